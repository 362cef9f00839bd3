//! The step loop.

mod checks;
mod ledger;
mod letting_go;
mod listing;
mod necks;
mod pairs;
mod shares;
mod snapshot;
mod steering;
mod surfaces;
mod verlet;

pub use crate::motion::Integrator;
pub use ledger::{Ledger, SurfaceAccount};
pub use necks::EXAMINED;
pub use pairs::Pair;
pub use snapshot::Snapshot;

use crate::error::Halt;
use crate::forces::{self, Block, Instructions, Totals};
use crate::motion::{self, BoxRelaxation, Grips, Moved, Spheres};
use crate::spec::{PairModel, Vec3};
use crate::system::System;
use listing::Listed;
use rayon::prelude::*;
use verlet::Held;

/// How a system is advanced. Units: ns, ag/ns, nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Time step.
    pub dt: f64,
    /// How velocities go with positions.
    pub integrator: Integrator,
    /// Coefficient `c` of the global damping force `-c v` on every free sphere.
    pub damping: f64,
    /// How much farther than their range neighbours are listed.
    pub skin: f64,
    /// Largest overlap allowed, as a fraction of the sum of the radii; infinite for no limit.
    pub max_overlap: f64,
    /// Lets the sides of the box follow the stress.
    pub relax_box: Option<BoxRelaxation>,
    /// Far pairs, which only attract or repel each other, are evaluated anew every so many steps.
    pub far_every: u64,
    /// Vector instructions of the pair loop.
    pub instructions: Instructions,
}

impl Settings {
    /// A time step in ns, and of all else what is plain: velocities half a step behind positions, no damping, neighbours listed
    /// no farther than their range, no limit of overlap, fixed sides, the widest vector instructions.
    pub fn new(dt: f64) -> Self {
        Self {
            dt,
            integrator: Integrator::HalfStep,
            damping: 0.0,
            skin: 0.0,
            max_overlap: f64::INFINITY,
            relax_box: None,
            far_every: 1,
            instructions: Instructions::best(),
        }
    }
}

/// A system under a contact model.
pub struct Simulation<M: PairModel> {
    model: M,
    settings: Settings,
    system: System,
    blocks: Vec<Block<M>>,
    /// Where the loads on the members of bodies are.
    grips: Grips,
    /// Where the loads on walls are: wall, block, place within the block.
    on_walls: Vec<(u32, u32, u32)>,
    /// What the neighbour list was built from, and is a function of.
    listed: Listed,
    /// Largest distance at which it lists neighbours.
    reach: f64,
    /// Whether what the far pairs do has been looked at since neighbours were listed.
    far_known: bool,
    /// Rates of strain of the sides, 1/ns.
    box_rate: [f64; 3],
    momentum_flux: [f64; 3],
    stress: [f64; 3],
    ledger: Ledger,
    /// What velocity Verlet goes on with.
    held: Held,
}

impl<M: PairModel> Simulation<M> {
    /// Puts a system under a model. The step must be below the stability limit of every free sphere.
    pub fn new(model: M, mut system: System, settings: Settings) -> Result<Self, Halt> {
        let springs = std::mem::take(&mut system.springs);
        let listed = Listed { x: Vec::new(), sides: system.domain.sides, poses: Vec::new(), moving: 0 };
        let mut simulation = Self {
            model,
            settings,
            blocks: Vec::new(),
            grips: Grips::default(),
            on_walls: Vec::new(),
            listed,
            reach: 0.0,
            far_known: false,
            box_rate: [0.0; 3],
            momentum_flux: [0.0; 3],
            stress: [0.0; 3],
            ledger: Ledger::default(),
            held: Held::default(),
            system,
        };
        simulation.check_time_step()?;
        simulation.list_neighbours(&springs)?;
        simulation.open_ledger();
        if settings.integrator == Integrator::VelocityVerlet {
            simulation.hold()?;
        }
        Ok(simulation)
    }

    /// The state. Members of bodies that nothing touches are where they were when neighbours were listed last, until
    /// [`place_members`](Self::place_members) is called.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Moves all members of bodies to where their bodies are.
    pub fn place_members(&mut self) {
        self.system.place_members(self.listed.moving);
    }

    /// Ends the simulation and hands back the state.
    pub fn into_system(mut self) -> System {
        self.place_members();
        self.system
    }

    /// Ends the simulation and hands back the state with the springs of all contacts, for the next simulation to go on with.
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

    /// Largest stress, absolutely, MPa.
    pub fn largest_stress(&self) -> f64 {
        self.stress.iter().fold(0.0, |most: f64, s| most.max(s.abs()))
    }

    /// Takes one step.
    pub fn step(&mut self) -> Result<(), Halt> {
        match self.settings.integrator {
            Integrator::HalfStep => self.step_half(),
            Integrator::VelocityVerlet => self.step_verlet(),
        }
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
        self.stress = std::array::from_fn(|a| (totals.virial[a] - self.momentum_flux[a]) / volume);
        let growth = match &self.settings.relax_box {
            Some(relaxation) => {
                let mass = self.system.particles.mass.iter().sum();
                relaxation.grow(&mut self.box_rate, self.stress, domain, mass, dt)
            }
            None => [1.0; 3],
        };
        let box_work: f64 = (0..3).map(|a| totals.virial[a] * (growth[a] - 1.0)).sum();
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
        self.system.step += 1;
        self.system.time += dt;
        self.check_finite(moved.kinetic + wall_work.kinetic)?;
        if self.stale(&moved) {
            self.list_anew()?;
        }
        Ok(())
    }

    /// Moves everything; also returns what forces inside bodies must correct the virial by.
    fn advance(&mut self, growth: [f64; 3], dt: f64, damping: f64) -> (Moved, [f64; 3]) {
        let stretch = std::array::from_fn(|a| self.system.domain.sides[a] / self.listed.sides[a] * growth[a]);
        let instructions = self.settings.instructions;
        let step = motion::Step { dt, damping, walls: &self.system.walls, growth, stretch, instructions };
        let (particles, blocks) = (&mut self.system.particles, &self.blocks);
        let single = self.grips.single;
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
        let moved: Vec<Moved> = self
            .blocks
            .par_iter()
            .zip(parts)
            .enumerate()
            .with_max_len(1)
            .map(|(number, (_, part))| motion::advance(blocks, number, part, &step))
            .collect();
        let moved = moved.into_iter().fold(Moved::default(), Moved::and);
        if self.system.bodies.is_empty() {
            return (moved, [0.0; 3]);
        }
        let bodies = (&mut self.system.bodies[..], &self.listed.poses[..]);
        let (carried, inside) =
            motion::advance_bodies(bodies, particles, single..self.listed.moving, (&self.grips, blocks), &step);
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
