//! The capillary force of a meniscus.

use super::def_meniscus::meniscus_gap;
use crate::equation::Equation;
use crate::{Real, equation};

/// Not in the paper: capillary force of a meniscus in equilibrium with the air.
///
/// ```math
/// F_{cap} = \pi \gamma R \sin\beta \left[2 \sin(\theta + \beta) + \frac{R \sin\beta}{r_K}\right]
/// ```
///
/// # Reading
///
/// Surface tension around the wetted circle and suction over its area, in the circular approximation; the curvature follows from Kelvin's equation.
/// Positive when it attracts, as Eq. 3 takes it. Without a meniscus, $\beta = 0$, it is zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | `beta` | $\beta$ | rad | [0, pi/2] | half-filling angle |
/// | → `f_cap` | $F_{cap}$ | N | | capillary force |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_worked_example_of_two_particles_of_4_nanometre`
/// * `large_spheres_in_touch_are_held_by_two_pi_gamma_r_cos_theta`
/// * `the_ends_of_the_branch_for_pairs_of_sizes`
#[inline]
pub fn capillary_force<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R) -> R {
    let a = r_eff * beta.sin();
    R::pi() * gamma * a * (R::lit(2.0) * (theta + beta).sin() + a / r_k)
}

/// Not in the paper: slope of the capillary force with respect to the distance.
///
/// ```math
/// \frac{dF_{cap}}{dd} = \frac{dF_{cap}}{d\beta} \Big/ \frac{dD}{d\beta}
/// ```
///
/// # Reading
///
/// Along the branch both depend on the angle. At rupture the slope is infinite: the force decreases like the square root of the remaining distance.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | `beta` | $\beta$ | rad | (0, pi/2] | half-filling angle, not the angle at rupture |
/// | → `slope` | $F'_{cap}$ | N/m | | change of the force with the distance |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_slope_is_the_derivative_along_the_branch`
#[inline]
pub fn capillary_slope<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R) -> R {
    angle_slope(gamma, r_k, r_eff, theta, beta) / meniscus_gap(r_eff, r_k, theta, beta).1
}

/// Change of the capillary force with the angle.
#[inline]
pub(super) fn angle_slope<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R) -> R {
    let (two, sum) = (R::lit(2.0), theta + beta);
    let (a, a_slope) = (r_eff * beta.sin(), r_eff * beta.cos());
    R::pi() * gamma * two * (a_slope * (sum.sin() + a / r_k) + a * sum.cos())
}

/// Not in the paper: work of the capillary force during separation, from a given half-filling angle to the angle at rupture.
///
/// ```math
/// W = \int_d^{d_r} F_{cap} \, dd = \int_{\beta}^{\beta_r} F_{cap} \frac{dD}{d\beta} \, d\beta
/// ```
///
/// # Reading
///
/// By ten-point Gauss quadrature: the integrand is smooth in the angle up to rupture.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | `beta` | $\beta$ | rad | [0, pi/2] | half-filling angle |
/// | `beta_r` | $\beta_r$ | rad | [0, pi/2] | half-filling angle at rupture |
/// | → `w` | $W$ | J | | work |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_force_is_the_slope_of_the_work`
#[inline]
pub fn capillary_work<R: Real>(gamma: R, r_k: R, r_eff: R, theta: R, beta: R, beta_r: R) -> R {
    work_along(gamma, r_k, r_eff, theta, beta, beta_r, |beta| meniscus_gap(r_eff, r_k, theta, beta).1)
}

/// The work of a meniscus of any shape, given the slope of its distance against the half-filling angle.
#[inline]
pub(super) fn work_along<R: Real>(
    gamma: R,
    r_k: R,
    r_eff: R,
    theta: R,
    beta: R,
    beta_r: R,
    slope: impl Fn(R) -> R,
) -> R {
    const POINTS: [(f64, f64); 5] = [
        (0.14887433898163122, 0.29552422471475287),
        (0.4333953941292472, 0.26926671930999636),
        (0.6794095682990244, 0.21908636251598204),
        (0.8650633666889845, 0.1494513491505806),
        (0.9739065285171717, 0.06667134430868814),
    ];
    let (middle, half) = (R::lit(0.5) * (beta + beta_r), R::lit(0.5) * (beta_r - beta));
    let power = |beta: R| capillary_force(gamma, r_k, r_eff, theta, beta) * slope(beta);
    let weighed = POINTS.map(|(x, weight)| {
        let off = half * R::lit(x);
        (power(middle - off) + power(middle + off)) * R::lit(weight)
    });
    weighed.into_iter().fold(R::zero(), |sum, x| sum + x) * half
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_capillary.rs", "titania-capillary", [], capillary_force),
        equation!("titania/def_capillary.rs", "titania-capillary-slope", [], capillary_slope),
        equation!("titania/def_capillary.rs", "titania-capillary-work", [], capillary_work),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::def_meniscus::{half_filling_angle, rupture};
    use crate::titania::def_radius::effective_radius;
    use approx::relative_eq;
    use proptest::prelude::*;

    // nm, nN: 4 nm nominal radius, half humidity
    const R_EFF: f64 = 4.153312960445846;
    const GAMMA: f64 = 0.108;
    const R_K: f64 = 1.1273674384933128;

    fn force(gap: f64) -> f64 {
        capillary_force(GAMMA, R_K, R_EFF, 0.0, half_filling_angle(R_EFF, R_K, 0.0, gap))
    }

    #[test]
    fn the_worked_example_of_two_particles_of_4_nanometre() {
        let rows = [
            (-0.50663, 37.2740, 2.93791),
            (-0.40663, 36.1633, 2.78909),
            (-0.30663, 35.0039, 2.63570),
            (-0.15663, 33.1539, 2.39568),
            (0.19337, 28.0332, 1.76926),
            (0.39337, 24.0572, 1.33107),
            (0.57337, 17.1400, 0.69568),
        ];
        for (gap, degrees, f_cap) in rows {
            let beta: f64 = half_filling_angle(R_EFF, R_K, 0.0, gap);
            assert!((beta.to_degrees() - degrees).abs() < 2e-3, "{gap}: {}", beta.to_degrees());
            assert!((force(gap) - f_cap).abs() < 2e-4, "{gap}: {}", force(gap));
        }
    }

    #[test]
    fn the_ends_of_the_branch_for_pairs_of_sizes() {
        let suction = 0.108 / R_K;
        for (r_i, r_j, gamma, d_r, f_r, degrees) in [
            (4.0, 4.0, 0.108, 8.8889, 0.555, 15.26),
            (8.0, 8.0, 0.091, 17.0247, 0.812, 10.45),
            (4.0, 10.0, 0.108, 14.9982, 0.752, 13.18),
            (10.0, 10.0, 0.091, 21.0850, 0.974, 9.36),
        ] {
            let layer = 0.4383129604458464 - 0.285;
            let r_k = gamma / suction;
            let r_eff = effective_radius(r_i + layer, r_j + layer).0;
            let (beta_r, gap_r) = rupture(r_eff, r_k, 0.0);
            assert!((gap_r + r_i + r_j + 2.0 * layer - d_r).abs() < 1e-4);
            assert!((beta_r.to_degrees() - degrees).abs() < 6e-3);
            assert!((capillary_force(gamma, r_k, r_eff, 0.0, beta_r) - f_r).abs() < 6e-4);
        }
    }

    proptest! {
        #[test]
        fn large_spheres_in_touch_are_held_by_two_pi_gamma_r_cos_theta(r_k in 0.1..2.0, theta in 0.0..1.3) {
            let (gamma, r_eff) = (0.1, 1e8);
            let beta = half_filling_angle(r_eff, r_k, theta, 0.0);
            let limit = 2.0 * std::f64::consts::PI * gamma * r_eff * theta.cos();
            prop_assert!(relative_eq!(capillary_force(gamma, r_k, r_eff, theta, beta), limit, max_relative = 2e-3));
        }

        #[test]
        fn the_slope_is_the_derivative_along_the_branch(gap in -0.6..0.5) {
            let h = 1e-5;
            let slope = capillary_slope(GAMMA, R_K, R_EFF, 0.0, half_filling_angle(R_EFF, R_K, 0.0, gap));
            let central = (force(gap + h) - force(gap - h)) / (2.0 * h);
            prop_assert!(relative_eq!(slope, central, max_relative = 1e-6), "{slope} {central}");
        }

        #[test]
        fn the_force_is_the_slope_of_the_work(gap in -0.6..0.57) {
            let h = 1e-4;
            let beta_r = rupture(R_EFF, R_K, 0.0).0;
            let work = |gap: f64| capillary_work(GAMMA, R_K, R_EFF, 0.0, half_filling_angle(R_EFF, R_K, 0.0, gap), beta_r);
            let central = (work(gap - h) - work(gap + h)) / (2.0 * h);
            prop_assert!((force(gap) - central).abs() < 1e-5, "{} {central}", force(gap));
        }
    }
}
