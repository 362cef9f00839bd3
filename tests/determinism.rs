//! Do the bits depend on the case alone?

mod common;

use common::{crowd, instruction_sets, run, settings, sheared_crowd, wear};
use veridem::forces::Instructions;
use veridem::run::advance;
use veridem::simulation::Simulation;

const DT: f64 = 1e-5;

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let with = |instructions| {
        let settings = veridem::simulation::Settings { instructions, ..settings(DT) };
        run(sheared_crowd(1, 7), settings, 300).snapshot()
    };
    let baseline = with(Instructions::BASELINE);
    for instructions in instruction_sets() {
        assert!(with(instructions) == baseline, "{instructions:?} differs from the baseline");
    }
}

#[test]
fn every_number_of_threads_gives_the_same_bits() {
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| run(sheared_crowd(2, 9), settings(DT), 300).snapshot())
    };
    let alone = with(1);
    for threads in [2, 3, 5] {
        assert!(with(threads) == alone, "{threads} threads differ from one");
    }
}

#[test]
fn a_simulation_taken_up_from_a_snapshot_goes_on_with_the_same_bits() {
    let mut uninterrupted = run(sheared_crowd(3, 7), settings(DT), 0);
    let mut snapshots = Vec::new();
    for step in 0..400 {
        if step % 57 == 0 {
            snapshots.push(uninterrupted.snapshot());
        }
        advance(&mut uninterrupted, 1).expect("a stable step");
    }
    for (k, snapshot) in snapshots.into_iter().enumerate() {
        let mut resumed = Simulation::resume(wear(), settings(DT), snapshot).expect("a valid snapshot");
        advance(&mut resumed, (400 - k * 57) as u64).expect("a stable step");
        assert!(resumed.snapshot() == uninterrupted.snapshot(), "resumed at step {}", k * 57);
    }
}

#[test]
fn the_list_is_rebuilt_in_these_runs() {
    // The tests above would prove little if no neighbour list were ever rebuilt.
    let order = |steps| run(crowd(4, 7), settings(DT), steps).system().particles.id.clone();
    assert_ne!(order(0), order(400));
}
