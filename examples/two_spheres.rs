//! Two silica spheres collide under the wear law of Pham-Ba & Molinari (2022).
//!
//!     cargo run --example two_spheres

use std::error::Error;
use veridem::run::advance_until;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::PairModel;
use veridem::spec::mechanics::reduced_mass::effective_mass;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::wear::a42_restitution::pair_restitution;
use veridem::spec::wear::{Interaction, Material, Wear};
use veridem::system::System;

fn main() -> Result<(), Box<dyn Error>> {
    // Units: nm, ns, ag; hence m/s, pN, zJ, MPa, mJ/m².
    let silica = Material {
        young_modulus: 73e3,
        poisson_ratio: 0.17,
        tensile_strength: 16e3,
        shear_strength: 11e3,
        surface_energy: 1500.0,
        restitution: 0.8,
        scaling: 0.5,
        forget_stretched_springs: false,
    };
    // Without cohesion, spheres separate where they met.
    let law = Wear { material: silica, interaction: Interaction::Repulsive };
    let (radius, mass) = (3.0, sphere_mass(2.2e-3, 3.0));
    let spheres = System::builder()
        .sphere([0.0, 0.0, 0.0], radius, mass)
        .velocity([5.0, 0.0, 0.0])
        .sphere([6.1, 0.0, 0.0], radius, mass)
        .velocity([-5.0, 0.0, 0.0])
        .build()?;
    let mut simulation = Simulation::new(law, spheres, Settings::new(1e-5).skin(0.5))?;

    let mut largest: f64 = 0.0;
    advance_until(&mut simulation, |now| {
        let overlap = now.largest_overlap().map_or(0.0, |(_, ratio)| 2.0 * radius * ratio);
        largest = largest.max(overlap);
        largest > 0.0 && overlap == 0.0
    })?;

    let (system, ledger) = (simulation.system(), simulation.ledger());
    println!("largest overlap            {largest:.4} nm");
    println!("apart again after          {:.4} ns", system.time);
    println!("coefficient of restitution {:.4}", system.particles.v[1].0[0] / 5.0);
    // The paper takes the damping for the stated restitution from an approximation, Eq. A.43.
    let k = law.coefficients(radius, radius, mass, mass);
    println!("the same by Eq. A.42       {:.4}", pair_restitution(k.k_n, effective_mass(mass, mass), k.c_n));
    println!("energy lost to damping     {:.4} zJ of {:.4}", ledger.lost(), ledger.kinetic_at_start);
    Ok(())
}
