//! The energy balance.
//!
//! Two accounts are kept. The *discrete* one follows the scheme: a kick by `F` changes the kinetic energy by exactly
//! `F . v dt + F^2 dt^2 / 2m`, so the powers of all pairs and walls must add up to the kinetic energy to rounding; it fails if
//! action is not reaction or a torque has the wrong arm. The *physical* one compares with the potentials: it closes to first
//! order in the time step.

use crate::forces::Totals;
use crate::motion::{MotionTotals, WallWork};
use crate::spec::Flat;
use crate::system::bounded;
use serde::{Deserialize, Serialize};

/// Energies since the start, zJ.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Kinetic energy of the free spheres and the loaded walls.
    pub kinetic: f64,
    /// Energy stored in pairs, by cause, when last evaluated.
    pub stored: Vec<f64>,
    /// Energy dissipated by pairs, by cause.
    pub lost_by_pairs: Vec<f64>,
    /// Lost to the global damping.
    pub lost_drag: f64,
    /// Energy stored in necks when they broke, less the energy of the contacts that replace them.
    pub lost_to_breaking: f64,
    /// Work of walls of prescribed velocity.
    pub work_walls: f64,
    /// Work of the loads on walls, and of springs at centres of mass as these moved.
    pub work_loads: f64,
    /// How much larger the work of those springs is at the velocities before each step, which the discrete account needs.
    pub late_work: f64,
    /// Work of the sides of the box.
    pub work_box: f64,
    /// Kinetic energy at the start.
    pub kinetic_at_start: f64,
    /// Energy stored in pairs at the start, by cause.
    pub stored_at_start: Vec<f64>,
    /// Work of all pairs, at the velocities with which they were evaluated.
    pub work_pairs: f64,
    /// The balance of surfaces.
    pub surfaces: SurfaceAccount,
    /// Energy added by the integration scheme.
    pub scheme: f64,
}

/// Energies of the contacts with surfaces and of the surfaces' attraction, zJ.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SurfaceAccount {
    /// Stored energy, by cause, when last evaluated.
    pub stored: Vec<f64>,
    /// Stored energy at the start, by cause.
    pub stored_at_start: Vec<f64>,
    /// Dissipated energy, by cause.
    pub lost: Vec<f64>,
    /// Work of the surfaces as they moved.
    pub work: f64,
    /// Work on the spheres, at the velocities they had.
    pub work_on_spheres: f64,
}

impl SurfaceAccount {
    /// Change of the stored energy since the start.
    pub fn gained(&self) -> f64 {
        self.stored.iter().sum::<f64>() - self.stored_at_start.iter().sum::<f64>()
    }
}

impl Ledger {
    pub(super) fn enter<L: Flat<f64>>(
        &mut self,
        totals: &Totals<L>,
        walls: &WallWork,
        moved: &MotionTotals,
        box_work: f64,
        dt: f64,
    ) {
        self.kinetic = moved.kinetic + walls.kinetic;
        for (k, lost) in self.lost_by_pairs.iter_mut().enumerate() {
            *lost += totals.losses.at(k);
        }
        self.lost_drag += moved.drag;
        self.work_walls += walls.prescribed;
        self.work_loads += walls.load;
        self.work_box += box_work;
        self.work_pairs += totals.power * dt;
        self.scheme += moved.scheme + walls.scheme;
    }

    /// Whether all energies are bounded.
    pub(super) fn is_sound(&self) -> bool {
        let Self { kinetic, stored, lost_by_pairs, lost_drag, lost_to_breaking, work_walls, work_loads, .. } = self;
        let Self { late_work, work_box, kinetic_at_start, stored_at_start, work_pairs, surfaces, scheme, .. } = self;
        let SurfaceAccount { stored: at_surfaces, stored_at_start: at_first, lost, work, work_on_spheres } = surfaces;
        let energies = [kinetic, lost_drag, lost_to_breaking, work_walls, work_loads, late_work, work_box];
        let others = [kinetic_at_start, work_pairs, scheme, work, work_on_spheres];
        let lists = [stored, lost_by_pairs, stored_at_start, at_surfaces, at_first, lost];
        bounded(energies.into_iter().chain(others).chain(lists.into_iter().flatten()))
    }

    /// Whether it has an entry for every cause by which a model stores and dissipates energy, of which there are `stored` and `lost`.
    pub(super) fn has_lengths(&self, stored: usize, lost: usize) -> bool {
        let surfaces = &self.surfaces;
        let has = |list: &[f64], length| list.len() == length;
        let or_none = |list: &[f64]| list.is_empty() || has(list, stored);
        or_none(&self.stored)
            && or_none(&surfaces.stored)
            && has(&self.stored_at_start, stored)
            && has(&surfaces.stored_at_start, stored)
            && has(&self.lost_by_pairs, lost)
            && has(&surfaces.lost, lost)
    }

    /// The total dissipated energy.
    pub fn lost(&self) -> f64 {
        self.lost_by_pairs.iter().chain(&self.surfaces.lost).sum::<f64>() + self.lost_drag + self.lost_to_breaking
    }

    /// The total external work.
    pub fn work(&self) -> f64 {
        self.work_walls + self.work_loads + self.work_box + self.surfaces.work
    }

    /// The scale of the residuals: the energy that was converted.
    pub fn turnover(&self) -> f64 {
        let absolute = |energies: &[f64]| energies.iter().map(|e| e.abs()).sum::<f64>();
        let held = absolute(&self.stored)
            + absolute(&self.stored_at_start)
            + absolute(&self.surfaces.stored)
            + absolute(&self.surfaces.stored_at_start);
        self.kinetic
            + self.kinetic_at_start
            + held
            + self.lost()
            + self.work_walls.abs()
            + self.work_loads.abs()
            + self.work_box.abs()
            + self.surfaces.work.abs()
    }

    /// The residual of the discrete balance, zJ: rounding.
    pub fn discrete_residual(&self) -> f64 {
        let loads = self.work_loads + self.late_work;
        let gained =
            self.work_pairs + self.surfaces.work_on_spheres + self.work_walls + loads + self.scheme - self.lost_drag;
        self.kinetic - self.kinetic_at_start - gained
    }

    /// The residual of the physical balance, zJ: first order in the time step.
    pub fn physical_residual(&self) -> f64 {
        let held = self.stored.iter().sum::<f64>() - self.stored_at_start.iter().sum::<f64>();
        self.kinetic - self.kinetic_at_start + held + self.surfaces.gained() + self.lost() - self.work()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sets one energy of an account.
    type Set = fn(&mut Ledger, f64);

    /// Every energy, and the sign with which it enters the discrete and the physical balance.
    const ENTRIES: [(&str, Set, f64, f64); 15] = [
        ("kinetic", |ledger, energy| ledger.kinetic = energy, 1.0, 1.0),
        ("kinetic at the start", |ledger, energy| ledger.kinetic_at_start = energy, -1.0, -1.0),
        ("stored", |ledger, energy| ledger.stored = vec![0.0, energy], 0.0, 1.0),
        ("stored at the start", |ledger, energy| ledger.stored_at_start = vec![energy, 0.0], 0.0, -1.0),
        ("stored at surfaces", |ledger, energy| ledger.surfaces.stored = vec![0.0, energy], 0.0, 1.0),
        ("there at the start", |ledger, energy| ledger.surfaces.stored_at_start = vec![energy], 0.0, -1.0),
        ("lost by pairs", |ledger, energy| ledger.lost_by_pairs = vec![0.0, energy], 0.0, 1.0),
        ("lost at surfaces", |ledger, energy| ledger.surfaces.lost = vec![energy, 0.0], 0.0, 1.0),
        ("lost to drag", |ledger, energy| ledger.lost_drag = energy, 1.0, 1.0),
        ("lost to breaking", |ledger, energy| ledger.lost_to_breaking = energy, 0.0, 1.0),
        ("work of walls", |ledger, energy| ledger.work_walls = energy, -1.0, -1.0),
        ("work of loads", |ledger, energy| ledger.work_loads = energy, -1.0, -1.0),
        ("work of the box", |ledger, energy| ledger.work_box = energy, 0.0, -1.0),
        ("work of surfaces", |ledger, energy| ledger.surfaces.work = energy, 0.0, -1.0),
        ("work of pairs", |ledger, energy| ledger.work_pairs = energy, -1.0, 0.0),
    ];

    #[test]
    fn every_energy_of_the_physical_balance_is_turned_over_whatever_its_sign() {
        for (name, set, discrete, physical) in ENTRIES {
            // Kinetic energy and losses are not negative.
            let signed = !(name.starts_with("kinetic") || name.starts_with("lost"));
            for &energy in if signed { &[3.0, -3.0][..] } else { &[3.0] } {
                let mut ledger = Ledger::default();
                set(&mut ledger, energy);
                assert_eq!(ledger.discrete_residual(), discrete * energy, "{name}");
                assert_eq!(ledger.physical_residual(), physical * energy, "{name}");
                assert_eq!(ledger.turnover(), 3.0 * physical.abs(), "{name}");
            }
        }
    }

    #[test]
    fn work_at_late_velocities_and_by_the_scheme_enters_the_discrete_balance_alone() {
        let sets: [Set; 3] = [
            |ledger, energy| ledger.late_work = energy,
            |ledger, energy| ledger.scheme = energy,
            |ledger, energy| ledger.surfaces.work_on_spheres = energy,
        ];
        for set in sets {
            let mut ledger = Ledger::default();
            set(&mut ledger, 3.0);
            assert_eq!((ledger.discrete_residual(), ledger.physical_residual(), ledger.turnover()), (-3.0, 0.0, 0.0));
        }
    }

    #[test]
    fn an_account_has_an_entry_for_every_cause_or_is_not_one_of_the_model() {
        let list = |length| vec![0.0; length];
        let of = |[stored, first, lost, at_surfaces, at_first, lost_there]: [usize; 6]| Ledger {
            stored: list(stored),
            stored_at_start: list(first),
            lost_by_pairs: list(lost),
            surfaces: SurfaceAccount {
                stored: list(at_surfaces),
                stored_at_start: list(at_first),
                lost: list(lost_there),
                ..SurfaceAccount::default()
            },
            ..Ledger::default()
        };
        let whole = [2, 2, 3, 2, 2, 3];
        assert!(of(whole).has_lengths(2, 3));
        for place in 0..whole.len() {
            let with = |length| {
                let mut lengths = whole;
                lengths[place] = length;
                of(lengths).has_lengths(2, 3)
            };
            // What is stored now has not been evaluated yet at the start of a stage.
            assert_eq!(with(0), place == 0 || place == 3, "{place}");
            assert!(!with(1) && !with(4), "{place}");
        }
    }
}
