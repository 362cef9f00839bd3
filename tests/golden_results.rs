//! Are results, tables and final states those of `golden/results`, over all instruction sets and for one and two threads, and does time never go back?

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

/// Compares the hash of the final state, the checksums of tables and events, and where the spheres are in the last frame, with a golden file.
fn state_is_golden(golden: &Path, folder: &RunFolder, what: &str) {
    let (manifest, series) = (Manifest::read(folder).expect("a manifest"), Series::read(folder).expect("a series"));
    let frames = ReadFrame::all(folder, &series.stages()).expect("frames");
    let last = frames.last().expect("a last frame");
    let frame = ReadFrame::read(last).expect("a frame");
    let mut state = format!("{}\n", manifest.final_state.expect("a state at the end"));
    for file in folder.tables().expect("tables").iter().chain([&folder.events(), last]) {
        let name = file.file_name().expect("a name").display();
        state += &format!("{name}: {:08x}\n", crc32fast::hash(&std::fs::read(file).expect("a file")));
    }
    frame.centres().for_each(|[x, y, z]| state += &format!("{x} {y} {z}\n"));
    let expected = std::fs::read_to_string(golden).unwrap_or_default();
    if state != expected {
        let new = Path::new(env!("CARGO_TARGET_TMPDIR")).join(golden.file_name().expect("a name"));
        std::fs::write(&new, &state).expect("the state is written");
        let numbers = |text: &str| -> Vec<f64> {
            let coordinates = text.lines().filter(|line| line.contains(' ') && !line.contains(':'));
            coordinates.flat_map(|line| line.split(' ')).map(|word| word.parse().expect("a number")).collect()
        };
        let (is, was) = (numbers(&state), numbers(&expected));
        let apart = is.iter().zip(&was).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let other: Vec<&str> = state.lines().filter(|line| line.contains(':') && !expected.contains(*line)).collect();
        panic!(
            "{what}: {} coordinates instead of {}, at most {apart:e} nm apart, other files: {other:?}; the new state is {}",
            is.len(),
            was.len(),
            new.display()
        );
    }
}

/// Compares a case with its golden results in one run.
fn results_of_one_run_are_golden(case: &str) {
    results_are_golden_with(case, &[Instructions::best()], &[2]);
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
    results_of_one_run_are_golden("titania-film");
}

#[test]
fn a_stretched_agglomerate_has_golden_results() {
    results_are_golden("titania-agglomerate");
}

#[test]
fn patch_tests_of_a_lattice_have_golden_results() {
    results_of_one_run_are_golden("patch-hcp");
}

#[test]
fn bodies_that_slide_over_each_other_have_golden_results() {
    results_of_one_run_are_golden("sliding");
}

#[test]
fn soot_on_a_substrate_has_golden_results() {
    results_of_one_run_are_golden("soot-on-substrate");
}

#[test]
fn particles_along_a_path_have_golden_results() {
    results_of_one_run_are_golden("titania-path");
}

#[test]
fn an_agglomerate_that_is_held_and_pulled_has_golden_results() {
    results_of_one_run_are_golden("titania-held");
}

#[test]
fn a_pair_that_is_pulled_and_a_particle_that_slides_and_rolls_have_golden_results() {
    results_of_one_run_are_golden("titania-pair");
}

#[test]
fn every_reading_of_titania_has_golden_results() {
    results_of_one_run_are_golden("titania-readings");
}

#[test]
fn necks_of_different_strengths_have_golden_results() {
    results_of_one_run_are_golden("soot-neck-strengths");
}
