//! Two spheres of unit mass and radius move in the engine as their golden trajectories, under both ways to step.

use super::super::Soot;
use super::super::case::parts;
use super::springs::{of_run, plane, spin, vector};
use crate::golden::{Complaints, Run, steps};
use crate::papers::parse;
use crate::run::advance_until;
use crate::simulation::{Integrator, Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::soot::{self, Along};
use crate::system::{Domain, Particles, System};
use std::path::Path;

pub(super) const BOTH: [Integrator; 2] = [Integrator::HalfStep, Integrator::VelocityVerlet];

/// The published interactions without a coating.
pub(super) fn dry() -> soot::Soot {
    let text = "title: t\nmodel: {soot: {necks: S, capillary_force: 0 nN}}\nsample: {aggregate: {}}\nexperiment: {restructuring: {}}\n";
    let case = parse::<Soot>(Path::new("published"), text).expect("a case of defaults");
    parts(&case).expect("a case of an aggregate").0.law(Along)
}

/// Springs and friction of a run for necks and contacts alike, and no attraction but that of its Hamaker constant.
pub(super) fn law(run: &Run) -> Result<soot::Soot, String> {
    let (springs, friction) = of_run(run)?;
    let mut law = soot::Soot { neck: springs, contact: springs, friction, ..dry() };
    law.attraction.a = run.number_or_nought("a")?;
    Ok(law)
}

/// Spheres of one radius and mass in free space.
pub(super) fn spheres(places: &[Vec3<f64>], radius: f64, mass: f64) -> System {
    let mut particles = Particles::default();
    places.iter().for_each(|&x| particles.push(x, radius, mass, 0));
    System::new(particles, Domain { sides: [20.0 * radius; 3], periodic: [false; 3] })
}

/// Two of unit mass and radius.
fn unit_pair(gap: f64) -> System {
    spheres(&[Vec3::zero(), Vec3([2.0 + gap, 0.0, 0.0])], 1.0, 1.0)
}

pub(super) struct Motion {
    pub(super) simulation: Simulation<soot::Soot>,
    dt: f64,
}

/// Position, velocity and spin of a sphere, as far as they are known.
type Known = (u32, [Option<Vec3<f64>>; 3]);

impl Motion {
    pub(super) fn new(law: soot::Soot, system: System, integrator: Integrator, dt: f64) -> Result<Self, String> {
        let skin = 0.1 * system.particles.radius[0];
        let settings = Settings { integrator, ..Settings::new(dt).skin(skin).max_overlap(f64::INFINITY) };
        let simulation = Simulation::new(law, system, settings).map_err(|halt| halt.to_string())?;
        Ok(Self { simulation, dt })
    }

    /// Goes on to a time; what is left to it is less than a step.
    pub(super) fn until(&mut self, time: f64) -> Result<f64, String> {
        let steps = steps((time / self.dt + 1e-9).floor())?;
        advance_until(&mut self.simulation, |now| now.system().step >= steps).map_err(|halt| halt.to_string())?;
        Ok(time - steps as f64 * self.dt)
    }

    /// Position, velocity and spin of a sphere, `late` after the last step.
    pub(super) fn state(&self, id: u32, late: f64) -> [Vec3<f64>; 3] {
        let system = self.simulation.system();
        let (p, of) = (system.place(id), &system.particles);
        [of.x[p] + of.v[p] * late, of.v[p], of.w[p]]
    }

    fn compare(&self, late: f64, expected: [Known; 2], tolerance: f64, complaints: &mut Complaints, what: &str) {
        for (id, values) in expected {
            let names = ["place", "velocity", "spin"];
            for ((name, is), expected) in names.into_iter().zip(self.state(id, late)).zip(values) {
                if let Some(expected) = expected {
                    complaints.near_vector(format_args!("{what}: {name} of sphere {id}"), is, expected, tolerance);
                }
            }
        }
    }
}

/// A kicked neck.
pub(super) fn neck(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let samples = run.samples::<10>()?;
    for integrator in BOTH {
        let mut system = unit_pair(0.0);
        system.necks = vec![(0, 1)];
        system.particles.v[1].0[1] = run.number("kick")?;
        let mut motion = Motion::new(law(run)?, system, integrator, 1e-4)?;
        for (number, sample) in samples.iter().enumerate() {
            let late = motion.until(sample[0])?;
            let at = |k: usize| Some(plane([sample[k], sample[k + 1]]));
            // First order where a dashpot sees the velocity of half a step before, and in the springs of the first step.
            let expected = [(0, [at(1), None, Some(spin(sample[5]))]), (1, [at(3), None, Some(spin(sample[6]))])];
            motion.compare(late, expected, 2e-5, complaints, &format!("{integrator:?}, sample {number}"));
        }
    }
    Ok(())
}

/// An oblique collision with spin.
pub(super) fn oblique(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let (samples, end) = (run.samples::<26>()?, run.numbers::<18>("final")?);
    for integrator in BOTH {
        let mut system = unit_pair(0.0);
        let (of, start) = (&mut system.particles, &samples[0]);
        (of.v[0], of.w[0], of.v[1], of.w[1]) =
            (vector(start, 4), vector(start, 7), vector(start, 13), vector(start, 16));
        let mut motion = Motion::new(law(run)?, system, integrator, 1e-4)?;
        for (number, sample) in samples.iter().enumerate() {
            let late = motion.until(sample[0])?;
            let at = |k: usize| Some(vector(sample, k));
            let expected = [(0, [at(1), at(4), at(7)]), (1, [at(10), at(13), at(16)])];
            // Velocities belong to half a step before, or friction is of first order.
            motion.compare(late, expected, 1e-4, complaints, &format!("{integrator:?}, sample {number}"));
        }
        motion.until(run.number("contact_time")? + 1.0)?;
        let at = |k: usize| Some(vector(&end, k));
        let expected = [(0, [None, at(3), at(6)]), (1, [None, at(12), at(15)])];
        motion.compare(0.0, expected, 2e-5, complaints, &format!("{integrator:?}, final"));
    }
    Ok(())
}

/// A planar collision with dashpots.
pub(super) fn planar(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    let end = run.numbers::<6>("final")?;
    for integrator in BOTH {
        // An overlap below every other scale: the dashpots act from first touch on.
        let mut system = unit_pair(-1e-12);
        let of = &mut system.particles;
        (of.v[0], of.v[1]) = (plane(run.numbers("v_i")?), plane(run.numbers("v_j")?));
        (of.w[0], of.w[1]) = (spin(run.number("omega_i")?), spin(run.number("omega_j")?));
        let mut motion = Motion::new(law(run)?, system, integrator, 2e-5)?;
        motion.until(run.number("contact_time")? + 1.0)?;
        let of = |k: usize| [None, Some(plane([end[k], end[k + 1]])), Some(spin(end[k + 2]))];
        motion.compare(0.0, [(0, of(0)), (1, of(3))], 2e-5, complaints, &format!("{integrator:?}, final"));
    }
    Ok(())
}
