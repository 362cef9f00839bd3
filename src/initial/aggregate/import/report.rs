//! A description of an imported aggregate.

use crate::geometry::Sphere;
use crate::geometry::{SphereExtent, gyration_radius, pairs_within};
use crate::spec::Real;
use serde::Serialize;
use std::fmt;

/// Surfaces that are deeper in each other than this part of the diameter and of the largest coordinate overlap. Rounding
/// both spheres to single precision, each number by half of EPSILON, brings the surfaces nearer by less than half of that.
const OVERLAP: f64 = 4.0 * f32::EPSILON as f64;

/// Figures for people.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Number of spheres.
    pub number: usize,
    /// Gyration radius of the centres, nm.
    pub r_g: f64,
    /// Fractal dimension, estimated from the distances of pairs.
    pub d_f: Option<f64>,
    /// Prefactor of the fractal law with this dimension and the geometric mean radius.
    pub k_f: Option<f64>,
    /// Smallest distance of two surfaces, nm; none if all pairs are far apart.
    pub smallest_gap: Option<f64>,
    /// Number of pairs that overlap.
    pub overlaps: usize,
    /// Number of parts that do not touch.
    pub components: usize,
}

impl Report {
    /// Measures the spheres.
    pub fn of(spheres: &[Sphere], components: usize) -> Self {
        let near = pairs_within(spheres, |r, s| 1.5 * (r + s));
        let gaps: Vec<(f64, f64)> = near
            .iter()
            .map(|&(i, j)| {
                let (a, b) = (&spheres[i], &spheres[j]);
                (a.gap(b), a.radius + b.radius)
            })
            .collect();
        let largest = spheres.iter().flat_map(|s| s.centre.0).map(f64::abs).fold(0.0, f64::max);
        let r_g = gyration_radius(spheres, SphereExtent::Centres);
        let n = spheres.len() as f64;
        let mean = Real::exp(spheres.iter().map(|s| Real::ln(s.radius)).sum::<f64>() / n);
        let d_f = dimension(spheres, mean, r_g);
        Self {
            number: spheres.len(),
            r_g,
            d_f,
            k_f: d_f.map(|d_f| n / crate::spec::soot::eq24_fractal::fractal_number(1.0, r_g, mean, d_f)),
            smallest_gap: gaps.iter().map(|gap| gap.0).min_by(f64::total_cmp),
            overlaps: gaps.iter().filter(|(gap, diameter)| *gap < -OVERLAP * (diameter + largest)).count(),
            components,
        }
    }
}

/// The slope of the logarithm of the number of pairs against that of their distance, by least squares between two diameters and
/// the gyration radius: an estimate that scatters by some tenths for aggregates of a hundred spheres. None if these are too few.
fn dimension(spheres: &[Sphere], mean_radius: f64, r_g: f64) -> Option<f64> {
    const STEPS: usize = 16;
    let (from, to) = (Real::ln(4.0 * mean_radius), Real::ln(r_g));
    if spheres.len() < 20 || to - from < 0.3 {
        return None;
    }
    // A thousand centres are enough of a sample.
    let stride = spheres.len().div_ceil(1000);
    let mut within = [0.0; STEPS];
    for a in spheres.iter().step_by(stride) {
        for b in spheres {
            let place = (Real::ln((a.centre - b.centre).norm()) - from) / (to - from) * (STEPS - 1) as f64;
            if a != b && place <= (STEPS - 1) as f64 {
                within[place.max(0.0).ceil() as usize] += 1.0;
            }
        }
    }
    let points: Vec<(f64, f64)> = within
        .iter()
        .enumerate()
        .scan(0.0, |sum: &mut f64, (k, &count)| {
            *sum += count;
            Some((from + (to - from) * k as f64 / (STEPS - 1) as f64, Real::ln(*sum)))
        })
        .collect();
    let mean = |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / STEPS as f64;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x).squared());
    slope.is_finite().then_some(slope)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let or_none = |value: Option<String>| value.unwrap_or_else(|| "none".into());
        writeln!(f, "spheres          {}", self.number)?;
        writeln!(f, "gyration radius  {:.4} nm", self.r_g)?;
        writeln!(f, "D_f (estimate)   {}", or_none(self.d_f.map(|d| format!("{d:.2}"))))?;
        writeln!(f, "k_f (estimate)   {}", or_none(self.k_f.map(|k| format!("{k:.2}"))))?;
        let gap = self.smallest_gap.map_or("more than a radius".into(), |gap| format!("{gap:.3e} nm"));
        writeln!(f, "smallest gap     {gap}")?;
        writeln!(f, "overlaps         {}", self.overlaps)?;
        write!(f, "components       {}", self.components)
    }
}
