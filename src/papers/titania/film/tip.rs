//! The tip of an atomic force microscope: a pyramid of spheres.

use crate::spec::{Real, Vec3};
use crate::system::{Domain, Particles};

/// The centres of touching spheres of a radius in a square pyramid that stands on its apex, the lowest sphere at the origin, as wide at its base
/// as `side`: every sphere lies in a hollow of four of the layer above it, so the faces rise at 54.7 degrees, as those of etched silicon do.
pub(super) fn pyramid(radius: f64, side: f64) -> Vec<Vec3<f64>> {
    let layers = ((side / (2.0 * radius)).round() as i32).max(1);
    let rise = Real::sqrt(2.0) * radius;
    let mut centres = Vec::new();
    for layer in 0..layers {
        let place = |k: i32| radius * f64::from(2 * k - layer);
        for (k, l) in (0..=layer).flat_map(|k| (0..=layer).map(move |l| (k, l))) {
            centres.push(Vec3([place(k), place(l), rise * f64::from(layer)]));
        }
    }
    centres
}

/// How far the tip must be lifted for no sphere of it to come closer to any of the particles than `clearance`; nothing if no
/// particle is below the tip.
pub(super) fn lift(
    centres: &[Vec3<f64>],
    radius: f64,
    particles: &Particles,
    domain: &Domain,
    clearance: f64,
) -> Option<f64> {
    let nearest = |a: usize, apart: f64| {
        let side = domain.sides[a];
        if domain.periodic[a] { apart - side * (apart / side).round() } else { apart }
    };
    let mut most = None;
    for (x, r) in particles.x.iter().zip(&particles.radius) {
        let reach = radius + r + clearance;
        for c in centres {
            let (dx, dy) = (nearest(0, x.0[0] - c.0[0]), nearest(1, x.0[1] - c.0[1]));
            let left = reach * reach - dx * dx - dy * dy;
            if left > 0.0 {
                let lifted = x.0[2] - c.0[2] + left.sqrt();
                most = Some(most.map_or(lifted, |most: f64| most.max(lifted)));
            }
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sphere_of_a_pyramid_touches_the_four_below_or_above_it_and_none_overlap() {
        let centres = pyramid(20.0, 200.0);
        assert_eq!(centres.len(), 1 + 4 + 9 + 16 + 25);
        let apart = |i: usize, j: usize| (centres[i] - centres[j]).norm();
        let touching = |i: usize| (0..centres.len()).filter(|&j| i != j && apart(i, j) < 40.0 + 1e-9).count();
        assert!((0..centres.len()).all(|i| (0..i).all(|j| apart(i, j) > 40.0 - 1e-9)));
        assert_eq!((touching(0), touching(centres.len() - 13)), (4, 8));
    }

    #[test]
    fn a_lifted_tip_just_clears_the_film_across_the_side_of_the_box_too() {
        let domain = Domain { sides: [100.0, 100.0, 50.0], periodic: [true, true, false] };
        let mut particles = Particles::default();
        particles.push(Vec3([95.0, 0.0, 7.0]), 5.0, 1.0, 0);
        let lifted = lift(&[Vec3::zero()], 20.0, &particles, &domain, 1.0).expect("a particle below");
        let apart = Vec3([-5.0, 0.0, 7.0 - lifted]).norm();
        assert!((apart - 26.0).abs() < 1e-12 && lifted > 0.0);
    }

    #[test]
    fn a_tip_above_no_particle_cannot_be_placed() {
        let domain = Domain { sides: [100.0, 100.0, 50.0], periodic: [true, true, false] };
        let mut particles = Particles::default();
        particles.push(Vec3([50.0, 50.0, 7.0]), 5.0, 1.0, 0);
        assert_eq!(lift(&[Vec3::zero()], 20.0, &particles, &domain, 1.0), None);
    }
}
