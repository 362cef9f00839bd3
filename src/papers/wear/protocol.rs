//! The stages of a run: the relaxation of Section 3.2, the tests of Section 3, the shearing of Section 4.
//!
//! A stage defines how the system is set up, which forces act, how it is advanced and when it ends. The caller decides what is
//! observed and written.

use super::bodies::Bodies;
use super::case::{InCriticalDampings, InCriticalSteps};
use super::junction::Junction;
use crate::case::InSteps;
use crate::error::Error;
use crate::initial::set_system_density;
use crate::interrupt::Interrupt;
use crate::motion::BoxRelaxation;
use crate::run::{Progress, Study};
use crate::simulation::{Settings, Simulation};
use crate::spec::wear::eq06_critical_time_step::critical_time_step;
use crate::spec::wear::eq21_critical_damping::critical_damping;
use crate::spec::wear::{Interaction, Material, Wear};
use crate::spec::{PairModel, Vec3};
use crate::system::{Motion, System};

/// A part of a run with one model and one integration scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Its name in the records of a run.
    pub name: &'static str,
    /// The set-up of the system before it begins.
    pub setup: Setup,
    /// The forces that act.
    pub interaction: Interaction,
    /// Time step.
    pub dt: InCriticalSteps,
    /// Global damping.
    pub damping: InCriticalDampings,
    /// Whether the box relaxes: its sides follow the stress until it vanishes.
    pub relax_box: bool,
    /// The condition for its end.
    pub stop: Stop,
    /// Bulk density to which the masses are rescaled at its end, ag/nm^3.
    pub final_density: Option<f64>,
}

/// The set-up of a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setup {
    /// Nothing.
    None,
    /// Two rigid walls of this thickness, nm, at the two ends of the y axis; the upper one is driven.
    Walls {
        /// Thickness of each.
        thickness: f64,
        /// The drive of the upper wall.
        drive: Drive,
    },
    /// Carves a junction.
    Junction(Junction),
    /// Cuts two bodies.
    Bodies(Bodies),
}

/// The drive of the upper wall of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// A compressive stress, MPa.
    Compress(f64),
    /// Extension by this strain in every step.
    Stretch(f64),
    /// Shear by this strain in every step.
    Shear(f64),
}

/// The condition for the end of a stage.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// After a time or a number of steps.
    After(InSteps),
    /// All normal stresses are below `stress`, MPa; the stage has failed after `most` steps.
    Relaxed {
        /// The largest residual stress.
        stress: f64,
        /// The largest number of steps.
        most: u64,
    },
}

/// The critical time step (Eq. 6) and the critical damping (Eq. 21) of the smallest
/// particle: the scales in which the paper gives its settings.
pub fn critical_scales(system: &System, material: &Material) -> (f64, f64) {
    let p = &system.particles;
    let model = Wear { material: *material, interaction: Interaction::Full };
    (0..p.len()).fold((f64::INFINITY, f64::INFINITY), |(dt, c), i| {
        let (r, m) = (p.radius[i], p.mass[i]);
        let k_n = model.coefficients(r, r, m, m).k_n;
        (dt.min(critical_time_step(m, k_n)), c.min(critical_damping(k_n, m)))
    })
}

/// Skin of the neighbour list, in mean diameters: particles of a slowly moving sample take thousands of steps to cross it, at the
/// price of a fifth more pairs.
const SKIN: f64 = 0.1;

impl Stage {
    /// Sets up a system for the stage.
    pub fn set_up(&self, mut system: System, material: &Material) -> System {
        match self.setup {
            Setup::None => system,
            Setup::Walls { thickness, drive } => {
                let dt = self.dt.value(critical_scales(&system, material).0);
                add_walls(&mut system, thickness, drive, dt);
                system
            }
            Setup::Junction(junction) => junction.carve(&system),
            Setup::Bodies(bodies) => bodies.carve(&system),
        }
    }

    /// The settings of its simulation.
    pub fn settings(&self, system: &System, material: &Material, max_overlap: f64) -> Settings {
        let (critical_step, critical_damping) = critical_scales(system, material);
        let p = &system.particles;
        Settings {
            damping: self.damping.value(critical_damping),
            skin: SKIN * p.mean_diameter(),
            max_overlap,
            relax_box: self.relax_box.then_some(BoxRelaxation { target: [0.0; 3], modulus: material.young_modulus }),
            ..Settings::new(self.dt.value(critical_step))
        }
    }

    /// Whether the stage has ended.
    pub fn progress(&self, simulation: &Simulation<impl PairModel>) -> Progress {
        let step = simulation.system().step;
        match &self.stop {
            Stop::After(_) if step >= self.steps(simulation.settings().dt) => Progress::Done,
            Stop::Relaxed { stress, .. } if step > 0 && simulation.largest_stress() < *stress => Progress::Done,
            Stop::Relaxed { most, .. } if step >= *most => Progress::Failed("stresses are not below the limit"),
            _ => Progress::Going,
        }
    }

    /// The largest number of steps.
    pub fn steps(&self, dt: f64) -> u64 {
        match &self.stop {
            Stop::After(duration) => ((duration.value(dt) / dt).round() as u64).max(1),
            Stop::Relaxed { most, .. } => *most,
        }
    }

    /// Whether it may end before its largest number of steps.
    pub fn may_end_early(&self) -> bool {
        matches!(self.stop, Stop::Relaxed { .. })
    }

    /// Returns the system at the end of the stage.
    pub fn end(&self, simulation: Simulation<impl PairModel>) -> System {
        let mut system = simulation.into_system();
        if let Some(density) = self.final_density {
            set_system_density(&mut system, density);
            // The relaxed state is at rest: the remaining motion is below the residual stress.
            for i in 0..system.particles.len() {
                system.particles.v[i] = Vec3::zero();
                system.particles.w[i] = Vec3::zero();
            }
        }
        system
    }
}

/// Opens the box along y and makes the two walls from the spheres at its ends; the lower one is held, the upper one driven.
fn add_walls(system: &mut System, thickness: f64, drive: Drive, dt: f64) {
    let held = Motion::Velocity(0.0);
    let [lx, ly, lz] = system.domain.sides;
    let velocity = |strain: f64| Motion::Velocity(strain * (ly - 2.0 * thickness) / dt);
    let driven = match drive {
        Drive::Compress(stress) => [held, Motion::Load(-stress * lx * lz), held],
        Drive::Stretch(strain) => [held, velocity(strain), held],
        Drive::Shear(strain) => [velocity(strain), held, held],
    };
    for i in 0..system.particles.len() {
        system.particles.x[i] = system.domain.folded(system.particles.x[i]);
    }
    system.domain.periodic[1] = false;
    system.add_wall([held; 3], |p, i| p.x[i].0[1] < thickness);
    system.add_wall(driven, |p, i| p.x[i].0[1] > ly - thickness);
}

/// A study without a case: stages in succession, observed by its sink only.
pub struct Protocol<'a> {
    /// The stages.
    pub stages: &'a [Stage],
    /// The state before the first.
    pub initial: System,
    /// The material.
    pub material: &'a Material,
    /// Largest overlap, as a fraction of the sum of the radii.
    pub max_overlap: f64,
}

impl Study for Protocol<'_> {
    type Model = Wear;
    type Watch = ();

    fn stages(&self) -> Vec<&'static str> {
        self.stages.iter().map(|stage| stage.name).collect()
    }
    fn initial(&self, _: &Interrupt) -> Result<System, Error> {
        Ok(self.initial.clone())
    }
    fn set_up(&self, stage: usize, system: System) -> Result<System, Error> {
        Ok(self.stages[stage].set_up(system, self.material))
    }
    fn model(&self, stage: usize, _: &System) -> Wear {
        Wear { material: *self.material, interaction: self.stages[stage].interaction }
    }
    fn settings(&self, stage: usize, system: &System) -> Settings {
        self.stages[stage].settings(system, self.material, self.max_overlap)
    }
    fn steps(&self, stage: usize, dt: f64) -> u64 {
        self.stages[stage].steps(dt)
    }
    fn progress(&self, stage: usize, (): &(), simulation: &Simulation<Wear>) -> Progress {
        self.stages[stage].progress(simulation)
    }
    fn may_end_early(&self, stage: usize) -> bool {
        self.stages[stage].may_end_early()
    }
    fn end(&self, stage: usize, simulation: Simulation<Wear>) -> Result<System, Error> {
        Ok(self.stages[stage].end(simulation))
    }
    fn watch(&self, _: usize, _: &Simulation<Wear>, _: &Interrupt) -> Result<(), Error> {
        Ok(())
    }
}
