//! Is a saved and loaded relaxed film the same film?

use std::path::Path;
use std::process::{Command, Output};
use veridem::output::{RunFolder, Series};

const EXPERIMENT: &str = "
    relaxation: 0.2 ns
    drag: 1e-11 kg/s
    tip:
      radius: 10 nm
      side: 60 nm
    speed: 5 m/s
    reversal: 0.2 ns
    average: 50 ps
    depth: 2 nm
    retraction: 1 nm
output:
  series: 50 ps
  frames: 10 ns
  checkpoints: 3 ns
";

fn run(place: &Path, name: &str, seed: u64, film: &str) -> Output {
    let case = format!(
        "title: A film\nseed: {seed}\nmodel:\n  titania: {{}}\nsample:\n  film:\n    particles: 260\n    sides: [140 nm, 140 nm]\n    \
         aggregates:\n      median: 8\n      largest: 16\n    {film}\nexperiment:\n  spectroscopy:{EXPERIMENT}"
    );
    let file = place.join(name).with_extension("yaml");
    std::fs::write(&file, case).unwrap();
    let mut veridem = Command::new(env!("CARGO_BIN_EXE_veridem"));
    veridem
        .current_dir(place)
        .args(["--quiet", "--threads", "1", "run"])
        .arg(file)
        .args(["--name", name])
        .output()
        .unwrap()
}

/// What was measured after the relaxation.
fn curve(place: &Path, name: &str) -> Vec<String> {
    let series = Series::read(&RunFolder::open(&place.join("run").join(name)).unwrap()).unwrap();
    let columns =
        ["tip moved [nm]", "force on the tip [pN]", "kinetic energy [zJ]", "menisci", "mean force on the tip [pN]"];
    let points = |(stage, column)| series.curve_of(stage, "step", column);
    let stages = ["approach", "retraction"].into_iter();
    let all = stages.flat_map(|stage| columns.map(|column| (stage, column)));
    all.flat_map(|of| points(of).into_iter().map(move |point| format!("{of:?} {point:?}"))).collect()
}

#[test]
fn a_kept_film_gives_the_same_curve_and_another_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let kept = run(place, "kept", 3, "save: one.film");
    assert!(kept.status.success(), "{}", String::from_utf8_lossy(&kept.stderr));
    let results = std::fs::read_to_string(place.join("run/kept/results.yaml")).unwrap();
    for name in [
        "porosity of the relaxed film",
        "mean number of contacts between an aggregate and others",
        "pore diameter, 50th percentile",
    ] {
        assert!(results.contains(name), "{results}");
    }
    let loaded = run(place, "loaded", 3, "load: one.film");
    assert!(loaded.status.success(), "{}", String::from_utf8_lossy(&loaded.stderr));
    assert!(curve(place, "kept").len() > 5);
    assert_eq!(curve(place, "kept"), curve(place, "loaded"));

    let other = run(place, "other", 4, "load: one.film");
    assert_eq!(other.status.code(), Some(65));
    assert!(String::from_utf8_lossy(&other.stderr).contains("another model, film, relaxation or seed"));
}
