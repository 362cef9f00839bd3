//! The convexity of an aggregate: the fraction of its convex hull that it fills.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 3.2**, unnumbered: convexity of an aggregate.
///
/// ```math
/// \frac{V_{\mathrm{aggregate}}}{V_{\mathrm{hull}}}
/// ```
///
/// # Reading
///
/// The volume of the aggregate is the sum of the volumes of its spheres: overlaps are small.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_spheres` | $V_{\mathrm{aggregate}}$ | m^3 | > 0 | volume of the spheres |
/// | `v_hull` | $V_{\mathrm{hull}}$ | m^3 | > 0 | volume of their convex hull |
/// | → `convexity` | | 1 | | convexity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_sphere_is_convex_and_a_dimer_four_fifths`
#[inline(always)]
pub fn convexity<R: Real>(v_spheres: R, v_hull: R) -> R {
    v_spheres / v_hull
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("soot/def_convexity.rs", "soot-convexity", [], convexity)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::convex_hull::{edge_curvature, hull_volume};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn chain(n: i32, r: f64) -> f64 {
        hull_volume(0.0, 0.0, edge_curvature(2.0 * r * f64::from(n - 1), 2.0 * PI), r)
    }

    proptest! {
        #[test]
        fn a_sphere_is_convex_and_a_dimer_four_fifths(r in 0.1..10.0) {
            let sphere = chain(1, r);
            prop_assert!((convexity(sphere, chain(1, r)) - 1.0).abs() < 1e-15);
            prop_assert!((convexity(2.0 * sphere, chain(2, r)) - 0.8).abs() < 1e-15);
        }
    }
}
