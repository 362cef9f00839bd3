//! Critical damping of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.19**, Appendix A.1.2: critical damping of two spheres.
///
/// ```math
/// c_c = 2 \sqrt{k_N m_{\text{eff}}}
/// ```
///
/// # Reading
///
/// As printed: critical for the dashpot between the two spheres. For equal masses it is Eq. 21.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | → `c_c` | $c_c$ | kg/s | | critical damping |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_characteristic_roots_coincide`
/// * `equal_masses_give_equation_21`
#[inline(always)]
pub fn critical_pair_damping<R: Real>(k_n: R, m_eff: R) -> R {
    R::lit(2.0) * (k_n * m_eff).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/a19_critical_damping.rs", "wear-A19", ["A19"], critical_pair_damping)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::wear::eq21_critical_damping::critical_damping;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    proptest! {
        /// The roots of `m s^2 + c s + k` coincide where the discriminant vanishes.
        #[test]
        fn the_characteristic_roots_coincide((k, m) in (0.1..10.0, 0.1..10.0)) {
            let c: f64 = critical_pair_damping(k, m);
            assert_abs_diff_eq!(c * c / (4.0 * k * m), 1.0, epsilon = 8.0 * f64::EPSILON);
        }

        #[test]
        fn equal_masses_give_equation_21((k, m) in (0.1..10.0, 0.1..10.0)) {
            let general = critical_pair_damping(k, effective_mass(m, m));
            assert_relative_eq!(general, critical_damping(k, m), epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
        }
    }
}
