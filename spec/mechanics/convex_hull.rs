//! The convex hull of spheres: contributions of its edges and faces to its volume.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 3.2**, unnumbered: contribution of an edge to the mean curvature of a polyhedron.
///
/// ```math
/// \frac{1}{2} \ell \theta
/// ```
///
/// # Reading
///
/// $\theta$ is the angle between the outward normals of the two faces that meet at the edge. A polygon has two faces, back to back, and a segment is an edge with an angle of $2\pi$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `length` | $\ell$ | m | >= 0 | length of the edge |
/// | `theta` | $\theta$ | rad | >= 0 | exterior angle |
/// | → `m_0` | $M_0$ | m | | contribution to the mean curvature |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_chain_of_spheres_has_the_hull_of_a_capsule`
#[inline(always)]
pub fn edge_curvature<R: Real>(length: R, theta: R) -> R {
    R::lit(0.5) * length * theta
}

/// **Section 3.2**, unnumbered: volume of the convex hull of equal spheres, by Steiner's formula.
///
/// ```math
/// V = V_0 + S_0 r + M_0 r^2 + \frac{4}{3} \pi r^3
/// ```
///
/// # Reading
///
/// The paper takes the hull "constructed around the aggregate" without further definition. It is read as the hull of the spheres: the hull of their centres, a polyhedron, expanded by the
/// radius on all sides.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_0` | $V_0$ | m^3 | >= 0 | volume of the hull of the centres |
/// | `s_0` | $S_0$ | m^2 | >= 0 | its surface |
/// | `m_0` | $M_0$ | m | >= 0 | its mean curvature, summed over its edges |
/// | `r` | $r$ | m | > 0 | radius of the spheres |
/// | → `v_hull` | $V$ | m^3 | | volume of the hull of the spheres |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_chain_of_spheres_has_the_hull_of_a_capsule`
/// * `a_cube_of_spheres_has_the_hull_of_a_rounded_cube`
#[inline(always)]
pub fn hull_volume<R: Real>(v_0: R, s_0: R, m_0: R, r: R) -> R {
    v_0 + s_0 * r + m_0 * r.squared() + R::lit(4.0) / R::lit(3.0) * R::pi() * (r * r * r)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/convex_hull.rs", "soot-edge-curvature", [], edge_curvature),
        equation!("mechanics/convex_hull.rs", "soot-hull", [], hull_volume),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn chain(n: i32, r: f64) -> f64 {
        hull_volume(0.0, 0.0, edge_curvature(2.0 * r * f64::from(n - 1), 2.0 * PI), r)
    }

    proptest! {
        #[test]
        fn a_chain_of_spheres_has_the_hull_of_a_capsule(n in 1..50, r in 0.1..10.0) {
            let capsule = PI * r * r * (2.0 * r * f64::from(n - 1)) + 4.0 / 3.0 * PI * r * r * r;
            prop_assert!((chain(n, r) / capsule - 1.0).abs() < 1e-14);
        }

        #[test]
        fn a_cube_of_spheres_has_the_hull_of_a_rounded_cube(a in 0.1..10.0, r in 0.1..10.0) {
            // A cube, six slabs, twelve quarter cylinders and eight eighths of a sphere.
            let m_0: f64 = (0..12).map(|_| edge_curvature(a, 0.5 * PI)).sum();
            let pieces = a * a * a + 6.0 * a * a * r + 3.0 * a * PI * r * r + 4.0 / 3.0 * PI * r * r * r;
            prop_assert!((hull_volume(a * a * a, 6.0 * a * a, m_0, r) / pieces - 1.0).abs() < 1e-14);
        }
    }
}
