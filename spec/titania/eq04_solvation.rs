//! The solvation force: layers of water are squeezed out one after the other.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 4**, Section 2.1: solvation force as a function of the distance.
///
/// ```math
/// F_{solv} = F_{solv}^0 \cos\left(\frac{2\pi (d - R_i - R_j)}{\sigma_{solv}}\right) e^{-\frac{d - R_i - R_j}{\sigma_{solv}}}
/// ```
///
/// # Reading
///
/// As printed, with bare radii: period and decay length are the same. Eq. 3 defines the meaning of the sign.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_0` | $F_{solv}^0$ | N | any | amplitude, Eq. 5 |
/// | `d` | $d$ | m | > 0 | distance of the centres |
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `sigma` | $\sigma_{solv}$ | m | > 0 | period and decay length |
/// | → `f_solv` | $F_{solv}$ | N | | solvation force |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_amplitude_where_bare_surfaces_touch`
/// * `a_period_on_it_is_smaller_by_e_and_half_a_period_on_it_has_the_other_sign`
/// * `vanishes_at_odd_quarters_of_the_period`
#[inline(always)]
pub fn solvation_force<R: Real>(f_0: R, d: R, r_i: R, r_j: R, sigma: R) -> R {
    let x = (d - r_i - r_j) / sigma;
    f_0 * (R::lit(2.0) * R::pi() * x).cos() * (-x).exp()
}

/// **Section 2.1**, unnumbered: integral of the solvation force from infinity to a gap.
///
/// ```math
/// \int_\infty^x F_{solv} \, dx = \frac{F_{solv}^0 \sigma}{1 + 4\pi^2} \, e^{-x/\sigma}
///   \left(2\pi \sin\frac{2\pi x}{\sigma} - \cos\frac{2\pi x}{\sigma}\right)
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_0` | $F_{solv}^0$ | N | any | amplitude, Eq. 5 |
/// | `x` | $x$ | m | any | distance of the bare surfaces |
/// | `sigma` | $\sigma_{solv}$ | m | > 0 | period and decay length |
/// | → `u` | $U$ | J | | integral, zero for a large gap |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_force_is_its_slope`
/// * `all_the_work_from_contact_is_the_amplitude_times_the_decay_length_over_one_plus_four_pi_squared`
#[inline(always)]
pub fn solvation_integral<R: Real>(f_0: R, x: R, sigma: R) -> R {
    let turn = R::lit(2.0) * R::pi();
    let phase = turn * (x / sigma);
    f_0 * sigma * (-(x / sigma)).exp() * (turn * phase.sin() - phase.cos()) / (R::one() + turn.squared())
}

/// **Section 2.1**, unnumbered: slope of the solvation force.
///
/// ```math
/// \frac{d F_{solv}}{d d} = -\frac{F_{solv}^0}{\sigma_{solv}} e^{-x/\sigma} \left(\cos\frac{2\pi x}{\sigma} + 2\pi \sin\frac{2\pi x}{\sigma}\right)
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_0` | $F_{solv}^0$ | N | any | amplitude, Eq. 5 |
/// | `x` | $x$ | m | any | distance of the bare surfaces |
/// | `sigma` | $\sigma_{solv}$ | m | > 0 | period and decay length |
/// | → `slope` | $F'_{solv}$ | N/m | | change of the force with the distance |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_derivative_of_the_force`
#[inline(always)]
pub fn solvation_slope<R: Real>(f_0: R, x: R, sigma: R) -> R {
    let turn = R::lit(2.0) * R::pi();
    let phase = turn * (x / sigma);
    -(f_0 / sigma * (-(x / sigma)).exp() * (phase.cos() + turn * phase.sin()))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq04_solvation.rs", "titania-4", ["4"], solvation_force),
        equation!("titania/eq04_solvation.rs", "titania-04-int", [], solvation_integral),
        equation!("titania/eq04_solvation.rs", "titania-04-slope", [], solvation_slope),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    fn force(gap: f64, sigma: f64) -> f64 {
        solvation_force(-20.6, 8.0 + gap, 4.0, 4.0, sigma)
    }

    proptest! {
        #[test]
        fn is_the_amplitude_where_bare_surfaces_touch(f_0 in -30.0..30.0f64, r_i in 0.5..4.0, r_j in 0.5..4.0, sigma in 0.1..1.0) {
            let d = r_i + r_j;
            prop_assert!((solvation_force(f_0, d, r_i, r_j, sigma) - f_0).abs() < 1e-12);
        }

        #[test]
        fn a_period_on_it_is_smaller_by_e_and_half_a_period_on_it_has_the_other_sign(gap in 0.0..2.0, sigma in 0.1..1.0) {
            let here = force(gap, sigma);
            prop_assert!((force(gap + sigma, sigma) - (-1.0f64).exp() * here).abs() < 1e-11);
            prop_assert!((force(gap + 0.5 * sigma, sigma) + (-0.5f64).exp() * here).abs() < 1e-11);
        }

        #[test]
        fn vanishes_at_odd_quarters_of_the_period(k in 0..6, sigma in 0.1..1.0) {
            prop_assert!(force((0.5 * f64::from(k) + 0.25) * sigma, sigma).abs() < 1e-11);
        }

        #[test]
        fn the_force_is_its_slope(x in -0.2..2.0, sigma in 0.1..1.0) {
            let u = solvation_integral(Dual::constant(-20.6), Dual::variable(x), Dual::constant(sigma));
            prop_assert!((u.slope - force(x, sigma)).abs() < 1e-9);
        }

        #[test]
        fn all_the_work_from_contact_is_the_amplitude_times_the_decay_length_over_one_plus_four_pi_squared(f_0 in -30.0..30.0f64, sigma in 0.1..1.0) {
            let expected = f_0 * sigma / (1.0 + 4.0 * std::f64::consts::PI.powi(2));
            prop_assert!((-solvation_integral(f_0, 0.0, sigma) - expected).abs() < 1e-14);
        }

        #[test]
        fn is_the_derivative_of_the_force(x in -0.2..2.0, sigma in 0.1..1.0) {
            let c = Dual::constant;
            let moved = solvation_force(c(-20.6), Dual::variable(8.0 + x), c(4.0), c(4.0), c(sigma)).slope;
            prop_assert!((moved - solvation_slope(-20.6, x, sigma)).abs() < 1e-9);
        }
    }
}
