//! Laube, Baric, Salameh, Mädler & Colombi Ciacchi, *A new contact model for the discrete element method simulation of TiO2
//! nanoparticle films under mechanical load*, Granular Matter 20 (2018) 28.
//!
//! Oxide particles of a few nanometres under a layer of water: a meniscus and the layers of water between the surfaces attract, compressed layers
//! repel, rough surfaces stick and slip, and roll against a constant resistance. The modules `eq..` are the numbered equations, `def_..` unnumbered
//! relations. The attraction is not in the paper, which refers to earlier work for it: [`def_water`], [`def_meniscus`] and [`def_capillary`] are
//! classical capillarity, [`def_exact_meniscus`] its exact profile, [`attraction`] composes it for a pair, [`table`] makes it fast. [`law`] is the law for an engine, [`tabulated`] the same
//! for many particles of a few sizes. Every numbered equation, 1 to 14, has a function.
//!
//! # Errata
//!
//! The paper is followed to the letter unless it contradicts itself. A reading that begins with "Erratum" says what is wrong as printed, its effect, and which
//! law fails for the printed form; one that begins with "Ambiguous", which reading of several is taken. `veridem book` collects them on one page.
//!
//! # Choices
//!
//! Where the text allows several readings, the equation says which is taken. Options of [`law::Titania`] are the sign of the solvation force
//! ([`eq03_attraction::Solvation`]), the shape of the meniscus ([`attraction::Meniscus`]), the tangential spring after a slip ([`eq12_sliding::Slip`]), the damping constant of Eq. 7.

pub mod attraction;
pub mod def_aggregate;
pub mod def_capillary;
pub mod def_exact_meniscus;
pub mod def_meniscus;
pub mod def_radius;
pub mod def_rayleigh;
pub mod def_relaxation;
pub mod def_water;
pub mod eq01_total_force;
pub mod eq02_torque;
pub mod eq03_attraction;
pub mod eq04_solvation;
pub mod eq05_amplitude;
pub mod eq06_normal_damping;
pub mod eq07_damping_coefficient;
pub mod eq08_repulsion;
pub mod eq09_stiffness;
pub mod eq10_peak_friction;
pub mod eq11_contact_area;
pub mod eq12_sliding;
pub mod eq13_rolling;
pub mod eq14_friction_factor;
pub mod law;
pub mod table;
pub mod tabulated;

pub use attraction::{Attraction, Meniscus};
pub use law::{Act, Coefficients, Held, Liquid, Lost, Parameters, Titania};
pub use table::Table;
pub use tabulated::Tabulated;

use crate::equation::{Equation, Paper};
use crate::mechanics;

/// The paper: Eqs. 1 to 14.
pub fn paper() -> Paper {
    Paper { name: "titania", numbers: (1..=14).map(|number| number.to_string()).collect(), equations }
}

/// The equations of the paper, in its order.
fn equations() -> Vec<Equation> {
    [
        eq01_total_force::equations(),
        eq02_torque::equations(),
        eq03_attraction::equations(),
        def_water::equations(),
        def_meniscus::equations(),
        def_capillary::equations(),
        def_exact_meniscus::equations(),
        eq04_solvation::equations(),
        def_radius::equations(),
        eq05_amplitude::equations(),
        eq06_normal_damping::equations(),
        eq07_damping_coefficient::equations(),
        eq08_repulsion::equations(),
        eq09_stiffness::equations(),
        def_relaxation::equations(),
        eq10_peak_friction::equations(),
        eq11_contact_area::equations(),
        eq12_sliding::equations(),
        eq13_rolling::equations(),
        def_rayleigh::equations(),
        mechanics::drive::equations(),
        mechanics::discretised_lognormal::equations(),
        def_aggregate::equations(),
        mechanics::rotation::equations(),
        mechanics::body::equations(),
        mechanics::body_inertia::equations(),
        mechanics::capacity::equations(),
        eq14_friction_factor::equations(),
        mechanics::diffusion::equations(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
