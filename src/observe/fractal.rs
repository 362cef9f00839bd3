//! The fractal dimension of one aggregate.

use crate::geometry::{Sphere, SphereExtent, gyration_radius};
use crate::observe::statistics::jackknife;
use crate::spec::Real;
use crate::spec::soot::eq24_fractal::fractal_number;
use serde::{Deserialize, Serialize};

/// The fractal law that an aggregate follows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FractalLaw {
    /// Fractal dimension.
    pub dimension: f64,
    /// Its standard error.
    pub error: f64,
    /// Prefactor of the law with this dimension, the radius of gyration of the centres and the geometric mean radius.
    pub prefactor: f64,
}

/// Points of the curve whose slope is the dimension.
const STEPS: usize = 16;
/// Least number of spheres.
const LEAST: usize = 20;
/// Centres from which distances are taken: enough of a sample.
const CENTRES: usize = 1000;
/// Groups of spheres that are left out in turn.
const GROUPS: usize = 10;

impl FractalLaw {
    /// The slope of the logarithm of the number of pairs against that of their distance, by least squares between two diameters and the radius of
    /// gyration. Its error is found by leaving out every tenth of the spheres in turn. None if these are too few.
    pub fn of(spheres: &[Sphere]) -> Option<Self> {
        let n = spheres.len() as f64;
        let mean = Real::exp(spheres.iter().map(|s| Real::ln(s.radius)).sum::<f64>() / n);
        let r_g = gyration_radius(spheres, SphereExtent::Centres);
        let span = (Real::ln(4.0 * mean), Real::ln(r_g));
        if spheres.len() < LEAST || span.1 - span.0 < 0.3 {
            return None;
        }
        // Pairs by distance and by the groups of both ends, so that a group is left out without counting again.
        let mut counts = vec![[[0.0; GROUPS]; GROUPS]; STEPS];
        let stride = spheres.len().div_ceil(CENTRES);
        for (i, a) in spheres.iter().enumerate().step_by(stride) {
            for (j, b) in spheres.iter().enumerate().filter(|(j, _)| *j != i) {
                let place = (Real::ln((a.centre - b.centre).norm()) - span.0) / (span.1 - span.0) * (STEPS - 1) as f64;
                if place <= (STEPS - 1) as f64 {
                    counts[place.max(0.0).ceil() as usize][i / stride % GROUPS][j % GROUPS] += 1.0;
                }
            }
        }
        let slope_without = |left_out: Option<usize>| {
            let within = counts.iter().map(|groups| {
                let kept = |group: &usize| Some(*group) != left_out;
                (0..GROUPS).filter(kept).map(|i| (0..GROUPS).filter(kept).map(|j| groups[i][j]).sum::<f64>()).sum()
            });
            slope(&within.collect::<Vec<f64>>(), span)
        };
        let dimension = slope_without(None);
        let others: Vec<f64> = (0..GROUPS).map(|group| slope_without(Some(group))).collect();
        let error = jackknife(&others);
        let prefactor = n / fractal_number(1.0, r_g, mean, dimension);
        (dimension.is_finite() && error.is_finite()).then_some(Self { dimension, error, prefactor })
    }
}

/// The slope of the logarithm of the running sum, at equal steps of `span`.
fn slope(counts: &[f64], (from, to): (f64, f64)) -> f64 {
    let running = counts.iter().scan(0.0, |sum: &mut f64, count| {
        *sum += count;
        Some(*sum)
    });
    let step = (to - from) / (counts.len() - 1) as f64;
    let points: Vec<(f64, f64)> = running.enumerate().map(|(k, sum)| (from + step * k as f64, Real::ln(sum))).collect();
    let mean = |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x).squared())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::aggregate::{Method, Radii, Recipe, aggregate};
    use crate::interrupt::Interrupt;
    use crate::spec::Vec3;

    #[test]
    fn a_line_has_one_dimension_and_a_plane_two() {
        let at = |x: f64, y: f64| Sphere { centre: Vec3([2.0 * x, 2.0 * y, 0.0]), radius: 1.0 };
        let line: Vec<Sphere> = (0..200).map(|k| at(f64::from(k), 0.0)).collect();
        let plane: Vec<Sphere> = (0..1600).map(|k| at(f64::from(k % 40), f64::from(k / 40))).collect();
        for (spheres, dimension) in [(line, 1.0), (plane, 2.0)] {
            let law = FractalLaw::of(&spheres).expect("enough spheres");
            assert!((law.dimension - dimension).abs() < 0.2, "{law:?}");
            assert!(law.error < 0.1, "{law:?}");
        }
        assert_eq!(FractalLaw::of(&[at(0.0, 0.0); 19]), None);
    }

    #[test]
    fn a_grown_aggregate_has_the_dimension_of_its_law_within_some_errors() {
        let recipe = Recipe { number: 600, d_f: 1.8, k_f: 1.4, radii: Radii::Equal(1.0), method: Method::Clusters };
        let grown = aggregate(&recipe, 1, &Interrupt::default()).expect("an aggregate");
        let law = FractalLaw::of(&grown).expect("enough spheres");
        assert!((law.dimension - 1.8).abs() < 4.0 * law.error && law.error < 0.3, "{law:?}");
    }

    #[test]
    fn a_dimension_that_one_pair_decides_has_no_error_and_is_not_told() {
        let at = |x: f64, y: f64| Sphere { centre: Vec3([x, y, 0.0]), radius: 1.0 };
        let grid = (0..25).map(|k| at(40.0 * f64::from(k % 5), 40.0 * f64::from(k / 5)));
        // Only two spheres are closer than four radii.
        let spheres: Vec<Sphere> = [at(2.0, 0.0)].into_iter().chain(grid).collect();
        assert_eq!(FractalLaw::of(&spheres), None);
    }

    #[test]
    fn every_part_counts_alike_for_the_error() {
        let recipe =
            Recipe { number: 10 * GROUPS, d_f: 1.8, k_f: 1.4, radii: Radii::Equal(1.0), method: Method::Clusters };
        let mut spheres = aggregate(&recipe, 1, &Interrupt::default()).expect("an aggregate");
        let law = FractalLaw::of(&spheres).expect("enough spheres");
        for _ in 1..GROUPS {
            spheres.rotate_left(1);
            let turned = FractalLaw::of(&spheres).expect("enough spheres");
            assert!((turned.error / law.error - 1.0).abs() < 1e-9, "{turned:?} {law:?}");
        }
    }
}
