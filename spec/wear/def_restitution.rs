//! Exact relations between damping and restitution.

use crate::equation::Equation;
use crate::{Real, equation};

/// The smallest double above zero.
const SMALLEST: f64 = f64::from_bits(1);

/// **Appendix A.1.2**, unnumbered: damping ratio of a spring and a dashpot in parallel.
///
/// ```math
/// \zeta = \frac{c}{2 \sqrt{k m_{\mathrm{eff}}}}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `c` | $c$ | kg/s | >= 0 | damping factor |
/// | `k` | $k$ | N/m | > 0 | stiffness |
/// | `m_eff` | $m_{\mathrm{eff}}$ | kg | > 0 | effective mass |
/// | → `zeta` | $\zeta$ | 1 | | damping ratio |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `one_for_the_critical_damping_of_a_pair`
#[inline(always)]
pub fn damping_ratio_of<R: Real>(c: R, k: R, m_eff: R) -> R {
    c / (R::lit(2.0) * (k * m_eff).sqrt())
}

/// **Appendix A.2**, unnumbered: exact restitution coefficient for a given damping ratio (A.42).
///
/// ```math
/// \eta = e^{-\pi \zeta / \sqrt{1 - \zeta^2}}
/// ```
///
/// # Reading
///
/// The contact ends when the particles stop touching, as in the paper, not when the force vanishes.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `zeta` | $\zeta$ | 1 | [0, 1) | damping ratio |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `everything_comes_back_without_damping`
/// * `less_comes_back_the_stronger_the_damping`
/// * `is_what_an_integrated_collision_gives`
#[inline(always)]
pub fn restitution<R: Real>(zeta: R) -> R {
    let one = R::one();
    (-R::pi() * zeta / ((one - zeta) * (one + zeta)).sqrt()).exp()
}

/// **Appendix A.2**, unnumbered: exact damping ratio for a desired restitution coefficient.
///
/// ```math
/// \zeta = \frac{-\ln \eta}{\sqrt{\pi^2 + \ln^2 \eta}}
/// ```
///
/// # Reading
///
/// Its limit for $\eta = 0$ is critical damping, $\zeta = 1$, at which A.42 lets nothing come back.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | desired restitution coefficient |
/// | → `zeta` | $\zeta$ | 1 | | damping ratio |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `inverts_the_restitution`
/// * `approaches_eq_12_for_weak_damping`
/// * `nothing_comes_back_of_critical_damping`
#[inline(always)]
pub fn damping_ratio<R: Real>(eta: R) -> R {
    let log = eta.max(R::lit(SMALLEST)).ln();
    R::select(eta.gt(R::zero()), -log / (R::pi().squared() + log.squared()).sqrt(), R::one())
}

/// **Appendix A.2**, unnumbered: exact damping factor for a desired restitution coefficient.
///
/// ```math
/// c = 2 \zeta(\eta) \sqrt{k m_{\mathrm{eff}}}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | desired restitution coefficient |
/// | `k` | $k$ | N/m | >= 0 | stiffness |
/// | `m_eff` | $m_{\mathrm{eff}}$ | kg | > 0 | effective mass |
/// | → `c` | $c$ | kg/s | | damping factor |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `gives_the_wanted_restitution`
/// * `nothing_comes_back_of_critical_damping`
#[inline(always)]
pub fn exact_damping<R: Real>(eta: R, k: R, m_eff: R) -> R {
    R::lit(2.0) * damping_ratio(eta) * (k * m_eff).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/def_restitution.rs", "wear-damping-ratio", [], damping_ratio_of),
        equation!("wear/def_restitution.rs", "wear-restitution", [], restitution),
        equation!("wear/def_restitution.rs", "wear-damping-ratio-exact", [], damping_ratio),
        equation!("wear/def_restitution.rs", "wear-damping-exact", [], exact_damping),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::wear::a19_critical_damping::critical_pair_damping;
    use crate::wear::a42_restitution::pair_restitution;
    use crate::wear::eq12_normal_damping::normal_damping;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn one_for_the_critical_damping_of_a_pair(k in 0.1..10.0, m in 0.1..10.0f64) {
            let c_c = f64::sqrt(2.0 * k * m);
            prop_assert!(relative_eq!(damping_ratio_of(c_c, k, effective_mass(m, m)), 1.0, max_relative = 1e-14));
        }

        #[test]
        fn less_comes_back_the_stronger_the_damping(zeta in 0.0..0.95, more in 0.001..0.04) {
            prop_assert!(restitution(zeta + more) < restitution(zeta));
        }

        #[test]
        fn inverts_the_restitution(eta in 0.05..0.999) {
            prop_assert!(relative_eq!(restitution(damping_ratio(eta)), eta, max_relative = 1e-13));
        }

        #[test]
        fn approaches_eq_12_for_weak_damping(loss in 1e-6..0.1f64) {
            let (exact, printed) = (exact_damping(1.0 - loss, 1.0, 1.0), normal_damping(1.0 - loss, 1.0, 1.0));
            prop_assert!(exact > printed && exact - printed <= loss * printed);
        }

        #[test]
        fn nothing_comes_back_of_critical_damping(k in 0.1..10.0, m in 0.1..10.0f64) {
            prop_assert_eq!(damping_ratio(0.0), 1.0);
            let (c, m_eff) = (exact_damping(0.0, k, effective_mass(m, m)), effective_mass(m, m));
            prop_assert!(relative_eq!(c, critical_pair_damping(k, m_eff), max_relative = 1e-15));
            prop_assert_eq!(pair_restitution(k, m_eff, c.next_up()), 0.0);
            // the limit is approached like the inverse square of the logarithm
            let (tiny, smallest) = (damping_ratio(1e-300), damping_ratio(SMALLEST));
            prop_assert!(0.9999 < tiny && tiny < smallest && smallest < 1.0);
        }

        #[test]
        fn gives_the_wanted_restitution(eta in 0.05..0.999, k in 0.1..10.0, m_eff in 0.1..10.0) {
            let zeta = damping_ratio_of(exact_damping(eta, k, m_eff), k, m_eff);
            prop_assert!(relative_eq!(restitution(zeta), eta, max_relative = 1e-13));
        }
    }

    #[test]
    fn everything_comes_back_without_damping() {
        assert_eq!(restitution(0.0), 1.0);
    }

    #[test]
    fn is_what_an_integrated_collision_gives() {
        // Unit mass on a unit spring, integrated by the classical Runge-Kutta method from first to last touch.
        let zeta = 0.3f64;
        let slope = |(x, v): (f64, f64)| (v, -x - 2.0 * zeta * v);
        let add = |(x, v): (f64, f64), (a, b): (f64, f64), h: f64| (x + h * a, v + h * b);
        let steps = 2000;
        let dt = std::f64::consts::PI / (1.0 - zeta * zeta).sqrt() / f64::from(steps);
        let mut now = (0.0, -1.0);
        for _ in 0..steps {
            let a = slope(now);
            let b = slope(add(now, a, 0.5 * dt));
            let c = slope(add(now, b, 0.5 * dt));
            let d = slope(add(now, c, dt));
            for (k, weight) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
                now = add(now, k, weight * dt / 6.0);
            }
        }
        assert!(now.0.abs() < 1e-12);
        assert!((now.1 - restitution(zeta)).abs() < 1e-12);
    }
}
