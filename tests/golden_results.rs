//! Are results the same text as in `golden/results`, over all instruction sets and for one and two threads, and does time never go back?

mod common;

use common::instruction_sets;
use std::path::Path;
use veridem::interrupt::Interrupt;
use veridem::output::columns::TIME;
use veridem::output::{RunFolder, Series};
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
            let folder = RunFolder::open(&run).expect("a run folder");
            let times = Series::read(&folder).expect("a series").curve("", TIME, TIME);
            assert!(times.is_sorted_by(|a, b| a.0 <= b.0), "{case}: time goes back from one stage to the next");
            let results = std::fs::read_to_string(folder.results()).expect("results");
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
