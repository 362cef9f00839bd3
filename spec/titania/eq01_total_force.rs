//! The total force between two particles.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 1**, Section 2: total force on i exerted by its partner.
///
/// ```math
/// \mathbf{F}_{ij} = \mathbf{F}_{na} + \mathbf{F}_{nr} + \mathbf{F}_{nd} + \mathbf{F}_t = \mathbf{F}_n + \mathbf{F}_t
/// ```
///
/// # Reading
///
/// As printed. The force is that on i, with $\mathbf{n}_{ij}$ from j to i: then Eq. 3 attracts and Eq. 8 repels. The first three act along
/// the normal, the last in the contact plane; all but the attraction are zero out of contact.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_na` | $\mathbf{F}_{na}$ | N (3) | any | attraction, Eq. 3 |
/// | `f_nr` | $\mathbf{F}_{nr}$ | N (3) | any | repulsion, Eq. 8 |
/// | `f_nd` | $\mathbf{F}_{nd}$ | N (3) | any | normal damping, Eq. 6 |
/// | `f_t` | $\mathbf{F}_t$ | N (3) | any | tangential force, Eq. 12 |
/// | → `force` | $\mathbf{F}_{ij}$ | N (3) | | force on i; the force on j is its negative |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `normal_and_tangential_part_can_be_told_apart`
#[inline(always)]
pub fn total_force<R: Real>(f_na: Vec3<R>, f_nr: Vec3<R>, f_nd: Vec3<R>, f_t: Vec3<R>) -> Vec3<R> {
    f_na + f_nr + f_nd + f_t
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq01_total_force.rs", "titania-1", ["1"], total_force)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn normal_and_tangential_part_can_be_told_apart(a in -3.0..3.0, r in -3.0..3.0, d in -3.0..3.0, x in -3.0..3.0, y in -3.0..3.0) {
            let n = Vec3::new(0.0, 0.6, 0.8);
            let f_t = Vec3::new(x, y, 0.3).perpendicular_to(n);
            let force = total_force(n * a, n * r, n * d, f_t);
            prop_assert!((force.dot(n) - (a + r + d)).abs() < 1e-14);
            prop_assert!((force.perpendicular_to(n) - f_t).norm() < 1e-14);
        }
    }
}
