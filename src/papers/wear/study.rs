//! The stages of a case of the wear paper, and their initial particles.

use super::case::{Amorphous, Case, Experiment, Sample};
use super::columns::{self, columns_of};
use super::derived::{Scales, material, spheres};
use super::lammps;
use super::protocol::{Drive, Setup, Stage};
use super::stages;
use super::watch::Watch;
use crate::case::units::in_unit;
use crate::error::Error;
use crate::initial::lattice::hcp_cells;
use crate::initial::{Sizes, hcp, random_packing};
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::output::{Cell, Column, Finding, load_sample, save_sample};
use crate::run::{Progress, Study};
use crate::simulation::{Settings, Simulation};
use crate::spec::wear::{Interaction, Wear};
use crate::spec::{Contact, PairModel};
use crate::system::System;
use std::marker::PhantomData;

/// The stages of a case: those that prepare the sample, one after the other, then the tests, each of which starts from the sample.
pub struct Plan<M> {
    case: Case,
    scales: Scales,
    /// The stages that prepare the sample.
    preparation: usize,
    stages: Vec<Stage>,
    law: PhantomData<M>,
}

impl<M> Plan<M> {
    /// The plan of a case.
    pub fn of(case: &Case) -> Self {
        let (scales, material) = (Scales::of(case), material(case));
        let modulus = material.young_modulus.value;
        let preparation = match &case.sample {
            Sample::Amorphous(Amorphous { load: None, relaxation, .. }) => {
                stages::relaxation(relaxation, modulus, material.density.value).into()
            }
            _ => Vec::new(),
        };
        let experiments = match &case.experiment {
            Experiment::Junction(junction) => vec![stages::junction(junction, scales.d_0, modulus)],
            Experiment::Sliding(sliding) => vec![stages::sliding(sliding, scales.d_0, modulus)],
            Experiment::Patch(patch) => {
                let compression =
                    patch.compression.as_ref().map(|test| stages::compression(test, scales.walls, modulus));
                let tension = patch.tension.as_ref().map(|test| stages::tension(test, scales.walls));
                let shear = patch.shear.as_ref().map(|test| stages::shear(test, scales.walls));
                [compression, tension, shear].into_iter().flatten().collect()
            }
        };
        let stages = [preparation.as_slice(), &experiments].concat();
        Self { case: case.clone(), scales, preparation: preparation.len(), stages, law: PhantomData }
    }

    /// All parameters that determine a sample.
    fn origin(&self) -> String {
        let mut sample = self.case.sample.clone();
        if let Sample::Amorphous(amorphous) = &mut sample {
            (amorphous.save, amorphous.load) = (None, None);
        }
        serde_json::to_string(&(&self.case.model, &sample, self.case.seed)).expect("a case is plain data")
    }
}

impl<M: PairModel + From<Wear>> Study for Plan<M> {
    type Model = M;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name).collect()
    }

    fn starts_from_sample(&self, stage: usize) -> bool {
        stage >= self.preparation
    }

    fn expected_spheres(&self) -> f64 {
        spheres(&self.case)
    }

    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error> {
        let Scales { d_0, d_s, d_l, size, .. } = self.scales;
        let density = material(&self.case).density.value;
        match &self.case.sample {
            Sample::Hcp(_) => Ok(hcp(d_0, hcp_cells(d_0, size), density)),
            Sample::Amorphous(Amorphous { load: Some(path), .. }) => {
                load_sample(path, &self.origin(), "model, sample or seed")
            }
            Sample::Amorphous(amorphous) => random_packing(
                Sizes { d_0, d_s, d_l },
                size,
                amorphous.volume_fraction,
                density,
                self.case.seed,
                interrupt,
            ),
        }
    }

    fn keep_sample(&self, system: &System) -> Result<(), Error> {
        match &self.case.sample {
            Sample::Amorphous(Amorphous { save: Some(path), .. }) => save_sample(path, &self.origin(), system),
            _ => Ok(()),
        }
    }

    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        let system = self.stages[stage].set_up(system, &material(&self.case).spec());
        let is_empty = |wall: usize| !system.particles.wall.iter().any(|&number| number as usize == wall + 1);
        if (0..system.walls.len()).any(is_empty) {
            let key = match self.case.experiment {
                Experiment::Patch(_) => "experiment.patch.walls",
                Experiment::Junction(_) => "experiment.junction.walls",
                Experiment::Sliding(_) => "experiment.sliding.walls",
            };
            let what =
                format!("found {}, expected walls in which a sphere has its centre", in_unit(self.scales.walls, "nm"));
            return Err(Error::of_key(key, what));
        }
        Ok(system)
    }

    fn model(&self, stage: usize, _: &System) -> M {
        material(&self.case).law(self.stages[stage].interaction).into()
    }

    fn pair_style(&self, stage: usize) -> Result<String, String> {
        let material = material(&self.case);
        Ok(lammps::pair_style(&material.law(self.stages[stage].interaction), material.readings, material.springs))
    }

    fn settings(&self, stage: usize, system: &System) -> Settings {
        let stage = &self.stages[stage];
        // The overlap of random spheres has no limit until the repulsion has separated them.
        let pushed_apart = stage.interaction != Interaction::Repulsive;
        let max_overlap = if pushed_apart { self.case.limits.overlap } else { f64::INFINITY };
        stage.settings(system, &material(&self.case).spec(), max_overlap)
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        self.stages[stage].steps(dt)
    }

    fn progress(&self, stage: usize, watch: &Watch, simulation: &Simulation<M>) -> Progress {
        if watch.ended() { Progress::Done } else { self.stages[stage].progress(simulation) }
    }

    fn may_end_early(&self, stage: usize) -> bool {
        let stage = &self.stages[stage];
        // Tests in tension and in shear end with the failure of the sample.
        let fails = |setup: &Setup| matches!(setup, Setup::Walls { drive: Drive::Stretch(_) | Drive::Shear(_), .. });
        stage.may_end_early() || fails(&stage.setup)
    }

    fn end(&self, stage: usize, simulation: Simulation<M>) -> Result<System, Error> {
        Ok(self.stages[stage].end(simulation))
    }

    fn parts(&self, stage: usize) -> u64 {
        if matches!(self.stages[stage].setup, Setup::Junction(_) | Setup::Bodies(_)) { 3 } else { 1 }
    }

    fn columns(&self, stage: usize) -> Vec<Column> {
        columns_of(&self.stages[stage].setup)
    }

    fn windows(&self) -> Vec<Column> {
        match self.case.experiment {
            Experiment::Patch(_) => Vec::new(),
            Experiment::Junction(_) => columns::windows(),
            Experiment::Sliding(_) => columns::sliding_windows(),
        }
    }

    fn profiles(&self) -> Vec<Column> {
        if matches!(self.case.experiment, Experiment::Sliding(_)) { columns::PROFILE.into() } else { Vec::new() }
    }

    fn watch(&self, stage: usize, simulation: &Simulation<M>, _: &Interrupt) -> Result<Watch, Error> {
        Ok(Watch::begin(&self.stages[stage], &self.case, simulation))
    }

    fn follow(&self, _: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<String> {
        watch.follow(simulation);
        Vec::new()
    }

    fn can_hold(&self, stage: usize, system: &System, watch: &Watch) -> bool {
        let setup = &self.stages[stage].setup;
        let walls = if matches!(setup, Setup::None) { 0 } else { 2 };
        let has_spheres = |wall: u32| system.particles.wall.contains(&wall);
        system.walls.len() == walls && (1..=walls as u32).all(has_spheres) && watch.belongs_to(setup, system)
    }

    fn look(&self, _: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<Cell> {
        watch.look(simulation)
    }

    fn window(&self, watch: &Watch, _: &Simulation<M>) -> Option<Vec<Cell>> {
        watch.window()
    }

    fn profile(&self, watch: &Watch, _: &Simulation<M>) -> Vec<Vec<Cell>> {
        watch.profile()
    }

    /// Cohesion holds a contact together until it is broken.
    fn kind(&self, _: &Contact<f64>) -> Option<PairKind> {
        Some(PairKind::Contact)
    }

    fn flags(&self, watch: &Watch, simulation: &Simulation<M>) -> Vec<(&'static str, Vec<bool>)> {
        watch.flags(simulation.system())
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<M>,
        _: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        Ok(watch.findings(&self.stages[stage], &self.case, simulation))
    }
}
