//! The complete state, to be saved and restored.
//!
//! The state from which the neighbour list was built is stored instead of the list, so a simulation restored from a snapshot has the same list,
//! the same order of sums, and continues with the same bits.

use super::shares::Shares;
use super::{Integrator, Ledger, Listed, Settings, Simulation, VerletState};
use crate::error::{Halt, Reason};
use crate::motion::{BoxMotion, LoadTable};
use crate::spec::{Flat, PairModel};
use crate::system::{Springs, Surface, System, bounded};
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
    box_motion: BoxMotion,
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

    /// Whether its numbers are bounded, its lists have the same lengths, and its indices and ids are those of something.
    pub fn is_sound(&self) -> bool {
        let Self { system, begun, listed, memory, far, box_motion, momentum_flux, stress, ledger, held } = self;
        let numbers = memory.iter().chain(far.iter().flatten()).chain(momentum_flux).chain(stress);
        let numbers = numbers.chain(&box_motion.rate).chain(&box_motion.owed).chain([begun]);
        system.is_sound() && listed.is_sound(system) && ledger.is_sound() && held.is_sound() && bounded(numbers)
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
            box_motion: self.box_motion,
            momentum_flux: self.momentum_flux,
            stress: self.stress,
            ledger: self.ledger.clone(),
            held: self.held.clone(),
        }
    }

    /// Restores a simulation from a sound snapshot.
    ///
    /// # Errors
    ///
    /// If the settings make no sense, or the snapshot is that of another model or integrator.
    pub fn resume(model: M, settings: Settings, snapshot: Snapshot) -> Result<Self, Halt> {
        let Snapshot { system, begun, listed, memory, far, box_motion, momentum_flux, stress, ledger, held } = snapshot;
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
            shares: Shares::default(),
            box_motion,
            momentum_flux,
            stress,
            ledger,
            held,
            system,
            begun,
        };
        simulation.check_settings()?;
        simulation.relist(&Springs::default())?;
        simulation.check_lengths(memory.len(), far.as_ref().map(Vec::len))?;
        let mut numbers = memory.into_iter();
        for block in &mut simulation.blocks {
            for (row, lane) in block.pairs.rows_and_lanes() {
                let row = &mut block.pairs.memory[row];
                for k in 0..M::Memory::<f64>::LEN {
                    row.at_mut(k).0[lane] = numbers.next().expect("the length was checked");
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

    /// Whether a snapshot that was restored is one of this model and integrator, with springs of the pairs and held forces of these lengths.
    fn check_lengths(&self, springs: usize, far: Option<usize>) -> Result<(), Halt> {
        let widths = (M::Memory::<f64>::LEN, M::Stored::<f64>::LEN, M::Losses::<f64>::LEN);
        let pairs: usize = self.blocks.iter().map(|block| block.each_pair().count()).sum();
        let held_far = || self.blocks.iter().map(|block| block.far.held_loads(block.len()).count()).sum::<usize>();
        let spheres = self.system.particles.len();
        let (is_verlet, only_spheres) = (
            self.settings.integrator == Integrator::VelocityVerlet,
            self.system.walls.is_empty() && self.system.bodies.is_empty(),
        );
        let surfaces = &self.system.surfaces;
        let touching = |surface: &Surface| surface.contacts.springs.len() == widths.0 * surface.contacts.places.len();
        let fits = springs == pairs * widths.0
            && far.is_none_or(|held| held == held_far())
            && self.held.has_loads_of(if is_verlet { spheres } else { 0 })
            && (only_spheres || !is_verlet)
            && self.ledger.has_lengths(widths.1, widths.2)
            && surfaces.iter().all(|surface| surface.material < M::SURFACES && touching(surface));
        if fits { Ok(()) } else { Err(self.halt(Reason::Snapshot)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulation::Settings;
    use crate::spec::titania::Titania;

    #[test]
    fn a_snapshot_is_unsound_if_any_of_its_numbers_is_not_finite() {
        let law = Titania::paper(1.0, 1.0, 1.0);
        let radius = law.contact_radius(8.0);
        let system = System::builder().sphere([0.0; 3], radius, 1.0).sphere([2.0 * radius, 0.0, 0.0], radius, 1.0);
        let system = system.build().expect("a system");
        let simulation = Simulation::new(law, system, Settings::new(1e-4).skin(1.0)).expect("a stable step");
        let whole = simulation.snapshot();
        assert!(whole.is_sound());
        let spoil: [fn(&mut Snapshot); 9] = [
            |snapshot| snapshot.system.particles.x[0].0[0] = f64::NAN,
            |snapshot| snapshot.begun = f64::NAN,
            |snapshot| snapshot.memory[0] = f64::INFINITY,
            |snapshot| snapshot.far = Some(vec![f64::NAN]),
            |snapshot| snapshot.box_motion.rate[2] = f64::NAN,
            |snapshot| snapshot.box_motion.owed[0] = f64::NAN,
            |snapshot| snapshot.momentum_flux[1] = f64::NAN,
            |snapshot| snapshot.stress[0] = f64::NAN,
            |snapshot| snapshot.ledger.kinetic = f64::NAN,
        ];
        for (number, spoil) in spoil.into_iter().enumerate() {
            let mut spoiled = whole.clone();
            spoil(&mut spoiled);
            assert!(!spoiled.is_sound(), "{number}");
        }
    }
}
