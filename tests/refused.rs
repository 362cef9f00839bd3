//! Are settings and systems that make no sense refused before the first step?

mod common;

use common::{settings, wear};
use veridem::error::Reason;
use veridem::simulation::{Settings, Simulation};
use veridem::system::System;

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
