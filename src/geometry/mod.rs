//! Geometry: sets of spheres, neighbours, directions, hulls, shadows.

pub mod capacity;
pub mod clusters;
pub mod directions;
pub mod hull;
mod neighbours;
pub mod shadow;
mod spheres;

pub use neighbours::{Neighbour, neighbours, neighbours_but};
pub use spheres::{Extent, Sphere, centre_of_mass, gyration_radius, mass, pairs_within, square_gyration_radius};
