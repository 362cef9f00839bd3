//! A cluster on its way to an aggregate.

use super::Sphere;
use crate::observe::morphology::{Extent, centre_of_mass, mass, square_gyration_radius};
use crate::spec::{Real, Vec3};

/// Spheres about their centre of mass, and what joining needs to know of them.
pub struct Cluster {
    pub spheres: Vec<Sphere>,
    /// In units in which a sphere of radius 1 has mass 1.
    pub mass: f64,
    /// Squared gyration radius of the centres.
    pub square: f64,
    /// Radius of the ball about the centre of mass that holds all spheres.
    pub reach: f64,
    /// Logarithms of the radii, added up.
    pub logarithms: f64,
}

impl Cluster {
    pub fn single(radius: f64) -> Self {
        Self::new(vec![Sphere { centre: Vec3::zero(), radius }])
    }

    pub fn new(mut spheres: Vec<Sphere>) -> Self {
        let centre = centre_of_mass(&spheres);
        for sphere in &mut spheres {
            sphere.centre = sphere.centre - centre;
        }
        Self {
            mass: spheres.iter().map(mass).sum(),
            square: square_gyration_radius(&spheres, Extent::Centres),
            reach: spheres.iter().map(|s| s.centre.norm() + s.radius).fold(0.0, f64::max),
            logarithms: spheres.iter().map(|s| Real::ln(s.radius)).sum(),
            spheres,
        }
    }
}
