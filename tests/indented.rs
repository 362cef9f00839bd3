//! Is what a case names indented, and does an aggregate of a file stay where it lies?

use std::path::Path;
use veridem::interrupt::Interrupt;
use veridem::papers::parse;
use veridem::papers::soot::{Plan, Soot};
use veridem::run::Study;
use veridem::spec::Vec3;
use veridem::spec::soot::Along;
use veridem::system::{Shape, System};

/// A pyramid of three spheres with a fourth on top, the lowest a little pressed into the substrate.
const ROWS: &str = "x,y,z,r\n0,0,13.99,14\n28,0,14,14\n14,24.24871130596428,14,14\n14,8.08290376865476,36.86190427985671,14\n60,8,14,14\n";

/// The system at the beginning of the indentation of a case with these keys.
fn begun(sample: &str, indent: &str) -> Result<System, String> {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("a.csv");
    std::fs::write(&file, ROWS).unwrap();
    let text = format!(
        "title: x\nmodel: {{soot: {{}}}}\nsample: {{aggregate: {{{sample}, import: {{file: {}, unit: 1 nm, disconnected: true}}}}}}\nexperiment:\n  sequence:\n    - indentation: {{keep_necks: 1.0{indent}}}\n",
        file.display()
    );
    let case = parse::<Soot>(Path::new("case.yaml"), &text).map_err(|error| error.to_string())?;
    let plan = Plan::of(&case, Along);
    let system = plan.initial(&Interrupt::default()).map_err(|error| error.to_string())?;
    plan.set_up(0, system).map_err(|error| error.to_string())
}

/// The lowest point of the tip, from the middle of the box.
fn apex(system: &System) -> Vec3<f64> {
    let Shape::Mesh(mesh) = &system.surfaces[1].shape else { panic!("a tip") };
    let lowest = mesh.vertices().iter().copied().reduce(|a, b| if b.0[2] < a.0[2] { b } else { a }).unwrap();
    let [a, b, _] = system.domain.sides;
    lowest - Vec3([0.5 * a, 0.5 * b, 0.0])
}

#[test]
fn the_tip_is_above_the_sphere_or_the_place_that_is_named() {
    let sphere = begun("on_substrate: true", ", indent: {sphere: 3}").unwrap();
    // Half a radius above its top.
    let top = Vec3([14.0, 8.08290376865476, 36.86190427985671 + 21.0]);
    assert!((apex(&sphere) - top).norm() < 1e-9, "{:?}", apex(&sphere));
    let place = begun("on_substrate: true", ", indent: {place: [14 nm, 8.08290376865476 nm]}").unwrap();
    assert!((apex(&place) - top).norm() < 1e-6, "{:?}", apex(&place));
    let aside = begun("on_substrate: true", ", indent: {place: [60 nm, 8 nm]}").unwrap();
    let found = apex(&aside);
    assert!(found.0[2] >= 14.0 + 21.0 - 1e-6 && (found.0[0] - 60.0).abs() < 1e-9, "{found:?}");
    let drawn = begun("on_substrate: true", "").unwrap();
    assert!(
        [3usize, 4]
            .iter()
            .any(|&k| (apex(&drawn) - drawn.particles.x[k]).perpendicular_to(Vec3([0.0, 0.0, 1.0])).norm() > 0.0)
    );
}

#[test]
fn spheres_on_the_substrate_stay_where_they_are_given() {
    let system = begun("on_substrate: true", "").unwrap();
    let [a, b, _] = system.domain.sides;
    for (x, row) in system.particles.x.iter().zip(ROWS.lines().skip(1)) {
        let given: Vec<f64> = row.split(',').take(3).map(|word| word.parse().unwrap()).collect();
        assert!((*x - Vec3([given[0] + 0.5 * a, given[1] + 0.5 * b, given[2]])).norm() < 1e-12);
    }
    assert_eq!(system.surfaces[0].name, "substrate");
}

#[test]
fn what_cannot_be_indented_is_named() {
    let hidden = begun("on_substrate: true", ", indent: {sphere: 0}").unwrap_err();
    assert!(
        hidden.contains("experiment.sequence[0].indentation.indent.sphere: found `0`, expected an exposed sphere: 3"),
        "{hidden}"
    );
    let beside = begun("on_substrate: true", ", indent: {place: [300 nm, 0 nm]}").unwrap_err();
    assert!(beside.contains("indent.place: found `300 nm, 0 nm`, expected a place above a sphere"), "{beside}");
    let floating = begun("on_substrate: false", ", indent: {sphere: 3}").unwrap_err();
    assert!(floating.contains("expected a deposition before it"), "{floating}");
}
