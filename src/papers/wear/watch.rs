//! The measurements of each stage, row by row, and its findings.

mod junction;
mod sliding;

use super::case::Case;
use super::columns::results;
use super::derived::material;
use super::protocol::{Setup, Stage};
use crate::case::units::rounded;
use crate::observe::patch::{Elasticity, Gauge};
use crate::observe::{Link, links, packing};
use crate::output::frames::THIRD_BODY;
use crate::output::{Cell, Column, Finding};
use crate::simulation::Simulation;
use crate::spec::PairModel;
use crate::system::System;
use junction::Sheared;
use serde::{Deserialize, Serialize};
use sliding::Sliding;

/// The observer of a stage.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Watch {
    /// Relaxation of a sample.
    Relaxation,
    /// A mechanical test between two walls.
    Test(Test),
    /// Shearing of a junction.
    Junction(Sheared),
    /// Long sliding of two bodies.
    Sliding(Sliding),
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

impl Watch {
    /// Starts observing a stage.
    pub fn begin(stage: &Stage, case: &Case, simulation: &Simulation<impl PairModel>) -> Self {
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
            Setup::Junction(junction) => Self::Junction(Sheared::begin(system, junction.height)),
            Setup::Bodies(_) => Self::Sliding(Sliding::begin(system, case)),
        }
    }

    /// Observes a step.
    pub fn follow(&mut self, simulation: &Simulation<impl PairModel>) {
        match self {
            Self::Relaxation => {}
            Self::Test(test) if simulation.system().step.is_multiple_of(MEASURED) => test.follow(simulation),
            Self::Test(_) => {}
            Self::Junction(sheared) => sheared.follow(simulation),
            Self::Sliding(sliding) => sliding.follow(simulation.system()),
        }
    }

    /// Whether it can be the observer of a stage that was set up like this.
    pub fn belongs_to(&self, setup: &Setup, system: &System) -> bool {
        let spheres = system.particles.len();
        match (self, setup) {
            (Self::Relaxation, Setup::None) => true,
            (Self::Test(test), Setup::Walls { .. }) => test.gauge.spheres() == spheres,
            (Self::Junction(sheared), Setup::Junction(_)) => sheared.spheres() == spheres,
            (Self::Sliding(sliding), Setup::Bodies(_)) => sliding.spheres() == spheres,
            _ => false,
        }
    }

    /// Measures a row: the cells of the columns of the stage.
    pub fn look(&self, simulation: &Simulation<impl PairModel>) -> Vec<Cell> {
        match self {
            Self::Relaxation => vec![Cell::Number(packing::volume_fraction(simulation.system()))],
            Self::Test(watch) => watch.look(simulation, &links(simulation)),
            Self::Junction(watch) => watch.look(simulation),
            Self::Sliding(watch) => watch.look(simulation.system()),
        }
    }

    /// The cells of a window that has closed in this step.
    pub fn window(&self) -> Option<Vec<Cell>> {
        match self {
            Self::Junction(sheared) => sheared.window(),
            Self::Sliding(sliding) => sliding.window(),
            _ => None,
        }
    }

    /// The cells of the layers of a profile that is due after this step.
    pub fn profile(&self) -> Vec<Vec<Cell>> {
        if let Self::Sliding(sliding) = self { sliding.profile() } else { Vec::new() }
    }

    /// The third body in the last window.
    pub fn flags(&self, system: &System) -> Vec<(&'static str, Vec<bool>)> {
        let members = match self {
            Self::Junction(sheared) => sheared.members(),
            Self::Sliding(sliding) => sliding.members(),
            _ => return Vec::new(),
        };
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
            Self::Junction(sheared) => sheared.findings(material(case).density.value, simulation.system()),
            Self::Sliding(sliding) => sliding.findings(case, simulation.system()),
        }
    }
}

/// Whether the stress has fallen below its peak for good.
fn has_passed(stress: f64, peak: [f64; 2]) -> bool {
    stress < PASSED * peak[1]
}

/// Whether a sample has failed: its strain exceeds the strain at the peak by half, and its stress is below half the peak.
fn has_failed([strain, stress]: [f64; 2], peak: [f64; 2]) -> bool {
    strain > 0.01 && strain > 1.5 * peak[0] && stress < 0.5 * peak[1]
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
        self.passed |= has_passed(stress, self.peak);
        if !simulation.system().step.is_multiple_of(JUDGED) {
            return;
        }
        self.failed = self.kind != Kind::Compression && has_failed([strain, stress], self.peak);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_fails_beyond_its_peak_with_little_stress_left() {
        let peak = [0.02, 100.0];
        assert!(has_failed([0.031, 49.0], peak));
        for held in [[0.029, 49.0], [0.031, 51.0]] {
            assert!(!has_failed(held, peak), "{held:?}");
        }
        assert!([10.0, 100.0].map(|stress| has_passed(0.89 * stress, [0.02, stress])) == [true; 2]);
        assert!([10.0, 100.0].map(|stress| has_passed(0.91 * stress, [0.02, stress])) == [false; 2]);
        // Noise at the start is no peak.
        assert!(!has_failed([0.009, 0.1], [0.001, 1.0]) && has_failed([0.011, 0.1], [0.001, 1.0]));
    }
}
