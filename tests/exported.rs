//! Does `veridem export` write what other programs need? Whether LAMMPS computes the same with it is checked in `bindings/lammps/tests`.

#[path = "common/program.rs"]
mod program;

use program::veridem;
use std::path::Path;

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

fn exported(place: &Path, from: &str, out: &str) -> [String; 3] {
    let done = veridem(place, &["export", "--lammps", from, "--out", out]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    ["state.data", "state.history", "in.lammps"]
        .map(|name| std::fs::read_to_string(place.join(out).join(name)).unwrap())
}

fn refused(place: &Path, from: &str, out: &str) -> (Option<i32>, String) {
    let done = veridem(place, &["export", "--lammps", from, "--out", out]);
    (done.status.code(), String::from_utf8_lossy(&done.stderr).to_string())
}

#[test]
fn an_aggregate_is_exported_with_its_necks_and_its_law() {
    let place = tempfile::tempdir().unwrap();
    let [data, history, input] = exported(place.path(), &case("soot-short"), "there");
    let count: usize = data.lines().find_map(|line| line.strip_suffix(" atoms")).unwrap().parse().unwrap();
    let rows = data.split("Velocities").next().unwrap().split("Atoms # sphere").nth(1).unwrap();
    assert_eq!(rows.lines().filter(|line| !line.is_empty()).count(), count);
    let necks = history.lines().skip(1).map(|line| line.split(' ').collect::<Vec<_>>()).filter(|row| row[2] == "1");
    assert!(necks.clone().count() > 0 && necks.clone().all(|row| row.len() == 11));
    for line in ["units nano", "newton off", "comm_modify vel yes", "pair_style veridem/soot neck_springs 1"] {
        assert!(input.lines().any(|found| found.starts_with(line)), "{line}\n{input}");
    }
}

#[test]
fn necks_are_exported_with_their_strength_and_a_box_with_what_moves_its_sides() {
    let place = tempfile::tempdir().unwrap();
    let [_, _, input] = exported(place.path(), &case("soot"), "necks");
    assert!(input.contains(" break_stress 5000 5000 5\n"), "{input}");
    let sample = "{amorphous: {diameter: 3 nm, size: [24 nm, 24 nm, 18 nm], relaxation: {repulsion_steps: 100}}}";
    let experiment = "{patch: {walls: 3 nm, shear: {strain: 0.01}}}";
    let silica = std::fs::read_to_string(case("junction")).unwrap();
    let model = silica.split("sample:").next().unwrap();
    std::fs::write(place.path().join("relaxes.yaml"), format!("{model}sample: {sample}\nexperiment: {experiment}\n"))
        .unwrap();
    let done = veridem(place.path(), &["run", "relaxes.yaml", "--out", "run", "--stop-after-steps", "102"]);
    assert_eq!(done.status.code(), Some(75), "{}", String::from_utf8_lossy(&done.stderr));
    let [_, _, input] = exported(place.path(), "run/relaxes", "box");
    let words: Vec<f64> = input
        .split(" relax ")
        .nth(1)
        .unwrap()
        .lines()
        .next()
        .unwrap()
        .split(' ')
        .map(|word| word.parse().unwrap())
        .collect();
    let [modulus, _, _, _, owed @ .., x, y, z] = &words[..] else { panic!("{input}") };
    assert!(*modulus > 0.0 && *owed == [0.0; 3] && [x, y, z].iter().all(|flux| **flux > 0.0), "{input}");
}

#[test]
fn what_comes_back_is_imported_and_compared() {
    let place = tempfile::tempdir().unwrap();
    let dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n\
                ITEM: ATOMS id radius x y z vx vy vz omegax omegay omegaz\n2 1 3 1 1 0 0 5 0 0 1\n1 1 1 1 1 0 0 4 0 0 1\n";
    std::fs::write(place.path().join("a.dump"), dump).unwrap();
    std::fs::write(place.path().join("b.dump"), dump.replace("2 1 3 1 1", "2 1 3.25 1 1")).unwrap();
    for name in ["a", "b"] {
        let words =
            ["import", &format!("{name}.dump"), "--unit", "1 nm", "--disconnected", "--out", &format!("{name}.xyz")];
        let done = veridem(place.path(), &words);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    }
    let diff = |words: &[&str]| veridem(place.path(), &[&["inspect", "--diff", "a.xyz", "b.xyz"], words].concat());
    let apart = diff(&[]);
    let said = String::from_utf8_lossy(&apart.stdout).to_string();
    assert!(apart.status.code() == Some(4) && said.contains("2.5e-1 of 3.250e0, sphere 1"), "{said}");
    assert!(diff(&["--within", "0.1"]).status.success());
}

#[test]
fn what_the_plugin_does_not_have_is_refused_by_name() {
    let place = tempfile::tempdir().unwrap();
    let often =
        std::fs::read_to_string(case("soot")).unwrap().replace("{dt: 50 fs", "{attraction_every: 10, dt: 50 fs");
    std::fs::write(place.path().join("often.yaml"), often).unwrap();
    let (code, said) = refused(place.path(), "often.yaml", "there");
    assert_eq!(code, Some(65), "{said}");
    assert!(said.contains("`attraction_every` other than 1"), "{said}");
    assert!(!place.path().join("there").exists());
}

#[test]
fn nothing_is_overwritten() {
    let place = tempfile::tempdir().unwrap();
    std::fs::create_dir(place.path().join("there")).unwrap();
    let (code, said) = refused(place.path(), &case("soot-short"), "there");
    assert_eq!(code, Some(2), "{said}");
    assert_eq!(std::fs::read_dir(place.path().join("there")).unwrap().count(), 0);
}

#[test]
fn the_spheres_of_a_frame_are_exported_for_optics_and_mobility() {
    let place = tempfile::tempdir().unwrap();
    let frame = "3\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 1\nC 0 0 2.5 1.5\nC 0.1 0 5.25 1.25\n";
    std::fs::write(place.path().join("frame.xyz"), frame).unwrap();
    let export = |target: &str, out: &str| {
        let done = veridem(place.path(), &["export", target, "frame.xyz", "--out", out]);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        std::fs::read_to_string(place.path().join(out)).unwrap()
    };
    assert_eq!(export("--mstm", "spheres.dat"), "0 0 0 1\n0 0 2.5 1.5\n0.1 0 5.25 1.25\n");
    assert_eq!(export("--bod", "body.bod").lines().nth(2), Some("SPHERE 0.1 0 5.25 1.25"));
    let mesh = export("--ply", "mesh.ply");
    let (head, body) = mesh.split_once("end_header\n").unwrap();
    assert!(head.contains("element vertex 486\n") && head.contains("element face 960\n"), "{head}");
    let numbers = |line: &str| line.split(' ').map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<_> = body.lines().map(numbers).collect();
    assert_eq!(rows.len(), 486 + 960);
    assert!(rows[..162].iter().all(|row| (row.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12));
    assert!(rows[486..].iter().all(|row| row[0] == 3.0 && row[1..].iter().all(|&corner| corner < 486.0)));
    let again = veridem(place.path(), &["export", "--bod", "frame.xyz", "--out", "body.bod"]);
    assert!(String::from_utf8_lossy(&again.stderr).contains("exists already"));
}
