//! The damping for a given coefficient of restitution.

use super::eq12_normal_damping::normal_damping;
use super::eq13_tangential_damping::tangential_damping;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.46**, Appendix A.2: normal damping as a fraction of critical damping.
///
/// ```math
/// c_N \approx \frac{1 - \eta}{\pi} c_c
/// ```
///
/// # Reading
///
/// As printed. A.45 is Eq. 12 and A.47 is Eq. 13. All three invert A.44, so the resulting restitution, A.42, is larger than
/// the desired one, which the `exact_damping` of [`def_restitution`](super::def_restitution) gives.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | desired restitution coefficient |
/// | `c_c` | $c_c$ | kg/s | > 0 | critical damping |
/// | → `c_n` | $c_N$ | kg/s | | normal damping |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_damping_of_equation_12`
/// * `inverts_the_weaker_approximation`
/// * `the_restitution_that_comes_out_is_larger_than_wanted`
/// * `the_exact_damping_gives_the_wanted_restitution`
#[inline(always)]
pub fn damping_of_critical<R: Real>(eta: R, c_c: R) -> R {
    (R::one() - eta) / R::pi() * c_c
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq12_normal_damping.rs", "wear-A45", ["A45"], normal_damping),
        equation!("wear/a45_damping.rs", "wear-A46", ["A46"], damping_of_critical),
        equation!("wear/eq13_tangential_damping.rs", "wear-A47", ["A47"], tangential_damping),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a19_critical_damping::critical_pair_damping;
    use crate::wear::a42_restitution::{pair_restitution, weaker_restitution};
    use crate::wear::def_restitution::exact_damping;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_damping_of_equation_12((k, m) in (0.1..10.0, 0.1..10.0), eta in 0.0..1.0) {
            let c = damping_of_critical(eta, critical_pair_damping(k, m));
            assert_relative_eq!(c, normal_damping(eta, k, m), epsilon = 0.0, max_relative = 8.0 * f64::EPSILON);
        }

        #[test]
        fn inverts_the_weaker_approximation((k, m) in (0.1..10.0, 0.1..10.0), eta in 0.0..1.0) {
            let c = damping_of_critical(eta, critical_pair_damping(k, m));
            assert_abs_diff_eq!(weaker_restitution(k, m, c), eta, epsilon = 8.0 * f64::EPSILON);
        }

        #[test]
        fn the_exact_damping_gives_the_wanted_restitution((k, m) in (0.1..10.0, 0.1..10.0), eta in 0.01..1.0) {
            let eta_out = pair_restitution(k, m, exact_damping(eta, k, m));
            // The exponent, up to 4.6, amplifies the rounding of the damping.
            assert_relative_eq!(eta_out, eta, epsilon = 0.0, max_relative = 64.0 * f64::EPSILON);
        }
    }

    #[test]
    fn the_restitution_that_comes_out_is_larger_than_wanted() {
        for (wanted, comes_out) in [(0.95, 0.95122), (0.9, 0.90479), (0.5, 0.60263), (0.0, 0.34824)] {
            let c = damping_of_critical(wanted, critical_pair_damping(1.0, 1.0));
            assert_abs_diff_eq!(pair_restitution(1.0, 1.0, c), comes_out, epsilon = 5e-6);
        }
    }
}
