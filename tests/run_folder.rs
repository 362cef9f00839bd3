//! Is nothing lost but what a run has made, and nothing taken for a result that is none?

#[path = "common/program.rs"]
mod program;

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use veridem::output::{Lock, Manifest, RunFolder, Status};

const STOP: &str = "--stop-after-steps";

fn case(name: &str) -> String {
    format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

/// Exit status and messages of a command in a folder.
fn veridem(place: &Path, arguments: &[&str]) -> (i32, String) {
    let Output { status, stderr, .. } = program::veridem(place, arguments);
    (status.code().expect("no signal"), String::from_utf8_lossy(&stderr).to_string())
}

fn write(path: PathBuf, text: &str) -> PathBuf {
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(&path, text).unwrap();
    path
}

fn flip(path: &Path, at: usize) {
    let mut bytes = std::fs::read(path).unwrap();
    bytes[at] ^= 1;
    std::fs::write(path, bytes).unwrap();
}

/// A run stopped after some steps, in `run/NAME` of a place.
fn stopped(place: &Path, name: &str, steps: &str) -> PathBuf {
    let case = case("patch-hcp");
    let (status, told) = veridem(place, &["--quiet", "run", &case, "--name", name, "--force", STOP, steps]);
    assert_eq!(status, 75, "{told}");
    place.join("run").join(name)
}

#[test]
fn a_folder_that_is_no_run_s_is_never_replaced() {
    let place = tempfile::tempdir().unwrap();
    let place = place.path();
    let text = std::fs::read_to_string(case("patch-hcp")).unwrap();
    let mine = write(place.join("proj/case.yaml"), &text);
    let notes = write(place.join("proj/notes.txt"), "mine");
    let (status, told) = veridem(place, &["run", "proj/case.yaml", "--out", ".", "--name", "proj", "--force"]);
    assert_eq!((status, told.contains("proj: is not ")), (2, true), "{told}");
    for name in ["", ".", "..", "../x", "a/b", "a/", "/tmp/x", "C:x", "a\\b"] {
        let (status, told) = veridem(place, &["run", "proj/case.yaml", "--out", "proj", "--name", name, "--force"]);
        assert_eq!((status, told.contains("expected a single file name")), (2, true), "{name}: {told}");
    }
    // A run folder whose case has been changed is one no more.
    let run = stopped(place, "run", "3");
    write(run.join("case.yaml"), "title: mine\n");
    let (status, told) = veridem(place, &["run", &case("patch-hcp"), "--name", "run", "--force"]);
    assert_eq!((status, told.contains("is not a run folder")), (2, true), "{told}");
    assert!(mine.exists() && notes.exists() && run.join("series.csv").exists());
}

#[test]
fn a_folder_that_holds_the_case_is_not_replaced() {
    let place = tempfile::tempdir().unwrap();
    let run = stopped(place.path(), "run", "3");
    let (status, told) = veridem(place.path(), &["run", "run/run/case.yaml", "--name", "run", "--force"]);
    assert_eq!((status, told.contains("which the run reads")), (2, true), "{told}");
    assert!(run.join("series.csv").exists());
}

#[cfg(unix)]
#[test]
fn only_the_files_of_a_run_are_removed_and_no_link_is_followed() {
    let place = tempfile::tempdir().unwrap();
    let run = stopped(place.path(), "run", "300");
    let strangers = ["notes.txt", "figures/mine.svg", "frames/best.xyz", "checkpoints/kept.bin", "more/a.csv"];
    for name in strangers {
        write(run.join(name), "mine");
    }
    let elsewhere = write(place.path().join("elsewhere/000000.xyz"), "mine");
    std::fs::rename(run.join("frames"), place.path().join("frames")).unwrap();
    std::os::unix::fs::symlink(place.path().join("elsewhere"), run.join("frames")).unwrap();
    let (status, told) = veridem(place.path(), &["run", &case("patch-hcp"), "--name", "run", "--force", STOP, "2"]);
    assert_eq!(status, 75, "{told}");
    for name in strangers.iter().filter(|name| !name.starts_with("frames")) {
        let named = if name.starts_with("more") { "more" } else { name };
        assert!(run.join(name).exists() && told.contains(&format!("{named}: was not made by a run")), "{name}: {told}");
    }
    assert_eq!(std::fs::read_to_string(elsewhere).unwrap(), "mine");
    let checkpoints = std::fs::read_dir(run.join("checkpoints")).unwrap().count();
    assert_eq!(checkpoints, 2, "the one of the new run, and that of the user");
}

#[test]
fn a_folder_is_written_by_one_process_and_the_other_is_told_by_which() {
    let place = tempfile::tempdir().unwrap();
    let run = stopped(place.path(), "run", "3");
    let lock = Lock::take(&run).unwrap();
    let holder = format!("is being written by process {}", std::process::id());
    let case = case("patch-hcp");
    for arguments in [&["resume", "run/run"][..], &["run", &case, "--name", "run", "--force"]] {
        let (status, told) = veridem(place.path(), arguments);
        assert_eq!((status, told.contains(&holder)), (74, true), "{told}");
    }
    drop(lock);
    assert_eq!(veridem(place.path(), &["resume", "run/run", STOP, "1"]).0, 75);
    let out = Lock::take(place.path()).unwrap();
    let (status, told) = veridem(place.path(), &["sweep", &case, "seed=1..2", "--out", "."]);
    assert_eq!((status, told.contains(&holder)), (74, true), "{told}");
    drop(out);
}

#[test]
fn of_two_runs_that_begin_at_once_in_one_folder_one_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let start = || {
        let mut run = Command::new(env!("CARGO_BIN_EXE_veridem"));
        let run = run.current_dir(place.path()).args(["--quiet", "run", &case("patch-hcp"), "--threads", "1"]);
        run.stderr(Stdio::null()).stdout(Stdio::null()).spawn().unwrap()
    };
    let (mut one, mut other) = (start(), start());
    let mut ends = [&mut one, &mut other].map(|run| run.wait().unwrap().code().unwrap());
    ends.sort_unstable();
    assert!(ends[0] == 0 && [2, 74].contains(&ends[1]), "{ends:?}");
}

#[test]
fn a_run_that_was_killed_before_its_first_checkpoint_begins_anew() {
    let place = tempfile::tempdir().unwrap();
    let case = case("patch-hcp");
    for missing in ["case.yaml", "series.csv", "frames", "checkpoints"] {
        let run = stopped(place.path(), "run", "0");
        std::fs::remove_file(run.join("checkpoints/stopped.checkpoint")).unwrap();
        let path = run.join(missing);
        if path.is_dir() {
            std::fs::remove_dir_all(&path).unwrap()
        } else {
            std::fs::remove_file(&path).unwrap()
        }
        let again = veridem(place.path(), &["run", &case, "--name", "run", "--force", STOP, "5"]);
        assert_eq!(again.0, 75, "{missing}: {}", again.1);
    }
    std::fs::create_dir_all(place.path().join("run/empty/frames")).unwrap();
    let (status, told) = veridem(place.path(), &["run", &case, "--name", "empty", STOP, "5"]);
    assert_eq!(status, 75, "{told}");
}

#[test]
fn missing_folders_are_made_again_and_missing_frames_are_told() {
    let place = tempfile::tempdir().unwrap();
    let run = stopped(place.path(), "run", "300");
    for folder in ["frames", "figures"] {
        std::fs::remove_dir_all(run.join(folder)).unwrap();
    }
    let (status, told) = veridem(place.path(), &["resume", "run/run"]);
    assert_eq!(
        (status, told.contains("missing frame files, the first is run/run/frames/compression.000000.bonds")),
        (0, true),
        "{told}"
    );
    assert!(run.join("report.html").exists());
}

#[test]
fn damage_to_the_record_is_found_before_anything_is_computed() {
    let place = tempfile::tempdir().unwrap();
    for (file, at) in [("series.csv", 100), ("events.jsonl", 10), ("frames/compression.000000.xyz", 50)] {
        let run = stopped(place.path(), "run", "3");
        flip(&run.join(file), at);
        let (status, told) = veridem(place.path(), &["resume", "run/run"]);
        let named = told.contains(&format!("run/run/{file}: has changed since the checkpoint"));
        assert_eq!((status, named), (65, true), "{told}");
        assert_eq!(Manifest::read(&RunFolder::open(&run).unwrap()).unwrap().status, Status::Stopped);
    }
}

#[test]
fn a_record_that_lost_its_end_goes_on_from_the_older_checkpoint() {
    let place = tempfile::tempdir().unwrap();
    let (whole, parts) = (place.path().join("run/whole"), stopped(place.path(), "parts", "300"));
    assert_eq!(veridem(place.path(), &["--quiet", "run", &case("patch-hcp"), "--name", "whole"]).0, 0);
    let series = std::fs::read(parts.join("series.csv")).unwrap();
    std::fs::write(parts.join("series.csv"), &series[..series.len() - 1]).unwrap();
    let (status, told) = veridem(place.path(), &["resume", "run/parts"]);
    assert_eq!((status, told.contains("an older checkpoint is used")), (0, true), "{told}");
    for name in ["series.csv", "events.jsonl", "results.yaml"] {
        assert!(std::fs::read(whole.join(name)).unwrap() == std::fs::read(parts.join(name)).unwrap(), "{name}");
    }
    let state = |run: &Path| Manifest::read(&RunFolder::open(run).unwrap()).unwrap().final_state;
    assert!(state(&whole).is_some() && state(&whole) == state(&parts));
}

#[test]
fn a_checkpoint_of_another_run_is_refused_by_name() {
    let place = tempfile::tempdir().unwrap();
    let run = stopped(place.path(), "run", "300");
    let text = std::fs::read_to_string(case("patch-hcp")).unwrap();
    write(place.path().join("patch-hcp.yaml"), &format!("{text}\n# another\n"));
    let other = veridem(place.path(), &["--quiet", "run", "patch-hcp.yaml", "--name", "other", STOP, "300"]);
    assert_eq!(other.0, 75, "{}", other.1);
    let stopped = "checkpoints/stopped.checkpoint";
    std::fs::copy(place.path().join("run/other").join(stopped), run.join(stopped)).unwrap();
    let (status, told) = veridem(place.path(), &["resume", "run/run"]);
    let named = told.contains("stopped.checkpoint: belongs to another run than manifest.json: ")
        && told.contains("patch-hcp.yaml differs");
    assert_eq!((status, named), (65, true), "{told}");
}

#[test]
fn a_sample_is_saved_once_and_only_where_nothing_is() {
    let place = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(case("junction")).unwrap();
    let text = text.replace("    diameter: 3 nm\n", "    diameter: 3 nm\n    save: SAVED\n");
    let run = |path: &str| {
        let case = write(place.path().join("saving.yaml"), &text.replace("SAVED", path)).display().to_string();
        veridem(place.path(), &["--quiet", "run", &case, "--name", "s", "--force", STOP, "0"])
    };
    for path in ["saving.yaml", "run/s/series.csv"] {
        assert_eq!(run(path).0, 65, "{path}");
    }
    write(place.path().join("sample.bin"), "mine");
    let case = write(place.path().join("saving.yaml"), &text.replace("SAVED", "sample.bin")).display().to_string();
    let (status, told) = veridem(place.path(), &["--quiet", "run", &case, STOP, "0"]);
    assert_eq!((status, told.contains("use --force to replace it")), (65, true), "{told}");
    let (status, told) = veridem(place.path(), &["--quiet", "sweep", &case, "seed=1..2"]);
    assert_eq!((status, told.contains("save to the same file")), (2, true), "{told}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_or_closed_output_never_ends_a_run() {
    let place = tempfile::tempdir().unwrap();
    let shell = |line: &str| {
        let line = line.replace("VERIDEM", env!("CARGO_BIN_EXE_veridem")).replace("CASE", &case("patch-hcp"));
        Command::new("sh").current_dir(place.path()).args(["-c", &line]).stderr(Stdio::null()).status().unwrap().code()
    };
    for (line, expected) in [
        ("VERIDEM --help > /dev/full", 74),
        ("VERIDEM --version > /dev/full", 74),
        ("VERIDEM run --help > /dev/full", 74),
        ("VERIDEM schema > /dev/full", 74),
        ("VERIDEM completions bash > /dev/full", 74),
        ("VERIDEM check CASE > /dev/full", 74),
        ("VERIDEM nonsense 2> /dev/full", 2),
        ("VERIDEM check nowhere.yaml 2>&-", 66),
        ("VERIDEM run CASE --name a 2> /dev/full", 0),
        ("VERIDEM run CASE --name b 2>&- >&-", 0),
        ("VERIDEM run CASE --name c > /dev/full", 74),
        ("{ VERIDEM schema; test $? = 0; } | true", 0),
    ] {
        assert_eq!(shell(line), Some(expected), "{line}");
    }
    let run = RunFolder::open(&place.path().join("run/c")).unwrap();
    assert_eq!(Manifest::read(&run).unwrap().status, Status::Finished);
}
