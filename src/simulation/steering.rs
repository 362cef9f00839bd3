//! Springs at centres of mass.

use super::Simulation;
use crate::spec::mechanics::work::work as work_of;
use crate::spec::{PairModel, Vec3};

impl<M: PairModel> Simulation<M> {
    /// Adds the forces of springs at centres of mass to the loads on their spheres.
    pub(super) fn steer(&mut self) {
        let (particles, dt) = (&self.system.particles, self.settings.dt);
        for steering in &mut self.system.steerings {
            let (centre, mass) = steering.centre(particles);
            let work = steering.pull(centre, dt);
            self.ledger.work_loads += work;
            self.ledger.late_work -= work;
            for p in steering.places(particles) {
                let share = steering.force * (particles.mass[p] / mass);
                let number = self.blocks.partition_point(|block| block.own.end <= p);
                let block = &mut self.blocks[number];
                let load = &mut block.loads[p - block.own.start];
                for a in 0..3 {
                    load.0[a] += share.0[a];
                }
                self.ledger.late_work += work_of(share, particles.v[p], Vec3::zero(), Vec3::zero(), dt);
            }
        }
    }
}
