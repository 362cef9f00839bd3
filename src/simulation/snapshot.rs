//! The complete state, to be saved and restored.
//!
//! The state from which the neighbour list was built is stored instead of the list, so a simulation restored from a snapshot has the same list,
//! the same order of sums, and continues with the same bits.

use super::{Ledger, Listed, Settings, Simulation, VerletState};
use crate::error::Halt;
use crate::motion::LoadTable;
use crate::spec::{Flat, PairModel};
use crate::system::Springs;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// The complete state of a simulation, without its model and settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    system: System,
    begun: f64,
    listed: Listed,
    /// Springs of all pairs, in the order of the list.
    memory: Vec<f64>,
    /// The held forces of far pairs, block by block, if the next step uses them.
    far: Option<Vec<f64>>,
    box_rate: [f64; 3],
    momentum_flux: [f64; 3],
    stress: [f64; 3],
    ledger: Ledger,
    held: VerletState,
}

impl Snapshot {
    /// The spheres, the box and the walls.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Whether its numbers are finite, its lists of the same length, and its numbers of spheres, bodies and walls those of existing ones.
    pub fn is_sound(&self) -> bool {
        let Self { system, listed, .. } = self;
        let (p, spheres) = (&system.particles, system.particles.len());
        let lengths = [p.v.len(), p.w.len(), p.radius.len(), p.mass.len(), p.wall.len(), p.body.len(), p.arm.len()];
        let sound = lengths.into_iter().chain([p.id.len(), p.tag.len(), listed.x.len()]).all(|n| n == spheres)
            && listed.poses.len() == system.bodies.len()
            && listed.moving <= spheres
            && p.wall
                .iter()
                .chain(system.bodies.iter().map(|body| &body.wall))
                .all(|&k| k as usize <= system.walls.len())
            && p.body.iter().all(|&k| k as usize <= system.bodies.len());
        let places = system.places();
        let known = |id: &u32| places.contains_key(id);
        let vectors = [&p.x, &p.v, &p.w, &p.arm, &listed.x].into_iter().flatten().flat_map(|vector| vector.0);
        sound
            && places.len() == spheres
            && system.necks.iter().all(|(i, j)| known(i) && known(j) && i != j)
            && p.radius.iter().chain(&p.mass).chain(&system.domain.sides).chain(&listed.sides).all(|&x| x > 0.0)
            && vectors
                .chain([system.time, self.begun])
                .chain(p.radius.iter().chain(&p.mass).copied())
                .all(f64::is_finite)
            && system.domain.sides.iter().chain(&listed.sides).all(|x| x.is_finite())
    }
}

impl<M: PairModel> Simulation<M> {
    /// The complete state.
    pub fn snapshot(&self) -> Snapshot {
        let memory = self.blocks.iter().flat_map(|block| {
            block.each_pair().flat_map(|(_, _, row, lane)| {
                let memory = &block.pairs.memory[row];
                (0..M::Memory::<f64>::LEN).map(move |k| memory.at(k).0[lane])
            })
        });
        let mut system = self.system.clone();
        system.place_members(self.listed.moving);
        Snapshot {
            memory: memory.collect(),
            far: (!self.far_due())
                .then(|| self.blocks.iter().flat_map(|block| block.far.held_loads(block.len())).collect()),
            system,
            begun: self.begun,
            listed: self.listed.clone(),
            box_rate: self.box_rate,
            momentum_flux: self.momentum_flux,
            stress: self.stress,
            ledger: self.ledger.clone(),
            held: self.held.clone(),
        }
    }

    /// Restores a simulation from a snapshot.
    ///
    /// # Errors
    ///
    /// If the time step is too large.
    pub fn resume(model: M, settings: Settings, snapshot: Snapshot) -> Result<Self, Halt> {
        let Snapshot { system, begun, listed, memory, far, box_rate, momentum_flux, stress, ledger, held } = snapshot;
        let (blocks, load_table, on_walls, reach, far_known) =
            (Vec::new(), LoadTable::default(), Vec::new(), 0.0, false);
        let mut simulation = Self {
            model,
            settings,
            blocks,
            load_table,
            on_walls,
            listed,
            reach,
            far_known,
            shared: None,
            box_rate,
            momentum_flux,
            stress,
            ledger,
            held,
            system,
            begun,
        };
        simulation.relist(&Springs::default())?;
        let mut numbers = memory.into_iter();
        for block in &mut simulation.blocks {
            for (row, lane) in block.pairs.rows_and_lanes() {
                let row = &mut block.pairs.memory[row];
                for k in 0..M::Memory::<f64>::LEN {
                    row.at_mut(k).0[lane] = numbers.next().unwrap_or(f64::NAN);
                }
            }
        }
        if let Some(numbers) = far {
            let mut numbers = numbers.into_iter();
            for block in &mut simulation.blocks {
                let spheres = block.len();
                block.far.restore_loads(spheres, &mut numbers);
            }
            simulation.far_known = true;
        }
        Ok(simulation)
    }
}
