//! The layer that is sheared between two sliding bodies, by layers of equal height and as a whole.

use crate::spec::Vec3;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// A layer of a profile: means over the spheres whose centres lie in it, weighted by mass.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    /// Height of its middle above the bottom of the box, nm.
    pub height: f64,
    /// Number of spheres.
    pub spheres: usize,
    /// Mean of the quantity of each sphere along the direction of sliding, in its unit.
    pub means: [f64; 2],
}

/// The profile of two quantities of the spheres, given by place, in layers of this thickness, nm, from the bottom of the box upwards; layers
/// without spheres are left out.
pub fn profile(system: &System, thickness: f64, quantity: impl Fn(usize) -> [f64; 2]) -> Vec<Layer> {
    let p = &system.particles;
    let number = |i: usize| (p.x[i].0[1] / thickness).floor();
    // Sums run in the order of ids: places change when the neighbour list is built.
    let mut order = p.by_id();
    order.sort_by(|&a, &b| number(a).total_cmp(&number(b)));
    let layer = |members: &[usize]| {
        let (mut mass, mut sums) = (0.0, [0.0; 2]);
        for &i in members {
            mass += p.mass[i];
            let of = quantity(i);
            sums = [sums[0] + p.mass[i] * of[0], sums[1] + p.mass[i] * of[1]];
        }
        let height = (number(members[0]) + 0.5) * thickness;
        Layer { height, spheres: members.len(), means: sums.map(|sum| sum / mass) }
    };
    order.chunk_by(|&a, &b| number(a) == number(b)).map(layer).collect()
}

/// The parts of the velocity of the upper body between which the sheared layer lies.
const EDGES: [f64; 2] = [0.1, 0.9];

/// Thickness of the sheared layer, nm, by heights, nm, and mean velocities over that of the upper body: the distance of the heights of a tenth and of
/// nine tenths, interpolated, over the eight tenths between them. A linear profile has its own height, and a plane on which rigid bodies slide the
/// distance of two layers, below which a profile tells nothing; what moves as one body has none. Elastic shear of the bodies, as long as it is below a tenth, hardly counts.
pub fn sheared_thickness(profile: impl Iterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<(f64, f64)> = profile.collect();
    let reached = |level: f64| {
        let ends = points.windows(2).map(|ends| (ends[0], ends[1]));
        ends.filter(move |(below, above)| below.1 < level && level <= above.1)
            .map(move |((y, part), (next, more))| y + (next - y) * (level - part) / (more - part))
    };
    match (reached(EDGES[0]).next(), reached(EDGES[1]).next_back()) {
        (Some(low), Some(high)) => (high - low) / (EDGES[1] - EDGES[0]),
        _ => 0.0,
    }
}

/// The spheres, by place, that have left both bodies: each has moved by more than `clear`, nm, relative to the lower body, which rests, and relative to
/// the upper body, which has moved by `slid` since the centres were `start`, by ids.
pub fn left_both(system: &System, start: &[Vec3<f64>], slid: Vec3<f64>, clear: f64) -> Vec<bool> {
    let p = &system.particles;
    let moved = |i: usize| p.x[i] - start[p.id[i] as usize];
    (0..p.len()).map(|i| moved(i).norm() > clear && (moved(i) - slid).norm() > clear).collect()
}

/// Thickness of a solid layer over the whole cross-section, nm, that has the mass of these spheres, given by place; `density` is that of the
/// solid, ag/nm^3.
pub fn thickness_of(system: &System, density: f64, member: impl Fn(usize) -> bool) -> f64 {
    let p = &system.particles;
    // The sum of no numbers is -0.
    let mass = p.by_id().into_iter().filter(|&i| member(i)).fold(0.0, |sum, i| sum + p.mass[i]);
    mass / (density * system.domain.sides[0] * system.domain.sides[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Domain, Particles};

    const SIDE: f64 = 4.0;
    /// Spheres of mass 1 on a cubic lattice of spacing 1 have this density, ag/nm^3.
    const DENSITY: f64 = 1.0;

    /// Layers of spheres at a height of 0.5, 1.5, ... nm, before and after a sphere at height y was displaced by `moved(y, number)` along x.
    fn displaced(layers: u32, moved: impl Fn(f64, usize) -> f64) -> (System, Vec<Vec3<f64>>) {
        let mut particles = Particles::default();
        for k in 0..16 * layers {
            let [x, y, z] = [k % 4, k / 16, k / 4 % 4].map(f64::from);
            particles.push(Vec3([x, y + 0.5, z]), 0.5, 1.0, 1);
        }
        let before = particles.x.clone();
        for (i, x) in particles.x.iter_mut().enumerate() {
            *x = *x + Vec3([moved(x.0[1], i), 0.0, 0.0]);
        }
        let domain = Domain { sides: [SIDE, f64::from(layers), SIDE], periodic: [true, false, true] };
        (System::new(particles, domain), before)
    }

    /// The thickness of the sheared layer by layers of this thickness.
    fn sheared(system: &System, before: &[Vec3<f64>], slid: f64, thickness: f64) -> f64 {
        let part = |i: usize| (system.particles.x[i].0[0] - before[i].0[0]) / slid;
        let layers = profile(system, thickness, |i| [part(i), 0.0]);
        sheared_thickness(layers.iter().map(|layer| (layer.height, layer.means[0])))
    }

    #[test]
    fn bodies_that_move_as_one_have_no_layer_and_a_plane_cannot_be_told_from_one() {
        let slid = 2.5;
        for (above, expected) in [(-1.0, 0.0), (3.0, 1.0), (9.0, 0.0)] {
            let (system, before) = displaced(8, |y, _| if y > above { slid } else { 0.0 });
            assert!((sheared(&system, &before, slid, 1.0) - expected).abs() < 1e-14);
            let left = left_both(&system, &before, Vec3([slid, 0.0, 0.0]), 1.0);
            assert!(left.iter().all(|left| !left));
        }
    }

    #[test]
    fn a_linear_displacement_has_its_profile_and_its_thickness() {
        let (n, rest, slid) = (10, 3, 7.0);
        let part = |y: f64| ((y - f64::from(rest)) / f64::from(n)).clamp(0.0, 1.0);
        let (system, before) = displaced(n + 2 * rest, |y, _| slid * part(y));
        let moved = |i: usize| system.particles.x[i].0[0] - before[i].0[0];
        let layers = profile(&system, 1.0, |i| [moved(i) / 2.0, moved(i)]);
        assert_eq!(layers.len(), (n + 2 * rest) as usize);
        for (k, layer) in layers.iter().enumerate() {
            assert_eq!((layer.height, layer.spheres), (k as f64 + 0.5, 16));
            let expected = slid * part(layer.height);
            assert!((layer.means[1] - expected).abs() < 1e-14 && (layer.means[0] - 0.5 * expected).abs() < 1e-14);
        }
        assert!((sheared(&system, &before, slid, 1.0) - f64::from(n)).abs() < 1e-12);
    }

    #[test]
    fn elastic_shear_of_the_bodies_changes_the_layer_by_less_than_its_part() {
        let elastic = 0.002;
        let layer = |y: f64| ((y - 8.0) / 8.0).clamp(0.0, 1.0);
        let thickness = |shear: f64| {
            let (system, before) = displaced(24, |y, _| shear * y + (1.0 - 24.0 * shear) * layer(y));
            sheared(&system, &before, 1.0, 1.0)
        };
        assert!((thickness(0.0) - 8.0).abs() < 1e-12);
        let more = thickness(elastic) / thickness(0.0) - 1.0;
        assert!(more > 0.0 && more < 24.0 * elastic, "{more}");
    }

    #[test]
    fn what_moves_with_half_the_speed_has_left_both_bodies() {
        let (system, before) = displaced(9, |y, _| {
            if y < 3.0 {
                0.0
            } else if y < 6.0 {
                5.0
            } else {
                10.0
            }
        });
        let left = left_both(&system, &before, Vec3([10.0, 0.0, 0.0]), 4.9);
        assert!((thickness_of(&system, DENSITY, |i| left[i]) - 3.0).abs() < 1e-12);
        assert!(!left_both(&system, &before, Vec3([10.0, 0.0, 0.0]), 5.1).contains(&true));
    }

    #[test]
    fn a_way_of_several_boxes_is_not_folded() {
        let slid = 5.0 * SIDE + 1.0;
        let (system, before) = displaced(6, |y, i| if y > 2.0 && (i % 2 == 0 || y > 4.0) { slid } else { 0.0 });
        let moved = |i: usize| system.particles.x[i].0[0] - before[i].0[0];
        let means: Vec<f64> = profile(&system, 2.0, |i| [0.0, moved(i)]).iter().map(|layer| layer.means[1]).collect();
        assert_eq!(means, [0.0, 0.5 * slid, slid]);
        assert!((sheared(&system, &before, slid, 2.0) - 4.0).abs() < 1e-12);
        assert!(!left_both(&system, &before, Vec3([slid, 0.0, 0.0]), 0.5).contains(&true));
    }

    #[test]
    fn measurements_do_not_depend_on_the_places_of_the_spheres() {
        let (system, before) = displaced(9, |y, i| 0.1 * y * (1.0 + 0.01 * i as f64));
        let mut other = system.clone();
        let places: Vec<u32> = (0..system.particles.len() as u32).rev().collect();
        other.particles = system.particles.pick(&places);
        let seen = |system: &System| {
            let p = &system.particles;
            let moved = |i: usize| p.x[i].0[0] - before[p.id[i] as usize].0[0];
            (profile(system, 2.0, |i| [moved(i), 1.0]), thickness_of(system, DENSITY, |i| moved(i) > 0.5))
        };
        assert_eq!(seen(&system), seen(&other));
    }
}
