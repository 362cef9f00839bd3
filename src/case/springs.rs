//! The four springs of a neck or of a frictional contact, as sections of a case file, and the transport of springs.

use super::check::{Found, expect};
use super::quantity::{Drag, Energy, Quantity, Stiffness, quantity};
use super::section::{section, words};
use crate::spec::mechanics::four_springs::Springs;

section! {
    /// Four springs with their dashpots.
    pub struct FourSprings {
        /// Normal stiffness.
        normal_stiffness: Quantity<Stiffness>,
        /// Tangential stiffness.
        tangential_stiffness: Quantity<Stiffness>,
        /// Rolling stiffness.
        rolling_stiffness: Quantity<Stiffness>,
        /// Torsional stiffness.
        torsional_stiffness: Quantity<Stiffness>,
        /// Normal damping coefficient.
        normal_damping: Quantity<Drag>,
        /// Tangential damping coefficient.
        tangential_damping: Quantity<Drag>,
        /// Rolling damping coefficient.
        rolling_damping: Quantity<Drag>,
        /// Torsional damping coefficient.
        torsional_damping: Quantity<Drag>,
    }
}

words! {
    /// Whether springs in the contact plane follow a pair that spins about its normal.
    pub enum Transport {
        /// They are projected into the contact plane, as in the papers: they follow the normal, and stay fixed in space while the pair spins about it.
        Projected = "projected",
        /// They are also turned about the normal with the mean spin of the two spheres: a pair that turns as a body carries them along.
        Carried = "carried",
    }
}

/// Four springs: normal, tangential, rolling and torsional stiffness and damping.
pub fn four_springs(stiffness: [&str; 4], damping: [&str; 4]) -> FourSprings {
    let ([k_n, k_t, k_r, k_o], [c_n, c_t, c_r, c_o]) = (stiffness, damping);
    FourSprings {
        normal_stiffness: quantity(k_n),
        tangential_stiffness: quantity(k_t),
        rolling_stiffness: quantity(k_r),
        torsional_stiffness: quantity(k_o),
        normal_damping: quantity(c_n),
        tangential_damping: quantity(c_t),
        rolling_damping: quantity(c_r),
        torsional_damping: quantity(c_o),
    }
}

impl FourSprings {
    /// The springs in engine units.
    pub fn spec(&self) -> Springs<f64> {
        Springs {
            k_n: self.normal_stiffness.value,
            k_t: self.tangential_stiffness.value,
            k_r: self.rolling_stiffness.value,
            k_o: self.torsional_stiffness.value,
            eta_n: self.normal_damping.value,
            eta_t: self.tangential_damping.value,
            eta_r: self.rolling_damping.value,
            eta_o: self.torsional_damping.value,
        }
    }
}

/// Checks the necks of a model of any paper.
pub fn necks(model: &str, neck: &Option<FourSprings>, strength: &Option<Quantity<Energy>>, found: &mut Found) {
    if let Some(energy) = strength {
        expect(found, energy.value > 0.0, &format!("{model}.break_energy"), energy, "more than zero");
    }
    if let Some(neck) = neck {
        springs(neck, &format!("{model}.neck_springs"), found);
    }
}

/// Checks four springs.
pub fn springs(springs: &FourSprings, section: &str, found: &mut Found) {
    let at = |key: &str| format!("{section}.{key}");
    for (key, stiffness) in [
        ("normal_stiffness", &springs.normal_stiffness),
        ("tangential_stiffness", &springs.tangential_stiffness),
        ("rolling_stiffness", &springs.rolling_stiffness),
        ("torsional_stiffness", &springs.torsional_stiffness),
    ] {
        expect(found, stiffness.value > 0.0, &at(key), stiffness, "more than zero");
    }
    for (key, damping) in [
        ("normal_damping", &springs.normal_damping),
        ("tangential_damping", &springs.tangential_damping),
        ("rolling_damping", &springs.rolling_damping),
        ("torsional_damping", &springs.torsional_damping),
    ] {
        expect(found, damping.value >= 0.0, &at(key), damping, "zero or more");
    }
}
