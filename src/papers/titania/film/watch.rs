//! The measurements of a film under a tip: the force on the tip, and the events at contacts.

use super::columns::results;
use super::contacts::Contacts;
use super::{FIXED, FilmStage, TIP};
use crate::geometry::clusters::Clusters;
use crate::initial::film::Bonding;
use crate::output::{Cell, Finding};
use crate::papers::titania::Law;
use crate::simulation::Simulation;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// Interval at which all contacts are examined, ns.
const LOOK: f64 = 0.05;
/// Why a stage has no mean force.
const SHORT: &str = "shorter than the averaging time";
/// Pulling force below which the tip counts as free, pN.
const NOTHING: f64 = 50.0;

/// The observer of a stage.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Watch {
    contacts: Contacts,
    /// Upward force on the tip, summed since the last mean was taken, and the number of steps.
    window: (f64, u64),
    /// Displacement of the tip, and the mean force on it.
    curve: Vec<(f64, f64)>,
    /// Whether a mean has been taken in the last step.
    closed: bool,
    /// Displacement of the tip when the stage began.
    from: f64,
    /// Number of necks when the stage began.
    necks: u64,
    /// Number of bodies and single spheres connected to the tip, and whether the fixed ones are among them.
    on_tip: u64,
    holds: bool,
    /// Displacement of the tip when it lost its connection to the bottom.
    rupture: Option<f64>,
}

impl Watch {
    /// Starts observing.
    pub fn begin<M: Law>(simulation: &Simulation<M>) -> Self {
        let System { walls, necks, .. } = simulation.system();
        let from = walls.get(TIP).map_or(0.0, |tip| tip.travel.0[2]);
        Self { contacts: Contacts::begin(simulation), from, necks: necks.len() as u64, ..Self::default() }
    }

    /// Observes a step and returns the events since the last examination. Forces are averaged over `average`, ns.
    pub fn follow<M: Law>(&mut self, stage: FilmStage, average: f64, simulation: &Simulation<M>) -> Vec<String> {
        let (system, dt) = (simulation.system(), simulation.settings().dt);
        let due = |interval: f64| system.step.is_multiple_of(((interval / dt).round() as u64).max(1));
        let mut events = if due(LOOK) { self.contacts.look(simulation) } else { Vec::new() };
        let Some(tip) = system.walls.get(TIP) else { return events };
        self.window = (self.window.0 + tip.force.0[2], self.window.1 + 1);
        self.closed = due(average);
        if self.closed {
            self.curve.push((tip.travel.0[2], self.window.0 / self.window.1 as f64));
            self.window = (0.0, 0);
            self.hang_together(simulation);
            if stage == FilmStage::Retraction && !self.holds && self.rupture.is_none() {
                self.rupture = Some(tip.travel.0[2]);
                events.push(format!("rupture, {} bodies stay on the tip", self.on_tip));
            }
        }
        events
    }

    /// Finds the bodies connected to the tip.
    fn hang_together<M: Law>(&mut self, simulation: &Simulation<M>) {
        let system = simulation.system();
        // Single spheres are numbered after the bodies; the numbers of members stay unused.
        let (body, bodies) = (&system.particles.body, system.bodies.len());
        let part = |sphere: usize| (body[sphere] as usize).checked_sub(1).unwrap_or(bodies + sphere);
        let links = simulation.contacts().map(|(i, j, ..)| (part(i), part(j)));
        let mut clusters = Clusters::new(bodies + body.len(), links);
        let roots: Vec<usize> = (0..bodies + body.len()).map(|part| clusters.root(part)).collect();
        let of = |wall: usize| system.bodies.iter().position(|body| body.wall as usize == wall + 1).map(|b| roots[b]);
        let tip = of(TIP);
        self.holds = of(FIXED) == tip;
        self.on_tip = roots.iter().filter(|&&root| Some(root) == tip).count() as u64 - 1;
    }

    /// Whether the tip has moved by `way` since the rupture, nm.
    pub fn parted_by(&self, way: f64) -> bool {
        self.rupture.zip(self.curve.last()).is_some_and(|(rupture, now)| now.0 >= rupture + way)
    }

    /// The latest mean force on the tip, pN; none before the first.
    fn mean_force(&self) -> Option<f64> {
        self.curve.last().map(|point| point.1)
    }

    /// Whether the tip has reached a force, pN.
    pub fn presses_with(&self, setpoint: f64) -> bool {
        self.mean_force().is_some_and(|force| force >= setpoint)
    }

    /// The cells of the columns of the stage.
    pub fn look<M: Law>(&self, simulation: &Simulation<M>) -> Vec<Cell> {
        let Contacts { slidings, rollings, detachments, .. } = self.contacts;
        let System { walls, necks, .. } = simulation.system();
        let mut cells = Vec::new();
        if let Some(tip) = walls.get(TIP) {
            cells.extend([tip.travel.0[2], tip.force.0[2]].map(Cell::Number));
            cells.push(Cell::Count(self.on_tip));
        }
        let own = match M::BONDING {
            Bonding::Rigid => rollings,
            Bonding::Necks => necks.len() as u64,
        };
        cells.extend([self.contacts.count() as u64, slidings, detachments, own].map(Cell::Count));
        cells
    }

    /// The cells of a window that has closed in this step.
    pub fn window(&self) -> Option<Vec<Cell>> {
        let &(moved, force) = self.curve.last().filter(|_| self.closed)?;
        Some([moved, force].map(Cell::Number).into())
    }

    /// The findings of the stage.
    pub fn findings<M: Law>(&self, stage: FilmStage, setpoint: f64, simulation: &Simulation<M>) -> Vec<Finding> {
        let Contacts { slidings, rollings, detachments, .. } = self.contacts;
        let mut found = match stage {
            FilmStage::Relaxation => Vec::new(),
            FilmStage::Approach => vec![
                Finding::words(
                    results::END_OF_APPROACH,
                    if self.presses_with(setpoint) {
                        "at the setpoint"
                    } else {
                        "at the largest depth, below the setpoint"
                    },
                ),
                Finding::reached(results::APPROACH_FORCE, self.mean_force(), SHORT).target(setpoint),
                Finding::reached(results::DEPTH, self.curve.last().map(|point| -point.0), SHORT),
            ],
            FilmStage::Retraction => self.peaks(),
        };
        let broken = self.necks - simulation.system().necks.len() as u64;
        let third = match M::BONDING {
            Bonding::Rigid => (results::ROLLINGS, rollings),
            Bonding::Necks => (results::BROKEN_NECKS, broken),
        };
        let counts = [(results::SLIDINGS, slidings), third, (results::DETACHMENTS, detachments)];
        found.extend(counts.map(|(result, n)| Finding::count(result, n).during(stage.name())));
        found
    }

    /// The largest pulling force on the tip, if it was ever pulled, and the last peak before the tip was free, pN.
    fn largest_and_last_pull(&self) -> (Option<f64>, Option<f64>) {
        let pull = |k: usize| -self.curve[k].1;
        let pulled = (0..self.curve.len()).rev().find(|&k| pull(k) > NOTHING);
        // Back from there the pull rises to its last peak.
        let last = pulled.map(|last| pull((1..=last).rev().find(|&k| pull(k) > pull(k - 1)).unwrap_or(0)));
        let largest = (0..self.curve.len()).map(pull).filter(|&pull| pull > 0.0).reduce(f64::max);
        (largest, last.filter(|_| self.rupture.is_some()))
    }

    /// The largest pulling force, the last peak, and the rupture distance.
    fn peaks(&self) -> Vec<Finding> {
        let (largest, last) = self.largest_and_last_pull();
        let attached = "the film still holds the tip";
        let last_reason = if self.rupture.is_some() { "the film hardly pulled the tip" } else { attached };
        vec![
            Finding::reached(results::LARGEST, largest, "the film never pulled the tip"),
            Finding::reached(results::LAST, last, last_reason),
            Finding::reached(results::RUPTURE, self.rupture.map(|height| height - self.from), attached),
            Finding::count(results::LEFT_ON_TIP, self.on_tip),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_has_parted_by_its_way_since_the_rupture_at_the_latest_mean() {
        let watch = |rupture, travelled: &[f64]| Watch {
            rupture,
            curve: travelled.iter().map(|&z| (z, 100.0)).collect(),
            ..Watch::default()
        };
        assert!(watch(Some(-10.0), &[0.0, 35.0, 40.0]).parted_by(50.0));
        assert!(!watch(Some(-10.0), &[45.0, 39.9]).parted_by(50.0));
        assert!(!watch(None, &[90.0]).parted_by(50.0) && !watch(Some(0.0), &[]).parted_by(0.0));
    }

    #[test]
    fn a_tip_presses_with_the_latest_mean_force() {
        let watch = Watch { curve: vec![(0.0, 9.0), (1.0, 5.0)], ..Watch::default() };
        assert!(watch.presses_with(5.0) && !watch.presses_with(5.1));
        assert!(!Watch::default().presses_with(f64::NEG_INFINITY));
    }

    #[test]
    fn the_last_peak_is_higher_than_the_mean_before_it_and_a_shoulder_is_none() {
        let last = |pulls: &[f64], rupture| {
            let curve = pulls.iter().map(|&pull| (0.0, -pull)).collect();
            Watch { curve, rupture, ..Watch::default() }.largest_and_last_pull()
        };
        let shoulder = [100.0, 300.0, 200.0, 200.0, 150.0, 40.0, 45.0];
        assert_eq!(last(&shoulder, Some(1.0)), (Some(300.0), Some(300.0)));
        assert_eq!(last(&shoulder, None), (Some(300.0), None));
        assert_eq!(last(&[100.0, 300.0, 200.0, 210.0, 150.0], Some(1.0)), (Some(300.0), Some(210.0)));
        assert_eq!(last(&[300.0, 200.0, 40.0], Some(1.0)), (Some(300.0), Some(300.0)));
        assert_eq!(last(&[-9.0, 49.0], Some(1.0)), (Some(49.0), None));
        assert_eq!(last(&[-9.0, -8.0], Some(1.0)), (None, None));
    }
}
