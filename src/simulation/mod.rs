//! The step loop.

mod checks;
mod ledger;
mod letting_go;
mod listing;
mod necks;
mod pairs;
mod settings;
mod shares;
mod snapshot;
mod steering;
mod surfaces;
mod verlet;

pub use crate::motion::Integrator;
pub use ledger::{Ledger, SurfaceAccount};
pub use necks::remove_necks;
pub use pairs::Pair;
pub use settings::Settings;
pub use snapshot::Snapshot;

use crate::error::{Halt, Reason};
use crate::forces::{self, Block, MergedLoads, Totals, stored_loads};
use crate::interrupt::Interrupt;
use crate::motion::{self, BoxMotion, LoadTable, MotionTotals, Spheres};
use crate::spec::mechanics::box_relaxation::box_work;
use crate::spec::mechanics::box_stress::box_stress;
use crate::spec::{PairModel, Vec3};
use crate::system::System;
use listing::Listed;
use rayon::prelude::*;
use shares::Shares;
use verlet::VerletState;

/// A system under a contact model.
pub struct Simulation<M: PairModel> {
    model: M,
    settings: Settings,
    system: System,
    /// Time at which its steps were counted from zero, ns.
    begun: f64,
    blocks: Vec<Block<M>>,
    /// The locations of the loads on the members of bodies.
    load_table: LoadTable,
    /// The locations of the loads on walls: wall, block, index within the block.
    on_walls: Vec<(u32, u32, u32)>,
    /// The state from which the neighbour list was built, of which it is a function.
    listed: Listed,
    /// Largest distance at which it lists neighbours.
    reach: f64,
    /// Whether the far pairs have been evaluated since the last rebuild of the neighbour list.
    far_known: bool,
    /// The counts by which contacts have their shares of moments of inertia; empty before the first evaluation of a neighbour list.
    shares: Shares,
    box_motion: BoxMotion,
    momentum_flux: [f64; 3],
    stress: [f64; 3],
    ledger: Ledger,
    /// The state of velocity Verlet.
    held: VerletState,
}

impl<M: PairModel> Simulation<M> {
    /// Puts a system under a model. The step must be below the stability limit of every free sphere.
    ///
    /// # Errors
    ///
    /// If the time step is too large, another setting makes no sense, or a neck joins a sphere that does not exist, or two of one body or wall.
    pub fn new(model: M, system: System, settings: Settings) -> Result<Self, Halt> {
        Self::new_unless(model, system, settings, &Interrupt::default())
    }

    /// The same, unless it is to stop before.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), or [`Reason::Interrupted`].
    pub fn new_unless(model: M, mut system: System, settings: Settings, interrupt: &Interrupt) -> Result<Self, Halt> {
        let springs = std::mem::take(&mut system.springs);
        let listed = Listed { x: Vec::new(), sides: system.domain.sides, poses: Vec::new(), moving: 0 };
        let mut simulation = Self {
            model,
            settings,
            blocks: Vec::new(),
            load_table: LoadTable::default(),
            on_walls: Vec::new(),
            listed,
            reach: 0.0,
            far_known: false,
            shares: Shares::default(),
            box_motion: BoxMotion::default(),
            momentum_flux: [0.0; 3],
            stress: [0.0; 3],
            ledger: Ledger::default(),
            held: VerletState::default(),
            begun: system.time - system.step as f64 * settings.dt,
            system,
        };
        simulation.check_settings()?;
        simulation.check_necks()?;
        simulation.list_neighbours(&springs, interrupt)?;
        simulation.unless(interrupt)?;
        let late = simulation.lag() - simulation.system.lag;
        if settings.synchronous_start && late != 0.0 {
            simulation.delay(late)?;
        }
        simulation.unless(interrupt)?;
        simulation.open_ledger(interrupt)?;
        simulation.unless(interrupt)?;
        if settings.integrator == Integrator::VelocityVerlet {
            simulation.hold()?;
        }
        Ok(simulation)
    }

    /// Goes on unless it is to stop.
    fn unless(&self, interrupt: &Interrupt) -> Result<(), Halt> {
        if interrupt.is_due() { Err(self.halt(Reason::Interrupted)) } else { Ok(()) }
    }

    /// The state. Members of bodies that nothing touches are where they were when neighbours were listed last, until
    /// [`place_members`](Self::place_members) is called.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Time since the stage began, ns: steps are counted from there.
    pub fn elapsed(&self) -> f64 {
        self.system.step as f64 * self.settings.dt
    }

    /// Updates the positions of all members of bodies.
    pub fn place_members(&mut self) {
        self.system.place_members(self.listed.moving);
    }

    /// Ends the simulation and returns the state.
    pub fn into_system(mut self) -> System {
        self.place_members();
        self.system.lag = self.lag();
        self.system
    }

    /// Ends the simulation and returns the state with the springs of all contacts, from which the next simulation continues.
    pub fn into_system_with_springs(self) -> System {
        let springs = self.springs().0;
        System { springs, ..self.into_system() }
    }

    /// The model.
    pub fn model(&self) -> &M {
        &self.model
    }

    /// The settings.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Diagonal of the stress of the whole box in the last step, MPa, positive in tension.
    pub fn stress(&self) -> [f64; 3] {
        self.stress
    }

    /// The motion of the sides of the box.
    pub fn box_motion(&self) -> BoxMotion {
        self.box_motion
    }

    /// Diagonal of the sum of `m v v` of the last step, zJ.
    pub fn momentum_flux(&self) -> [f64; 3] {
        self.momentum_flux
    }

    /// Largest stress, absolutely, MPa.
    pub fn largest_stress(&self) -> f64 {
        self.stress.iter().fold(0.0, |most: f64, s| most.max(s.abs()))
    }

    /// Takes one step.
    pub(crate) fn step(&mut self) -> Result<(), Halt> {
        match self.settings.integrator {
            Integrator::HalfStep => self.step_half(),
            Integrator::VelocityVerlet => self.step_verlet(),
        }
    }

    /// Time by which the velocities are behind its positions, ns.
    fn lag(&self) -> f64 {
        match self.settings.integrator {
            Integrator::HalfStep => 0.5 * self.settings.dt,
            Integrator::VelocityVerlet => 0.0,
        }
    }

    /// Counts a step. Time is a product, in which rounding errors do not add up.
    fn tick(&mut self) {
        self.system.step += 1;
        self.system.time = self.begun + self.elapsed();
    }

    /// Evaluates all pairs and advances their springs by `dt`.
    fn evaluate(&mut self, dt: f64) -> Result<Totals<M::Losses<f64>>, Halt> {
        self.share();
        let Settings { max_overlap, instructions, .. } = self.settings;
        let (model, particles, domain) = (&self.model, &self.system.particles, &self.system.domain);
        let far_anew = self.far_due();
        let totals: Vec<Totals<_>> = self
            .blocks
            .par_iter_mut()
            .with_max_len(1)
            .map(|block| forces::evaluate(model, instructions, block, (particles, domain), far_anew, (max_overlap, dt)))
            .collect();
        self.far_known = true;
        let totals = totals.into_iter().fold(Totals::default(), Totals::and);
        if totals.clearance < 0.0 { Err(self.overlapping()) } else { Ok(totals) }
    }

    /// Whether the far pairs are evaluated in the next step.
    fn far_due(&self) -> bool {
        !self.far_known || self.system.step.is_multiple_of(self.settings.far_every)
    }

    fn step_half(&mut self) -> Result<(), Halt> {
        let Settings { dt, damping, .. } = self.settings;
        let totals = self.evaluate(dt)?;
        let domain = &self.system.domain;
        let volume = domain.volume();
        self.stress = box_stress(Vec3(totals.virial), Vec3(self.momentum_flux), volume).0;
        let growth = match &self.settings.relax_box {
            Some(relaxation) => {
                let mass = self.system.particles.mass.iter().sum();
                relaxation.grow(&mut self.box_motion, self.stress, domain, mass, dt)
            }
            None => [1.0; 3],
        };
        let box_work = box_work(Vec3(totals.virial), Vec3(growth));
        self.lean_on_surfaces()?;
        self.steer();
        let acting = self.acting_on_walls();
        let wall_work = motion::drive(&mut self.system.walls, &acting, dt);
        let (moved, corrected) = self.advance(growth, dt, damping);
        for (stress, inside) in self.stress.iter_mut().zip(corrected) {
            *stress += inside / volume;
        }
        for (side, factor) in self.system.domain.sides.iter_mut().zip(growth) {
            *side *= factor;
        }
        self.momentum_flux = moved.momentum_flux;
        self.ledger.enter(&totals, &wall_work, &moved, box_work, dt);
        self.tick();
        self.check_finite(moved.kinetic + wall_work.kinetic)?;
        if self.stale(&moved) {
            self.list_anew()?;
        }
        Ok(())
    }

    /// Moves everything; also returns the correction of the virial for forces inside bodies.
    fn advance(&mut self, growth: [f64; 3], dt: f64, damping: f64) -> (MotionTotals, [f64; 3]) {
        let stretch = std::array::from_fn(|a| self.system.domain.sides[a] / self.listed.sides[a] * growth[a]);
        let instructions = self.settings.instructions;
        let step = motion::Step { dt, damping, walls: &self.system.walls, growth, stretch, instructions };
        let (particles, blocks) = (&mut self.system.particles, &self.blocks);
        let single = self.load_table.single;
        let mut spheres = Spheres {
            x: &mut particles.x,
            v: &mut particles.v,
            w: &mut particles.w,
            radius: &particles.radius,
            mass: &particles.mass,
            wall: &particles.wall,
            listed: &self.listed.x,
        };
        let mut parts = Vec::with_capacity(self.blocks.len());
        for block in &self.blocks {
            let (part, rest) = spheres.split(block.own.end.min(single) - block.own.start.min(single));
            parts.push(part);
            spheres = rest;
        }
        let stored = stored_loads(blocks);
        let moved: Vec<MotionTotals> = self
            .blocks
            .par_iter()
            .zip(parts)
            .with_max_len(1)
            .map(|(block, part)| motion::advance(MergedLoads::new(block, part.x.len(), &stored), part, &step))
            .collect();
        let moved = moved.into_iter().fold(MotionTotals::default(), MotionTotals::and);
        if self.system.bodies.is_empty() {
            return (moved, [0.0; 3]);
        }
        let bodies = (&mut self.system.bodies[..], &self.listed.poses[..]);
        let (carried, inside) =
            motion::advance_bodies(bodies, particles, single..self.listed.moving, (&self.load_table, blocks), &step);
        (moved.and(carried), inside)
    }

    /// Forces on the walls and torques on their spheres.
    fn acting_on_walls(&self) -> Vec<(Vec3<f64>, Vec3<f64>)> {
        let mut acting = vec![(Vec3::zero(), Vec3::zero()); self.system.walls.len()];
        for &(wall, block, place) in &self.on_walls {
            let [fx, fy, fz, tx, ty, tz, ..] = self.blocks[block as usize].loads[place as usize].0;
            let (force, torque) = &mut acting[wall as usize];
            *force = *force + Vec3([fx, fy, fz]);
            *torque = *torque + Vec3([tx, ty, tz]);
        }
        acting
    }
}
