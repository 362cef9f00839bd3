//! The stages of a case of the soot paper: an aggregate is deposited, indented, collapses under its coating.

mod stage;
pub mod watch;

use super::Study;
use crate::build::aggregate::necks::{keep_fraction, necks};
use crate::build::aggregate::{Method, Radii, Recipe, Sphere, aggregate, import};
use crate::build::protocol::Progress;
use crate::case::quantity::{Length, Quantity};
use crate::case::{Aggregate, Case, Deposition, Growth, Import, Soot, SootStage};
use crate::error::Error;
use crate::forces::Instructions;
use crate::observe::morphology::centre_of_mass;
use crate::output::{Cell, Finding, Kept, keep, kept};
use crate::simulation::{Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::soot;
use crate::spec::wear::def_sphere::sphere_mass;
use crate::system::{Domain, Halt, Particles, System};
use serde::{Deserialize, Serialize};
use stage::Ground;
use watch::Watch;

/// The plan of a case.
pub struct Plan {
    /// Seed of every random stream.
    pub seed: u64,
    /// Largest overlap allowed, as a part of the sum of the radii.
    pub max_overlap: f64,
    /// The interactions.
    pub soot: Soot,
    /// The aggregate.
    pub sample: Aggregate,
    /// What is done to it, one after the other.
    pub stages: Vec<SootStage>,
}

/// How much farther than their range neighbours are listed, in radii: spheres that collapse take tens of thousands of steps for this way.
const SKIN: f64 = 0.1;

/// Steps from one look at the strength of necks to the next: a small part of the period of their springs at any published time step.
pub const EXAMINED: u64 = 5;

impl Plan {
    /// The plan of a case of the soot paper.
    pub fn of(case: &Case) -> Self {
        let (soot, sample, stages) = case.soot().expect("a checked case of the soot paper is complete");
        let (soot, sample) = (soot.clone(), sample.clone());
        Self { seed: case.seed, max_overlap: case.limits.overlap, soot, sample, stages }
    }
}

/// A deposited aggregate on disk, with what it was made from.
#[derive(Serialize, Deserialize)]
struct Deposited {
    origin: String,
    system: System,
}

impl Plan {
    /// What a deposited aggregate must agree in. Not the seed: another one indents the same aggregate elsewhere.
    fn origin(&self) -> String {
        let sample = Aggregate { deposited: None, ..self.sample.clone() };
        serde_json::to_string(&(&self.soot, &sample)).expect("a case is plain data")
    }

    /// The spheres of the sample, about their centre of mass.
    fn spheres(&self) -> Result<Vec<Sphere>, Error> {
        let sample = &self.sample;
        if let Some(Import { file, unit, radius, disconnected }) = &sample.import {
            let length = |quantity: &Option<Quantity<Length>>| quantity.as_ref().map(|length| length.value);
            let (unit, radius, disconnected) = (length(unit), length(radius), *disconnected);
            let options = import::Options { format: None, unit, radius, disconnected };
            return Ok(centred(import::read(file, &options)?.spheres));
        }
        let median = sample.radius.value;
        let recipe = Recipe {
            number: sample.spheres as usize,
            d_f: sample.fractal_dimension,
            k_f: sample.prefactor,
            radii: if sample.deviation == 1.0 {
                Radii::Equal(median)
            } else {
                Radii::LogNormal { median, deviation: sample.deviation }
            },
            method: match sample.growth {
                Growth::Clusters => Method::Clusters,
                Growth::Spheres => Method::Spheres,
            },
        };
        aggregate(&recipe, self.seed).map_err(|failure| Error::Usage(failure.to_string()))
    }
}

/// The same spheres with their centre of mass at the origin.
fn centred(mut spheres: Vec<Sphere>) -> Vec<Sphere> {
    let centre = centre_of_mass(&spheres);
    for sphere in &mut spheres {
        sphere.centre = sphere.centre - centre;
    }
    spheres
}

impl Study for Plan {
    type Model = soot::Soot;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(SootStage::name).collect()
    }

    fn initial(&self) -> Result<System, Error> {
        // Files that a later stage needs are looked at before anything is computed.
        self.stages.iter().try_for_each(|stage| stage::solid(stage).map(drop))?;
        if let Some(path) = &self.sample.deposited {
            let Deposited { origin, system } = kept(path, Kept::Sample)?;
            if origin != self.origin() {
                return Err(Error::input(path, "was made with another model or aggregate"));
            }
            return Ok(system);
        }
        let spheres = self.spheres()?;
        let joined = necks(&spheres, self.sample.neck_distance.value, true);
        let kept = keep_fraction(&joined, self.sample.neck_fraction, self.seed);
        let mut particles = Particles::default();
        let reach = spheres.iter().map(|sphere| sphere.centre.norm() + sphere.radius).fold(0.0, f64::max);
        for &Sphere { centre, radius } in &spheres {
            particles.push(centre + Vec3([reach; 3]), radius, sphere_mass(self.soot.density.value, radius), 0);
        }
        let domain = Domain { sides: [2.0 * reach; 3], periodic: [false; 3] };
        let necks = kept.into_iter().map(|(i, j)| (i as u32, j as u32)).collect();
        Ok(System { necks, ..System::new(particles, domain) })
    }

    fn starts_from_sample(&self, _: usize) -> bool {
        false
    }

    fn keep_sample(&self, _: &System) -> Result<(), Error> {
        Ok(())
    }

    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        let ground = Ground { seed: self.seed, radius: self.sample.radius.value };
        stage::set_up(&self.stages[stage], &ground, system)
    }

    /// The coating acts only in a restructuring.
    fn model(&self, stage: usize) -> soot::Soot {
        let mut law = self.soot.law();
        if !matches!(self.stages[stage], SootStage::Restructuring(_)) {
            law.attraction.psi = 0.0;
        }
        law
    }

    fn settings(&self, stage: usize, _: &System) -> Settings {
        Settings {
            dt: self.stages[stage].dt().value,
            integrator: self.stages[stage].integrator().engine(),
            far_every: self.stages[stage].attraction_every(),
            damping: 0.0,
            skin: SKIN * self.sample.radius.value,
            max_overlap: self.max_overlap,
            relax_box: None,
            instructions: Instructions::best(),
        }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        (self.stages[stage].duration().value(dt) / dt).round() as u64
    }

    fn progress(&self, stage: usize, _: &Watch, simulation: &Simulation<soot::Soot>) -> Progress {
        let last = self.steps(stage, simulation.settings().dt);
        if simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }

    /// The next stage goes on from here, with the springs of all contacts.
    fn end(&self, stage: usize, simulation: Simulation<soot::Soot>) -> Result<System, Error> {
        let system = simulation.into_system_with_springs();
        if let SootStage::Deposition(Deposition { save: Some(path), .. }) = &self.stages[stage] {
            keep(path, Kept::Sample, &Deposited { origin: self.origin(), system: system.clone() })?;
        }
        Ok(system)
    }

    fn parts(&self, stage: usize) -> u64 {
        if matches!(self.stages[stage], SootStage::Indentation(_)) { 4 } else { 2 }
    }

    fn columns(&self) -> Vec<&'static str> {
        watch::COLUMNS.into()
    }

    fn watch(&self, stage: usize, simulation: &Simulation<soot::Soot>) -> Watch {
        Watch::begin(&self.stages[stage], simulation)
    }

    fn intervene(&self, _: usize, simulation: &mut Simulation<soot::Soot>) -> Result<Vec<String>, Halt> {
        let Some(strength) = &self.soot.break_energy else { return Ok(Vec::new()) };
        if !simulation.system().step.is_multiple_of(EXAMINED) {
            return Ok(Vec::new());
        }
        let broken = simulation
            .break_necks(|held| held.normal + held.tangential + held.rolling + held.torsion > strength.value)?;
        Ok(broken.iter().map(|(i, j)| format!("the neck of {i} and {j} breaks")).collect())
    }

    fn follow(&self, _: usize, watch: &mut Watch, simulation: &Simulation<soot::Soot>) -> Vec<String> {
        watch.follow(simulation);
        Vec::new()
    }

    fn look(&self, watch: &mut Watch, simulation: &Simulation<soot::Soot>) -> Vec<Cell> {
        watch.look(simulation)
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<soot::Soot>,
    ) -> Result<Vec<Finding>, Error> {
        let mut findings = watch.findings(&self.stages[stage], simulation);
        if self.stages.len() > 1 {
            let name = self.stages[stage].name();
            let before = self.stages[..stage].iter().filter(|other| other.name() == name).count();
            let of_stage = if before == 0 { name.to_string() } else { format!("{name} {}", before + 1) };
            findings.iter_mut().for_each(|finding| finding.name = format!("{of_stage}: {}", finding.name));
        }
        Ok(findings)
    }
}
