//! A step of velocity Verlet. Positions, velocities and output belong to the same time; forces are evaluated with the positions there
//! and the velocities of half a step before, with which the springs advance, too.

use super::Simulation;
use crate::error::{Halt, Reason};
use crate::forces::{MergedLoads, SurfaceTotals, Totals, stored_loads};
use crate::motion::verlet;
use crate::spec::mechanics::box_stress::box_stress;
use crate::spec::mechanics::work::work;
use crate::spec::numbers::Lanes;
use crate::spec::{Flat, PairModel, Vec3};
use crate::system::bounded;
use serde::{Deserialize, Serialize};

/// The state between steps: the forces at the end of the last one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct VerletState {
    /// Force and torque on each sphere.
    loads: Vec<[f64; 6]>,
    /// Power of the pairs at the velocities they saw.
    pairs: f64,
    /// Power of the surfaces on the spheres, likewise.
    surfaces: f64,
    /// Energy by which this is less than the work, in half a step, at the velocities that go with the positions.
    late: f64,
}

impl VerletState {
    /// Whether its numbers are bounded.
    pub(super) fn is_sound(&self) -> bool {
        let Self { loads, pairs, surfaces, late } = self;
        bounded(loads.iter().flatten().chain([pairs, surfaces, late]))
    }

    /// Whether it holds forces on this number of spheres.
    pub(super) fn has_loads_of(&self, spheres: usize) -> bool {
        self.loads.len() == spheres
    }
}

impl<M: PairModel> Simulation<M> {
    pub(super) fn step_verlet(&mut self) -> Result<(), Halt> {
        let dt = self.settings.dt;
        let half = 0.5 * dt;
        let moved = verlet::begin(&mut self.system.particles, &self.held.loads, &self.listed.x, dt);
        self.enter_half(moved.scheme + self.held.late);
        self.system.surfaces.iter_mut().for_each(|surface| surface.advance(dt));
        if self.stale(&moved) {
            self.list_anew()?;
        }

        let totals = self.evaluate(dt)?;
        let mut power = 0.0;
        for s in 0..self.system.surfaces.len() {
            let of_surface = self.totals_of(s, dt)?;
            power += of_surface.power;
            let (surface, account) = (&mut self.system.surfaces[s], &mut self.ledger.surfaces);
            for (k, lost) in account.lost.iter_mut().enumerate() {
                *lost += of_surface.losses.at(k);
            }
            let before = surface.force.reversed();
            let both = before.total() + of_surface.force.total();
            account.work += work(both, surface.velocity, Vec3::zero(), Vec3::zero(), half);
            surface.force = of_surface.force.reversed();
            of_surface.store_contacts(&mut surface.contacts);
        }
        self.hold_loads(&totals, power);
        let moved = verlet::end(&mut self.system.particles, &self.held.loads, dt);
        self.enter_half(moved.scheme);
        self.held.late = 2.0 * moved.scheme;
        self.ledger.kinetic = moved.kinetic;
        for (k, lost) in self.ledger.lost_by_pairs.iter_mut().enumerate() {
            *lost += totals.losses.at(k);
        }
        self.stress = box_stress(Vec3(totals.virial), Vec3(moved.momentum_flux), self.system.domain.volume()).0;
        self.momentum_flux = moved.momentum_flux;
        self.tick();
        self.check_finite(moved.kinetic)
    }

    /// Evaluates the present forces, at the start and after necks have broken, without advancing springs.
    pub(super) fn hold(&mut self) -> Result<(), Halt> {
        // Forces at the start are known for free spheres that nothing but their partners and surfaces act on.
        let expected = "0 with velocity Verlet, and where the velocities at the start are those at its time";
        for (name, value) in [
            ("damping", self.settings.damping),
            ("number of walls", self.system.walls.len() as f64),
            ("number of rigid bodies", self.system.bodies.len() as f64),
            ("relaxation of the box", f64::from(u8::from(self.settings.relax_box.is_some()))),
        ] {
            if value != 0.0 {
                return Err(self.halt(Reason::Setting { name, value, expected }));
            }
        }
        let springs: Vec<_> = self.blocks.iter().map(|block| block.pairs.memory.clone()).collect();
        let totals = self.evaluate(0.0)?;
        for (block, springs) in self.blocks.iter_mut().zip(springs) {
            block.pairs.memory = springs;
        }
        let mut power = 0.0;
        for s in 0..self.system.surfaces.len() {
            let SurfaceTotals { force, power: of_surface, .. } = self.totals_of(s, 0.0)?;
            power += of_surface;
            self.system.surfaces[s].force = force.reversed();
        }
        self.hold_loads(&totals, power);
        Ok(())
    }

    /// Takes the velocities of the initial state back by a time, ns.
    pub(super) fn delay(&mut self, time: f64) -> Result<(), Halt> {
        self.hold()?;
        let loads = std::mem::take(&mut self.held).loads;
        verlet::delay(&mut self.system.particles, &loads, time);
        Ok(())
    }

    /// Half a step of the held forces, for the discrete account.
    fn enter_half(&mut self, scheme: f64) {
        let half = 0.5 * self.settings.dt;
        self.ledger.work_pairs += self.held.pairs * half;
        self.ledger.surfaces.work_on_spheres += self.held.surfaces * half;
        self.ledger.scheme += scheme;
    }

    fn hold_loads(&mut self, totals: &Totals<M::Losses<f64>>, power_of_surfaces: f64) {
        let stored = stored_loads(&self.blocks);
        let merged = |block| MergedLoads::new(block, block.own.len(), &stored);
        let loads = self.blocks.iter().flat_map(merged).map(|Lanes([a, b, c, d, e, f, ..])| [a, b, c, d, e, f]);
        self.held = VerletState { loads: loads.collect(), pairs: totals.power, surfaces: power_of_surfaces, late: 0.0 };
    }
}
