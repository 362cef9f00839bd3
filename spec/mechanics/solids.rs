//! Volumes of spheres and of parts of them, and the cell of close packing.

use super::sphere::sphere_mass;
use crate::equation::Equation;
use crate::{Real, equation};

/// Volume of a sphere.
///
/// ```math
/// V = \frac{4}{3} \pi r^3
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | >= 0 | radius |
/// | → `volume` | $V$ | m^3 |  | volume |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `two_caps_that_meet_are_the_sphere`
#[inline(always)]
pub fn sphere_volume<R: Real>(r: R) -> R {
    sphere_mass(R::one(), r)
}

/// Volume of a spherical cap.
///
/// ```math
/// V = \frac{\pi}{3} h^2 (3 r - h)
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius of the sphere |
/// | `h` | $h$ | m | >= 0 | height of the cap, up to twice the radius |
/// | → `volume` | $V$ | m^3 |  | volume |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `two_caps_that_meet_are_the_sphere`
/// * `it_grows_with_the_height_by_the_section`
#[inline(always)]
pub fn cap_volume<R: Real>(r: R, h: R) -> R {
    R::pi() / R::lit(3.0) * h * h * (R::lit(3.0) * r - h)
}

/// Sides of the orthogonal cell of four spheres of hexagonal close packing.
///
/// ```math
/// a = d, \quad b = \sqrt{3} \, d, \quad c = \sqrt{\frac{8}{3}} \, d
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d` | $d$ | m | > 0 | diameter of the spheres |
/// | → `a` | $a$ | m |  | along a close-packed row |
/// | → `b` | $b$ | m |  | across it in the basal plane |
/// | → `c` | $c$ | m |  | along the hexagonal axis |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `four_spheres_fill_0_74_of_the_cell`
#[inline(always)]
pub fn hcp_cell<R: Real>(d: R) -> (R, R, R) {
    let three = R::lit(3.0);
    (d, three.sqrt() * d, (R::lit(8.0) / three).sqrt() * d)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/solids.rs", "mechanics-sphere-volume", [], sphere_volume),
        equation!("mechanics/solids.rs", "mechanics-cap-volume", [], cap_volume),
        equation!("mechanics/solids.rs", "mechanics-hcp-cell", [], hcp_cell),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn two_caps_that_meet_are_the_sphere(r in 0.1..10.0f64, share in 0.0..1.0) {
            let h = 2.0 * r * share;
            let both = cap_volume(r, h) + cap_volume(r, 2.0 * r - h);
            prop_assert!((both / sphere_volume(r) - 1.0).abs() < 1e-14);
        }

        #[test]
        fn it_grows_with_the_height_by_the_section(r in 0.1..10.0f64, share in 0.0..1.0) {
            let h = 2.0 * r * share;
            let section = std::f64::consts::PI * h * (2.0 * r - h);
            let slope = cap_volume(Dual::lit(r), Dual::variable(h)).slope;
            prop_assert!((slope - section).abs() < 1e-13 * r * r);
        }

        #[test]
        fn four_spheres_fill_0_74_of_the_cell(d in 0.1..10.0f64) {
            let (a, b, c) = hcp_cell(d);
            prop_assert!((4.0 * sphere_volume(0.5 * d) / (a * b * c) - 0.7404804896930609).abs() < 1e-14);
            // neighbours in the row, in the next row and in the next layer touch
            for (x, y, z) in [(a, 0.0, 0.0), (0.5 * a, 0.5 * b, 0.0), (0.5 * a, b / 6.0, 0.5 * c)] {
                prop_assert!(((x * x + y * y + z * z).sqrt() / d - 1.0).abs() < 1e-14);
            }
        }
    }
}
