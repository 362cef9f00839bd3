//! Log-normal sizes between two bounds.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 3.2**, unnumbered: parameters of the log-normal distribution of the diameters.
///
/// ```math
/// e^{\mu - \sigma^2} = d_0, \quad e^{2\mu + \sigma^2} (e^{\sigma^2} - 1) = \big(0.2 \, (d_l - d_s)\big)^2
/// ```
///
/// # Reading
///
/// The paper gives the mode and the standard deviation. This deviation is taken before the truncation to $[d_s, d_l]$: with this reading, the volumes
/// of Table 6 hold the particles it counts. With $u = e^{\sigma^2} - 1$ the two conditions leave
/// $u (1 + u)^3 = (0.2 (d_l - d_s) / d_0)^2$, which Newton's method solves from above, where it converges monotonically: ten steps are
/// more than enough for any number. $\ln(1 + u)$ is evaluated as $u \ln w / (w - 1)$ with $w = 1 + u$ rounded, which
/// loses nothing for small `u`; where `w` is one, it is `u`.
///
/// A logarithm requires a dimensionless argument: diameters are multiples of any one unit of length.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d_0` | $d_0$ | 1 | > 0 | mode of the diameters |
/// | `d_s` | $d_s$ | 1 | > 0 | smallest diameter |
/// | `d_l` | $d_l$ | 1 | > 0 | largest diameter, above the smallest |
/// | → `mu` | $\mu$ | 1 | | mean of the logarithm |
/// | → `sigma` | $\sigma$ | 1 | | standard deviation of the logarithm |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `has_the_mode_and_the_standard_deviation`
/// * `does_not_depend_on_the_unit_of_length`
/// * `narrow_and_wide_distributions_have_the_standard_deviation`
#[inline(always)]
pub fn lognormal<R: Real>(d_0: R, d_s: R, d_l: R) -> (R, R) {
    let (one, three) = (R::one(), R::lit(3.0));
    let target = ((d_l - d_s) / (R::lit(5.0) * d_0)).squared();
    let mut u = target.min(target.sqrt().sqrt());
    for _ in 0..10 {
        let w = one + u;
        u = u - (u * w * w * w - target) / (w * w * (w + three * u));
    }
    let w = one + u;
    let variance = R::select(w.gt(one), u * w.ln() / (w - one), u);
    (d_0.ln() + variance, variance.sqrt())
}

/// **Section 3.2**, unnumbered: fraction, mean, standard deviation and mean cube of the diameters that the truncation keeps.
///
/// ```math
/// \langle d^k \rangle = \frac{e^{k\mu + k^2 \sigma^2 / 2}}{K} \Big[\Phi\big(z_l - k\sigma\big) - \Phi\big(z_s - k\sigma\big)\Big], \quad
/// z = \frac{\ln d - \mu}{\sigma}, \quad K = \Phi(z_l) - \Phi(z_s)
/// ```
///
/// # Reading
///
/// $\Phi$ is the normal distribution. All diameters are taken relative to the mode, with $e^\mu = d_0 e^{\sigma^2}$:
/// $z = \ln(d / d_0) / \sigma - \sigma$. The mode lies between the bounds: without $d_s < d_0 < d_l$ there is no value.
///
/// Where both limits of a moment, shifted by a multiple of $\sigma$, are beyond 2.5 on one side, the complements of $\Phi$ are subtracted, as a continued fraction: values near one half would lose digits.
/// The variance is a difference of nearly equal moments where the distribution is narrow. Up to $\sigma = 1/2$ it is that of $e^{\sigma z} - 1$, expanded in powers of $\sigma$: with
/// $t_n = \frac{\sigma^n}{n!} \int_{z_s}^{z_l} z^n \varphi(z) \, dz$ its first two moments are $\frac{1}{K} \sum_{n \ge 1} t_n$ and $\frac{1}{K} \sum_{n \ge 2} (2^n - 2) \, t_n$, and
/// $t_n = \frac{\sigma^2}{n} t_{n-2} + \frac{\sigma^n}{n!} \big[z_s^{n-1} \varphi(z_s) - z_l^{n-1} \varphi(z_l)\big]$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d_0` | $d_0$ | m | > 0 | mode of the diameters |
/// | `d_s` | $d_s$ | m | > 0 | smallest diameter, below the mode |
/// | `d_l` | $d_l$ | m | > 0 | largest diameter, above the mode |
/// | → `kept` | $K$ | 1 | | fraction of the drawn diameters that is kept |
/// | → `mean` | $\langle d \rangle$ | m | | mean diameter |
/// | → `std` | $\sqrt{\langle d^2 \rangle - \langle d \rangle^2}$ | m | | standard deviation of the diameters |
/// | → `m3` | $\langle d^3 \rangle$ | m^3 | | mean cube of the diameters |
///
/// Rounding: at most 100 ULP.
///
/// # Laws
///
/// * `the_moments_are_those_of_the_density`
/// * `the_deviation_of_a_narrow_distribution_keeps_its_digits`
/// * `the_moments_far_in_one_tail_keep_their_digits`
/// * `gives_the_numbers_of_particles_of_table_6`
/// * `without_a_mode_between_the_bounds_there_is_no_value`
#[inline(always)]
pub fn truncated_moments<R: Real>(d_0: R, d_s: R, d_l: R) -> (R, R, R, R) {
    let (_, sigma) = lognormal(R::one(), d_s / d_0, d_l / d_0);
    let z = |d: R| (d / d_0).ln() / sigma - sigma;
    let (z_s, z_l) = (z(d_s), z(d_l));
    let none = R::zero() / R::zero();
    let kept = R::select(d_s.lt(d_0) & d_0.lt(d_l), between(z_s, z_l), none);
    // Moments of the diameters in units of the median.
    let moment = |k: f64| {
        let shift = R::lit(k) * sigma;
        (R::lit(0.5) * shift.squared()).exp() * between(z_s - shift, z_l - shift) / kept
    };
    let (mean, median) = (moment(1.0), d_0 * sigma.squared().exp());
    let narrow = sigma.le(R::lit(NARROW));
    let variance = R::select(narrow, variance(sigma, z_s, z_l, kept), moment(2.0) - mean.squared());
    (kept, median * mean, median * variance.sqrt(), median * median * median * moment(3.0))
}

/// Up to this deviation of the logarithm the variance is a series.
const NARROW: f64 = 0.5;
/// Its terms: the remainder is below one part in $10^{38}$.
const TERMS: i32 = 60;

/// The variance of the diameters between two limits, in units of the median squared.
fn variance<R: Real>(sigma: R, z_s: R, z_l: R, kept: R) -> R {
    let (two, steps) = (R::lit(2.0), [z_s, z_l].map(|z| sigma * z));
    // sigma^n z^(n - 1) / n! times the density at both limits
    let mut ends = [z_s, z_l].map(|z| sigma * density(z));
    let (mut before, mut term) = (kept, ends[0] - ends[1]);
    let (mut mean, mut square, mut power) = (term, R::zero(), two);
    for n in 2..=TERMS {
        let n = R::lit(f64::from(n));
        ends = [ends[0] * steps[0] / n, ends[1] * steps[1] / n];
        (before, term) = (term, sigma.squared() * before / n + (ends[0] - ends[1]));
        power = two * power;
        (mean, square) = (mean + term, square + (power - two) * term);
    }
    square / kept - (mean / kept).squared()
}

/// The density of the normal distribution.
fn density<R: Real>(z: R) -> R {
    (R::lit(-0.5) * z.squared()).exp() / (R::lit(2.0) * R::pi()).sqrt()
}

/// From here on the complement of the normal distribution is a continued fraction.
const TAIL: f64 = 2.5;

/// The normal distribution between two limits.
fn between<R: Real>(low: R, high: R) -> R {
    // the distribution is even: mostly above zero
    let below = (low + high).lt(R::zero());
    let (low, high) = (R::select(below, -high, low), R::select(below, -low, high));
    let tails = beyond(low) - beyond(high);
    R::select(low.gt(R::lit(TAIL)), tails, beyond_the_middle(high) - beyond_the_middle(low))
}

/// The normal distribution beyond a limit of at least `TAIL`: its density over `z + 1 / (z + 2 / (z + ...))`, to 38 digits.
fn beyond<R: Real>(z: R) -> R {
    let z = z.max(R::lit(TAIL));
    let mut sum = z;
    for k in (1..400).rev() {
        sum = z + R::lit(f64::from(k)) / sum;
    }
    density(z) / sum
}

/// The normal distribution minus one half: its density times `z + z^3/3 + z^5/15 + ...`. Beyond 13 less than 1e-38 is left, which
/// reference values of 34 digits do not see.
fn beyond_the_middle<R: Real>(z: R) -> R {
    let z = z.min(R::lit(13.0)).max(R::lit(-13.0));
    let square = z.squared();
    // Horner's rule: each term is the one before times z^2 / (2k + 1).
    let mut sum = R::one();
    for k in (1..250).rev() {
        sum = R::one() + sum * square / R::lit(f64::from(2 * k + 1));
    }
    z * sum * (R::lit(-0.5) * square).exp() / (R::lit(2.0) * R::pi()).sqrt()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/truncated_lognormal.rs", "wear-lognormal", [], lognormal),
        equation!("mechanics/truncated_lognormal.rs", "wear-lognormal-truncated", [], truncated_moments),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Reference;
    use approx::relative_eq;
    use proptest::prelude::*;

    /// The standard deviation as printed, of diameters between two limits whose mode is one, with digits enough for the difference.
    fn printed_deviation(low: Reference, high: Reference) -> Reference {
        let sigma = lognormal(Reference::exact(1.0), low, high).1;
        let limits = [low, high].map(|d| d.ln() / sigma - sigma);
        let moment = |k: f64| {
            let shift = Reference::exact(k) * sigma;
            let kept = between(limits[0] - shift, limits[1] - shift) / between(limits[0], limits[1]);
            (shift.squared() / Reference::exact(2.0)).exp() * kept
        };
        sigma.squared().exp() * (moment(2.0) - moment(1.0).squared()).sqrt()
    }

    proptest! {
        #[test]
        fn has_the_mode_and_the_standard_deviation(d_0 in 0.1..100.0, d_s in 0.3..0.99, d_l in 1.01..20.0) {
            let (mu, sigma) = lognormal(d_0, d_s * d_0, d_l * d_0);
            let (mu, square): (f64, f64) = (mu, sigma * sigma);
            prop_assert!(relative_eq!((mu - square).exp(), d_0, max_relative = 1e-13));
            let std = ((2.0 * mu + square).exp() * square.exp_m1()).sqrt();
            prop_assert!(relative_eq!(std, 0.2 * (d_l - d_s) * d_0, max_relative = 1e-13));
        }

        #[test]
        fn narrow_and_wide_distributions_have_the_standard_deviation(log_width in -60.0..40.0f64) {
            let (d_s, d_l) = (1.0 - 0.5 * log_width.exp2().min(1.0), 1.0 + 0.5 * log_width.exp2());
            let (mu, sigma) = lognormal(1.0, d_s, d_l);
            let square: f64 = sigma * sigma;
            prop_assert!(relative_eq!(mu, square, max_relative = 1e-15));
            let std = ((2.0 * mu + square).exp() * square.exp_m1()).sqrt();
            prop_assert!(relative_eq!(std, 0.2 * (d_l - d_s), max_relative = 1e-12), "{std} {}", 0.2 * (d_l - d_s));
        }

        #[test]
        fn does_not_depend_on_the_unit_of_length(d_0 in 0.1..100.0, d_l in 1.01..20.0) {
            let (in_nm, in_m) = (lognormal(d_0, 0.75 * d_0, d_l * d_0), lognormal(1e-9 * d_0, 0.75e-9 * d_0, 1e-9 * d_l * d_0));
            prop_assert!(relative_eq!(in_nm.1, in_m.1, max_relative = 1e-14));
            prop_assert!(relative_eq!(in_nm.0 - in_m.0, 1e9f64.ln(), max_relative = 1e-14));
        }

        #[test]
        fn the_moments_are_those_of_the_density(d_s in 0.5..0.95, d_l in 1.05..6.0) {
            let (mu, sigma) = lognormal(1.0, d_s, d_l);
            let (kept, mean, std, m3) = truncated_moments(1.0, d_s, d_l);
            // Simpson's rule over the logarithm.
            let intervals = 400;
            let (low, h) = (d_s.ln(), f64::ln(d_l / d_s) / f64::from(intervals));
            let integral = |k: f64| -> f64 {
                (0..=intervals)
                    .map(|n| {
                        let weight = if n == 0 || n == intervals { 1.0 } else if n % 2 == 1 { 4.0 } else { 2.0 };
                        let t = low + f64::from(n) * h;
                        let z = (t - mu) / sigma;
                        weight * (k * t - 0.5 * z * z).exp() * h / 3.0 / (sigma * (2.0 * std::f64::consts::PI).sqrt())
                    })
                    .sum()
            };
            prop_assert!(relative_eq!(kept, integral(0.0), max_relative = 1e-8));
            prop_assert!(relative_eq!(mean, integral(1.0) / kept, max_relative = 1e-8));
            prop_assert!(relative_eq!(m3, integral(3.0) / kept, max_relative = 1e-8));
            prop_assert!(relative_eq!(std * std + mean * mean, integral(2.0) / kept, max_relative = 1e-8));
        }

        #[test]
        fn the_deviation_of_a_narrow_distribution_keeps_its_digits(log_width in -20.0..2.0f64, place in 0.05..0.95f64) {
            let width = log_width.exp2();
            // the mode is one: what rounds its distances from the bounds is no matter of the equation
            let (d_s, d_l) = (1.0 - place * width.min(0.9), 1.0 + (1.0 - place) * width);
            let [one, low, high] = [1.0, d_s, d_l].map(Reference::exact);
            let exact = truncated_moments(one, low, high).2;
            let (_, _, std, _) = truncated_moments(1.0, d_s, d_l);
            // a unit of the last place of a bound is one over its distance from the mode of that
            prop_assert!(((std / exact.to_f64() - 1.0) * width).abs() < 1e-14);
            let printed = printed_deviation(low, high);
            prop_assert!(((exact - printed) / exact).abs().to_f64() < 1e-30);
        }
    }

    #[test]
    fn without_a_mode_between_the_bounds_there_is_no_value() {
        for (d_s, d_l) in [(1.0, 2.0), (0.5, 1.0), (1.5, 2.0), (0.2, 0.5)] {
            let (kept, mean, std, m3) = truncated_moments(1.0, d_s, d_l);
            assert!([kept, mean, std, m3].iter().all(|number: &f64| number.is_nan()), "{d_s} {d_l}");
        }
    }

    #[test]
    fn the_moments_far_in_one_tail_keep_their_digits() {
        // the density by Simpson's rule from a limit to 12 deviations beyond
        let normal = |low: f64, high: f64| -> f64 {
            let (intervals, h) = (4000, (high - low) / 4000.0);
            let weight = |n: i32| {
                if n == 0 || n == intervals {
                    1.0
                } else if n % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            };
            (0..=intervals).map(|n| weight(n) * density(low + f64::from(n) * h) * h / 3.0).sum()
        };
        for (low, high) in [(-1.0, 2.0), (0.5, 2.4), (2.4, 2.6), (2.6, 3.0), (3.0, 9.0), (6.0, 8.0)] {
            for share in [between(low, high), between(-high, -low)] {
                assert!((share / normal(low, high) - 1.0).abs() < 1e-11, "{low} {high}");
            }
        }
        // both forms, each with digits enough, where the one gives way to the other and at their ends
        for z in [TAIL, 3.0, 5.0, 12.5] {
            let z = Reference::exact(z);
            let (tail, rest) = (beyond(z), Reference::exact(0.5) - beyond_the_middle(z));
            assert!((tail - rest).abs().to_f64() < 1e-38 && (tail / rest).to_f64() > 0.999, "{z:?}");
        }
        for limit in [13.0, 14.0, 1e3] {
            let [above, below] = [limit, -limit].map(|z| beyond_the_middle(Reference::exact(z)));
            let left = Reference::exact(0.5) - above;
            assert!(
                left.to_f64() > 0.0 && left.to_f64() < 1e-38 && above.to_decimal() == (-below).to_decimal(),
                "{limit}: {left:?}"
            );
        }
        // diameters whose largest is many modes: all moments are in one tail
        for [d_0, d_s, d_l] in [[1.0, 0.5, 300.0], [1.0, 0.5, 1e12]] {
            let exact = truncated_moments(Reference::exact(d_0), Reference::exact(d_s), Reference::exact(d_l));
            let printed = printed_deviation(Reference::exact(d_s), Reference::exact(d_l));
            assert!(((exact.2 - printed) / printed).abs().to_f64() < 1e-30, "{d_l}");
            let double = truncated_moments(d_0, d_s, d_l);
            let pairs = [(double.0, exact.0), (double.1, exact.1), (double.2, exact.2), (double.3, exact.3)];
            assert!(
                pairs.iter().all(|(double, exact)| (double / exact.to_f64() - 1.0).abs() < 1e-12),
                "{d_l} {double:?}"
            );
        }
    }

    #[test]
    fn gives_the_numbers_of_particles_of_table_6() {
        // 0.75 of 100 000 nm^3 holds about the 6000, 2600 and 600 particles of the paper.
        let particles = |m3: f64| 0.75e5 / (std::f64::consts::PI / 6.0 * m3);
        for (d_0, expected) in [(1.5, 5542.0), (3.0, 2540.0), (6.0, 626.0)] {
            let (.., m3) = truncated_moments(d_0, 0.75 * d_0, 7.5);
            assert!((particles(m3) - expected).abs() <= 1.0);
        }
        // A standard deviation of the logarithm in place of the diameter's would not.
        let (d_0, d_s, d_l) = (1.5, 0.75 * 1.5, 7.5);
        let sigma = 0.2 * (d_l - d_s) / d_0;
        let (mut kept, mut m3) = (0.0, 0.0);
        for n in 0..10_000 {
            let d = d_s + (f64::from(n) + 0.5) * 1e-4 * (d_l - d_s);
            let z = f64::ln(d / d_0) / sigma - sigma;
            let density = (-0.5 * z * z).exp() / d;
            (kept, m3) = (kept + density, m3 + density * d * d * d);
        }
        assert!(particles(m3 / kept) < 2200.0);
    }
}
