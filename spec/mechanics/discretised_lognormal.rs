//! Log-normal sizes in classes.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use crate::equation::Equation;
use crate::{Real, equation};

/// Largest number of classes of diameters.
const CLASSES: usize = 32;

/// Density of the distribution at a diameter, up to a constant.
#[inline]
fn density<R: Real>(d: R, median: R, sigma_g: R) -> R {
    let z = (d / median).ln() / sigma_g.ln();
    (-(R::lit(0.5) * z.squared())).exp() / d
}

/// Sums over the classes from `lo` to `hi` of the density times the powers 0 to 3 of the diameter.
#[inline]
fn moments<R: Real>(median: R, sigma_g: R, lo: R, hi: R) -> [R; 4] {
    let mut sums = [R::zero(); 4];
    let mut d = lo;
    for _ in 0..CLASSES {
        let mut term = R::select(d.le(hi), density(d, median, sigma_g), R::zero());
        for sum in &mut sums {
            *sum = *sum + term;
            term = term * d;
        }
        d = d + R::one();
    }
    sums
}

/// **Section 5.3**, unnumbered: fraction of the particles in a class of the discretised log-normal distribution.
///
/// ```math
/// p(d) = \frac{g(d)}{\sum_k g(d_k)}, \quad g(d) = \frac{1}{d} \exp\left(-\frac{\ln^2(d / m)}{2 \ln^2 \sigma_G}\right), \quad
/// d_k = d_{lo}, d_{lo} + 1, \dots, d_{hi}
/// ```
///
/// # Reading
///
/// The diameters go from 3 to 23 nm in steps of 1 nm with a median $m$ of 9.0 nm and $\sigma_G$ = 1.45. The paper does not define the discretisation of a class: here it
/// is the density at its diameter. Diameters are numbers, multiples of the step, from three on; at most 32 classes. The resulting Sauter diameter is 12.2 nm, not the
/// 11.3 nm implied by the box of "140 $\bar{d}_s$".
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d` | $d$ | 1 | >= 3 | diameter of the class |
/// | `median` | $m$ | 1 | >= 3 | median before the discretisation |
/// | `s_g` | $\sigma_G$ | 1 | [1.2, 3] | geometric standard deviation |
/// | `lo` | $d_{lo}$ | 1 | >= 3 | smallest diameter |
/// | `hi` | $d_{hi}$ | 1 | >= 3 | largest diameter, up to 31 above the smallest |
/// | → `p` | $p$ | 1 | | fraction of the particles in the class |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `the_shares_of_all_classes_are_one`
/// * `the_shares_of_the_paper_are_the_independent_values`
/// * `there_may_be_32_classes`
#[inline]
pub fn lognormal_share<R: Real>(d: R, median: R, s_g: R, lo: R, hi: R) -> R {
    density(d, median, s_g) / moments(median, s_g, lo, hi)[0]
}

/// **Section 5.3**, unnumbered: mean, Sauter and volume-mean diameter of the discretised log-normal distribution.
///
/// ```math
/// \langle d \rangle = \sum p \, d, \quad \bar{d}_s = \frac{\sum p \, d^3}{\sum p \, d^2}, \quad d_{30} = \Big(\sum p \, d^3\Big)^{1/3}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `median` | $m$ | 1 | >= 3 | median before the discretisation |
/// | `s_g` | $\sigma_G$ | 1 | [1.2, 3] | geometric standard deviation |
/// | `lo` | $d_{lo}$ | 1 | >= 3 | smallest diameter |
/// | `hi` | $d_{hi}$ | 1 | >= 3 | largest diameter, up to 31 above the smallest |
/// | → `mean` | $\langle d \rangle$ | 1 | | mean diameter |
/// | → `sauter` | $\bar{d}_s$ | 1 | | Sauter diameter |
/// | → `d_30` | $d_{30}$ | 1 | | diameter of the mean volume |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `the_sauter_diameter_of_the_paper_is_not_that_of_its_box`
#[inline]
pub fn lognormal<R: Real>(median: R, s_g: R, lo: R, hi: R) -> (R, R, R) {
    let [all, first, second, third] = moments(median, s_g, lo, hi);
    (first / all, third / second, ((third / all).ln() / R::lit(3.0)).exp())
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/discretised_lognormal.rs", "titania-lognormal-share", [], lognormal_share),
        equation!("mechanics/discretised_lognormal.rs", "titania-lognormal", [], lognormal),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_shares_of_all_classes_are_one(median in 4.0..12.0, s_g in 1.1..2.0) {
            let all: f64 = (3..=23).map(|d| lognormal_share(f64::from(d), median, s_g, 3.0, 23.0)).sum();
            prop_assert!((all - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn there_may_be_32_classes() {
        let all: f64 = (3..35).map(|d| lognormal_share(f64::from(d), 20.0, 2.0, 3.0, 34.0)).sum();
        assert!((all - 1.0).abs() < 1e-14, "{all}");
    }

    #[test]
    fn the_shares_of_the_paper_are_the_independent_values() {
        for (d, share) in [
            (3.0, 4.545576656345368e-3),
            (4.0, 2.492774739281294e-2),
            (8.0, 1.2827836754171914e-1),
            (17.0, 1.466980088751936e-2),
        ] {
            assert!((lognormal_share(d, 9.0, 1.45, 3.0, 23.0) - share).abs() < 1e-16);
        }
    }

    #[test]
    fn the_sauter_diameter_of_the_paper_is_not_that_of_its_box() {
        let (mean, sauter, d_30): (f64, f64, f64) = lognormal(9.0, 1.45, 3.0, 23.0);
        assert!((mean - 9.5612).abs() < 1e-4 && (sauter - 12.2097).abs() < 1e-4 && (d_30 - 10.8210).abs() < 1e-4);
        assert!((1581.4 / 140.0 / sauter - 1.0).abs() > 0.07);
    }
}
