//! Principal axes.

use super::jacobi::eigenvalues;
use crate::spec::mechanics::quaternion::product;
use crate::spec::{Tensor, Vec3};

/// Principal moments of an inertia tensor and the orientation of its principal axes.
pub fn principal(inertia: Tensor<f64>) -> (Vec3<f64>, f64, Vec3<f64>) {
    let (mut q_0, mut q) = (1.0, Vec3::zero());
    let moments = eigenvalues(inertia.map(|row| row.0), |i, j, c, s| {
        let half = (0.5 * (1.0 + c)).sqrt();
        let mut e = Vec3::zero();
        e.0[3 - i - j] = -0.5 * s / half;
        (q_0, q) = product(q_0, q, half, e);
    });
    let scale = 1.0 / (q_0 * q_0 + q.dot(q)).sqrt();
    (Vec3(moments), q_0 * scale, q * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::mechanics::body_inertia::member_inertia;
    use crate::spec::mechanics::rotation::to_space;
    use faer::{Mat, Side};
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn moments_are_the_eigenvalues_and_axes_the_eigenvectors_of_the_tensor(a in vector(), b in vector(), c in vector()) {
            let mut tensor = [Vec3::zero(); 3];
            for (m, r, x) in [(1.0, 0.2, a), (2.0, 0.3, b), (0.5, 0.1, c)] {
                let part = member_inertia(m, r, x);
                tensor = std::array::from_fn(|row| tensor[row] + part[row]);
            }
            let (moments, q_0, q) = principal(tensor);
            for k in 0..3 {
                let mut e = Vec3::zero();
                e.0[k] = 1.0;
                let axis = to_space(q_0, q, e);
                let image = Vec3(tensor.map(|row| row.dot(axis)));
                prop_assert!((image - axis * moments.0[k]).norm() < 1e-13, "{image:?}");
            }
            let mut sorted = moments.0;
            sorted.sort_by(f64::total_cmp);
            let matrix = Mat::from_fn(3, 3, |row, column| tensor[row].0[column]);
            let known = matrix.self_adjoint_eigenvalues(Side::Lower).unwrap();
            prop_assert!((0..3).all(|k| (known[k] - sorted[k]).abs() < 1e-13));
        }
    }
}
