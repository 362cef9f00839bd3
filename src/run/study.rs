//! The interface between the driver and a study.

use crate::error::{Error, Halt};
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::output::{Cell, Column, Finding};
use crate::simulation::{Settings, Simulation};
use crate::spec::{Contact, PairModel};
use crate::system::System;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The state of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// It has not ended.
    Going,
    /// It has ended.
    Done,
    /// It has exceeded its largest number of steps, for this reason.
    Failed(&'static str),
}

/// An experiment as a sequence of stages, each with its model, settings and observer. Stages are numbered from zero.
pub trait Study {
    /// The contact model.
    type Model: PairModel;
    /// The state of an observer.
    type Watch: Clone + Serialize + DeserializeOwned;

    /// The names of the stages.
    fn stages(&self) -> Vec<&'static str>;
    /// The names of the stages, with a number appended to repeated names.
    fn names(&self) -> Vec<String> {
        let stages = self.stages();
        let before = |at: usize| stages[..at].iter().filter(|&name| *name == stages[at]).count();
        let name = |at| if before(at) == 0 { stages[at].into() } else { format!("{} {}", stages[at], before(at) + 1) };
        (0..stages.len()).map(name).collect()
    }
    /// Approximate number of spheres, before they are placed; zero if it is small or not known.
    fn expected_spheres(&self) -> f64 {
        0.0
    }
    /// The files read by the stages after this one.
    fn reads_after(&self, _stage: usize) -> Vec<PathBuf> {
        Vec::new()
    }
    /// The initial particles. Long computations poll `interrupt`.
    ///
    /// # Errors
    ///
    /// If the sample cannot be built or read, or an interruption.
    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error>;
    /// Whether a stage starts from the sample rather than from the end of the preceding stage.
    fn starts_from_sample(&self, _stage: usize) -> bool {
        false
    }
    /// Saves the sample, if requested.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    fn keep_sample(&self, _system: &System) -> Result<(), Error> {
        Ok(())
    }
    /// Sets up the system for a stage.
    ///
    /// # Errors
    ///
    /// If the stage cannot be set up from this state.
    fn set_up(&self, _stage: usize, system: System) -> Result<System, Error> {
        Ok(system)
    }
    /// The model of a stage, for the spheres of this system.
    fn model(&self, stage: usize, system: &System) -> Self::Model;
    /// The model of a stage as a pair style of LAMMPS with the plugin of `bindings/lammps`.
    ///
    /// # Errors
    ///
    /// Why there is none, in words.
    fn pair_style(&self, _stage: usize) -> Result<String, String> {
        Err("has a contact model that the plugin for LAMMPS does not have".into())
    }
    /// The settings of the simulation of a stage.
    fn settings(&self, stage: usize, system: &System) -> Settings;
    /// The largest number of steps of a stage.
    fn steps(&self, stage: usize, dt: f64) -> u64;
    /// Whether a stage has ended: by default at its largest number of steps.
    fn progress(&self, stage: usize, _watch: &Self::Watch, simulation: &Simulation<Self::Model>) -> Progress {
        let last = self.steps(stage, simulation.settings().dt);
        if simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }
    /// Whether a stage may end before its largest number of steps, so that its remaining time is only bounded: never by default, as by default [`progress`](Self::progress) does not.
    fn may_end_early(&self, _stage: usize) -> bool {
        false
    }
    /// The system at the end of a stage, with the springs of all contacts.
    ///
    /// # Errors
    ///
    /// If a file that the stage saves cannot be written.
    fn end(&self, _stage: usize, simulation: Simulation<Self::Model>) -> Result<System, Error> {
        Ok(simulation.into_system_with_springs())
    }
    /// Number of equal parts of a stage between pictures.
    fn parts(&self, _stage: usize) -> u64 {
        1
    }
    /// The axis that points upwards in pictures, the second or the third.
    fn upwards(&self) -> usize {
        1
    }

    /// The columns that the observer of a stage adds to the series.
    fn columns(&self, _stage: usize) -> Vec<Column> {
        Vec::new()
    }
    /// The columns of the table of windows, the same in all stages that have any.
    fn windows(&self) -> Vec<Column> {
        Vec::new()
    }
    /// The columns of the table of profiles, which has a row for every layer of a system, the same in all stages that have any.
    fn profiles(&self) -> Vec<Column> {
        Vec::new()
    }
    /// Starts observing a stage. Long computations poll `interrupt`.
    ///
    /// # Errors
    ///
    /// An interruption.
    fn watch(
        &self,
        stage: usize,
        simulation: &Simulation<Self::Model>,
        interrupt: &Interrupt,
    ) -> Result<Self::Watch, Error>;
    /// Whether a stage can be under way with this system, whose numbers and indices are sound, and this observer, as a checkpoint claims: whether
    /// both have the parts that the stage takes for granted.
    fn can_hold(&self, _stage: usize, _system: &System, _watch: &Self::Watch) -> bool {
        true
    }
    /// Interventions between two steps, such as the breaking of necks; returns the events.
    ///
    /// # Errors
    ///
    /// If the simulation leaves its domain.
    fn intervene(
        &self,
        _stage: usize,
        _watch: &Self::Watch,
        _simulation: &mut Simulation<Self::Model>,
    ) -> Result<Vec<String>, Halt> {
        Ok(Vec::new())
    }
    /// Observes a step and returns its events.
    fn follow(&self, _stage: usize, _watch: &mut Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<String> {
        Vec::new()
    }
    /// Measures a row: the cells of the columns of the stage.
    fn look(&self, _stage: usize, _watch: &mut Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<Cell> {
        Vec::new()
    }
    /// The kind of a pair that no neck joins, if it is one that frames list.
    fn kind(&self, contact: &Contact<f64>) -> Option<PairKind> {
        (contact.gap <= 0.0).then_some(PairKind::Contact)
    }
    /// Further columns of frames: names and flags of spheres, by place.
    fn flags(&self, _watch: &Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<(&'static str, Vec<bool>)> {
        Vec::new()
    }
    /// The strengths of necks for frames, by ids, if necks have strengths of their own.
    fn strengths<'a>(&self, _watch: &'a Self::Watch) -> Option<&'a BTreeMap<(u32, u32), f64>> {
        None
    }
    /// The cells of a window that has closed in this step, such as means over its steps.
    fn window(&self, _watch: &Self::Watch, _simulation: &Simulation<Self::Model>) -> Option<Vec<Cell>> {
        None
    }
    /// The cells of the layers of a profile that is due after this step.
    fn profile(&self, _watch: &Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<Vec<Cell>> {
        Vec::new()
    }
    /// The findings of a stage. Long computations poll `interrupt`.
    ///
    /// # Errors
    ///
    /// If a result cannot be computed, or an interruption.
    fn findings(
        &self,
        _stage: usize,
        _watch: &Self::Watch,
        _simulation: &Simulation<Self::Model>,
        _interrupt: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        Ok(Vec::new())
    }
}
