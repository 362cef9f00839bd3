//! Rigid bodies made of spheres.

use super::{LEAST, Particles, System};
use crate::spec::numbers::jacobi::eigenvalues;
use crate::spec::titania::def_body::{member_velocity, spin};
use crate::spec::titania::def_inertia::member_inertia;
use crate::spec::titania::def_rotation::to_space;
use crate::spec::{Real, Tensor, Vec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Where a body is and how it lies: its centre of mass, nm, never folded back into the box, and the unit quaternion that takes
/// the frame of its principal axes to that of space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Centre of mass.
    pub x: Vec3<f64>,
    /// Scalar part of the orientation.
    pub q_0: f64,
    /// Vector part of the orientation.
    pub q: Vec3<f64>,
}

/// Spheres that move as one body, which turns. Units: nm, m/s, ag.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Its place and orientation.
    pub pose: Pose,
    /// Velocity of its centre of mass.
    pub v: Vec3<f64>,
    /// Angular momentum in its own frame, ag nm^2/ns.
    pub l: Vec3<f64>,
    /// Mass.
    pub mass: f64,
    /// Principal moments of inertia, ag nm^2.
    pub moments: Vec3<f64>,
    /// Distance of the farthest centre of a sphere.
    pub extent: f64,
    /// Number of spheres.
    pub count: f64,
    /// Sum of the places of the spheres in its frame, nm.
    pub lever: Vec3<f64>,
    /// Sum of `r^2 - r r` of the spheres in its frame, nm^2.
    pub spread: Tensor<f64>,
    /// 0 for a free body, `k` for one that moves with `walls[k - 1]` and does not turn.
    pub wall: u32,
    /// The body's name, unique and lasting; bodies change places as spheres do.
    pub id: u32,
}

/// How far any point of a body that lies as the quaternion `(q_0, q)` says can be from where it was when it lay as `(p_0, p)` said, whatever
/// the displacement of the centre of mass, nm; `extent` is how far from that centre its points are at most.
#[inline(always)]
pub fn turned<R: Real>(q_0: R, q: Vec3<R>, p_0: R, p: Vec3<R>, extent: R) -> R {
    let between = q * p_0 - p * q_0 - q.cross(p);
    R::lit(2.0) * between.norm() * extent
}

impl Body {
    /// Angular velocity, 1/ns.
    pub fn omega(&self) -> Vec3<f64> {
        spin(self.pose.q_0, self.pose.q, self.l, self.moments).0
    }

    /// Kinetic energy, zJ.
    pub fn kinetic(&self) -> f64 {
        0.5 * self.mass * self.v.dot(self.v) + spin(self.pose.q_0, self.pose.q, self.l, self.moments).1
    }

    /// Centre, velocity and angular velocity of a sphere that is at `arm` in its frame.
    pub fn member(&self, omega: Vec3<f64>, arm: Vec3<f64>) -> (Vec3<f64>, Vec3<f64>) {
        let r = to_space(self.pose.q_0, self.pose.q, arm);
        (self.pose.x + r, member_velocity(self.v, omega, r))
    }
}

impl System {
    /// Makes spheres into one rigid body at rest.
    pub fn add_body(&mut self, members: &[usize]) {
        let particles = &mut self.particles;
        let mass: f64 = members.iter().map(|&p| particles.mass[p]).sum();
        let centre = members.iter().fold(Vec3::zero(), |sum, &p| sum + particles.x[p] * (particles.mass[p] / mass));
        let mut inertia = [Vec3::zero(); 3];
        for &p in members {
            let part = member_inertia(particles.mass[p], particles.radius[p], particles.x[p] - centre);
            inertia = std::array::from_fn(|row| inertia[row] + part[row]);
        }
        let (moments, q_0, q) = principal(inertia);
        let number = self.bodies.len() as u32 + 1;
        let mut body = Body {
            pose: Pose { x: centre, q_0, q },
            v: Vec3::zero(),
            l: Vec3::zero(),
            mass,
            moments,
            extent: 0.0,
            count: members.len() as f64,
            lever: Vec3::zero(),
            spread: [Vec3::zero(); 3],
            wall: 0,
            id: number - 1,
        };
        for &p in members {
            let r = to_space(q_0, -q, particles.x[p] - centre);
            body.extent = body.extent.max(r.norm());
            body.lever = body.lever + r;
            for (k, row) in body.spread.iter_mut().enumerate() {
                row.0[k] += r.dot(r);
                *row = *row - r * r.0[k];
            }
            (particles.body[p], particles.arm[p]) = (number, r);
            (particles.v[p], particles.w[p]) = (Vec3::zero(), Vec3::zero());
        }
        self.bodies.push(body);
    }

    /// Moves the spheres from the place `from` on that belong to bodies to where their bodies are.
    pub fn place_members(&mut self, from: usize) {
        let Particles { x, v, w, body, arm, .. } = &mut self.particles;
        let omegas: Vec<Vec3<f64>> = self.bodies.iter().map(Body::omega).collect();
        let bodies = &self.bodies;
        let members = (&mut x[from..], &mut v[from..], &mut w[from..], &body[from..], &arm[from..]);
        members.into_par_iter().with_min_len(LEAST).filter(|member| *member.3 > 0).for_each(
            |(x, v, w, &body, &arm)| {
                let number = body as usize - 1;
                (*x, *v) = bodies[number].member(omegas[number], arm);
                *w = omegas[number];
            },
        );
    }
}

/// Principal moments of an inertia tensor and the orientation of its principal axes.
fn principal(inertia: Tensor<f64>) -> (Vec3<f64>, f64, Vec3<f64>) {
    let (mut q_0, mut q) = (1.0, Vec3::zero());
    let moments = eigenvalues(inertia.map(|row| row.0), |i, j, c, s| {
        let half = (0.5 * (1.0 + c)).sqrt();
        let mut e = Vec3::zero();
        e.0[3 - i - j] = -0.5 * s / half;
        (q_0, q) = (q_0 * half - q.dot(e), q * half + e * q_0 + q.cross(e));
    });
    let scale = 1.0 / (q_0 * q_0 + q.dot(q)).sqrt();
    (Vec3(moments), q_0 * scale, q * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Domain;
    use faer::{Mat, Side};
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }
    fn cloud() -> impl Strategy<Value = System> {
        prop::collection::vec((vector(), 0.1..0.3, 0.5..2.0), 1..20).prop_map(|spheres| {
            let mut particles = Particles::default();
            for (x, r, m) in spheres {
                particles.push(x, r, m, 0);
            }
            System::new(particles, Domain { sides: [4.0; 3], periodic: [false; 3] })
        })
    }

    proptest! {
        #[test]
        fn moments_are_the_eigenvalues_and_axes_the_eigenvectors_of_the_tensor(a in vector(), b in vector(), c in vector()) {
            let mut tensor = [Vec3::zero(); 3];
            for (m, r, x) in [(1.0, 0.2, a), (2.0, 0.3, b), (0.5, 0.1, c)] {
                let part = member_inertia(m, r, x);
                tensor = std::array::from_fn(|row| tensor[row] + part[row]);
            }
            let (moments, q_0, q) = principal(tensor);
            for k in 0..3 {
                let mut e = Vec3::zero();
                e.0[k] = 1.0;
                let axis = to_space(q_0, q, e);
                let image = Vec3(tensor.map(|row| row.dot(axis)));
                prop_assert!((image - axis * moments.0[k]).norm() < 1e-13, "{image:?}");
            }
            let mut sorted = moments.0;
            sorted.sort_by(f64::total_cmp);
            let matrix = Mat::from_fn(3, 3, |row, column| tensor[row].0[column]);
            let known = matrix.self_adjoint_eigenvalues(Side::Lower).unwrap();
            prop_assert!((0..3).all(|k| (known[k] - sorted[k]).abs() < 1e-13));
        }

        #[test]
        fn spheres_are_where_they_were_before_they_became_a_body(mut system in cloud()) {
            let before = system.particles.x.clone();
            system.add_body(&(0..before.len()).collect::<Vec<_>>());
            system.place_members(0);
            for (now, before) in system.particles.x.iter().zip(&before) {
                prop_assert!((*now - *before).norm() < 1e-14 * 8.0);
            }
        }

        #[test]
        fn energy_and_angular_momentum_are_those_of_the_spheres(mut system in cloud(), v in vector(), l in vector()) {
            let n = system.particles.len();
            system.add_body(&(0..n).collect::<Vec<_>>());
            (system.bodies[0].v, system.bodies[0].l) = (v, l);
            system.place_members(0);
            let (p, body) = (&system.particles, &system.bodies[0]);
            let (mut energy, mut momentum) = (0.0, Vec3::zero());
            for k in 0..n {
                let own = crate::motion::inertia(p, k);
                energy += 0.5 * (p.mass[k] * p.v[k].dot(p.v[k]) + own * p.w[k].dot(p.w[k]));
                momentum = momentum + (p.x[k] - body.pose.x).cross(p.v[k]) * p.mass[k] + p.w[k] * own;
            }
            prop_assert!((energy - body.kinetic()).abs() < 1e-12 * energy);
            prop_assert!((momentum - to_space(body.pose.q_0, body.pose.q, l)).norm() < 1e-12);
        }

        #[test]
        fn no_point_has_gone_farther_than_the_turn_says(mut system in cloud(), q_0 in 0.0f64..1.0, q in vector()) {
            let n = system.particles.len();
            system.add_body(&(0..n).collect::<Vec<_>>());
            let (before, places) = (system.bodies[0].pose, system.particles.x.clone());
            let length = (q_0 * q_0 + q.dot(q)).sqrt();
            system.bodies[0].pose = Pose { q_0: q_0 / length, q: q * (1.0 / length), ..before };
            system.place_members(0);
            let Body { pose, extent, .. } = system.bodies[0];
            let bound = turned(pose.q_0, pose.q, before.q_0, before.q, extent);
            let farthest = (0..n).map(|k| (system.particles.x[k] - places[k]).norm()).fold(0.0, f64::max);
            prop_assert!(farthest <= bound + 1e-13, "{farthest} {bound}");
        }
    }
}
