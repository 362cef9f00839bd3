//! Are settings and systems that make no sense refused before the first step?

mod common;

use common::{settings, soot, wear};
use veridem::error::{Halt, Reason};
use veridem::motion::BoxRelaxation;
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::mechanics::coordinated_step::coordinated_time_step;
use veridem::spec::{PairModel, Vec3};
use veridem::system::{Domain, System};

const DT: f64 = 1e-6;

fn pair() -> System {
    let spheres = System::builder().sphere([0.0; 3], 1.0, 0.01).sphere([1.99, 0.0, 0.0], 1.0, 0.01);
    spheres.build().expect("two spheres")
}

#[test]
fn a_setting_that_makes_no_sense_is_refused_by_name() {
    let good = settings(DT);
    for (name, settings) in [
        ("dt", Settings { dt: 0.0, ..good }),
        ("dt", Settings { dt: -DT, ..good }),
        ("dt", Settings { dt: f64::NAN, ..good }),
        ("damping", good.damping(-1.0)),
        ("damping", good.damping(f64::NAN)),
        ("skin", good.skin(-0.1)),
        ("skin", good.skin(f64::NAN)),
        ("skin", good.skin(f64::INFINITY)),
        ("max_overlap", good.max_overlap(f64::NAN)),
        ("far_every", good.far_every(0)),
    ] {
        let halt = Simulation::new(wear(), pair(), settings).map(drop).expect_err(name);
        assert!(matches!(halt.reason, Reason::Setting { name: of, .. } if of == name), "{name}: {halt}");
    }
    Simulation::new(wear(), pair(), good).expect("settings that make sense");
}

#[test]
fn a_neck_of_a_sphere_that_is_not_there_is_refused() {
    let system = System { necks: vec![(1, 7)], ..pair() };
    let halt = Simulation::new(wear(), system, settings(DT)).map(drop).expect_err("a neck of nothing");
    assert_eq!(halt.reason, Reason::NoSphere { particle: 7 });
}

#[test]
fn a_time_step_at_the_limit_is_refused_and_the_sphere_that_sets_it_is_named() {
    let spheres = System::builder().sphere([0.0; 3], 1.0, 0.01).sphere([9.0, 0.0, 0.0], 1.0, 0.0025);
    let system = spheres.sphere([18.0, 0.0, 0.0], 1.0, 0.01).build().expect("three spheres");
    let start = |dt: f64| Simulation::new(wear(), system.clone(), settings(dt));
    let (limit, sphere) = start(DT).expect("a short step").critical_time_step();
    assert_eq!((limit, sphere), (wear().critical_time_step_among(1.0, 0.0025, 1.0), 1));
    let halt = start(limit).map(drop).expect_err("the limit itself");
    assert_eq!(halt.reason, Reason::TimeStep { dt: limit, limit, particle: 1 });
    start(limit.next_down()).expect("a step below the limit");
}

#[test]
fn of_a_chain_the_middle_limits_the_step_and_the_deepest_pair_is_the_largest_overlap() {
    let mut chain = System::builder();
    for x in [0.0, 1.99, 3.97, 9.0, 10.985] {
        chain = chain.sphere([x, 0.0, 0.0], 1.0, 0.01);
    }
    let simulation = Simulation::new(wear(), chain.build().expect("spheres"), settings(DT)).expect("a short step");
    let stability = simulation.stability().expect("contacts");
    assert_eq!((stability.particle, stability.contacts, stability.necks, stability.dt), (1, 2, 0, DT));
    assert_eq!(stability.limit, coordinated_time_step(simulation.critical_time_step().0, 2.0));
    let (pair, ratio) = simulation.largest_overlap().expect("overlaps");
    assert!(pair == (1, 2) && (ratio - 0.01).abs() < 1e-12, "{pair:?} {ratio}");
}

#[test]
fn a_frame_does_not_hold_what_single_precision_does_not() {
    let simulation = |change: &dyn Fn(&mut System)| {
        let mut system = pair();
        change(&mut system);
        Simulation::new(wear(), system, settings(DT)).expect("a system within the range of doubles")
    };
    assert_eq!(simulation(&|_| ()).check_frame(), Ok(()));
    let fast = simulation(&|system| system.particles.v[1] = Vec3([0.0, 1e39, 0.0]));
    assert_eq!(fast.check_frame().expect_err("too fast").reason, Reason::NotFinite { particle: 1 });
    let spinning = simulation(&|system| system.particles.w[0] = Vec3([0.0, 0.0, -1e39]));
    assert_eq!(spinning.check_frame().expect_err("too fast").reason, Reason::NotFinite { particle: 0 });
    let wide = simulation(&|system| system.domain.sides[2] = 1e39);
    assert_eq!(
        wide.check_frame().expect_err("too wide").reason,
        Reason::NotANumber { quantity: "sides of the box".into() }
    );
}

#[test]
fn one_pair_that_overlaps_beyond_the_limit_stops_a_run_among_many_that_are_apart() {
    let mut aggregate = soot::system(|_| false);
    let particles = &mut aggregate.particles;
    let (last, deep) = (particles.len() as u32, 2.0 * soot::RADIUS - 1.0);
    let clear =
        |x: Vec3<f64>| particles.x.iter().filter(|&&other| (x - other).norm() < 2.0 * soot::RADIUS + 1.0).count() == 1;
    let along = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| Vec3(axis) * deep);
    let beside = particles.x.iter().flat_map(|&x| along.map(|branch| x + branch)).find(|&x| clear(x));
    particles.push(beside.expect("a sphere with a free side"), soot::RADIUS, soot::MASS, 0);
    let settings = soot::settings(soot::DT).max_overlap(0.02);
    let halt = Simulation::new(soot::dry(), aggregate, settings).and_then(|mut simulation| advance(&mut simulation, 2));
    let Err(Halt { reason: Reason::Overlap { pair, ratio, limit }, .. }) = halt else { panic!("{halt:?}") };
    assert!(pair.0 == last || pair.1 == last, "{pair:?}");
    assert!((ratio - 1.0 / (2.0 * soot::RADIUS)).abs() < 1e-3 && limit == 0.02, "{ratio}");
}

#[test]
fn a_box_that_grows_without_bounds_stops_the_run() {
    let relaxation = BoxRelaxation { target: [1e6, 0.0, 0.0], modulus: 1e-9 };
    let system = System { domain: Domain::periodic([50.0; 3]), ..pair() };
    let mut simulation = Simulation::new(wear(), system, settings(DT).relax_box(relaxation)).expect("a valid system");
    let halt = advance(&mut simulation, 100_000).expect_err("an endless box");
    assert_eq!(halt.reason, Reason::NotANumber { quantity: "sides of the box".into() });
}
