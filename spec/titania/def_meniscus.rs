//! The shape of the meniscus between two particles.
//!
//! Not in the paper, which refers to earlier work for it: classical capillarity in the circular (toroidal) approximation. The profile of the liquid is an
//! arc of radius $r$, its neck has the radius $l$, it meets spheres of the radius $R$ at the angle $\theta$ and covers them up to the half-filling
//! angle $\beta$. Unlike spheres are replaced by equal ones of their harmonic mean radius; all lengths include the water layer.
//!
//! With $A = R \sin\beta$, $c = \cos(\theta + \beta)$, $s = \sin(\theta + \beta)$ and the height $g = 2R(1 - \cos\beta) + D$ of the meniscus,
//!
//! ```math
//! r = \frac{g}{2c}, \quad l = A - r (1 - s), \quad \frac{1}{r} - \frac{1}{l} = \frac{1}{r_K}
//! ```
//!
//! For a given angle the last equation is quadratic in $g$, so the distance follows in closed form and the largest distance is the rupture distance.

use crate::equation::Equation;
use crate::{Real, equation};

/// Quantities that the angle alone determines.
struct Profile<R> {
    a: R,
    a_slope: R,
    c: R,
    s: R,
    root: R,
    height: R,
    beta: R,
}

impl<R: Real> Profile<R> {
    #[inline]
    fn new(r_eff: R, r_k: R, theta: R, beta: R) -> Self {
        let two = R::lit(2.0);
        let (a, c, s) = (r_eff * beta.sin(), (theta + beta).cos(), (theta + beta).sin());
        let sum = a + r_k * (two - s);
        let root = (a.squared() + two * r_k * a * s + (r_k * (two - s)).squared()).sqrt();
        let height = R::lit(4.0) * c * r_k * a / (sum + root);
        Self { a, a_slope: r_eff * beta.cos(), c, s, root, height, beta }
    }
    #[inline]
    fn gap(&self, r_eff: R) -> R {
        self.height - R::lit(4.0) * r_eff * (R::lit(0.5) * self.beta).sin().squared()
    }
    #[inline]
    fn slope(&self, r_k: R) -> R {
        let two = R::lit(2.0);
        let bend = self.height.squared() / (two * (R::one() + self.s));
        let lean = (self.a_slope - r_k * self.c) * self.height;
        let neck = two * r_k * (self.c * self.a_slope - self.s * self.a);
        (neck - bend - lean) / self.root - two * self.a
    }
}

/// Distance of two layers whose meniscus has a given half-filling angle, and its slope.
///
/// ```math
/// D = g - 4 R \sin^2\tfrac{\beta}{2}, \quad g = \frac{4 c \, r_K A}{S + Q}, \quad
/// S = A + r_K (2 - s), \quad Q = \sqrt{A^2 + 2 r_K A s + r_K^2 (2 - s)^2}
/// ```
///
/// # Reading
///
/// Multiplied by $r_K r l$, the condition of equilibrium becomes $\frac{c}{2(1 + s)} g^2 - S g + 2 c \, r_K A = 0$; the smaller root has a neck of
/// positive radius. $Q^2$ is the discriminant, a sum of positive terms. The slope follows from the derivative of the quadratic, divided by $-Q$.
/// Where the Kelvin radius and the filling angle are tiny, the gap is a small difference: such menisci determine the rounding bound.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | `beta` | $\beta$ | rad | [0, pi/2] | half-filling angle, at most $\pi/2 - \theta$ |
/// | → `gap` | $D$ | m | | distance of the layers, negative when they overlap |
/// | → `slope` | $dD/d\beta$ | m | | its slope |
///
/// Rounding: at most 16 ULP.
///
/// # Laws
///
/// * `the_meniscus_has_the_curvature_of_kelvin`
/// * `the_slope_of_the_gap_is_its_derivative`
#[inline]
pub fn meniscus_gap<R: Real>(r_eff: R, r_k: R, theta: R, beta: R) -> (R, R) {
    let profile = Profile::new(r_eff, r_k, theta, beta);
    (profile.gap(r_eff), profile.slope(r_k))
}

/// Where the meniscus ruptures: the angle and the distance at which its branch ends.
///
/// ```math
/// \frac{dD}{d\beta}(\beta_r) = 0, \quad D_r = D(\beta_r)
/// ```
///
/// # Reading
///
/// The distance increases with the angle up to rupture and decreases beyond. Below the rupture angle a stretched meniscus would shrink by its
/// own suction: that branch is unstable. Sixty bisections resolve the angle to the last bit of a double, and the distance to twice as many
/// bits.
/// Where the Kelvin radius is tiny compared with the particles, the gap is a small difference: such menisci determine the rounding bound.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | → `beta_r` | $\beta_r$ | rad | | half-filling angle at rupture |
/// | → `gap_r` | $D_r$ | m | | distance of the layers at rupture |
///
/// Rounding: at most 24 ULP.
///
/// # Laws
///
/// * `no_meniscus_reaches_beyond_the_rupture`
/// * `scales_with_radius_and_kelvin_radius`
/// * `a_liquid_that_hardly_wets_ruptures_too`
#[inline]
pub fn rupture<R: Real>(r_eff: R, r_k: R, theta: R) -> (R, R) {
    rupture_of(theta, |beta| meniscus_gap(r_eff, r_k, theta, beta))
}

/// The rupture of a meniscus of any shape, given its distance against the half-filling angle, and the slope.
#[inline]
pub(super) fn rupture_of<R: Real>(theta: R, distance: impl Fn(R) -> (R, R)) -> (R, R) {
    let (half, mut low, mut high) = (R::lit(0.5), R::zero(), R::lit(0.5) * R::pi() - theta);
    for _ in 0..60 {
        let middle = half * (low + high);
        let rises = distance(middle).1.gt(R::zero());
        low = R::select(rises, middle, low);
        high = R::select(rises, high, middle);
    }
    let beta_r = half * (low + high);
    (beta_r, distance(beta_r).0)
}

/// Half-filling angle of the meniscus at a given distance: the stable branch, zero beyond the rupture.
///
/// ```math
/// D(\beta) = D, \quad \beta_r \le \beta \le \frac{\pi}{2} - \theta
/// ```
///
/// # Reading
///
/// On the stable branch $\varphi(\beta) = \sqrt{D_r - D(\beta)}$ is nearly linear, down to the rupture: Newton's method for
/// $\varphi(\beta) = \sqrt{D_r - D}$ starts on the chord and converges in a few steps; a step that would leave the branch goes halfway to
/// its end instead. Spheres that overlap so far that no meniscus is left have the largest angle.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $R$ | m | > 0 | harmonic mean radius of the water-covered particles |
/// | `r_k` | $r_K$ | m | > 0 | Kelvin radius |
/// | `theta` | $\theta$ | rad | [0, pi/2) | contact angle |
/// | `gap` | $D$ | m | any | distance of the layers |
/// | → `beta` | $\beta$ | rad | | half-filling angle |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_angle_gives_back_the_distance`
/// * `the_angle_falls_as_the_particles_part`
/// * `the_branch_ends_at_the_angle_of_rupture_and_at_the_largest`
#[inline]
pub fn half_filling_angle<R: Real>(r_eff: R, r_k: R, theta: R, gap: R) -> R {
    let (beta_r, gap_r) = rupture(r_eff, r_k, theta);
    angle_on(theta, beta_r, gap_r, gap, |beta| meniscus_gap(r_eff, r_k, theta, beta))
}

/// The half-filling angle of a meniscus of any shape, when its rupture is known.
#[inline]
pub(super) fn angle_on<R: Real>(theta: R, beta_r: R, gap_r: R, gap: R, distance: impl Fn(R) -> (R, R)) -> R {
    let (half, zero, two) = (R::lit(0.5), R::zero(), R::lit(2.0));
    let depth = |gap: R| (gap_r - gap).max(zero).sqrt();
    let end = half * R::pi() - theta;
    let (target, largest) = (depth(gap), depth(distance(end).0));
    let mut beta = beta_r + (end - beta_r) * (target / largest).min(R::one());
    for _ in 0..9 {
        let (here, slope) = distance(beta);
        let here = depth(here);
        let newton = beta + two * here * (here - target) / slope;
        let inside = R::select(newton.lt(beta_r), half * (beta + beta_r), newton.min(end));
        beta = R::select(slope.lt(zero), inside, beta);
    }
    R::select(gap.le(gap_r), beta, zero)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_meniscus.rs", "titania-meniscus-gap", [], meniscus_gap),
        equation!("titania/def_meniscus.rs", "titania-rupture", [], rupture),
        equation!("titania/def_meniscus.rs", "titania-half-filling", [], half_filling_angle),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use approx::relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    prop_compose! {
        fn menisci()(r_eff in 0.5..20.0, r_k in 0.1..5.0, theta in prop_oneof![Just(0.0), 0.0..1.3], share in 0.02..0.98)
            -> (f64, f64, f64, f64) {
            (r_eff, r_k, theta, share * (FRAC_PI_2 - theta))
        }
    }

    proptest! {
        #[test]
        fn the_meniscus_has_the_curvature_of_kelvin((r_eff, r_k, theta, beta) in menisci()) {
            let (gap, _) = meniscus_gap(r_eff, r_k, theta, beta);
            let r = (2.0 * r_eff * (1.0 - beta.cos()) + gap) / (2.0 * (theta + beta).cos());
            let l = r_eff * beta.sin() - r * (1.0 - (theta + beta).sin());
            prop_assert!(r > 0.0 && l > 0.0);
            prop_assert!(((1.0 / r - 1.0 / l) * r_k - 1.0).abs() < 1e-11 * (1.0 + r_eff / r) * (1.0 + r_k / l) * (1.0 + r_k / r));
        }

        #[test]
        fn the_slope_of_the_gap_is_its_derivative((r_eff, r_k, theta, beta) in menisci()) {
            let c = Dual::constant;
            let (gap, slope) = meniscus_gap(c(r_eff), c(r_k), c(theta), Dual::variable(beta));
            prop_assert!((gap.slope - slope.value).abs() < 1e-12 * (r_eff + r_k));
        }

        #[test]
        fn no_meniscus_reaches_beyond_the_rupture((r_eff, r_k, theta, beta) in menisci()) {
            let (beta_r, gap_r) = rupture(r_eff, r_k, theta);
            let (gap, slope) = meniscus_gap(r_eff, r_k, theta, beta);
            prop_assert!(gap <= gap_r + 1e-14 * r_eff);
            prop_assert!((meniscus_gap(r_eff, r_k, theta, beta_r).0 - gap_r).abs() < 1e-13 * (r_eff + r_k));
            prop_assert!((beta - beta_r).abs() < 1e-9 || (slope > 0.0) == (beta < beta_r));
            prop_assert_eq!(half_filling_angle(r_eff, r_k, theta, gap_r + 1e-9), 0.0);
        }

        #[test]
        fn scales_with_radius_and_kelvin_radius(r_eff in 0.5..20.0, r_k in 0.1..5.0, theta in 0.0..1.3, factor in 0.1..10.0) {
            let (gap, grown) = (rupture(r_eff, r_k, theta).1, rupture(factor * r_eff, factor * r_k, theta).1);
            prop_assert!(relative_eq!(grown, factor * gap, max_relative = 1e-12));
        }

        #[test]
        fn the_angle_gives_back_the_distance((r_eff, r_k, theta, _) in menisci(), share in 0.0..1.0f64, power in 1..9) {
            let (gap_r, closed) = (rupture(r_eff, r_k, theta).1, meniscus_gap(r_eff, r_k, theta, FRAC_PI_2 - theta).0);
            let gap = gap_r - (gap_r - closed) * share.powi(power);
            let beta = half_filling_angle(r_eff, r_k, theta, gap);
            prop_assert!((meniscus_gap(r_eff, r_k, theta, beta).0 - gap).abs() < 1e-14 * (r_eff + r_k));
        }

        #[test]
        fn the_branch_ends_at_the_angle_of_rupture_and_at_the_largest((r_eff, r_k, theta, _) in menisci(), pressed in 0.0..1.0) {
            let ((beta_r, gap_r), end) = (rupture(r_eff, r_k, theta), FRAC_PI_2 - theta);
            prop_assert_eq!(half_filling_angle(r_eff, r_k, theta, gap_r), beta_r);
            prop_assert_eq!(half_filling_angle(r_eff, r_k, theta, gap_r.next_up()), 0.0);
            let deepest = half_filling_angle(r_eff, r_k, theta, meniscus_gap(r_eff, r_k, theta, end).0 - pressed * r_eff);
            prop_assert!((deepest - end).abs() < 1e-8 && deepest <= end, "{deepest} {end}");
        }

        #[test]
        fn the_angle_falls_as_the_particles_part((r_eff, r_k, theta, _) in menisci(), gap in -5.0..1.0, more in 0.01..1.0) {
            prop_assert!(half_filling_angle(r_eff, r_k, theta, gap + more) <= half_filling_angle(r_eff, r_k, theta, gap));
        }
    }

    #[test]
    fn a_liquid_that_hardly_wets_ruptures_too() {
        for theta in [1.4, 1.5, 1.55, 1.57] {
            let slope = |share: f64| meniscus_gap(1.0, 0.5, theta, share * rupture(1.0, 0.5, theta).0).1;
            assert!(slope(0.99) > 0.0 && slope(1.01) < 0.0, "{theta}");
        }
    }
}
