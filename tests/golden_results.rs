//! Are results the same text as in `golden/results`, over all instruction sets and for one and two threads?

mod common;

use common::instruction_sets;
use std::path::Path;
use veridem::interrupt::Interrupt;
use veridem::papers::PAPERS;

/// Compares a case of `tests/cases/good` with its golden results.
fn results_are_golden(case: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let golden = root.join(format!("golden/results/{case}.yaml"));
    let golden = std::fs::read_to_string(&golden).unwrap_or_else(|error| panic!("{}: {error}", golden.display()));
    for instructions in instruction_sets() {
        for threads in [1, 2] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let place = tempfile::tempdir().expect("a folder");
            let run = place.path().join("run");
            pool.install(|| {
                let mut job = PAPERS.read(&root.join(format!("tests/cases/good/{case}.yaml"))).expect("a good case");
                job.instructions = Some(instructions);
                job.launch(&run, false, &Interrupt::default(), &mut |_| {}).map(drop).expect("a run to the end");
            });
            let results = std::fs::read_to_string(run.join("results.yaml")).expect("results");
            let what = format!("{case}, {instructions:?}, {threads} threads");
            for (line, (is, expected)) in results.lines().zip(golden.lines()).enumerate() {
                assert_eq!(is, expected, "{what}: line {}", line + 1);
            }
            assert_eq!(results, golden, "{what}");
        }
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
fn a_stretched_agglomerate_has_golden_results() {
    results_are_golden("titania-agglomerate");
}
