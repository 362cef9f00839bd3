//! The contact area.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 11**, Section 2.4: area of the circle in which two contact spheres meet.
///
/// ```math
/// A_{ij} = \pi \left[R_i^2 - \frac{(R_i^2 - R_j^2 + d^2)^2}{4 d^2}\right]
/// ```
///
/// # Reading
///
/// Erratum: bare spheres in contact are further apart than the sum of their radii. The spheres
/// that meet have the radii $R + h_n$ of Eq. 8: with them the area is positive exactly where there is an overlap.
///
/// Effect: the printed area is negative in the whole range of the contact, and friction in proportion to it would drive the sliding.
///
/// Proof: `positive_exactly_in_contact_which_bare_radii_are_not`.
///
/// The printed difference cancels. With $a = R_i + h_n$ and $b = R_j + h_n$ it factors into
///
/// ```math
/// A_{ij} = \frac{\pi}{4 d^2} (a + b - d)(d - a + b)(d + a - b)(d + a + b)
/// ```
///
/// of which the first factor is the overlap. The outer two are $(a + b)^2 - d^2$ and the inner two $d^2 - (a - b)^2$: where the distance is known only by its
/// square, the area needs no root. It is zero for spheres that do not meet.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | `d` | $d$ | m | > 0 | distance of the centres |
/// | → `a` | $A_{ij}$ | m^2 | | contact area |
/// | → `delta_n` | $\delta_n$ | m | | overlap |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `the_factors_are_the_printed_difference`
/// * `positive_exactly_in_contact_which_bare_radii_are_not`
/// * `for_a_small_overlap_it_is_pi_times_the_effective_radius_times_the_overlap`
/// * `never_exceeds_the_section_of_the_smaller_sphere`
/// * `is_zero_where_one_sphere_contains_the_other`
/// * `does_not_depend_on_which_particle_is_first`
#[inline(always)]
pub fn contact_area<R: Real>(r_i: R, r_j: R, h_n: R, d: R) -> (R, R) {
    let (a, b, delta_n) = (r_i + h_n, r_j + h_n, super::def_radius::overlap(r_i, r_j, h_n, d));
    (section(a, b, delta_n * (a + b + d), d.squared(), R::one() / d.squared()), delta_n)
}

/// Eq. 11 of two contact spheres of radii `a` and `b`, with $(a + b)^2 - d^2$, the square $d^2$ of their distance and its inverse.
#[inline(always)]
pub(super) fn section<R: Real>(a: R, b: R, outer: R, square: R, inverse: R) -> R {
    let inner = square - (a - b).squared();
    R::select(outer.min(inner).gt(R::zero()), R::pi() * R::lit(0.25) * outer * inner * inverse, R::zero())
}

/// **Section 2.4**, unnumbered: area of the circle in which a contact sphere and a plane meet.
///
/// ```math
/// A = \pi (2 a \delta_n - \delta_n^2), \quad a = R + h_n
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $R$ | m | > 0 | bare radius |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | `delta` | $\delta_n$ | m | >= 0 | overlap, at most the diameter |
/// | → `a` | $A$ | m^2 | | contact area |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_plane_is_an_infinite_sphere`
#[inline(always)]
pub fn plane_area<R: Real>(r: R, h_n: R, delta: R) -> R {
    R::pi() * delta * ((r + h_n) + (r + h_n - delta))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq11_contact_area.rs", "titania-11", ["11"], contact_area),
        equation!("titania/eq11_contact_area.rs", "titania-11-plane", [], plane_area),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Reference;
    use approx::relative_eq;
    use proptest::prelude::*;

    fn printed<R: Real>(r_i: R, r_j: R, d: R) -> R {
        R::pi()
            * (r_i.squared() - (r_i.squared() - r_j.squared() + d.squared()).squared() / (R::lit(4.0) * d.squared()))
    }

    proptest! {
        #[test]
        fn the_factors_are_the_printed_difference(r_i in 1.0..12.0, r_j in 1.0..12.0, delta in 1e-4..0.7) {
            let e = Reference::exact;
            let (r_i, r_j, h_n) = (e(r_i), e(r_j), e(0.36));
            let d = r_i + r_j + h_n + h_n - e(delta);
            let (area, printed) = (contact_area(r_i, r_j, h_n, d).0, printed(r_i + h_n, r_j + h_n, d));
            prop_assert!((area - printed).abs().le(e(1e-60)));
        }

        #[test]
        fn positive_exactly_in_contact_which_bare_radii_are_not(r_i in 1.0..12.0, r_j in 1.0..12.0, delta in 1e-9..0.7) {
            let d = |delta: f64| r_i + r_j + 0.72 - delta;
            prop_assert!(contact_area(r_i, r_j, 0.36, d(delta)).0 > 0.0);
            prop_assert_eq!(contact_area(r_i, r_j, 0.36, d(-delta)).0, 0.0);
            prop_assert!(printed(r_i, r_j, d(delta)) < 0.0);
        }

        #[test]
        fn for_a_small_overlap_it_is_pi_times_the_effective_radius_times_the_overlap(r_i in 1.0..12.0, r_j in 1.0..12.0, delta in 1e-9..1e-6) {
            let (area, overlap) = contact_area(r_i, r_j, 0.36, r_i + r_j + 0.72 - delta);
            let r_star = crate::titania::def_radius::effective_radius(r_i + 0.36, r_j + 0.36).0;
            prop_assert!(relative_eq!(area, std::f64::consts::PI * r_star * overlap, max_relative = 1e-5));
        }

        #[test]
        fn never_exceeds_the_section_of_the_smaller_sphere(r_i in 1.0..12.0, r_j in 1.0..12.0f64, d in 0.1..25.0) {
            let smaller = r_j.min(r_i) + 0.36;
            prop_assert!(contact_area(r_i, r_j, 0.36, d).0 <= std::f64::consts::PI * smaller * smaller * (1.0 + 1e-14));
        }

        #[test]
        fn is_zero_where_one_sphere_contains_the_other(r in 1.0..12.0, more in 0.0..12.0, share in 0.0..0.999) {
            for d in [0.0, share * more] {
                prop_assert_eq!(contact_area(r, r + more, 0.36, d).0, 0.0);
                prop_assert_eq!(contact_area(r, r, 0.36, 0.0).0, 0.0);
            }
        }

        #[test]
        fn does_not_depend_on_which_particle_is_first(r_i in 1.0..12.0, r_j in 1.0..12.0, d in 0.1..25.0) {
            let (here, there) = (contact_area(r_i, r_j, 0.36, d), contact_area(r_j, r_i, 0.36, d));
            prop_assert!(relative_eq!(here.0, there.0, max_relative = 1e-12) && here.1 == there.1);
        }

        #[test]
        fn a_plane_is_an_infinite_sphere(r in 1.0..12.0, delta in 0.01..0.7) {
            let (area, overlap) = contact_area(r, 1e8, 0.36, r + 1e8 + 0.72 - delta);
            prop_assert!(relative_eq!(area, plane_area(r, 0.36, overlap), max_relative = 1e-6));
        }
    }
}
