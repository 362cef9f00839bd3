//! Are the files of a run the same, byte for byte, whatever the threads, the instructions, the stops and the surroundings, and its results whatever its
//! output intervals?
//!
//! Every shipped case in small, and a few random variations of them, in surroundings drawn at random. `VERIDEM_TRIALS` multiplies the number of draws
//! and of variations; `VERIDEM_SEED` seeds them.

mod cases;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/trials.rs"]
mod trials;

use cases::Small;
use common::{instruction_sets, uniform};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use trials::setting;
use veridem::output::RunFolder;

/// How often a run is stopped at most.
const STOPS: usize = 2;

/// Number of variations, times `VERIDEM_TRIALS`.
const VARIATIONS: u64 = 6;

/// Output intervals other than those of the reduced cases.
const OTHER_OUTPUT: [&str; 3] = [
    "{series: 7 steps, frames: 1 s, checkpoints: 1 s}",
    "{series: 1 s, frames: 90 steps, checkpoints: 33 steps}",
    "{series: 111 steps, frames: 111 steps, checkpoints: 111 steps}",
];

fn veridem(surroundings: &[(&str, String)], arguments: &[String]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
    command.arg("--quiet").args(arguments).envs(surroundings.iter().map(|(name, value)| (*name, value)));
    command.output().expect("the program starts")
}

/// The files that hold results, by name.
fn results(root: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let all = RunFolder::at(root).outputs().expect("a run folder");
    let read = |path: PathBuf| {
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        (path.strip_prefix(root).expect("a file of the run").to_path_buf(), bytes)
    };
    all.into_iter().map(read).collect()
}

/// Number of steps of a finished run, over all its stages.
fn steps(root: &Path) -> u64 {
    let events = std::fs::read_to_string(root.join("events.jsonl")).expect("events");
    let events = events.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).expect("an event"));
    events.filter(|event| event["event"] == "end").map(|event| event["step"].as_u64().expect("a step")).sum()
}

fn told(output: &Output) -> String {
    format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr))
}

/// Compares some runs of a case with one on one thread, with the plainest instructions and in one go.
fn is_the_same(case: &Small, draws: u64, random: &mut ChaCha8Rng) {
    let place = tempfile::tempdir().expect("a folder");
    let file = place.path().join("case.yaml");
    std::fs::write(&file, &case.text).expect("a case");
    let run = |out: &Path, file: &Path, threads: u64, instructions: &str| -> Vec<String> {
        let (out, file, threads) = (out.display().to_string(), file.display().to_string(), threads.to_string());
        let arguments = ["run", &file, "--out", &out, "--name", "run", "--threads", &threads];
        [&arguments[..], &["--instructions", instructions]].concat().into_iter().map(String::from).collect()
    };
    let plain = place.path().join("plain");
    let baseline = veridem(&[], &run(&plain, &file, 1, "baseline"));
    // A variation may fail or halt, which it must do in the same way in all surroundings.
    let ended = baseline.status.code();
    assert!(matches!(ended, Some(0 | 4 | 5)), "{}: {}\n{}", case.name, told(&baseline), case.text);
    assert!(ended == Some(0) || case.name.ends_with("varied"), "{}: {}", case.name, told(&baseline));
    let expected = results(&plain.join("run"));
    let (sets, steps) = (instruction_sets(), steps(&plain.join("run")).max(1));
    let widest = sets[sets.len() - 1].name();
    for draw in 0..draws {
        let mut below = |n: u64| (uniform(random) * n as f64) as u64;
        let threads = [1, 2, 3, 4, 8][below(5) as usize];
        let set = sets[below(sets.len() as u64) as usize].name();
        let surroundings = [
            ("LC_ALL", ["C", "de_DE.UTF-8", "tr_TR.UTF-8"][below(3) as usize].to_string()),
            ("TZ", ["UTC", "Pacific/Chatham"][below(2) as usize].to_string()),
        ];
        let root = place.path().join(format!("other {draw} é"));
        // One draw in three has other output intervals.
        let output = OTHER_OUTPUT.get(below(9) as usize);
        let other = place.path().join("other.yaml");
        if let Some(output) = output {
            std::fs::write(&other, case.with_output(output).text).expect("a case");
        }
        let mut stops = vec![below(steps)];
        let mut arguments = run(&root, if output.is_some() { &other } else { &file }, threads, set);
        arguments.extend(["--stop-after-steps".into(), stops[0].to_string()]);
        let mut ran = veridem(&surroundings, &arguments);
        while ran.status.code() == Some(75) {
            let (root, threads) = (root.join("run").display().to_string(), (1 + below(4)).to_string());
            let resumed = ["resume", &root, "--threads", &threads, "--instructions", widest];
            let mut resumed = resumed.map(String::from).to_vec();
            // The last process goes on to the end.
            if stops.len() < STOPS {
                stops.push(1 + below(steps));
                resumed.extend(["--stop-after-steps".into(), stops[stops.len() - 1].to_string()]);
            }
            ran = veridem(&surroundings, &resumed);
        }
        let name = &case.name;
        let what =
            format!("{name}: {threads} threads, {set}, stopped after {stops:?} steps, {output:?}, {surroundings:?}");
        assert_eq!(ran.status.code(), ended, "{what}: {}\n{}", told(&ran), case.text);
        let mut found = results(&root.join("run"));
        let mut expected = expected.clone();
        if output.is_some() {
            for files in [&mut found, &mut expected] {
                files.retain(|file| file.0 == Path::new("results.yaml"));
            }
        }
        let names = |files: &[(PathBuf, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{what}");
        for ((file, found), (_, expected)) in found.iter().zip(&expected) {
            assert!(found == expected, "{what}: {} differs\n{}", file.display(), case.text);
        }
        std::fs::remove_dir_all(&root).expect("the folder is the test's");
    }
}

/// Compares cases side by side; reports all that differ.
fn are_the_same(cases: Vec<Small>, draws: u64) {
    let seed = setting("VERIDEM_SEED");
    let differs = |(number, case): (usize, &Small)| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number as u64);
        let compared = std::panic::catch_unwind(move || is_the_same(case, draws, &mut random));
        compared.err().map(|panic| panic.downcast_ref::<String>().cloned().unwrap_or_else(|| case.name.clone()))
    };
    let failures: Vec<String> = cases.par_iter().enumerate().filter_map(differs).collect();
    println!("{} cases, {draws} draws each, VERIDEM_SEED={seed}", cases.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn a_shipped_case_has_the_same_bits_in_all_surroundings() {
    let cases = Small::shipped();
    assert!(!cases.is_empty());
    are_the_same(cases, setting("VERIDEM_TRIALS"));
}

#[test]
fn a_variation_has_the_same_bits_in_all_surroundings() {
    let mut random = ChaCha8Rng::seed_from_u64(setting("VERIDEM_SEED"));
    let shipped = Small::shipped();
    let mut draw = || {
        let chosen = (uniform(&mut random) * shipped.len() as f64) as usize;
        shipped[chosen].varied(&mut random)
    };
    are_the_same((0..VARIATIONS * setting("VERIDEM_TRIALS")).map(|_| draw()).collect(), 1);
}

#[test]
fn instructions_that_the_processor_lacks_are_refused_by_name() {
    let refused = veridem(&[], &["schema".into(), "--instructions".into(), "avx9".into()]);
    let told = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2));
    assert!(told.starts_with("--instructions: this processor has no `avx9`, it has `baseline`"), "{told}");
}
