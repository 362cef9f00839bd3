//! The largest friction forces.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 10**, Section 2.4: largest tangential force of sliding and of rolling.
///
/// ```math
/// F_{t,max}^S = \tau_S A_{ij}; \quad F_{t,max}^R = \tau_R A_{ij}
/// ```
///
/// # Reading
///
/// As printed. The paper calls $\tau$ a shear stiffness; it is a stress.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a` | $A_{ij}$ | m^2 | >= 0 | contact area, Eq. 11 |
/// | `tau_s` | $\tau_S$ | Pa | >= 0 | shear strength of sliding, 0.65 GPa |
/// | `tau_r` | $\tau_R$ | Pa | >= 0 | shear strength of rolling, 0.25 GPa |
/// | → `f_ts` | $F_{t,max}^S$ | N | | largest force of sliding |
/// | → `f_tr` | $F_{t,max}^R$ | N | | largest force of rolling |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_proportional_to_the_area_and_not_to_the_load`
/// * `over_the_area_it_is_the_shear_strength`
#[inline(always)]
pub fn peak_friction<R: Real>(a: R, tau_s: R, tau_r: R) -> (R, R) {
    (tau_s * a, tau_r * a)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq10_peak_friction.rs", "titania-10", ["10"], peak_friction)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::eq08_repulsion::repulsion;
    use crate::titania::eq11_contact_area::contact_area;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn over_the_area_it_is_the_shear_strength(a in 0.1..10.0f64, tau_s in 0.1..10.0, tau_r in 0.1..10.0) {
            let (sliding, rolling) = peak_friction(a, tau_s, tau_r);
            prop_assert!(relative_eq!(sliding / a, tau_s, max_relative = 1e-15) && relative_eq!(rolling / a, tau_r, max_relative = 1e-15));
        }

        #[test]
        fn is_proportional_to_the_area_and_not_to_the_load(delta in 1e-5..1e-3f64) {
            // Small overlaps: the load grows with the power 3/2 of the overlap, the area with the overlap itself.
            let at = |delta: f64| {
                let (load, area) = (repulsion(24.5, delta, 4.0, 4.0, 0.36).1, contact_area(4.0, 4.0, 0.36, 8.72 - delta).0);
                (load, peak_friction(area, 0.65, 0.25))
            };
            let ((load, (sliding, rolling)), (load_8, (sliding_8, _))) = (at(delta), at(4.0 * delta));
            prop_assert!(relative_eq!(load_8, 8.0 * load, max_relative = 1e-9));
            prop_assert!(relative_eq!(sliding_8, 4.0 * sliding, max_relative = 2e-3));
            prop_assert!(rolling < sliding);
        }
    }
}
