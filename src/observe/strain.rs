//! The homogeneous deformation that is nearest to what a sample did.

use crate::spec::{Tensor, Vec3};
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// Gradient of the displacement, rows first, from `u = u_0 + gradient x` by least squares over all points; none when the points do not
/// span space.
pub fn displacement_gradient(before: &[Vec3<f64>], after: &[Vec3<f64>]) -> Option<Tensor<f64>> {
    if before.len() < 4 {
        return None;
    }
    let middle = before.iter().fold(Vec3::zero(), |sum, &x| sum + x) * (1.0 / before.len() as f64);
    let design = Mat::from_fn(before.len(), 4, |i, k| if k == 3 { 1.0 } else { (before[i] - middle).0[k] });
    let moved = Mat::from_fn(before.len(), 3, |i, k| (after[i] - before[i]).0[k]);
    let fit = design.qr().solve_lstsq(moved);
    let gradient: Tensor<f64> = std::array::from_fn(|row| Vec3(std::array::from_fn(|column| fit[(column, row)])));
    gradient.iter().all(|row| row.norm().is_finite()).then_some(gradient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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

    #[test]
    fn three_points_do_not_span_space() {
        assert!(displacement_gradient(&[Vec3::zero(); 3], &[Vec3::zero(); 3]).is_none());
    }
}
