//! Eigenvalues and eigenvectors of small symmetric matrices, by Jacobi's rotations. A library's solver would take whatever instructions the
//! processor has, and the last bits would be another machine's.

/// Rounds over all pairs of axes; each, once the matrix is nearly diagonal, squares what is left beside the diagonal.
const ROUNDS: usize = 10;

/// The eigenvalues of a symmetric matrix. `turned(i, j, c, s)` is told every rotation on the way: of the axes `i` and `j`, by an angle with cosine `c` and sine `s`.
pub fn eigenvalues<const N: usize>(mut a: [[f64; N]; N], mut turned: impl FnMut(usize, usize, f64, f64)) -> [f64; N] {
    for _ in 0..ROUNDS {
        for (i, j) in pairs::<N>() {
            let off = a[i][j];
            if off == 0.0 {
                continue;
            }
            let cotangent = (a[j][j] - a[i][i]) / (2.0 * off);
            let tangent = f64::copysign(1.0, cotangent) / (cotangent.abs() + (cotangent * cotangent + 1.0).sqrt());
            let c = 1.0 / (tangent * tangent + 1.0).sqrt();
            let s = tangent * c;
            for k in 0..N {
                (a[i][k], a[j][k]) = (a[i][k] * c - a[j][k] * s, a[i][k] * s + a[j][k] * c);
            }
            for k in 0..N {
                (a[k][i], a[k][j]) = (a[k][i] * c - a[k][j] * s, a[k][i] * s + a[k][j] * c);
            }
            (a[i][j], a[j][i]) = (0.0, 0.0);
            turned(i, j, c, s);
        }
    }
    std::array::from_fn(|k| a[k][k])
}

/// Eigenvalues, and the eigenvectors of length one in the rows of a matrix, in the same order.
pub fn eigenvectors<const N: usize>(a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut axes: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    let values = eigenvalues(a, |i, j, c, s| {
        for k in 0..N {
            (axes[i][k], axes[j][k]) = (axes[i][k] * c - axes[j][k] * s, axes[i][k] * s + axes[j][k] * c);
        }
    });
    (values, axes)
}

/// Every pair of axes once.
fn pairs<const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    let twice_too_often = |stride: usize| 2 * stride == N;
    (1..=N / 2).flat_map(move |stride| {
        let first = 0..if twice_too_often(stride) { stride } else { N };
        first.map(move |i| (i, (i + stride) % N))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::{Mat, Side};
    use proptest::prelude::*;

    #[test]
    fn every_pair_of_axes_comes_once() {
        assert_eq!(pairs::<3>().collect::<Vec<_>>(), [(0, 1), (1, 2), (2, 0)]);
        assert_eq!(pairs::<4>().collect::<Vec<_>>(), [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3)]);
    }

    proptest! {
        #[test]
        fn values_and_vectors_are_those_of_the_matrix_and_of_faer(numbers in prop::array::uniform16(-1.0..1.0f64)) {
            let a: [[f64; 4]; 4] =
                std::array::from_fn(|i| std::array::from_fn(|j| numbers[4 * i.min(j) + i.max(j)]));
            let (values, axes) = eigenvectors(a);
            for (value, axis) in values.iter().zip(&axes) {
                for i in 0..4 {
                    let image: f64 = (0..4).map(|j| a[i][j] * axis[j]).sum();
                    prop_assert!((image - value * axis[i]).abs() < 1e-14 * 4.0);
                }
                prop_assert!((axis.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14);
            }
            let mut sorted = values;
            sorted.sort_by(f64::total_cmp);
            let known = Mat::from_fn(4, 4, |i, j| a[i][j]).self_adjoint_eigenvalues(Side::Lower).unwrap();
            prop_assert!((0..4).all(|k| (known[k] - sorted[k]).abs() < 1e-14 * 4.0));
        }
    }
}
