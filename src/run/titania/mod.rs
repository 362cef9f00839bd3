//! The stages of a case of the titania paper: tests of one contact, or an agglomerate stretched.

mod film;
mod pull;
mod stage;
mod watch;

pub use film::{Plan as Film, Spectrum};
pub use pull::Pull;
pub use watch::rolling_resistance;

use super::Study;
use crate::build::agglomerate::{agglomerate, extent};
use crate::build::pair::pair;
use crate::build::protocol::Progress;
use crate::case::{self, Agglomerate, Case, ContactTests, TitaniaTest, TwoParticles};
use crate::error::Error;
use crate::forces::Instructions;
use crate::output::{Cell, Finding};
use crate::simulation::{Integrator, Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::titania::Titania;
use crate::system::{Domain, Particles, System};
use stage::{Act, Stage};
use watch::Watch;

/// The plan of a case.
pub struct Plan {
    case: Case,
    titania: case::Titania,
    dt: f64,
    stages: Vec<Stage>,
}

/// How much farther than their range neighbours are listed, nm.
const SKIN: f64 = 1.0;

impl Plan {
    /// The plan of a case of the titania paper.
    pub fn of(case: &Case) -> Self {
        let (titania, test) = case.titania().expect(COMPLETE);
        let dt = test.dt().1.value;
        let stages = match test {
            TitaniaTest::Contact(TwoParticles { diameters: [first, second] }, tests) => {
                let ContactTests { approach, slide, roll, .. } = tests;
                let released = approach.as_ref().map(|test| Stage::approach(test, [first.value, second.value], dt));
                let slid = slide.as_ref().map(|test| Stage::dragging(test, first.value, false, dt));
                let rolled = roll.as_ref().map(|test| Stage::dragging(test, first.value, true, dt));
                released.into_iter().chain(slid.into_iter().flatten()).chain(rolled.into_iter().flatten()).collect()
            }
            TitaniaTest::Stretching(chain, test) => Stage::stretching(test, chain.particles as u32, dt).into(),
            TitaniaTest::Spectroscopy(..) => unreachable!("{OTHER}"),
        };
        Self { case: case.clone(), titania: titania.clone(), dt, stages }
    }

    /// Steps in a time, at least one.
    fn steps_in(&self, time: f64) -> u64 {
        ((time / self.dt).round() as u64).max(1)
    }

    /// The chain, in a box that it can be stretched in.
    fn chain(&self, chain: &Agglomerate, room: f64) -> System {
        let built = agglomerate(&chain.recipe(), self.case.seed).expect("a checked case has a chain of that length");
        let high: [f64; 3] = std::array::from_fn(|axis| extent(&built, axis)[1]);
        let margin = chain.largest.value;
        // Twice as deep as the chain: pictures show what lies behind the middle, and that is to be all of it.
        let sides = [high[0] + room + 2.0 * margin, high[1] + 2.0 * margin, 2.0 * (high[2] + 2.0 * margin)];
        let mut particles = Particles::default();
        for (x, d) in built {
            let ((radius, mass), tag) = (self.titania.particle(d), particles.len() as u32);
            particles.push(x + Vec3([margin; 3]), radius, mass, tag);
        }
        System::new(particles, Domain { sides, periodic: [false; 3] })
    }
}

impl Study for Plan {
    type Model = Titania;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name).collect()
    }

    fn initial(&self) -> Result<System, Error> {
        match self.case.titania().expect(COMPLETE).1 {
            TitaniaTest::Contact(TwoParticles { diameters: [first, second] }, _) => {
                Ok(pair(&self.titania, [first.value, second.value], 0, 0.0))
            }
            TitaniaTest::Stretching(chain, test) => Ok(self.chain(chain, test.distance.value)),
            TitaniaTest::Spectroscopy(..) => unreachable!("{OTHER}"),
        }
    }

    fn starts_from_sample(&self, _: usize) -> bool {
        false
    }

    fn keep_sample(&self, _: &System) -> Result<(), Error> {
        Ok(())
    }

    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        let stage = &self.stages[stage];
        let mut system = match stage.act {
            Act::Approach { diameters, from } => pair(&self.titania, diameters, 0, from),
            Act::Press { diameters, .. } => System { time: system.time, ..pair(&self.titania, diameters, 1, 0.0) },
            _ => system,
        };
        stage.drive(&mut system);
        system.step = 0;
        Ok(system)
    }

    fn model(&self, _: usize) -> Titania {
        self.titania.law()
    }

    fn settings(&self, stage: usize, _: &System) -> Settings {
        Settings {
            dt: self.dt,
            integrator: Integrator::HalfStep,
            far_every: 1,
            damping: self.stages[stage].damping,
            skin: SKIN,
            max_overlap: self.case.limits.overlap,
            relax_box: None,
            instructions: Instructions::best(),
        }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        ((self.stages[stage].duration / dt).round() as u64).max(1)
    }

    fn progress(&self, stage: usize, _: &Watch, simulation: &Simulation<Titania>) -> Progress {
        let last = self.steps(stage, simulation.settings().dt);
        if simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }

    fn end(&self, _: usize, simulation: Simulation<Titania>) -> Result<System, Error> {
        Ok(simulation.into_system_with_springs())
    }

    fn parts(&self, stage: usize) -> u64 {
        if matches!(self.stages[stage].act, Act::Pull { .. }) { 4 } else { 1 }
    }

    fn columns(&self) -> Vec<&'static str> {
        watch::COLUMNS.into()
    }

    fn watch(&self, _: usize, simulation: &Simulation<Titania>) -> Watch {
        Watch::begin(simulation)
    }

    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<Titania>) -> Vec<String> {
        watch.follow(&self.stages[stage].act, simulation)
    }

    fn look(&self, watch: &mut Watch, simulation: &Simulation<Titania>) -> Vec<Cell> {
        watch.look(simulation)
    }

    fn findings(&self, stage: usize, watch: &Watch, simulation: &Simulation<Titania>) -> Result<Vec<Finding>, Error> {
        Ok(watch.findings(&self.stages[stage].act, simulation))
    }
}

const OTHER: &str = "a film has a plan of its own";
const COMPLETE: &str = "a checked case of the titania paper is complete";
