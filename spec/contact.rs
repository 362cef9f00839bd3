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
        Self { n: x * inverse, distance, gap: distance - r_i - r_j, v, omega_i, omega_j, r_i, r_j }
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
