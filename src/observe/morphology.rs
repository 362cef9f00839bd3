//! The shape of an aggregate: gyration, coordination, convexity, components.

use super::clusters::Clusters;
use super::hull::{inner_radius, measures};
use crate::build::aggregate::Sphere;
use crate::build::directions::spread;
use crate::build::sphere_volume;
use crate::forces::neighbours;
use crate::spec::soot::def_convexity::{convexity as filled, hull_volume};
use crate::spec::soot::eq26_coordination::{are_neighbours, coordination_number as mean_coordination};
use crate::spec::{Real, Vec3};
use crate::system::Domain;

/// Largest gap between neighbours, as a fraction of their mean diameter (Eq. 26).
pub const NEIGHBOURLY: f64 = 0.01;

/// Whether the spheres' own extent counts in the gyration radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Only the centres count, as in the fractal law.
    Centres,
    /// Each sphere adds its squared radius, so that one alone has its radius as gyration radius (Filippov, Zurita & Rosner 2000).
    Radii,
}

/// Mass of a sphere, in units in which one of radius 1 nm has mass 1.
pub fn mass(sphere: &Sphere) -> f64 {
    let r = sphere.radius;
    r * r * r
}

/// Centre of mass, nm.
pub fn centre_of_mass(spheres: &[Sphere]) -> Vec3<f64> {
    let (mut sum, mut total) = (Vec3::zero(), 0.0);
    for s in spheres {
        sum = sum + s.centre * mass(s);
        total += mass(s);
    }
    sum * (1.0 / total)
}

/// Square of [`gyration_radius`], nm^2.
pub fn square_gyration_radius(spheres: &[Sphere], extent: Extent) -> f64 {
    let centre = centre_of_mass(spheres);
    let total: f64 = spheres.iter().map(mass).sum();
    let mut sum = [0.0; 3];
    for s in spheres {
        let own = match extent {
            Extent::Centres => 0.0,
            Extent::Radii => s.radius.squared() / 3.0,
        };
        for (sum, from_centre) in sum.iter_mut().zip((s.centre - centre).0) {
            *sum += from_centre.squared() * (mass(s) / total);
            *sum += own * mass(s) / total;
        }
    }
    sum.iter().sum()
}

/// Root mean square distance from the centre of mass, weighted by mass, nm.
pub fn gyration_radius(spheres: &[Sphere], extent: Extent) -> f64 {
    square_gyration_radius(spheres, extent).sqrt()
}

/// The pairs `i < j` whose centres are closer than `reach` of their radii, which must not decrease with either, in ascending order.
pub fn pairs_within(spheres: &[Sphere], reach: impl Fn(f64, f64) -> f64 + Sync) -> Vec<(usize, usize)> {
    let x: Vec<Vec3<f64>> = spheres.iter().map(|s| s.centre).collect();
    let radii: Vec<f64> = spheres.iter().map(|s| s.radius).collect();
    let open = Domain { sides: [1.0; 3], periodic: [false; 3] };
    neighbours(&x, &radii, &open, reach).into_iter().map(|pair| (pair.p as usize, pair.q as usize)).collect()
}

/// The pairs of neighbours in the sense of Eq. 26.
pub fn neighbouring(spheres: &[Sphere]) -> Vec<(usize, usize)> {
    let mut pairs = pairs_within(spheres, |r, s| (1.0 + 2.0 * NEIGHBOURLY) * (r + s));
    pairs.retain(|&(i, j)| {
        let (a, b) = (&spheres[i], &spheres[j]);
        are_neighbours(a.centre, b.centre, a.radius, b.radius, NEIGHBOURLY) > 0.0
    });
    pairs
}

/// Mean number of neighbours of a sphere (Eq. 26).
pub fn coordination_number(spheres: &[Sphere]) -> f64 {
    mean_coordination(2.0 * neighbouring(spheres).len() as f64, spheres.len() as f64)
}

/// Into how many parts the spheres fall that are not neighbours of each other.
pub fn components(spheres: &[Sphere]) -> usize {
    Clusters::new(spheres.len(), neighbouring(spheres)).count()
}

/// A value and a bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// Middle of the interval that holds the true value.
    pub value: f64,
    /// Half its width: zero where only rounding is lost.
    pub error: f64,
}

/// Points on each of unequal spheres.
const POINTS: usize = 400;

/// Volume of the spheres over that of their convex hull: by Steiner's formula if they are equal. Unequal spheres are replaced
/// by one polyhedron of many corners, scaled: inscribed in them it gives a lower bound of the hull, around them an upper one.
pub fn convexity(spheres: &[Sphere]) -> Bounded {
    let own: f64 = spheres.iter().map(|s| sphere_volume(s.radius)).sum();
    let r = spheres[0].radius;
    if spheres.iter().all(|s| s.radius == r) {
        let centres: Vec<Vec3<f64>> = spheres.iter().map(|s| s.centre).collect();
        let hull = measures(&centres);
        return Bounded { value: filled(own, hull_volume(hull.volume, hull.surface, hull.curvature, r)), error: 0.0 };
    }
    let corners = spread(POINTS);
    // Volume of the hull of the polyhedra, which are `scale` times as large as those inscribed.
    let hull = |scale: f64| {
        let points: Vec<Vec3<f64>> =
            spheres.iter().flat_map(|s| corners.iter().map(move |&u| s.centre + u * (scale * s.radius))).collect();
        measures(&points).volume
    };
    let (least, most) = (filled(own, hull(1.0 / inner_radius(&corners))), filled(own, hull(1.0)));
    Bounded { value: 0.5 * (least + most), error: 0.5 * (most - least) }
}

#[cfg(test)]
mod tests;
