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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;

    /// Spheres of a radius in a row.
    fn row<const N: usize>(radius: f64, places: [f64; N]) -> Report {
        let spheres = places.map(|x| Sphere { centre: Vec3([0.0, x, 0.0]), radius });
        Report::of(&spheres, N, &Interrupt::default()).expect("nothing interrupts")
    }

    #[test]
    fn the_smallest_gap_is_that_of_spheres_less_than_a_radius_apart() {
        assert_eq!(row(1.0, [0.0, 2.5, 7.0]).smallest_gap, Some(0.5));
        assert_eq!(row(1.0, [0.0, 2.875, 4.875 - 0.25]).smallest_gap, Some(-0.25));
        assert_eq!(row(1.0, [0.0, 2.99]).smallest_gap.map(|gap| (gap * 100.0).round()), Some(99.0));
        assert_eq!(row(1.0, [0.0, 3.01]).smallest_gap, None);
    }

    #[test]
    fn an_overlap_is_deeper_than_single_precision_rounds() {
        // Diameter and largest coordinate are 8 + 24: the bound is an overlap of 2^-16, which itself does not count.
        let bound = 2f64.powi(-16);
        for (overlap, expected) in [(0.0, 0), (0.999 * bound, 0), (bound, 0), (1.001 * bound, 1), (7.0, 1)] {
            assert_eq!(row(4.0, [0.0, 8.0 - overlap, -24.0]).overlaps, expected, "{overlap}");
        }
        assert_eq!(row(4.0, [0.0, 7.0, 14.0, 22.0]).overlaps, 2);
        // The bound goes with the size: of small spheres small overlaps count.
        assert_eq!(row(4e-3, [0.0, 8e-3 - 1e-8]).overlaps, 1);
    }

    #[test]
    fn figures_stand_in_a_column() {
        let text = "spheres          2\nsmallest gap     5.000e-1 nm\noverlaps         0\ncomponents       2";
        assert_eq!(row(1.0, [0.0, 2.5]).to_string(), text);
        assert!(row(1.0, [0.0, 9.0]).to_string().contains("\nsmallest gap     more than a radius\n"));
    }
}
