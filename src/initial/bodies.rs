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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Domain, Particles};

    /// A free sphere, and two of masses 1 and 3 and radii 0.5 and 1 that are 4 apart along a diagonal.
    fn dumbbell() -> System {
        let mut particles = Particles::default();
        particles.push(Vec3([50.0; 3]), 9.0, 100.0, 0);
        particles.push(Vec3([1.0, 1.0, 1.0]), 0.5, 1.0, 0);
        particles.push(Vec3([1.0 + 8.0 / 3.0, 1.0 - 4.0 / 3.0, 1.0 + 8.0 / 3.0]), 1.0, 3.0, 0);
        particles.v.fill(Vec3([7.0; 3]));
        particles.w.fill(Vec3([8.0; 3]));
        let mut system = System::new(particles, Domain::periodic([100.0; 3]));
        system.add_body(&[1, 2]);
        system
    }

    const ALONG: Vec3<f64> = Vec3([2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0]);

    #[test]
    fn a_body_has_the_mass_the_centre_and_the_inertia_of_its_spheres() {
        let System { particles, bodies, .. } = dumbbell();
        let body = &bodies[0];
        assert_eq!((body.mass, body.count, body.wall, body.id), (4.0, 2.0, 0, 0));
        assert!((body.pose.x - (Vec3([1.0; 3]) + ALONG * 3.0)).norm() < 1e-14);
        // 2/5 m r^2 of both, and across the axis m d^2 with distances of 3 and 1.
        let mut moments = body.moments.0;
        moments.sort_by(f64::total_cmp);
        assert!(
            moments.iter().zip([1.3, 13.3, 13.3]).all(|(found, known)| (found - known).abs() < 1e-13),
            "{moments:?}"
        );
        assert!((body.extent - 3.0).abs() < 1e-14);
        let arms = [particles.arm[1], particles.arm[2]];
        let Pose { x, q_0, q } = body.pose;
        assert!([1, 2].iter().all(|&p| (x + to_space(q_0, q, particles.arm[p]) - particles.x[p]).norm() < 1e-14));
        assert!((body.lever - arms[0] - arms[1]).norm() < 1e-14);
        for u in [ALONG, Vec3([1.0, 2.0, 3.0])] {
            let u = to_space(q_0, -q, u);
            let spread = arms.iter().map(|r| r.dot(*r) * u.dot(u) - r.dot(u) * r.dot(u)).sum::<f64>();
            assert!((u.dot(Vec3(body.spread.map(|row| row.dot(u)))) - spread).abs() < 1e-12);
        }
        assert_eq!((particles.body, particles.v[0], particles.w[0]), (vec![0, 1, 1], Vec3([7.0; 3]), Vec3([8.0; 3])));
        assert_eq!(
            (particles.v[1], particles.w[2], body.v, body.l),
            (Vec3::zero(), Vec3::zero(), Vec3::zero(), Vec3::zero())
        );
    }

    #[test]
    fn bodies_are_numbered_as_they_come() {
        let mut system = dumbbell();
        system.add_body(&[0]);
        assert_eq!((system.particles.body, system.bodies[1].id), (vec![2, 1, 1], 1));
        assert!((system.bodies[1].moments - Vec3([3240.0; 3])).norm() < 1e-10 && system.bodies[1].extent == 0.0);
    }

    #[test]
    fn a_body_moves_with_the_momenta_of_its_spheres() {
        let mut system = dumbbell();
        // A turn about an axis across the line of centres, by itself and with a spin of one sphere about that line.
        let across = Vec3([1.0, 2.0, 0.0]) * (1.0 / 5f64.sqrt());
        let (along, omega) = (Vec3([1.0, -2.0, 3.0]), across * 2.0);
        let x = system.bodies[0].pose.x;
        let v: Vec<Vec3<f64>> = system.particles.x.iter().map(|place| along + omega.cross(*place - x)).collect();
        let mut w = vec![omega; 3];
        w[2] = w[2] + ALONG * 5.0;
        system.move_body(0, &[1, 2], (&v, &w));
        let body = &system.bodies[0];
        assert!((body.v - along).norm() < 1e-13);
        // 13.3 about the axis across, and 2/5 of the mass of 3 of the sphere that spins.
        let l = to_space(body.pose.q_0, body.pose.q, body.l);
        assert!((l - omega * 13.3 - ALONG * (1.2 * 5.0)).norm() < 1e-12, "{l:?}");
        // Now it turns as one.
        let turned = omega + ALONG * (6.0 / 1.3);
        for p in [1, 2] {
            assert!((system.particles.w[p] - turned).norm() < 1e-12);
            assert!((system.particles.v[p] - along - turned.cross(system.particles.x[p] - x)).norm() < 1e-12);
        }
        assert_eq!((system.particles.v[0], system.particles.w[0]), (Vec3([7.0; 3]), Vec3([8.0; 3])));
    }

    #[test]
    fn every_sphere_of_a_body_that_is_moved_has_its_velocity_at_once() {
        let mut system = dumbbell();
        system.add_body(&[0]);
        let given = [Vec3([1.0, 2.0, 3.0]); 3];
        system.move_body(1, &[0], (&given, &[Vec3::zero(); 3]));
        assert_eq!(system.particles.v, [given[0], Vec3::zero(), Vec3::zero()]);
    }
}
