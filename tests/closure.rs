//! The order at which the physical energy balance closes, cause by cause: the residual of a pair is measured while its energy is converted, for four time steps,
//! each half of the one before, and for several starts, since contacts begin and slip at other places within a step.

mod common;

use common::soot::{MASS, RADIUS, dry, plane, settings as soot_settings, space};
use common::{SILICA, settings, sheared_crowd};
use veridem::run::advance;
use veridem::simulation::{Ledger, Settings, Simulation};
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::soot::Soot;
use veridem::spec::titania::Titania;
use veridem::spec::wear::law::{Interaction, Material, Wear};
use veridem::spec::{PairModel, Vec3};
use veridem::system::{Motion, Particles, PrescribedMotion, Surface, System};

/// Starts of a case.
const STARTS: usize = 8;
/// How far the order may be from the expected one.
const TOLERANCE: f64 = 0.1;

/// The order at which residuals fall from a time step to half of it: the slope of a line through the logarithms of their root mean squares.
fn order(residuals: &[f64]) -> f64 {
    let n = residuals.len() as f64;
    let middle = 0.5 * (n - 1.0);
    let steps = || (0..residuals.len()).map(|k| k as f64 - middle);
    let rise: f64 = steps().zip(residuals).map(|(k, r)| -k * r.log2()).sum();
    rise / steps().map(|k| k * k).sum::<f64>()
}

/// All energy that has gone from one account to another.
fn moved(ledger: &Ledger) -> f64 {
    let gained = |held: &[f64], before: &[f64]| held.iter().zip(before).map(|(a, b)| (a - b).abs()).sum::<f64>();
    let surfaces = &ledger.surfaces;
    let lost = ledger.lost_by_pairs.iter().chain(&surfaces.lost).map(|lost| lost.abs()).sum::<f64>() + ledger.lost_drag;
    let worked = ledger.work_walls.abs() + ledger.work_loads.abs() + surfaces.work.abs();
    (ledger.kinetic - ledger.kinetic_at_start).abs()
        + gained(&ledger.stored, &ledger.stored_at_start)
        + gained(&surfaces.stored, &surfaces.stored_at_start)
        + lost
        + worked
}

/// Asserts that the residual falls at first order, and that every run has used what it is to test: `share` is the part of it in the account.
fn assert_first_order(name: &str, dt: f64, share: impl Fn(&Ledger) -> f64, run: impl Fn(f64, f64) -> Ledger) {
    let residual = |halvings: i32| {
        let squares = (0..STARTS).map(|start| {
            let ledger = run(start as f64 / STARTS as f64, dt * 0.5f64.powi(halvings));
            let used = share(&ledger).abs() / moved(&ledger);
            assert!(used > 1e-3, "{name} has hardly any part in the account: {used} {ledger:?}");
            (ledger.physical_residual() / moved(&ledger)).powi(2)
        });
        (squares.sum::<f64>() / STARTS as f64).sqrt()
    };
    let residuals: Vec<f64> = (0..4).map(residual).collect();
    let order = order(&residuals);
    println!("{name}: order {order:.3}, relative residuals {residuals:?}");
    assert!((order - 1.0).abs() < TOLERANCE, "{name}: order {order}, residuals {residuals:?}");
}

fn run<M: PairModel>(model: M, system: System, settings: Settings, time: f64) -> Ledger {
    let steps = (time / settings.dt).round() as u64;
    let mut simulation = Simulation::new(model, system, settings).expect("a stable step");
    advance(&mut simulation, steps).expect("a stable step");
    simulation.ledger()
}

/// Two equal spheres in free space: the distance of their centres along x, the velocity and the spin of the second.
fn two(radius: f64, mass: f64, distance: f64, v: [f64; 3], w: [f64; 3]) -> System {
    let mut particles = Particles::default();
    particles.push(Vec3([200.0; 3]), radius, mass, 0);
    particles.push(Vec3([200.0 + distance, 200.0, 200.0]), radius, mass, 0);
    (particles.v[1], particles.w[1]) = (Vec3(v), Vec3(w));
    System::new(particles, space())
}

mod wear {
    use super::*;

    const DT: f64 = 8e-6;

    fn law(restitution: f64, interaction: Interaction) -> Wear {
        Wear { material: Material { restitution, ..SILICA }, interaction }
    }
    fn silica(start: f64, v: [f64; 3]) -> System {
        two(1.0, sphere_mass(2.2e-3, 1.0), 1.99 + 5e-3 * start, v, [0.0; 3])
    }

    #[test]
    fn the_account_closes_at_first_order_by_every_cause() {
        let full = |restitution| law(restitution, Interaction::Full);
        let normal = law(1.0, Interaction::Normal);
        let pair = |model: Wear, v, time| move |start, dt| run(model, silica(start, v), settings(dt), time);
        assert_first_order("normal spring", DT, |l| l.stored[0], pair(normal, [-200.0, 0.0, 0.0], 1.6e-4));
        assert_first_order(
            "normal dashpot",
            DT,
            |l| l.lost_by_pairs[0],
            pair(law(0.5, Interaction::Normal), [-200.0, 0.0, 0.0], 3.2e-4),
        );
        assert_first_order("tangential spring", DT, |l| l.stored[1], pair(full(1.0), [0.0, 100.0, 0.0], 1.6e-4));
        assert_first_order(
            "tangential dashpot",
            DT,
            |l| l.lost_by_pairs[1],
            pair(full(0.5), [0.0, 100.0, 0.0], 3.2e-4),
        );
        assert_first_order("slip", DT, |l| l.lost_by_pairs[2], pair(full(1.0), [-100.0, 2000.0, 0.0], 3.2e-4));
        assert_first_order(
            "drag",
            DT,
            |l| l.lost_drag,
            |start, dt| {
                let settings = Settings { damping: 5.0, ..settings(dt) };
                run(normal, silica(start, [-200.0, 0.0, 0.0]), settings, 1.6e-4)
            },
        );
        for (name, motion, share) in [
            ("wall that is moved", Motion::Velocity(200.0), (|l| l.work_walls) as fn(&Ledger) -> f64),
            ("wall under a load", Motion::Load(1e6), |l| l.work_loads),
        ] {
            assert_first_order(name, DT, share, |start, dt| {
                let mut system = silica(start, [0.0; 3]);
                let still = Motion::Velocity(0.0);
                system.add_wall([motion, still, still], |particles, p| particles.x[p].0[0] < 201.0);
                run(normal, system, settings(dt), 1.6e-4)
            });
        }
    }

    #[test]
    fn the_account_of_a_sheared_crowd_closes_at_first_order() {
        let crowd = |_, dt| run(common::wear(), sheared_crowd(7, 5), settings(dt), 1e-3);
        assert_first_order("sheared crowd", DT, |ledger| ledger.lost(), crowd);
    }
}

mod soot {
    use super::*;

    const DT: f64 = 1e-5;

    /// Contacts without dashpots or attraction.
    fn bare() -> Soot {
        let mut law = dry();
        law.attraction.a = 0.0;
        for springs in [&mut law.neck, &mut law.contact] {
            (springs.eta_n, springs.eta_t, springs.eta_r, springs.eta_o) = (0.0, 0.0, 0.0, 0.0);
        }
        law
    }
    fn spheres(gap: f64, v: [f64; 3], w: [f64; 3]) -> System {
        two(RADIUS, MASS, 2.0 * RADIUS + gap, v, w)
    }
    fn pair(law: Soot, system: impl Fn(f64) -> System, time: f64) -> impl Fn(f64, f64) -> Ledger {
        move |start, dt| run(law, system(start), soot_settings(dt), time)
    }

    #[test]
    fn the_account_closes_at_first_order_by_every_cause() {
        let touching = |v: [f64; 3], w: [f64; 3]| move |start| spheres(2e-3 * start, v, w);
        assert_first_order(
            "normal spring",
            DT,
            |l| l.stored[1],
            pair(bare(), touching([-2.0, 0.0, 0.0], [0.0; 3]), 0.002),
        );
        let damped = Soot { contact: dry().contact, ..bare() };
        assert_first_order(
            "dashpot",
            DT,
            |l| l.lost_by_pairs[0],
            pair(damped, touching([-2.0, 0.0, 0.0], [0.0; 3]), 0.003),
        );
        assert_first_order(
            "friction",
            DT,
            |l| l.lost_by_pairs[4],
            pair(bare(), touching([-2.0, 2.0, 0.6], [0.1, 0.0, 0.0]), 0.01),
        );
        let joined =
            |start: f64| System { necks: vec![(0, 1)], ..spheres(0.0, [-2.0 + start, 2.0, 0.6], [0.1, -0.1, 0.0]) };
        assert_first_order("neck", DT, |l| l.stored[0], pair(bare(), joined, 0.02));
        let apart = |start: f64| spheres(1.0 + 0.1 * start, [-2.0, 0.0, 0.0], [0.0; 3]);
        let attraction = Soot { attraction: dry().attraction, ..bare() };
        assert_first_order("van der Waals", DT, |l| l.stored[5] - l.stored_at_start[5], pair(attraction, apart, 0.03));
        let mut wet = bare();
        wet.attraction = veridem::spec::soot::Attraction { a: 0.0, ..common::soot::law().attraction };
        assert_first_order("capillary", DT, |l| l.stored[6] - l.stored_at_start[6], pair(wet, apart, 0.03));
    }

    #[test]
    fn the_account_closes_at_first_order_with_a_surface() {
        let fall = |law: Soot, gap: f64, time: f64| {
            move |start: f64, dt: f64| {
                let mut particles = Particles::default();
                particles.push(Vec3([50.0, 50.0, RADIUS + gap * (1.0 + 0.1 * start)]), RADIUS, MASS, 0);
                (particles.v[0], particles.w[0]) = (Vec3([2.0, 1.0, -2.0]), Vec3([0.1, 0.0, 0.05]));
                let substrate = Surface::new("substrate", 0, plane(), PrescribedMotion::Still);
                let system = System { surfaces: vec![substrate], ..System::new(particles, space()) };
                run(law, system, soot_settings(dt), time)
            }
        };
        let mut smooth = bare();
        smooth.walls[0].hamaker = 0.0;
        assert_first_order("surface", DT, |l| l.surfaces.stored.iter().sum(), fall(smooth, 1e-3, 0.002));
        assert_first_order("friction of a surface", DT, |l| l.surfaces.lost[4], fall(smooth, 1e-3, 0.003));
        assert_first_order("attraction of a surface", DT, |l| l.surfaces.gained(), fall(bare(), 1.0, 0.03));
    }
}

mod titania {
    use super::*;

    const DT: f64 = 2e-4;
    const DIAMETER: f64 = 8.0;

    /// The law without what it loses.
    fn bare() -> Titania {
        Titania { gamma_0: 0.0, tau_s: 0.0, tau_r: 0.0, ..Titania::paper(1.0, 1e3, 1.0) }
    }
    /// Spheres so far beyond their distance at rest.
    fn pair(law: Titania, beyond: f64, v: [f64; 3], w: [f64; 3], time: f64) -> impl Fn(f64, f64) -> Ledger {
        let radius = law.contact_radius(DIAMETER);
        let distance = law.equilibrium(radius, radius);
        move |start, dt| {
            let system = two(radius, sphere_mass(4.23e-3, radius), distance + beyond + 0.02 * start, v, w);
            run(law, system, Settings { skin: 1.0, ..Settings::new(dt) }, time)
        }
    }

    #[test]
    fn the_account_closes_at_first_order_by_every_cause() {
        let paper = Titania::paper(1.0, 1e3, 1.0);
        let gained = |k: usize| move |l: &Ledger| l.stored[k] - l.stored_at_start[k];
        assert_first_order("repulsion", DT, gained(0), pair(bare(), -0.05, [0.0; 3], [0.0; 3], 0.012));
        assert_first_order("meniscus", DT, gained(1), pair(bare(), 0.5, [-5.0, 0.0, 0.0], [0.0; 3], 0.02));
        let damped = Titania { gamma_0: paper.gamma_0, ..bare() };
        assert_first_order("dashpot", DT, |l| l.lost_by_pairs[0], pair(damped, -0.05, [0.0; 3], [0.0; 3], 0.1));
        let sliding = Titania { tau_s: paper.tau_s, ..bare() };
        let across = [2.0, 10.0, 0.0];
        assert_first_order("tangential spring", DT, gained(2), pair(sliding, 0.0, across, [0.0; 3], 0.02));
        assert_first_order("contact area", DT, |l| l.lost_by_pairs[3], pair(sliding, 0.0, across, [0.0; 3], 0.02));
        assert_first_order("slip", DT, |l| l.lost_by_pairs[1], pair(sliding, 0.0, [0.0, 60.0, 0.0], [0.0; 3], 0.1));
        let rolling = Titania { tau_r: paper.tau_r, ..bare() };
        assert_first_order("rolling", DT, |l| l.lost_by_pairs[2], pair(rolling, 0.0, [0.0; 3], [0.0, 0.0, 10.0], 0.02));
    }

    /// Two spheres that part while they slide.
    fn parting(start: f64, dt: f64) -> Ledger {
        let law = Titania { tau_s: Titania::paper(1.0, 1e3, 1.0).tau_s, ..bare() };
        pair(law, 0.0, [60.0, 100.0, 0.0], [0.0; 3], 0.02)(start, dt)
    }

    #[test]
    fn the_account_of_a_contact_that_ends_closes_at_first_order() {
        assert_first_order("contact that ends", DT, |ledger| ledger.lost_by_pairs[3], parting);
    }

    #[test]
    fn no_smaller_step_makes_up_for_what_a_shrinking_contact_area_takes() {
        let unexplained = |dt: f64| {
            let ledger = parting(0.5, dt);
            assert_eq!(ledger.stored[2], 0.0, "they have parted");
            let area = ledger.lost_by_pairs[3];
            (ledger.physical_residual() / area, (ledger.physical_residual() - area) / area)
        };
        let [coarse, fine] = [DT, DT / 8.0].map(unexplained);
        println!("residual over what the area took, with and without that account: {coarse:?} {fine:?}");
        assert!(fine.0.abs() < 0.2 * coarse.0.abs() && (fine.1 + 1.0).abs() < 0.2, "{coarse:?} {fine:?}");
    }
}
