//! Section 5.3 of the titania paper: the power laws of the aggregates of a film, by regression.

use crate::error::Error;
use crate::geometry::{Sphere, SphereExtent, gyration_radius};
use crate::initial::film::DepositedFilm;
use crate::interrupt::Interrupt;
use crate::observe::aggregate::AggregateShape;
use crate::observe::statistics::Mean;
use crate::reproduce::{Claim, log_slope};
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::titania::def_aggregate::sauter_diameter;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Number of aggregates whose size is measured.
const MEASURED: usize = 200;
/// Smallest number of particles in one of them: the shape of a smaller aggregate is ill defined.
const LEAST: usize = 10;
/// Groups of aggregates whose slopes have a mean and an interval.
const GROUPS: usize = 10;

/// Number of particles against size over Sauter diameter.
type Points = Vec<(f64, f64)>;

/// The fractal dimension and the mass-mobility exponent of the aggregates of a film.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub(super) fn laws(film: &DepositedFilm, interrupt: &Interrupt) -> Result<Vec<Claim>, Error> {
    let same = film.spheres.chunk_by(|a, b| a.aggregate == b.aggregate).filter(|members| members.len() >= LEAST);
    let aggregates: Vec<Vec<Sphere>> = same
        .take(MEASURED)
        .map(|members| members.iter().map(|s| Sphere { centre: s.centre, radius: 0.5 * s.diameter }).collect())
        .collect();
    let points = |size: &(dyn Fn(&[Sphere]) -> Result<f64, Error> + Sync)| -> Result<Points, Error> {
        aggregates.par_iter().map(|spheres| Ok((size(spheres)? / sauter(spheres), spheres.len() as f64))).collect()
    };
    let gyration = points(&|spheres| Ok(2.0 * gyration_radius(spheres, SphereExtent::Centres)))?;
    let mobility = points(&|spheres| {
        let [radius, _] = AggregateShape::of(spheres, interrupt)?.mobility_radius.expect("few spheres");
        Ok(2.0 * radius)
    })?;
    let claim = |what: &str, stated: f64, points: &[(f64, f64)]| {
        let slope = slope(points);
        Claim::new(
            "Section 5.3",
            format!("{what}, by regression of {} aggregates, within the confidence interval or 0.05", points.len()),
            format!("{stated}"),
            format!("{slope}, with the stated exponent a prefactor of {:.2}", prefactor(points, stated)),
            slope.covers(stated) || (slope.value - stated).abs() <= 0.05,
        )
    };
    Ok(vec![
        claim("fractal dimension, with radii of gyration of the centres", 1.8, &gyration),
        claim("mass-mobility exponent, with mobility diameters in air", 2.15, &mobility),
    ])
}

/// Sauter diameter of spheres.
fn sauter(spheres: &[Sphere]) -> f64 {
    let sum = |of: fn(f64) -> f64| spheres.iter().map(|s| of(s.radius)).sum::<f64>();
    sauter_diameter(sum(sphere_volume), sum(|r| 4.0 * PI * r * r))
}

/// The mean slope of groups of points.
fn slope(points: &[(f64, f64)]) -> Mean {
    let group = |k: usize| points.iter().copied().skip(k).step_by(GROUPS).collect::<Vec<_>>();
    Mean::of(&(0..GROUPS).map(|k| log_slope(&group(k))).collect::<Vec<_>>())
}

/// The geometric mean of what remains of the numbers beside a power of the size.
fn prefactor(points: &[(f64, f64)], power: f64) -> f64 {
    let left = points.iter().map(|(size, number)| libm::log(*number) - power * libm::log(*size));
    libm::exp(left.sum::<f64>() / points.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponent_and_prefactor_of_a_power_law_are_found() {
        let points: Points = (1..100).map(f64::from).map(|size| (size, 1.3 * size.powf(1.8))).collect();
        let slope = slope(&points);
        assert!((slope.value - 1.8).abs() < 1e-12 && slope.margin < 1e-12);
        assert!((prefactor(&points, 1.8) - 1.3).abs() < 1e-12);
    }
}
