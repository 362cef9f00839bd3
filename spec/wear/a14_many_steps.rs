//! Many steps at once: powers of the amplification matrix, bounded only below the critical step.

use super::a11_scaled_step::{amplification_matrix, amplify};
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.14**, Appendix A.1.1: the state after `n` steps.
///
/// ```math
/// \mathbf p_n = A^n \mathbf p_0
/// ```
///
/// # Reading
///
/// As printed, with the power of A.15; `n` is truncated to an integer.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | `n` | $n$ | 1 | [0, 4294967295] | number of steps |
/// | `x_0` | $\hat x_0$ | 1 | any | scaled separation at the start |
/// | `v_0` | $\hat v_0$ | 1 | any | scaled rate of separation at the start |
/// | → `x` | $\hat x_n$ | 1 | | scaled separation |
/// | → `v` | $\hat v_n$ | 1 | | scaled rate of separation |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `is_as_many_single_steps`
/// * `bounded_below_the_limit`
/// * `grows_linearly_at_the_limit`
/// * `grows_exponentially_above_the_limit`
#[inline(always)]
pub fn state_after<R: Real>(h: R, n: R, x_0: R, v_0: R) -> (R, R) {
    let (a, b, c, d) = amplification_power(h, n);
    amplify(a, b, c, d, x_0, v_0)
}

/// **Eq. A.15**, Appendix A.1.1: power of the amplification matrix.
///
/// ```math
/// A^n = Q \Lambda^n Q^{-1}
/// ```
///
/// # Reading
///
/// Computed by squaring: the binary digits of `n` select the factors among `A, A^2, A^4, ...`. The eigendecomposition
/// does not exist at a scaled step of two, where both eigenvalues are -1 and there is only one eigenvector; squaring
/// works there too. `n` is truncated to an integer.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | `n` | $n$ | 1 | [0, 4294967295] | number of steps |
/// | → `a_xx` | $(A^n)_{11}$ | 1 | | position from position |
/// | → `a_xv` | $(A^n)_{12}$ | 1 | | position from velocity |
/// | → `a_vx` | $(A^n)_{21}$ | 1 | | velocity from position |
/// | → `a_vv` | $(A^n)_{22}$ | 1 | | velocity from velocity |
///
/// Rounding: at most 12 ULP.
///
/// # Laws
///
/// * `is_the_eigendecomposition_where_there_is_one`
/// * `six_half_critical_steps_return`
/// * `four_steps_of_root_two_return`
#[inline]
pub fn amplification_power<R: Real>(h: R, n: R) -> (R, R, R, R) {
    let (zero, one) = (R::zero(), R::one());
    let mut power = (one, zero, zero, one);
    let mut square = amplification_matrix(h);
    let mut digits = n.floor();
    for _ in 0..32 {
        let shifted = (digits / R::lit(2.0)).floor();
        let odd = digits.gt(shifted + shifted);
        let next = product(square, power);
        power = (
            R::select(odd, next.0, power.0),
            R::select(odd, next.1, power.1),
            R::select(odd, next.2, power.2),
            R::select(odd, next.3, power.3),
        );
        square = product(square, square);
        digits = shifted;
    }
    power
}

/// Product of two matrices, row by row: `a` applied to both columns of `b`.
#[inline(always)]
fn product<R: Real>(a: (R, R, R, R), b: (R, R, R, R)) -> (R, R, R, R) {
    let (xx, vx) = amplify(a.0, a.1, a.2, a.3, b.0, b.2);
    let (xv, vv) = amplify(a.0, a.1, a.2, a.3, b.1, b.3);
    (xx, xv, vx, vv)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a14_many_steps.rs", "wear-A14", ["A14"], state_after),
        equation!("wear/a14_many_steps.rs", "wear-A15", ["A15"], amplification_power),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a07_scaled_variables::scaled_energy;
    use crate::wear::a11_scaled_step::scaled_step;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use faer::mat;
    use proptest::prelude::*;

    /// Energy relative to its initial value, `n` steps after a start at phase `angle`.
    fn energy_after(h: f64, n: u32, angle: f64) -> f64 {
        let (x, v) = state_after(h, f64::from(n), angle.cos(), angle.sin());
        scaled_energy(x, v)
    }

    proptest! {
        #[test]
        fn is_as_many_single_steps(h in 0.0..1.9, n in 0u32..200, x in -1.0..1.0, v in -1.0..1.0) {
            let mut state = (v, x);
            for _ in 0..n {
                state = scaled_step(h, state.1, state.0);
            }
            let (x_n, v_n) = state_after(h, f64::from(n), x, v);
            // The rounding of two hundred steps stays below this.
            assert_abs_diff_eq!(v_n, state.0, epsilon = 1e-11);
            assert_abs_diff_eq!(x_n, state.1, epsilon = 1e-11);
        }

        #[test]
        fn bounded_below_the_limit(h in 0.0..1.99, n in 0u32..1_000_000, angle in 0.0..6.3) {
            let bound = (1.0 + h / 2.0) / (1.0 - h / 2.0);
            // The rounding of a million steps stays below the last factor.
            prop_assert!(energy_after(h, n, angle) <= bound * (1.0 + 1e-7));
        }

        /// `A^n = (-1)^n (I - n (A + I))`: integers, hence exact.
        #[test]
        fn grows_linearly_at_the_limit(n in 0u32..1_000_000) {
            let (steps, sign) = (f64::from(n), if n % 2 == 0 { 1.0 } else { -1.0 });
            let power = amplification_power(2.0, steps);
            let [up, down] = [1.0 + 2.0 * steps, 1.0 - 2.0 * steps].map(|entry| sign * entry);
            prop_assert_eq!(power, (up, -sign * 2.0 * steps, sign * 2.0 * steps, down));
        }

        #[test]
        fn grows_exponentially_above_the_limit(excess in 0.01f64..1.0, angle in 0.1..1.5) {
            let h = 2.0 + excess;
            let growth = energy_after(h, 101, angle) / energy_after(h, 100, angle);
            let eigenvalue = -((h + (h * h - 4.0).sqrt()) / 2.0).powi(2);
            assert_relative_eq!(growth, eigenvalue.powi(2), epsilon = 0.0, max_relative = 1e-10);
        }

        #[test]
        fn is_the_eigendecomposition_where_there_is_one(
            (h, n) in (prop_oneof![0.1f64..1.9, 2.1f64..3.0], 0u32..40),
        ) {
            let (a, b, c, d) = amplification_matrix(h);
            let decomposition = mat![[a, b], [c, d]].eigen().expect("a matrix of finite numbers");
            let (q, lambda) = (decomposition.U(), decomposition.S().column_vector());
            prop_assert!((q[(0, 0)] * q[(1, 1)] - q[(0, 1)] * q[(1, 0)]).norm() > 0.01, "Q has no inverse");
            // A^n Q = Q Lambda^n, one column after the other
            let (xx, xv, vx, vv) = amplification_power(h, f64::from(n));
            let largest = 1e-12 * (xx.abs() + xv.abs() + vx.abs() + vv.abs());
            for j in 0..2 {
                let (x, v, power) = (q[(0, j)], q[(1, j)], lambda[j].powu(n));
                prop_assert!((x * xx + v * xv - power * x).norm() <= largest);
                prop_assert!((x * vx + v * vv - power * v).norm() <= largest);
            }
        }
    }

    #[test]
    fn six_half_critical_steps_return() {
        assert_eq!(amplification_power(1.0, 6.0), (1.0, 0.0, 0.0, 1.0));
        assert_eq!(amplification_power(1.0, 3.0), (-1.0, 0.0, 0.0, -1.0));
        // the largest number of steps is a multiple of three, and odd; of a broken one the whole part counts
        assert_eq!(amplification_power(1.0, 4_294_967_295.0), (-1.0, 0.0, 0.0, -1.0));
        assert_eq!(amplification_power(1.0, 6.75), (1.0, 0.0, 0.0, 1.0));
    }

    #[test]
    fn four_steps_of_root_two_return() {
        let (xx, xv, vx, vv) = amplification_power(2f64.sqrt(), 4.0);
        for (entry, identity) in [(xx, 1.0), (xv, 0.0), (vx, 0.0), (vv, 1.0)] {
            assert_abs_diff_eq!(entry, identity, epsilon = 8.0 * f64::EPSILON);
        }
    }
}
