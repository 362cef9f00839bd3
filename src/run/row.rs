//! The tables of a run: a row of the series, and the files into which it goes.

use super::{RunningStage, Study};
use crate::error::Halt;
use crate::output::columns::{
    DISCRETE_RESIDUAL, KINETIC, LARGEST_OVERLAP, LOST_TO_BREAKING, LOST_TO_DRAG, PHYSICAL_RESIDUAL, RELATIVE_RESIDUAL,
    SIDES, STAGE, STEP, STRESS, TIME, WORK_OF_BOX, WORK_OF_LOADS, WORK_OF_WALLS, lost, stored,
};
use crate::output::{Cell, Column, Layout};
use crate::spec::{Named, PairModel};

/// The columns of the energy balance, between the energies of pairs and the stress.
const ACCOUNTS: [Column; 9] = [
    LOST_TO_DRAG,
    LOST_TO_BREAKING,
    WORK_OF_WALLS,
    WORK_OF_LOADS,
    WORK_OF_BOX,
    DISCRETE_RESIDUAL,
    PHYSICAL_RESIDUAL,
    RELATIVE_RESIDUAL,
    LARGEST_OVERLAP,
];

/// The headers of a row of a stage: those of every stage, and those of its observer.
pub fn columns<S: Study>(study: &S, stage: usize) -> Vec<String> {
    let held = <S::Model as PairModel>::Stored::<f64>::names().into_iter().map(|cause| stored(&cause));
    let gone = <S::Model as PairModel>::Losses::<f64>::names().into_iter().map(|cause| lost(&cause));
    let first = [STAGE, STEP, TIME, KINETIC].into_iter().map(|column| column.to_string());
    let own = study.columns(stage);
    let last = ACCOUNTS.into_iter().chain(STRESS).chain(SIDES).chain(own).map(|column| column.to_string());
    first.chain(held).chain(gone).chain(last).collect()
}

/// The files of the tables of a run, and their columns.
pub(super) fn layout<S: Study>(study: &S) -> Layout {
    let names = study.names();
    let stages = (0..names.len()).map(|stage| columns(study, stage)).collect();
    let headers = |columns: Vec<Column>| columns.iter().map(Column::to_string).collect();
    Layout::new(&names, stages, headers(study.windows()), headers(study.profiles()))
}

/// A row of the series, and its numbers that are shown as progress.
pub struct Row {
    /// The cells.
    pub cells: Vec<Cell>,
    /// Relative residual of the physical energy balance.
    pub residual: f64,
    /// Largest overlap, relative to the sum of the radii.
    pub overlap: f64,
}

impl<S: Study> RunningStage<'_, S> {
    /// Measures.
    ///
    /// # Errors
    ///
    /// The first quantity that is not finite.
    pub fn measure(&mut self) -> Result<Row, Halt> {
        let simulation = &self.simulation;
        let (system, ledger) = (simulation.system(), simulation.ledger());
        let residual = ledger.physical_residual() / ledger.turnover().max(f64::MIN_POSITIVE);
        let overlap = simulation.largest_overlap().map_or(0.0, |(_, ratio)| ratio);
        let energies =
            [system.time, ledger.kinetic].into_iter().chain(ledger.stored.clone()).chain(ledger.lost_by_pairs.clone());
        let accounts: [f64; ACCOUNTS.len()] = [
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
        let mut cells = vec![Cell::Name(self.name.clone()), Cell::Count(system.step)];
        cells.extend(numbers.map(Cell::Number));
        cells.extend(self.study.look(self.number, &mut self.watch, simulation));
        self.finite(&cells, || columns(self.study, self.number))?;
        Ok(Row { cells, residual, overlap })
    }

    /// The row of a window that has closed in this step.
    ///
    /// # Errors
    ///
    /// The first quantity that is not finite.
    pub fn window(&self) -> Result<Option<Vec<Cell>>, Halt> {
        let Some(own) = self.study.window(&self.watch, &self.simulation) else { return Ok(None) };
        self.placed(own, S::windows).map(Some)
    }

    /// The rows of a profile that is due after this step, one for each layer.
    ///
    /// # Errors
    ///
    /// The first quantity that is not finite.
    pub fn profile(&self) -> Result<Vec<Vec<Cell>>, Halt> {
        let rows = self.study.profile(&self.watch, &self.simulation);
        rows.into_iter().map(|own| self.placed(own, S::profiles)).collect()
    }

    /// A row with these cells behind stage, step and time.
    fn placed(&self, own: Vec<Cell>, columns: impl FnOnce(&S) -> Vec<Column>) -> Result<Vec<Cell>, Halt> {
        self.finite(&own, || columns(self.study).iter().map(Column::to_string).collect())?;
        let system = self.simulation.system();
        let place = [Cell::Name(self.name.clone()), Cell::Count(system.step), Cell::Number(system.time)];
        Ok(place.into_iter().chain(own).collect())
    }

    /// Refuses cells that are not finite, by their columns.
    fn finite(&self, cells: &[Cell], columns: impl FnOnce() -> Vec<String>) -> Result<(), Halt> {
        let wrong = cells.iter().position(|cell| matches!(cell, Cell::Number(number) if !number.is_finite()));
        wrong.map_or(Ok(()), |place| Err(self.simulation.not_a_number(&columns()[place])))
    }
}
