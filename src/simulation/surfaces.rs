//! Surfaces: their forces on the spheres in a step, and the energy stored in their contacts.

use super::{Simulation, SurfaceAccount};
use crate::error::{Halt, Reason};
use crate::forces::{SurfaceTotals, each_touch, surface_forces};
use crate::geometry::triangles::NearTriangles;
use crate::spec::mechanics::work::work;
use crate::spec::{Flat, PairModel, Vec3};
use rayon::prelude::*;

/// Number of blocks below which one core processes the surfaces faster than several threads.
const MANY: usize = 16;

impl<M: PairModel> Simulation<M> {
    /// Adds the forces of the surfaces to the loads on the spheres, and moves the surfaces.
    pub(super) fn lean_on_surfaces(&mut self) -> Result<(), Halt> {
        let dt = self.settings.dt;
        for s in 0..self.system.surfaces.len() {
            let of_surface = self.totals_of(s, dt)?;
            let account = &mut self.ledger.surfaces;
            account.work_on_spheres += of_surface.power * dt;
            for (k, lost) in account.lost.iter_mut().enumerate() {
                *lost += of_surface.losses.at(k);
            }
            let surface = &mut self.system.surfaces[s];
            account.work += work(of_surface.force.total(), surface.velocity, Vec3::zero(), Vec3::zero(), dt);
            surface.force = of_surface.force.reversed();
            of_surface.store_contacts(&mut surface.contacts);
            surface.advance(dt);
        }
        Ok(())
    }

    /// Adds the forces of a surface to the loads on the spheres, with the springs of its contacts advanced by `dt`.
    pub(super) fn totals_of(&mut self, s: usize, dt: f64) -> Result<SurfaceTotals<M>, Halt> {
        let (model, particles, surface) = (&self.model, &self.system.particles, &self.system.surfaces[s]);
        let one = |block| surface_forces(model, (s, surface), particles, block, dt);
        let parts: Vec<SurfaceTotals<M>> = if self.blocks.len() < MANY {
            self.blocks.iter_mut().map(one).collect()
        } else {
            self.blocks.par_iter_mut().map(one).collect()
        };
        let of_surface = parts.into_iter().fold(SurfaceTotals::default(), SurfaceTotals::and);
        let (particle, ratio) = of_surface.deepest;
        let limit = self.settings.max_overlap;
        if ratio > limit { Err(self.halt(Reason::Sunk { particle, ratio, limit })) } else { Ok(of_surface) }
    }

    /// Shows force and torque of the surfaces in the next step on each sphere that they act on: its place, the arm from its centre to the surface, nm, and the
    /// load, pN and pN nm.
    pub fn each_load_by_surfaces(&self, mut show: impl FnMut(usize, Vec3<f64>, (Vec3<f64>, Vec3<f64>))) {
        let (particles, dt) = (&self.system.particles, self.settings.dt);
        let mut seen = Vec::new();
        for surface in &self.system.surfaces {
            for p in 0..particles.len() {
                let finder = (&mut NearTriangles::default(), &mut seen);
                each_touch(&self.model, surface, particles, p, finder, |at, touch, springs, share| {
                    let mut totals = SurfaceTotals::default();
                    let load = totals.enter(&self.model, surface, (particles.id[p], at, share), touch, springs, dt);
                    let [fx, fy, fz, tx, ty, tz, ..] = load.0;
                    show(p, -touch.n * (touch.r + touch.gap), (Vec3([fx, fy, fz]), Vec3([tx, ty, tz])));
                });
            }
        }
    }

    /// Energy stored at the surfaces, zJ, by cause.
    pub(super) fn stored_at_surfaces(&self) -> Vec<f64> {
        let mut sums = vec![0.0; M::Stored::<f64>::LEN];
        let mut seen = Vec::new();
        for surface in &self.system.surfaces {
            for p in 0..self.system.particles.len() {
                let finder = (&mut NearTriangles::default(), &mut seen);
                each_touch(&self.model, surface, &self.system.particles, p, finder, |_, touch, springs, share| {
                    let springs = springs.unwrap_or(Flat::from_fn(|_| 0.0));
                    let stored = self.model.surface_stored(surface.material, touch, &springs, share.value);
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
