//! A film under the tip of an atomic force microscope: relaxation, approach to the setpoint, and retraction.

pub(super) mod columns;
mod contacts;
mod import;
pub mod spectrum;
mod tip;
mod watch;

pub use spectrum::Spectrum;

use super::case::{self, Case, Spectroscopy, TitaniaTest, checked};
use super::lammps;
use super::law::{Law, radii};
use crate::error::{Error, Halt};
use crate::initial::aggregate::import::Import;
use crate::initial::film::{DepositedFilm, FilmSphere};
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::observe::film::Structure;
use crate::output::{Cell, Column, Finding, load_sample, save_sample, sha256_file};
use crate::papers::necks::breaks;
use crate::run::{Progress, Study};
use crate::simulation::{Settings, Simulation};
use crate::spec::necked::EXAMINED;
use crate::spec::{Contact, Vec3};
use crate::system::{Motion, System};
use columns::results;
use std::marker::PhantomData;
use watch::Watch;

/// The plan of a case.
pub struct Plan<M> {
    titania: case::Titania,
    film: case::Film,
    test: Spectroscopy,
    seed: u64,
    overlap: f64,
    stages: Vec<FilmStage>,
    law: PhantomData<M>,
}

/// A stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmStage {
    /// Relaxation of the film.
    Relaxation,
    /// Approach of the tip.
    Approach,
    /// Reversal and retraction of the tip.
    Retraction,
}

impl FilmStage {
    const ALL: [Self; 3] = [Self::Relaxation, Self::Approach, Self::Retraction];

    fn name(self) -> &'static str {
        match self {
            Self::Relaxation => "relaxation",
            Self::Approach => "approach",
            Self::Retraction => "retraction",
        }
    }
}

/// Indices of the two walls.
const FIXED: usize = 0;
const TIP: usize = 1;
/// Skin of the neighbour list, nm.
const SKIN: f64 = 3.0;
const AT_REST: [Motion; 3] = [Motion::Velocity(0.0); 3];

impl<M: Law> Plan<M> {
    /// The plan of a case with a film.
    pub fn of(case: &Case) -> Self {
        let (titania, TitaniaTest::Spectroscopy(film, test)) = checked(case) else {
            unreachable!("asked only of cases that are about a film")
        };
        let (titania, film, test) = (titania.clone(), film.clone(), test.clone());
        let stages = if film.load.is_some() { &FilmStage::ALL[1..] } else { &FilmStage::ALL[..] }.to_vec();
        let (seed, overlap) = (case.seed, case.limits.overlap);
        Self { titania, film, test, seed, overlap, stages, law: PhantomData }
    }

    /// All parameters that determine a relaxed film. Files count by their contents: they may be copies.
    fn origin(&self) -> Result<String, Error> {
        let mut film = case::Film { save: None, load: None, ..self.film.clone() };
        for path in film.import.iter_mut().flat_map(Import::files_mut) {
            *path = sha256_file(path)?.into();
        }
        let Spectroscopy { relaxation, drag, dt, .. } = &self.test;
        let all = (&self.titania, film, relaxation, drag, dt, self.seed);
        Ok(serde_json::to_string(&all).expect("a case is plain data"))
    }

    /// The contact radii that grown particles may have, and their nominal diameters.
    fn sizes(&self) -> Vec<(f64, f64)> {
        self.film.sizes().into_iter().map(|d| (self.titania.particle(d).0, d)).collect()
    }

    /// Whether all spheres are particles of the film or, in some stages, of the tip. Particles of a file may have any size.
    fn has_sizes(&self, system: &System, with_tip: bool) -> bool {
        let sizes = self.sizes();
        let tip = with_tip.then(|| self.titania.particle(2.0 * self.test.tip.radius.value).0);
        let known = |radius: &f64| Some(*radius) == tip || sizes.iter().any(|size| size.0 == *radius);
        self.film.import.is_some() || system.particles.radius.iter().all(known)
    }

    /// The present structure of the film; spheres touch if their water layers do.
    fn structure(&self, system: &System) -> Structure {
        let p = &system.particles;
        let nominal = |radius: f64| self.titania.nominal(radius);
        let sphere = |i: usize| FilmSphere { centre: p.x[i], diameter: nominal(p.radius[i]), aggregate: p.tag[i] };
        let spheres: Vec<FilmSphere> = (0..p.len()).map(sphere).collect();
        let mut on_floor = vec![false; p.tag.iter().max().map_or(0, |&tag| tag as usize + 1)];
        (0..p.len()).filter(|&i| p.wall[i] > 0).for_each(|i| on_floor[p.tag[i] as usize] = true);
        let thickness = spheres.iter().map(|s| s.centre.0[2] + 0.5 * s.diameter).fold(0.0, f64::max);
        let [width, depth, _] = system.domain.sides;
        let film = DepositedFilm { spheres, on_floor, sides: [width, depth], thickness };
        Structure::of(&film, 2.0 * self.titania.layer.value - self.titania.core_gap.value, self.seed)
    }

    /// The spheres of the tip above the middle of the film, and their radius and mass.
    fn tip(&self, system: &System) -> Result<(Vec<Vec3<f64>>, f64, f64), Error> {
        let case::Tip { radius, side, clearance } = &self.test.tip;
        let [width, depth, _] = system.domain.sides;
        let (radius, mass) = self.titania.particle(2.0 * radius.value);
        let middle = Vec3([0.5 * width, 0.5 * depth, 0.0]);
        let centres: Vec<_> = tip::pyramid(radius, side.value).into_iter().map(|c| c + middle).collect();
        let lifted = tip::lift(&centres, radius, &system.particles, &system.domain, clearance.value);
        let none =
            || Error::of_key("sample.film", "no sphere lies below the tip, expected a denser film or a wider tip");
        let lifted = lifted.ok_or_else(none)?;
        Ok((centres.into_iter().map(|c| c + Vec3([0.0, 0.0, lifted])).collect(), radius, mass))
    }

    /// Places the tip above the middle of the film, and starts the approach.
    fn add_tip(&self, system: &mut System) -> Result<(), Error> {
        let (centres, radius, mass) = self.tip(system)?;
        let first = system.particles.len();
        // The ids continue those of the film, because indices no longer equal ids.
        let tag = system.particles.tag.iter().copied().max().map_or(0, |tag| tag + 1);
        for c in centres {
            system.particles.push(c, radius, mass, tag);
        }
        system.add_body(&(first..system.particles.len()).collect::<Vec<_>>());
        let tip = system.bodies.len() as u32;
        let down = [AT_REST[0], AT_REST[1], Motion::Velocity(-self.test.speed.value)];
        system.add_wall(down, |p, i| p.body[i] == tip);
        let top = system.particles.x.iter().map(|x| x.0[2]).fold(0.0, f64::max);
        // Pictures are to show the tip during its retraction too.
        system.domain.sides[2] = top + radius + 0.5 * self.test.retraction.value;
        Ok(())
    }
}

impl<M: Law> Study for Plan<M> {
    type Model = M;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name()).collect()
    }

    fn expected_spheres(&self) -> f64 {
        self.film.number() as f64
    }

    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error> {
        if let Some(path) = &self.film.load {
            let system = load_sample(path, &self.origin()?, "model, film, relaxation or seed")?;
            let known = self.has_sizes(&system, false);
            return if known { Ok(system) } else { Err(Error::input(path, "holds particles of other sizes")) };
        }
        let system = match &self.film.import {
            Some(import) => self.imported(import, interrupt)?,
            None => {
                let film = self.film.plan().build(self.seed, interrupt).map_err(|failure| failure.of("sample.film"))?;
                film.system(M::BONDING, |d| self.titania.particle(d))
            }
        };
        // A film that leaves nothing below the tip is found before it is relaxed.
        self.tip(&system).map(|_| system)
    }

    fn set_up(&self, stage: usize, mut system: System) -> Result<System, Error> {
        match self.stages[stage] {
            FilmStage::Relaxation => {}
            FilmStage::Approach => self.add_tip(&mut system)?,
            FilmStage::Retraction => {
                let turning = Motion::Return { speed: self.test.speed.value, turn: self.test.reversal.value };
                system.walls[TIP].redirect([AT_REST[0], AT_REST[1], turning]);
            }
        }
        Ok(system)
    }

    fn model(&self, _: usize, system: &System) -> M {
        M::new(&self.titania, &radii(system))
    }

    fn pair_style(&self, _: usize) -> Result<String, String> {
        Ok(lammps::pair_style(&self.titania))
    }

    fn settings(&self, stage: usize, _: &System) -> Settings {
        let damping = if self.stages[stage] == FilmStage::Relaxation { self.test.drag.value } else { 0.0 };
        Settings { damping, skin: SKIN, max_overlap: self.overlap, ..Settings::new(self.test.dt.value) }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        let test = &self.test;
        let time = match self.stages[stage] {
            FilmStage::Relaxation => test.relaxation.value(dt),
            FilmStage::Approach => test.depth.value / test.speed.value,
            FilmStage::Retraction => test.reversal.value + test.retraction.value / test.speed.value,
        };
        ((time / dt).round() as u64).max(1)
    }

    fn progress(&self, stage: usize, watch: &Watch, simulation: &Simulation<M>) -> Progress {
        let done = match self.stages[stage] {
            FilmStage::Relaxation => false,
            FilmStage::Approach => watch.presses_with(self.test.setpoint.value),
            FilmStage::Retraction => watch.parted_by(AFTER),
        };
        let last = self.steps(stage, simulation.settings().dt);
        if done || simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }

    fn may_end_early(&self, stage: usize) -> bool {
        self.stages[stage] != FilmStage::Relaxation
    }

    fn end(&self, stage: usize, simulation: Simulation<M>) -> Result<System, Error> {
        let system = simulation.into_system_with_springs();
        if let (FilmStage::Relaxation, Some(path)) = (self.stages[stage], &self.film.save) {
            save_sample(path, &self.origin()?, &system)?;
        }
        Ok(system)
    }

    fn parts(&self, stage: usize) -> u64 {
        if self.stages[stage] == FilmStage::Retraction { 4 } else { 1 }
    }

    fn upwards(&self) -> usize {
        2
    }

    fn columns(&self, stage: usize) -> Vec<Column> {
        columns::columns_of(self.stages[stage], M::BONDING)
    }

    fn windows(&self) -> Vec<Column> {
        columns::windows()
    }

    fn watch(&self, _: usize, simulation: &Simulation<M>, _: &Interrupt) -> Result<Watch, Error> {
        Ok(Watch::begin(simulation))
    }

    fn can_hold(&self, stage: usize, system: &System, _: &Watch) -> bool {
        let relaxes = self.stages[stage] == FilmStage::Relaxation;
        system.walls.len() == if relaxes { FIXED } else { TIP } + 1 && self.has_sizes(system, !relaxes)
    }

    fn intervene(&self, _: usize, _: &Watch, simulation: &mut Simulation<M>) -> Result<Vec<String>, Halt> {
        let Some(strength) = &self.titania.break_energy else { return Ok(Vec::new()) };
        if !simulation.system().step.is_multiple_of(EXAMINED) {
            return Ok(Vec::new());
        }
        let broken = simulation.break_necks(|_, _, _, held| M::neck_breaks(held, strength.value))?;
        Ok(broken.into_iter().map(|neck| breaks(neck, None)).collect())
    }

    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<String> {
        watch.follow(self.stages[stage], self.test.average.value, simulation)
    }

    fn look(&self, _: usize, watch: &mut Watch, simulation: &Simulation<M>) -> Vec<Cell> {
        watch.look(simulation)
    }

    fn window(&self, watch: &Watch, _: &Simulation<M>) -> Option<Vec<Cell>> {
        watch.window()
    }

    fn kind(&self, contact: &Contact<f64>) -> Option<PairKind> {
        Some(if contact.gap < 0.0 { PairKind::Contact } else { PairKind::Meniscus })
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<M>,
        _: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        let mut found = watch.findings(self.stages[stage], self.test.setpoint.value, simulation);
        if self.stages[stage] == FilmStage::Relaxation {
            let structure = self.structure(simulation.system());
            // A single layer of spheres has no bulk.
            let bulk = structure.bulk[0] < structure.bulk[1];
            found.extend(bulk.then(|| Finding::number(results::POROSITY, structure.porosity).target(0.98)));
            found.extend([
                Finding::number(results::THICKNESS, structure.thickness),
                Finding::number(results::CONTACTS_BETWEEN, structure.contacts_between),
                Finding::number(results::CONTACTS_WITHIN, structure.contacts_within),
            ]);
            let pores = [results::PORE_10, results::PORE_50, results::PORE_90].into_iter().zip(structure.pores);
            found.extend(pores.filter(|_| bulk).map(|(result, pore)| Finding::number(result, pore)));
            found.push(Finding::numbers(results::PROFILE, structure.profile));
        }
        Ok(found)
    }
}

/// Displacement of the tip after the rupture at which the retraction ends, nm.
const AFTER: f64 = 50.0;
