//! An impact that ends when the force vanishes, before the contact does.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Unnumbered**, cf. Eq. A.39: duration of an impact up to the first instant of zero force.
///
/// ```math
/// t_f = \frac{2 \arccos \zeta}{\omega}
/// ```
///
/// # Reading
///
/// The paper ends the impact at the return to `x = 0` instead, where the dashpot still pulls; the total force
/// $k_N x + c_N \dot x$ vanishes earlier, where $\tan \omega t = -2 \zeta \sqrt{1 - \zeta^2} / (1 - 2 \zeta^2)$, that is at
/// $\omega t = 2 \arccos \zeta$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega` | $\omega$ | rad/s | > 0 | damped frequency |
/// | `zeta` | $\zeta$ | 1 | [0, 1) | damping ratio |
/// | → `t_f` | $t_f$ | s | | duration of the impact |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_force_vanishes_then_and_not_before`
/// * `undamped_both_ends_coincide`
#[inline(always)]
pub fn zero_force_duration<R: Real>(omega: R, zeta: R) -> R {
    R::lit(2.0) * zeta.acos() / omega
}

/// **Unnumbered**, cf. Eq. A.42: restitution coefficient of this impact.
///
/// ```math
/// \eta = e^{-2 \zeta \arccos \zeta / \sqrt{1 - \zeta^2}}
/// ```
///
/// # Reading
///
/// At that instant the velocity is exactly $-v_0 e^{-\beta t}$. The coefficient is larger than A.42, because the dashpot does not
/// pull at the end.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `zeta` | $\zeta$ | 1 | [0, 1) | damping ratio |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `is_the_velocity_at_that_end`
/// * `undamped_both_ends_coincide`
/// * `more_comes_back_than_to_the_last_touch`
#[inline(always)]
pub fn zero_force_restitution<R: Real>(zeta: R) -> R {
    let one = R::one();
    (-R::lit(2.0) * zeta * zeta.acos() / ((one - zeta) * (one + zeta)).sqrt()).exp()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/def_zero_force_end.rs", "wear-zero-force-duration", [], zero_force_duration),
        equation!("wear/def_zero_force_end.rs", "wear-zero-force-restitution", [], zero_force_restitution),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a01_pair_motion::relative_acceleration;
    use crate::wear::a35_impact::{impact_separation, impact_velocity};
    use crate::wear::a37_frequency::damped_frequency;
    use crate::wear::a39_impact_end::impact_duration;
    use crate::wear::def_restitution::restitution;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    /// Acceleration and velocity at time `t` after an impact with unit mass, stiffness and velocity.
    fn motion(zeta: f64, t: f64) -> (f64, f64) {
        let x = impact_separation(1.0, 1.0, 2.0 * zeta, 1.0, t);
        let v = impact_velocity(1.0, 1.0, 2.0 * zeta, 1.0, t);
        (relative_acceleration(1.0, 2.0 * zeta, 1.0, x, v), v)
    }
    fn end(zeta: f64) -> f64 {
        zero_force_duration(damped_frequency(1.0, 1.0, 2.0 * zeta), zeta)
    }

    proptest! {
        #[test]
        fn the_force_vanishes_then_and_not_before(zeta in 0.001..0.95, earlier in 0.01..0.99) {
            let t_f = end(zeta);
            assert_abs_diff_eq!(motion(zeta, t_f).0, 0.0, epsilon = 1e-14);
            prop_assert!(motion(zeta, earlier * t_f).0 < 0.0);
        }

        #[test]
        fn is_the_velocity_at_that_end(zeta in 0.001..0.95) {
            assert_abs_diff_eq!(-motion(zeta, end(zeta)).1, zero_force_restitution(zeta), epsilon = 1e-14);
        }

        #[test]
        fn more_comes_back_than_to_the_last_touch(zeta in 0.001..0.95) {
            prop_assert!(zero_force_restitution(zeta) > restitution(zeta));
            prop_assert!(end(zeta) < impact_duration(damped_frequency(1.0, 1.0, 2.0 * zeta)));
        }
    }

    #[test]
    fn undamped_both_ends_coincide() {
        assert_eq!(end(0.0), impact_duration(1.0));
        assert_eq!(zero_force_restitution(0.0), 1.0);
    }
}
