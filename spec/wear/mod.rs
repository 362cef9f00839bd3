//! Pham-Ba & Molinari, *Adhesive wear with a coarse-grained discrete element model*,
//! Comput. Methods Appl. Mech. Engrg. 397 (2022) 115124.

pub mod eq03_normal_force;

use crate::equation::Equation;

/// The equations of the paper, in its order.
pub fn equations() -> Vec<Equation> {
    [eq03_normal_force::equations()].into_iter().flatten().collect()
}
