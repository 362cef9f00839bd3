//! The measurements of a junction under shear.

use crate::case::units::in_unit;
use crate::observe::statistics::standard_error;
use crate::observe::{links, upper_wall};
use crate::output::{Cell, Column, Finding};
use crate::papers::wear::columns::results;
use crate::papers::wear::fate::{Fate, Row, WINDOW, Witness};
use crate::simulation::Simulation;
use crate::spec::{PairModel, Vec3};
use crate::system::System;
use serde::{Deserialize, Serialize};

/// A junction under shear.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Sheared {
    witness: Witness,
    height: f64,
    start: [f64; 3],
    /// Sliding distance at which the next window closes, nm.
    next: f64,
    /// Whether a window has closed in the last step.
    closed: bool,
}

impl Sheared {
    /// Starts observing a junction of this height, nm.
    pub(super) fn begin(system: &System, height: f64) -> Self {
        Self { witness: Witness::new(system, height), height, start: upper_wall(system).0, next: WINDOW, closed: false }
    }

    /// Number of spheres that it observes.
    pub(super) fn spheres(&self) -> usize {
        self.witness.spheres()
    }

    /// Ids of the third body in the last window, in ascending order.
    pub(super) fn members(&self) -> &[u32] {
        self.witness.members()
    }

    pub(super) fn follow(&mut self, simulation: &Simulation<impl PairModel>) {
        let system = simulation.system();
        self.witness.follow(system);
        self.closed = (upper_wall(system).0[0] - self.start[0]).abs() >= self.next;
        if self.closed {
            self.next += WINDOW;
            self.witness.look(system, &links(simulation));
        }
    }

    pub(super) fn look(&self, simulation: &Simulation<impl PairModel>) -> Vec<Cell> {
        let system = simulation.system();
        let now = upper_wall(system).0;
        let (slid, separation) = (now[0] - self.start[0], self.height + now[1] - self.start[1]);
        let wall = system.walls[1].force.0;
        [slid, separation, 0.0 - wall[0], wall[1]].map(Cell::Number).into()
    }

    pub(super) fn window(&self) -> Option<Vec<Cell>> {
        let row = self.witness.rows.last().filter(|_| self.closed)?;
        let mut cells: Vec<Cell> = [row.slid, row.separation, row.friction, row.normal].map(Cell::Number).into();
        cells.extend([row.third_size, row.third_from_junction].map(|n| Cell::Count(n as u64)));
        cells.extend([row.third_mass, row.third_height, row.turns, row.rigidity].map(Cell::Number));
        cells.extend([row.links_to_bottom, row.links_to_top, row.links_direct].map(|n| Cell::Count(n as u64)));
        Some(cells)
    }

    pub(super) fn findings(&self, density: f64, system: &System) -> Vec<Finding> {
        let fate = match self.witness.fate() {
            Fate::Flattened => "squeezed flat",
            Fate::Rolls => "detached and rolling",
            Fate::Cut => "cut",
            Fate::Attached => "still attached",
        };
        let rows = &self.witness.rows;
        let short = format!("slid by less than {}", in_unit(2.0 * WINDOW, "nm"));
        let last = rows.last();
        let [slid, risen, _] = (upper_wall(system) - Vec3(self.start)).0;
        let [friction, load] = self.witness.mean_forces();
        let peak = rows.iter().map(|row| row.friction / load).reduce(f64::max);
        // A sliding junction is judged by the second half of its way: the first has the static peak in it.
        let late: Vec<&Row> = rows.iter().filter(|row| row.slid > 0.5 * slid).collect();
        let over = |result: Column, value: &dyn Fn(&Row) -> f64, why: &str| {
            let values: Vec<f64> = late.iter().map(|row| value(row)).collect();
            if values.len() < 2 || !why.is_empty() {
                return Finding::reached(result, None, if why.is_empty() { &*short } else { why });
            }
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            Finding::number(result, mean).spread(standard_error(&values, mean))
        };
        let none = if late.iter().any(|row| row.third_size > 0) { "" } else { "no third body in the second half" };
        vec![
            Finding::words(results::FATE, last.map_or(&*short, |_| fate)),
            Finding::number(results::SLIDING_DISTANCE, slid),
            Finding::number(results::SEPARATION, self.height + risen),
            Finding::number(results::FRICTION_FORCE, friction),
            Finding::reached(results::PEAK_FRICTION, peak, &*short),
            over(results::KINETIC_FRICTION, &|row| row.friction / load, ""),
            over(results::WEAR_VOLUME, &|row| row.third_mass / density, none),
            over(results::WEAR_RATE, &|row| row.third_mass / density / row.slid, none),
            over(results::THIRD_BODY, &|row| row.third_size as f64, none),
            Finding::reached(results::TURNS, last.map(|row| row.turns), &*short),
            over(results::RIGIDITY, &|row| row.rigidity, none),
        ]
    }
}
