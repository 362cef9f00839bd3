//! The event of a neck that breaks.

use crate::case::units::significant;

/// The neck of these two spheres breaks; its strength is told if necks have strengths of their own.
pub(super) fn breaks((i, j): (u32, u32), strength: Option<f64>) -> String {
    let strength =
        strength.map_or_else(String::new, |strength| format!(": its strength is {}", significant(strength, 4)));
    format!("the neck of {i} and {j} breaks{strength}")
}
