//! A list of pairs with their constants and their history, and one step of it.

use crate::columns::KINEMATICS;
use crate::error::{Done, wrong};
use crate::law::{Breaks, constants, width};
use crate::necks;
use crate::spheres::{Spheres, Totals};
use crate::step::{MOST, Step};
use std::ffi::c_int;
use std::sync::Arc;
use veridem_spec::mechanics::friction_share::inertia_share;
use veridem_spec::mechanics::reduced_mass::effective_mass;
use veridem_spec::mechanics::sphere::moment_of_inertia;
use veridem_spec::numbers::Instructions;
use veridem_spec::{Contact, Flat, PairModel, Vec3};

/// Moment of inertia from which on a sphere cannot turn.
const FIXED: f64 = 1e300;

/// The neighbours of some spheres, by their places.
pub(crate) trait Neighbours {
    /// Shows every sphere with its neighbours.
    fn each(&self, show: &mut dyn FnMut(usize, &[c_int]));
    /// The bits of a neighbour that are its place.
    fn mask(&self) -> c_int;
}

/// A list of pairs of some law.
pub(crate) trait List {
    /// Lists pairs anew, all without history.
    fn build(&mut self, spheres: (usize, &[c_int]), neighbours: &dyn Neighbours) -> Done;
    /// The spheres of the pairs, the one with the lower id first.
    fn pairs(&self) -> [&[u32]; 2];
    /// The history of all pairs.
    fn history(&mut self) -> &mut [f64];
    /// Adds one to the number of contacts of each owned sphere for every pair that touches without a neck.
    fn count_contacts(&self, spheres: &Spheres, contacts: &mut [f64]) -> Done;
    /// Lets the pairs forget the springs that the law does not keep when they are listed anew.
    fn forget(&mut self, spheres: &Spheres, losses: &mut [f64]) -> Done;
    /// The pairs whose necks are loaded beyond their strength.
    fn overloaded(&mut self, spheres: &Spheres) -> Done<&[u32]>;
    /// Breaks the necks of some pairs; returns the energy lost.
    fn break_necks(&mut self, spheres: &Spheres, pairs: &[u32]) -> Done<f64>;
    /// Adds the forces of all pairs; advances their springs by `dt` if so wanted.
    fn step<'a>(&mut self, spheres: &mut Spheres<'a>, totals: &mut Totals<'a>, dt: f64, advance: bool) -> Done;
}

/// The pairs of a model.
pub(crate) struct Pairs<M: PairModel> {
    pub(crate) model: Arc<M>,
    pub(crate) breaks: Option<Breaks<M>>,
    count: usize,
    pub(crate) i: Vec<u32>,
    pub(crate) j: Vec<u32>,
    pub(crate) constants: Vec<M::Coefficients<f64>>,
    pub(crate) history: Vec<f64>,
    /// Pairs whose necks were overloaded when last examined.
    pub(crate) overloaded: Vec<u32>,
}

impl<M: PairModel> Pairs<M> {
    /// No pairs yet.
    pub(crate) fn new(model: Arc<M>, breaks: Option<Breaks<M>>) -> Self {
        let arguments = KINEMATICS + M::Coefficients::<f64>::LEN + M::Memory::<f64>::LEN;
        let results = 9 + M::Memory::<f64>::LEN + M::Losses::<f64>::LEN;
        assert!(
            arguments.max(results) <= MOST,
            "a law has {arguments} arguments and {results} results, at most {MOST} fit"
        );
        let (i, j, constants, history) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { model, breaks, count: 0, i, j, constants, history, overloaded: Vec::new() }
    }

    /// The constants of pairs that were just listed and given their history.
    fn find_constants(&mut self, spheres: &Spheres) {
        let mut last = None;
        for (pair, (&i, &j)) in self.i.iter().zip(&self.j).enumerate() {
            let (i, j) = (i as usize, j as usize);
            let of = [spheres.radius[i], spheres.radius[j], spheres.mass[i], spheres.mass[j]];
            let joined = self.history[pair * width::<M>()] > 0.5;
            let k = match last {
                Some((same, k)) if same == (of, joined) => k,
                _ => constants(&*self.model, of, joined),
            };
            last = Some(((of, joined), k));
            self.constants.push(k);
        }
    }

    /// The constants of a pair now, with what its friction may stop.
    pub(crate) fn constants_of(&self, pair: usize, spheres: &Spheres) -> M::Coefficients<f64> {
        let k = self.constants[pair];
        if !M::FRICTION_STOPS || spheres.moment.is_empty() {
            return k;
        }
        let share = |p: u32| {
            let p = p as usize;
            let given = spheres.moment[p];
            let moment = if given == 0.0 { moment_of_inertia(spheres.mass[p], spheres.radius[p]) } else { given };
            (moment < FIXED).then(|| inertia_share(moment, spheres.contacts[p]))
        };
        let reduced = match (share(self.i[pair]), share(self.j[pair])) {
            (Some(of_i), Some(of_j)) => effective_mass(of_i, of_j),
            (only, other) => only.or(other).unwrap_or(f64::INFINITY),
        };
        self.model.turning(k, reduced)
    }

    fn clear(&mut self) {
        self.i.clear();
        self.j.clear();
        self.constants.clear();
        self.history.clear();
    }

    fn check(&self, spheres: &Spheres) -> Done {
        let found = spheres.x.len();
        if found == self.count { Ok(()) } else { wrong(format!("found {found} spheres, listed were {}", self.count)) }
    }

    /// Checks the spheres, and finds the constants of pairs that were just listed.
    pub(crate) fn prepare(&mut self, spheres: &Spheres) -> Done {
        self.check(spheres)?;
        if self.constants.len() != self.i.len() {
            self.constants.clear();
            self.find_constants(spheres);
        }
        Ok(())
    }

    /// What a pair stores with this history.
    pub(crate) fn stored(&self, contact: &Contact<f64>, pair: usize, memory: &M::Memory<f64>) -> M::Stored<f64> {
        self.model.stored(contact, &self.constants[pair], memory)
    }

    /// The pair as the law sees it.
    pub(crate) fn contact(&self, spheres: &Spheres, pair: usize) -> Contact<f64> {
        let (i, j) = (self.i[pair] as usize, self.j[pair] as usize);
        let difference = |of: &[[f64; 3]]| Vec3(std::array::from_fn(|a| of[i][a] - of[j][a]));
        let (omega_i, omega_j) = (Vec3(spheres.omega[i]), Vec3(spheres.omega[j]));
        Contact::new(
            difference(spheres.x),
            difference(spheres.v),
            omega_i,
            omega_j,
            spheres.radius[i],
            spheres.radius[j],
        )
    }

    /// The share of a pair that is entered here: a pair with a ghost is listed once more where the ghost is owned.
    pub(crate) fn share(&self, spheres: &Spheres, pair: usize) -> f64 {
        let owned = |p: u32| (p as usize) < spheres.owned;
        if owned(self.i[pair]) && owned(self.j[pair]) { 1.0 } else { 0.5 }
    }

    /// The springs of a pair.
    pub(crate) fn memory(&self, pair: usize) -> M::Memory<f64> {
        Flat::from_fn(|k| self.history[pair * width::<M>() + 1 + k])
    }
}

impl<M: PairModel> List for Pairs<M> {
    fn build(&mut self, (owned, id): (usize, &[c_int]), neighbours: &dyn Neighbours) -> Done {
        let count = id.len();
        self.clear();
        self.count = count;
        let (mask, mut beyond) = (neighbours.mask(), None);
        neighbours.each(&mut |p, of_p| {
            for &q in of_p {
                let q = (q & mask) as usize;
                if p >= owned || q >= count || q == p {
                    beyond = Some((p, q));
                    continue;
                }
                let (i, j) = if id[p] <= id[q] { (p, q) } else { (q, p) };
                self.i.push(i as u32);
                self.j.push(j as u32);
            }
        });
        if let Some((p, q)) = beyond {
            self.clear();
            return wrong(format!("found the pair {p}, {q} of {owned} owned spheres and {count} in all"));
        }
        self.history.resize(self.i.len() * width::<M>(), 0.0);
        Ok(())
    }

    fn pairs(&self) -> [&[u32]; 2] {
        [&self.i, &self.j]
    }

    fn history(&mut self) -> &mut [f64] {
        // It may be changed, and with it the necks.
        self.constants.clear();
        &mut self.history
    }

    fn count_contacts(&self, spheres: &Spheres, contacts: &mut [f64]) -> Done {
        self.check(spheres)?;
        for (pair, (&i, &j)) in self.i.iter().zip(&self.j).enumerate() {
            let (i, j) = (i as usize, j as usize);
            let branch = Vec3(spheres.x[i]) - Vec3(spheres.x[j]);
            let reach = spheres.radius[i] + spheres.radius[j];
            if branch.dot(branch) < reach * reach && self.history[pair * width::<M>()] <= 0.5 {
                for p in [i, j].into_iter().filter(|&p| p < spheres.owned) {
                    contacts[p] += 1.0;
                }
            }
        }
        Ok(())
    }

    fn forget(&mut self, spheres: &Spheres, losses: &mut [f64]) -> Done {
        self.prepare(spheres)?;
        for pair in 0..self.i.len() {
            let (kept, lost) =
                self.model.relisted(&self.contact(spheres, pair), &self.constants[pair], self.memory(pair));
            let share = self.share(spheres, pair);
            let memory = &mut self.history[pair * width::<M>() + 1..][..M::Memory::<f64>::LEN];
            memory.iter_mut().enumerate().for_each(|(k, number)| *number = *kept.at(k));
            losses.iter_mut().enumerate().for_each(|(k, sum)| *sum += share * lost.at(k));
        }
        Ok(())
    }

    fn overloaded(&mut self, spheres: &Spheres) -> Done<&[u32]> {
        necks::overloaded(self, spheres)
    }

    fn break_necks(&mut self, spheres: &Spheres, pairs: &[u32]) -> Done<f64> {
        necks::break_necks(self, spheres, pairs)
    }

    fn step<'a>(&mut self, spheres: &mut Spheres<'a>, totals: &mut Totals<'a>, dt: f64, advance: bool) -> Done {
        self.prepare(spheres)?;
        Instructions::best().run(Step { pairs: self, spheres, totals, dt, advance })
    }
}
