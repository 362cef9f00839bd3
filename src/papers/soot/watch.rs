//! What is followed in the stages of soot.

use super::case::SootStage;
use crate::geometry::Sphere;
use crate::geometry::{Extent, gyration_radius};
use crate::initial::aggregate::NEIGHBOURLY;
use crate::observe::force_curve::ForceCurve;
use crate::observe::morphology::{convexity, coordination_number};
use crate::output::{Cell, Finding};
use crate::simulation::Simulation;
use crate::spec::Vec3;
use crate::spec::soot::{Reading, Soot};
use crate::spec::soot::{SUBSTRATE, TIP};
use crate::system::{Forces, Particles, Surface, System};
use serde::{Deserialize, Serialize};

/// The columns of the series.
pub mod columns {
    use crate::output::Column;
    use crate::output::columns::{AT_SURFACES, LOST_AT_SURFACES};

    /// Mean coordination number.
    pub const COORDINATION: Column = Column::pure("coordination number");
    /// Volume over volume of the convex hull.
    pub const CONVEXITY: Column = Column::pure("convexity");
    /// Gyration radius of the centres.
    pub const GYRATION_RADIUS: Column = Column::new("gyration radius", "nm");
    /// Height of the centre of mass.
    pub const HEIGHT: Column = Column::new("height", "nm");
    /// Displacement of the tip.
    pub const TIP_DISPLACEMENT: Column = Column::new("tip displacement", "nm");
    /// Force of the aggregate on the tip, downwards.
    pub const PULL: Column = Column::new("pull on the tip", "pN");
    /// The same as the cantilever reads it.
    pub const READING: Column = Column::new("cantilever reading", "pN");

    /// All of them.
    pub const ALL: [Column; 19] = [
        COORDINATION,
        CONVEXITY,
        GYRATION_RADIUS,
        HEIGHT,
        Column::pure("necks"),
        AT_SURFACES,
        LOST_AT_SURFACES,
        Column::new("work of surfaces", "zJ"),
        Column::pure("spheres on the substrate"),
        Column::new("contact on the substrate", "pN"),
        Column::new("friction on the substrate", "pN"),
        Column::new("van der Waals on the substrate", "pN"),
        TIP_DISPLACEMENT,
        Column::pure("spheres on the tip"),
        Column::new("contact on the tip", "pN"),
        Column::new("friction on the tip", "pN"),
        Column::new("van der Waals on the tip", "pN"),
        PULL,
        READING,
    ];
}

/// What of an aggregate's shape is followed: coordination number, convexity, gyration radius.
pub type Shape = [f64; 3];

/// The shape of an aggregate.
pub fn shape(system: &System) -> Shape {
    let Particles { x, radius, .. } = &system.particles;
    let spheres: Vec<Sphere> = x.iter().zip(radius).map(|(&centre, &radius)| Sphere { centre, radius }).collect();
    [coordination_number(&spheres), convexity(&spheres).value, gyration_radius(&spheres, Extent::Centres)]
}

/// What is remembered of the beginning of a stage, and the force curve of an indentation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Watch {
    shape: Shape,
    kinetic: f64,
    curve: Option<ForceCurve>,
}

impl Watch {
    /// Begins to watch a stage.
    pub fn begin(stage: &SootStage, simulation: &Simulation<Soot<impl Reading>>) -> Self {
        let curve = match stage {
            SootStage::Indentation(test) => Some(ForceCurve::new(2.0 * std::f64::consts::PI * test.cantilever.value)),
            _ => None,
        };
        Self { shape: shape(simulation.system()), kinetic: simulation.ledger().kinetic, curve }
    }

    /// Sees every step.
    pub fn follow(&mut self, simulation: &Simulation<Soot<impl Reading>>) {
        if let (Some(curve), Some(tip)) = (&mut self.curve, surface(simulation.system(), TIP)) {
            curve.follow(-tip.force.total().0[2], simulation.settings().dt);
        }
    }

    /// The cells of a row.
    pub fn look(&mut self, simulation: &Simulation<Soot<impl Reading>>) -> Vec<Cell> {
        let system = simulation.system();
        let ledger = simulation.ledger();
        let account = ledger.surfaces;
        let mut cells: Vec<Cell> = shape(system).into_iter().chain([height(system)]).map(Cell::Number).collect();
        cells.push(Cell::Count(system.necks.len() as u64));
        let energies = [account.stored.iter().sum(), account.lost.iter().sum(), account.work];
        cells.extend(energies.map(Cell::Number));
        match surface(system, SUBSTRATE) {
            Some(substrate) => {
                cells.push(Cell::Count(spheres_on(&system.particles, substrate)));
                // The friction of a level substrate has no vertical part.
                let Forces { contact, friction, van_der_waals } = substrate.force;
                cells.extend([contact.0[2], friction.norm(), van_der_waals.0[2]].map(Cell::Number));
            }
            None => cells.extend(vec![Cell::Nothing; 4]),
        }
        self.keep(simulation);
        match (surface(system, TIP), &self.curve) {
            (Some(tip), Some(curve)) => {
                cells.extend([Cell::Number(tip.way.0[2]), Cell::Count(spheres_on(&system.particles, tip))]);
                let Forces { contact, friction, van_der_waals } = tip.force;
                cells.extend([contact, friction, van_der_waals].map(|force| Cell::Number(force.0[2])));
                cells.extend([-tip.force.total().0[2], curve.reading()].map(Cell::Number));
            }
            _ => cells.extend(vec![Cell::Nothing; 7]),
        }
        cells
    }

    /// The force curve of an indentation.
    pub fn curve(&self) -> Option<&ForceCurve> {
        self.curve.as_ref()
    }

    /// The kinetic energy at the beginning, zJ.
    pub fn kinetic(&self) -> f64 {
        self.kinetic
    }

    /// Keeps the point of the force curve that has been reached.
    pub fn keep(&mut self, simulation: &Simulation<Soot<impl Reading>>) {
        if let (Some(curve), Some(tip)) = (&mut self.curve, surface(simulation.system(), TIP)) {
            curve.look(tip.way.0[2]);
        }
    }

    /// What the stage amounts to.
    pub fn findings(&self, stage: &SootStage, simulation: &Simulation<Soot<impl Reading>>) -> Vec<Finding> {
        let system = simulation.system();
        let number = |name: &str, value: f64, unit: &str| Finding::number(name, value, unit, None);
        let mut findings = match stage {
            SootStage::Deposition(_) => {
                let Deposit { spheres, kinetic, dissipated, rests } = self.deposit(simulation);
                let verdict = match (rests, spheres) {
                    (_, 0) => "does not adhere",
                    (false, _) => "has not come to rest",
                    (true, 1) => "stands on one sphere",
                    (true, _) => "adheres",
                };
                let sentence = format!(
                    "the aggregate {verdict}, with {:.2} % of its kinetic energy left",
                    100.0 * kinetic / self.kinetic
                );
                vec![
                    Finding::words("end", sentence),
                    number("spheres on the substrate", spheres as f64, ""),
                    number("kinetic energy at first", self.kinetic, "zJ"),
                    number("kinetic energy at last", kinetic, "zJ"),
                    number("energy dissipated", dissipated, "zJ"),
                ]
            }
            SootStage::Indentation(_) => {
                let curve = self.curve.as_ref().expect("an indentation has a force curve");
                let (peaks, highest) = (curve.peaks().len(), curve.highest());
                let end = match curve.rupture() {
                    Some(displacement) => {
                        format!("is free, or what it holds torn off, {displacement:.0} nm above its start")
                    }
                    None => "still pulls at the aggregate".into(),
                };
                let sentence = format!("the tip {end}; it was pulled by {:.2} nN at most", 1e-3 * highest);
                let mut found = vec![
                    Finding::words("end", sentence),
                    number("peaks of the force curve", peaks as f64, ""),
                    number("highest peak", highest, "pN"),
                ];
                found.extend(curve.rupture().map(|height| number("rupture height", height, "nm")));
                found
            }
            SootStage::Restructuring(_) => {
                let (first, last) = (self.shape, shape(system));
                let verdict = if last[0] > first[0] && last[2] < first[2] { "compacts" } else { "does not compact" };
                let sentence = format!(
                    "the aggregate {verdict}: coordination number {:.2} after {:.2}, gyration radius {:.0} nm after {:.0} nm",
                    last[0], first[0], last[2], first[2]
                );
                vec![Finding::words("end", sentence)]
            }
        };
        findings.push(number("necks", system.necks.len() as f64, ""));
        for (when, [coordination, convexity, gyration]) in [("at first", self.shape), ("at last", shape(system))] {
            findings.extend([
                number(&format!("coordination number {when}"), coordination, ""),
                number(&format!("convexity {when}"), convexity, ""),
                number(&format!("gyration radius {when}"), gyration, "nm"),
            ]);
        }
        findings
    }

    /// What became of a deposition.
    pub fn deposit(&self, simulation: &Simulation<Soot<impl Reading>>) -> Deposit {
        let ledger = simulation.ledger();
        let system = simulation.system();
        let spheres = surface(system, SUBSTRATE).map_or(0, |substrate| spheres_on(&system.particles, substrate));
        let rests = ledger.kinetic < RESTING * self.kinetic;
        Deposit { spheres, kinetic: ledger.kinetic, dissipated: ledger.lost(), rests }
    }
}

/// An aggregate has come to rest when this part of its kinetic energy is left: with a hundredth it may still turn about its first contact for tens of
/// nanoseconds.
const RESTING: f64 = 1e-3;

/// What became of a deposition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deposit {
    /// Spheres that lie on the substrate.
    pub spheres: u64,
    /// Kinetic energy left, zJ.
    pub kinetic: f64,
    /// Energy turned into heat, zJ.
    pub dissipated: f64,
    /// Whether it has come to rest.
    pub rests: bool,
}

/// The substrate or the tip.
pub fn surface(system: &System, material: usize) -> Option<&Surface> {
    system.surfaces.iter().find(|surface| surface.material == material)
}

/// Spheres that lie on a surface: as near to it as a neighbour of Eq. 26, so that one that bounces by a hundredth of a nanometre counts.
fn spheres_on(Particles { x, radius, .. }: &Particles, surface: &Surface) -> u64 {
    let mut seen = Vec::new();
    let near = |p: usize| {
        seen.clear();
        surface.see(x[p], (1.0 + 2.0 * NEIGHBOURLY) * radius[p], 0.0, &mut seen);
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
    use crate::system::{Course, Shape};

    #[test]
    fn a_sphere_lies_on_a_plane_up_to_a_gap_of_a_hundredth_of_its_diameter() {
        let shape = Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) };
        let plane = Surface::new("substrate", SUBSTRATE, shape, Course::Still);
        let mut particles = Particles::default();
        [13.9, 14.0, 14.27, 14.29].into_iter().for_each(|z| particles.push(Vec3([0.0, 0.0, z]), 14.0, 1.0, 0));
        assert_eq!(spheres_on(&particles, &plane), 3);
    }
}
