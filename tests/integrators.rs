//! Do both integrators have the stated accuracy?

mod common;

use common::soot::{DT, MASS, RADIUS, between, dry, momentum, plane, run, settings, space};
use veridem::motion::inertia;
use veridem::run::advance;
use veridem::simulation::{Integrator, Ledger, Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::soot::Soot;
use veridem::system::{Motion, Particles, System};

const BOTH: [Integrator; 2] = [Integrator::HalfStep, Integrator::VelocityVerlet];

fn with(integrator: Integrator, dt: f64) -> Settings {
    Settings { integrator, ..settings(dt) }
}

fn verlet() -> Settings {
    with(Integrator::VelocityVerlet, DT)
}

/// The dry interactions without a dashpot.
fn undamped() -> Soot {
    let mut law = dry();
    for springs in [&mut law.neck, &mut law.contact] {
        (springs.eta_n, springs.eta_t, springs.eta_r, springs.eta_o) = (0.0, 0.0, 0.0, 0.0);
    }
    law
}

/// Two spheres with a neck, one of them moving.
fn pair(v: [f64; 3], w: [f64; 3]) -> System {
    let mut particles = Particles::default();
    particles.push(Vec3::zero(), RADIUS, MASS, 0);
    particles.push(Vec3([2.0 * RADIUS, 0.0, 0.0]), RADIUS, MASS, 0);
    (particles.v[1], particles.w[1]) = (Vec3(v), Vec3(w));
    System { necks: vec![(0, 1)], ..System::new(particles, space()) }
}

/// Two spheres that vibrate, and roll and twist about their neck.
fn restless() -> System {
    pair([20.0, 7.0, 0.0], [1.0, 0.0, -0.5])
}

/// The largest part of the energy that is missing in any of the next steps.
fn missing(simulation: &mut Simulation<Soot>, steps: usize) -> f64 {
    let share = |ledger: Ledger| ledger.physical_residual().abs() / ledger.turnover();
    (0..steps).fold(0.0, |most: f64, _| {
        advance(simulation, 1).expect("a stable step");
        most.max(share(simulation.ledger()))
    })
}

#[test]
fn the_energy_of_a_pair_without_dashpots_is_within_the_same_bounds_after_a_thousand_periods() {
    for integrator in BOTH {
        let mut simulation = run(undamped(), restless(), with(integrator, DT), 0);
        let first = missing(&mut simulation, 10_000);
        advance(&mut simulation, 100_000).expect("a stable step");
        let last = missing(&mut simulation, 10_000);
        assert!(last < 1.03 * first, "{integrator:?}: {last} after {first}");
    }
}

#[test]
fn without_dashpots_the_account_closes_to_first_order_and_to_second_where_velocities_are_not_late() {
    for (integrator, factor) in [(Integrator::HalfStep, 2.0), (Integrator::VelocityVerlet, 4.0)] {
        let missing =
            |dt: f64| missing(&mut run(undamped(), restless(), with(integrator, dt), 0), (0.04 / dt) as usize);
        let (coarse, fine) = (missing(DT), missing(DT / 2.0));
        assert!((coarse / fine / factor - 1.0).abs() < 0.03, "{integrator:?}: {coarse} and {fine}");
    }
}

#[test]
fn both_lead_to_the_same_positions_from_velocities_half_a_step_apart() {
    let along = |v: f64| pair([v, 0.0, 0.0], [0.0; 3]);
    let steps = 2_000;
    let end = |system, settings, steps| {
        let simulation = run(undamped(), system, settings, steps);
        let system = simulation.system();
        [0, 1].map(|id| system.particles.x[system.place(id)])
    };
    let first = end(along(20.0), verlet(), 1);
    let at_first = along(20.0);
    // The velocity in the middle of the first step, and what is as far on the other side of the first.
    let before: [Vec3<f64>; 2] = std::array::from_fn(|k| {
        let particles = &at_first.particles;
        particles.v[k] * 2.0 - (first[k] - particles.x[k]) * (1.0 / DT)
    });
    let mut half_a_step_before = at_first.clone();
    half_a_step_before.particles.v = before.into();
    let half_step = with(Integrator::HalfStep, DT);
    let synchronous = end(at_first.clone(), verlet(), steps);
    let late = end(half_a_step_before, half_step, steps);
    let started = end(at_first, half_step.synchronous_start(), steps);
    for (a, b) in synchronous.into_iter().zip(late).chain(synchronous.into_iter().zip(started)) {
        assert!((a - b).norm() < 1e-8, "{a:?} {b:?}");
    }
}

#[test]
fn a_state_handed_from_one_integrator_to_another_goes_on_as_if_it_had_not_been() {
    let whole = |settings: [Settings; 2]| {
        let [first, second] = settings.map(Settings::synchronous_start);
        let system = run(undamped(), pair([20.0, 0.0, 0.0], [0.0; 3]), first, 1_000).into_system_with_springs();
        let simulation = Simulation::new(undamped(), System { step: 0, ..system }, second).expect("a stable step");
        let mut simulation = simulation;
        advance(&mut simulation, 1_000).expect("a stable step");
        let system = simulation.system();
        system.particles.x[system.place(0)]
    };
    let (half_step, synchronous) = (with(Integrator::HalfStep, DT), verlet());
    let alone = whole([synchronous; 2]);
    for settings in [[half_step; 2], [half_step, synchronous], [synchronous, half_step]] {
        let found = whole(settings);
        assert!((found - alone).norm() < 1e-6, "{settings:?}: {found:?} {alone:?}");
    }
}

#[test]
fn velocity_verlet_keeps_momentum_and_accounts_for_surfaces_and_necks_that_break() {
    let mut simulation = run(dry(), between(plane()), verlet(), 0);
    let mut broken = 0;
    let account = |simulation: &Simulation<Soot>| {
        let ledger = simulation.ledger();
        assert!(ledger.discrete_residual().abs() < 1e-11 * ledger.turnover(), "{ledger:?}");
        assert!(ledger.physical_residual().abs() < 1e-2 * ledger.turnover(), "{ledger:?}");
    };
    account(&simulation);
    for _ in 0..10_000 {
        advance(&mut simulation, 1).expect("a stable step");
        broken += simulation.break_necks(|_, _, _, held| held.necks > 20.0).expect("neighbours").len();
    }
    account(&simulation);
    assert!(broken > 0 && !simulation.system().necks.is_empty(), "{broken} broken");

    let mut free = between(plane());
    free.surfaces.clear();
    let total = |particles: &Particles| {
        let spin = |k: usize| {
            particles.x[k].cross(particles.v[k]) * particles.mass[k] + particles.w[k] * inertia(particles, k)
        };
        (momentum(particles), (0..particles.len()).fold(Vec3::zero(), |sum, k| sum + spin(k)))
    };
    let before = total(&free.particles);
    let after = total(&run(dry(), free, verlet(), 10_000).system().particles);
    assert!((after.0 - before.0).norm() < 1e-11 * before.0.norm(), "{before:?} {after:?}");
    assert!((after.1 - before.1).norm() < 1e-11 * before.1.norm(), "{before:?} {after:?}");
}

#[test]
fn velocity_verlet_goes_on_from_a_snapshot_with_the_same_bits() {
    let settings = Settings { far_every: 5, ..verlet() };
    let whole = run(dry(), between(plane()), settings, 6_000).snapshot();
    let half = run(dry(), between(plane()), settings, 4_321).snapshot();
    let mut resumed = Simulation::resume(dry(), settings, half).expect("a valid snapshot");
    advance(&mut resumed, 6_000 - 4_321).expect("a stable step");
    assert!(resumed.snapshot() == whole);
}

#[test]
fn velocity_verlet_and_synchronous_starts_refuse_walls_and_bodies_by_name() {
    let synchronous = Settings { synchronous_start: true, ..with(Integrator::HalfStep, 1e-5) };
    for settings in [with(Integrator::VelocityVerlet, 1e-5), synchronous] {
        let apart = System { necks: Vec::new(), ..pair([0.0; 3], [0.0; 3]) };
        let (mut walled, mut rigid) = (apart.clone(), apart);
        walled.add_wall([Motion::Velocity(0.0); 3], |_, p| p == 0);
        rigid.add_body(&[0, 1]);
        for (system, name) in [(walled, "number of walls"), (rigid, "number of rigid bodies")] {
            let halt = Simulation::new(undamped(), system, settings).err().expect("a refusal");
            assert!(halt.to_string().contains(&format!("`{name}` is 1, expected 0 with velocity Verlet")), "{halt}");
        }
    }
}

#[test]
fn the_momentum_flux_of_a_step_is_that_of_the_velocities_after_it() {
    for integrator in BOTH {
        let simulation = run(undamped(), restless(), with(integrator, DT), 100);
        let Particles { v, mass, .. } = &simulation.system().particles;
        for (a, flux) in simulation.momentum_flux().into_iter().enumerate() {
            let sum: f64 = mass.iter().zip(v).map(|(m, v)| m * v.0[a] * v.0[a]).sum();
            assert!((flux - sum).abs() <= 1e-13 * sum, "{integrator:?}: {flux} instead of {sum}");
        }
    }
}

#[test]
fn the_stress_is_the_tension_of_necks_less_the_flux_of_momentum_per_volume() {
    let volume: f64 = space().sides.iter().product();
    for integrator in BOTH {
        let stress = |system| {
            let mut simulation = run(undamped(), system, with(integrator, 1e-4 * DT), 0);
            advance(&mut simulation, 2).expect("a stable step");
            simulation.stress()
        };
        let v = [30.0, -20.0, 10.0];
        let mut flying = pair(v, [0.0; 3]);
        flying.necks.clear();
        flying.particles.x[1].0[0] += 10.0 * RADIUS;
        for (found, v) in stress(flying).into_iter().zip(v) {
            assert!((found * volume / (-MASS * v * v) - 1.0).abs() < 1e-9, "{integrator:?}: {found}");
        }
        let mut stretched = pair([0.0; 3], [0.0; 3]);
        stretched.particles.x[1].0[0] += 0.5;
        let pulled = undamped().neck.k_n * 0.5 * (2.0 * RADIUS + 0.5) / volume;
        let [along, across, up] = stress(stretched);
        assert!((along / pulled - 1.0).abs() < 1e-5, "{integrator:?}: {along} {pulled}");
        assert!(across.abs() + up.abs() < 1e-9 * pulled, "{integrator:?}: {across} {up}");
    }
}
