//! Pham-Ba & Molinari, *Adhesive wear with a coarse-grained discrete element model*,
//! Comput. Methods Appl. Mech. Engrg. 397 (2022) 115124.
//!
//! A solid of cohesive spheres: every pair is a spring that also carries tension, weakens and breaks, and heals when its particles touch
//! again. The modules `eq..` are the numbered equations of the text, `a..` the equations of the appendix, `def_..` unnumbered relations.
//! [`def_parameters`] derives the parameters of a pair from a material, [`def_contact`] is the force law, [`law`] the law for an engine,
//! [`eq01_symplectic_euler`] the step. Every numbered equation, 1 to 22 and A.1 to A.66, has a function.
//!
//! # Errata
//!
//! The paper is followed to the letter unless it contradicts itself. A reading that begins with "Erratum" says what is wrong as printed, its effect, and which
//! law fails for the printed form; one that begins with "Ambiguous", which reading of several is taken. `veridem book` collects them on one page.

pub mod a01_pair_motion;
pub mod a04_time_step;
pub mod a06_energy;
pub mod a07_scaled_variables;
pub mod a11_scaled_step;
pub mod a14_many_steps;
pub mod a16_eigenvalues;
pub mod a17_stability;
pub mod a19_critical_damping;
pub mod a20_stress;
pub mod a24_stiffness;
pub mod a28_elastic_limit;
pub mod a31_fracture_energy;
pub mod a35_impact;
pub mod a37_frequency;
pub mod a39_impact_end;
pub mod a42_restitution;
pub mod a45_damping;
pub mod a49_rescaled_separation;
pub mod a50_pair_strain;
pub mod a56_body_energy;
pub mod a60_elastic_constants;
pub mod def_contact;
pub mod def_elastic_constants;
pub mod def_kinematics;
pub mod def_parameters;
pub mod def_potential;
pub mod def_published;
pub mod def_restitution;
pub mod def_stable_step;
pub mod def_zero_force_end;
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
pub mod eq18_critical_diameter;
pub mod eq19_minimum_diameter;
pub mod eq20_matched_strength;
pub mod eq21_critical_damping;
pub mod eq22_critical_length;
pub mod law;

pub use crate::mechanics::reduced_mass as eq17_effective_mass;
pub use crate::mechanics::symplectic_euler as eq01_symplectic_euler;

pub use def_contact::Parameters;
pub use def_published::Published;
pub use law::{Interaction, Material, Wear};

use crate::equation::{Equation, Paper};
use crate::mechanics;

/// The paper: Eqs. 1 to 22 and A.1 to A.66.
pub fn paper() -> Paper {
    let text = (1..=22).map(|number| number.to_string());
    let appendix = (1..=66).map(|number| format!("A{number}"));
    Paper { name: "wear", numbers: text.chain(appendix).collect(), equations }
}

/// The equations of the paper, in its order.
fn equations() -> Vec<Equation> {
    [
        eq01_symplectic_euler::equations(),
        eq02_pair_force::equations(),
        def_kinematics::equations(),
        eq03_normal_force::equations(),
        def_potential::equations(),
        eq04_tangential_force::equations(),
        eq05_rescaled_maximum::equations(),
        mechanics::projected_spring::equations(),
        def_contact::equations(),
        def_published::equations(),
        eq06_critical_time_step::equations(),
        def_stable_step::equations(),
        mechanics::stable_step::equations(),
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
        mechanics::sphere::equations(),
        eq18_critical_diameter::equations(),
        eq19_minimum_diameter::equations(),
        def_parameters::equations(),
        eq20_matched_strength::equations(),
        def_elastic_constants::equations(),
        eq21_critical_damping::equations(),
        mechanics::drag::equations(),
        mechanics::virial::equations(),
        mechanics::truncated_lognormal::equations(),
        mechanics::packing::equations(),
        eq22_critical_length::equations(),
        a01_pair_motion::equations(),
        a04_time_step::equations(),
        a06_energy::equations(),
        a07_scaled_variables::equations(),
        a11_scaled_step::equations(),
        a14_many_steps::equations(),
        a16_eigenvalues::equations(),
        a17_stability::equations(),
        a19_critical_damping::equations(),
        a20_stress::equations(),
        a24_stiffness::equations(),
        a28_elastic_limit::equations(),
        a31_fracture_energy::equations(),
        a35_impact::equations(),
        a37_frequency::equations(),
        a39_impact_end::equations(),
        a42_restitution::equations(),
        def_zero_force_end::equations(),
        a45_damping::equations(),
        a49_rescaled_separation::equations(),
        a50_pair_strain::equations(),
        a56_body_energy::equations(),
        a60_elastic_constants::equations(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
