//! The measurements of the stages of soot, and their findings.

use super::case::SootStage;
use super::columns::results;
use super::strengths::Strengths;
use crate::error::Error;
use crate::geometry::{SphereExtent, gyration_radius};
use crate::initial::aggregate::NEIGHBOURLY;
use crate::interrupt::Interrupt;
use crate::observe::aggregate::AggregateShape;
use crate::observe::force_curve::ForceCurve;
use crate::observe::morphology::{convexity, coordination_number};
use crate::output::{Cell, Finding};
use crate::simulation::Simulation;
use crate::spec::Vec3;
use crate::spec::soot::{Reading, Soot};
use crate::spec::soot::{SUBSTRATE, TIP};
use crate::system::{Forces, Particles, Surface, System};
use serde::{Deserialize, Serialize};

/// The coordination number, the convexity and the radius of gyration of an aggregate.
pub fn shape(system: &System) -> [f64; 3] {
    let spheres = system.particles.spheres();
    [coordination_number(&spheres), convexity(&spheres).value, gyration_radius(&spheres, SphereExtent::Centres)]
}

/// Interval between the points of a force curve, ns.
const RECORDED: f64 = 0.1;

/// The initial state of a stage, the strengths of its necks, and the force curve of an indentation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Watch {
    shape: AggregateShape,
    kinetic: f64,
    curve: Option<ForceCurve>,
    strengths: Strengths,
}

impl Watch {
    /// Starts observing a stage.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn begin(
        stage: &SootStage,
        simulation: &Simulation<Soot<impl Reading>>,
        strengths: Strengths,
        interrupt: &Interrupt,
    ) -> Result<Self, Error> {
        let curve = match stage {
            SootStage::Indentation(test) => Some(ForceCurve::new(2.0 * std::f64::consts::PI * test.cantilever.value)),
            _ => None,
        };
        let shape = AggregateShape::of(&simulation.system().particles.spheres(), interrupt)?;
        Ok(Self { shape, kinetic: simulation.ledger().kinetic, curve, strengths })
    }

    /// Whether it can be the observer of this stage.
    pub fn belongs_to(&self, stage: &SootStage, system: &System) -> bool {
        let indents = matches!(stage, SootStage::Indentation(_));
        self.curve.is_some() == indents && surface(system, TIP).is_some() == indents
    }

    /// Observes every step.
    pub fn follow(&mut self, simulation: &Simulation<Soot<impl Reading>>) {
        if let (Some(curve), Some(tip)) = (&mut self.curve, surface(simulation.system(), TIP)) {
            let dt = simulation.settings().dt;
            curve.follow(-tip.force.total().0[2], dt);
            if simulation.system().step.is_multiple_of(((RECORDED / dt).round() as u64).max(1)) {
                curve.look(tip.way.0[2]);
            }
        }
    }

    /// The cells of a row.
    pub fn look(&mut self, simulation: &Simulation<Soot<impl Reading>>) -> Vec<Cell> {
        let system = simulation.system();
        let ledger = simulation.ledger();
        let account = ledger.surfaces;
        let mut cells: Vec<Cell> = shape(system).into_iter().chain([height(system)]).map(Cell::Number).collect();
        cells.push(Cell::Count(system.necks.len() as u64));
        let energies = [account.work, account.stored.iter().sum(), account.lost.iter().sum()];
        cells.extend(energies.map(Cell::Number));
        if let Some(substrate) = surface(system, SUBSTRATE) {
            cells.push(Cell::Count(spheres_on(&system.particles, substrate)));
            // The friction of a level substrate has no vertical part.
            let Forces { contact, friction, van_der_waals } = substrate.force;
            cells.extend([contact.0[2], friction.norm(), van_der_waals.0[2]].map(Cell::Number));
        }
        if let (Some(tip), Some(curve)) = (surface(system, TIP), &self.curve) {
            cells.extend([Cell::Number(tip.way.0[2]), Cell::Count(spheres_on(&system.particles, tip))]);
            let Forces { contact, friction, van_der_waals } = tip.force;
            cells.extend([contact, friction, van_der_waals].map(|force| Cell::Number(force.0[2])));
            cells.extend([-tip.force.total().0[2], curve.reading()].map(Cell::Number));
        }
        cells
    }

    /// The force curve of an indentation.
    pub fn curve(&self) -> Option<&ForceCurve> {
        self.curve.as_ref()
    }

    /// The strengths of the necks relative to that of the case.
    pub fn strengths(&self) -> &Strengths {
        &self.strengths
    }

    /// The initial kinetic energy, zJ.
    pub fn kinetic(&self) -> f64 {
        self.kinetic
    }

    /// The findings of the stage.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn findings(
        &self,
        stage: &SootStage,
        simulation: &Simulation<Soot<impl Reading>>,
        interrupt: &Interrupt,
    ) -> Result<Vec<Finding>, Error> {
        let system = simulation.system();
        let last = AggregateShape::of(&system.particles.spheres(), interrupt)?;
        let mut findings = match stage {
            SootStage::Deposition(_) => {
                let Deposit { spheres, kinetic, dissipated, rests } = self.deposit(simulation);
                let verdict = match (rests, spheres) {
                    (_, 0) => "does not adhere",
                    (false, _) => "has not come to rest",
                    (true, 1) => "rests on one sphere",
                    (true, _) => "adheres",
                };
                let left = (self.kinetic > 0.0).then(|| 100.0 * kinetic / self.kinetic);
                let left = left.map_or(String::new(), |left| format!("; {left:.2} % of its kinetic energy remains"));
                vec![
                    Finding::words(results::END, format!("the aggregate {verdict}{left}")),
                    Finding::count(results::ON_SUBSTRATE, spheres),
                    Finding::number(results::INITIAL_KINETIC, self.kinetic),
                    Finding::number(results::FINAL_KINETIC, kinetic),
                    Finding::number(results::DISSIPATED, dissipated),
                ]
            }
            SootStage::Indentation(_) => {
                let curve = self.curve.as_ref().expect("an indentation has a force curve");
                let highest = Some(curve.highest()).filter(|&highest| highest > 0.0);
                let end = match curve.rupture() {
                    Some(displacement) => {
                        format!("is free, or has torn off a fragment, {displacement:.0} nm above its initial position")
                    }
                    None if highest.is_none() => "was not pulled after its reversal".into(),
                    None => "is still attached to the aggregate".into(),
                };
                let strongest = |force: Option<f64>| Finding::reached(results::HIGHEST_PEAK, force, "none").sentence();
                let sentence = format!(
                    "the tip {end}; its largest pulling force: {}, filtered by the cantilever and after the reversal: {}",
                    strongest(curve.largest()),
                    strongest(highest),
                );
                vec![
                    Finding::words(results::END, sentence),
                    Finding::reached(results::LARGEST_PULL, curve.largest(), "the tip was never pulled"),
                    Finding::count(results::PEAKS, curve.peaks().len() as u64),
                    Finding::reached(results::HIGHEST_PEAK, highest, "the tip was not pulled after its reversal"),
                    Finding::reached(results::RUPTURE_HEIGHT, curve.rupture(), format!("the tip {end}")),
                ]
            }
            SootStage::Restructuring(_) => {
                let (first, [coordination, _, gyration]) = (&self.shape, shape(system));
                let compacts = coordination > first.coordination && gyration < first.gyration_radius;
                let sentence = format!(
                    "the aggregate {}: coordination number {:.2} -> {coordination:.2}, radius of gyration {:.0} -> {gyration:.0} nm",
                    if compacts { "compacts" } else { "does not compact" },
                    first.coordination,
                    first.gyration_radius,
                );
                vec![Finding::words(results::END, sentence)]
            }
        };
        findings.push(Finding::count(results::NECKS, system.necks.len() as u64));
        for (when, shape) in [("initial", &self.shape), ("final", &last)] {
            findings.extend(shape.findings().into_iter().map(|finding| finding.at(when)));
        }
        Ok(findings)
    }

    /// The outcome of a deposition.
    pub fn deposit(&self, simulation: &Simulation<Soot<impl Reading>>) -> Deposit {
        let ledger = simulation.ledger();
        let system = simulation.system();
        let spheres = surface(system, SUBSTRATE).map_or(0, |substrate| spheres_on(&system.particles, substrate));
        let rests = ledger.kinetic < RESTING * self.kinetic;
        Deposit { spheres, kinetic: ledger.kinetic, dissipated: ledger.lost(), rests }
    }
}

/// Fraction of the initial kinetic energy below which an aggregate has come to rest: with a hundredth it may still rotate about its first contact for
/// tens of nanoseconds.
const RESTING: f64 = 1e-3;

/// What became of a deposition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deposit {
    /// Number of spheres on the substrate.
    pub spheres: u64,
    /// Final kinetic energy, zJ.
    pub kinetic: f64,
    /// Energy dissipated, zJ.
    pub dissipated: f64,
    /// Whether the aggregate has come to rest.
    pub rests: bool,
}

/// The substrate or the tip.
pub fn surface(system: &System, material: usize) -> Option<&Surface> {
    system.surfaces.iter().find(|surface| surface.material == material)
}

/// Number of spheres on a surface, by the distance criterion of Eq. 26, so that a sphere bouncing by a hundredth of a nanometre counts.
fn spheres_on(Particles { x, radius, .. }: &Particles, surface: &Surface) -> u64 {
    let mut seen = Vec::new();
    let near = |p: usize| {
        seen.clear();
        surface.distance_minima(x[p], (1.0 + 2.0 * NEIGHBOURLY) * radius[p], &mut seen);
        !seen.is_empty()
    };
    (0..x.len()).map(near).filter(|near| *near).count() as u64
}

/// Height of the centre of mass, nm.
pub fn height(system: &System) -> f64 {
    let Particles { x, mass, .. } = &system.particles;
    let moment = x.iter().zip(mass).fold(Vec3::zero(), |sum, (x, m)| sum + *x * *m);
    moment.0[2] / mass.iter().sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{PrescribedMotion, Shape};

    #[test]
    fn a_sphere_lies_on_a_plane_up_to_a_gap_of_a_hundredth_of_its_diameter() {
        let shape = Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) };
        let plane = Surface::new("substrate", SUBSTRATE, shape, PrescribedMotion::Still);
        let mut particles = Particles::default();
        [13.9, 14.0, 14.27, 14.29].into_iter().for_each(|z| particles.push(Vec3([0.0, 0.0, z]), 14.0, 1.0, 0));
        assert_eq!(spheres_on(&particles, &plane), 3);
    }
}
