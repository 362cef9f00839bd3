//! The hydrodynamic radius, from random walks.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use crate::equation::Equation;
use crate::{Real, equation};

/// Not in the paper: electrostatic capacity of a body, from the fraction of walks that hit it.
///
/// ```math
/// C = p \, R
/// ```
///
/// # Reading
///
/// The paper takes the hydrodynamic radius $R_H$ from the program ZENO (Mansfield, Douglas & Garboczi, Phys. Rev. E 64, 061401, 2001), which takes the
/// capacity for it: Brownian walks start uniformly distributed on a sphere around the body; a fraction $p$ of them hits the body, the others escape.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `p` | $p$ | 1 | [0, 1] | share of the walks that hit |
/// | `radius` | $R$ | m | > 0 | radius of the sphere on which they begin |
/// | → `c` | $C$ | m | | capacity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_capacity_of_a_sphere_is_its_radius_wherever_the_walks_begin`
#[inline]
pub fn capacity<R: Real>(p: R, radius: R) -> R {
    p * radius
}

/// Not in the paper: probability that a Brownian walk outside a sphere comes back to it.
///
/// ```math
/// q = \frac{R}{\rho}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `radius` | $R$ | m | > 0 | radius of the sphere |
/// | `rho` | $\rho$ | m | > 0 | distance from its centre, not below the radius |
/// | → `q` | $q$ | 1 | | probability |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_capacity_of_a_sphere_is_its_radius_wherever_the_walks_begin`
#[inline]
pub fn return_probability<R: Real>(radius: R, rho: R) -> R {
    radius / rho
}

/// Not in the paper: point at which a returning walk meets a sphere.
///
/// ```math
/// \cos\theta = \frac{2 u (1 + q)^2 (1 - q + q u)}{(1 - q + 2 q u)^2} - 1
/// ```
///
/// # Reading
///
/// The density of $\cos\theta$ is Poisson's kernel, in proportion to $(1 + q^2 - 2 q \cos\theta)^{-3/2}$; this is the inverse of its integral,
/// written without cancellation. $\theta$ is the angle at the centre between the walk and the place.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `u` | $u$ | 1 | [0, 1] | random number, uniform |
/// | `q` | $q$ | 1 | (0, 1) | radius over distance |
/// | → `cosine` | $\cos\theta$ | 1 | | cosine of the angle |
///
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `returns_are_distributed_by_the_kernel_of_poisson`
/// * `the_mean_cosine_of_returns_is_that_of_the_field_of_a_dipole`
#[inline]
pub fn return_cosine<R: Real>(u: R, q: R) -> R {
    let (one, two) = (R::one(), R::lit(2.0));
    let rest = one - q;
    two * u * (one + q).squared() * (rest + q * u) / (rest + two * q * u).squared() - one
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/capacity.rs", "titania-capacity", [], capacity),
        equation!("mechanics/capacity.rs", "titania-return", [], return_probability),
        equation!("mechanics/capacity.rs", "titania-return-cosine", [], return_cosine),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_capacity_of_a_sphere_is_its_radius_wherever_the_walks_begin(r in 0.1..1.0f64, larger in 1.0..9.0) {
            let begin = r * larger;
            prop_assert!((capacity(return_probability(r, begin), begin) - r).abs() < 1e-15);
        }

        #[test]
        fn returns_are_distributed_by_the_kernel_of_poisson(u in 0.01..0.99f64, q in 0.01..0.99) {
            let cosine = return_cosine(Dual::variable(u), Dual::constant(q));
            let kernel = |c: f64| (1.0 - q * q) / (2.0 * (1.0 + q * q - 2.0 * q * c).powf(1.5));
            prop_assert!((cosine.slope * kernel(cosine.value) - 1.0).abs() < 1e-10);
            prop_assert!((return_cosine(0.0, q) + 1.0).abs() < 1e-15 && (return_cosine(1.0, q) - 1.0).abs() < 1e-14);
        }

        #[test]
        fn the_mean_cosine_of_returns_is_that_of_the_field_of_a_dipole(q in 0.01..0.9) {
            let n = 20_000;
            let mean = (0..n).map(|k| return_cosine((f64::from(k) + 0.5) / f64::from(n), q)).sum::<f64>() / f64::from(n);
            prop_assert!((mean - q).abs() < 1e-4);
        }
    }
}
