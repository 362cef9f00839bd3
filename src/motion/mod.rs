//! From forces to motion: spheres, rigid bodies and walls, and the sides of the box.

mod bodies;
mod box_relaxation;
mod members;
mod push;
mod spheres;
mod steering;
mod surfaces;
pub mod verlet;
mod walls;

pub use bodies::{LoadTable, advance_bodies};
pub use box_relaxation::{BoxMotion, BoxRelaxation};
pub use spheres::{MotionTotals, Spheres, Step, advance, inertia};
pub use verlet::Integrator;
pub use walls::{WallWork, drive, kinetic_energy};
