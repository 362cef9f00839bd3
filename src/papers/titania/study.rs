//! The stages of a case of the titania paper: tests of a single contact, or the stretching of an agglomerate.

use super::case::{self, Agglomerate, Case, ContactTests, TitaniaTest, TwoParticles, checked};
use super::chain::{agglomerate, extent};
use super::columns::{self, columns_of};
use super::pair::pair;
use super::stage::{Stage, StageAct};
use super::watch::Watch;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::output::{Cell, Column, Finding};
use crate::run::Study;
use crate::simulation::{Settings, Simulation};
use crate::spec::titania::Titania;
use crate::spec::{Contact, Vec3};
use crate::system::{Domain, Particles, System};

/// The plan of a case.
pub struct Plan {
    pub(super) titania: case::Titania,
    pub(super) dt: f64,
    pub(super) overlap: f64,
    /// The chain that is stretched, with the seed from which it grows and the space for its ends.
    pub(super) chain: Option<(Agglomerate, u64, f64)>,
    pub(super) stages: Vec<Stage>,
}

/// Skin of the neighbour list, nm.
const SKIN: f64 = 1.0;

impl Plan {
    /// The plan of a case of the titania paper.
    pub fn of(case: &Case) -> Self {
        let (titania, test) = checked(case);
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
        let chain = match test {
            TitaniaTest::Stretching(chain, test) => Some((chain.clone(), case.seed, test.distance.value)),
            _ => None,
        };
        Self { titania: titania.clone(), dt, overlap: case.limits.overlap, chain, stages }
    }

    /// The chain, in a box large enough for its stretching.
    fn stretchable(&self, chain: &Agglomerate, seed: u64, room: f64, interrupt: &Interrupt) -> Result<System, Error> {
        let built = agglomerate(&chain.recipe(), seed, interrupt)?.ok_or_else(|| {
            let expected = "expected a length that a random chain of these particles can have";
            Error::of_key("sample.agglomerate.length", format!("found `{}`, {expected}", chain.length))
        })?;
        let high: [f64; 3] = std::array::from_fn(|axis| extent(&built, axis)[1]);
        let margin = chain.largest.value;
        // Twice as deep as the chain: pictures show the half behind the middle, which is to hold the whole chain.
        let sides = [high[0] + room + 2.0 * margin, high[1] + 2.0 * margin, 2.0 * (high[2] + 2.0 * margin)];
        let mut particles = Particles::default();
        for (x, d) in built {
            let ((radius, mass), tag) = (self.titania.particle(d), particles.len() as u32);
            particles.push(x + Vec3([margin; 3]), radius, mass, tag);
        }
        Ok(System::new(particles, Domain { sides, periodic: [false; 3] }))
    }
}

impl Study for Plan {
    type Model = Titania;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name).collect()
    }

    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error> {
        match &self.chain {
            Some((chain, seed, room)) => self.stretchable(chain, *seed, *room, interrupt),
            // Every test of a contact starts with a new pair.
            None => Ok(System::new(Particles::default(), Domain { sides: [1.0; 3], periodic: [false; 3] })),
        }
    }

    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        let stage = &self.stages[stage];
        let mut system = match stage.act {
            StageAct::Approach { diameters, from } => pair(&self.titania, diameters, 0, from),
            StageAct::Press { diameters, .. } => pair(&self.titania, diameters, 1, 0.0),
            _ => system,
        };
        stage.drive(&mut system);
        Ok(system)
    }

    fn model(&self, _: usize) -> Titania {
        self.titania.law()
    }

    fn settings(&self, stage: usize, _: &System) -> Settings {
        Settings {
            damping: self.stages[stage].damping,
            skin: SKIN,
            max_overlap: self.overlap,
            ..Settings::new(self.dt)
        }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        ((self.stages[stage].duration / dt).round() as u64).max(1)
    }

    fn parts(&self, stage: usize) -> u64 {
        if matches!(self.stages[stage].act, StageAct::Pull { .. }) { 4 } else { 1 }
    }

    fn columns(&self, stage: usize) -> Vec<Column> {
        columns_of(&self.stages[stage].act)
    }

    fn windows(&self) -> Vec<Column> {
        if self.chain.is_some() { columns::windows() } else { Vec::new() }
    }

    fn watch(&self, _: usize, simulation: &Simulation<Titania>) -> Watch {
        Watch::begin(simulation)
    }

    fn can_hold(&self, stage: usize, system: &System, _: &Watch) -> bool {
        let (spheres, walls, steerings) = self.stages[stage].act.parts();
        let counts = (system.particles.len(), system.walls.len(), system.steerings.len());
        counts == (spheres.unwrap_or(counts.0), walls, steerings) && system.bodies.is_empty()
    }

    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<Titania>) -> Vec<String> {
        watch.follow(&self.stages[stage].act, simulation)
    }

    fn look(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<Titania>) -> Vec<Cell> {
        watch.look(&self.stages[stage].act, simulation)
    }

    fn window(&self, watch: &Watch, simulation: &Simulation<Titania>) -> Option<Vec<Cell>> {
        watch.window(simulation)
    }

    fn kind(&self, contact: &Contact<f64>) -> Option<PairKind> {
        Some(if contact.gap < 0.0 { PairKind::Contact } else { PairKind::Meniscus })
    }

    fn findings(&self, stage: usize, watch: &Watch, simulation: &Simulation<Titania>) -> Result<Vec<Finding>, Error> {
        Ok(watch.findings(&self.stages[stage].act, simulation))
    }
}

const OTHER: &str = "a film has a plan of its own";
