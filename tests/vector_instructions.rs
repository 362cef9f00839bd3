//! Does every instruction set move small systems alike? This is all that the modules with `unsafe` do, in a few steps: `.ci/run` repeats it under
//! valgrind.

mod common;

use common::{instruction_sets, settings, sheared_crowd, soot, wear};
use veridem::forces::Instructions;
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation, Snapshot};
use veridem::spec::PairModel;
use veridem::system::System;

/// The state after some steps.
fn after<M: PairModel>(model: M, system: System, settings: Settings, steps: u64) -> Snapshot {
    let mut simulation = Simulation::new(model, system, settings).expect("a stable step");
    advance(&mut simulation, steps).expect("a stable step");
    simulation.snapshot()
}

fn alike(state: impl Fn(Instructions) -> Snapshot) {
    let baseline = state(Instructions::BASELINE);
    for instructions in instruction_sets() {
        assert!(state(instructions) == baseline, "{instructions:?} differs from the baseline");
    }
}

#[test]
fn every_instruction_set_moves_a_crowd_between_walls_alike() {
    alike(|instructions| after(wear(), sheared_crowd(1, 3), Settings { instructions, ..settings(1e-5) }, 5));
}

#[test]
fn every_instruction_set_moves_attracted_spheres_alike() {
    let settings = soot::settings(soot::DT);
    alike(|instructions| after(soot::law(), soot::system(soot::third), Settings { instructions, ..settings }, 3));
}
