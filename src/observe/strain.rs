//! The homogeneous deformation closest to the deformation of a sample.

use crate::geometry::jacobi::eigenvectors;
use crate::spec::{Tensor, Vec3};

/// Smallest squared ratio of thickness to width of a sample that spans space.
const FLAT: f64 = 1e-13;

/// Gradient of the displacement, rows first, from `u = u_0 + gradient x` by least squares over all points; none when the points do not
/// span space.
pub fn displacement_gradient(before: &[Vec3<f64>], after: &[Vec3<f64>]) -> Option<Tensor<f64>> {
    if before.len() < 4 {
        return None;
    }
    let mean = |points: &[Vec3<f64>]| points.iter().fold(Vec3::zero(), |sum, &x| sum + x) * (1.0 / points.len() as f64);
    let (middle, drift) = (mean(before), mean(after) - mean(before));
    let (mut spread, mut moved) = ([Vec3::zero(); 3], [Vec3::zero(); 3]);
    for (&from, &to) in before.iter().zip(after) {
        let (x, u) = (from - middle, to - from - drift);
        let (squares, products) = (x.outer(x), u.outer(x));
        spread = std::array::from_fn(|row| spread[row] + squares[row]);
        moved = std::array::from_fn(|row| moved[row] + products[row]);
    }
    let (widths, axes) = eigenvectors(spread.map(|row| row.0));
    let widest = widths.into_iter().fold(0.0, f64::max);
    if !widths.iter().all(|&width| width > FLAT * widest) {
        return None;
    }
    let gradient = moved.map(|row| {
        let axes = axes.iter().zip(widths).map(|(&axis, width)| (Vec3(axis), width));
        axes.fold(Vec3::zero(), |sum, (axis, width)| sum + axis * (row.dot(axis) / width))
    });
    gradient.iter().all(|row| row.norm().is_finite()).then_some(gradient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;
    use faer::linalg::solvers::SolveLstsq;
    use proptest::prelude::*;

    /// By the QR factors of the design matrix.
    fn by_factors(before: &[Vec3<f64>], after: &[Vec3<f64>]) -> Tensor<f64> {
        let design = Mat::from_fn(before.len(), 4, |i, k| if k == 3 { 1.0 } else { before[i].0[k] });
        let moved = Mat::from_fn(before.len(), 3, |i, k| (after[i] - before[i]).0[k]);
        let fit = design.qr().solve_lstsq(moved);
        std::array::from_fn(|row| Vec3(std::array::from_fn(|column| fit[(column, row)])))
    }

    proptest! {
        #[test]
        fn a_homogeneous_deformation_is_recovered(
            cloud in prop::collection::vec(prop::array::uniform3(-5.0..5.0f64), 12..40),
            g in prop::array::uniform9(-0.1..0.1f64),
            shift in prop::array::uniform3(-9.0..9.0f64),
        ) {
            let gradient: Tensor<f64> = std::array::from_fn(|row| Vec3([g[3 * row], g[3 * row + 1], g[3 * row + 2]]));
            let before: Vec<_> = cloud.into_iter().map(Vec3).collect();
            let after: Vec<_> = before.iter().map(|&x| x + Vec3(gradient.map(|row| row.dot(x))) + Vec3(shift)).collect();
            let found = displacement_gradient(&before, &after).unwrap();
            for row in 0..3 {
                prop_assert!((found[row] - gradient[row]).norm() < 1e-10, "{found:?} {gradient:?}");
            }
        }
    }

    proptest! {
        #[test]
        fn any_displacement_has_the_gradient_of_least_squares(
            cloud in prop::collection::vec(prop::array::uniform6(-5.0..5.0f64), 12..40),
        ) {
            let (before, after): (Vec<_>, Vec<_>) =
                cloud.into_iter().map(|[a, b, c, d, e, f]| (Vec3([a, b, c]), Vec3([d, e, f]))).unzip();
            let (found, known) = (displacement_gradient(&before, &after).unwrap(), by_factors(&before, &after));
            for row in 0..3 {
                prop_assert!((found[row] - known[row]).norm() < 1e-10, "{found:?} {known:?}");
            }
        }
    }

    #[test]
    fn points_of_a_plane_do_not_span_space() {
        let plane: Vec<_> = (0..20).map(|k| Vec3([f64::from(k % 5), f64::from(k / 5), 0.1])).collect();
        assert!(displacement_gradient(&plane, &plane).is_none());
    }

    #[test]
    fn three_points_do_not_span_space() {
        assert!(displacement_gradient(&[Vec3::zero(); 3], &[Vec3::zero(); 3]).is_none());
    }

    #[test]
    fn how_flat_a_sample_may_be_does_not_depend_on_its_size() {
        let found = |thickness: f64, scale: f64| {
            let at = |k: i32| [k % 3, k / 3 % 3, k / 9].map(f64::from);
            let points: Vec<_> = (0..27).map(at).map(|[x, y, z]| Vec3([x, y, thickness * z]) * scale).collect();
            displacement_gradient(&points, &points).is_some()
        };
        for scale in [1e-3, 1.0, 1e3] {
            assert_eq!([1e-6, 1e-7].map(|thickness| found(thickness, scale)), [true, false], "{scale}");
        }
    }
}
