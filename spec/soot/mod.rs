//! Demidov, Gor & Khalizov, *Discrete element method model of soot aggregates*,
//! Phys. Rev. E 110 (2024) 054902.
//!
//! Aggregates of spheres that touch or are joined by necks, attract each other, and are compacted by a coating or pulled apart by the tip of an atomic force microscope. The modules `eq..` are the
//! numbered equations, `def_..` unnumbered relations. [`four_springs`](mechanics::four_springs) are the four springs of a contact, [`def_contact`] neck and friction, [`def_wall`] substrate and tip,
//! [`law`] the law for an engine, [`verlet`](mechanics::verlet) the step. Every numbered equation, 1 to 33, has a function. All of it holds for unequal spheres; the equal spheres of the paper are a
//! special case.
//!
//! # Errata
//!
//! The paper is followed to the letter unless it contradicts itself. A reading that begins with "Erratum" says what is wrong as printed, its effect, and which
//! law fails for the printed form; one that begins with "Ambiguous", which reading of several is taken. `veridem book` collects them on one page.
//!
//! Choices where the text is ambiguous: the normal force of the caps ([`eq13_friction::static_friction`]), the saturation distance
//! ([`eq19_equal_hamaker::saturated_hamaker`]), direction and meaning of Eq. 23, Eq. 25 against its prose, the hull ([`hull_volume`](mechanics::convex_hull::hull_volume)), the arms at a wall ([`def_wall`]).

pub mod def_body_forces;
pub mod def_contact;
pub mod def_convexity;
pub mod def_facets;
pub mod def_filter;
pub mod def_neck_stress;
pub mod def_wall;
pub mod eq18_hamaker;
pub mod eq19_equal_hamaker;
pub mod eq21_hamaker_plane;
pub mod eq23_capillary;
pub mod eq24_fractal;
pub mod eq26_coordination;
pub mod eq27_cantilever;
pub mod eq30_transfer;
pub mod law;

pub use crate::mechanics::approach as eq25_tip;
pub use crate::mechanics::friction as eq13_friction;
pub use crate::mechanics::newton as eq01_motion;
pub use crate::mechanics::pair_geometry as eq03_geometry;
pub use crate::mechanics::relative_spin as eq09_relative_spin;
pub use crate::mechanics::relative_velocity as eq04_relative_velocity;
pub use crate::mechanics::spring_force as eq12_spring_force;

pub use def_body_forces::Attraction;
pub use law::{
    Along, Coefficients, Following, Lagging, Printed, Programmed, Reading, SUBSTRATE, Soot, Stored, Strength, TIP, Wall,
};

use crate::equation::{Equation, Paper};
use crate::mechanics;

/// The paper: Eqs. 1 to 33.
pub fn paper() -> Paper {
    Paper { name: "soot", numbers: (1..=33).map(|number| number.to_string()).collect(), equations }
}

/// The equations of the paper, in its order.
fn equations() -> Vec<Equation> {
    [
        mechanics::primary_particle::equations(),
        eq01_motion::equations(),
        mechanics::verlet::equations(),
        eq03_geometry::equations(),
        eq04_relative_velocity::equations(),
        eq09_relative_spin::equations(),
        mechanics::rotated_spring::equations(),
        eq12_spring_force::equations(),
        def_neck_stress::equations(),
        mechanics::pair_frequency::equations(),
        eq13_friction::equations(),
        def_contact::equations(),
        def_wall::equations(),
        eq18_hamaker::equations(),
        eq19_equal_hamaker::equations(),
        eq21_hamaker_plane::equations(),
        def_facets::equations(),
        eq23_capillary::equations(),
        def_body_forces::equations(),
        eq24_fractal::equations(),
        eq25_tip::equations(),
        eq26_coordination::equations(),
        mechanics::convex_hull::equations(),
        def_convexity::equations(),
        eq27_cantilever::equations(),
        eq30_transfer::equations(),
        def_filter::equations(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
