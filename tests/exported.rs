//! Does `veridem export` write what LAMMPS needs? Whether LAMMPS computes the same with it is checked in `bindings/lammps/check`.

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
fn what_the_plugin_does_not_have_is_refused_by_name() {
    let place = tempfile::tempdir().unwrap();
    let (code, said) = refused(place.path(), &case("soot"), "there");
    assert_eq!(code, Some(65), "{said}");
    assert!(said.contains("necks that break"), "{said}");
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
