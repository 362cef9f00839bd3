//! The size of a fractal aggregate.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 24**, Section 2.1.6: number of primary particles of an aggregate.
///
/// ```math
/// N = k_\mathrm{f} \left(\frac{R_\mathrm{g}}{r}\right)^{D_\mathrm{f}}
/// ```
///
/// # Reading
///
/// The radius of gyration is the root mean square distance of the centres from their centroid, without the size of the particles. For unequal particles
/// both are weighted by mass, and $r$ is the geometric mean of the radii: the median of a log-normal distribution.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_f` | $k_\mathrm{f}$ | 1 | > 0 | prefactor |
/// | `r_g` | $R_\mathrm{g}$ | m | > 0 | radius of gyration |
/// | `r` | $r$ | m | > 0 | radius of the primary particles |
/// | `d_f` | $D_\mathrm{f}$ | 1 | > 0 | fractal dimension |
/// | → `n` | $N$ | 1 | | number of primary particles |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_fractal_dimension_is_the_slope_in_logarithms`
#[inline(always)]
pub fn fractal_number<R: Real>(k_f: R, r_g: R, r: R, d_f: R) -> R {
    k_f * (d_f * (r_g / r).ln()).exp()
}

/// **Section 2.1.6**, unnumbered: radius of gyration of an aggregate with a given number of particles.
///
/// ```math
/// R_\mathrm{g} = r \left(\frac{N}{k_\mathrm{f}}\right)^{1 / D_\mathrm{f}}
/// ```
///
/// # Reading
///
/// Eq. 24 solved for the radius of gyration.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_f` | $k_\mathrm{f}$ | 1 | > 0 | prefactor |
/// | `n` | $N$ | 1 | > 0 | number of primary particles |
/// | `r` | $r$ | m | > 0 | radius of the primary particles |
/// | `d_f` | $D_\mathrm{f}$ | 1 | > 0 | fractal dimension |
/// | → `r_g` | $R_\mathrm{g}$ | m | | radius of gyration |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `number_and_radius_of_gyration_are_inverse`
/// * `the_aggregates_of_the_paper_have_a_radius_of_gyration_of_188_nm`
#[inline(always)]
pub fn gyration_radius<R: Real>(k_f: R, n: R, r: R, d_f: R) -> R {
    r * ((n / k_f).ln() / d_f).exp()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq24_fractal.rs", "soot-24", ["24"], fractal_number),
        equation!("soot/eq24_fractal.rs", "soot-24-inv", [], gyration_radius),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_fractal_dimension_is_the_slope_in_logarithms(k_f in 0.5..3.0f64, r_g in 1.0..30.0f64, d_f in 1.0..3.0f64) {
            let number = |factor: f64| fractal_number(k_f, factor * r_g, 1.0, d_f);
            prop_assert!(((number(2.0) / number(1.0)).log2() - d_f).abs() < 1e-12);
            prop_assert!((fractal_number(k_f, r_g, r_g, d_f) - k_f).abs() < 1e-15);
        }

        #[test]
        fn number_and_radius_of_gyration_are_inverse(k_f in 0.5..3.0f64, n in 2.0..1000.0f64, r in 0.1..10.0f64, d_f in 1.0..3.0f64) {
            let r_g = gyration_radius(k_f, n, r, d_f);
            prop_assert!((fractal_number(k_f, r_g, r, d_f) / n - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn the_aggregates_of_the_paper_have_a_radius_of_gyration_of_188_nm() {
        assert!((gyration_radius(1.4, 150.0, 14.0, 1.8) - 187.882f64).abs() < 5e-4);
    }
}
