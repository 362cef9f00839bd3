//! The study: the stages and their observer.

use super::case::{Experiment, Model, Sample};
use super::law::{Linear, contact_time, restitution};
use serde::{Deserialize, Serialize};
use veridem::case::{Case, InSteps};
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::output::columns::columns;
use veridem::output::{Cell, Column, Finding};
use veridem::run::{Progress, Study};
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::mechanics::reduced_mass::effective_mass;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::system::{Domain, Particles, System};

/// Two spheres approach each other, and rebound.
pub(super) struct Plan {
    pub law: Linear,
    radius: f64,
    pub mass: f64,
    gap: f64,
    velocity: f64,
    pub dt: f64,
    most: InSteps,
    max_overlap: f64,
}

/// The number of the second stage.
const REBOUND: usize = 1;
columns! {
    /// Columns and results.
    pub(super) const ALL {
        /// Distance of the surfaces.
        GAP = "gap" in "nm";
        /// Relative velocity after the collision over that before.
        RESTITUTION = "restitution";
        /// Largest overlap of the spheres.
        DEEPEST = "largest overlap" in "nm";
    }
}

/// The state of the observer: the present gap and the smallest one so far, nm.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Watch {
    gap: f64,
    least: f64,
}

fn gap(system: &System) -> f64 {
    let spheres = &system.particles;
    (spheres.x[0] - spheres.x[1]).norm() - spheres.radius[0] - spheres.radius[1]
}

impl Plan {
    /// What a case asks for.
    pub(super) fn of(case: &Case<Model, Sample, Experiment>) -> Self {
        let (Model::Linear(material), Sample::Pair(pair)) = (&case.model, &case.sample);
        let Experiment::Collision(collision) = &case.experiment;
        let law = Linear { stiffness: material.stiffness.value, damping_ratio: material.damping_ratio };
        let radius = pair.radius.value;
        let mass = sphere_mass(material.density.value, radius);
        Self {
            law,
            radius,
            mass,
            gap: pair.gap.value(radius),
            velocity: collision.velocity.value,
            dt: collision.dt.value(contact_time(effective_mass(mass, mass), law.stiffness, law.damping_ratio)),
            most: collision.most.clone(),
            max_overlap: case.limits.overlap,
        }
    }

    /// Velocity of separation relative to velocity of approach.
    pub(super) fn bounce(&self, system: &System) -> f64 {
        (system.particles.v[0] - system.particles.v[1]).norm() / self.velocity
    }
}

impl Study for Plan {
    type Model = Linear;
    type Watch = Watch;

    fn stages(&self) -> Vec<&'static str> {
        vec!["approach", "rebound"]
    }
    fn initial(&self, _: &Interrupt) -> Result<System, Error> {
        let side = 8.0 * self.radius + self.gap;
        let mut spheres = Particles::default();
        for direction in [-1.0, 1.0] {
            let x = 0.5 * side + direction * (self.radius + 0.5 * self.gap);
            spheres.push(Vec3::new(x, 0.5 * side, 0.5 * side), self.radius, self.mass, 0);
        }
        spheres.v = [0.5, -0.5].map(|share| Vec3::new(share * self.velocity, 0.0, 0.0)).into();
        Ok(System::new(spheres, Domain { sides: [side; 3], periodic: [false; 3] }))
    }
    fn model(&self, _: usize, _: &System) -> Linear {
        self.law
    }
    fn settings(&self, _: usize, _: &System) -> Settings {
        Settings::new(self.dt).skin(0.1 * self.radius).max_overlap(self.max_overlap)
    }
    fn steps(&self, _: usize, dt: f64) -> u64 {
        self.most.value(dt).div_euclid(dt) as u64
    }
    fn progress(&self, stage: usize, watch: &Watch, simulation: &Simulation<Linear>) -> Progress {
        let late = simulation.system().step >= self.steps(stage, self.dt);
        match stage {
            REBOUND if watch.gap >= 0.0 => Progress::Done,
            REBOUND if late => Progress::Failed("the spheres have not separated"),
            REBOUND => Progress::Going,
            _ if watch.gap < 0.0 => Progress::Done,
            _ if late => Progress::Failed("the spheres have not met"),
            _ => Progress::Going,
        }
    }
    fn may_end_early(&self, _: usize) -> bool {
        true
    }
    fn columns(&self, _: usize) -> Vec<Column> {
        vec![GAP]
    }
    fn watch(&self, _: usize, simulation: &Simulation<Linear>, _: &Interrupt) -> Result<Watch, Error> {
        let gap = gap(simulation.system());
        Ok(Watch { gap, least: gap })
    }
    fn follow(&self, stage: usize, watch: &mut Watch, simulation: &Simulation<Linear>) -> Vec<String> {
        let before = watch.gap;
        watch.gap = gap(simulation.system());
        watch.least = watch.least.min(watch.gap);
        let turns = stage == REBOUND && watch.least == before && watch.gap > before;
        if turns { vec!["the overlap is deepest".into()] } else { Vec::new() }
    }
    fn look(&self, _: usize, watch: &mut Watch, _: &Simulation<Linear>) -> Vec<Cell> {
        vec![Cell::Number(watch.gap)]
    }
    fn findings(
        &self,
        stage: usize,
        watch: &Watch,
        simulation: &Simulation<Linear>,
        _: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        if stage != REBOUND {
            return Ok(Vec::new());
        }
        let expected = restitution(self.law.damping_ratio);
        Ok(vec![
            Finding::number(RESTITUTION, self.bounce(simulation.system())).target(expected),
            Finding::number(DEEPEST, -watch.least),
        ])
    }
}
