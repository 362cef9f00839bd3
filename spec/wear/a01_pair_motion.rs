//! Two touching spheres on a line: their equations of motion, and the one equation of their distance.

use super::eq17_effective_mass::effective_mass;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.1**, Appendix A.1: motion of two spheres along the line of their centres.
///
/// ```math
/// m_i \ddot x_i + c_N (\dot x_i - \dot x_j) + k_N (x_i - x_j) = 0, \qquad
/// m_j \ddot x_j + c_N (\dot x_j - \dot x_i) + k_N (x_j - x_i) = 0
/// ```
///
/// # Reading
///
/// Solved for the two accelerations. The coordinates are displacements from the positions in which the spheres just
/// touch, so that `x_i - x_j` is the separation of the surfaces.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_i` | $m_i$ | kg | > 0 | mass of i |
/// | `m_j` | $m_j$ | kg | > 0 | mass of j |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `x_i` | $x_i$ | m | any | displacement of i |
/// | `x_j` | $x_j$ | m | any | displacement of j |
/// | `v_i` | $\dot x_i$ | m/s | any | velocity of i |
/// | `v_j` | $\dot x_j$ | m/s | any | velocity of j |
/// | → `a_i` | $\ddot x_i$ | m/s^2 | | acceleration of i |
/// | → `a_j` | $\ddot x_j$ | m/s^2 | | acceleration of j |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `momentum_is_conserved`
/// * `a_common_motion_goes_unnoticed`
/// * `is_the_difference_of_the_two_accelerations`
#[inline(always)]
pub fn pair_accelerations<R: Real>(m_i: R, m_j: R, c_n: R, k_n: R, x_i: R, x_j: R, v_i: R, v_j: R) -> (R, R) {
    let pull = c_n * (v_i - v_j) + k_n * (x_i - x_j);
    (-pull / m_i, pull / m_j)
}

/// **Eq. A.2**, Appendix A.1: motion of the separation.
///
/// ```math
/// m_{\text{eff}} \ddot x + c_N \dot x + k_N x = 0
/// ```
///
/// # Reading
///
/// Erratum: the paper obtains the equation "by subtracting one to the other"; that holds only after each line of A.1 has been divided by its mass.
/// The equation itself is right; here it is solved for the acceleration.
///
/// Effect: subtracted as printed, the lines do not close in `x_i - x_j` unless the masses are equal.
///
/// Proof: `subtracting_before_dividing_is_wrong_for_unequal_masses`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `x` | $x$ | m | any | separation, `x_i - x_j` |
/// | `v` | $\dot x$ | m/s | any | rate of separation |
/// | → `a` | $\ddot x$ | m/s^2 | | acceleration of the separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_difference_of_the_two_accelerations`
/// * `subtracting_before_dividing_is_wrong_for_unequal_masses`
#[inline(always)]
pub fn relative_acceleration<R: Real>(m_eff: R, c_n: R, k_n: R, x: R, v: R) -> R {
    -(c_n * v + k_n * x) / m_eff
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a01_pair_motion.rs", "wear-A1", ["A1"], pair_accelerations),
        equation!("wear/a01_pair_motion.rs", "wear-A2", ["A2"], relative_acceleration),
        equation!("mechanics/reduced_mass.rs", "wear-A3", ["A3"], effective_mass),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn momentum_is_conserved(
            (m_i, m_j) in (0.1f64..10.0, 0.1f64..10.0), (c, k) in (0.0..2.0, 0.1..10.0),
            (x_i, x_j) in (-1.0..1.0, -1.0..1.0), (v_i, v_j) in (-1.0..1.0, -1.0..1.0),
        ) {
            let (a_i, a_j) = pair_accelerations(m_i, m_j, c, k, x_i, x_j, v_i, v_j);
            assert_relative_eq!(m_i * a_i, -m_j * a_j, epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
        }

        /// Sums of eighths are exact, so rounding plays no part.
        #[test]
        fn a_common_motion_goes_unnoticed(
            (x_i, x_j) in (-8..8, -8..8), (v_i, v_j) in (-8..8, -8..8), (x, v) in (-99..99, -99..99),
        ) {
            let [x_i, x_j, v_i, v_j, x, v] = [x_i, x_j, v_i, v_j, x, v].map(|eighths| f64::from(eighths) / 8.0);
            prop_assert_eq!(
                pair_accelerations(1.0, 2.0, 0.5, 3.0, x_i + x, x_j + x, v_i + v, v_j + v),
                pair_accelerations(1.0, 2.0, 0.5, 3.0, x_i, x_j, v_i, v_j)
            );
        }

        #[test]
        fn is_the_difference_of_the_two_accelerations(
            (m_i, m_j) in (0.1f64..10.0, 0.1f64..10.0), (c, k) in (0.0..2.0, 0.1..10.0), (x, v) in (0.1..1.0, 0.0..1.0),
        ) {
            let (a_i, a_j) = pair_accelerations(m_i, m_j, c, k, x, 0.0, v, 0.0);
            let a = relative_acceleration(effective_mass(m_i, m_j), c, k, x, v);
            assert_relative_eq!(a, a_i - a_j, epsilon = 0.0, max_relative = 8.0 * f64::EPSILON);
        }

        /// Subtracted as printed, A.1 says `m_i a_i - m_j a_j = -2 (c v + k x)`; dividing by the mean mass then is
        /// wrong.
        #[test]
        fn subtracting_before_dividing_is_wrong_for_unequal_masses(m_i in 0.1..1.0, more in 0.1..10.0) {
            let m_j = m_i + more;
            let (a_i, a_j) = pair_accelerations(m_i, m_j, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0);
            assert_relative_eq!(m_i * a_i - m_j * a_j, -2.0, epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
            let printed = -2.0 / (0.5 * (m_i + m_j));
            let a = relative_acceleration(effective_mass(m_i, m_j), 0.0, 1.0, 1.0, 0.0);
            prop_assert!((a - (a_i - a_j)).abs() < 1e-12 * a.abs());
            prop_assert!((printed - (a_i - a_j)).abs() > 1e-3 * a.abs());
        }
    }
}
