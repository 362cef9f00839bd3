//! The shape of an aggregate: coordination number and convexity.

use crate::geometry::Sphere;
use crate::geometry::directions::spread;
use crate::geometry::hull::{inner_radius, measures};
use crate::initial::aggregate::neighbouring;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use crate::spec::mechanics::convex_hull::hull_volume;
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::soot::def_convexity::convexity as filled;
use crate::spec::soot::eq26_coordination::coordination_number as mean_coordination;

/// Mean number of neighbours of a sphere (Eq. 26).
pub fn coordination_number(spheres: &[Sphere]) -> f64 {
    let neighbouring = neighbouring(spheres, &Interrupt::default()).expect("nothing asks to stop");
    mean_coordination(2.0 * neighbouring.len() as f64, spheres.len() as f64)
}

/// A value and a bound of its error.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Bounded {
    /// Middle of the interval that holds the true value.
    pub value: f64,
    /// Half its width: zero where only rounding is lost.
    pub error: f64,
}

/// Points on each of unequal spheres.
const POINTS: usize = 400;

/// Volume of the spheres relative to the volume of their convex hull: by Steiner's formula if they are equal. Unequal spheres are replaced
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
