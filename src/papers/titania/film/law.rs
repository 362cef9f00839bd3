//! What acts between the particles of a film, and holds its aggregates together.

use crate::initial::film::Bonding;
use crate::papers::titania::case;
use crate::spec::titania::Tabulated;
use crate::spec::{Flat, Necked, PairModel, Vec3};

/// A contact law for films.
pub trait Law: PairModel + Clone {
    /// What holds aggregates together.
    const BONDING: Bonding;

    /// The law of a case, with the attraction in tables.
    fn new(titania: &case::Titania, tables: Tabulated) -> Self;
    /// The contact law between aggregates.
    fn tables(&self) -> &Tabulated;
    /// The tangential spring of a contact.
    fn spring(memory: &Self::Memory<f64>) -> Vec3<f64>;
    /// What the springs of a neck hold.
    fn in_neck(held: &Self::Stored<f64>) -> f64;
}

/// Rigid aggregates.
impl Law for Tabulated {
    const BONDING: Bonding = Bonding::Rigid;

    fn new(_: &case::Titania, tables: Tabulated) -> Self {
        tables
    }
    fn tables(&self) -> &Tabulated {
        self
    }
    fn spring(memory: &Vec3<f64>) -> Vec3<f64> {
        *memory
    }
    fn in_neck(_: &Self::Stored<f64>) -> f64 {
        0.0
    }
}

/// Aggregates whose particles necks join.
impl Law for Necked<Tabulated> {
    const BONDING: Bonding = Bonding::Necks;

    fn new(titania: &case::Titania, tables: Tabulated) -> Self {
        let springs = titania.neck_springs.as_ref().expect("a case with necks has their springs");
        // The spheres of the contact law overlap at rest by the layers on both.
        let layer = titania.layer.value - 0.5 * titania.core_gap.value;
        Self { law: tables, neck: springs.spec(), layer }
    }
    fn tables(&self) -> &Tabulated {
        &self.law
    }
    fn spring((memory, _): &Self::Memory<f64>) -> Vec3<f64> {
        *memory
    }
    fn in_neck((_, held): &Self::Stored<f64>) -> f64 {
        (0..4).map(|spring| *held.at(spring)).sum()
    }
}
