//! Critical damping of a pair by its dashpot, and by a drag.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 21**, Section 3: critical damping of a system of two equal particles.
///
/// ```math
/// c_c = \sqrt{2 k_N m}
/// ```
///
/// # Reading
///
/// Erratum: this value is critical for the dashpot between the two particles. The paper measures its *global* damping, a drag on each particle, in
/// units of it; for a drag the critical value is [`critical_drag`], twice as large. As a unit it is used as printed.
///
/// Effect: a global damping of $0.2 c_c$ is a tenth of the critical one, not a fifth.
///
/// Proof: `a_drag_of_eq_21_lets_the_pair_overshoot`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m` | $m$ | kg | > 0 | mass of either particle |
/// | → `c_c` | $c_c$ | kg/s | | critical damping |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_dashpot_of_less_lets_the_pair_overshoot_and_of_more_does_not`
#[inline(always)]
pub fn critical_damping<R: Real>(k_n: R, m: R) -> R {
    (R::lit(2.0) * k_n * m).sqrt()
}

/// **Section 3**, unnumbered: critical coefficient of a drag on each of two equal particles.
///
/// ```math
/// c_g = 2 c_c = 2 \sqrt{2 k_N m}
/// ```
///
/// # Reading
///
/// Drags on both particles act on the separation like a dashpot of half the coefficient.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m` | $m$ | kg | > 0 | mass of either particle |
/// | → `c_g` | $c_g$ | kg/s | | critical coefficient of the drag |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_drag_of_less_lets_the_pair_overshoot_and_of_more_does_not`
/// * `a_drag_of_eq_21_lets_the_pair_overshoot`
#[inline(always)]
pub fn critical_drag<R: Real>(k_n: R, m: R) -> R {
    R::lit(2.0) * critical_damping(k_n, m)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq21_critical_damping.rs", "wear-21", ["21"], critical_damping),
        equation!("wear/eq21_critical_damping.rs", "wear-critical-drag", [], critical_drag),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Vec3;
    use crate::mechanics::drag::global_damping;
    use crate::mechanics::kick_and_drift::{drift, kick};
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::wear::def_restitution::damping_ratio_of;
    use proptest::prelude::*;

    /// Whether two equal particles released from a stretched spring cross, with a dashpot `c` between them and a `drag`
    /// on each.
    fn overshoots(k: f64, m: f64, c: f64, drag: f64) -> bool {
        let dt = 2e-3 * (m / k).sqrt();
        let along = |x: f64| Vec3::new(x, 0.0, 0.0);
        let (mut x, mut v) = ([along(0.5), along(-0.5)], [along(0.0); 2]);
        (0..20_000).any(|_| {
            let pull = (x[0] - x[1]) * k + (v[0] - v[1]) * c;
            for (i, force) in [-pull, pull].into_iter().enumerate() {
                v[i] = kick(v[i], force + global_damping(drag, v[i]), m, dt);
                x[i] = drift(x[i], v[i], dt);
            }
            x[0].0[0] < x[1].0[0]
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        #[test]
        fn a_dashpot_of_less_lets_the_pair_overshoot_and_of_more_does_not(k in 0.1..10.0f64, m in 0.1..10.0f64) {
            let c_c = critical_damping(k, m);
            prop_assert!((damping_ratio_of(c_c, k, effective_mass(m, m)) - 1.0).abs() < 1e-14);
            prop_assert!(overshoots(k, m, 0.95 * c_c, 0.0));
            prop_assert!(!overshoots(k, m, 1.05 * c_c, 0.0));
        }

        #[test]
        fn a_drag_of_less_lets_the_pair_overshoot_and_of_more_does_not(k in 0.1..10.0f64, m in 0.1..10.0f64) {
            let c_g = critical_drag(k, m);
            // opposed to each other, each particle has twice the stiffness of the spring: the roots of its motion coincide
            prop_assert!((c_g * c_g / (4.0 * m * 2.0 * k) - 1.0).abs() < 1e-14);
            prop_assert!(overshoots(k, m, 0.0, 0.95 * c_g));
            prop_assert!(!overshoots(k, m, 0.0, 1.05 * c_g));
        }

        #[test]
        fn a_drag_of_eq_21_lets_the_pair_overshoot(k in 0.1..10.0, m in 0.1..10.0) {
            prop_assert!(overshoots(k, m, 0.0, critical_damping(k, m)));
        }
    }
}
