//! The stages that a case asks for, and the particles they begin with.

use crate::build::protocol::Stage;
use crate::build::{Sizes, hcp, lattice::hcp_cells, random_packing, stages};
use crate::case::{Amorphous, Case, Experiment, Sample, Scales};
use crate::error::Error;
use crate::output::{Kept, keep, kept};
use crate::system::System;
use serde::{Deserialize, Serialize};

/// The stages of a case: those that make the sample, one after another, then those that each start from the sample.
pub struct Plan {
    case: Case,
    scales: Scales,
    preparation: Vec<Stage>,
    experiments: Vec<Stage>,
}

/// An equilibrated sample on disk, with what it was made from.
#[derive(Serialize, Deserialize)]
struct Equilibrated {
    origin: String,
    system: System,
}

impl Plan {
    /// The plan of a case.
    pub fn of(case: &Case) -> Self {
        let (scales, material) = (Scales::of(case), case.material());
        let modulus = material.young_modulus.value;
        let preparation = match &case.sample {
            Sample::Amorphous(Amorphous { load: None, relaxation, .. }) => {
                stages::relaxation(relaxation, modulus, material.density.value).into()
            }
            _ => Vec::new(),
        };
        let experiments = match &case.experiment {
            Experiment::Junction(junction) => vec![stages::junction(junction, scales.d_0, modulus)],
            Experiment::Patch(patch) => {
                let compression =
                    patch.compression.as_ref().map(|test| stages::compression(test, scales.walls, modulus));
                let tension = patch.tension.as_ref().map(|test| stages::tension(test, scales.walls));
                let shear = patch.shear.as_ref().map(|test| stages::shear(test, scales.walls));
                [compression, tension, shear].into_iter().flatten().collect()
            }
        };
        Self { case: case.clone(), scales, preparation, experiments }
    }

    /// All stages in order.
    pub fn stages(&self) -> impl Iterator<Item = &Stage> {
        self.preparation.iter().chain(&self.experiments)
    }

    /// True for a stage that starts from the sample, false for one that makes it.
    pub fn starts_from_sample(&self, stage: usize) -> bool {
        stage >= self.preparation.len()
    }

    /// The particles before the first stage.
    pub fn initial(&self) -> Result<System, Error> {
        let Scales { d_0, d_s, d_l, size, .. } = self.scales;
        let density = self.case.material().density.value;
        match &self.case.sample {
            Sample::Hcp(_) => Ok(hcp(d_0, hcp_cells(d_0, size), density)),
            Sample::Amorphous(Amorphous { load: Some(path), .. }) => {
                let Equilibrated { origin, system } = kept(path, Kept::Sample)?;
                if origin != self.origin() {
                    return Err(Error::input(path, "was made with another model, sample or seed"));
                }
                Ok(system)
            }
            Sample::Amorphous(amorphous) => {
                Ok(random_packing(Sizes { d_0, d_s, d_l }, size, amorphous.volume_fraction, density, self.case.seed))
            }
        }
    }

    /// Keeps the sample, if the case wants it.
    pub fn keep_sample(&self, system: &System) -> Result<(), Error> {
        match &self.case.sample {
            Sample::Amorphous(Amorphous { save: Some(path), .. }) => {
                keep(path, Kept::Sample, &Equilibrated { origin: self.origin(), system: system.clone() })
            }
            _ => Ok(()),
        }
    }

    /// Everything that a sample depends on.
    fn origin(&self) -> String {
        let mut sample = self.case.sample.clone();
        if let Sample::Amorphous(amorphous) = &mut sample {
            (amorphous.save, amorphous.load) = (None, None);
        }
        serde_json::to_string(&(&self.case.model, &sample, self.case.seed)).expect("a case is plain data")
    }
}
