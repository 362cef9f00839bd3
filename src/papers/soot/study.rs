//! The stages of a case of the soot paper: deposition, indentation and restructuring of an aggregate.

use super::case::{Aggregate, Case, Deposition, Experiment, NeckStrengths, Soot, SootStage, parts};
use super::columns::columns_of;
use super::energy::initial_springs;
use super::lammps;
use super::place::{middle, reach};
use super::stage::{self, Ground};
use super::strengths::Strengths;
use super::watch::Watch;
use crate::error::{Error, Halt};
use crate::geometry::Sphere;
use crate::initial::aggregate::NEIGHBOURLY;
use crate::initial::aggregate::import::Extras;
use crate::interrupt::Interrupt;
use crate::observe::PairKind;
use crate::output::{Cell, Column, Finding, load_sample, save_sample, sha256_file};
use crate::papers::necks::breaks;
use crate::random::Stream;
use crate::run::Study;
use crate::simulation::{Settings, Simulation};
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::necked::EXAMINED;
use crate::spec::soot::eq26_coordination::are_neighbours;
use crate::spec::soot::{self, Reading, Strength};
use crate::spec::{Contact, Vec3};
use crate::system::{Domain, Particles, System};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The plan of a case.
pub struct Plan<S> {
    /// Seed of every random stream.
    pub seed: u64,
    /// Largest overlap, as a fraction of the sum of the radii.
    pub max_overlap: f64,
    /// The interactions.
    pub soot: Soot,
    /// The reading of the springs.
    pub reading: S,
    /// The aggregate.
    pub sample: Aggregate,
    /// The stages, in succession.
    pub stages: Vec<SootStage>,
    /// Whether the case has a sequence of stages, even if of one: their keys then have numbers.
    pub in_sequence: bool,
}

/// Skin of the neighbour list, in radii: spheres of a collapsing aggregate take tens of thousands of steps to cross it.
const SKIN: f64 = 0.1;

/// Purpose of a random stream: the choice of the necks that are removed.
pub(super) const NECK_REMOVAL: &str = "neck removal";
/// Purpose of a random stream: the choice of the sphere that is indented.
const INDENTED_SPHERE: &str = "indented sphere";

impl<S: Reading> Plan<S> {
    /// The plan of a case of the soot paper.
    pub fn of(case: &Case, reading: S) -> Self {
        let (soot, sample, stages) = parts(case).expect("a checked case that is not about a pair");
        let (soot, sample) = (soot.clone(), sample.clone());
        let in_sequence = matches!(case.experiment, Experiment::Sequence(_));
        Self { seed: case.seed, max_overlap: case.limits.overlap, soot, reading, sample, stages, in_sequence }
    }
}

impl<S: Reading> Plan<S> {
    /// The parameters in which a deposited aggregate must agree. The seed is not one of them: with another seed the same aggregate is indented elsewhere. Files count by their
    /// contents: they may be copies.
    fn origin(&self) -> Result<String, Error> {
        let mut sample = Aggregate { deposited: None, ..self.sample.clone() };
        if let Some(import) = &mut sample.import {
            for path in import.files_mut() {
                *path = sha256_file(path)?.into();
            }
        }
        let mut soot = self.soot.clone();
        if let Some(NeckStrengths::File(path)) = &mut soot.neck_strengths {
            *path = sha256_file(path)?.into();
        }
        Ok(serde_json::to_string(&(&soot, &sample)).expect("a case is plain data"))
    }

    /// The key of a stage in the case.
    pub(super) fn key(&self, stage: usize) -> String {
        self.stages[stage].key(self.in_sequence.then_some(stage))
    }

    /// The contact law of a stage.
    pub(super) fn law(&self, stage: usize) -> soot::Soot<S> {
        self.soot.law_of(self.reading, &self.stages[stage])
    }

    /// The strengths of these necks relative to that of the case.
    fn strengths_in(&self, system: &System, interrupt: &Interrupt) -> Result<Strengths, Error> {
        let (necks, spheres) = (&system.necks, system.particles.len());
        Strengths::of(self.soot.neck_strengths.as_ref(), self.seed, necks, spheres, interrupt)
    }

    /// The random stream of a stage for a purpose: the first user, the sample or a stage, draws from the stream of the purpose, every later stage from a stream of its own.
    fn stream(&self, stage: usize, purpose: &str, by_sample: bool, draws: impl Fn(&SootStage) -> bool) -> Stream {
        let first = !by_sample && !self.stages[..stage].iter().any(draws);
        Stream::new(self.seed, &if first { purpose.into() } else { format!("{purpose} {}", stage + 1) })
    }
}

/// The median radius of the spheres, the unit of lengths in radii.
fn median_radius(Particles { radius, .. }: &Particles) -> f64 {
    let mut radii = radius.clone();
    radii.sort_unstable_by(f64::total_cmp);
    radii[radii.len() / 2]
}

impl<S: Reading> Study for Plan<S> {
    type Model = soot::Soot<S>;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(SootStage::name).collect()
    }

    fn expected_spheres(&self) -> f64 {
        self.sample.spheres as f64
    }

    fn reads_after(&self, stage: usize) -> Vec<PathBuf> {
        let solids = self.stages.iter().skip(stage + 1).filter_map(|stage| Some(stage.solid()?.stl.clone()));
        // Those of a stage under way are in its checkpoint.
        let strengths = self.soot.strengths_file().filter(|_| stage + 1 < self.stages.len());
        solids.chain(strengths.cloned()).collect()
    }

    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error> {
        // Files of later stages are checked before anything is computed.
        self.stages.iter().try_for_each(|stage| stage::solid(stage).map(drop))?;
        if let Some(path) = &self.sample.deposited {
            let system = load_sample(path, &self.origin()?, "model or aggregate")?;
            self.suits(system.particles.radius.iter().copied())?;
            self.strengths_in(&system, interrupt)?;
            return Ok(system);
        }
        let (spheres, necks, Extras { v, w, .. }) = self.aggregate(interrupt)?;
        let mut particles = Particles::default();
        let reach = reach(&spheres);
        let middle = middle(reach, self.sample.on_substrate);
        for &Sphere { centre, radius } in &spheres {
            particles.push(centre + middle, radius, sphere_mass(self.soot.density.value, radius), 0);
        }
        particles.v.iter_mut().zip(v).for_each(|(own, v)| *own = v);
        particles.w.iter_mut().zip(w).for_each(|(own, w)| *own = w);
        let domain = Domain { sides: [2.0 * reach; 3], periodic: [false; 3] };
        let springs = initial_springs::<S>(self.sample.neck_length, &spheres, &necks);
        let necks = necks.into_iter().map(|(i, j)| (i as u32, j as u32)).collect();
        let surfaces = if self.sample.on_substrate { vec![stage::plane()] } else { Vec::new() };
        let system = System { necks, springs, surfaces, ..System::new(particles, domain) };
        self.strengths_in(&system, interrupt)?;
        Ok(system)
    }

    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        let indents = |stage: &SootStage| matches!(stage, SootStage::Indentation(_));
        let ground = Ground {
            necks: self.stream(stage, NECK_REMOVAL, self.sample.neck_fraction < 1.0, stage::removes_necks),
            target: self.stream(stage, INDENTED_SPHERE, false, indents),
            radius: median_radius(&system.particles),
            key: self.key(stage),
        };
        stage::set_up::<Self::Model>(&self.stages[stage], ground, system)
    }

    fn model(&self, stage: usize, _: &System) -> soot::Soot<S> {
        self.law(stage)
    }

    fn pair_style(&self, stage: usize) -> Result<String, String> {
        if self.soot.neck_strengths.is_some() {
            return Err("has necks of different strengths, which the plugin for LAMMPS does not have".into());
        }
        Ok(lammps::pair_style(&self.soot, &self.law(stage)))
    }

    fn settings(&self, stage: usize, system: &System) -> Settings {
        let test = &self.stages[stage];
        Settings {
            integrator: test.integrator().engine(),
            synchronous_start: true,
            far_every: test.attraction_every(),
            skin: SKIN * median_radius(&system.particles),
            max_overlap: self.max_overlap,
            ..Settings::new(test.dt().value)
        }
    }

    fn steps(&self, stage: usize, dt: f64) -> u64 {
        (self.stages[stage].duration().value(dt) / dt).round() as u64
    }

    /// The next stage starts from this state, with the springs of all contacts.
    fn end(&self, stage: usize, simulation: Simulation<soot::Soot<S>>) -> Result<System, Error> {
        let system = simulation.into_system_with_springs();
        if let SootStage::Deposition(Deposition { save: Some(path), .. }) = &self.stages[stage] {
            save_sample(path, &self.origin()?, &system)?;
        }
        Ok(system)
    }

    fn parts(&self, stage: usize) -> u64 {
        if matches!(self.stages[stage], SootStage::Indentation(_)) { 4 } else { 2 }
    }

    fn columns(&self, stage: usize) -> Vec<Column> {
        columns_of(&self.stages[stage])
    }

    fn watch(
        &self,
        stage: usize,
        simulation: &Simulation<soot::Soot<S>>,
        interrupt: &Interrupt,
    ) -> Result<Watch, Error> {
        let strengths = self.strengths_in(simulation.system(), interrupt)?;
        Watch::begin(&self.stages[stage], simulation, strengths, interrupt)
    }

    fn can_hold(&self, stage: usize, system: &System, watch: &Watch) -> bool {
        let System { walls, bodies, steerings, necks, .. } = system;
        let observed = watch.belongs_to(&self.stages[stage], system)
            && watch.strengths().belong_to(necks, self.soot.neck_strengths.is_none());
        walls.is_empty() && bodies.is_empty() && steerings.is_empty() && observed
    }

    fn intervene(
        &self,
        _: usize,
        watch: &Watch,
        simulation: &mut Simulation<soot::Soot<S>>,
    ) -> Result<Vec<String>, Halt> {
        let strength = self.soot.strength();
        if strength == Strength::default() || !simulation.system().step.is_multiple_of(EXAMINED) {
            return Ok(Vec::new());
        }
        let law = *simulation.model();
        let broken = simulation.break_necks(|neck, contact, memory, held| {
            law.neck_breaks(contact, memory, held, &strength.times(watch.strengths().own(neck).unwrap_or(1.0)))
        })?;
        Ok(broken.into_iter().map(|neck| breaks(neck, watch.strengths().own(neck))).collect())
    }

    fn follow(&self, _: usize, watch: &mut Watch, simulation: &Simulation<soot::Soot<S>>) -> Vec<String> {
        watch.follow(simulation);
        Vec::new()
    }

    fn look(&self, _: usize, watch: &mut Watch, simulation: &Simulation<soot::Soot<S>>) -> Vec<Cell> {
        watch.look(simulation)
    }

    fn strengths<'a>(&self, watch: &'a Watch) -> Option<&'a BTreeMap<(u32, u32), f64>> {
        self.soot.neck_strengths.is_some().then(|| watch.strengths().all())
    }

    /// Spheres touch by the criterion of their coordination number.
    fn kind(&self, contact: &Contact<f64>) -> Option<PairKind> {
        let &Contact { n, distance, r_i, r_j, .. } = contact;
        let near = are_neighbours(n * distance, Vec3::zero(), r_i, r_j, NEIGHBOURLY) > 0.0;
        near.then_some(PairKind::Contact)
    }

    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<soot::Soot<S>>,
        interrupt: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        let findings = watch.findings(&self.stages[stage], simulation, interrupt)?;
        if self.stages.len() > 1 {
            let name = &self.names()[stage];
            return Ok(findings.into_iter().map(|finding| finding.during(name)).collect());
        }
        Ok(findings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::parse;
    use crate::spec::soot::Along;
    use std::path::Path;

    /// The initial systems of the stages of a sequence, as if no earlier stage had been run.
    fn beginnings(neck_fraction: f64, stages: &[&str]) -> Vec<System> {
        let lines: String = stages.iter().map(|stage| format!("    - {stage}\n")).collect();
        let sample = format!("sample: {{aggregate: {{spheres: 40, neck_fraction: {neck_fraction}}}}}\n");
        let text = format!("title: x\nmodel: {{soot: {{}}}}\n{sample}experiment:\n  sequence:\n{lines}");
        let case = parse::<crate::papers::soot::Soot>(Path::new("x.yaml"), &text).expect("a case");
        let plan = Plan::of(&case, Along);
        let system = plan.initial(&Interrupt::default()).expect("an aggregate");
        (0..stages.len()).map(|stage| plan.set_up(stage, system.clone()).expect("a stage")).collect()
    }

    const HALVED: &str = "restructuring: {keep_necks: 0.5}";
    const WHOLE: &str = "restructuring: {}";

    #[test]
    fn equal_stages_of_a_sequence_remove_other_necks() {
        let systems = beginnings(1.0, &[HALVED, HALVED]);
        assert_eq!(systems[0].necks.len(), systems[1].necks.len());
        assert_ne!(systems[0].necks, systems[1].necks);
        // The first stage that removes necks removes the same ones, wherever it is in the sequence.
        assert_eq!(beginnings(1.0, &[WHOLE, HALVED])[1].necks, systems[0].necks);
    }

    #[test]
    fn a_stage_does_not_repeat_the_random_numbers_of_the_sample() {
        let systems = beginnings(0.5, &[WHOLE, HALVED]);
        let drawn = |purpose: &str| {
            let mut system = systems[0].clone();
            stage::break_necks::<soot::Soot>(0.5, &mut Stream::new(1, purpose), &mut system);
            system.necks
        };
        assert_eq!(systems[1].necks, drawn("neck removal 2"));
        assert_ne!(systems[1].necks, drawn("neck removal"));
    }

    #[test]
    fn equal_stages_of_a_sequence_indent_other_spheres() {
        let systems = beginnings(1.0, &["deposition: {}", "indentation: {}", "indentation: {}", "indentation: {}"]);
        let tips: Vec<_> = systems[1..].iter().map(|system| &system.surfaces.last().expect("a tip").shape).collect();
        assert!(tips.iter().any(|shape| *shape != tips[0]));
    }

    #[test]
    fn an_aggregate_that_is_deposited_does_not_turn() {
        let case = "title: x\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 5}}\nexperiment: {deposition: {}}\n";
        let plan = Plan::of(&parse::<crate::papers::soot::Soot>(Path::new("x.yaml"), case).expect("a case"), Along);
        let mut system = plan.initial(&Interrupt::default()).expect("an aggregate");
        system.particles.w.fill(Vec3([1.0, 2.0, 3.0]));
        let deposited = plan.set_up(0, system).expect("a stage");
        assert!(deposited.particles.w.iter().all(|w| *w == Vec3::zero()));
    }

    #[test]
    fn stages_that_come_again_are_numbered() {
        let text = "title: x\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 2}}\nexperiment:\n  sequence:\n    - deposition: {}\n    \
                    - restructuring: {}\n    - restructuring: {}\n";
        let case = parse::<crate::papers::soot::Soot>(Path::new("x.yaml"), text).expect("a case");
        assert_eq!(Plan::of(&case, Along).names(), ["deposition", "restructuring", "restructuring 2"]);
    }
}
