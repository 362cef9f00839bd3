//! Geometry: sets of spheres, neighbours, directions, hulls, shadows, triangulated surfaces, principal axes.

mod balls;
pub mod capacity;
pub mod clusters;
pub mod directions;
mod domain;
pub mod hull;
pub mod jacobi;
mod neighbours;
pub mod principal;
pub mod shadow;
mod spheres;
mod surfaces;
pub mod triangles;

pub use neighbours::{Neighbour, neighbours, neighbours_but};
pub use spheres::{
    Sphere, SphereExtent, centre_of_mass, centred, gyration_radius, mass, pairs_within, square_gyration_radius,
};
