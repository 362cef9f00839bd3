//! Van der Waals attraction of two spheres.

use crate::equation::Equation;
use crate::{Real, equation};

/// Below this, the series of [`energy_of`] is used.
const FEW_TERMS: f64 = 0.5;
/// Terms of the series: with them the remainder is below one part in $10^{36}$.
const TERMS: i32 = 61;

/// **Eq. 18**, Section 2.1.4: energy of two spheres.
///
/// ```math
/// U = -\frac{A}{6} \left[\frac{2 r_1 r_2}{(2r_1 + 2r_2 + \delta) \delta} + \frac{2 r_1 r_2}{(2r_1 + \delta)(2r_2 + \delta)} +
/// \ln \frac{(2r_1 + 2r_2 + \delta) \delta}{(2r_1 + \delta)(2r_2 + \delta)}\right]
/// ```
///
/// # Reading
///
/// Cancellation: for spheres a hundred radii apart the printed terms leave five of the sixteen digits of a double, at a thousand radii none. With the two denominators
/// $p < q$ and $t = (q - p)/(q + p) = 4 r_1 r_2/(p + q)$ the bracket is $2t/(1 - t^2) - 2 \operatorname{artanh} t = 4 \sum_{k \ge 1} \frac{k}{2k + 1} t^{2k + 1}$, a sum of positive terms that is
/// used below $t = 1/2$; above, the printed form loses a factor of six at most.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_1` | $r_1$ | m | > 0 | radius of one sphere |
/// | `r_2` | $r_2$ | m | > 0 | radius of the other |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `u` | $U$ | J | | energy, zero for spheres far apart |
///
/// Rounding: at most 2.5 ULP.
///
/// # Laws
///
/// * `is_the_printed_energy`
/// * `depends_on_the_shape_alone`
/// * `lost_digits_of_the_printed_form_are_kept`
#[inline(always)]
pub fn hamaker_energy<R: Real>(r_1: R, r_2: R, delta: R, a: R) -> R {
    let (p, q) = denominators(r_1, r_2, delta);
    let product = R::lit(2.0) * r_1 * r_2;
    let t = R::lit(2.0) * product / (p + q);
    energy_of(t, product / p + product / q, p / q, a)
}

/// **Section 2.1.4**, unnumbered: force between two unequal spheres.
///
/// ```math
/// f = \frac{\mathrm{d}U}{\mathrm{d}\delta} = \frac{32 A \, r_1^3 r_2^3 \, (r_1 + r_2 + \delta)}{3 \, (2r_1 + 2r_2 + \delta)^2 \delta^2 (2r_1 + \delta)^2 (2r_2 + \delta)^2}
/// ```
///
/// # Reading
///
/// The slope of Eq. 18, all terms over one denominator. Positive for attraction, along the normal on i.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_1` | $r_1$ | m | > 0 | radius of one sphere |
/// | `r_2` | $r_2$ | m | > 0 | radius of the other |
/// | `delta` | $\delta$ | m | > 0 | gap |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | → `f` | $f$ | N | | attraction |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_force_is_the_slope_of_the_energy`
/// * `attraction_falls_with_the_gap`
#[inline(always)]
pub fn hamaker_force<R: Real>(r_1: R, r_2: R, delta: R, a: R) -> R {
    let (p, q) = denominators(r_1, r_2, delta);
    let product = r_1 * r_2;
    R::lit(32.0) / R::lit(3.0) * a * (product * product * product) * (r_1 + r_2 + delta) / (p * q).squared()
}

/// The squared distances from which the sum, or the difference, of the radii is taken away, squared.
#[inline(always)]
fn denominators<R: Real>(r_1: R, r_2: R, delta: R) -> (R, R) {
    let (d_1, d_2) = (R::lit(2.0) * r_1, R::lit(2.0) * r_2);
    ((d_1 + d_2 + delta) * delta, (d_1 + delta) * (d_2 + delta))
}

/// $-\frac{A}{6} (\text{rational} + \ln \text{ratio})$, for small `t` by the series in `t`.
#[inline(always)]
pub(super) fn energy_of<R: Real>(t: R, rational: R, ratio: R, a: R) -> R {
    let square = t.squared();
    let series = (1..=TERMS).rev().fold(R::zero(), |sum, k| {
        let k = f64::from(k);
        (sum + R::lit(k) / R::lit(2.0 * k + 1.0)) * square
    });
    let bracket = R::select(t.lt(R::lit(FEW_TERMS)), R::lit(4.0) * t * series, rational + ratio.ln());
    -(a / R::lit(6.0) * bracket)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq18_hamaker.rs", "soot-18", ["18"], hamaker_energy),
        equation!("soot/eq18_hamaker.rs", "soot-hamaker-force", [], hamaker_force),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    fn printed<R: Real>(r_1: R, r_2: R, delta: R, a: R) -> R {
        let two = R::lit(2.0);
        let (near, far) = ((two * r_1 + two * r_2 + delta) * delta, (two * r_1 + delta) * (two * r_2 + delta));
        -(a / R::lit(6.0)) * (two * r_1 * r_2 / near + two * r_1 * r_2 / far + (near / far).ln())
    }

    proptest! {
        #[test]
        fn is_the_printed_energy(r_1 in 0.1..10.0, r_2 in 0.1..10.0, log_gap in -6.0..6.0f64, a in 0.1..10.0) {
            let [r_1, r_2, delta, a] = [r_1, r_2, 10f64.powf(log_gap), a].map(Reference::exact);
            let (u, printed) = (hamaker_energy(r_1, r_2, delta, a), printed(r_1, r_2, delta, a));
            prop_assert!(((u - printed) / printed).abs().to_f64() < 1e-33);
        }

        #[test]
        fn depends_on_the_shape_alone(r_1 in 0.1..10.0, r_2 in 0.1..10.0, delta in 0.01..10.0, scale in 0.1..10.0) {
            let u: f64 = hamaker_energy(r_1, r_2, delta, 1.0);
            prop_assert!((hamaker_energy(scale * r_1, scale * r_2, scale * delta, 1.0) / u - 1.0).abs() < 1e-12);
            prop_assert!((hamaker_energy(r_2, r_1, delta, 1.0) / u - 1.0).abs() < 1e-14);
            prop_assert!(u < 0.0);
        }

        #[test]
        fn the_force_is_the_slope_of_the_energy(r_1 in 0.1..10.0, r_2 in 0.1..10.0, log_gap in -3.0..3.0f64, a in 0.1..10.0) {
            let delta = 10f64.powf(log_gap);
            let [x, y, z] = [r_1, r_2, a].map(Dual::constant);
            let slope = hamaker_energy(x, y, Dual::variable(delta), z).slope;
            prop_assert!((hamaker_force(r_1, r_2, delta, a) / slope - 1.0).abs() < 1e-11);
        }

        #[test]
        fn attraction_falls_with_the_gap(r_1 in 0.1..10.0, r_2 in 0.1..10.0, delta in 0.01..10.0, more in 1.001..3.0) {
            let force = |delta| hamaker_force(r_1, r_2, delta, 1.0);
            prop_assert!(force(delta) > force(more * delta) && force(more * delta) > 0.0);
        }
    }

    #[test]
    fn lost_digits_of_the_printed_form_are_kept() {
        let exact =
            hamaker_energy(Reference::one(), Reference::one(), Reference::exact(1000.0), Reference::one()).to_f64();
        assert!((hamaker_energy(1.0, 1.0, 1000.0, 1.0) / exact - 1.0).abs() < 1e-15);
        assert!((printed(1.0, 1.0, 1000.0, 1.0) / exact - 1.0).abs() > 1e-2);
    }

    use num_traits::One;
}
