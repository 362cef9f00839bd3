//! Pham-Ba & Molinari, *Adhesive wear with a coarse-grained discrete element model*,
//! Comput. Methods Appl. Mech. Engrg. 397 (2022) 115124.

pub mod def_potential;
pub mod def_restitution;
pub mod def_sphere;
pub mod def_stable_step;
pub mod eq01_symplectic_euler;
pub mod eq02_pair_force;
pub mod eq03_normal_force;
pub mod eq04_tangential_force;
pub mod eq05_rescaled_maximum;
pub mod eq06_critical_time_step;
pub mod eq07_normal_stiffness;
pub mod eq08_tangential_stiffness;
pub mod eq09_elastic_separation;
pub mod eq10_fracture_separation;
pub mod eq11_maximum_tangential_force;
pub mod eq12_normal_damping;
pub mod eq13_tangential_damping;
pub mod eq14_effective_radius;
pub mod eq15_normal_cross_section;
pub mod eq16_tangential_cross_section;
pub mod eq17_effective_mass;
pub mod eq18_critical_diameter;
pub mod eq19_minimum_diameter;
pub mod law;

pub use law::{Interaction, Material, Parameters, Wear};

use crate::equation::Equation;

/// The equations of the paper, in its order.
pub fn equations() -> Vec<Equation> {
    [
        eq01_symplectic_euler::equations(),
        eq02_pair_force::equations(),
        eq03_normal_force::equations(),
        def_potential::equations(),
        eq04_tangential_force::equations(),
        eq05_rescaled_maximum::equations(),
        eq06_critical_time_step::equations(),
        def_stable_step::equations(),
        eq07_normal_stiffness::equations(),
        eq08_tangential_stiffness::equations(),
        eq09_elastic_separation::equations(),
        eq10_fracture_separation::equations(),
        eq11_maximum_tangential_force::equations(),
        eq12_normal_damping::equations(),
        def_restitution::equations(),
        eq13_tangential_damping::equations(),
        eq14_effective_radius::equations(),
        eq15_normal_cross_section::equations(),
        eq16_tangential_cross_section::equations(),
        eq17_effective_mass::equations(),
        eq18_critical_diameter::equations(),
        eq19_minimum_diameter::equations(),
        def_sphere::equations(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
