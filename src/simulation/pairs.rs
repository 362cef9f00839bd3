//! Pairs one by one, for observers.

use super::shares::Shares;
use super::{Ledger, Simulation};
use crate::error::Halt;
use crate::forces::Block;
use crate::interrupt::Interrupt;
use crate::spec::mechanics::box_stress::momentum_flux;
use crate::spec::mechanics::kinetic_energy::kinetic_energy;
use crate::spec::{Contact, Flat, Outcome, PairModel, Vec3};
use crate::system::{Image, Particles};

/// Number of pairs between two questions whether to stop.
const ASKED: usize = 4096;

/// One pair in range, or joined by a neck.
#[derive(Clone, Copy, Debug)]
pub struct Pair<M: PairModel> {
    /// Index of the sphere with the lower id.
    pub i: usize,
    /// Index of the other sphere.
    pub j: usize,
    /// From the centre of `j` to that of `i`, nm.
    pub branch: Vec3<f64>,
    /// The contact kinematics.
    pub contact: Contact<f64>,
    /// The springs of the contact before that step.
    pub memory: M::Memory<f64>,
    /// The forces of the next step.
    pub outcome: Outcome<f64, M::Memory<f64>, M::Losses<f64>>,
    /// The energy stored in the pair.
    pub stored: M::Stored<f64>,
}

/// A pair in its block.
struct ListedPair<'a, M: PairModel> {
    block: &'a Block<M>,
    /// Row and lane; none for a far pair.
    near: Option<(usize, usize)>,
    /// Place and copy of the sphere with the lower id.
    i: (usize, Image),
    /// The same of the other.
    j: (usize, Image),
    contact: Contact<f64>,
    memory: M::Memory<f64>,
}

impl<M: PairModel> Simulation<M> {
    /// All pairs in range or joined by necks, in an order that depends on the particles alone.
    pub fn pairs(&self) -> impl Iterator<Item = Pair<M>> + '_ {
        let shares = self.shares();
        self.listed_pairs()
            .filter(|listed| self.acts(listed))
            .map(move |listed| self.evaluated(listed, shares.as_ref()))
    }

    /// The same pairs by the indices of their spheres, the sphere with the lower id first, with their contact kinematics and
    /// springs: much cheaper than [`pairs`](Self::pairs).
    pub fn contacts(&self) -> impl Iterator<Item = (usize, usize, Contact<f64>, M::Memory<f64>)> + '_ {
        let listed_pairs = self.listed_pairs().filter(|listed| self.acts(listed));
        listed_pairs.map(|ListedPair { i, j, contact, memory, .. }| (i.0, j.0, contact, memory))
    }

    fn evaluated(
        &self,
        ListedPair { block, near, i: (i, _), j: (j, _), contact, memory }: ListedPair<'_, M>,
        shares: Option<&Shares>,
    ) -> Pair<M> {
        let Particles { radius: r, mass: m, .. } = &self.system.particles;
        let coefficients = match near {
            Some((row, lane)) => Flat::from_fn(|k| block.pairs.constants(row).at(k).0[lane]),
            None => self.model.coefficients(r[i], r[j], m[i], m[j]),
        };
        let coefficients = match shares {
            Some(shares) => self.model.turning(coefficients, shares.reduced(&self.system, i, j)),
            None => coefficients,
        };
        let outcome = self.model.pair(&contact, &coefficients, memory, self.settings.dt);
        let stored = self.model.stored(&contact, &coefficients, &memory);
        Pair { i, j, branch: contact.n * contact.distance, contact, memory, outcome, stored }
    }

    /// Where the listed pairs are.
    fn listed_pairs(&self) -> impl Iterator<Item = ListedPair<'_, M>> + '_ {
        self.blocks.iter().flat_map(move |block| {
            let near = block.each_pair().map(|(i, j, row, lane)| (i, j, Some((row, lane))));
            let far = block.each_far().map(|(i, j)| (i, j, None));
            near.chain(far).map(move |(i, j, near)| {
                let (i, j) = (block.member(i), block.member(j));
                let memory = match near {
                    Some((row, lane)) => block.pairs.memory_of(row, lane),
                    None => Flat::from_fn(|_| 0.0),
                };
                ListedPair { block, near, i, j, contact: self.contact(i, j), memory }
            })
        })
    }

    /// A neck acts at any distance.
    fn acts(&self, ListedPair { i, j, contact, .. }: &ListedPair<'_, M>) -> bool {
        let joined = || {
            let (a, b, _) = self.bond(*i, *j);
            self.system.necks.binary_search(&(a, b)).is_ok()
        };
        contact.distance <= self.model.range(contact.r_i, contact.r_j) || joined()
    }

    /// The contact kinematics of two spheres, each given by index and copy.
    pub(super) fn contact(&self, (i, image_i): (usize, Image), (j, image_j): (usize, Image)) -> Contact<f64> {
        let (Particles { x, v, w, radius, .. }, domain) = (&self.system.particles, &self.system.domain);
        let branch = x[i] + domain.shift(image_i) - (x[j] + domain.shift(image_j));
        Contact::new(branch, v[i] - v[j], w[i], w[j], radius[i], radius[j])
    }

    /// The energy balance up to now.
    pub fn ledger(&self) -> Ledger {
        let mut ledger = Ledger { stored: self.stored(), ..self.ledger.clone() };
        ledger.surfaces.stored = self.stored_at_surfaces();
        ledger
    }

    /// Energy stored in all pairs, zJ, by cause, including pairs that have just left their range and whose springs are released in the next step.
    pub(super) fn stored(&self) -> Vec<f64> {
        self.stored_unless(&Interrupt::default()).expect("nothing asks to stop")
    }

    /// The same, unless it is to stop before.
    fn stored_unless(&self, interrupt: &Interrupt) -> Result<Vec<f64>, Halt> {
        let mut sums = vec![0.0; M::Stored::<f64>::LEN];
        let stretched = |listed: &ListedPair<M>| (0..M::Memory::<f64>::LEN).any(|k| *listed.memory.at(k) != 0.0);
        for (number, listed) in self.listed_pairs().enumerate() {
            if number.is_multiple_of(ASKED) {
                self.unless(interrupt)?;
            }
            if stretched(&listed) || self.acts(&listed) {
                let pair = self.evaluated(listed, None);
                for (k, sum) in sums.iter_mut().enumerate() {
                    *sum += pair.stored.at(k);
                }
            }
        }
        Ok(sums)
    }

    pub(super) fn open_ledger(&mut self, interrupt: &Interrupt) -> Result<(), Halt> {
        let particles = &self.system.particles;
        let mut kinetic = 0.0;
        let mut enter = |energy: f64, m: f64, v: Vec3<f64>| {
            kinetic += energy;
            for (sum, flux) in self.momentum_flux.iter_mut().zip(momentum_flux(m, v).0) {
                *sum += flux;
            }
        };
        for p in (0..particles.len()).filter(|&p| particles.wall[p] == 0 && particles.body[p] == 0) {
            let (m, v, w) = (particles.mass[p], particles.v[p], particles.w[p]);
            enter(kinetic_energy(m, v, crate::motion::inertia(particles, p), w), m, v);
        }
        for body in self.system.bodies.iter().filter(|body| body.wall == 0) {
            enter(body.kinetic(), body.mass, body.v);
        }
        kinetic += self.system.walls.iter().map(crate::motion::kinetic_energy).sum::<f64>();
        self.ledger = Ledger {
            kinetic,
            kinetic_at_start: kinetic,
            stored_at_start: self.stored_unless(interrupt)?,
            lost_by_pairs: vec![0.0; M::Losses::<f64>::LEN],
            surfaces: self.open_surface_account(),
            ..Ledger::default()
        };
        Ok(())
    }
}
