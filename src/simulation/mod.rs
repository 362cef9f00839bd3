//! The step loop.

mod checks;
mod ledger;
mod necks;
mod pairs;
mod snapshot;
mod surfaces;

pub use ledger::{Ledger, SurfaceAccount};
pub use pairs::Pair;
pub use snapshot::Snapshot;

use crate::forces::{self, Block, Instructions, Springs, Totals};
use crate::motion::{self, BoxRelaxation, Moved, Spheres};
use crate::spec::{Flat, PairModel, Vec3};
use crate::system::{Domain, Halt, Reason, System};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// How a system is advanced. Units: ns, ag/ns, nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Time step.
    pub dt: f64,
    /// Coefficient `c` of the global damping force `-c v` on every free sphere.
    pub damping: f64,
    /// How much farther than their range neighbours are listed.
    pub skin: f64,
    /// Largest overlap allowed, as a fraction of the sum of the radii; infinite for no limit.
    pub max_overlap: f64,
    /// Lets the sides of the box follow the stress.
    pub relax_box: Option<BoxRelaxation>,
    /// Vector instructions of the pair loop.
    pub instructions: Instructions,
}

/// A system under a contact model.
pub struct Simulation<M: PairModel> {
    model: M,
    settings: Settings,
    system: System,
    blocks: Vec<Block<M>>,
    /// What the neighbour list was built from, and is a function of.
    listed: Listed,
    /// Largest distance at which it lists neighbours.
    reach: f64,
    /// Rates of strain of the sides, 1/ns.
    box_rate: [f64; 3],
    momentum_flux: [f64; 3],
    stress: [f64; 3],
    ledger: Ledger,
}

/// What the neighbour list was built from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Listed {
    pub x: Vec<Vec3<f64>>,
    pub sides: [f64; 3],
}

impl<M: PairModel> Simulation<M> {
    /// Puts a system under a model. The step must be below the stability limit of every free sphere.
    pub fn new(model: M, mut system: System, settings: Settings) -> Result<Self, Halt> {
        let listed = Listed { x: Vec::new(), sides: system.domain.sides };
        let springs = std::mem::take(&mut system.springs);
        let mut simulation = Self {
            model,
            settings,
            blocks: Vec::new(),
            listed,
            reach: 0.0,
            box_rate: [0.0; 3],
            momentum_flux: [0.0; 3],
            stress: [0.0; 3],
            ledger: Ledger::default(),
            system,
        };
        simulation.check_time_step()?;
        simulation.list_neighbours(&springs)?;
        simulation.open_ledger();
        Ok(simulation)
    }

    /// The state.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Ends the simulation and hands back the state.
    pub fn into_system(self) -> System {
        self.system
    }

    /// Ends the simulation and hands back the state, with the springs of all pairs for a simulation that is to go on.
    pub fn into_system_with_springs(self) -> System {
        System { springs: self.springs(), ..self.system }
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
        let Settings { dt, damping, max_overlap, instructions, .. } = self.settings;
        let (model, particles, domain) = (&self.model, &self.system.particles, &self.system.domain);
        let totals: Vec<Totals<_>> = self
            .blocks
            .par_iter_mut()
            .with_max_len(1)
            .map(|block| forces::evaluate(model, instructions, block, (particles, domain), max_overlap, dt))
            .collect();
        let totals = totals.into_iter().fold(Totals::default(), Totals::and);
        if totals.clearance < 0.0 {
            return Err(self.overlapping());
        }

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
        let acting = self.acting_on_walls();
        let wall_work = motion::drive(&mut self.system.walls, &acting, dt);
        let moved = self.advance(growth, dt, damping);
        for (side, factor) in self.system.domain.sides.iter_mut().zip(growth) {
            *side *= factor;
        }
        self.momentum_flux = moved.momentum_flux;
        self.ledger.enter(&totals, &wall_work, &moved, box_work, dt);
        self.system.step += 1;
        self.system.time += dt;
        self.check_finite(moved.kinetic + wall_work.kinetic)?;
        if self.stale(&moved) {
            self.list_neighbours(&self.springs())?;
        }
        Ok(())
    }

    fn advance(&mut self, growth: [f64; 3], dt: f64, damping: f64) -> Moved {
        let stretch = std::array::from_fn(|a| self.system.domain.sides[a] / self.listed.sides[a] * growth[a]);
        let step = motion::Step { dt, damping, walls: &self.system.walls, growth, stretch };
        let (particles, blocks) = (&mut self.system.particles, &self.blocks);
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
            let (part, rest) = spheres.split(block.own.len());
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
        moved.into_iter().fold(Moved::default(), Moved::and)
    }

    /// Forces on the walls and torques on their spheres.
    fn acting_on_walls(&self) -> Vec<(Vec3<f64>, Vec3<f64>)> {
        let mut acting = vec![(Vec3::zero(), Vec3::zero()); self.system.walls.len()];
        if acting.is_empty() {
            return acting;
        }
        for block in &self.blocks {
            let own = block.own.clone();
            let halo = block.halo.iter().map(|&(q, _)| q as usize);
            for (p, load) in own.chain(halo).zip(block.loads.iter()) {
                let number = (self.system.particles.wall[p] as usize).checked_sub(1);
                if let Some((force, torque)) = number.map(|k| &mut acting[k]) {
                    let [fx, fy, fz, tx, ty, tz, ..] = load.0;
                    *force = *force + Vec3([fx, fy, fz]);
                    *torque = *torque + Vec3([tx, ty, tz]);
                }
            }
        }
        acting
    }

    /// Whether spheres may have come into range that the neighbour list does not hold.
    fn stale(&self, moved: &Moved) -> bool {
        let strain =
            (0..3).map(|a| (self.system.domain.sides[a] / self.listed.sides[a] - 1.0).abs()).fold(0.0, f64::max);
        let deformed = strain * self.reach;
        #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN is stale too")]
        let stale = !(moved.approach() + deformed < self.settings.skin);
        stale
    }

    fn list_neighbours(&mut self, springs: &Springs) -> Result<(), Halt> {
        let order = forces::spatial_order(&self.system.particles.x, &self.system.domain, self.mean_diameter());
        self.system.particles = self.system.particles.pick(&order);
        self.listed = Listed { x: self.system.particles.x.clone(), sides: self.system.domain.sides };
        self.relist(springs)
    }

    /// Builds the list from what it was built from, which the particles are already in the order of.
    fn relist(&mut self, springs: &Springs) -> Result<(), Halt> {
        let particles = &self.system.particles;
        let domain = Domain { sides: self.listed.sides, ..self.system.domain };
        let (model, skin) = (&self.model, self.settings.skin);
        let largest = particles.radius.iter().copied().fold(0.0, f64::max);
        self.reach = model.range(largest, largest) + skin;
        let pairs =
            forces::neighbours(&self.listed.x, &particles.radius, &domain, |r_i, r_j| model.range(r_i, r_j) + skin);
        let pairs: Vec<_> = pairs
            .into_iter()
            .filter(|n| {
                particles.wall[n.p as usize] == 0 || particles.wall[n.q as usize] != particles.wall[n.p as usize]
            })
            .collect();
        let necks = &self.system.necks;
        let mut missing: std::collections::BTreeSet<_> = necks.iter().copied().collect();
        for pair in &pairs {
            if missing.is_empty() {
                break;
            }
            let (i, j, _) = forces::bond(particles, pair.p as usize, pair.q as usize, pair.image);
            missing.remove(&(i, j));
        }
        if let Some(&pair) = missing.first() {
            return Err(self.halt(Reason::Neck { pair }));
        }
        self.blocks = forces::partition(model, particles, (&self.listed.x, &domain, skin), &pairs, necks, springs)
            .map_err(|reason| self.halt(reason))?;
        Ok(())
    }

    /// The springs of all contacts, by who the spheres are.
    fn springs(&self) -> Springs {
        let particles = &self.system.particles;
        let mut springs = Springs::new(M::Memory::<f64>::LEN);
        for block in &self.blocks {
            for (i, j, row, lane) in block.each_pair() {
                let ((p, a), (q, b)) = (block.member(i), block.member(j));
                let bond = forces::bond(particles, p, q, std::array::from_fn(|k| b[k] - a[k]));
                let memory = Flat::from_fn(|k| block.pairs.memory[row].at(k).0[lane]);
                let memory = self.model.relisted(&self.contact((p, a), (q, b)), memory);
                springs.add(bond, (0..M::Memory::<f64>::LEN).map(|k| *memory.at(k)));
            }
        }
        springs.sorted()
    }

    fn mean_diameter(&self) -> f64 {
        let radius = &self.system.particles.radius;
        2.0 * radius.iter().sum::<f64>() / radius.len() as f64
    }
}
