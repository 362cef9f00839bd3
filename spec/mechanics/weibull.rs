//! Strengths of the weakest of many flaws.

use crate::equation::Equation;
use crate::{Real, equation};

/// The strength that a given share of brittle bodies exceeds.
///
/// ```math
/// x = \lambda \, (-\ln p)^{1/k}
/// ```
///
/// # Reading
///
/// The distribution of Weibull (1951), $p = e^{-(x/\lambda)^k}$, solved for the strength. A number that is uniform between zero and one, taken for $p$, gives a strength with this distribution. The power is taken by logarithms.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `p` | $p$ | 1 | (0, 1) | share that is stronger |
/// | `scale` | $\lambda$ | 1 | > 0 | strength that one body in e exceeds |
/// | `shape` | $k$ | 1 | >= 0.1 | Weibull modulus: the larger, the more alike they are |
/// | → `x` | $x$ | 1 | | strength |
///
/// Rounding: at most 2.5 ULP.
///
/// # Laws
///
/// * `the_share_that_is_stronger_is_given`
/// * `the_stronger_the_rarer`
/// * `one_in_e_exceeds_the_scale`
/// * `the_weakest_of_many_has_the_same_distribution`
#[inline]
pub fn weibull_quantile<R: Real>(p: R, scale: R, shape: R) -> R {
    scale * ((-p.ln()).ln() / shape).exp()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/weibull.rs", "mechanics-weibull-quantile", [], weibull_quantile)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_share_that_is_stronger_is_given(p in 0.001..0.999f64, scale in 0.1..10.0f64, shape in 0.5..20.0f64) {
            let x = weibull_quantile(p, scale, shape);
            prop_assert!(relative_eq!((-(x / scale).powf(shape)).exp(), p, max_relative = 1e-12));
        }

        #[test]
        fn the_stronger_the_rarer(p in 0.001..0.998f64, by in 1.0001..1.001f64, scale in 0.1..10.0f64, shape in 0.5..20.0f64) {
            prop_assert!(weibull_quantile(p * by, scale, shape) < weibull_quantile(p, scale, shape));
        }

        #[test]
        fn one_in_e_exceeds_the_scale(scale in 0.1..10.0f64, shape in 0.5..20.0f64) {
            prop_assert!(relative_eq!(weibull_quantile((-1f64).exp(), scale, shape), scale, max_relative = 1e-14));
        }

        /// Of `n` bodies in a row all are stronger than `x` with the probability `p^n`.
        #[test]
        fn the_weakest_of_many_has_the_same_distribution(p in 0.01..0.99f64, scale in 0.1..10.0f64, shape in 0.5..20.0f64, n in 2..100) {
            let n = f64::from(n);
            let (of_one, of_weakest) = (weibull_quantile(p, scale, shape), weibull_quantile(p.powf(n), scale * n.powf(-1.0 / shape), shape));
            prop_assert!(relative_eq!(of_one, of_weakest, max_relative = 1e-11));
        }
    }
}
