//! Shares of the moment of inertia of a sphere, or of its body, that are assigned to its contacts. Friction may stop a rotating sphere or body, but
//! several contacts together must not reverse it. Only the contacts that touch at this instant share it, whatever pairs the neighbour list holds.

use super::Simulation;
use crate::forces::{Block, Touchable, prefetch};
use crate::motion;
use crate::spec::mechanics::friction_share::inertia_share;
use crate::spec::mechanics::reduced_mass::effective_mass;
use crate::spec::{PairModel, Vec3};
use crate::system::{Particles, System};
use rayon::prelude::*;

/// Number of contacts of each single sphere and of each body.
#[derive(Default)]
pub(super) struct Shares {
    contacts: Vec<u32>,
    /// No gap has changed by more than this since neighbours were listed, nm.
    pub strayed: f64,
}

/// The index of a sphere, or of its body, in the counts: single spheres come after the bodies.
fn turning(System { particles, bodies, .. }: &System, p: u32) -> usize {
    (particles.body[p as usize] as usize).checked_sub(1).unwrap_or(bodies.len() + p as usize)
}

/// Number of those.
fn count_turning(System { particles, bodies, .. }: &System) -> usize {
    bodies.len() + particles.len()
}

impl Shares {
    /// Counts the contacts without necks.
    fn count<M: PairModel>(blocks: &[Block<M>], system: &System) -> Self {
        let mut contacts = vec![0; count_turning(system)];
        for pair in blocks.iter().flat_map(|block| &block.touchable).filter(|pair| touch(system, pair)) {
            for (p, _) in pair.spheres {
                contacts[turning(system, p)] += 1;
            }
        }
        Self { contacts, strayed: 0.0 }
    }

    /// The share of the moment of inertia of a contact of a sphere, ag nm^2; none for the spheres of a wall.
    fn of(&self, system: &System, p: usize) -> Option<f64> {
        let System { particles, bodies, .. } = system;
        let least = |moments: Vec3<f64>| moments.0.into_iter().fold(f64::INFINITY, f64::min);
        let moment = match particles.body[p] as usize {
            0 => motion::inertia(particles, p),
            body => least(bodies[body - 1].moments),
        };
        (particles.wall[p] == 0).then(|| inertia_share(moment, f64::from(self.contacts[turning(system, p as u32)])))
    }

    /// The reduced moment of inertia of the contact of two spheres.
    pub(super) fn reduced(&self, system: &System, p: usize, q: usize) -> f64 {
        match (self.of(system, p), self.of(system, q)) {
            (Some(of_p), Some(of_q)) => effective_mass(of_p, of_q),
            (only, other) => only.or(other).unwrap_or(f64::INFINITY),
        }
    }
}

/// Whether two spheres touch.
fn touch(System { particles, domain, .. }: &System, Touchable { spheres, .. }: &Touchable) -> bool {
    let Particles { x, radius, .. } = particles;
    let [(p, a), (q, b)] = spheres.map(|(p, image)| (p as usize, image));
    let here = a == [0; 3] && b == [0; 3];
    let branch = if here { x[p] - x[q] } else { x[p] + domain.shift(a) - (x[q] + domain.shift(b)) };
    let reach = radius[p] + radius[q];
    branch.dot(branch) < reach * reach
}

/// Number of pairs from the request for their spheres to their use.
const AHEAD: usize = 8;
/// Rounding of coordinates, nm.
const ROUNDING: f64 = 1e-6;

/// The contacts that came or went since contacts were counted last.
fn changes<M: PairModel>(block: &mut Block<M>, system: &System, strayed: f64, all: bool) -> Vec<Touchable> {
    let mut changes = Vec::new();
    let due = if all {
        block.touchable.len()
    } else {
        block.touchable.partition_point(|pair| pair.margin <= strayed + ROUNDING)
    };
    for k in 0..due {
        if let Some(ahead) = block.touchable.get(k + AHEAD) {
            for (p, _) in ahead.spheres {
                prefetch(&system.particles.x[p as usize]);
                prefetch(&system.particles.radius[p as usize]);
            }
        }
        let pair = &mut block.touchable[k];
        let touches = touch(system, pair);
        if touches != pair.touches {
            pair.touches = touches;
            changes.push(*pair);
        }
    }
    changes
}

impl<M: PairModel> Simulation<M> {
    /// Updates the shares of the contacts before these are evaluated: of those that share a sphere or a body with one that came or went.
    pub(super) fn share(&mut self) {
        if !M::FRICTION_STOPS {
            return;
        }
        let (model, system, shares) = (&self.model, &self.system, &mut self.shares);
        // The first evaluation of a neighbour list tests every pair, later ones those whose gap may have changed enough.
        let (strayed, all) = (shares.strayed, shares.contacts.is_empty());
        let blocks = self.blocks.par_iter_mut().with_max_len(1);
        let changes: Vec<_> = blocks.map(|block| changes(block, system, strayed, all)).collect();
        shares.contacts.resize(count_turning(system), 0);
        if changes.iter().all(Vec::is_empty) {
            return;
        }
        let mut changed = vec![false; shares.contacts.len()];
        for Touchable { spheres, touches, .. } in changes.into_iter().flatten() {
            for end in spheres.map(|(p, _)| turning(system, p)) {
                shares.contacts[end] = if touches { shares.contacts[end] + 1 } else { shares.contacts[end] - 1 };
                changed[end] = true;
            }
        }
        self.blocks.par_iter_mut().with_max_len(1).for_each(|block| {
            let Block { touchable, pairs, .. } = block;
            for &Touchable { spheres: [(p, _), (q, _)], row, lane, .. } in touchable.iter().filter(|pair| pair.touches)
            {
                if changed[turning(system, p)] || changed[turning(system, q)] {
                    let moment = shares.reduced(system, p as usize, q as usize);
                    pairs.change_constants(row as usize, lane.into(), |constants| model.turning(constants, moment));
                }
            }
        });
    }

    /// The shares of the pairs as they will be in the next step.
    pub(super) fn shares(&self) -> Option<Shares> {
        M::FRICTION_STOPS.then(|| Shares::count(&self.blocks, &self.system))
    }
}
