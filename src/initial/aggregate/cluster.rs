//! A cluster during the growth of an aggregate.

use super::law::Sums;
use crate::geometry::Sphere;
use crate::geometry::{SphereExtent, centre_of_mass, square_gyration_radius};
use crate::spec::Vec3;

/// Spheres centred at their centre of mass, with the properties required for joining.
pub(super) struct Cluster {
    pub spheres: Vec<Sphere>,
    pub sums: Sums,
    /// Squared gyration radius.
    pub square: f64,
    /// Radius of the ball about the centre of mass that holds all spheres.
    pub reach: f64,
}

impl Cluster {
    pub(super) fn single(radius: f64, extent: SphereExtent) -> Self {
        Self::new(vec![Sphere { centre: Vec3::zero(), radius }], extent)
    }

    pub(super) fn new(mut spheres: Vec<Sphere>, extent: SphereExtent) -> Self {
        let centre = centre_of_mass(&spheres);
        for sphere in &mut spheres {
            sphere.centre = sphere.centre - centre;
        }
        Self {
            sums: Sums::of(&spheres),
            square: square_gyration_radius(&spheres, extent),
            reach: spheres.iter().map(|s| s.centre.norm() + s.radius).fold(0.0, f64::max),
            spheres,
        }
    }
}
