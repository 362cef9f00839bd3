//! Shares of the moment of inertia of a sphere, or of its body, that are assigned to its contacts. Friction may stop a rotating sphere or body, but
//! several contacts together must not reverse it. Only the contacts that touch at this instant share it, whatever pairs the neighbour list holds.

use super::Simulation;
use crate::forces::{Block, Touchable};
use crate::motion;
use crate::spec::mechanics::friction_share::inertia_share;
use crate::spec::mechanics::reduced_mass::effective_mass;
use crate::spec::{PairModel, Vec3};
use crate::system::{Image, Particles, System};
use rayon::prelude::*;

/// Number of contacts of each single sphere and of each body.
#[derive(PartialEq)]
pub(super) struct Shares {
    contacts: Vec<u32>,
}

/// The index of a sphere, or of its body, in the counts: single spheres come after the bodies.
fn turning(System { particles, bodies, .. }: &System, p: usize) -> usize {
    (particles.body[p] as usize).checked_sub(1).unwrap_or(bodies.len() + p)
}

impl Shares {
    /// Counts the contacts without necks.
    pub(super) fn count<M: PairModel>(blocks: &[Block<M>], system: &System) -> Self {
        let touching = |block: &Block<M>| -> Vec<[usize; 2]> {
            let ends = |pair: &Touchable| [block.member(pair.i), block.member(pair.j)];
            let touching = block.touchable.iter().map(ends).filter(|&[i, j]| touch(system, i, j));
            touching.map(|[(p, _), (q, _)]| [p, q]).collect()
        };
        let touching: Vec<_> = blocks.par_iter().with_max_len(1).map(touching).collect();
        let mut contacts = vec![0; system.bodies.len() + system.particles.len()];
        for p in touching.into_iter().flatten().flatten() {
            contacts[turning(system, p)] += 1;
        }
        Self { contacts }
    }

    /// The share of the moment of inertia of a contact of a sphere, ag nm^2; none for the spheres of a wall.
    fn of(&self, system: &System, p: usize) -> Option<f64> {
        let System { particles, bodies, .. } = system;
        let least = |moments: Vec3<f64>| moments.0.into_iter().fold(f64::INFINITY, f64::min);
        let moment = match particles.body[p] as usize {
            0 => motion::inertia(particles, p),
            body => least(bodies[body - 1].moments),
        };
        (particles.wall[p] == 0).then(|| inertia_share(moment, f64::from(self.contacts[turning(system, p)])))
    }

    /// The reduced moment of inertia of the contact of two spheres.
    pub(super) fn reduced(&self, system: &System, p: usize, q: usize) -> f64 {
        match (self.of(system, p), self.of(system, q)) {
            (Some(of_p), Some(of_q)) => effective_mass(of_p, of_q),
            (only, other) => only.or(other).unwrap_or(f64::INFINITY),
        }
    }
}

/// Whether two spheres touch, each given by index and copy.
fn touch(System { particles, domain, .. }: &System, (p, a): (usize, Image), (q, b): (usize, Image)) -> bool {
    let Particles { x, radius, .. } = particles;
    let branch = x[p] + domain.shift(a) - (x[q] + domain.shift(b));
    let reach = radius[p] + radius[q];
    branch.dot(branch) < reach * reach
}

impl<M: PairModel> Simulation<M> {
    /// Updates the shares of the contacts before these are evaluated.
    pub(super) fn share(&mut self) {
        if !M::FRICTION_STOPS {
            return;
        }
        let shares = Shares::count(&self.blocks, &self.system);
        // A contact that comes or goes changes the count of its spheres.
        if self.shared.as_ref() == Some(&shares) {
            return;
        }
        let (model, system) = (&self.model, &self.system);
        self.blocks.par_iter_mut().with_max_len(1).for_each(|block| {
            for k in 0..block.touchable.len() {
                let Touchable { i, j, row, lane } = block.touchable[k];
                let moment = shares.reduced(system, block.member(i).0, block.member(j).0);
                block.pairs.change_constants(row, lane, |constants| model.turning(constants, moment));
            }
        });
        self.shared = Some(shares);
    }

    /// The shares of the pairs as they will be in the next step.
    pub(super) fn shares(&self) -> Option<Shares> {
        M::FRICTION_STOPS.then(|| Shares::count(&self.blocks, &self.system))
    }
}
