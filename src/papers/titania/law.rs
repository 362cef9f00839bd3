//! The contact laws that the plans of this paper may have.

use super::case;
use crate::initial::film::Bonding;
use crate::spec::titania::{Tabulated, Titania};
use crate::spec::{Carried, Necked, PairModel, Turns, Vec3};
use crate::system::System;

/// Largest error of the tables of the attraction, pN.
const TOLERANCE: f64 = 0.1;

/// A contact law of this paper.
pub trait Law: PairModel + Clone {
    /// What holds aggregates together.
    const BONDING: Bonding;

    /// The law of a case, for contact spheres of these radii, in ascending order.
    fn new(titania: &case::Titania, radii: &[f64]) -> Self;
    /// The law between aggregates, without tables.
    fn law(&self) -> &Titania;
    /// The tangential spring of a contact.
    fn spring(memory: &Self::Memory<f64>) -> Vec3<f64>;
    /// Whether a neck that holds these energies breaks at this one, zJ.
    fn neck_breaks(held: &Self::Stored<f64>, energy: f64) -> bool;
    /// Energy that slipping springs of a pair lose in a step, zJ.
    fn slipped(lost: &Self::Losses<f64>) -> f64;
}

/// The radii of the spheres of a system, each once, in ascending order.
pub(super) fn radii(system: &System) -> Vec<f64> {
    let mut radii = system.particles.radius.clone();
    radii.sort_unstable_by(f64::total_cmp);
    radii.dedup();
    radii
}

/// A few spheres: the attraction is solved for in every step.
impl Law for Titania {
    const BONDING: Bonding = Bonding::Rigid;

    fn new(titania: &case::Titania, _: &[f64]) -> Self {
        titania.law()
    }
    fn law(&self) -> &Titania {
        self
    }
    fn spring(memory: &Vec3<f64>) -> Vec3<f64> {
        *memory
    }
    fn neck_breaks(_: &Self::Stored<f64>, _: f64) -> bool {
        false
    }
    fn slipped(lost: &Self::Losses<f64>) -> f64 {
        lost.sliding
    }
}

/// Rigid aggregates, or single spheres.
impl Law for Tabulated {
    const BONDING: Bonding = Bonding::Rigid;

    fn new(titania: &case::Titania, radii: &[f64]) -> Self {
        Self::new(titania.law(), radii, TOLERANCE)
    }
    fn law(&self) -> &Titania {
        self.law()
    }
    fn spring(memory: &Vec3<f64>) -> Vec3<f64> {
        *memory
    }
    fn neck_breaks(_: &Self::Stored<f64>, _: f64) -> bool {
        false
    }
    fn slipped(lost: &Self::Losses<f64>) -> f64 {
        lost.sliding
    }
}

/// Aggregates whose particles necks join.
impl Law for Necked<Tabulated> {
    const BONDING: Bonding = Bonding::Necks;

    fn new(titania: &case::Titania, radii: &[f64]) -> Self {
        let springs = titania.neck_springs.as_ref().expect("a case with necks has their springs");
        // The spheres of the contact law overlap at rest by the layers on both.
        let layer = titania.layer.value - 0.5 * titania.core_gap.value;
        Self { law: Law::new(titania, radii), neck: springs.spec(), layer }
    }
    fn law(&self) -> &Titania {
        self.law.law()
    }
    fn spring((memory, _): &Self::Memory<f64>) -> Vec3<f64> {
        *memory
    }
    fn neck_breaks(held: &Self::Stored<f64>, energy: f64) -> bool {
        Self::neck_breaks(held, energy)
    }
    fn slipped((lost, _): &Self::Losses<f64>) -> f64 {
        lost.sliding
    }
}

/// The same with springs that follow a pair which spins.
impl<M: Law + Turns> Law for Carried<M> {
    const BONDING: Bonding = M::BONDING;

    fn new(titania: &case::Titania, radii: &[f64]) -> Self {
        Self(M::new(titania, radii))
    }
    fn law(&self) -> &Titania {
        self.0.law()
    }
    fn spring(memory: &Self::Memory<f64>) -> Vec3<f64> {
        M::spring(memory)
    }
    fn neck_breaks(held: &Self::Stored<f64>, energy: f64) -> bool {
        M::neck_breaks(held, energy)
    }
    fn slipped(lost: &Self::Losses<f64>) -> f64 {
        M::slipped(lost)
    }
}
