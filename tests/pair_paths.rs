//! Do the forces and torques along a path of two spheres at a fixed distance follow the equations?

use std::process::Command;
use veridem::spec::Vec3;
use veridem::spec::mechanics::projected_spring::stretched_spring;
use veridem::spec::titania::Titania;
use veridem::spec::titania::eq02_torque::moment_arm;
use veridem::spec::titania::eq11_contact_area::contact_area;
use veridem::spec::titania::eq12_sliding::sliding_spring;

const X: Vec3<f64> = Vec3([1.0, 0.0, 0.0]);

/// Runs a case and returns the rows of the series: the force and the torque on the first sphere, and those on the second.
fn rows(text: &str) -> Vec<[Vec3<f64>; 4]> {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("path.yaml"), text).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_veridem"))
        .current_dir(place.path())
        .args(["--quiet", "run", "path.yaml"])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut reader = csv::Reader::from_path(place.path().join("run/path/series.csv")).unwrap();
    let place_of = |wanted: &str, reader: &mut csv::Reader<std::fs::File>| {
        reader.headers().unwrap().iter().position(|name| name == wanted).unwrap()
    };
    let (first, step) = (place_of("force x on the first [pN]", &mut reader), place_of("step", &mut reader));
    let number = |row: &csv::StringRecord, k: usize| row[first + k].parse::<f64>();
    // The row at the start of a leg is what the first step will do, or the last one has done.
    let vectors = |row: csv::StringRecord| {
        (&row[step] != "0").then(|| [0, 3, 6, 9].map(|k| Vec3([0, 1, 2].map(|a| number(&row, k + a).unwrap()))))
    };
    reader.records().filter_map(|row| vectors(row.unwrap())).collect()
}

fn near(a: Vec3<f64>, b: Vec3<f64>, scale: f64) -> bool {
    (a - b).norm() < 1e-9 * scale
}

#[test]
fn a_tangential_loop_in_two_directions_has_the_force_of_the_sliding_equation() {
    // 0.4 nm to y, 0.4 nm to z, and back to y: 0.57 nm from where the spring was relaxed it has slipped.
    let legs = [[4.0, 0.0], [0.0, 4.0], [-4.0, 0.0], [0.0, -4.0]];
    let written = legs.map(|[y, z]| format!("{{duration: 0.1 ns, velocity: [{y} m/s, {z} m/s]}}")).join(", ");
    let found = rows(&format!(
        "title: a loop\nmodel: {{titania: {{}}}}\nsample: {{pair: {{}}}}\nexperiment: {{path: {{dt: 1 ps, legs: [{written}]}}}}\noutput: {{series: 1 steps}}\n"
    ));
    let law = Titania::paper(1.0, 1e3, 1.0);
    let r = law.contact_radius(8.0);
    let (d, dt) = (law.equilibrium(r, r), 1e-3);
    let (area, arm) = (contact_area(r - law.h_n, r - law.h_n, law.h_n, d).0, moment_arm(r, r, d));
    let strength = law.tau_s * area;
    let (mut spring, mut slips) = (Vec3::zero(), 0);
    let steps = legs.iter().flat_map(|&[y, z]| vec![Vec3([0.0, y, z]); 100]);
    assert_eq!(found.len(), 400);
    for ([force, torque, on_second, torque_second], v) in found.into_iter().zip(steps) {
        let (friction, kept) = sliding_spring(law.tau_s, area, law.lambda_t, stretched_spring(spring, X, v, dt), 0.0);
        slips += usize::from(kept == Vec3::zero());
        spring = kept;
        assert!(near(force.perpendicular_to(X), friction, strength), "{force:?} {friction:?}");
        let expected = friction.cross(X) * arm;
        assert!(near(torque, expected, arm * strength) && near(torque_second, expected, arm * strength));
        assert!(near(force, -on_second, strength));
    }
    assert!(slips > 0);
}

#[test]
fn rolling_meets_the_torque_of_the_slider_and_torsion_none() {
    let turn = |axis: usize, w: f64| {
        let spin =
            |w: f64| (0..3).map(|a| format!("{} 1/ns", if a == axis { w } else { 0.0 })).collect::<Vec<_>>().join(", ");
        format!("{{duration: 0.01 ns, spin_of_first: [{}], spin_of_second: [{}]}}", spin(w), spin(-w))
    };
    let legs = [turn(2, 3.0), turn(1, -3.0), turn(0, 3.0)].join(", ");
    let found = rows(&format!(
        "title: turns\nmodel: {{titania: {{}}}}\nsample: {{pair: {{}}}}\nexperiment: {{path: {{dt: 1 ps, legs: [{legs}]}}}}\noutput: {{series: 10 steps}}\n"
    ));
    let law = Titania::paper(1.0, 1e3, 1.0);
    let r = law.contact_radius(8.0);
    let area = contact_area(r - law.h_n, r - law.h_n, law.h_n, law.equilibrium(r, r)).0;
    let m = law.tau_r * area * 0.5 * r;
    for (row, expected) in found.iter().zip([Vec3([0.0, 0.0, -m]), Vec3([0.0, m, 0.0]), Vec3::zero()]) {
        assert!(near(row[1], expected, m) && near(row[3], -expected, m), "{row:?} {expected:?}");
        assert!(row[0].perpendicular_to(X).norm() < 1e-9 * m);
    }
}

#[test]
fn the_neck_of_two_spheres_of_soot_answers_each_motion_with_its_own_spring() {
    let zero = "0 1/ns";
    let legs = format!(
        "[{{duration: 0.001 ns, velocity: [2 m/s, 0 m/s]}}, {{duration: 0.001 ns, spin_of_first: [{zero}, {zero}, 0.1 1/ns], spin_of_second: [{zero}, {zero}, -0.1 1/ns]}}, {{duration: 0.001 ns, spin_of_first: [0.2 1/ns, {zero}, {zero}]}}, {{duration: 0.001 ns}}]"
    );
    let found = rows(&format!(
        "title: a neck\nmodel: {{soot: {{hamaker_constant: 0 J, capillary_force: 0 nN}}}}\nsample: {{pair: {{neck: true}}}}\nexperiment: {{path: {{distance: 28 nm, dt: 10 fs, legs: {legs}}}}}\noutput: {{series: 100 steps}}\n"
    ));
    assert_eq!(found.len(), 4);
    // At rest in the last leg: springs of 1e8 pN/nm alone.
    let (k, r) = (1e8, 14.0);
    let [force, torque, _, torque_second] = found[3];
    let slid = Vec3([0.0, -k * 0.002, 0.0]);
    assert!(near(force, slid, k * 0.002), "{force:?} {slid:?}");
    // The arm of sliding, the relative spin of 0.2 over 1 ps by the arm r, and the torsion by 0.2 over 1 ps.
    let (bent, twisted) = (k * r * r * 0.2e-3, k * r * r * 0.2e-3);
    let sliding = slid.cross(X) * r;
    let turning = Vec3([-twisted, 0.0, -bent]);
    assert!(near(torque, sliding + turning, bent), "{torque:?} {:?}", sliding + turning);
    assert!(near(torque_second, sliding - turning, bent), "{torque_second:?}");
}

/// Half a turn about the normal, with both spheres alike, after sliding: the force turns with the pair where springs are carried, and stays in space where they are projected, as in the papers.
#[test]
fn carried_springs_turn_with_a_pair_that_spins_about_its_normal() {
    let (spin, zero) = (50.0, "0 1/ns");
    let legs = format!(
        "[{{duration: 0.01 ns, velocity: [4 m/s, 0 m/s]}}, {{duration: {} ns, spin_of_first: [{spin} 1/ns, {zero}, {zero}], spin_of_second: [{spin} 1/ns, {zero}, {zero}]}}]",
        std::f64::consts::PI / spin
    );
    for (model, distance) in
        [("titania: {", ""), ("soot: {hamaker_constant: 0 J, capillary_force: 0 nN, ", "distance: 27.9 nm, ")]
    {
        let forces = |springs: &str| {
            let found = rows(&format!(
                "title: a spin\nmodel: {{{model}springs: {springs}}}}}\nsample: {{pair: {{}}}}\nexperiment: {{path: {{{distance}dt: 10 fs, legs: {legs}}}}}\noutput: {{series: 10 steps}}\n"
            ));
            let slid = found[99][0].perpendicular_to(X);
            (slid, found.last().unwrap()[0].perpendicular_to(X))
        };
        let ((slid, carried), (same, projected)) = (forces("carried"), forces("projected"));
        assert_eq!(slid, same);
        // The dashpot, which only the sliding has, is 1 % of the force.
        assert!(slid.norm() > 0.0 && (projected - slid).norm() < 0.02 * slid.norm(), "{model} {projected:?} {slid:?}");
        // The duration is rounded to steps, in each of which the pair turns by 5e-4.
        let size = projected.norm();
        assert!((carried + projected).norm() < 1e-3 * size, "{model} {carried:?} {projected:?}");
    }
}
