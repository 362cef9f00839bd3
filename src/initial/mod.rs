//! Ways to place spheres: lattices, random packings, aggregates grown and imported, films, surfaces from files.

pub mod aggregate;
mod bodies;
mod builder;
pub mod film;
mod foreign;
pub mod lattice;
pub mod packing;
pub mod stl;

pub use builder::Builder;
pub use lattice::hcp;
pub use packing::{Sizes, random_packing};

use crate::spec::mechanics::packing::mass_factor;
use crate::system::System;

/// Rescales all masses alike, so that the density of the whole box, holes included, is `density`.
pub fn set_system_density(system: &mut System, density: f64) {
    let total: f64 = system.particles.mass.iter().sum();
    let factor = mass_factor(density, system.domain.volume(), total);
    for m in &mut system.particles.mass {
        *m *= factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masses_are_scaled_alike_to_the_density_of_the_box() {
        let mut system = hcp(1.0, [2; 3], 5.0);
        system.particles.mass.iter_mut().zip(1..).for_each(|(mass, k)| *mass = f64::from(k));
        set_system_density(&mut system, 3.0);
        let mass = &system.particles.mass;
        assert!((mass.iter().sum::<f64>() / system.domain.volume() - 3.0).abs() < 1e-14);
        assert!((mass[9] / mass[1] - 5.0).abs() < 1e-14);
    }
}
