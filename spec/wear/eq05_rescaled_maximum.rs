//! The largest tangential force of spheres that do not touch.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 5**, Section 2.1: largest tangential force at a given separation.
///
/// ```math
/// F'_{m,T} = \min\left(\frac{\delta_f - \delta_N}{\delta_f}, 1\right) F_{m,T}
/// ```
///
/// # Reading
///
/// Beyond the fracture separation, where the interaction has ended, the printed value is negative; the function returns
/// zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_n` | $\delta_N$ | m | any | separation of the surfaces, negative for an overlap |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation |
/// | `f_mt` | $F_{m,T}$ | N | >= 0 | largest tangential force in contact |
/// | → `f_mt_rescaled` | $F'_{m,T}$ | N | | largest tangential force at this separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `whole_in_contact`
/// * `zero_from_the_fracture_separation_on_where_the_printed_one_is_negative`
/// * `never_grows_with_the_separation`
/// * `halves_half_way`
#[inline(always)]
pub fn rescaled_maximum<R: Real>(delta_n: R, delta_f: R, f_mt: R) -> R {
    ((delta_f - delta_n) / delta_f).min(R::one()).max(R::zero()) * f_mt
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq05_rescaled_maximum.rs", "wear-5", ["5"], rescaled_maximum)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn whole_in_contact(delta_n in -5.0..=0.0, delta_f in 0.1..2.0, f_mt in 0.0..5.0) {
            prop_assert_eq!(rescaled_maximum(delta_n, delta_f, f_mt), f_mt);
        }

        #[test]
        fn zero_from_the_fracture_separation_on_where_the_printed_one_is_negative(
            beyond in 1e-3..5.0, delta_f in 0.1..2.0f64, f_mt in 0.1..5.0,
        ) {
            let delta_n = delta_f + beyond;
            let printed = f64::min((delta_f - delta_n) / delta_f, 1.0) * f_mt;
            prop_assert!(printed < 0.0);
            prop_assert_eq!(rescaled_maximum(delta_n, delta_f, f_mt), 0.0);
            prop_assert_eq!(rescaled_maximum(delta_f, delta_f, f_mt), 0.0);
        }

        #[test]
        fn never_grows_with_the_separation(delta_n in -1.0..3.0, more in 0.0..1.0, delta_f in 0.1..2.0) {
            prop_assert!(rescaled_maximum(delta_n + more, delta_f, 1.0) <= rescaled_maximum(delta_n, delta_f, 1.0));
        }

        #[test]
        fn halves_half_way(delta_f in 0.1..2.0, f_mt in 0.1..5.0) {
            prop_assert!(relative_eq!(rescaled_maximum(0.5 * delta_f, delta_f, f_mt), 0.5 * f_mt));
        }
    }
}
