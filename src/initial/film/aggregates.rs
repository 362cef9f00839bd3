//! The aggregates of a film before their deposition, and their diffusion coefficients.

use super::{Diameters, Failure, FilmPlan, Numbers, Ungrown};
use crate::case::units::BOLTZMANN;
use crate::geometry::Sphere;
use crate::geometry::capacity::capacity;
use crate::geometry::shadow::mean_projected_area;
use crate::initial::aggregate::grown;
use crate::initial::aggregate::law::{Form, Law};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::Real;
use crate::spec::mechanics::diffusion::diffusion;
use crate::spec::mechanics::discretised_lognormal::lognormal_share;
use crate::spec::mechanics::thermal::thermal_energy;
use crate::spec::titania::eq14_friction_factor::friction_factor;
use rayon::prelude::*;

/// Walks that measure the hydrodynamic radius: its standard error is 3 % where half of them hit.
const WALKS: usize = 1000;
/// Number of times that the spheres of an aggregate are redrawn if they cannot meet the law, such as a large one among small ones.
const DRAWS: usize = 5;
/// Directions in which the projected area is taken.
const DIRECTIONS: usize = 56;

/// An aggregate about its centre of mass.
pub(super) struct Aggregate {
    pub spheres: Vec<Sphere>,
    /// Coefficient of diffusion.
    pub diffusion: f64,
}

/// The aggregates of a film, in the order in which they fall.
pub(super) fn aggregates(plan: &FilmPlan, seed: u64, interrupt: &Interrupt) -> Result<Vec<Aggregate>, Failure> {
    let mut stream = Stream::new(seed, "film numbers");
    let (mut sizes, mut total) = (Vec::new(), 0);
    while total < plan.spheres {
        sizes.push(plan.numbers.draw(&mut stream));
        total += sizes[sizes.len() - 1];
    }
    let classes = plan.diameters.classes();
    let law = Law { k_f: plan.k_f, d_f: plan.d_f, form: Form::SauterDiameter };
    let one = |(k, &number): (usize, &usize)| {
        let mut stream = Stream::new(seed, &format!("film aggregate {k}"));
        let mut missed = None;
        for _ in 0..DRAWS {
            let radii = (0..number).map(|_| 0.5 * draw(&classes, &mut stream)).collect();
            let (spheres, failure) =
                grown(radii, plan.cluster, &law, &mut stream, interrupt).map_err(Failure::Ungrown)?;
            // One cluster may be too small for the law, whatever its spheres: as clusters do on the way, it comes as near as it can.
            if failure.is_none() || number <= plan.cluster {
                let diffusion = plan.diffusion(&spheres, &mut stream, interrupt)?;
                return Ok(Aggregate { spheres, diffusion });
            }
            missed = failure;
        }
        Err(Failure::Ungrown(missed.expect("it was grown at least once")))
    };
    sizes.par_iter().enumerate().map(one).collect()
}

impl FilmPlan {
    fn diffusion(&self, spheres: &[Sphere], stream: &mut Stream, interrupt: &Interrupt) -> Result<f64, Failure> {
        let stopped = |_| Failure::Ungrown(Ungrown::Interrupted);
        let [r_h, _] = capacity(spheres, WALKS, stream, interrupt).map_err(stopped)?;
        let area = mean_projected_area(spheres, DIRECTIONS, interrupt).map_err(stopped)?;
        let (_, _, friction) = friction_factor(self.gas.viscosity, self.gas.free_path, r_h, area);
        Ok(diffusion(thermal_energy(BOLTZMANN, self.gas.temperature), friction))
    }
}

impl Numbers {
    /// A random number.
    pub fn draw(&self, stream: &mut Stream) -> usize {
        loop {
            let number = (self.median * Real::exp(self.deviation * stream.normal())).round();
            if number >= 1.0 && number <= f64::from(self.largest) {
                return number as usize;
            }
        }
    }
}

impl Diameters {
    /// The diameters and the shares of those up to each.
    pub fn classes(&self) -> Vec<(f64, f64)> {
        let (lo, hi) = (f64::from(self.smallest), f64::from(self.largest));
        let mut up_to = 0.0;
        let class = |d| {
            up_to += lognormal_share(f64::from(d), self.median, self.deviation, lo, hi);
            (f64::from(d), up_to)
        };
        (self.smallest..=self.largest).map(class).collect()
    }
}

pub(super) fn draw(classes: &[(f64, f64)], stream: &mut Stream) -> f64 {
    let share = stream.uniform();
    classes[classes.partition_point(|class| class.1 <= share).min(classes.len() - 1)].0
}
