//! Diffusion and drift of an aggregate in a gas.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 5.3**, unnumbered: diffusion coefficient of an aggregate.
///
/// ```math
/// D = \frac{k_B T}{f}
/// ```
///
/// # Reading
///
/// The relation of Einstein and Smoluchowski with the friction factor of Eq. 14.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `kt` | $k_B T$ | J | > 0 | Boltzmann's constant times the temperature of the gas |
/// | `f` | $f$ | kg/s | > 0 | friction factor |
/// | → `d` | $D$ | m^2/s | | coefficient of diffusion |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `twice_the_friction_is_half_the_diffusion`
/// * `the_walk_of_a_settling_cloud_balances_its_fall`
#[inline]
pub fn diffusion<R: Real>(kt: R, f: R) -> R {
    kt / f
}

/// Not in the paper: point at which a drifting Brownian walk leaves a sphere at whose centre it starts.
///
/// ```math
/// \cos\theta = 1 + \frac{\ln\left(u + (1 - u) \, e^{-2\kappa}\right)}{\kappa}, \quad \kappa = \frac{v \ell}{2 D}
/// ```
///
/// # Reading
///
/// Without drift the exit point is distributed uniformly, independent of the exit time. By Girsanov's theorem a drift weights the paths with $e^{\mathbf{v} \cdot \mathbf{x} / 2D}$
/// and a function of that time: the density of $\cos\theta$, the inverse of whose integral this is, is proportional to $e^{\kappa \cos\theta}$. A walk may therefore jump between
/// spheres that are as large as the free space allows, without error. Written with $\tanh \kappa$ where the logarithm is that of a number near 1.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `u` | $u$ | 1 | (0, 1] | random number, uniform |
/// | `v` | $v$ | m/s | > 0 | velocity of the drift |
/// | `ell` | $\ell$ | m | > 0 | radius of the ball |
/// | `d` | $D$ | m^2/s | > 0 | coefficient of diffusion |
/// | → `cosine` | $\cos\theta$ | 1 | | cosine of the angle between the drift and the place |
///
/// Rounding: at most 5 ULP.
///
/// # Laws
///
/// * `exits_are_weighted_with_the_exponential_of_the_drift`
/// * `the_random_number_is_the_share_of_exits_behind`
/// * `a_slow_walk_goes_anywhere_and_a_fast_one_ahead`
/// * `the_mean_cosine_of_exits_is_that_of_langevin`
/// * `exits_behind_keep_their_digits`
#[inline]
pub fn exit_cosine<R: Real>(u: R, v: R, ell: R, d: R) -> R {
    let (one, two) = (R::one(), R::lit(2.0));
    let kappa = v * ell / (two * d);
    let (w, t) = (u + (one - u) * (-(two * kappa)).exp(), kappa.tanh());
    let log = R::select(w.lt(R::lit(0.5)), w.ln(), ln_one_plus(-(two * (one - u) * t / (one + t))));
    one + log / kappa
}

/// $\ln(1 + x)$ of a number between -1 and 0, without loss for a small one: the error of `w` is that of the denominator.
#[inline]
fn ln_one_plus<R: Real>(x: R) -> R {
    let w = R::one() + x;
    R::select(w.lt(R::one()), x * w.ln() / (w - R::one()), x)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/diffusion.rs", "titania-diffusion", [], diffusion),
        equation!("mechanics/diffusion.rs", "titania-exit", [], exit_cosine),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn twice_the_friction_is_half_the_diffusion(kt in 0.1..10.0, f in 0.1..10.0) {
            prop_assert_eq!(diffusion(kt, 2.0 * f), 0.5 * diffusion(kt, f));
        }

        /// A barometric density, of Boltzmann's factor, has no net flux: what diffuses up is what falls with the force over the friction.
        #[test]
        fn the_walk_of_a_settling_cloud_balances_its_fall(kt in 0.1..10.0f64, f in 0.1..10.0f64, weight in 0.1..10.0f64, height in 0.0..1.0f64) {
            let density = (-(Dual::constant(weight / kt) * Dual::variable(height))).exp();
            let (diffused, fallen) = (-diffusion(kt, f) * density.slope, weight / f * density.value);
            prop_assert!((diffused / fallen - 1.0).abs() < 1e-13);
        }

        #[test]
        fn exits_are_weighted_with_the_exponential_of_the_drift(u in 0.01..0.99f64, v in 0.1..10.0f64, ell in 0.1..2.0f64) {
            let [drift, radius, d] = [v, ell, 1.0].map(Dual::constant);
            let cosine = exit_cosine(Dual::variable(u), drift, radius, d);
            let kappa = 0.5 * v * ell;
            let density = kappa * (kappa * cosine.value).exp() / (2.0 * kappa.sinh());
            prop_assert!((cosine.slope * density - 1.0).abs() < 1e-10);
        }

        #[test]
        fn the_random_number_is_the_share_of_exits_behind(u in 0.01..1.0f64, v in 0.1..3.0f64, ell in 0.1..2.0f64, d in 0.3..3.0f64) {
            let (kappa, cosine) = (0.5 * v * ell / d, exit_cosine(u, v, ell, d));
            let behind = ((kappa * (cosine - 1.0)).exp() - (-2.0 * kappa).exp()) / -(-2.0 * kappa).exp_m1();
            prop_assert!((behind / u - 1.0).abs() < 1e-11);
            // of a drift that is hardly felt
            prop_assert!((exit_cosine(u, 1e-17 * v, ell, d) - (2.0 * u - 1.0)).abs() < 1e-15);
        }

        #[test]
        fn a_slow_walk_goes_anywhere_and_a_fast_one_ahead(u in 0.01..1.0f64) {
            prop_assert!((exit_cosine(u, 1e-9, 1.0, 1.0) - (2.0 * u - 1.0)).abs() < 1e-8);
            prop_assert!((exit_cosine(u, 1e9, 1.0, 1.0) - 1.0).abs() < 1e-7);
        }

        #[test]
        fn exits_behind_keep_their_digits(log_u in -50.0..0.0f64, log_kappa in -6.0..6.0f64) {
            let (u, v) = (log_u.exp2(), log_kappa.exp2());
            let exact = |x: f64| Reference::exact(x);
            let cosine = exit_cosine(exact(u), exact(v), exact(2.0), exact(1.0));
            let share = cosine - exact(exit_cosine(u, v, 2.0, 1.0));
            // the logarithm is over the drift
            prop_assert!(share.to_f64().abs() < 1e-15 * (1.0 + 1.0 / v), "{u} {v} {}", share.to_f64());
        }

        #[test]
        fn the_mean_cosine_of_exits_is_that_of_langevin(kappa in 0.1..20.0f64) {
            let n = 20_000;
            let cosine = |k| exit_cosine((f64::from(k) + 0.5) / f64::from(n), 2.0 * kappa, 1.0, 1.0);
            let mean = (0..n).map(cosine).sum::<f64>() / f64::from(n);
            prop_assert!((mean - (1.0 / kappa.tanh() - 1.0 / kappa)).abs() < 1e-4);
        }
    }
}
