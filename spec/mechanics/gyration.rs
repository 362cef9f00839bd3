//! The radius of gyration of spheres, and of two joined clusters.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Contribution of a point mass to the squared radius of gyration, by axis.
///
/// ```math
/// g_a^2 = x_a^2 \frac{m}{M}
/// ```
///
/// # Reading
///
/// The sum over all masses and the three axes is the squared radius of gyration.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x` | $\mathbf{x}$ | m (3) | any | position relative to the common centre of mass |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `total` | $M$ | kg | > 0 | total mass |
/// | → `square` | $g_a^2$ | m^2 (3) |  | contribution along each axis |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `two_points_have_their_distance_weighted_with_the_reduced_mass`
#[inline(always)]
pub fn gyration_term<R: Real>(x: Vec3<R>, m: R, total: R) -> Vec3<R> {
    let share = m / total;
    Vec3(x.0.map(|x_a| x_a.squared() * share))
}

/// Contribution of the size of a sphere to the squared radius of gyration along each axis.
///
/// ```math
/// g^2 = \frac{1}{3} r^2 \frac{m}{M}
/// ```
///
/// # Reading
///
/// With it the radius of gyration of a single sphere is its radius (Filippov, Zurita & Rosner, J. Colloid Interface Sci. 229, 261, 2000). Summed
/// over the three axes it is $r^2 m / M$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `total` | $M$ | kg | > 0 | mass of all spheres |
/// | → `square` | $g^2$ | m^2 |  | contribution along one axis |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_single_sphere_has_its_radius`
#[inline(always)]
pub fn own_gyration<R: Real>(r: R, m: R, total: R) -> R {
    r.squared() / R::lit(3.0) * m / total
}

/// Distance between the centres of mass of two clusters that together have a given radius of gyration.
///
/// ```math
/// d = \sqrt{\frac{M}{m_a m_b} \left(M R^2 - m_a R_a^2 - m_b R_b^2\right)}, \quad M = m_a + m_b
/// ```
///
/// # Reading
///
/// Steiner's theorem. If the clusters alone already exceed it, the distance is zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_a` | $m_a$ | kg | > 0 | mass of one cluster |
/// | `m_b` | $m_b$ | kg | > 0 | mass of the other |
/// | `total` | $M$ | kg | > 0 | their sum |
/// | `square_a` | $R_a^2$ | m^2 | >= 0 | squared gyration radius of one |
/// | `square_b` | $R_b^2$ | m^2 | >= 0 | squared gyration radius of the other |
/// | `radius` | $R$ | m | > 0 | gyration radius of both together |
/// | → `distance` | $d$ | m |  | distance |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `two_points_at_the_distance_have_the_gyration_radius`
/// * `clusters_that_are_too_large_coincide`
#[inline(always)]
pub fn joined_distance<R: Real>(m_a: R, m_b: R, total: R, square_a: R, square_b: R, radius: R) -> R {
    let between = total * radius.squared() - m_a * square_a - m_b * square_b;
    (between.max(R::zero()) * total / (m_a * m_b)).sqrt()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/gyration.rs", "mechanics-gyration-term", [], gyration_term),
        equation!("mechanics/gyration.rs", "mechanics-own-gyration", [], own_gyration),
        equation!("mechanics/gyration.rs", "mechanics-joined-distance", [], joined_distance),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn two_points_have_their_distance_weighted_with_the_reduced_mass(m_a in 0.1..10.0f64, m_b in 0.1..10.0f64, x in vector()) {
            let total = m_a + m_b;
            let parts = [(m_a, x * (m_b / total)), (m_b, x * (-m_a / total))];
            let square: f64 = parts.into_iter().flat_map(|(m, x)| gyration_term(x, m, total).0).sum();
            prop_assert!((square - m_a * m_b / (total * total) * x.dot(x)).abs() < 1e-14);
        }

        #[test]
        fn a_single_sphere_has_its_radius(r in 0.1..10.0f64, m in 0.1..10.0) {
            prop_assert!((3.0 * own_gyration(r, m, m) / (r * r) - 1.0).abs() < 1e-15);
        }

        #[test]
        fn two_points_at_the_distance_have_the_gyration_radius(m_a in 0.1..10.0f64, m_b in 0.1..10.0f64, radius in 0.1..10.0f64) {
            let total = m_a + m_b;
            let d = joined_distance(m_a, m_b, total, 0.0, 0.0, radius);
            prop_assert!(d > 0.0);
            prop_assert!((m_a * m_b / (total * total) * d * d / (radius * radius) - 1.0).abs() < 1e-14);
        }

        #[test]
        fn clusters_that_are_too_large_coincide(m_a in 0.1..10.0f64, m_b in 0.1..10.0f64, radius in 0.1..10.0f64) {
            prop_assert_eq!(joined_distance(m_a, m_b, m_a + m_b, 2.0 * radius * radius, 2.0 * radius * radius, radius), 0.0);
        }
    }
}
