//! The kinematics of a contact: relative position, velocity and spin of two spheres.
//!
//! Convention of this crate: `n` points from `j` to `i`, a force is the force on `i`, and the *gap* is the distance between
//! the surfaces, negative when the spheres overlap.

use crate::{Real, Vec3};

/// Two spheres at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Contact<R> {
    /// Unit vector from the centre of `j` to the centre of `i`.
    pub n: Vec3<R>,
    /// Distance of the centres, m.
    pub distance: R,
    /// One over the distance of the centres, 1/m.
    pub inverse: R,
    /// Distance of the surfaces, m: negative for an overlap.
    pub gap: R,
    /// Relative velocity of the centres, `v_i - v_j`, m/s.
    pub v: Vec3<R>,
    /// Angular velocity of `i`, 1/s.
    pub omega_i: Vec3<R>,
    /// Angular velocity of `j`, 1/s.
    pub omega_j: Vec3<R>,
    /// Radius of `i`, m.
    pub r_i: R,
    /// Radius of `j`, m.
    pub r_j: R,
}

impl<R: Real> Contact<R> {
    /// The contact of two spheres whose centres are `x = x_i - x_j` apart and move with `v = v_i - v_j`.
    #[inline(always)]
    pub fn new(x: Vec3<R>, v: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>, r_i: R, r_j: R) -> Self {
        let distance = x.norm();
        Self::at_distance(x, distance, R::one() / distance, v, omega_i, omega_j, r_i, r_j)
    }

    /// The same where the distance and its inverse are known.
    #[inline(always)]
    pub fn at_distance(
        x: Vec3<R>,
        distance: R,
        inverse: R,
        v: Vec3<R>,
        omega_i: Vec3<R>,
        omega_j: Vec3<R>,
        r_i: R,
        r_j: R,
    ) -> Self {
        Self { n: x * inverse, distance, inverse, gap: distance - r_i - r_j, v, omega_i, omega_j, r_i, r_j }
    }

    /// Rate of change of the gap, m/s: positive when the spheres separate.
    #[inline(always)]
    pub fn normal_velocity(&self) -> R {
        self.v.dot(self.n)
    }

    /// Sliding velocity of `i` over `j` at the contact point, m/s, which lies `arm_i` and `arm_j` from the centres.
    #[inline(always)]
    pub fn sliding_velocity(&self, arm_i: R, arm_j: R) -> Vec3<R> {
        let spin = self.omega_i * arm_i + self.omega_j * arm_j;
        self.v.perpendicular_to(self.n) - spin.cross(self.n)
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_normal_leads_from_j_to_i_and_the_radii_leave_the_gap(x in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.1);
            let c = Contact::new(x, Vec3::zero(), Vec3::zero(), Vec3::zero(), r_i, r_j);
            prop_assert!((c.n * c.distance - x).norm() < 1e-15 && (c.n.norm() - 1.0).abs() < 1e-15);
            prop_assert!((r_i + c.gap + r_j - x.norm()).abs() < 1e-15);
            prop_assert_eq!((c.r_i, c.r_j), (r_i, r_j));
        }

        #[test]
        fn the_normal_velocity_is_the_rate_of_the_gap(x in vector(), v in vector()) {
            prop_assume!(x.norm() > 0.1);
            let moving = Vec3([0, 1, 2].map(|k| Dual { value: x.0[k], slope: v.0[k] }));
            let none = Vec3::zero();
            let gap = Contact::new(moving, none, none, none, Dual::constant(0.3), Dual::constant(0.2)).gap;
            let c = Contact::new(x, v, Vec3::zero(), Vec3::zero(), 0.3, 0.2);
            prop_assert!((gap.slope - c.normal_velocity()).abs() < 1e-14);
        }

        /// The material of i at the contact point, and that of j, which lies there as well.
        #[test]
        fn surfaces_slide_with_the_difference_of_their_velocities(
            x in vector(), v in vector(), omega_i in vector(), omega_j in vector(), share in 0.0..1.0f64,
        ) {
            prop_assume!(x.norm() > 0.1);
            let c = Contact::new(x, v, omega_i, omega_j, 0.3, 0.2);
            let (arm_i, arm_j) = (share * c.distance, (1.0 - share) * c.distance);
            let apart = v + omega_i.cross(c.n * -arm_i) - omega_j.cross(c.n * arm_j);
            prop_assert!((c.sliding_velocity(arm_i, arm_j) + c.n * c.normal_velocity() - apart).norm() < 1e-14);
        }
    }
}
