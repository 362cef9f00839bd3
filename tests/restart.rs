//! Is a run that was stopped and resumed the same, byte for byte, as one that was not?

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Duration;
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::output::{Manifest, RunFolder, Status};
use veridem::papers::PAPERS;

fn veridem(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_veridem")).arg("--quiet").args(arguments).output().unwrap()
}

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

/// Every file of a run folder but the manifest, which tells the runs' histories.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if !["manifest.json", "report.html"].iter().any(|name| path.file_name().unwrap() == *name) {
                found.insert(path.strip_prefix(folder).unwrap().to_path_buf(), std::fs::read(&path).unwrap());
            }
        }
    }
    found
}

fn assert_same(a: &Path, b: &Path, when: &str) {
    let (a, b) = (files(a), files(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>(), "{when}");
    for (path, bytes) in &a {
        assert!(*bytes == b[path], "{} differs: {when}", path.display());
    }
}

/// Runs a case without a break, and again with a stop after each of the given numbers of steps.
fn survives_stops(name: &str, stops: &[u64]) {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().display().to_string();
    assert!(veridem(&["run", &case(name), "--out", &out, "--name", "whole"]).status.success());
    let whole = place.path().join("whole");
    for stop in stops {
        let parts = place.path().join("parts").display().to_string();
        let arguments = ["run", &case(name), "--out", &out, "--name", "parts", "--force", "--stop-after-steps"];
        let stopped = veridem(&[&arguments[..], &[&stop.to_string()]].concat());
        assert_eq!(stopped.status.code(), Some(75), "{}", String::from_utf8_lossy(&stopped.stderr));
        assert_eq!(
            String::from_utf8_lossy(&stopped.stderr),
            format!("stopped; resume with `veridem resume {parts}`\n")
        );
        let again = veridem(&["resume", &parts, "--stop-after-steps", "7"]);
        assert_eq!(again.status.code(), Some(75), "{}", String::from_utf8_lossy(&again.stderr));
        let resumed = veridem(&["resume", &parts]);
        assert!(resumed.status.success(), "{}", String::from_utf8_lossy(&resumed.stderr));
        assert_same(&whole, Path::new(&parts), &format!("stopped after {stop} steps"));
    }
}

#[test]
fn a_junction_goes_on_with_the_same_bits_wherever_it_is_stopped() {
    // In each stage, at the first step of a stage, at and beside a checkpoint, near the end.
    survives_stops("junction", &[0, 1, 200, 201, 230, 414, 415, 416, 830]);
}

#[test]
fn sliding_bodies_go_on_with_the_same_bits_wherever_they_are_stopped() {
    // In the relaxation, and within the first and the last window of the sliding.
    survives_stops("sliding", &[150, 230, 700]);
}

#[test]
fn patch_tests_go_on_with_the_same_bits_wherever_they_are_stopped() {
    survives_stops("patch-hcp", &[130, 299, 300, 700]);
}

#[test]
fn necks_of_different_strengths_break_at_the_same_steps_wherever_a_run_is_stopped() {
    // Necks break after 10 to 20 steps, and after 270, 495 and 1070.
    survives_stops("soot-neck-strengths", &[0, 17, 269, 600]);
}

#[test]
fn a_run_stopped_by_time_can_be_resumed() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().display().to_string();
    let stopped = veridem(&["run", &case("junction"), "--out", &out, "--max-time", "0"]);
    assert_eq!(stopped.status.code(), Some(75));
    let resumed = veridem(&["resume", &place.path().join("junction").display().to_string()]);
    assert!(resumed.status.success(), "{}", String::from_utf8_lossy(&resumed.stderr));
}

#[test]
fn a_killed_run_goes_on_from_its_last_checkpoint() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().display().to_string();
    for name in ["whole", "killed"] {
        assert!(veridem(&["run", &case("junction"), "--out", &out, "--name", name]).status.success());
    }
    let (whole, killed) = (place.path().join("whole"), place.path().join("killed"));
    // As if the process had vanished some time after its last checkpoint.
    std::fs::remove_file(killed.join("results.yaml")).unwrap();
    let manifest = std::fs::read_to_string(killed.join("manifest.json")).unwrap();
    std::fs::write(killed.join("manifest.json"), manifest.replacen("finished", "running", 1)).unwrap();
    let series = killed.join("series.csv");
    let half_a_row = std::fs::read_to_string(&series).unwrap() + "shearing,99";
    std::fs::write(&series, half_a_row).unwrap();
    let resumed = veridem(&["resume", &killed.display().to_string()]);
    assert!(resumed.status.success(), "{}", String::from_utf8_lossy(&resumed.stderr));
    assert_same(&whole, &killed, "killed");
}

#[test]
fn a_finished_run_is_not_resumed_and_not_overwritten() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().display().to_string();
    let root = place.path().join("patch-hcp").display().to_string();
    assert!(veridem(&["run", &case("patch-hcp"), "--out", &out]).status.success());
    let again = veridem(&["run", &case("patch-hcp"), "--out", &out]);
    assert_eq!(again.status.code(), Some(2));
    assert_eq!(
        String::from_utf8_lossy(&again.stderr),
        format!("{root}: exists already; use --force to replace it, or --name for another\n")
    );
    let resumed = veridem(&["resume", &root]);
    assert_eq!(resumed.status.code(), Some(2));
    assert_eq!(String::from_utf8_lossy(&resumed.stderr), format!("{root}: has finished; there is nothing to resume\n"));
}

#[test]
fn a_run_is_not_resumed_with_another_case_or_another_file() {
    let place = tempfile::tempdir().unwrap();
    let within = |arguments: &[&str]| {
        let veridem = Command::new(env!("CARGO_BIN_EXE_veridem")).current_dir(place.path()).args(arguments).output();
        let Output { status, stderr, .. } = veridem.unwrap();
        (status.code(), String::from_utf8(stderr).unwrap())
    };
    let write = |name: &str, text: &str| std::fs::write(place.path().join(name), text).unwrap();
    let tip = |height: f64| {
        let corners = [[0.0, 0.0, 0.0], [9.0, 0.0, height], [-9.0, 9.0, height], [-9.0, -9.0, height]];
        let corner = |k: usize| format!("vertex {} {} {}\n", corners[k][0], corners[k][1], corners[k][2]);
        let face = |[a, b, c]: [usize; 3]| {
            format!("facet normal 0 0 0\nouter loop\n{}{}{}endloop\nendfacet\n", corner(a), corner(b), corner(c))
        };
        let faces: String = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]].map(face).concat();
        format!("solid tip\n{faces}endsolid tip\n")
    };
    write("tip.stl", &tip(20.0));
    write(
        "tip.yaml",
        "title: A tip from a file\nmodel: {soot: {necks: S}}\nsample: {aggregate: {spheres: 10, neck_fraction: 1}}\n\
         experiment: {sequence: [{deposition: {duration: 20 steps}}, \
         {indentation: {tip: {stl: tip.stl, unit: 1 nm}, duration: 20 steps}}]}\n",
    );
    let resume = |steps: &str| within(&["--quiet", "resume", "run/tip", "--stop-after-steps", steps]);
    let stopped = (Some(75), "stopped; resume with `veridem resume run/tip`\n".to_string());
    assert_eq!(within(&["--quiet", "run", "tip.yaml", "--stop-after-steps", "5"]), stopped);

    // The run has a copy.
    std::fs::remove_file(place.path().join("tip.stl")).unwrap();
    assert_eq!(resume("1"), stopped);
    let copy = "run/tip/inputs/tip.stl";
    write(copy, &tip(21.0));
    assert_eq!(resume("5"), (Some(65), format!("{copy}: has changed since the run was started\n")));
    std::fs::remove_file(place.path().join(copy)).unwrap();
    let missing = format!("{copy}: cannot be read: No such file or directory (os error 2)\n");
    assert_eq!(resume("5"), (Some(66), missing));
    write(copy, &tip(20.0));
    assert_eq!(resume("20"), stopped);
    // By now the tip is in the checkpoint.
    std::fs::remove_file(place.path().join(copy)).unwrap();
    assert_eq!(resume("5"), stopped);

    let case = std::fs::read_to_string(place.path().join("run/tip/case.yaml")).unwrap();
    write("run/tip/case.yaml", &case.replace("spheres: 10", "spheres: 11"));
    assert_eq!(resume("5"), (Some(65), "run/tip/case.yaml: has changed since the run was started\n".into()));
}

#[test]
fn an_interruption_while_the_sample_is_built_leaves_a_run_to_resume() {
    for name in ["soot-short", "titania-film"] {
        let place = tempfile::tempdir().unwrap();
        let [whole, parts] = ["whole", "parts"].map(|run| place.path().join(run));
        let job = PAPERS.read(Path::new(&case(name))).unwrap();
        let over = Interrupt::default().within(Duration::ZERO);
        let stopped = job.launch(&parts, false, &over, &mut |_| {}).map(drop).unwrap_err();
        assert!(matches!(&stopped, Error::Stopped(Some(run)) if *run == parts), "{name}: {stopped}");
        assert_eq!(Manifest::read(&RunFolder::open(&parts).unwrap()).unwrap().status, Status::Stopped);
        let resumed = veridem(&["resume", &parts.display().to_string()]);
        assert!(resumed.status.success(), "{name}: {}", String::from_utf8_lossy(&resumed.stderr));
        job.launch(&whole, false, &Interrupt::default(), &mut |_| {}).unwrap();
        assert_same(&whole, &parts, name);
    }
}

#[test]
fn a_record_shorter_than_its_checkpoint_leaves_the_run_as_it_was() {
    let place = tempfile::tempdir().unwrap();
    let run = place.path().join("run");
    let out = place.path().display().to_string();
    let stopped = veridem(&["run", &case("titania-pair"), "--out", &out, "--name", "run", "--stop-after-steps", "300"]);
    assert_eq!(stopped.status.code(), Some(75), "{}", String::from_utf8_lossy(&stopped.stderr));
    std::fs::write(run.join("series.csv"), "").unwrap();
    let refused = veridem(&["resume", &run.display().to_string()]);
    assert!(!refused.status.success(), "there is nothing to append to");
    assert_eq!(Manifest::read(&RunFolder::open(&run).unwrap()).unwrap().status, Status::Stopped);
}
