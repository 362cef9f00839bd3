//! The scaled step, its matrix, and its invariant.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.11**, Appendix A.1.1: the step of A.5 in scaled variables.
///
/// ```math
/// \hat v_{n+1} = \hat v_n - \hat{\Delta t}\, \hat x_n, \qquad
/// \hat x_{n+1} = (1 - \hat{\Delta t}^2)\, \hat x_n + \hat{\Delta t}\, \hat v_n
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | `x` | $\hat x_n$ | 1 | any | scaled separation |
/// | `v` | $\hat v_n$ | 1 | any | scaled rate of separation |
/// | → `v_next` | $\hat v_{n+1}$ | 1 | | scaled rate of separation after the step |
/// | → `x_next` | $\hat x_{n+1}$ | 1 | | scaled separation after the step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_time_step_in_scaled_variables`
#[inline(always)]
pub fn scaled_step<R: Real>(h: R, x: R, v: R) -> (R, R) {
    (v - h * x, (R::one() - h.squared()) * x + h * v)
}

/// **Eq. A.12**, Appendix A.1.1: the amplification matrix.
///
/// ```math
/// \begin{bmatrix} \hat x_{n+1} \\ \hat v_{n+1} \end{bmatrix} =
/// \begin{bmatrix} 1 - \hat{\Delta t}^2 & \hat{\Delta t} \\ -\hat{\Delta t} & 1 \end{bmatrix}
/// \begin{bmatrix} \hat x_n \\ \hat v_n \end{bmatrix}
/// ```
///
/// # Reading
///
/// The matrix, row by row. The state is ordered position first, while A.11 computes the velocity first.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | → `a_xx` | $A_{11}$ | 1 | | position from position |
/// | → `a_xv` | $A_{12}$ | 1 | | position from velocity |
/// | → `a_vx` | $A_{21}$ | 1 | | velocity from position |
/// | → `a_vv` | $A_{22}$ | 1 | | velocity from velocity |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_matrix_does_the_scaled_step`
/// * `the_matrix_keeps_areas`
#[inline(always)]
pub fn amplification_matrix<R: Real>(h: R) -> (R, R, R, R) {
    (R::one() - h.squared(), h, -h, R::one())
}

/// **Eq. A.13**, Appendix A.1.1: one application of the matrix.
///
/// ```math
/// \mathbf p_{n+1} = A \mathbf p_n
/// ```
///
/// # Reading
///
/// As printed, for any matrix.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_xx` | $A_{11}$ | 1 | any | position from position |
/// | `a_xv` | $A_{12}$ | 1 | any | position from velocity |
/// | `a_vx` | $A_{21}$ | 1 | any | velocity from position |
/// | `a_vv` | $A_{22}$ | 1 | any | velocity from velocity |
/// | `x` | $\hat x_n$ | 1 | any | scaled separation |
/// | `v` | $\hat v_n$ | 1 | any | scaled rate of separation |
/// | → `x_next` | $\hat x_{n+1}$ | 1 | | scaled separation after the step |
/// | → `v_next` | $\hat v_{n+1}$ | 1 | | scaled rate of separation after the step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_matrix_does_the_scaled_step`
#[inline(always)]
pub fn amplify<R: Real>(a_xx: R, a_xv: R, a_vx: R, a_vv: R, x: R, v: R) -> (R, R) {
    (a_xx * x + a_xv * v, a_vx * x + a_vv * v)
}

/// **Unnumbered**, after Eq. A.13: the quantity that the step conserves instead of the energy.
///
/// ```math
/// I = \hat x^2 + \hat v^2 - \hat{\Delta t}\, \hat x \hat v
/// ```
///
/// # Reading
///
/// Not in the paper. Below a scaled step of two its level curves are ellipses, which bound the energy; at two they are
/// pairs of straight lines and above it hyperbolas, along which the energy grows without limit.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | `x` | $\hat x$ | 1 | any | scaled separation |
/// | `v` | $\hat v$ | 1 | any | scaled rate of separation |
/// | → `invariant` | $I$ | 1 | | conserved quantity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_step_leaves_the_invariant_unchanged`
/// * `without_a_step_it_is_twice_the_scaled_energy_and_at_two_a_square`
#[inline(always)]
pub fn step_invariant<R: Real>(h: R, x: R, v: R) -> R {
    x.squared() + v.squared() - h * x * v
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a11_scaled_step.rs", "wear-A11", ["A11"], scaled_step),
        equation!("wear/a11_scaled_step.rs", "wear-A12", ["A12"], amplification_matrix),
        equation!("wear/a11_scaled_step.rs", "wear-A13", ["A13"], amplify),
        equation!("wear/a11_scaled_step.rs", "wear-invariant", [], step_invariant),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a04_time_step::explicit_step;
    use crate::wear::a07_scaled_variables::{scaled_position, scaled_time_step, scaled_velocity};
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_time_step_in_scaled_variables(
            (k, m) in (0.5..2.0, 0.5..2.0), dt in 0.01..1.0, x in -1.0..1.0, v in -1.0..1.0,
        ) {
            let (v_next, x_next) = explicit_step(k, m, dt, x, v);
            let h = scaled_time_step(k, m, dt);
            let scaled = scaled_step(h, scaled_position(k, 1.0, x), scaled_velocity(m, 1.0, v));
            assert_abs_diff_eq!(scaled.0, scaled_velocity(m, 1.0, v_next), epsilon = 32.0 * f64::EPSILON);
            assert_abs_diff_eq!(scaled.1, scaled_position(k, 1.0, x_next), epsilon = 32.0 * f64::EPSILON);
        }

        #[test]
        fn the_matrix_does_the_scaled_step(h in 0.0..4.0, x in -1.0..1.0, v in -1.0..1.0) {
            let (a, b, c, d) = amplification_matrix(h);
            let (x_next, v_next) = amplify(a, b, c, d, x, v);
            prop_assert_eq!((v_next, x_next), scaled_step(h, x, v));
        }

        #[test]
        fn the_matrix_keeps_areas(h in 0.0..4.0) {
            let (a, b, c, d) = amplification_matrix(h);
            // Sums of terms below 32.
            assert_abs_diff_eq!(a * d - b * c, 1.0, epsilon = 32.0 * f64::EPSILON);
        }

        #[test]
        fn without_a_step_it_is_twice_the_scaled_energy_and_at_two_a_square(x in -1.0..1.0f64, v in -1.0..1.0f64) {
            prop_assert_eq!(step_invariant(0.0, x, v), x * x + v * v);
            assert_abs_diff_eq!(step_invariant(2.0, x, v), (x - v) * (x - v), epsilon = 8.0 * f64::EPSILON);
        }

        #[test]
        fn a_step_leaves_the_invariant_unchanged(h in 0.0..4.0, x in -1.0..1.0, v in -1.0..1.0) {
            let (v_next, x_next) = scaled_step(h, x, v);
            // Each square in the sum stays below 400.
            assert_abs_diff_eq!(
                step_invariant(h, x_next, v_next),
                step_invariant(h, x, v),
                epsilon = 2000.0 * f64::EPSILON
            );
        }
    }
}
