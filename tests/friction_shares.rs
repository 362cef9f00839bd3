//! Does friction stop rotating spheres independently of the neighbour list?

use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::titania::{Tabulated, Titania};
use veridem::system::{Domain, Motion, Particles, System};

const DIAMETER: f64 = 8.0;
const DT: f64 = 0.5e-3;
const STEPS: u64 = 200;

fn law() -> Titania {
    Titania::paper(1.0, 1e3, 1.0)
}

/// Some places of a face-centred cubic lattice of spheres at rest, and what turns them.
fn lattice(cells: i32, spin: impl Fn(usize) -> Vec3<f64>) -> System {
    let radius = law().contact_radius(DIAMETER);
    let half = law().equilibrium(radius, radius) / 2f64.sqrt();
    let mut particles = Particles::default();
    let places = (0..cells).flat_map(|i| (0..cells).flat_map(move |j| (0..cells).map(move |k| [i, j, k])));
    for place in places.filter(|place| place.iter().sum::<i32>() % 2 == 0) {
        let x = Vec3(place.map(|n| half * (f64::from(n) + 2.0)));
        particles.push(x, radius, sphere_mass(4.23e-3, radius), 0);
    }
    for p in 0..particles.len() {
        particles.w[p] = spin(p);
    }
    let side = half * f64::from(cells + 4);
    System::new(particles, Domain { periodic: [false; 3], ..Domain::periodic([side; 3]) })
}

fn simulation(law: Titania, system: System, skin: f64) -> Simulation<Tabulated> {
    let tables = Tabulated::new(law, &[law.contact_radius(DIAMETER)], 0.1);
    Simulation::new(tables, system, Settings { skin, ..Settings::new(DT) }).expect("a valid system")
}

/// Centres and spins after some steps, by the ids of the spheres.
fn after(system: System, skin: f64) -> Vec<(Vec3<f64>, Vec3<f64>)> {
    let mut simulation = simulation(law(), system, skin);
    advance(&mut simulation, STEPS).expect("a stable step");
    let particles = &simulation.system().particles;
    let mut places: Vec<usize> = (0..particles.len()).collect();
    places.sort_by_key(|&p| particles.id[p]);
    places.into_iter().map(|p| (particles.x[p], particles.w[p])).collect()
}

#[test]
fn how_far_neighbours_are_listed_changes_a_trajectory_by_no_more_than_rounding() {
    let spin = |p: usize| Vec3([0, 1, 2].map(|a| ((p * 37 + a * 11) % 13) as f64 - 6.0));
    let system = || lattice(4, spin);
    let of = |skin| after(system(), skin);
    let (narrow, wide) = (of(0.2), of(5.0));
    let start = system();
    let mut moved: f64 = 0.0;
    for (p, (a, b)) in narrow.iter().zip(&wide).enumerate() {
        assert!((a.0 - b.0).norm() < 1e-10 && (a.1 - b.1).norm() < 1e-9, "{p}: {a:?} {b:?}");
        moved = moved.max((a.1 - start.particles.w[p]).norm());
    }
    assert!(moved > 1.0, "friction has stopped something: {moved}");
}

#[test]
fn twelve_contacts_together_stop_a_sphere_and_do_not_turn_it_back() {
    let (cells, middle) = (5, 2.0 + 2.0);
    let mut system = lattice(cells, |_| Vec3::zero());
    let radius = law().contact_radius(DIAMETER);
    let at = Vec3([middle * law().equilibrium(radius, radius) / 2f64.sqrt(); 3]);
    let centre = (0..system.particles.len()).find(|&p| (system.particles.x[p] - at).norm() < 0.1).expect("a middle");
    system.add_wall([Motion::Velocity(0.0); 3], |particles, p| (particles.x[p] - at).norm() > 0.1);
    let spin = Vec3([3.0, -2.0, 1.0]);
    system.particles.w[centre] = spin;
    // Tangential springs would bring the sphere back.
    let mut simulation = simulation(Titania { tau_s: 0.0, ..law() }, system, 1.0);
    for _ in 0..200 {
        advance(&mut simulation, 1).expect("a stable step");
        let particles = &simulation.system().particles;
        let turning: Vec<_> = (0..particles.len()).filter(|&p| particles.wall[p] == 0).collect();
        let [p] = turning[..] else { panic!("one sphere is free") };
        assert!(particles.w[p].dot(spin) > -1e-12, "{:?}", particles.w[p]);
    }
    let still = simulation.system().particles.w.iter().map(|w| w.norm()).fold(0.0, f64::max);
    assert!(still < 1e-6, "{still}");
}

#[test]
fn contacts_across_the_side_of_a_periodic_box_share_like_all_others() {
    let spin = |p: usize| Vec3([p as f64 + 1.0, -2.0, 0.5]);
    let spins = |shift: f64| {
        let mut system = lattice(3, spin);
        system.domain = Domain::periodic(system.domain.sides.map(|side| 2.0 * side));
        let side = system.domain.sides[0];
        for x in &mut system.particles.x {
            *x = Vec3(x.0.map(|x| (x + shift * side) % side));
        }
        after(system, 0.2)
    };
    let inside = spins(0.0);
    for shift in [0.72, 0.8, 0.88] {
        for ((_, here), (_, there)) in inside.iter().zip(spins(shift)) {
            assert!((*here - there).norm() < 1e-9, "{shift}: {here:?} {there:?}");
        }
    }
}
