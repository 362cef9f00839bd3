//! Van der Waals attraction of two equal spheres.

use super::eq18_hamaker::{hamaker_energy, hamaker_force};
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 19**, Section 2.1.4: energy of two equal spheres.
///
/// ```math
/// U = -\frac{A}{6} \left[\frac{2 r^2}{(4r + \delta) \delta} + \frac{2 r^2}{(2r + \delta)^2} + \ln \frac{(4r + \delta) \delta}{(2r + \delta)^2}\right]
/// ```
///
/// # Reading
///
/// Eq. 18 for $r_1 = r_2$, and evaluated as such.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius of both spheres |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `u` | $U$ | J | | energy, zero for spheres far apart |
///
/// Rounding: at most 2.5 ULP.
///
/// # Laws
///
/// * `equal_spheres_are_a_case_of_unequal_ones`
/// * `near_spheres_attract_as_the_inverse_gap_and_far_ones_as_its_sixth_power`
#[inline(always)]
pub fn equal_hamaker_energy<R: Real>(r: R, delta: R, a: R) -> R {
    hamaker_energy(r, r, delta, a)
}

/// **Eq. 20**, Section 2.1.4: force between two equal spheres.
///
/// ```math
/// \mathbf{f} = -\frac{A}{6} \left[\frac{4r + 2\delta}{(4r + \delta) \delta} - \frac{2}{2r + \delta} - \frac{4 r^2}{(2r + \delta)^3}
/// - \frac{2 r^2 (4r + 2\delta)}{(4r + \delta)^2 \delta^2}\right] \mathbf{n}
/// ```
///
/// # Reading
///
/// Cancellation: the printed form has no correct digit at a thousand radii. Over one denominator it is
/// $\frac{32 A r^6}{3 \delta^2 (4r + \delta)^2 (2r + \delta)^3}$, which does not cancel. It is the coefficient of the normal: positive, so that i is attracted by j.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius of both spheres |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `f` | $\mathbf{f} \cdot \mathbf{n}$ | N | | attraction |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_printed_force`
/// * `near_spheres_attract_as_the_inverse_gap_and_far_ones_as_its_sixth_power`
#[inline(always)]
pub fn equal_hamaker_force<R: Real>(r: R, delta: R, a: R) -> R {
    hamaker_force(r, r, delta, a)
}

/// **Section 2.1.4**, unnumbered: force and energy with the saturation distance.
///
/// ```math
/// f(\delta) = f(\max(\delta, \delta_0)), \quad U(\delta) = U(\max(\delta, \delta_0)) - f \cdot (\max(\delta, \delta_0) - \delta)
/// ```
///
/// # Reading
///
/// The text gives a saturation distance $\delta_0$ from 0.4 to 1 nm, but no formula. Below it the force keeps its value at $\delta_0$, also for overlapping spheres, and the
/// potential continues as a straight line: both are continuous.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_1` | $r_1$ | m | > 0 | radius of one sphere |
/// | `r_2` | $r_2$ | m | > 0 | radius of the other |
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | `delta_0` | $\delta_0$ | m | > 0 | saturation distance |
/// | → `f` | $f$ | N | | attraction |
/// | → `u` | $U$ | J | | energy |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_saturated_force_is_the_slope_of_its_energy`
/// * `force_and_energy_are_continuous_at_saturation`
#[inline(always)]
pub fn saturated_hamaker<R: Real>(r_1: R, r_2: R, delta: R, a: R, delta_0: R) -> (R, R) {
    let apart = delta.max(delta_0);
    let f = hamaker_force(r_1, r_2, apart, a);
    (f, hamaker_energy(r_1, r_2, apart, a) - f * (apart - delta))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq19_equal_hamaker.rs", "soot-19", ["19"], equal_hamaker_energy),
        equation!("soot/eq19_equal_hamaker.rs", "soot-20", ["20"], equal_hamaker_force),
        equation!("soot/eq19_equal_hamaker.rs", "soot-20-sat", [], saturated_hamaker),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equal_spheres_are_a_case_of_unequal_ones(r in 0.1..10.0, log_gap in -6.0..6.0f64, a in 0.1..10.0) {
            let [r, d, a] = [r, 10f64.powf(log_gap), a].map(Reference::exact);
            let (two, four) = (Reference::exact(2.0), Reference::exact(4.0));
            let (near, far) = ((four * r + d) * d, (two * r + d).squared());
            let printed = -(a / Reference::exact(6.0)) * (two * r * r / near + two * r * r / far + (near / far).ln());
            prop_assert!(((equal_hamaker_energy(r, d, a) - printed) / printed).abs().to_f64() < 1e-33);
        }

        #[test]
        fn is_the_printed_force(r in 0.1..10.0, log_gap in -6.0..5.0f64, a in 0.1..10.0) {
            let [r, d, a] = [r, 10f64.powf(log_gap), a].map(Reference::exact);
            let (two, four) = (Reference::exact(2.0), Reference::exact(4.0));
            let (outer, inner) = (four * r + d, two * r + d);
            let slope = four * r + two * d;
            let bracket = slope / (outer * d) - two / inner - four * r * r / (inner * inner * inner)
                - two * r * r * slope / (outer * d).squared();
            let printed = -(a / Reference::exact(6.0)) * bracket;
            prop_assert!(((equal_hamaker_force(r, d, a) - printed) / printed).abs().to_f64() < 1e-33);
        }

        #[test]
        fn near_spheres_attract_as_the_inverse_gap_and_far_ones_as_its_sixth_power(r in 0.1..10.0f64, a in 0.1..10.0) {
            let (near, far) = (1e-8 * r, 1e5 * r);
            prop_assert!((equal_hamaker_energy(r, near, a) * 12.0 * near / (a * r) + 1.0).abs() < 1e-6);
            prop_assert!((equal_hamaker_energy(r, far, a) * 9.0 * (far / r).powi(6) / (16.0 * a) + 1.0).abs() < 1e-3);
            prop_assert!((equal_hamaker_force(r, near, a) * 12.0 * near * near / (a * r) - 1.0).abs() < 1e-6);
            prop_assert!((equal_hamaker_force(r, far, a) * 3.0 * r * (far / r).powi(7) / (32.0 * a) - 1.0).abs() < 1e-3);
        }

        #[test]
        fn a_saturated_force_is_the_slope_of_its_energy(r_1 in 0.1..10.0, r_2 in 0.1..10.0, delta in -1.0..3.0, delta_0 in 0.1..1.0) {
            let [x, y, a, d] = [r_1, r_2, 2.0, delta_0].map(Dual::constant);
            let (f, u) = saturated_hamaker(x, y, Dual::variable(delta), a, d);
            prop_assert!((f.value / u.slope - 1.0).abs() < 1e-12);
        }

        #[test]
        fn force_and_energy_are_continuous_at_saturation(r_1 in 0.1..10.0, r_2 in 0.1..10.0, delta_0 in 0.1..1.0f64) {
            let at = |delta| saturated_hamaker(r_1, r_2, delta, 1.0, delta_0);
            let (inside, outside) = (at(delta_0 * (1.0 - 1e-14)), at(delta_0 * (1.0 + 1e-14)));
            prop_assert!((inside.0 / outside.0 - 1.0).abs() < 1e-12 && (inside.1 / outside.1 - 1.0).abs() < 1e-12);
            prop_assert_eq!(at(-1.0).0, at(0.0).0);
            // farther apart nothing is saturated
            let d = delta_0 + 0.5;
            prop_assert_eq!(at(d), (hamaker_force(r_1, r_2, d, 1.0), hamaker_energy(r_1, r_2, d, 1.0)));
        }
    }
}
