//! Necks under another paper's contact law: is their energy accounted for, and does a contact replace a broken neck?

use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::mechanics::four_springs::Springs;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::titania::Titania;
use veridem::spec::{Necked, Vec3};
use veridem::system::{Domain, Particles, System};

/// Energy at which necks break, zJ.
const STRENGTH: f64 = 500.0;

fn model(dashpot: f64) -> Necked<Titania> {
    let (k_n, k_t, k_r, k_o) = (91e3, 36e3, 5.2e3, 4.1e3);
    let neck = Springs { k_n, k_t, k_r, k_o, eta_n: dashpot, eta_t: dashpot, eta_r: dashpot, eta_o: dashpot };
    Necked { law: Titania::paper(1.0, 1e3, 1.0), neck, layer: 0.075 }
}

/// Two particles of 8 and 12 nm at rest with each other, a neck between them.
fn pair(law: &Titania) -> System {
    let mut particles = Particles::default();
    for (d, x) in [(8.0, 20.0), (12.0, 30.0)] {
        let r = law.contact_radius(d);
        particles.push(Vec3::new(x, 25.0, 25.0), r, sphere_mass(4.23e-3, r), 0);
    }
    System { necks: vec![(0, 1)], ..System::new(particles, Domain { sides: [50.0; 3], periodic: [false; 3] }) }
}

fn settings(dt: f64) -> Settings {
    Settings::new(dt).skin(1.0).max_overlap(1.0)
}

/// The pair on its way apart.
fn moving(dt: f64) -> Simulation<Necked<Titania>> {
    let model = model(50.0);
    let mut system = pair(&model.law);
    (system.particles.v[0], system.particles.v[1]) = (Vec3::new(-50.0, 6.0, 0.0), Vec3::new(20.0, 0.0, -4.0));
    (system.particles.w[0], system.particles.w[1]) = (Vec3::new(2.0, 0.0, 3.0), Vec3::new(-1.0, 2.0, 0.0));
    Simulation::new(model, system, settings(dt)).unwrap()
}

/// The pair torn apart: the steps until the neck breaks, and the simulation then.
fn torn(dt: f64) -> (u64, Simulation<Necked<Titania>>) {
    let mut simulation = moving(dt);
    loop {
        advance(&mut simulation, 1).unwrap();
        let broken = simulation
            .break_necks(|_, _, _, (_, held)| {
                held.neck_normal + held.neck_tangential + held.neck_rolling + held.neck_torsion > STRENGTH
            })
            .unwrap();
        if !broken.is_empty() {
            assert_eq!(broken, [(0, 1)]);
            return (simulation.system().step, simulation);
        }
        assert!(simulation.system().time < 1.0, "it must break");
    }
}

#[test]
fn particles_at_rest_stay_where_they_are_with_a_neck_and_hold_nothing() {
    let model = model(50.0);
    let system = pair(&model.law);
    let before = system.particles.x.clone();
    let mut simulation = Simulation::new(model, system, settings(1e-3)).unwrap();
    advance(&mut simulation, 1000).unwrap();
    assert!((0..2).all(|p| (simulation.system().particles.x[p] - before[p]).norm() < 1e-12));
    assert!(simulation.ledger().stored.iter().all(|held| held.abs() < 1e-12));
}

#[test]
fn the_account_closes_over_a_break_to_first_order_in_the_step() {
    let residual = |dt: f64| {
        let (_, simulation) = torn(dt);
        let ledger = simulation.ledger();
        // The neck held what it breaks at, the contact holds what is stored now.
        let held: f64 = ledger.stored.iter().sum();
        let lost = ledger.lost_to_breaking;
        assert!((lost + held - STRENGTH).abs() < 0.02 * STRENGTH, "{lost} {held}");
        assert!(ledger.discrete_residual().abs() < 1e-9 * ledger.turnover());
        assert!(ledger.physical_residual().abs() < 5e-3 * ledger.turnover(), "{}", ledger.physical_residual());
        ledger.physical_residual().abs()
    };
    let (coarse, fine) = (residual(2e-5), residual(1e-5));
    assert!(fine < 0.6 * coarse, "{coarse} {fine}");
}

#[test]
fn a_broken_neck_leaves_the_contact_of_the_law() {
    let (step, mut necked) = torn(1e-4);
    assert!(step > 1);
    assert!(necked.system().necks.is_empty());
    let mut plain = Simulation::new(necked.model().law, necked.system().clone(), settings(1e-4)).unwrap();
    for _ in 0..2000 {
        advance(&mut necked, 1).unwrap();
        advance(&mut plain, 1).unwrap();
    }
    assert_eq!(necked.system().particles, plain.system().particles);
}

#[test]
fn a_snapshot_goes_on_with_the_same_bits_before_and_after_the_break() {
    let (last, broken) = torn(1e-4);
    let step = |mut simulation: Simulation<Necked<Titania>>, steps: u64| {
        advance(&mut simulation, steps).unwrap();
        simulation
    };
    let resumed =
        |simulation: &Simulation<_>| Simulation::resume(model(50.0), settings(1e-4), simulation.snapshot()).unwrap();
    let taken_up = step(resumed(&broken), 500);
    assert_eq!(step(broken, 500).snapshot(), taken_up.snapshot());

    let mut whole = step(moving(1e-4), last / 2);
    let mut parts = resumed(&whole);
    for simulation in [&mut whole, &mut parts] {
        advance(simulation, last - 1 - last / 2).unwrap();
    }
    assert_eq!(whole.system().necks, [(0, 1)]);
    assert_eq!(whole.snapshot(), parts.snapshot());
}
