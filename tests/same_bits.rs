//! Are the files of a run the same, byte for byte, whatever the threads, the instructions, the stops and the surroundings?
//!
//! Every shipped kind of case in small, in a few surroundings drawn at random. `VERIDEM_SAME_BITS` is the number of draws per case, 1 unless
//! given; `VERIDEM_SEED` the seed of the draws.

mod common;

use common::{instruction_sets, uniform};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The reduced cases, each with the step before which it is stopped.
const CASES: [(&str, u64); 8] = [
    ("junction", 830),
    ("patch-hcp", 900),
    ("soot-short", 300),
    ("soot-sequence", 60),
    ("titania-agglomerate", 900),
    ("titania-film", 600),
    ("titania-film-necks", 600),
    ("titania-pair", 300),
];

/// How often a run is stopped at most.
const STOPS: usize = 2;

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}: no number")))
}

fn veridem(surroundings: &[(&str, String)], arguments: &[String]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_veridem"));
    command.arg("--quiet").args(arguments).envs(surroundings.iter().map(|(name, value)| (*name, value)));
    command.output().expect("the program starts")
}

/// The files that hold results, by name.
fn results(root: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let frames = std::fs::read_dir(root.join("frames")).expect("frames").map(|entry| entry.expect("a frame").path());
    let others = ["series.csv", "events.jsonl", "results.yaml", "case.resolved.yaml"].map(|name| root.join(name));
    let mut all: Vec<PathBuf> = frames.chain(others).collect();
    all.sort();
    let read = |path: PathBuf| {
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        (path.strip_prefix(root).expect("a file of the run").to_path_buf(), bytes)
    };
    all.into_iter().map(read).collect()
}

fn is_the_same(name: &str, steps: u64, draws: u64, random: &mut ChaCha8Rng) {
    let case = format!("{}/tests/cases/good/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().expect("a folder");
    let plain = place.path().join("plain");
    let run = |out: &Path, more: &[String]| -> Vec<String> {
        let out = out.display().to_string();
        let arguments = ["run", &case, "--out", &out, "--name", "run", "--threads", "1"].map(String::from);
        [&arguments[..], more].concat()
    };
    let baseline = veridem(&[], &run(&plain, &["--instructions".into(), "baseline".into()]));
    assert!(baseline.status.success(), "{name}: {}", String::from_utf8_lossy(&baseline.stderr));
    let expected = results(&plain.join("run"));
    let sets = instruction_sets();
    let mut below = |n: u64| (uniform(random) * n as f64) as u64;
    for draw in 0..draws {
        let threads = [1, 2, 3, 4, 8][below(5) as usize].to_string();
        let widest = sets[sets.len() - 1].name();
        let first = sets[below(sets.len() as u64) as usize].name().to_string();
        let surroundings = [
            ("LC_ALL", ["C", "de_DE.UTF-8", "tr_TR.UTF-8"][below(3) as usize].to_string()),
            ("TZ", ["UTC", "Pacific/Chatham"][below(2) as usize].to_string()),
        ];
        let root = place.path().join(format!("other {draw} é"));
        let mut stops = vec![below(steps)];
        let mut arguments = run(&root, &["--instructions".into(), first.clone()]);
        arguments[7] = threads.clone();
        arguments.extend(["--stop-after-steps".into(), stops[0].to_string()]);
        let mut output = veridem(&surroundings, &arguments);
        while output.status.code() == Some(75) {
            let (root, threads) = (root.join("run").display().to_string(), (1 + below(4)).to_string());
            let mut resumed =
                ["resume", &root, "--threads", &threads, "--instructions", widest].map(String::from).to_vec();
            // The third process goes on to the end, however long the case is.
            if stops.len() < STOPS {
                stops.push(1 + below(steps));
                resumed.extend(["--stop-after-steps".into(), stops[stops.len() - 1].to_string()]);
            }
            output = veridem(&surroundings, &resumed);
        }
        let what = format!("{name}: {threads} threads, {first}, stopped after {stops:?} steps, {surroundings:?}");
        assert!(output.status.success(), "{what}: {}", String::from_utf8_lossy(&output.stderr));
        let found = results(&root.join("run"));
        let names = |files: &[(PathBuf, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{what}");
        for ((file, found), (_, expected)) in found.iter().zip(&expected) {
            assert!(found == expected, "{what}: {} differs", file.display());
        }
        std::fs::remove_dir_all(&root).expect("the folder is the test's");
    }
}

#[test]
fn a_run_has_the_same_bits_in_all_surroundings() {
    let mut random = ChaCha8Rng::seed_from_u64(setting("VERIDEM_SEED", 1));
    for (name, steps) in CASES {
        is_the_same(name, steps, setting("VERIDEM_SAME_BITS", 1), &mut random);
    }
}

#[test]
fn instructions_that_the_processor_lacks_are_refused_by_name() {
    let refused = veridem(&[], &["schema".into(), "--instructions".into(), "avx9".into()]);
    let told = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2));
    assert!(told.starts_with("--instructions: this processor has no `avx9`, it has `baseline`"), "{told}");
}
