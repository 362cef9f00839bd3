//! The spheres of rigid bodies: their positions and velocities.

use crate::forces::{LANES, Square, Vectorised};
use crate::spec::Vec3;
use crate::spec::mechanics::body::{member_velocity, spin};
use crate::spec::mechanics::kinetic_energy::translational_energy;
use crate::spec::mechanics::rotation::to_space;
use crate::system::{Body, Particles, System};
use rayon::prelude::*;

/// Smallest number of particles for which another thread pays.
const LEAST: usize = 4096;

impl Body {
    /// Angular velocity, 1/ns.
    pub fn omega(&self) -> Vec3<f64> {
        spin(self.pose.q_0, self.pose.q, self.l, self.moments).0
    }

    /// Kinetic energy, zJ.
    pub fn kinetic(&self) -> f64 {
        translational_energy(self.mass, self.v) + spin(self.pose.q_0, self.pose.q, self.l, self.moments).1
    }

    /// Centre and velocity of a sphere that is at `arm` in its frame.
    #[inline(always)]
    pub fn member(&self, omega: Vec3<f64>, arm: Vec3<f64>) -> (Vec3<f64>, Vec3<f64>) {
        let r = to_space(self.pose.q_0, self.pose.q, arm);
        (self.pose.x + r, member_velocity(self.v, omega, r))
    }
}

/// The members of some bodies, which follow them.
pub(super) struct Members<'a> {
    /// The bodies.
    pub bodies: &'a [Body],
    /// Their angular velocities.
    pub omegas: &'a [Vec3<f64>],
    /// Where the members of each body begin and end; the first number is that of the first member.
    pub ends: &'a [usize],
    /// Places of the members in the frames of their bodies.
    pub arms: &'a [Vec3<f64>],
    /// Centres of the members.
    pub x: &'a mut [Vec3<f64>],
    /// Their velocities.
    pub v: &'a mut [Vec3<f64>],
    /// Their angular velocities.
    pub w: &'a mut [Vec3<f64>],
}

impl Vectorised for Members<'_> {
    type Outcome = ();

    #[inline(always)]
    fn run(self, _: impl Fn(Square) -> Square) {
        let Self { bodies, omegas, ends, mut arms, mut x, mut v, w } = self;
        for ((body, &omega), range) in bodies.iter().zip(omegas).zip(ends.windows(2)) {
            w[range[0] - ends[0]..range[1] - ends[0]].fill(omega);
            let count = range[1] - range[0];
            let (own_arms, own_x, own_v);
            ((own_arms, arms), (own_x, x), (own_v, v)) =
                (arms.split_at(count), x.split_at_mut(count), v.split_at_mut(count));
            let (side_by_side, rest) = own_arms.as_chunks::<LANES>();
            for (chunk, arms) in side_by_side.iter().enumerate() {
                let (mut places, mut velocities) = ([Vec3::zero(); LANES], [Vec3::zero(); LANES]);
                for lane in 0..LANES {
                    (places[lane], velocities[lane]) = body.member(omega, arms[lane]);
                }
                own_x[chunk * LANES..][..LANES].copy_from_slice(&places);
                own_v[chunk * LANES..][..LANES].copy_from_slice(&velocities);
            }
            let whole = count - rest.len();
            for ((x, v), &arm) in own_x[whole..].iter_mut().zip(&mut own_v[whole..]).zip(rest) {
                (*x, *v) = body.member(omega, arm);
            }
        }
    }
}

impl System {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::mechanics::quaternion::largest_displacement;
    use crate::system::{Domain, Pose};
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
            let bound = largest_displacement(pose.q_0, pose.q, before.q_0, before.q, extent);
            let farthest = (0..n).map(|k| (system.particles.x[k] - places[k]).norm()).fold(0.0, f64::max);
            prop_assert!(farthest <= bound + 1e-13, "{farthest} {bound}");
        }
    }
}
