//! Pairs one by one, for observers.

use super::{Ledger, Simulation};
use crate::spec::{Contact, Flat, Outcome, PairModel, Vec3};
use crate::system::{Image, Particles};

/// One pair in range.
#[derive(Clone, Copy, Debug)]
pub struct Pair<M: PairModel> {
    /// Place of the sphere with the lower id.
    pub i: usize,
    /// Place of the other.
    pub j: usize,
    /// From the centre of `j` to that of `i`, nm.
    pub branch: Vec3<f64>,
    /// What they see of each other.
    pub contact: Contact<f64>,
    /// What they will do in the next step.
    pub outcome: Outcome<f64, M::Memory<f64>, M::Losses<f64>>,
    /// What the pair holds.
    pub stored: M::Stored<f64>,
}

impl<M: PairModel> Simulation<M> {
    /// All pairs in range, in an order that depends on the particles alone.
    pub fn pairs(&self) -> impl Iterator<Item = Pair<M>> + '_ {
        self.blocks.iter().flat_map(move |block| {
            let near = block.each_pair().map(move |(i, j, row, lane)| {
                let coefficients = Flat::from_fn(|k| block.pairs.constants(row).at(k).0[lane]);
                let memory = Flat::from_fn(|k| block.pairs.memory[row].at(k).0[lane]);
                (block.member(i), block.member(j), coefficients, memory)
            });
            let far = block.each_far().map(move |(i, j)| {
                let (i, j) = (block.member(i), block.member(j));
                let Particles { radius: r, mass: m, .. } = &self.system.particles;
                let coefficients = self.model.coefficients(r[i.0], r[j.0], m[i.0], m[j.0]);
                (i, j, coefficients, Flat::from_fn(|_| 0.0))
            });
            near.chain(far).filter_map(move |(end_i, end_j, coefficients, memory)| {
                let contact = self.contact(end_i, end_j);
                if contact.distance > self.model.range(contact.r_i, contact.r_j) {
                    return None;
                }
                let outcome = self.model.pair(&contact, &coefficients, memory, self.settings.dt);
                let stored = self.model.stored(&contact, &coefficients, &memory);
                Some(Pair { i: end_i.0, j: end_j.0, branch: contact.n * contact.distance, contact, outcome, stored })
            })
        })
    }

    /// What two spheres, each a place and a copy, see of each other.
    pub(super) fn contact(&self, (i, image_i): (usize, Image), (j, image_j): (usize, Image)) -> Contact<f64> {
        let (Particles { x, v, w, radius, .. }, domain) = (&self.system.particles, &self.system.domain);
        let branch = x[i] + domain.shift(image_i) - (x[j] + domain.shift(image_j));
        Contact::new(branch, v[i] - v[j], w[i], w[j], radius[i], radius[j])
    }

    /// Where the energy went, up to now.
    pub fn ledger(&self) -> Ledger {
        let mut ledger = Ledger { stored: self.stored(), ..self.ledger.clone() };
        ledger.surfaces.stored = self.stored_at_surfaces();
        ledger
    }

    /// What all pairs hold, zJ, by cause.
    pub(super) fn stored(&self) -> Vec<f64> {
        let mut sums = vec![0.0; M::Stored::<f64>::LEN];
        for pair in self.pairs() {
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum += pair.stored.at(k);
            }
        }
        sums
    }

    pub(super) fn open_ledger(&mut self) {
        let particles = &self.system.particles;
        let mut kinetic = 0.0;
        for p in (0..particles.len()).filter(|&p| particles.wall[p] == 0) {
            let (m, v, w) = (particles.mass[p], particles.v[p], particles.w[p]);
            kinetic += 0.5 * (m * v.dot(v) + crate::motion::inertia(particles, p) * w.dot(w));
            for a in 0..3 {
                self.momentum_flux[a] += m * v.0[a] * v.0[a];
            }
        }
        kinetic += self.system.walls.iter().map(crate::motion::kinetic_energy).sum::<f64>();
        self.ledger = Ledger {
            kinetic,
            kinetic_at_start: kinetic,
            stored_at_start: self.stored(),
            lost_by_pairs: vec![0.0; M::Losses::<f64>::LEN],
            surfaces: self.open_surface_account(),
            ..Ledger::default()
        };
    }
}
