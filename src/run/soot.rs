//! The stages of a case of the soot paper: an aggregate collapses under its coating.

use super::Study;
use crate::build::aggregate::necks::{keep_fraction, necks};
use crate::build::aggregate::{Method, Radii, Recipe, Sphere, aggregate, import};
use crate::build::protocol::Progress;
use crate::case::quantity::{Length, Quantity};
use crate::case::{Aggregate, Case, Growth, Import, Restructuring, Soot};
use crate::error::Error;
use crate::forces::Instructions;
use crate::observe::morphology::{Extent, centre_of_mass, convexity, coordination_number, gyration_radius};
use crate::output::{Cell, Finding};
use crate::simulation::{Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::soot;
use crate::spec::wear::def_sphere::sphere_mass;
use crate::system::{Domain, Particles, System};

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
    /// What is done to it.
    pub test: Restructuring,
}

/// How much farther than their range neighbours are listed, in radii: a collapse moves spheres by a few diameters.
const SKIN: f64 = 0.5;

impl Plan {
    /// The plan of a case of the soot paper.
    pub fn of(case: &Case) -> Self {
        let (soot, sample, test) = case.soot().expect("a checked case of the soot paper is complete");
        let (soot, sample, test) = (soot.clone(), sample.clone(), test.clone());
        Self { seed: case.seed, max_overlap: case.limits.overlap, soot, sample, test }
    }
}

impl Plan {
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

const COLUMNS: [&str; 3] = ["coordination number", "convexity", "gyration radius [nm]"];

/// What of an aggregate's shape is followed: coordination number, convexity, gyration radius.
pub type Shape = [f64; 3];

fn shape(system: &System) -> Shape {
    let Particles { x, radius, .. } = &system.particles;
    let spheres: Vec<Sphere> = x.iter().zip(radius).map(|(&centre, &radius)| Sphere { centre, radius }).collect();
    [coordination_number(&spheres), convexity(&spheres).value, gyration_radius(&spheres, Extent::Centres)]
}

impl Study for Plan {
    type Model = soot::Soot;
    type Watch = Shape;

    fn stages(&self) -> Vec<&'static str> {
        vec!["restructuring"]
    }

    fn initial(&self) -> Result<System, Error> {
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

    fn set_up(&self, _: usize, system: System) -> System {
        system
    }

    fn model(&self, _: usize) -> soot::Soot {
        self.soot.law()
    }

    fn settings(&self, _: usize, _: &System) -> Settings {
        Settings {
            dt: self.test.dt.value,
            damping: 0.0,
            skin: SKIN * self.sample.radius.value,
            max_overlap: self.max_overlap,
            relax_box: None,
            instructions: Instructions::best(),
        }
    }

    fn steps(&self, _: usize, dt: f64) -> u64 {
        (self.test.duration.value(dt) / dt).round() as u64
    }

    fn progress(&self, stage: usize, _: &Shape, simulation: &Simulation<soot::Soot>) -> Progress {
        let last = self.steps(stage, simulation.settings().dt);
        if simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }

    fn end(&self, _: usize, simulation: Simulation<soot::Soot>) -> System {
        simulation.into_system()
    }

    fn parts(&self, _: usize) -> u64 {
        2
    }

    fn columns(&self) -> Vec<&'static str> {
        COLUMNS.into()
    }

    fn watch(&self, _: usize, simulation: &Simulation<soot::Soot>) -> Shape {
        shape(simulation.system())
    }

    fn look(&self, _: &mut Shape, simulation: &Simulation<soot::Soot>) -> Vec<Cell> {
        shape(simulation.system()).map(Cell::Number).into()
    }

    fn findings(&self, _: usize, begin: &Shape, simulation: &Simulation<soot::Soot>) -> Result<Vec<Finding>, Error> {
        let mut findings = vec![Finding::number("necks", simulation.system().necks.len() as f64, "", None)];
        for (when, [coordination, convexity, gyration]) in
            [("at first", *begin), ("at last", shape(simulation.system()))]
        {
            findings.extend([
                Finding::number(&format!("coordination number {when}"), coordination, "", None),
                Finding::number(&format!("convexity {when}"), convexity, "", None),
                Finding::number(&format!("gyration radius {when}"), gyration, "nm", None),
            ]);
        }
        Ok(findings)
    }
}
