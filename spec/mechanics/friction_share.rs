//! Friction of several contacts on one body.

use crate::equation::Equation;
use crate::{Real, equation};

/// Share of the moment of inertia of a body that is assigned to one of several contacts.
///
/// ```math
/// I_c = \frac{I}{\max(n, 1)}
/// ```
///
/// # Reading
///
/// Friction may stop a rotating body, but not reverse it. Each contact may at most stop a body of this smaller inertia; all of them together
/// then stop the whole. For a non-spherical body $I$ is the smallest principal moment.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia of the body |
/// | `n` | $n$ | 1 | >= 0 | number of its contacts |
/// | → `share` | $I_c$ | kg m^2 | | moment of inertia for one contact |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `contacts_that_each_stop_their_share_stop_the_body`
#[inline(always)]
pub fn inertia_share<R: Real>(i: R, n: R) -> R {
    i / n.max(R::one())
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/friction_share.rs", "mechanics-inertia-share", [], inertia_share)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn contacts_that_each_stop_their_share_stop_the_body(i in 0.1..10.0f64, n in 0..20u8, omega in -3.0..3.0f64) {
            let impulse = inertia_share(i, f64::from(n)) * omega;
            let left = omega - f64::from(n) * impulse / i;
            let turning_still = f64::from(u8::from(n == 0)) * omega;
            prop_assert!((left - turning_still).abs() < 1e-14);
        }
    }
}
