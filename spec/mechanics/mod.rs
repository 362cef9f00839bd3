//! Mechanics shared by all papers: spheres and rigid bodies, their integration, springs and their transport, drag, stress, and distributions.
//!
//! Relations used by several models are defined once, here. An equation that a paper prints or prescribes keeps the id of that paper, under which it is listed; the paper's
//! module refers to it. Equations with an id of this module belong to no paper. [`four_springs`] are the springs of a contact or a neck, [`necked`] adds necks to any contact
//! law, and [`carried`] springs that follow a pair which spins.

#[cfg(test)]
pub(crate) mod amplification;
pub mod approach;
pub mod body;
pub mod body_inertia;
pub mod box_relaxation;
pub mod box_stress;
pub mod capacity;
pub mod carried;
pub mod carried_spring;
pub mod contact_kinematics;
pub mod convex_hull;
pub mod coordinated_step;
pub mod diffusion;
pub mod discretised_lognormal;
pub mod drag;
pub mod drive;
pub mod four_springs;
pub mod friction;
pub mod friction_share;
pub mod gyration;
pub mod kick_and_drift;
pub mod kinetic_energy;
pub mod neck_rest;
pub mod necked;
pub mod newton;
pub mod oscillation;
pub mod packing;
pub mod pair_frequency;
pub mod pair_geometry;
pub mod primary_particle;
pub mod projected_spring;
pub mod quaternion;
pub mod reduced_mass;
pub mod relative_spin;
pub mod relative_velocity;
pub mod rolling;
pub mod rotated_spring;
pub mod rotation;
#[cfg(test)]
pub(crate) mod samples;
pub mod solids;
pub mod sphere;
pub mod spring_force;
pub mod springs_step;
pub mod stable_step;
pub mod symplectic_euler;
pub mod thermal;
pub mod truncated_lognormal;
pub mod verlet;
pub mod virial;
pub mod weibull;
pub mod work;

use crate::equation::{Equation, Paper};

/// Equations without a paper, and hence without numbers.
pub fn paper() -> Paper {
    Paper { name: "mechanics", numbers: vec![], equations }
}

/// The equations of this room that no paper lists.
fn equations() -> Vec<Equation> {
    [
        kick_and_drift::equations(),
        kinetic_energy::equations(),
        work::equations(),
        box_stress::equations(),
        box_relaxation::equations(),
        quaternion::equations(),
        solids::equations(),
        gyration::equations(),
        oscillation::equations(),
        rolling::equations(),
        coordinated_step::equations(),
        friction_share::equations(),
        thermal::equations(),
        neck_rest::equations(),
        carried_spring::equations(),
        weibull::equations(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
