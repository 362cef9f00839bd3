//! Surfaces: what they do to the spheres in a step, and what their contacts hold.

use super::{Simulation, SurfaceAccount};
use crate::error::{Halt, Reason};
use crate::forces::{Leaning, each_touch, lean};
use crate::spec::mechanics::work::work;
use crate::spec::{Flat, PairModel, Vec3};
use rayon::prelude::*;

/// Below this number of blocks one core has looked at all surfaces sooner than others have been called.
const MANY: usize = 16;

impl<M: PairModel> Simulation<M> {
    /// Adds what the surfaces do to the loads on the spheres, and moves them.
    pub(super) fn lean_on_surfaces(&mut self) -> Result<(), Halt> {
        let dt = self.settings.dt;
        for s in 0..self.system.surfaces.len() {
            let leaning = self.lean_on(s, dt)?;
            let account = &mut self.ledger.surfaces;
            account.work_on_spheres += leaning.power * dt;
            for (k, lost) in account.lost.iter_mut().enumerate() {
                *lost += leaning.losses.at(k);
            }
            let surface = &mut self.system.surfaces[s];
            account.work += work(leaning.force.total(), surface.velocity, Vec3::zero(), Vec3::zero(), dt);
            surface.force = leaning.force.reversed();
            leaning.keep(&mut surface.grips);
            surface.advance(dt);
        }
        Ok(())
    }

    /// Adds what a surface does to the loads on the spheres, with the springs of its contacts advanced by `dt`.
    pub(super) fn lean_on(&mut self, s: usize, dt: f64) -> Result<Leaning<M>, Halt> {
        let (model, particles, surface) = (&self.model, &self.system.particles, &self.system.surfaces[s]);
        let one = |block| lean(model, surface, particles, block, dt);
        let parts: Vec<Leaning<M>> = if self.blocks.len() < MANY {
            self.blocks.iter_mut().map(one).collect()
        } else {
            self.blocks.par_iter_mut().map(one).collect()
        };
        let leaning = parts.into_iter().fold(Leaning::default(), Leaning::and);
        let (particle, ratio) = leaning.deepest;
        let limit = self.settings.max_overlap;
        if ratio > limit { Err(self.halt(Reason::Sunk { particle, ratio, limit })) } else { Ok(leaning) }
    }

    /// What the surfaces hold, zJ, by cause.
    pub(super) fn stored_at_surfaces(&self) -> Vec<f64> {
        let mut sums = vec![0.0; M::Stored::<f64>::LEN];
        let mut seen = Vec::new();
        for surface in &self.system.surfaces {
            for p in 0..self.system.particles.len() {
                each_touch(&self.model, surface, &self.system.particles, p, &mut seen, |_, touch, springs, nearest| {
                    let springs = springs.unwrap_or(Flat::from_fn(|_| 0.0));
                    let stored = self.model.surface_stored(surface.material, touch, &springs, nearest);
                    for (k, sum) in sums.iter_mut().enumerate() {
                        *sum += stored.at(k);
                    }
                });
            }
        }
        sums
    }

    pub(super) fn open_surface_account(&self) -> SurfaceAccount {
        let lost = vec![0.0; M::Losses::<f64>::LEN];
        SurfaceAccount { stored_at_start: self.stored_at_surfaces(), lost, ..SurfaceAccount::default() }
    }
}
