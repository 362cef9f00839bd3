//! The crystal that all measurements share: touching silica spheres under the wear law, twelve neighbours each.

use veridem::error::Halt;
use veridem::forces::Instructions;
use veridem::initial::hcp;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::wear::{Interaction, Material, Wear};
use veridem::system::System;

/// Diameter of the spheres, nm.
const DIAMETER: f64 = 6.0;

/// Silica, in MPa and mJ/m².
pub(crate) fn silica() -> Wear {
    let material = Material {
        young_modulus: 73e3,
        poisson_ratio: 0.17,
        tensile_strength: 16e3,
        shear_strength: 11e3,
        surface_energy: 1500.0,
        restitution: 0.95,
        scaling: 0.5,
        forget_stretched_springs: false,
    };
    Wear { material, interaction: Interaction::Full }
}

/// Numbers between -1/2 and 1/2, always the same.
pub(crate) fn noise() -> impl FnMut() -> f64 {
    let mut numbers =
        (1..).map(|k: u64| (k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11) as f64 / (1u64 << 53) as f64 - 0.5);
    move || numbers.next().unwrap_or(0.0)
}

/// Spheres at 0.99 of a diameter from each other, moving a little.
fn crystal(cells: [usize; 3]) -> System {
    let mut system = hcp(DIAMETER, cells, 2.2e-3);
    let mut noise = noise();
    for side in &mut system.domain.sides {
        *side *= 0.99;
    }
    for (x, v) in system.particles.x.iter_mut().zip(&mut system.particles.v) {
        *x = *x * 0.99;
        v.0.fill_with(|| 1e-3 * noise());
    }
    system
}

/// The crystal of so many orthogonal cells of four spheres, ready to run.
pub(crate) fn simulation(cells: [usize; 3], instructions: Instructions) -> Result<Simulation<Wear>, Halt> {
    let settings = Settings::new(1e-4).skin(0.1 * DIAMETER).instructions(instructions);
    Simulation::new(silica(), crystal(cells), settings)
}
