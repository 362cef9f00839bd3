//! The kinematics of a contact: of two spheres, or of a sphere and a wall.
//!
//! The one place where the convention of the crate, normals from j to i, becomes that of these springs, normals from i to j.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::pair_geometry::{arm, mean_arm};
use super::relative_spin::{relative_spin, rolling_rate, torsion_rate};
use super::relative_velocity::at_contact;
use crate::{Contact, Real, Vec3};

/// The geometry of a contact and the rates of its four springs, as the paper has them.
#[derive(Clone, Copy, Debug)]
pub struct ContactKinematics<R> {
    /// Normal from i to j.
    pub n: Vec3<R>,
    /// Gap, negative for an overlap, m.
    pub delta: R,
    /// Arm of the tangential force on i, m.
    pub a_i: R,
    /// Arm of the tangential force on j, m.
    pub a_j: R,
    /// Arm of rolling, m.
    pub a: R,
    /// Arm of torsion, m.
    pub r: R,
    /// Rate of the normal spring along the normal, m/s.
    pub v_n: R,
    /// Rate of the tangential spring, m/s.
    pub v_t: Vec3<R>,
    /// Rate of the rolling spring, m/s.
    pub v_r: Vec3<R>,
    /// Rate of the torsion spring along the normal, m/s.
    pub v_o: R,
}

impl<R: Real> ContactKinematics<R> {
    /// Two spheres.
    #[inline(always)]
    pub fn of_spheres(c: &Contact<R>) -> Self {
        let (a_i, a_j) = (arm(c.r_i, c.gap), arm(c.r_j, c.gap));
        Self::new(-c.n, c.gap, -c.v, c.omega_i, c.omega_j, [a_i, a_j, mean_arm(a_i, a_j), mean_arm(c.r_i, c.r_j)])
    }

    /// A sphere and a wall that does not turn: `n` points from the wall to the sphere, `v` is the velocity of its centre relative to the wall. The contact point
    /// is on the wall, at an arm of the radius and the whole gap.
    #[inline(always)]
    pub fn of_wall(n: Vec3<R>, gap: R, v: Vec3<R>, omega: Vec3<R>, r: R) -> Self {
        let a = r + gap;
        Self::new(-n, gap, -v, omega, Vec3::zero(), [a, R::zero(), a, r])
    }

    #[inline(always)]
    fn new(n: Vec3<R>, delta: R, v: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>, arms: [R; 4]) -> Self {
        let [a_i, a_j, a, r] = arms;
        let spin = relative_spin(omega_i, omega_j);
        Self {
            n,
            delta,
            a_i,
            a_j,
            a,
            r,
            v_n: v.dot(n),
            v_t: at_contact(v, omega_i, omega_j, n, a_i, a_j).perpendicular_to(n),
            v_r: rolling_rate(spin, n, a),
            v_o: torsion_rate(spin, n, r),
        }
    }
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn the_contact_point_of_a_wall_is_on_the_wall() {
        let none = Vec3::zero();
        let at = ContactKinematics::of_wall(Vec3::new(0.0, 0.0, 1.0), 0.25, none, none, 2.0);
        assert_eq!([at.a_i, at.a_j, at.a, at.r], [2.25, 0.0, 2.25, 2.0]);
    }
}
