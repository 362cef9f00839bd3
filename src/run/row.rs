//! What every row of the series holds, whatever the stage.

use super::Study;
use crate::output::Cell;
use crate::simulation::Simulation;
use crate::spec::{Named, PairModel};

const COLUMNS: [&str; 15] = [
    "lost to drag [zJ]",
    "lost to breaking [zJ]",
    "work of walls [zJ]",
    "work of loads [zJ]",
    "work of box [zJ]",
    "discrete residual [zJ]",
    "physical residual [zJ]",
    "relative residual",
    "largest overlap",
    "stress xx [MPa]",
    "stress yy [MPa]",
    "stress zz [MPa]",
    "side x [nm]",
    "side y [nm]",
    "side z [nm]",
];

/// The columns of the series.
pub fn columns<S: Study>(study: &S) -> Vec<String> {
    let stored = <S::Model as PairModel>::Stored::<f64>::names().into_iter();
    let stored = stored.map(|cause| format!("{cause} energy [zJ]"));
    let lost = <S::Model as PairModel>::Losses::<f64>::names().into_iter().map(|cause| format!("lost to {cause} [zJ]"));
    let first = ["stage", "step", "time [ns]", "kinetic energy [zJ]"].into_iter().map(String::from);
    let last = COLUMNS.into_iter().chain(study.columns()).map(String::from);
    first.chain(stored).chain(lost).chain(last).collect()
}

/// A row, and what of it those who wait want to see: the relative residual of the ledger and the largest overlap.
pub fn measure<S: Study>(
    study: &S,
    stage: &str,
    simulation: &Simulation<S::Model>,
    watch: &mut S::Watch,
) -> (Vec<Cell>, (f64, f64)) {
    let (system, ledger) = (simulation.system(), simulation.ledger());
    let residual = ledger.physical_residual() / ledger.turnover().max(f64::MIN_POSITIVE);
    let overlap = simulation.largest_overlap().map_or(0.0, |(_, ratio)| ratio);
    let energies =
        [system.time, ledger.kinetic].into_iter().chain(ledger.stored.clone()).chain(ledger.lost_by_pairs.clone());
    let accounts = [
        ledger.lost_drag,
        ledger.lost_to_breaking,
        ledger.work_walls,
        ledger.work_loads,
        ledger.work_box,
        ledger.discrete_residual(),
        ledger.physical_residual(),
        residual,
        overlap,
    ];
    let numbers = energies.chain(accounts).chain(simulation.stress()).chain(system.domain.sides);
    let mut cells = vec![Cell::Name(stage.into()), Cell::Count(system.step)];
    cells.extend(numbers.map(Cell::Number));
    cells.extend(study.look(watch, simulation));
    (cells, (residual, overlap))
}
