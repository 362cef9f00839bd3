//! The virial stress of a region.

use super::Link;
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::mechanics::virial::{kinetic_stress, pair_stress};
use crate::spec::{Tensor, Vec3};
use crate::system::System;
use serde::{Deserialize, Serialize};

/// The part of the box between two heights.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slab {
    /// Lower face, nm.
    pub low: f64,
    /// Upper face, nm.
    pub high: f64,
}

impl Slab {
    /// True for a point inside; the upper face belongs to the next slab.
    fn contains(&self, x: Vec3<f64>) -> bool {
        (self.low..self.high).contains(&x.0[1])
    }

    /// The part of the straight line from height `y` to `y + rise` that lies inside: this share of a pair's virial belongs
    /// to the slab, so that the slabs of a stack add up to the whole.
    fn share(&self, y: f64, rise: f64) -> f64 {
        if rise == 0.0 {
            return if (self.low..self.high).contains(&y) { 1.0 } else { 0.0 };
        }
        let (a, b) = ((self.low - y) / rise, (self.high - y) / rise);
        (a.max(b).min(1.0) - a.min(b).max(0.0)).max(0.0)
    }
}

/// Mean virial stress in a slab, MPa, tension positive. The velocity of a sphere is taken relative to the mean velocity in
/// the slab, so that a drifting sample has no stress from its drift.
pub fn stress(system: &System, links: &[Link], slab: Slab) -> Tensor<f64> {
    let p = &system.particles;
    let volume = (slab.high - slab.low) * system.domain.sides[0] * system.domain.sides[2];
    let mut sum = [Vec3::zero(); 3];
    let mut add = |term: Tensor<f64>| sum = std::array::from_fn(|a| sum[a] + term[a]);
    for link in links {
        let share = slab.share(p.x[link.i].0[1], link.branch.0[1]);
        if share > 0.0 {
            add(pair_stress(volume, link.branch * share, link.force));
        }
    }
    let inside: Vec<usize> = (0..p.len()).filter(|&i| slab.contains(p.x[i])).collect();
    let mass: f64 = inside.iter().map(|&i| p.mass[i]).sum();
    let drift = inside.iter().fold(Vec3::zero(), |sum, &i| sum + p.v[i] * (p.mass[i] / mass));
    for i in inside {
        add(kinetic_stress(volume, p.mass[i], p.v[i] - drift));
    }
    sum
}

/// The share of a force in the stress of the sphere that it acts on at the end of an arm, MPa, tension positive: xx, yy, zz, xy, xz, yz.
pub fn of_sphere(radius: f64, arm: Vec3<f64>, force: Vec3<f64>) -> [f64; 6] {
    let [Vec3([xx, xy, xz]), Vec3([yx, yy, yz]), Vec3([zx, zy, zz])] = pair_stress(sphere_volume(radius), arm, force);
    [xx, yy, zz, 0.5 * (xy + yx), 0.5 * (xz + zx), 0.5 * (yz + zy)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Domain, Particles};
    use proptest::prelude::*;

    fn sample(points: &[[f64; 3]]) -> (System, Vec<Link>) {
        let mut particles = Particles::default();
        for (k, &x) in points.iter().enumerate() {
            particles.push(Vec3(x), 0.5, 1.0 + k as f64, 0);
        }
        for i in 0..particles.len() {
            let x = particles.x[i].0;
            particles.v[i] = Vec3([x[1], -x[2], x[0] * x[1]]);
        }
        let links = (1..points.len())
            .map(|j| {
                let branch = particles.x[j] - particles.x[j - 1];
                Link { i: j - 1, j, branch, gap: 0.0, force: branch * (j as f64) }
            })
            .collect();
        (System::new(particles, Domain { sides: [4.0, 10.0, 5.0], periodic: [true, false, true] }), links)
    }

    proptest! {
        #[test]
        fn the_shares_of_a_pair_in_a_stack_of_slabs_add_up_to_one(
            y in 0.0..10.0f64, end in 0.0..10.0f64, cuts in prop::collection::vec(0.0..10.0f64, 0..5),
        ) {
            let mut faces = cuts;
            faces.extend([0.0, 10.0]);
            faces.sort_by(f64::total_cmp);
            let total: f64 = faces.windows(2).map(|f| Slab { low: f[0], high: f[1] }.share(y, end - y)).sum();
            prop_assert!((total - 1.0).abs() < 1e-9, "{total}");
        }

        #[test]
        fn a_drifting_sample_has_the_stress_of_a_resting_one(
            points in prop::collection::vec(prop::array::uniform3(0.0..4.0f64), 2..8), drift in prop::array::uniform3(-50.0..50.0f64),
        ) {
            let whole = Slab { low: 0.0, high: 10.0 };
            let (mut system, links) = sample(&points);
            let rest = stress(&system, &links, whole);
            for v in &mut system.particles.v {
                *v = *v + Vec3(drift);
            }
            let drifting = stress(&system, &links, whole);
            for a in 0..3 {
                prop_assert!((rest[a] - drifting[a]).norm() < 1e-9);
            }
        }

        #[test]
        fn central_forces_give_a_symmetric_stress(points in prop::collection::vec(prop::array::uniform3(0.0..4.0f64), 2..8)) {
            let (system, links) = sample(&points);
            let s = stress(&system, &links, Slab { low: 0.5, high: 3.0 });
            for a in 0..3 {
                for b in 0..3 {
                    prop_assert!((s[a].0[b] - s[b].0[a]).abs() < 1e-10);
                }
            }
        }
    }

    #[test]
    fn a_stretched_bar_between_the_faces_carries_force_over_area() {
        let mut particles = Particles::default();
        particles.push(Vec3([1.0, -1.0, 1.0]), 0.5, 1.0, 0);
        particles.push(Vec3([1.0, 11.0, 1.0]), 0.5, 1.0, 0);
        let system = System::new(particles, Domain { sides: [4.0, 10.0, 5.0], periodic: [true, false, true] });
        let link = Link { i: 0, j: 1, branch: Vec3([0.0, 12.0, 0.0]), gap: 11.0, force: Vec3([0.0, 3.0, 0.0]) };
        let s = stress(&system, &[link], Slab { low: 2.0, high: 7.0 });
        // Share, volume and product round once each.
        assert!((s[1].0[1] / (3.0 / 20.0) - 1.0).abs() <= 4.0 * f64::EPSILON);
    }
}
