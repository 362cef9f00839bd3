//! Principal axes.

use crate::spec::mechanics::quaternion::product;
use crate::spec::{Tensor, Vec3};

/// Principal moments of an inertia tensor and the orientation of its principal axes, by Jacobi's rotations. A library's solver
/// would take whatever instructions the processor has, and the axes of a round body would be another machine's.
pub fn principal(mut inertia: Tensor<f64>) -> (Vec3<f64>, f64, Vec3<f64>) {
    let (mut q_0, mut q) = (1.0, Vec3::zero());
    for turn in 0..TURNS {
        let (i, j, axis) = (turn % 3, (turn + 1) % 3, (turn + 2) % 3);
        let off = inertia[i].0[j];
        if off == 0.0 {
            continue;
        }
        let cotangent = (inertia[j].0[j] - inertia[i].0[i]) / (2.0 * off);
        let tangent = f64::copysign(1.0, cotangent) / (cotangent.abs() + (cotangent * cotangent + 1.0).sqrt());
        let c = 1.0 / (tangent * tangent + 1.0).sqrt();
        let s = tangent * c;
        let rows = |t: Tensor<f64>| {
            let mut turned = t;
            (turned[i], turned[j]) = (t[i] * c - t[j] * s, t[i] * s + t[j] * c);
            turned
        };
        let transposed = |t: Tensor<f64>| std::array::from_fn(|k| Vec3(t.map(|row| row.0[k])));
        inertia = transposed(rows(transposed(rows(inertia))));
        (inertia[i].0[j], inertia[j].0[i]) = (0.0, 0.0);
        let half = (0.5 * (1.0 + c)).sqrt();
        let mut e = Vec3::zero();
        e.0[axis] = -0.5 * s / half;
        (q_0, q) = product(q_0, q, half, e);
    }
    let scale = 1.0 / (q_0 * q_0 + q.dot(q)).sqrt();
    (Vec3(std::array::from_fn(|k| inertia[k].0[k])), q_0 * scale, q * scale)
}

/// Rotations in turn about three axes; each round of three squares what is left beside the diagonal.
const TURNS: usize = 30;

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
