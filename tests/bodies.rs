//! Do rigid bodies among free spheres and walls conserve momentum and energy, for any number of threads and after any restart?

mod common;

use common::{crowd, settings, wear};
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::mechanics::rotation::to_space;
use veridem::spec::wear::law::Wear;
use veridem::system::{Domain, Motion, Particles, Steering, System};

/// The crowd of the other tests; of every five spheres in a row of six three are a body, bent by the jitter, and three stay by themselves.
fn mixed(seed: u64) -> System {
    mixed_rows(seed, 6)
}

fn mixed_rows(seed: u64, length: usize) -> System {
    let mut system = crowd(seed, length);
    for row in 0..length * length {
        system.add_body(&[length * row, length * row + 1, length * row + 2]);
        let body = system.bodies.last_mut().expect("just added");
        (body.v, body.l) = (Vec3([30.0, -20.0, 10.0 * (row % 3) as f64]), Vec3([0.3, -0.2, 0.1 * (row % 5) as f64]));
    }
    system.place_members(0);
    system
}

fn steps(mut simulation: Simulation<Wear>, count: usize) -> Simulation<Wear> {
    advance(&mut simulation, count as u64).expect("a stable step");
    simulation
}

fn start(system: System) -> Simulation<Wear> {
    Simulation::new(wear(), system, settings(2e-5)).expect("a valid system")
}

/// Momentum, and angular momentum about the origin.
fn momenta(system: &System) -> (Vec3<f64>, Vec3<f64>) {
    let (p, mut sums) = (&system.particles, (Vec3::zero(), Vec3::zero()));
    let mut add = |x: Vec3<f64>, v: Vec3<f64>, m: f64, own: Vec3<f64>| {
        sums = (sums.0 + v * m, sums.1 + x.cross(v) * m + own);
    };
    for k in (0..p.len()).filter(|&k| p.body[k] == 0) {
        add(p.x[k], p.v[k], p.mass[k], p.w[k] * veridem::motion::inertia(p, k));
    }
    for body in &system.bodies {
        add(body.pose.x, body.v, body.mass, to_space(body.pose.q_0, body.pose.q, body.l));
    }
    sums
}

#[test]
fn momentum_and_angular_momentum_are_kept_and_every_exchange_of_energy_is_booked() {
    let mut system = mixed(3);
    system.domain.periodic = [false; 3];
    let before = momenta(&system);
    let simulation = steps(start(system), 2000);
    let after = momenta(simulation.system());
    assert!((after.0 - before.0).norm() < 1e-10 * before.0.norm().max(1.0), "{:?}", after.0 - before.0);
    assert!((after.1 - before.1).norm() < 1e-9 * before.1.norm().max(1.0), "{:?}", after.1 - before.1);
    let ledger = simulation.ledger();
    assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{}", ledger.discrete_residual());
}

#[test]
fn global_damping_slows_a_body_as_it_slows_its_spheres() {
    let (eta, dt) = (3.0, 2e-5);
    let mut system = mixed(3);
    // One body by itself, which turns and flies.
    system.particles = system.particles.pick(&[0, 1, 2]);
    system.bodies.truncate(1);
    let before = momenta(&system);
    let (x, v) = (system.particles.x.clone(), system.particles.v.clone());
    let damped = Simulation::new(wear(), system, Settings { damping: eta, ..settings(dt) }).expect("a valid system");
    let simulation = steps(damped, 1);
    let after = momenta(simulation.system());
    let sum = |of: &dyn Fn(usize) -> Vec3<f64>| (0..3).map(of).fold(Vec3::zero(), |a, b| a + b);
    let (kick, twist) = (sum(&|k| v[k] * (-eta * dt)), sum(&|k| x[k].cross(v[k]) * (-eta * dt)));
    assert!((after.0 - before.0 - kick).norm() < 1e-9 * kick.norm(), "{:?} {kick:?}", after.0 - before.0);
    assert!((after.1 - before.1 - twist).norm() < 1e-9 * twist.norm(), "{:?} {twist:?}", after.1 - before.1);
    let (ledger, lost) = (simulation.ledger(), eta * dt * (0..3).map(|k| v[k].dot(v[k])).sum::<f64>());
    assert!((ledger.lost_drag - lost).abs() < 1e-9 * lost, "{} {lost}", ledger.lost_drag);
    assert!(ledger.discrete_residual().abs() < 1e-12 * ledger.turnover(), "{}", ledger.discrete_residual());
}

#[test]
fn the_physical_account_closes_to_first_order_in_the_time_step() {
    let residual = |dt: f64, count: usize| {
        let mut system = mixed(3);
        system.domain.periodic = [false; 3];
        let simulation = Simulation::new(wear(), system, settings(dt)).expect("a valid system");
        let ledger = steps(simulation, count).ledger();
        ledger.physical_residual().abs() / ledger.turnover()
    };
    let (coarse, fine) = (residual(4e-5, 500), residual(1e-5, 2000));
    assert!(coarse < 0.03 && fine < 0.3 * coarse, "{coarse} {fine}");
}

#[test]
fn a_spring_draws_the_centre_of_mass_of_colliding_spheres_as_if_it_were_one() {
    let mut system = crowd(7, 4);
    system.domain.periodic = [false; 3];
    let (dt, count, all) = (2e-5, 700, (0..64).collect());
    let velocity = Vec3([5.0, -2.0, 0.0]);
    let omega = 2.0 * std::f64::consts::PI / (500.0 * dt);
    let mass: f64 = system.particles.mass.iter().sum();
    let momentum = momenta(&system).0;
    system.steerings = vec![Steering::new(&system.particles, all, mass * omega * omega, velocity)];
    let simulation = steps(start(system), count);
    let spring = &simulation.system().steerings[0];
    let t = count as f64 * dt;
    let way = (spring.centre(&simulation.system().particles).0 - spring.origin).0;
    for a in 0..3 {
        let begun = momentum.0[a] / mass;
        let expected = velocity.0[a] * t - (velocity.0[a] - begun) / omega * (omega * t).sin();
        assert!((way[a] - expected).abs() < 1e-3 * (1.0 + begun.abs()) * t, "{a}: {} {expected}", way[a]);
    }
    let ledger = simulation.ledger();
    assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{}", ledger.discrete_residual());
}

#[test]
fn a_body_of_one_sphere_moves_like_the_sphere() {
    let free = crowd(5, 4);
    let mut bodies = free.clone();
    for p in 0..free.particles.len() {
        bodies.add_body(&[p]);
        let (v, w) = (free.particles.v[p], free.particles.w[p]);
        let body = bodies.bodies.last_mut().expect("just added");
        (body.v, body.l) = (v, to_space(body.pose.q_0, -body.pose.q, w * body.moments.0[0]));
    }
    bodies.place_members(0);
    let (free, mut bodies) = (steps(start(free), 300), steps(start(bodies), 300));
    bodies.place_members();
    let (a, b) = (&free.system().particles, &bodies.system().particles);
    for p in 0..a.len() {
        let q = b.id.iter().position(|id| *id == a.id[p]).expect("the same spheres");
        assert!((a.x[p] - b.x[q]).norm() < 1e-9 && (a.w[p] - b.w[q]).norm() < 1e-6, "sphere {}", a.id[p]);
    }
}

#[test]
fn no_pair_is_inside_a_body_but_a_body_larger_than_the_box_meets_its_own_copy() {
    // A rod across the side of a box that is shorter than twice its length: its ends overlap with their copies.
    let mut particles = Particles::default();
    for k in 0..5 {
        particles.push(Vec3([4.0 + 1.9 * f64::from(k), 3.0, 3.0]), 1.0, 0.01, 0);
    }
    let mut system = System::new(particles, Domain::periodic([9.3, 6.0, 6.0]));
    system.add_body(&[0, 1, 2, 3, 4]);
    system.bodies[0].v = Vec3([20.0, 10.0, 0.0]);
    let mut simulation = start(system);
    let ends: Vec<[u32; 2]> =
        simulation.pairs().map(|pair| [pair.i, pair.j].map(|p| simulation.system().particles.id[p])).collect();
    assert_eq!(ends, [[0, 4]]);
    simulation = steps(simulation, 1000);
    let body = &simulation.system().bodies[0];
    assert!((body.v - Vec3([20.0, 10.0, 0.0])).norm() < 1e-10, "a body cannot push itself: {:?}", body.v);
    assert!(body.l.norm() < 1e-10, "nor turn itself, for its ends lie behind each other");
}

#[test]
fn fixed_and_driven_bodies_do_as_they_are_told() {
    let mut system = mixed(7);
    let (fixed, driven, loaded) = (1, 2, 3);
    system.add_wall([Motion::Velocity(0.0); 3], |p, i| p.body[i] == fixed);
    let turning = Motion::Return { speed: 8.0, turn: 4e-3 };
    system.add_wall([Motion::Velocity(0.0), Motion::Velocity(0.0), turning], |p, i| p.body[i] == driven);
    system.add_wall([Motion::Velocity(0.0), Motion::Load(500.0), Motion::Velocity(0.0)], |p, i| p.body[i] == loaded);
    let place = |system: &System, id: u32| system.bodies.iter().find(|body| body.id == id).map(|body| body.pose.x.0);
    let before = [0, 1, 2].map(|id| place(&system, id).expect("a body"));
    let simulation = steps(start(system), 400);
    let after = [0, 1, 2].map(|id| place(simulation.system(), id).expect("a body"));
    assert_eq!(before[0], after[0]);
    // After twice the time of the turn it is as high as it was at its beginning, but for the step.
    assert!((after[1][2] - before[1][2] - 8.0 * 4e-3).abs() < 1e-3, "{}", after[1][2] - before[1][2]);
    assert!(after[2][1] != before[2][1] && after[2][0] == before[2][0]);
    let ledger = simulation.ledger();
    assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{}", ledger.discrete_residual());
}

#[test]
fn the_bits_do_not_depend_on_the_number_of_threads() {
    let end = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads");
        pool.install(|| steps(start(mixed(11)), 600).snapshot())
    };
    let one = end(1);
    assert!([2, 5].into_iter().all(|threads| end(threads) == one));
}

#[test]
fn a_resumed_simulation_has_the_same_bits() {
    let mut uninterrupted = start(mixed(13));
    let mut snapshots = Vec::new();
    for step in 0..600 {
        if step % 149 == 0 {
            snapshots.push((step, uninterrupted.snapshot()));
        }
        advance(&mut uninterrupted, 1).expect("a stable step");
    }
    for (step, snapshot) in snapshots {
        let resumed = Simulation::resume(wear(), settings(2e-5), snapshot).expect("a valid snapshot");
        assert!(steps(resumed, 600 - step).snapshot() == uninterrupted.snapshot(), "resumed at step {step}");
    }
}

#[test]
fn what_nothing_touches_is_in_its_place_when_it_is_looked_at() {
    // Two bodies far apart: none of their spheres is moved by the steps.
    let mut particles = Particles::default();
    for x in [2.0, 3.5, 12.0, 13.5] {
        particles.push(Vec3([x, 5.0, 5.0]), 1.0, 0.01, 0);
    }
    let mut system = System::new(particles, Domain { sides: [20.0; 3], periodic: [false; 3] });
    system.add_body(&[0, 1]);
    system.add_body(&[2, 3]);
    system.bodies[1].v = Vec3([0.0, 3.0, 0.0]);
    let mut simulation = steps(start(system), 100);
    let snapshot = simulation.snapshot();
    simulation.place_members();
    for system in [snapshot.system(), simulation.system()] {
        let p = &system.particles;
        let y = |id: u32| p.x[p.id.iter().position(|&other| other == id).expect("a sphere")].0[1];
        assert!((y(2) - 5.0 - 3.0 * 100.0 * 2e-5).abs() < 1e-12 && y(0) == 5.0, "{}", y(2));
    }
}

#[test]
fn the_state_at_the_end_has_the_spheres_of_bodies_where_they_are() {
    let mut system = mixed(3);
    system.particles = system.particles.pick(&[0, 1, 2]);
    system.bodies.truncate(1);
    has_members_in_place(&steps(start(system), 50).into_system());
}

#[test]
fn hundreds_of_bodies_move_together_with_their_spheres() {
    let mut system = mixed_rows(3, 13);
    system.domain.periodic = [false; 3];
    let before = momenta(&system);
    let end = steps(start(system), 50).into_system();
    let after = momenta(&end);
    assert_eq!(end.bodies.len(), 169);
    assert!((after.0 - before.0).norm() < 1e-10 * before.0.norm(), "{:?}", after.0 - before.0);
    assert!((after.1 - before.1).norm() < 1e-9 * before.1.norm(), "{:?}", after.1 - before.1);
    has_members_in_place(&end);
}

#[test]
fn bodies_of_dozens_of_spheres_move_with_all_of_them() {
    let mut system = crowd(3, 6);
    for body in 0..4 {
        let members: Vec<usize> = (50 * body..50 * body + 16 + 7 * body).collect();
        system.add_body(&members);
        system.bodies[body].l = Vec3([3.0, -2.0, body as f64]);
    }
    system.place_members(0);
    has_members_in_place(&steps(start(system), 50).into_system());
}

/// Checks that every sphere of a body is where its body is, and moves with it.
fn has_members_in_place(system: &System) {
    let particles = &system.particles;
    for (p, &number) in particles.body.iter().enumerate().filter(|(_, number)| **number > 0) {
        let body = &system.bodies[number as usize - 1];
        let (x, v) = body.member(body.omega(), particles.arm[p]);
        assert!((particles.x[p] - x).norm() < 1e-12 && (particles.v[p] - v).norm() < 1e-9, "{p}");
    }
}
