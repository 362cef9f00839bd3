//! Initial conditions: lattices, amorphous samples, the junction, and the stages that prepare and test them.

pub mod agglomerate;
pub mod aggregate;
pub mod amorphous;
pub mod directions;
pub mod film;
pub mod junction;
pub mod lattice;
pub mod pair;
pub mod protocol;
pub mod random;
pub mod stages;
pub mod surface;

pub use amorphous::{Sizes, random_packing};
pub use junction::{Body, Junction};
pub use lattice::hcp;

use crate::spec::wear::def_box::mass_factor;
use crate::spec::wear::def_sphere::sphere_mass;
use crate::system::System;

/// Volume of a sphere.
pub fn sphere_volume(r: f64) -> f64 {
    sphere_mass(1.0, r)
}

/// Rescales all masses alike, so that the density of the whole box, holes included, is `density`.
pub fn set_system_density(system: &mut System, density: f64) {
    let total: f64 = system.particles.mass.iter().sum();
    let factor = mass_factor(density, system.domain.volume(), total);
    for m in &mut system.particles.mass {
        *m *= factor;
    }
}
