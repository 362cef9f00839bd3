//! Rigid bodies made of spheres.

use crate::geometry::principal::principal;
use crate::spec::Vec3;
use crate::spec::mechanics::body_inertia::{member_inertia, member_momentum};
use crate::spec::mechanics::rotation::to_space;
use crate::system::{Body, Pose, System};

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

    /// Sets a body in motion, with the momentum and the angular momentum that its spheres, all its members, have with these velocities and angular velocities.
    pub fn move_body(&mut self, number: usize, members: &[usize], (v, w): (&[Vec3<f64>], &[Vec3<f64>])) {
        let (particles, body) = (&self.particles, &mut self.bodies[number]);
        let (mut momentum, mut l) = (Vec3::zero(), Vec3::zero());
        for &p in members {
            let (m, r, x) = (particles.mass[p], particles.radius[p], particles.x[p] - body.pose.x);
            momentum = momentum + v[p] * m;
            l = l + member_momentum(m, r, x, v[p], w[p]);
        }
        let Pose { q_0, q, .. } = body.pose;
        (body.v, body.l) = (momentum * (1.0 / body.mass), to_space(q_0, -q, l));
        self.place_members(0);
    }
}
