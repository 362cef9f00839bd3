//! Are results and final states those of `golden/results`, over all instruction sets and for one and two threads, and does time never go back?

mod common;

use common::instruction_sets;
use std::path::Path;
use veridem::forces::Instructions;
use veridem::interrupt::Interrupt;
use veridem::output::columns::TIME;
use veridem::output::{Manifest, ReadFrame, RunFolder, Series};
use veridem::papers::PAPERS;

/// Compares a case of `tests/cases/good` with its golden results.
fn results_are_golden(case: &str) {
    results_are_golden_with(case, &instruction_sets(), &[1, 2]);
}

fn results_are_golden_with(case: &str, sets: &[Instructions], threads: &[usize]) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let golden = root.join(format!("golden/results/{case}.yaml"));
    let golden = std::fs::read_to_string(&golden).unwrap_or_else(|error| panic!("{}: {error}", golden.display()));
    for &instructions in sets {
        for &threads in threads {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let place = tempfile::tempdir().expect("a folder");
            let run = place.path().join("run");
            pool.install(|| {
                let mut job = PAPERS.read(&root.join(format!("tests/cases/good/{case}.yaml"))).expect("a good case");
                job.instructions = Some(instructions);
                job.launch(&run, false, &Interrupt::default(), &mut |_| {}).map(drop).expect("a run to the end");
            });
            let folder = RunFolder::open(&run).expect("a run folder");
            let times = Series::read(&folder).expect("a series").curve("", TIME, TIME);
            assert!(times.is_sorted_by(|a, b| a.0 <= b.0), "{case}: time goes back from one stage to the next");
            let results = std::fs::read_to_string(folder.results()).expect("results");
            let what = format!("{case}, {instructions:?}, {threads} threads");
            for (line, (is, expected)) in results.lines().zip(golden.lines()).enumerate() {
                assert_eq!(is, expected, "{what}: line {}", line + 1);
            }
            assert_eq!(results, golden, "{what}");
            state_is_golden(&root.join(format!("golden/results/{case}.state")), &folder, &what);
        }
    }
}

/// Compares the hash of the final state, and where the spheres are in the last frame, with a golden file.
fn state_is_golden(golden: &Path, folder: &RunFolder, what: &str) {
    let (manifest, series) = (Manifest::read(folder).expect("a manifest"), Series::read(folder).expect("a series"));
    let frames = ReadFrame::all(folder, &series.stages()).expect("frames");
    let frame = ReadFrame::read(frames.last().expect("a last frame")).expect("a frame");
    let mut state = format!("{}\n", manifest.final_state.expect("a state at the end"));
    frame.centres().for_each(|[x, y, z]| state += &format!("{x} {y} {z}\n"));
    let expected = std::fs::read_to_string(golden).unwrap_or_default();
    if state != expected {
        let new = Path::new(env!("CARGO_TARGET_TMPDIR")).join(golden.file_name().expect("a name"));
        std::fs::write(&new, &state).expect("the state is written");
        let numbers = |text: &str| -> Vec<f64> {
            text.lines().skip(1).flat_map(|line| line.split(' ')).map(|word| word.parse().expect("a number")).collect()
        };
        let (is, was) = (numbers(&state), numbers(&expected));
        let apart = is.iter().zip(&was).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        panic!(
            "{what}: {} coordinates instead of {}, at most {apart:e} nm apart; the new state is {}",
            is.len(),
            was.len(),
            new.display()
        );
    }
}

#[test]
fn a_junction_has_golden_results() {
    results_are_golden("junction");
}

#[test]
fn soot_that_is_deposited_indented_and_restructured_has_golden_results() {
    results_are_golden("soot-short");
}

#[test]
fn a_film_that_a_tip_touches_has_golden_results() {
    results_are_golden_with("titania-film", &[Instructions::best()], &[2]);
}

#[test]
fn a_stretched_agglomerate_has_golden_results() {
    results_are_golden("titania-agglomerate");
}
