//! A description of an imported aggregate.

use crate::error::Error;
use crate::geometry::Sphere;
use crate::geometry::pairs_within;
use crate::interrupt::Interrupt;
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
    /// Smallest distance of two surfaces, nm; none if all pairs are far apart.
    pub smallest_gap: Option<f64>,
    /// Number of pairs that overlap.
    pub overlaps: usize,
    /// Number of parts that do not touch.
    pub components: usize,
}

impl Report {
    /// Measures the spheres.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn of(spheres: &[Sphere], components: usize, interrupt: &Interrupt) -> Result<Self, Error> {
        let near = pairs_within(spheres, |r, s| 1.5 * (r + s), interrupt)?;
        let gaps: Vec<(f64, f64)> = near
            .iter()
            .map(|&(i, j)| {
                let (a, b) = (&spheres[i], &spheres[j]);
                (a.gap(b), a.radius + b.radius)
            })
            .collect();
        let largest = spheres.iter().flat_map(|s| s.centre.0).map(f64::abs).fold(0.0, f64::max);
        Ok(Self {
            number: spheres.len(),
            smallest_gap: gaps.iter().map(|gap| gap.0).min_by(f64::total_cmp),
            overlaps: gaps.iter().filter(|(gap, diameter)| *gap < -OVERLAP * (diameter + largest)).count(),
            components,
        })
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "spheres          {}", self.number)?;
        let gap = self.smallest_gap.map_or("more than a radius".into(), |gap| format!("{gap:.3e} nm"));
        writeln!(f, "smallest gap     {gap}")?;
        writeln!(f, "overlaps         {}", self.overlaps)?;
        write!(f, "components       {}", self.components)
    }
}
