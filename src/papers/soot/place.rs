//! The place of an aggregate in its box.

use crate::geometry::{Sphere, centre_of_mass, centred};
use crate::spec::Vec3;

/// Half the side of the box: the aggregate can turn about the origin in it.
pub(super) fn reach(spheres: &[Sphere]) -> f64 {
    spheres.iter().map(|sphere| sphere.centre.norm() + sphere.radius).fold(0.0, f64::max)
}

/// Where the origin of the aggregate is in the box: what lies on the substrate keeps its height.
pub(super) fn middle(reach: f64, on_substrate: bool) -> Vec3<f64> {
    Vec3([reach, reach, if on_substrate { 0.0 } else { reach }])
}

/// How far imported spheres are moved into the box: their origin is their centre of mass, or that of the file if they lie on the substrate.
pub(super) fn shift(spheres: Vec<Sphere>, on_substrate: bool) -> Vec3<f64> {
    let (origin, spheres) =
        if on_substrate { (Vec3::zero(), spheres) } else { (centre_of_mass(&spheres), centred(spheres)) };
    middle(reach(&spheres), on_substrate) - origin
}
