//! The stages of a case of the titania paper: tests of a single contact, or an agglomerate that is stretched or let go.

use super::case::{self, Agglomerate, Case, ChainTest, ContactTests, Stretching, TitaniaTest, TwoParticles, checked};
use super::chain::{Particle, agglomerate, corner, extent, margin};
use super::columns::{self, columns_of};
use super::law::{Law, radii};
use super::pair::pair;
use super::stage::{Stage, StageAct, ends};
use super::watch::Watch;
use super::{check, imported, lammps};
use crate::error::Error;
use crate::initial::aggregate::import::{Extras, Import};
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::output::{Cell, Column, Finding};
use crate::run::Study;
use crate::simulation::{Settings, Simulation};
use crate::spec::Contact;
use crate::spec::titania::Titania;
use crate::system::{Domain, Particles, System};
use std::marker::PhantomData;

/// The plan of a case, with its contact law: for a few spheres the law itself, for many with the attraction in tables.
pub struct Plan<M = Titania> {
    pub(super) titania: case::Titania,
    pub(super) dt: f64,
    pub(super) overlap: f64,
    /// The chain that is stretched or let go.
    pub(super) chain: Option<Chain>,
    pub(super) stages: Vec<Stage>,
    pub(super) law: PhantomData<M>,
}

/// A chain.
pub(super) struct Chain {
    sample: Agglomerate,
    seed: u64,
    /// Space for an end that is drawn, nm.
    room: f64,
    /// What its particles must suit.
    test: ChainTest,
}

/// Skin of the neighbour list, nm.
const SKIN: f64 = 1.0;

impl<M> Plan<M> {
    /// The plan of a case of the titania paper.
    pub fn of(case: &Case) -> Self {
        let (titania, test) = checked(case);
        let dt = test.dt().1.value;
        let stages = match &test {
            TitaniaTest::Contact(TwoParticles { diameters: [first, second] }, tests) => {
                let ContactTests { approach, slide, roll, .. } = tests;
                let released = approach.as_ref().map(|test| Stage::approach(test, [first.value, second.value], dt));
                let slid = slide.as_ref().map(|test| Stage::dragging(test, first.value, false, dt));
                let rolled = roll.as_ref().map(|test| Stage::dragging(test, first.value, true, dt));
                released.into_iter().chain(slid.into_iter().flatten()).chain(rolled.into_iter().flatten()).collect()
            }
            TitaniaTest::Chain(_, test) => match &**test {
                ChainTest::Stretching(test) => Stage::stretching(test, dt).into(),
                ChainTest::Release(test) => vec![Stage::release(test, dt)],
            },
            TitaniaTest::Path(..) | TitaniaTest::Spectroscopy(..) => unreachable!("{OTHER}"),
        };
        let chain = match test {
            TitaniaTest::Chain(sample, test) => {
                let room = match &*test {
                    ChainTest::Stretching(test) => test.distance.value,
                    ChainTest::Release(_) => 0.0,
                };
                Some(Chain { sample: sample.clone(), seed: case.seed, room, test: *test })
            }
            _ => None,
        };
        let overlap = case.limits.overlap;
        Self { titania: titania.clone(), dt, overlap, chain, stages, law: PhantomData }
    }

    /// The chain, in a box large enough for its stretching.
    fn boxed(&self, Chain { sample, seed, room, test }: &Chain, interrupt: &Interrupt) -> Result<System, Error> {
        let (built, extras, margin) = match &sample.import {
            Some(import) => {
                let (built, extras) = imported::particles(import, interrupt)?;
                self.suits(import, &built, test)?;
                let margin = margin(&built);
                (built, extras, margin)
            }
            None => {
                let built = agglomerate(&sample.recipe(), *seed, interrupt)?.ok_or_else(|| {
                    let expected = "expected a length that a random chain of these particles can have";
                    Error::of_key("sample.agglomerate.length", format!("found `{}`, {expected}", sample.length))
                })?;
                (built, Extras::default(), sample.largest.value)
            }
        };
        let extents: [[f64; 2]; 3] = std::array::from_fn(|axis| extent(&built, axis));
        let [x, y, z] = extents.map(|[low, high]| high - low.round());
        // Twice as deep as the chain: pictures show the half behind the middle, which is to hold the whole chain.
        let sides = [x + room + 2.0 * margin, y + 2.0 * margin, 2.0 * (z + 2.0 * margin)];
        let corner = corner(&built, margin);
        let mut particles = Particles::default();
        for (x, d) in built {
            let ((radius, mass), tag) = (self.titania.particle(d), particles.len() as u32);
            particles.push(x + corner, radius, mass, tag);
        }
        let mut system = System::new(particles, Domain { sides, periodic: [false; 3] });
        if let Some(import) = &sample.import {
            imported::join_and_move(&import.file, &extras, &mut system)?;
            self.ends_are_apart(import, &system, test)?;
        }
        Ok(system)
    }

    /// Checks the sizes and the number of particles from a file.
    fn suits(&self, import: &Import, built: &[Particle], test: &ChainTest) -> Result<(), Error> {
        let smallest = built.iter().map(|particle| particle.1).fold(f64::INFINITY, f64::min);
        let mut found = Vec::new();
        check::chain(&self.titania, smallest, test, &mut found);
        if let Some((key, what)) = found.into_iter().next() {
            return Err(Error::of_key(key, what));
        }
        if let ChainTest::Stretching(Stretching { drawn, .. }) = test
            && (built.len() as u64) < 2 * drawn
        {
            let what =
                format!("found {} particles, expected at least {}: `drawn` at either end", built.len(), 2 * drawn);
            return Err(Error::input(&import.file, what));
        }
        Ok(())
    }

    /// Checks that no rigid body is at both ends.
    fn ends_are_apart(&self, import: &Import, system: &System, test: &ChainTest) -> Result<(), Error> {
        let ChainTest::Stretching(Stretching { drawn, .. }) = test else { return Ok(()) };
        let [first, last] = ends(system.particles.len() as u32, *drawn as u32);
        let body = |id: u32| system.particles.body[id as usize];
        if first.into_iter().any(|i| body(i) > 0 && last.clone().any(|j| body(i) == body(j))) {
            let what = "one rigid body is at both ends, expected ends that can be drawn apart";
            return Err(Error::input(&import.file, what));
        }
        Ok(())
    }
}

impl<M: Law> Study for Plan<M> {
    type Model = M;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name).collect()
    }

    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error> {
        match &self.chain {
            Some(chain) => self.boxed(chain, interrupt),
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

    fn model(&self, _: usize, system: &System) -> M {
        M::new(&self.titania, &radii(system))
    }

    fn pair_style(&self, _: usize) -> Result<String, String> {
        Ok(lammps::pair_style(&self.titania))
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

    fn watch(&self, _: usize, simulation: &Simulation<M>, _: &Interrupt) -> Result<Watch, Error> {
        Ok(Watch::begin(simulation))
    }

    fn can_hold(&self, stage: usize, system: &System, _: &Watch) -> bool {
        let (spheres, walls, steerings) = self.stages[stage].act.parts();
        let counts = (system.particles.len(), system.walls.len(), system.steerings.len());
        counts == (spheres.unwrap_or(counts.0), walls, steerings) && (self.chain.is_some() || system.bodies.is_empty())
    }

    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<String> {
        watch.follow(&self.stages[stage].act, simulation)
    }

    fn look(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<Cell> {
        watch.look(&self.stages[stage].act, simulation)
    }

    fn window(&self, watch: &Watch, simulation: &Simulation<M>) -> Option<Vec<Cell>> {
        watch.window(simulation)
    }

    fn kind(&self, contact: &Contact<f64>) -> Option<PairKind> {
        Some(if contact.gap < 0.0 { PairKind::Contact } else { PairKind::Meniscus })
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<M>,
        interrupt: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        watch.findings(&self.stages[stage].act, simulation, interrupt)
    }
}

const OTHER: &str = "films and paths have plans of their own";
