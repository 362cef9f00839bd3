//! The capillary force of a coating.

use crate::equation::Equation;
use crate::real::ln_one_plus;
use crate::{Real, equation};

/// **Eq. 23**, Section 2.1.5: capillary force between two spheres.
///
/// ```math
/// \mathbf{f} = \frac{1}{2} \psi \left[1 - \tanh\left(\kappa \left(\lVert \mathbf{x}_j - \mathbf{x}_i \rVert - d_{\mathrm{cutoff}}\right)\right)\right]
/// ```
///
/// # Reading
///
/// The formula has no direction; the force is attractive, along the normal on i. At $d_{\mathrm{cutoff}}$ it has not dropped to zero, as the text says, but to
/// one half. The distance is measured between centres regardless of the radii, so for spheres larger than in the paper, where they touch at 28 nm, the force at contact is smaller. Evaluated as $\psi / (1 + e^{2\kappa(d - d_{\mathrm{cutoff}})})$, which does not cancel at large distances and needs the exponential of a negative number only.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `psi` | $\psi$ | N | >= 0 | largest force |
/// | `kappa` | $\kappa$ | 1/m | > 0 | sharpness of the drop |
/// | `d` | $d$ | m | >= 0 | distance of the centres |
/// | `d_cutoff` | $d_{\mathrm{cutoff}}$ | m | > 0 | distance at which half the force is left |
/// | → `f` | $f$ | N | | attraction |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_printed_sigmoid`
/// * `half_the_force_is_left_at_the_cutoff_distance`
/// * `no_distance_is_too_large_or_too_small`
#[inline(always)]
pub fn capillary_force<R: Real>(psi: R, kappa: R, d: R, d_cutoff: R) -> R {
    let (beyond, tail) = tail(kappa, d, d_cutoff);
    psi * R::select(beyond.gt(R::zero()), tail, R::one()) / (R::one() + tail)
}

/// **Section 2.1.5**, unnumbered: potential of the capillary force, zero for spheres far apart.
///
/// ```math
/// U = -\frac{\psi}{2\kappa} \ln\left(1 + e^{-2\kappa(d - d_{\mathrm{cutoff}})}\right)
/// ```
///
/// # Reading
///
/// The integral of Eq. 23. Evaluated as $\max(-x, 0) + \ln(1 + e^{-|x|})$ with $x = 2\kappa(d - d_{\mathrm{cutoff}})$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `psi` | $\psi$ | N | >= 0 | largest force |
/// | `kappa` | $\kappa$ | 1/m | > 0 | sharpness of the drop |
/// | `d` | $d$ | m | >= 0 | distance of the centres |
/// | `d_cutoff` | $d_{\mathrm{cutoff}}$ | m | > 0 | distance at which half the force is left |
/// | → `u` | $U$ | J | | energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_capillary_force_is_the_slope_of_its_potential`
/// * `no_distance_is_too_large_or_too_small`
#[inline(always)]
pub fn capillary_energy<R: Real>(psi: R, kappa: R, d: R, d_cutoff: R) -> R {
    let (beyond, tail) = tail(kappa, d, d_cutoff);
    -(psi / (R::lit(2.0) * kappa)) * ((-beyond).max(R::zero()) + ln_one_plus(tail))
}

/// The argument of the exponential, and the exponential of its negative magnitude.
#[inline(always)]
fn tail<R: Real>(kappa: R, d: R, d_cutoff: R) -> (R, R) {
    let beyond = R::lit(2.0) * kappa * (d - d_cutoff);
    (beyond, (-beyond.abs()).exp())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq23_capillary.rs", "soot-23", ["23"], capillary_force),
        equation!("soot/eq23_capillary.rs", "soot-23-energy", [], capillary_energy),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_printed_sigmoid(psi in 0.1..10.0, kappa in 0.1..5.0, d in 0.0..10.0, d_cutoff in 0.1..10.0) {
            let [psi, kappa, d, d_c] = [psi, kappa, d, d_cutoff].map(Reference::exact);
            let printed = psi * (Reference::exact(1.0) - (kappa * (d - d_c)).tanh()) / Reference::exact(2.0);
            prop_assert!(((capillary_force(psi, kappa, d, d_c) - printed) / printed).abs().to_f64() < 1e-33);
        }

        #[test]
        fn half_the_force_is_left_at_the_cutoff_distance(psi in 0.1..10.0f64, kappa in 0.1..5.0f64, d_cutoff in 1.0..10.0f64, x in 0.0..1.0f64) {
            let force = |d| capillary_force(psi, kappa, d, d_cutoff);
            prop_assert_eq!(force(d_cutoff), 0.5 * psi);
            prop_assert!((force(d_cutoff - x) + force(d_cutoff + x) - psi).abs() < 1e-13 * psi);
            prop_assert!(force(d_cutoff + x) <= force(d_cutoff - x));
        }

        #[test]
        fn the_capillary_force_is_the_slope_of_its_potential(psi in 0.1..10.0, kappa in 0.1..5.0, d in 0.0..10.0, d_cutoff in 0.1..10.0) {
            let [p, k, c] = [psi, kappa, d_cutoff].map(Dual::constant);
            let slope = capillary_energy(p, k, Dual::variable(d), c).slope;
            prop_assert!((capillary_force(psi, kappa, d, d_cutoff) / slope - 1.0).abs() < 1e-9);
        }

        #[test]
        fn no_distance_is_too_large_or_too_small(sharp in 1.0..1e6f64, d in 0.0..1e3f64, d_cutoff in 1.0..1e3) {
            prop_assume!(f64::abs(d - d_cutoff) > 1e-3);
            let (f, u): (f64, f64) = (capillary_force(1.0, sharp, d, d_cutoff), capillary_energy(1.0, sharp, d, d_cutoff));
            prop_assert!((0.0..=1.0).contains(&f) && u <= 0.0 && u >= -d_cutoff - 1.0);
            if sharp > 1e5 {
                // A step.
                prop_assert!(f < 1e-80 || f == 1.0);
            }
        }
    }
}
