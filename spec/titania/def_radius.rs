//! The radii of a particle and of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 2.1**, unnumbered: effective radius of a pair.
///
/// ```math
/// R^* = \frac{2 R_i R_j}{R_i + R_j}
/// ```
///
/// # Reading
///
/// The harmonic mean: the radius itself for equal spheres, twice the radius against a plane. The effective radius of contact
/// mechanics, $R_i R_j / (R_i + R_j)$, is half of it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | radius of i |
/// | `r_j` | $R_j$ | m | > 0 | radius of j |
/// | → `r_star` | $R^*$ | m | | harmonic mean of the radii |
/// | → `r_eff` | $R_\text{eff}$ | m | | half of it |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_radius_of_equal_spheres_and_twice_the_radius_on_a_plane`
/// * `does_not_depend_on_which_sphere_is_first`
/// * `lies_between_the_smaller_radius_and_its_double`
/// * `scales_with_the_radii`
#[inline(always)]
pub fn effective_radius<R: Real>(r_i: R, r_j: R) -> (R, R) {
    let r_eff = r_i * r_j / (r_i + r_j);
    (r_eff + r_eff, r_eff)
}

/// **Section 2.3**, unnumbered: overlap of the compressed water layers.
///
/// ```math
/// \delta_n = R_i + R_j + 2 h_n - d
/// ```
///
/// # Reading
///
/// The paper draws the overlap and does not define it. Eq. 8 acts below the onset of the repulsion, where the compressed layers of thickness
/// $h_n$ meet. `h_n` is not the thickness $h$ of the free layer, of which it is 0.88.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | `d` | $d$ | m | > 0 | distance of the centres |
/// | → `delta_n` | $\delta_n$ | m | | overlap, positive in contact |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `falls_as_the_distance_grows`
/// * `does_not_depend_on_which_sphere_is_first`
#[inline(always)]
pub fn overlap<R: Real>(r_i: R, r_j: R, h_n: R, d: R) -> R {
    (r_i + r_j - d) + (h_n + h_n)
}

/// Not in the paper: the three radii of a particle of a nominal diameter.
///
/// ```math
/// R = \frac{d_\text{nom} - \Delta}{2}, \quad R_\text{nom} = \frac{d_\text{nom}}{2}, \quad r = R + h_n
/// ```
///
/// # Reading
///
/// The paper's $R$ is the bare radius, that of the oxide core. Published results are labelled by nominal diameters $d_\text{nom}$ in steps
/// of one nanometre. The authors' program takes a core gap $\Delta$ of 0.57 nm for every size, so that two particles at equilibrium are
/// exactly their mean nominal diameter apart. The contact acts between spheres of radius $R + h_n$, with $h_n$ = 0.36 nm; their overlap at
/// equilibrium, $2 h_n - \Delta$ = 0.15 nm, is the same for every pair. Masses and moments of inertia are those of the contact spheres.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d_nom` | $d_\text{nom}$ | m | > 0 | nominal diameter |
/// | `gap` | $\Delta$ | m | >= 0 | distance of two cores at equilibrium |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | → `core` | $R$ | m | | bare radius |
/// | → `nominal` | $R_\text{nom}$ | m | | half the nominal diameter |
/// | → `contact` | $r$ | m | | radius of the contact sphere |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `nominal_radii_add_up_to_the_distance_at_equilibrium_of_any_two_sizes`
#[inline(always)]
pub fn radii<R: Real>(d_nom: R, gap: R, h_n: R) -> (R, R, R) {
    let half = R::lit(0.5);
    let core = half * (d_nom - gap);
    (core, half * d_nom, core + h_n)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_radius.rs", "titania-Rstar", [], effective_radius),
        equation!("titania/def_radius.rs", "titania-deltan", [], overlap),
        equation!("titania/def_radius.rs", "titania-radii", [], radii),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_radius_of_equal_spheres_and_twice_the_radius_on_a_plane(r in 0.1..10.0) {
            prop_assert!(relative_eq!(effective_radius(r, r).0, r, max_relative = 1e-15));
            prop_assert!(relative_eq!(effective_radius(r, 1e12).0, 2.0 * r, max_relative = 1e-10));
        }

        #[test]
        fn does_not_depend_on_which_sphere_is_first(r_i in 0.1..10.0, r_j in 0.1..10.0, d in 0.1..20.0) {
            prop_assert_eq!(effective_radius(r_i, r_j), effective_radius(r_j, r_i));
            prop_assert_eq!(overlap(r_i, r_j, 0.36, d), overlap(r_j, r_i, 0.36, d));
        }

        #[test]
        fn lies_between_the_smaller_radius_and_its_double(r_i in 0.1..10.0f64, r_j in 0.1..10.0) {
            let (r_star, smaller) = (effective_radius(r_i, r_j).0, r_i.min(r_j));
            prop_assert!(r_star >= smaller * (1.0 - 1e-15) && r_star <= 2.0 * smaller);
        }

        #[test]
        fn scales_with_the_radii(r_i in 0.1..10.0, r_j in 0.1..10.0, factor in 0.1..10.0) {
            let scaled = effective_radius(factor * r_i, factor * r_j).0;
            prop_assert!(relative_eq!(scaled, factor * effective_radius(r_i, r_j).0, max_relative = 1e-14));
        }

        #[test]
        fn falls_as_the_distance_grows(r_i in 0.1..10.0, r_j in 0.1..10.0, d in 0.1..20.0, more in 0.1..1.0f64) {
            let fallen = overlap(r_i, r_j, 0.36, d) - overlap(r_i, r_j, 0.36, d + more);
            prop_assert!((fallen - more).abs() < 1e-13);
        }

        #[test]
        fn nominal_radii_add_up_to_the_distance_at_equilibrium_of_any_two_sizes(d_i in 3.0..23.0, d_j in 3.0..23.0) {
            let (gap, h_n) = (0.57, 0.36);
            let ((core_i, nominal_i, _), (core_j, nominal_j, contact_j)) = (radii(d_i, gap, h_n), radii(d_j, gap, h_n));
            let d = nominal_i + nominal_j;
            prop_assert!((d - core_i - core_j - gap).abs() < 1e-13);
            prop_assert!((overlap(core_i, core_j, h_n, d) - 0.15).abs() < 1e-13);
            prop_assert!((contact_j - nominal_j - 0.075).abs() < 1e-13);
        }
    }
}
