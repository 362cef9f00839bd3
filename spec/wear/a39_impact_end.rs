//! The end of an impact: its duration and the velocity of separation.

use super::a19_critical_damping::critical_pair_damping;
use super::a35_impact::impact_velocity;
use super::a37_frequency::damped_frequency;
use super::a42_restitution::pair_restitution;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Unnumbered**, before Eq. A.39: duration of an impact.
///
/// ```math
/// t_f = \frac{\pi}{\omega}
/// ```
///
/// # Reading
///
/// "Approximately", according to the paper; it is exact with the damped frequency if the impact ends when the spheres stop
/// touching.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega` | $\omega$ | rad/s | > 0 | damped frequency |
/// | → `t_f` | $t_f$ | s | | duration of the impact |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_spheres_just_touch_after_it`
#[inline(always)]
pub fn impact_duration<R: Real>(omega: R) -> R {
    R::pi() / omega
}

/// **Eq. A.39**, Appendix A.2: rate of separation after the impact.
///
/// ```math
/// v_f = \dot x(t_f)
/// ```
///
/// # Reading
///
/// As printed, with A.36. At and beyond critical damping the spheres never separate, and the value is zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `v_0` | $v_0$ | m/s | any | rate of separation before the impact |
/// | → `v_f` | $v_f$ | m/s | | rate of separation after the impact |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_closed_form_is_the_velocity_at_the_end`
/// * `without_return_the_final_velocity_is_zero`
#[inline(always)]
pub fn velocity_at_the_end<R: Real>(k_n: R, m_eff: R, c_n: R, v_0: R) -> R {
    let t_f = impact_duration(damped_frequency(k_n, m_eff, c_n));
    let parts = c_n.lt(critical_pair_damping(k_n, m_eff));
    R::select(parts, impact_velocity(k_n, m_eff, c_n, v_0, t_f), R::zero())
}

/// **Eq. A.40**, Appendix A.2: the same in closed form.
///
/// ```math
/// v_f = v_0 e^{-\frac{\pi c_N}{2 \omega m_{\text{eff}}}}
/// ```
///
/// # Reading
///
/// Erratum: the minus sign is missing. The spheres separate in the direction from which they came:
/// $v_f = -v_0 e^{-\pi c_N / 2 \omega m_{\text{eff}}}$.
///
/// Effect: as printed the spheres would leave the impact through each other.
///
/// Proof: `the_velocity_turns_round`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `v_0` | $v_0$ | m/s | any | rate of separation before the impact |
/// | → `v_f` | $v_f$ | m/s | | rate of separation after the impact |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_closed_form_is_the_velocity_at_the_end`
/// * `the_velocity_turns_round`
#[inline(always)]
pub fn final_velocity<R: Real>(k_n: R, m_eff: R, c_n: R, v_0: R) -> R {
    -v_0 * pair_restitution(k_n, m_eff, c_n)
}

/// **Eq. A.41**, Appendix A.2: restitution coefficient.
///
/// ```math
/// \eta = \frac{v_0}{v_f}
/// ```
///
/// # Reading
///
/// Erratum: the ratio is upside down. Section 2.2 defines it as final over initial velocity, and A.42 is below one:
/// $\eta = -v_f / v_0$, with the minus sign of A.40.
///
/// Effect: as printed the ratio is above one; an impact would create energy.
///
/// Proof: `is_final_over_initial_velocity`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_0` | $v_0$ | m/s | > 0 | rate of separation before the impact |
/// | `v_f` | $v_f$ | m/s | any | rate of separation after the impact |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_final_over_initial_velocity`
#[inline(always)]
pub fn velocity_ratio<R: Real>(v_0: R, v_f: R) -> R {
    -v_f / v_0
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a39_impact_end.rs", "wear-impact-duration", [], impact_duration),
        equation!("wear/a39_impact_end.rs", "wear-A39", ["A39"], velocity_at_the_end),
        equation!("wear/a39_impact_end.rs", "wear-A40", ["A40"], final_velocity),
        equation!("wear/a39_impact_end.rs", "wear-A41", ["A41"], velocity_ratio),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a35_impact::impact_separation;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    prop_compose! {
        /// Stiffness, mass and a damping below the critical one.
        fn underdamped()((k, m) in (0.5..2.0, 0.5..2.0), zeta in 0.0..0.9) -> (f64, f64, f64) {
            (k, m, zeta * critical_pair_damping(k, m))
        }
    }

    proptest! {
        #[test]
        fn the_spheres_just_touch_after_it((k, m, c) in underdamped()) {
            let t_f = impact_duration(damped_frequency(k, m, c));
            assert_abs_diff_eq!(impact_separation(k, m, c, 1.0, t_f), 0.0, epsilon = 32.0 * f64::EPSILON);
            prop_assert!(t_f > 0.0 && impact_separation(k, m, c, 1.0, 0.5 * t_f).abs() > 0.02);
        }

        #[test]
        fn the_closed_form_is_the_velocity_at_the_end((k, m, c) in underdamped(), v_0 in -2.0..2.0) {
            let at_the_end = velocity_at_the_end(k, m, c, v_0);
            assert_abs_diff_eq!(final_velocity(k, m, c, v_0), at_the_end, epsilon = 32.0 * f64::EPSILON);
        }

        /// A.40 as printed does not reverse the velocity and fails here.
        #[test]
        fn the_velocity_turns_round((k, m, c) in underdamped(), v_0 in 0.1..2.0) {
            prop_assert!(final_velocity(k, m, c, v_0) < 0.0 && velocity_at_the_end(k, m, c, v_0) < 0.0);
            prop_assert!(final_velocity(k, m, c, -v_0) > 0.0);
        }

        /// A.41 as printed is the reciprocal, above one, and fails here.
        #[test]
        fn is_final_over_initial_velocity((k, m, c) in underdamped(), v_0 in 0.1..2.0) {
            let eta = velocity_ratio(v_0, final_velocity(k, m, c, v_0));
            assert_relative_eq!(eta, pair_restitution(k, m, c), epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
            prop_assert!(eta <= 1.0);
        }

        #[test]
        fn without_return_the_final_velocity_is_zero(zeta in 1.0..5.0, v_0 in 0.1..2.0) {
            prop_assert_eq!(velocity_at_the_end(1.0, 1.0, 2.0 * zeta, v_0), 0.0);
            prop_assert_eq!(final_velocity(1.0, 1.0, 2.0 * zeta, v_0), 0.0);
        }
    }
}
