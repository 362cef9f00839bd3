//! The measurements of each stage, row by row, and its findings.

use super::case::Case;
use super::columns::results;
use super::derived::material;
use super::fate::{Fate, Row, WINDOW, Witness};
use super::protocol::{Setup, Stage};
use crate::case::units::{in_unit, rounded};
use crate::observe::patch::{Elasticity, Gauge};
use crate::observe::statistics::standard_error;
use crate::observe::{Link, links, packing, upper_wall};
use crate::output::frames::THIRD_BODY;
use crate::output::{Cell, Column, Finding};
use crate::simulation::Simulation;
use crate::spec::PairModel;
use crate::spec::Vec3;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// The observer of a stage.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Watch {
    /// Relaxation of a sample.
    Relaxation,
    /// A mechanical test between two walls.
    Test(Test),
    /// Shearing of a junction.
    Junction(Sheared),
}

/// Intervals, in steps, at which a test between two walls is measured and at which it is asked for its end, whatever is written.
const MEASURED: u64 = 20;
const JUDGED: u64 = 100;
/// A peak has been passed once the stress has fallen below this fraction of it.
const PASSED: f64 = 0.9;

/// A test between two walls: strain and stress, and the peak stress.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Test {
    kind: Kind,
    gauge: Gauge,
    /// Strain and stress at the peak.
    peak: [f64; 2],
    /// Whether the stress has fallen since.
    passed: bool,
    failed: bool,
    /// Strain at the last measurement.
    strain: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Kind {
    Compression,
    Tension,
    Shear,
}

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

impl Watch {
    /// Starts observing a stage.
    pub fn begin(stage: &Stage, simulation: &Simulation<impl PairModel>) -> Self {
        let system = simulation.system();
        match &stage.setup {
            Setup::None => Self::Relaxation,
            Setup::Walls { thickness, .. } => {
                let kind = match stage.name {
                    "compression" => Kind::Compression,
                    "tension" => Kind::Tension,
                    _ => Kind::Shear,
                };
                let gauge = Gauge::new(system, &links(simulation), *thickness);
                Self::Test(Test { kind, gauge, peak: [0.0; 2], passed: false, failed: false, strain: 0.0 })
            }
            Setup::Junction(junction) => Self::Junction(Sheared {
                witness: Witness::new(system, junction.height),
                height: junction.height,
                start: upper_wall(system).0,
                next: WINDOW,
                closed: false,
            }),
        }
    }

    /// Observes a step.
    pub fn follow(&mut self, simulation: &Simulation<impl PairModel>) {
        match self {
            Self::Relaxation => {}
            Self::Test(test) if simulation.system().step.is_multiple_of(MEASURED) => test.follow(simulation),
            Self::Test(_) => {}
            Self::Junction(sheared) => sheared.follow(simulation),
        }
    }

    /// Whether it can be the observer of a stage that was set up like this.
    pub fn belongs_to(&self, setup: &Setup, system: &System) -> bool {
        let spheres = system.particles.len();
        match (self, setup) {
            (Self::Relaxation, Setup::None) => true,
            (Self::Test(test), Setup::Walls { .. }) => test.gauge.spheres() == spheres,
            (Self::Junction(sheared), Setup::Junction(_)) => sheared.witness.spheres() == spheres,
            _ => false,
        }
    }

    /// Measures a row: the cells of the columns of the stage.
    pub fn look(&self, simulation: &Simulation<impl PairModel>) -> Vec<Cell> {
        match self {
            Self::Relaxation => vec![Cell::Number(packing::volume_fraction(simulation.system()))],
            Self::Test(watch) => watch.look(simulation, &links(simulation)),
            Self::Junction(watch) => watch.look(simulation),
        }
    }

    /// The cells of a window that has closed in this step.
    pub fn window(&self) -> Option<Vec<Cell>> {
        if let Self::Junction(sheared) = self { sheared.window() } else { None }
    }

    /// The third body in the last window.
    pub fn flags(&self, system: &System) -> Vec<(&'static str, Vec<bool>)> {
        let Self::Junction(sheared) = self else { return Vec::new() };
        let members = sheared.witness.members();
        vec![(THIRD_BODY.name, system.particles.id.iter().map(|id| members.binary_search(id).is_ok()).collect())]
    }

    /// Whether the stage may end early.
    pub fn ended(&self) -> bool {
        matches!(self, Self::Test(Test { failed: true, .. }))
    }

    /// The findings of the stage.
    pub fn findings(&self, stage: &Stage, case: &Case, simulation: &Simulation<impl PairModel>) -> Vec<Finding> {
        match self {
            Self::Relaxation => {
                vec![
                    Finding::number(results::VOLUME_FRACTION, packing::volume_fraction(simulation.system()))
                        .during(stage.name),
                ]
            }
            Self::Test(test) => test.findings(case, simulation),
            Self::Junction(sheared) => sheared.findings(material(case).density.value, simulation),
        }
    }
}

impl Test {
    /// The strain and the stress of the test, and all cells but the peak.
    fn read(&self, simulation: &Simulation<impl PairModel>, links: &[Link]) -> ([f64; 2], [f64; 5]) {
        let reading = self.gauge.read(simulation.system(), links);
        let (normal, shear) = (reading.stress[1].0[1], reading.stress[0].0[1]);
        let [sheared, stretched, _] = reading.strain.0;
        let own = if self.kind == Kind::Shear { [sheared, shear] } else { [stretched, normal] };
        (own, [stretched, sheared, normal, reading.stress[0].0[0], shear])
    }

    fn follow(&mut self, simulation: &Simulation<impl PairModel>) {
        let ([strain, stress], _) = self.read(simulation, &links(simulation));
        self.strain = strain;
        if stress > self.peak[1] {
            (self.peak, self.passed) = ([strain, stress], false);
        }
        self.passed |= stress < PASSED * self.peak[1];
        if !simulation.system().step.is_multiple_of(JUDGED) {
            return;
        }
        // Failure: the strain exceeds the strain at the peak by half, and the stress is below half the peak.
        self.failed = self.kind != Kind::Compression
            && strain > 0.01
            && strain > 1.5 * self.peak[0]
            && stress < 0.5 * self.peak[1];
    }

    fn look(&self, simulation: &Simulation<impl PairModel>, links: &[Link]) -> Vec<Cell> {
        let ([_, stress], cells) = self.read(simulation, links);
        cells.into_iter().chain([stress.max(self.peak[1])]).map(Cell::Number).collect()
    }

    fn findings(&self, case: &Case, simulation: &Simulation<impl PairModel>) -> Vec<Finding> {
        let material = material(case);
        match self.kind {
            Kind::Compression => {
                let elasticity = self.gauge.elasticity(simulation.system(), &links(simulation));
                let of = |result, value: fn(&Elasticity) -> f64| {
                    Finding::reached(result, elasticity.as_ref().map(value), "the sample did not keep its shape")
                };
                vec![
                    of(results::YOUNG_MODULUS, |e| e.young_modulus).target(material.young_modulus.value),
                    of(results::POISSON_RATIO, |e| e.poisson_ratio).target(material.poisson_ratio),
                    of(results::C_11, |e| e.c_11),
                    of(results::C_12, |e| e.c_12),
                ]
            }
            Kind::Tension => self.strength(
                [results::TENSILE_STRENGTH, results::TENSILE_STRAIN, results::LARGEST_TENSION],
                material.tensile_strength.value,
            ),
            Kind::Shear => self.strength(
                [results::SHEAR_STRENGTH, results::SHEAR_STRAIN, results::LARGEST_SHEAR],
                material.shear_strength.value,
            ),
        }
    }

    /// The peak of the stress, which is the strength only once the stress has fallen.
    fn strength(&self, [strength, at, largest]: [Column; 3], target: f64) -> Vec<Finding> {
        let [strain, stress] = self.peak;
        let peak = |value: f64| self.passed.then_some(value);
        let rising = format!("not reached by a strain of {}", rounded(self.strain));
        vec![
            Finding::reached(strength, peak(stress), &*rising).target(target),
            Finding::reached(at, peak(strain), &*rising),
            Finding::number(largest, stress),
        ]
    }
}

impl Sheared {
    fn follow(&mut self, simulation: &Simulation<impl PairModel>) {
        let system = simulation.system();
        self.witness.follow(system);
        self.closed = (upper_wall(system).0[0] - self.start[0]).abs() >= self.next;
        if self.closed {
            self.next += WINDOW;
            self.witness.look(system, &links(simulation));
        }
    }

    fn look(&self, simulation: &Simulation<impl PairModel>) -> Vec<Cell> {
        let system = simulation.system();
        let now = upper_wall(system).0;
        let (slid, separation) = (now[0] - self.start[0], self.height + now[1] - self.start[1]);
        let wall = system.walls[1].force.0;
        [slid, separation, 0.0 - wall[0], wall[1]].map(Cell::Number).into()
    }

    fn window(&self) -> Option<Vec<Cell>> {
        let row = self.witness.rows.last().filter(|_| self.closed)?;
        let mut cells: Vec<Cell> = [row.slid, row.separation, row.friction, row.normal].map(Cell::Number).into();
        cells.extend([row.third_size, row.third_from_junction].map(|n| Cell::Count(n as u64)));
        cells.extend([row.third_mass, row.third_height, row.turns, row.rigidity].map(Cell::Number));
        cells.extend([row.links_to_bottom, row.links_to_top, row.links_direct].map(|n| Cell::Count(n as u64)));
        Some(cells)
    }

    fn findings(&self, density: f64, simulation: &Simulation<impl PairModel>) -> Vec<Finding> {
        let fate = match self.witness.fate() {
            Fate::Flattened => "squeezed flat",
            Fate::Rolls => "detached and rolling",
            Fate::Cut => "cut",
            Fate::Attached => "still attached",
        };
        let rows = &self.witness.rows;
        let short = format!("slid by less than {}", in_unit(2.0 * WINDOW, "nm"));
        let last = rows.last();
        let [slid, risen, _] = (upper_wall(simulation.system()) - Vec3(self.start)).0;
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
