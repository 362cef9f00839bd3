//! A list of pairs with their constants and their history, and one step of it.

use crate::columns::KINEMATICS;
use crate::error::{Done, Trouble, wrong};
use crate::law::{constants, width};
use crate::spheres::{Spheres, Totals};
use std::ffi::c_int;
use std::sync::Arc;
use veridem_spec::columns::PairKernel;
use veridem_spec::equation::Kernel;
use veridem_spec::mechanics::friction_share::inertia_share;
use veridem_spec::mechanics::reduced_mass::effective_mass;
use veridem_spec::mechanics::sphere::moment_of_inertia;
use veridem_spec::numbers::{Instructions, Work};
use veridem_spec::{Contact, Flat, PairModel, Vec3};

/// How many pairs are evaluated together: several vectors side by side, which together stay in the first cache.
const WIDTH: usize = 32;
/// Largest number of arguments and of results of a law.
const MOST: usize = 48;
/// One number for each of the pairs that are evaluated together.
type Row = [f64; WIDTH];

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
    /// Adds the forces of all pairs; advances their springs by `dt` if so wanted.
    fn step<'a>(&mut self, spheres: &mut Spheres<'a>, totals: &mut Totals<'a>, dt: f64, advance: bool) -> Done;
}

/// The pairs of a model.
pub(crate) struct Pairs<M: PairModel> {
    model: Arc<M>,
    count: usize,
    i: Vec<u32>,
    j: Vec<u32>,
    constants: Vec<M::Coefficients<f64>>,
    history: Vec<f64>,
}

impl<M: PairModel> Pairs<M> {
    /// No pairs yet.
    pub(crate) fn new(model: Arc<M>) -> Self {
        let arguments = KINEMATICS + M::Coefficients::<f64>::LEN + M::Memory::<f64>::LEN;
        let results = 9 + M::Memory::<f64>::LEN + M::Losses::<f64>::LEN;
        assert!(
            arguments.max(results) <= MOST,
            "a law has {arguments} arguments and {results} results, at most {MOST} fit"
        );
        let (i, j, constants, history) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { model, count: 0, i, j, constants, history }
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
    fn constants_of(&self, pair: usize, spheres: &Spheres) -> M::Coefficients<f64> {
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

    #[inline(always)]
    fn gather(&self, spheres: &Spheres, input: &mut [Row; MOST], begin: usize, length: usize) {
        for place in 0..length {
            let pair = begin + place;
            let k = self.constants_of(pair, spheres);
            let (i, j) = (self.i[pair] as usize, self.j[pair] as usize);
            for a in 0..3 {
                input[a][place] = spheres.x[i][a] - spheres.x[j][a];
                input[3 + a][place] = spheres.v[i][a] - spheres.v[j][a];
                input[6 + a][place] = spheres.omega[i][a];
                input[9 + a][place] = spheres.omega[j][a];
            }
            input[12][place] = spheres.radius[i];
            input[13][place] = spheres.radius[j];
            let (kept, rest) = input[KINEMATICS..].split_at_mut(M::Coefficients::<f64>::LEN);
            let springs = &mut rest[..M::Memory::<f64>::LEN];
            for (n, column) in kept.iter_mut().enumerate() {
                column[place] = *k.at(n);
            }
            let memory = &self.history[pair * width::<M>() + 1..][..springs.len()];
            for (column, &number) in springs.iter_mut().zip(memory) {
                column[place] = number;
            }
        }
    }

    #[inline(always)]
    fn scatter(
        &mut self,
        spheres: &mut Spheres,
        totals: &mut Totals,
        (arguments, results): (&[Row; MOST], &[Row; MOST]),
        (begin, length): (usize, usize),
        advance: bool,
    ) -> Done {
        let springs = M::Memory::<f64>::LEN;
        for place in 0..length {
            let pair = begin + place;
            let (i, j) = (self.i[pair] as usize, self.j[pair] as usize);
            let force: [f64; 3] = std::array::from_fn(|a| results[a][place]);
            if !force.iter().all(|f| f.is_finite()) {
                let ids = (spheres.id[i], spheres.id[j]);
                return Err(Trouble::Domain(format!(
                    "the force between spheres {} and {} is not finite",
                    ids.0, ids.1
                )));
            }
            // Ghosts get nothing: the pair is listed once more where the ghost is owned.
            for (p, sign, torque) in [(i, 1.0, 3), (j, -1.0, 6)] {
                if p < spheres.owned {
                    for a in 0..3 {
                        spheres.force[p][a] += sign * force[a];
                        spheres.torque[p][a] += results[torque + a][place];
                    }
                }
            }
            let share = if i < spheres.owned && j < spheres.owned { 1.0 } else { 0.5 };
            if !totals.virial.is_empty() {
                let branch: [f64; 3] = std::array::from_fn(|a| arguments[a][place]);
                for (sum, (a, b)) in totals.virial.iter_mut().zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]) {
                    *sum += share * branch[a] * force[b];
                }
            }
            if advance {
                let memory = &mut self.history[pair * width::<M>() + 1..][..springs];
                for (number, column) in memory.iter_mut().zip(&results[9..]) {
                    *number = column[place];
                }
                for (sum, column) in totals.losses.iter_mut().zip(&results[9 + springs..]) {
                    *sum += share * column[place];
                }
            }
            if !totals.stored.is_empty() {
                let vector = |first: usize| Vec3(std::array::from_fn(|a| arguments[first + a][place]));
                let [x, v, omega_i, omega_j] = [vector(0), vector(3), vector(6), vector(9)];
                let contact = Contact::new(x, v, omega_i, omega_j, spheres.radius[i], spheres.radius[j]);
                let memory = Flat::from_fn(|k| self.history[pair * width::<M>() + 1 + k]);
                let stored = self.model.stored(&contact, &self.constants[pair], &memory);
                for (k, sum) in totals.stored.iter_mut().enumerate() {
                    *sum += share * *stored.at(k);
                }
            }
        }
        Ok(())
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
}

/// A step of all pairs of a list.
struct Step<'a, 'b, M: PairModel> {
    pairs: &'a mut Pairs<M>,
    spheres: &'a mut Spheres<'b>,
    totals: &'a mut Totals<'b>,
    dt: f64,
    advance: bool,
}

impl<M: PairModel> Work for Step<'_, '_, M> {
    type Outcome = Done;

    #[inline(always)]
    fn run(self) -> Done {
        let Self { pairs, spheres, totals, dt, advance } = self;
        let model = pairs.model.clone();
        let kernel = PairKernel { model: &*model, dt };
        let (mut input, mut output) = ([[0.0; WIDTH]; MOST], [[0.0; WIDTH]; MOST]);
        for begin in (0..pairs.i.len()).step_by(WIDTH) {
            let length = WIDTH.min(pairs.i.len() - begin);
            pairs.gather(spheres, &mut input, begin, length);
            // Beyond the end of the list it evaluates what the row before has left there.
            for lane in 0..WIDTH {
                let (mut taken, mut given) = (0, 0);
                let mut from = || {
                    taken += 1;
                    input[taken - 1][lane]
                };
                let mut to = |number| {
                    given += 1;
                    output[given - 1][lane] = number;
                };
                kernel.apply(&mut from, &mut to);
            }
            pairs.scatter(spheres, totals, (&input, &output), (begin, length), advance)?;
        }
        Ok(())
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

    fn step<'a>(&mut self, spheres: &mut Spheres<'a>, totals: &mut Totals<'a>, dt: f64, advance: bool) -> Done {
        self.check(spheres)?;
        if self.constants.len() != self.i.len() {
            self.constants.clear();
            self.find_constants(spheres);
        }
        Instructions::best().run(Step { pairs: self, spheres, totals, dt, advance })
    }
}
