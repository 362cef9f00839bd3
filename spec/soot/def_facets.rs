//! The attraction of a surface with edges: a groove, a corner, the facets of a tip.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Section 3.1**, unnumbered: share of a facet in the attraction beside a nearer facet.
///
/// ```math
/// s = 1 - \min\left(1, \max\left(0, \frac{\mathbf{d} \cdot \mathbf{d}_0}{d_0^2}\right)\right)
/// ```
///
/// # Reading
///
/// The paper has the force of a plane (Eq. 22) and a tip of three facets, and does not say how facets act together. Here the distance of the centre from the surface decides: every place where this
/// distance has a minimum attracts like a half-space. A convex body and a flat wall have one minimum, however finely they are triangulated; a groove has one on either side, and the sphere stays in its middle.
/// The share makes the energy $\sum s U$ a continuous function of the position: where a minimum leaves its facet across the bottom of a groove, the vector $\mathbf{d}$ from there to the centre ends in the plane through the
/// nearer place $\mathbf{d}_0$ and normal to it, so that $\mathbf{d} \cdot \mathbf{d}_0 = d_0^2$ and the share vanishes. At right or acute angles both sides attract in full; a groove that is nearly flat attracts like a plane.
/// Beside several nearer places the smallest share counts.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d` | $\mathbf{d}$ | m (3) | any | from the place on the facet to the centre |
/// | `d_0` | $\mathbf{d}_0$ | m (3) | any | from a nearer place to the centre |
/// | → `s` | $s$ | 1 | | share |
///
/// Rounding: at most 1 ULP.
///
/// # Limits
///
/// Where three sides of a concave corner meet at obtuse angles, the energy jumps when two of them become equally distant behind the third.
///
/// # Laws
///
/// * `walls_at_right_or_acute_angles_attract_in_full`
/// * `the_share_vanishes_where_the_place_reaches_the_bottom_of_a_groove`
/// * `a_groove_attracts_alike_when_its_sides_are_exchanged`
/// * `the_share_changes_only_between_all_and_nothing`
#[inline(always)]
pub fn facet_share<R: Real>(d: Vec3<R>, d_0: Vec3<R>) -> R {
    R::one() - (d.dot(d_0) / d_0.dot(d_0)).max(R::zero()).min(R::one())
}

/// **Section 3.1**, unnumbered: gradient of the share of a facet.
///
/// ```math
/// \nabla s = \frac{2 (\mathbf{d} \cdot \mathbf{d}_0)\, \mathbf{d}_0}{d_0^4} - \frac{\mathbf{Q} \mathbf{d}_0 + \mathbf{Q}_0 \mathbf{d}}{d_0^2} \quad (0 < s < 1)
/// ```
///
/// # Reading
///
/// $\mathbf{Q} = \partial \mathbf{d} / \partial \mathbf{x}$ is symmetric: $\mathbf{n}\mathbf{n}^\mathsf{T}$ on a face, $\mathbf{1} - \mathbf{t}\mathbf{t}^\mathsf{T}$ on an edge, $\mathbf{1}$ at a corner. The force that follows from the energy $s U$ is
/// $-s \nabla U - U \nabla s$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d` | $\mathbf{d}$ | m (3) | any | from the place on the facet to the centre |
/// | `d_0` | $\mathbf{d}_0$ | m (3) | any | from a nearer place to the centre |
/// | `q_d_0` | $\mathbf{Q} \mathbf{d}_0$ | m (3) | any | change of `d` when the centre is displaced by `d_0` |
/// | `q_0_d` | $\mathbf{Q}_0 \mathbf{d}$ | m (3) | any | change of `d_0` when the centre is displaced by `d` |
/// | → `slope` | $\nabla s$ | 1/m (3) | | gradient |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_slope_is_the_gradient_of_the_share`
#[inline(always)]
pub fn facet_share_slope<R: Real>(d: Vec3<R>, d_0: Vec3<R>, q_d_0: Vec3<R>, q_0_d: Vec3<R>) -> Vec3<R> {
    let (along, square) = (d.dot(d_0), d_0.dot(d_0));
    let part = along / square;
    let slope = (d_0 * (part + part) - q_d_0 - q_0_d) * (R::one() / square);
    let changes = part.gt(R::zero()) & part.lt(R::one());
    Vec3::select(changes, slope, Vec3::zero())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/def_facets.rs", "soot-facet-share", [], facet_share),
        equation!("soot/def_facets.rs", "soot-facet-share-slope", [], facet_share_slope),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    /// The vectors to a point at the polar angle `theta` above a groove of the angle `alpha` from its two sides, the first at the angle zero.
    fn groove<R: Real>(alpha: f64, [y, z]: [R; 2]) -> [Vec3<R>; 2] {
        [0.0, alpha].map(|angle| {
            let (sin, cos) = (R::lit(angle.sin()), R::lit(angle.cos()));
            let height = z * cos - y * sin;
            Vec3([R::zero(), -(height * sin), height * cos])
        })
    }

    fn at(theta: f64) -> [f64; 2] {
        [theta.cos(), theta.sin()]
    }

    proptest! {
        #[test]
        fn walls_at_right_or_acute_angles_attract_in_full(alpha in 0.1..1.57, part in 0.01..0.5) {
            let [near, far] = groove(alpha, at(part * alpha));
            prop_assert_eq!(facet_share(far, near), 1.0);
        }

        #[test]
        fn the_share_vanishes_where_the_place_reaches_the_bottom_of_a_groove(alpha in 1.6..3.1f64) {
            // There the place is a right angle away.
            let [near, far] = groove(alpha, at(alpha - std::f64::consts::FRAC_PI_2));
            prop_assert!(facet_share(far, near).abs() < 1e-12);
            let [near, far] = groove(alpha, at(0.5 * alpha));
            prop_assert!((facet_share(far, near) - (1.0 + alpha.cos())).abs() < 1e-12);
        }

        #[test]
        fn a_groove_attracts_alike_when_its_sides_are_exchanged(alpha in 1.6..3.1f64) {
            let [one, other] = groove(alpha, at(0.5 * alpha));
            prop_assert!((facet_share(one, other) - facet_share(other, one)).abs() < 1e-12);
        }

        #[test]
        fn the_slope_is_the_gradient_of_the_share(alpha in 1.7..3.1f64, part in 0.1..0.9, dx in -1.0..1.0) {
            // Between the middle and the place where the share vanishes.
            let middle = 0.5 * alpha;
            let theta = middle - part * (middle - (alpha - std::f64::consts::FRAC_PI_2));
            let [y, z] = at(theta);
            let moved = [Dual { value: y, slope: dx }, Dual { value: z, slope: 1.0 - dx }];
            let [near, far] = groove(alpha, moved);
            let ([d_0, d], displacement) = (groove(alpha, [y, z]), Vec3([0.0, dx, 1.0 - dx]));
            let turned = |n: Vec3<f64>, u: Vec3<f64>| n * (n.dot(u) / n.dot(n));
            let slope = facet_share_slope(d, d_0, turned(d, d_0), turned(d_0, d));
            prop_assert!((facet_share(far, near).slope - slope.dot(displacement)).abs() < 1e-11);
        }
    }

    #[test]
    fn the_share_changes_only_between_all_and_nothing() {
        let (d_0, turned) = (Vec3::new(0.0, 0.0, 2.0), [Vec3::new(1.0, 2.0, 3.0), Vec3::new(-4.0, 5.0, 7.0)]);
        for (part, share) in [(-0.5, 1.0), (0.0, 1.0), (0.25, 0.75), (1.0, 0.0), (1.5, 0.0)] {
            let d = Vec3::new(0.3, -0.4, 2.0 * part);
            assert_eq!(facet_share(d, d_0), share);
            let slope = (d_0 * (2.0 * part) - turned[0] - turned[1]) * 0.25;
            let expected = if share == 0.75 { slope } else { Vec3::zero() };
            assert_eq!(facet_share_slope(d, d_0, turned[0], turned[1]), expected);
        }
    }
}
