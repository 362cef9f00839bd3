//! The measurements of each stage, row by row, and its findings.

use super::case::Case;
use super::derived::material;
use super::fate::{Fate, WINDOW, Witness};
use super::protocol::{Setup, Stage};
use crate::observe::patch::Gauge;
use crate::observe::{Link, links, packing, upper_wall};
use crate::output::{Cell, Finding};
use crate::simulation::Simulation;
use crate::spec::wear::Wear;
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

/// A test between two walls: strain and stress, and the peak stress.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Test {
    kind: Kind,
    gauge: Gauge,
    /// Strain and stress at the peak.
    peak: [f64; 2],
    failed: bool,
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
    window: f64,
    friction: f64,
    rows: u64,
}

/// The columns of all observers; a stage fills its own.
pub(super) mod columns {
    use crate::output::Column;

    /// Volume fraction of the spheres in the box.
    pub(crate) const VOLUME_FRACTION: Column = Column::pure("volume fraction");
    /// Strain normal to the walls.
    pub(crate) const NORMAL_STRAIN: Column = Column::pure("normal strain");
    /// Shear strain parallel to the walls.
    pub(crate) const SHEAR_STRAIN: Column = Column::pure("shear strain");
    /// Stress normal to the walls.
    pub(crate) const NORMAL_STRESS: Column = Column::new("normal stress", "MPa");
    /// Shear stress.
    pub(crate) const SHEAR_STRESS: Column = Column::new("shear stress", "MPa");
    /// Displacement of the upper wall.
    pub(crate) const SLID: Column = Column::new("slid", "nm");
    /// Distance between the bodies.
    pub(crate) const SEPARATION: Column = Column::new("separation", "nm");
    /// Friction force.
    pub(crate) const FRICTION: Column = Column::new("friction", "pN");
    /// Revolutions of the third body.
    pub(crate) const TURNS: Column = Column::pure("third body turns");

    /// Columns of a relaxation.
    pub(crate) const RELAXATION: [Column; 1] = [VOLUME_FRACTION];
    /// Columns of a test between two walls.
    pub(crate) const TEST: [Column; 6] = [
        NORMAL_STRAIN,
        SHEAR_STRAIN,
        NORMAL_STRESS,
        Column::new("lateral stress", "MPa"),
        SHEAR_STRESS,
        Column::new("peak stress", "MPa"),
    ];
    /// Columns of a sheared junction.
    pub(crate) const JUNCTION: [Column; 13] = [
        SLID,
        SEPARATION,
        FRICTION,
        Column::new("normal force", "pN"),
        Column::pure("third body size"),
        Column::pure("third body from junction"),
        Column::new("third body mass", "ag"),
        Column::new("third body height", "nm"),
        TURNS,
        Column::pure("third body rigidity"),
        Column::pure("links to bottom"),
        Column::pure("links to top"),
        Column::pure("links between bodies"),
    ];
}
use columns::{JUNCTION, RELAXATION, TEST};

impl Watch {
    /// Starts observing a stage.
    pub fn begin(stage: &Stage, case: &Case, simulation: &Simulation<Wear>) -> Self {
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
                Self::Test(Test { kind, gauge, peak: [0.0; 2], failed: false })
            }
            Setup::Junction(junction) => {
                let window = WINDOW.max(junction.velocity.abs() * case.output.series.value(simulation.settings().dt));
                Self::Junction(Sheared {
                    witness: Witness::new(system, junction.height),
                    height: junction.height,
                    start: upper_wall(system).0,
                    next: window,
                    window,
                    friction: 0.0,
                    rows: 0,
                })
            }
        }
    }

    /// Measures a row: the cells of the columns of all observers, empty for other stages.
    pub fn look(&mut self, simulation: &Simulation<Wear>) -> Vec<Cell> {
        let system = simulation.system();
        let nothing = |columns: usize| vec![Cell::Nothing; columns];
        let (mut relaxation, mut test, mut junction) =
            (nothing(RELAXATION.len()), nothing(TEST.len()), nothing(JUNCTION.len()));
        match self {
            Self::Relaxation => relaxation = vec![Cell::Number(packing::volume_fraction(system))],
            Self::Test(watch) => test = watch.look(simulation, &links(simulation)),
            Self::Junction(watch) => junction = watch.look(simulation),
        }
        [relaxation, test, junction].concat()
    }

    /// Whether the stage may end early.
    pub fn ended(&self) -> bool {
        matches!(self, Self::Test(Test { failed: true, .. }))
    }

    /// The findings of the stage.
    pub fn findings(&self, stage: &Stage, case: &Case, simulation: &Simulation<Wear>) -> Vec<Finding> {
        match self {
            Self::Relaxation => {
                let name = format!("volume fraction after {}", stage.name);
                vec![Finding::number(&name, packing::volume_fraction(simulation.system()), "", None)]
            }
            Self::Test(test) => test.findings(case, simulation),
            Self::Junction(sheared) => sheared.findings(),
        }
    }
}

impl Test {
    fn look(&mut self, simulation: &Simulation<Wear>, links: &[Link]) -> Vec<Cell> {
        let reading = self.gauge.read(simulation.system(), links);
        let (normal, shear) = (reading.stress[1].0[1], reading.stress[0].0[1]);
        let (strain, stress) = match self.kind {
            Kind::Shear => (reading.strain.0[0], shear),
            _ => (reading.strain.0[1], normal),
        };
        if stress > self.peak[1] {
            self.peak = [strain, stress];
        }
        // Failure: the strain exceeds the strain at the peak by half, and the stress is below half the peak.
        self.failed = self.kind != Kind::Compression
            && strain > 0.01
            && strain > 1.5 * self.peak[0]
            && stress < 0.5 * self.peak[1];
        let lateral = reading.stress[0].0[0];
        [reading.strain.0[1], reading.strain.0[0], normal, lateral, shear, self.peak[1]].map(Cell::Number).into()
    }

    fn findings(&self, case: &Case, simulation: &Simulation<Wear>) -> Vec<Finding> {
        let material = material(case);
        match self.kind {
            Kind::Compression => {
                let Some(elasticity) = self.gauge.elasticity(simulation.system(), &links(simulation)) else {
                    return vec![Finding::words("elasticity", "not measured: the sample did not keep its shape")];
                };
                vec![
                    Finding::number(
                        "Young's modulus",
                        elasticity.young_modulus,
                        "MPa",
                        Some(material.young_modulus.value),
                    ),
                    Finding::number("Poisson's ratio", elasticity.poisson_ratio, "", Some(material.poisson_ratio)),
                    Finding::number("stiffness C11", elasticity.c_11, "MPa", None),
                    Finding::number("stiffness C12", elasticity.c_12, "MPa", None),
                ]
            }
            Kind::Tension => {
                let target = Some(material.tensile_strength.value);
                vec![Finding::number("tensile strength", self.peak[1], "MPa", target), self.strain("tension")]
            }
            Kind::Shear => {
                let target = Some(material.shear_strength.value);
                vec![Finding::number("shear strength", self.peak[1], "MPa", target), self.strain("shear")]
            }
        }
    }

    fn strain(&self, name: &str) -> Finding {
        Finding::number(&format!("strain at the peak of {name}"), self.peak[0], "", None)
    }
}

impl Sheared {
    fn look(&mut self, simulation: &Simulation<Wear>) -> Vec<Cell> {
        let system = simulation.system();
        let now = upper_wall(system).0;
        let (slid, separation) = (now[0] - self.start[0], self.height + now[1] - self.start[1]);
        let wall = system.walls[1].force.0;
        self.friction -= wall[0];
        self.rows += 1;
        let mut cells: Vec<Cell> = [slid, separation, -wall[0], wall[1]].map(Cell::Number).into();
        if slid.abs() >= self.next {
            self.next += self.window;
            let row = self.witness.look(system, &links(simulation));
            cells.extend([Cell::Count(row.third_size as u64), Cell::Count(row.third_from_junction as u64)]);
            cells.extend([row.third_mass, row.third_height, row.turns, row.rigidity].map(Cell::Number));
            cells.extend([row.links_to_bottom, row.links_to_top, row.links_direct].map(|n| Cell::Count(n as u64)));
        }
        cells.resize(JUNCTION.len(), Cell::Nothing);
        cells
    }

    fn findings(&self) -> Vec<Finding> {
        let fate = match self.witness.fate() {
            Fate::Flattened => "squeezed flat",
            Fate::Rolls => "detached and rolling",
            Fate::Cut => "cut",
            Fate::Attached => "still attached",
        };
        let mut findings = vec![Finding::words("fate of the junction", fate)];
        if let Some(row) = self.witness.rows.last() {
            findings.extend([
                Finding::number("sliding distance", row.slid, "nm", None),
                Finding::number("distance between the bodies", row.separation, "nm", None),
                Finding::number("mean friction force", self.friction / self.rows as f64, "pN", None),
                Finding::number("particles in the third body", row.third_size as f64, "", None),
                Finding::number("turns of the third body", row.turns, "", None),
                Finding::number("rigidity of the third body's motion", row.rigidity, "", None),
            ]);
        }
        findings
    }
}
