//! The exact shape of the meniscus between two particles.
//!
//! Not in the paper: the profile of constant curvature, where [`def_meniscus`](super::def_meniscus) takes an arc of a circle. At the height $z$ above the neck the liquid has the radius $y(z)$, and
//! the pressure in it is lower by $\gamma / r_K$ than outside. Multiplied by $y \, y'$, the equation of Young and Laplace has the first integral
//!
//! ```math
//! \frac{y}{\sqrt{1 + y'^2}} + \frac{y^2}{2 r_K} = C
//! ```
//!
//! $2 \pi \gamma C$ is the force through every cross-section. At the wetted circle of radius $w = R \sin\beta$ the profile meets the sphere at the angle $\theta$, so $C = w s + w^2 / (2 r_K)$ with
//! $s = \sin(\theta + \beta)$: against the half-filling angle the force is that of the circular approximation ([`capillary_force`](super::def_capillary::capillary_force)), and only the distance differs.

use super::def_capillary::{angle_slope, work_along};
use super::def_meniscus::{angle_on, rupture_of};
use crate::equation::Equation;
use crate::real::ln_one_plus;
use crate::{Real, equation};

/// Steps of the arithmetic-geometric mean: each doubles the digits. They suffice for numbers of 256 bits while the neck is less than $10^8$ times as wide as the Kelvin radius.
const STEPS: usize = 10;

/// Largest radius, in Kelvin radii. The terms of the height exceed the height by $w / r_K$: between larger particles too many digits cancel, and there
/// the circular approximation suffices.
const LARGEST: f64 = 1e4;

/// Distance of two layers whose meniscus has a given half-filling angle, by the exact profile, and its slope.
///
/// ```math
/// D = 2 h - 4 R \sin^2\tfrac{\beta}{2}, \quad h = \int_l^w \frac{dy}{y'} = \int_l^w \frac{(l m - y^2) \, dy}{\sqrt{(y^2 - l^2)(m^2 - y^2)}}, \quad
/// l = \sqrt{r_K^2 + 2 r_K C} - r_K, \quad m = l + 2 r_K
/// ```
///
/// # Reading
///
/// $l$ is the radius of the neck. With $t^2 = l^2 (m^2 - y^2) / (y^2 - l^2)$ and $I = \int_{t_0}^\infty dt / \sqrt{(t^2 + l^2)(t^2 + m^2)}$ the elliptic integrals become those that
/// Gauss's transformation of $t$ leaves as they are. With $a_0 = m$, $c_0 = l$ and $u = 1/t$
///
/// ```math
/// a_{n+1} = \frac{a_n + \sqrt{a_n^2 - c_n^2}}{2}, \quad c_{n+1} = \frac{c_n^2}{4 a_{n+1}}, \quad u_{n+1} = \frac{2 u_n}{1 + \sqrt{1 + c_n^2 u_n^2}}, \quad
/// I = \frac{\operatorname{arsinh}(a_\infty u_\infty)}{a_\infty}
/// ```
///
/// ```math
/// h = \left(l m - \sum_{n \ge 0} 2^{n-1} c_n^2\right) I - \frac{w \sigma}{1 + \rho} + \sum_{n \ge 1} 2^{n-1} c_n^2 u_{n+1} \sqrt{1 + a_n^2 u_n^2}, \quad
/// \sigma^2 = 1 - \rho^2 = \frac{w^2 - l^2}{m^2 - l^2}, \quad u_1 = \frac{2 \sigma}{l (1 + \rho)}
/// ```
///
/// $a_n$ is the arithmetic-geometric mean of $m$ and $\sqrt{m^2 - l^2}$: ten steps give all digits, and square roots and a logarithm are all that a number needs. $l/w$, $\sigma$ and $\rho$ are computed without cancellation. The
/// slope follows from the derivatives of the elliptic integrals, in which the singular terms of the neck and of the wetted circle cancel:
///
/// ```math
/// \frac{dh}{d\beta} = \frac{r_K}{a^2} \left[C' (2 r_K^2 I + h) - w (w' \cos(\theta + \beta) + w s + r_K)\right], \quad a = l + r_K
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles, at most $10^4 \, r_K$ |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, 1.5] | contact angle |
/// | `beta` | $\beta$ | rad | (0, pi/2] | half-filling angle, at most $\pi/2 - \theta$ |
/// | → `gap` | $D$ | m | | distance of the layers, negative when they overlap |
/// | → `slope` | $dD/d\beta$ | m | | its slope |
///
/// Rounding: at most 3 ULP.
///
/// # Laws
///
/// * `the_height_is_the_integral_of_the_profile`
/// * `the_slope_of_the_gap_is_its_derivative`
/// * `short_menisci_are_nearly_circular`
/// * `particles_much_larger_than_the_kelvin_radius_have_no_value`
#[inline]
pub fn exact_gap<R: Real>(r_eff: R, r_k: R, theta: R, beta: R) -> (R, R) {
    let (one, two, half) = (R::one(), R::lit(2.0), R::lit(0.5));
    let (w, w_slope) = (r_eff * beta.sin(), r_eff * beta.cos());
    let (s, c) = ((theta + beta).sin(), (theta + beta).cos());
    let (around, suction) = (w * s, half * w.squared());
    let a = (r_k.squared() + two * (r_k * around + suction)).sqrt();
    let share = (two * r_k * s + w) / (a + r_k);
    let (l, m) = (w * share, w * share + two * r_k);

    let sigma = c * ((one + share) / (two * (one + s) * (w + m) * a)).sqrt();
    let part = one + ((m + around) / (two * a)).sqrt();
    let mut u = two * sigma / (share * part);

    let root = two * (r_k * (l + r_k)).sqrt();
    let mut mean = half * (m + root);
    let mut difference = l.squared() / (two * (m + root));
    let (mut weight, mut first, mut rest) = (one, l * m - half * l.squared(), R::zero());
    for _ in 0..STEPS {
        let square = weight * difference.squared();
        let next = two * u / (one + (one + (difference * u).squared()).sqrt());
        first = first - square;
        rest = rest + square * next * (one + (mean * u).squared()).sqrt();
        let following = half * (mean + (mean.squared() - difference.squared()).sqrt());
        difference = difference.squared() / (R::lit(4.0) * following);
        (mean, u, weight) = (following, next, two * weight);
    }
    let x = mean * u;
    let integral = ln_one_plus(x + x.squared() / (one + (one + x.squared()).sqrt())) / mean;

    let height = first * integral - w.squared() * sigma / part + rest;
    let c_slope = r_k * (w_slope * s + w * c) + w * w_slope;
    let grows = c_slope * (two * r_k.squared() * integral + height) - r_k * w * (w_slope * c + around + r_k);
    let gap = two * height - R::lit(4.0) * r_eff * (half * beta).sin().squared();
    let (resolved, none) = (r_eff.le(R::lit(LARGEST) * r_k), R::zero() / R::zero());
    (R::select(resolved, gap, none), R::select(resolved, two * grows / a.squared() - two * w, none))
}

/// Where the exact meniscus ruptures: the angle and the distance at which its branch ends.
///
/// ```math
/// \frac{dD}{d\beta}(\beta_r) = 0, \quad D_r = D(\beta_r)
/// ```
///
/// # Reading
///
/// As [`rupture`](super::def_meniscus::rupture), by sixty bisections. Two particles of 8 nm at half humidity part at a distance of their bare surfaces that is 0.11 nm larger than in the circular approximation.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles, at most $10^4 \, r_K$ |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, 1.5] | contact angle |
/// | → `beta_r` | $\beta_r$ | rad | | half-filling angle at rupture |
/// | → `gap_r` | $D_r$ | m | | distance of the layers at rupture |
///
/// Rounding: at most 8 ULP.
///
/// # Laws
///
/// * `no_meniscus_reaches_beyond_the_rupture`
/// * `an_exact_meniscus_ruptures_farther_out_than_a_circular_one`
/// * `scales_with_radius_and_kelvin_radius`
#[inline]
pub fn exact_rupture<R: Real>(r_eff: R, r_k: R, theta: R) -> (R, R) {
    rupture_of(theta, |beta| exact_gap(r_eff, r_k, theta, beta))
}

/// Half-filling angle of the exact meniscus at a given distance: the stable branch, zero beyond the rupture.
///
/// ```math
/// D(\beta) = D, \quad \beta_r \le \beta \le \frac{\pi}{2} - \theta
/// ```
///
/// # Reading
///
/// As [`half_filling_angle`](super::def_meniscus::half_filling_angle), with the exact distance.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles, at most $10^4 \, r_K$ |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, 1.5] | contact angle |
/// | `gap` | $D$ | m | any | distance of the layers |
/// | → `beta` | $\beta$ | rad | | half-filling angle |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `the_angle_gives_back_the_distance`
/// * `the_force_of_the_exact_meniscus_at_the_distances_of_a_worked_example`
#[inline]
pub fn exact_half_filling_angle<R: Real>(r_eff: R, r_k: R, theta: R, gap: R) -> R {
    let (beta_r, gap_r) = exact_rupture(r_eff, r_k, theta);
    angle_on(theta, beta_r, gap_r, gap, |beta| exact_gap(r_eff, r_k, theta, beta))
}

/// Slope of the force of the exact meniscus with respect to the distance.
///
/// ```math
/// \frac{dF_{cap}}{dd} = \frac{dF_{cap}}{d\beta} \Big/ \frac{dD}{d\beta}
/// ```
///
/// # Reading
///
/// As [`capillary_slope`](super::def_capillary::capillary_slope), with the exact distance. At rupture the slope is infinite.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles, at most $10^4 \, r_K$ |
/// | `theta` | $\theta$ | rad | [0, 1.5] | contact angle |
/// | `beta` | $\beta$ | rad | (0, pi/2] | half-filling angle, not the angle at rupture |
/// | → `slope` | $F'_{cap}$ | N/m | | change of the force with the distance |
///
/// Rounding: at most 3 ULP.
///
/// # Laws
///
/// * `the_slope_is_the_derivative_along_the_branch`
#[inline]
pub fn exact_slope<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R) -> R {
    angle_slope(gamma, r_k, r_eff, theta, beta) / exact_gap(r_eff, r_k, theta, beta).1
}

/// Work of the force of the exact meniscus during separation, from a given half-filling angle to the angle at rupture.
///
/// ```math
/// W = \int_d^{d_r} F_{cap} \, dd = \int_{\beta}^{\beta_r} F_{cap} \frac{dD}{d\beta} \, d\beta
/// ```
///
/// # Reading
///
/// As [`capillary_work`](super::def_capillary::capillary_work), by ten-point Gauss quadrature, with the exact distance.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles, at most $10^4 \, r_K$ |
/// | `theta` | $\theta$ | rad | [0, 1.5] | contact angle |
/// | `beta` | $\beta$ | rad | (0, pi/2] | half-filling angle |
/// | `beta_r` | $\beta_r$ | rad | (0, pi/2] | half-filling angle at rupture |
/// | → `w` | $W$ | J | | work |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_force_is_the_slope_of_the_work`
#[inline]
pub fn exact_work<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R, beta_r: R) -> R {
    work_along(gamma, r_k, r_eff, theta, beta, beta_r, |beta| exact_gap(r_eff, r_k, theta, beta).1)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_exact_meniscus.rs", "titania-exact-gap", [], exact_gap),
        equation!("titania/def_exact_meniscus.rs", "titania-exact-rupture", [], exact_rupture),
        equation!("titania/def_exact_meniscus.rs", "titania-exact-half-filling", [], exact_half_filling_angle),
        equation!("titania/def_exact_meniscus.rs", "titania-exact-slope", [], exact_slope),
        equation!("titania/def_exact_meniscus.rs", "titania-exact-work", [], exact_work),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use crate::titania::def_capillary::capillary_force;
    use crate::titania::def_meniscus::{meniscus_gap, rupture};
    use approx::relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    // nm, nN: 4 nm nominal radius, half humidity
    const R_EFF: f64 = 4.153312960445846;
    const GAMMA: f64 = 0.108;
    const R_K: f64 = 1.1273674384933128;

    prop_compose! {
        fn menisci()(r_eff in 0.5..20.0, r_k in 0.1..5.0, theta in prop_oneof![Just(0.0), 0.0..1.3], share in 0.02..0.98)
            -> (f64, f64, f64, f64) {
            (r_eff, r_k, theta, share * (FRAC_PI_2 - theta))
        }
    }

    fn force(gap: f64) -> f64 {
        capillary_force(GAMMA, R_K, R_EFF, 0.0, exact_half_filling_angle(R_EFF, R_K, 0.0, gap))
    }

    proptest! {
        /// By the midpoint rule, with y = l + (w - l) x^2, which takes the singularity of the neck.
        #[test]
        fn the_height_is_the_integral_of_the_profile((r_eff, r_k, theta, beta) in menisci()) {
            let (w, s) = (r_eff * Real::sin(beta), Real::sin(theta + beta));
            let c = w * s + w * w / (2.0 * r_k);
            let l = Real::sqrt(r_k * r_k + 2.0 * r_k * c) - r_k;
            let (steps, length) = (2000, w - l);
            let height: f64 = (0..steps).map(|k| {
                let x = (f64::from(k) + 0.5) / f64::from(steps);
                let y = l + length * x * x;
                // 1 / sqrt(1 + y'^2)
                let lean = (c - y * y / (2.0 * r_k)) / y;
                // 1 - lean is zero at the neck, as x^2
                let rest = (length * x * x) * (y + l + 2.0 * r_k) / (2.0 * r_k * y);
                2.0 * length * x * lean / Real::sqrt(rest * (1.0 + lean))
            }).sum::<f64>() / f64::from(steps);
            let gap = 2.0 * height - 2.0 * r_eff * (1.0 - Real::cos(beta));
            prop_assert!((exact_gap(r_eff, r_k, theta, beta).0 - gap).abs() < 2e-6 * (r_eff + r_k), "{} {gap}", exact_gap(r_eff, r_k, theta, beta).0);
        }

        #[test]
        fn the_slope_of_the_gap_is_its_derivative((r_eff, r_k, theta, beta) in menisci()) {
            let c = Dual::constant;
            let (gap, slope) = exact_gap(c(r_eff), c(r_k), c(theta), Dual::variable(beta));
            prop_assert!((gap.slope - slope.value).abs() < 1e-11 * (r_eff + r_k), "{} {}", gap.slope, slope.value);
        }

        /// Both are arcs of the same angle at the sphere; they differ as the meridian curves over the height.
        #[test]
        fn short_menisci_are_nearly_circular(r_eff in 5.0..20.0, share in 0.001..0.01, beta in 0.9..1.5) {
            let r_k = share * r_eff;
            let (exact, circular) = (exact_gap(r_eff, r_k, 0.0, beta).0, meniscus_gap(r_eff, r_k, 0.0, beta).0);
            prop_assert!((exact - circular).abs() < 2.0 * share * r_k, "{exact} {circular}");
        }

        #[test]
        fn no_meniscus_reaches_beyond_the_rupture((r_eff, r_k, theta, beta) in menisci()) {
            let (beta_r, gap_r) = exact_rupture(r_eff, r_k, theta);
            let (gap, slope) = exact_gap(r_eff, r_k, theta, beta);
            prop_assert!(gap <= gap_r + 1e-13 * (r_eff + r_k));
            prop_assert!((exact_gap(r_eff, r_k, theta, beta_r).0 - gap_r).abs() < 1e-13 * (r_eff + r_k));
            prop_assert!((beta - beta_r).abs() < 1e-9 || (slope > 0.0) == (beta < beta_r));
            prop_assert_eq!(exact_half_filling_angle(r_eff, r_k, theta, gap_r + 1e-9), 0.0);
        }

        #[test]
        fn an_exact_meniscus_ruptures_farther_out_than_a_circular_one(r_eff in 0.5..20.0, r_k in 0.1..5.0, theta in 0.0..0.5) {
            prop_assert!(exact_rupture(r_eff, r_k, theta).1 > rupture(r_eff, r_k, theta).1);
        }

        #[test]
        fn scales_with_radius_and_kelvin_radius(r_eff in 0.5..20.0, r_k in 0.1..5.0, theta in 0.0..1.3, factor in 0.1..10.0) {
            let (gap, grown) = (exact_rupture(r_eff, r_k, theta).1, exact_rupture(factor * r_eff, factor * r_k, theta).1);
            prop_assert!(relative_eq!(grown, factor * gap, max_relative = 1e-11));
        }

        #[test]
        fn the_angle_gives_back_the_distance((r_eff, r_k, theta, _) in menisci(), share in 0.0..1.0f64, power in 1..9) {
            let (gap_r, closed) = (exact_rupture(r_eff, r_k, theta).1, exact_gap(r_eff, r_k, theta, FRAC_PI_2 - theta).0);
            let gap = gap_r - (gap_r - closed) * share.powi(power);
            let beta = exact_half_filling_angle(r_eff, r_k, theta, gap);
            prop_assert!((exact_gap(r_eff, r_k, theta, beta).0 - gap).abs() < 1e-13 * (r_eff + r_k));
        }

        #[test]
        fn the_slope_is_the_derivative_along_the_branch(gap in -0.6..0.6) {
            let h = 1e-5;
            let slope = exact_slope(GAMMA, R_K, R_EFF, 0.0, exact_half_filling_angle(R_EFF, R_K, 0.0, gap));
            let central = (force(gap + h) - force(gap - h)) / (2.0 * h);
            prop_assert!(relative_eq!(slope, central, max_relative = 1e-6), "{slope} {central}");
        }

        #[test]
        fn the_force_is_the_slope_of_the_work(gap in -0.6..0.68) {
            let h = 1e-4;
            let beta_r = exact_rupture(R_EFF, R_K, 0.0).0;
            let work = |gap: f64| exact_work(GAMMA, R_K, R_EFF, 0.0, exact_half_filling_angle(R_EFF, R_K, 0.0, gap), beta_r);
            let central = (work(gap - h) - work(gap + h)) / (2.0 * h);
            prop_assert!((force(gap) - central).abs() < 1e-5, "{} {central}", force(gap));
        }
    }

    #[test]
    fn particles_much_larger_than_the_kelvin_radius_have_no_value() {
        for r_k in [0.3, 1.0, 7.0] {
            let ends = |r_eff: f64| {
                let (beta_r, gap_r) = exact_rupture(r_eff, r_k, 0.2);
                let (gap, slope) = exact_gap(r_eff, r_k, 0.2, 0.5);
                let along = [exact_slope(1.0, r_k, r_eff, 0.2, 0.5), exact_work(1.0, r_k, r_eff, 0.2, 0.5, beta_r)];
                [gap_r, gap, slope, along[0], along[1]]
            };
            let largest = LARGEST * r_k;
            assert!(ends(largest).iter().all(|x| x.is_finite()), "{:?}", ends(largest));
            assert!(ends(largest.next_up()).iter().all(|x| x.is_nan()), "{:?}", ends(largest.next_up()));
        }
    }

    /// Solved with the first integral by an integrator and by root finding, independently of the formulas here.
    #[test]
    fn the_force_of_the_exact_meniscus_at_the_distances_of_a_worked_example() {
        let rows = [(7.8, 3.0245), (8.0, 2.7389), (8.15, 2.5144), (8.5, 1.9433), (8.7, 1.5683), (8.88, 1.1578)];
        for (d, f_cap) in rows {
            assert!((force(d - 2.0 * R_EFF) - f_cap).abs() < 6e-5, "{d}: {}", force(d - 2.0 * R_EFF));
        }
        assert!((exact_rupture(R_EFF, R_K, 0.0).1 + 2.0 * R_EFF - 9.002).abs() < 5e-4);
    }
}
