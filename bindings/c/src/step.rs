//! One step of a list of pairs, a row of them at a time.

use crate::columns::KINEMATICS;
use crate::error::{Done, Trouble};
use crate::law::width;
use crate::list::Pairs;
use crate::spheres::{Spheres, Totals};
use veridem_spec::columns::PairKernel;
use veridem_spec::equation::Kernel;
use veridem_spec::numbers::Work;
use veridem_spec::{Contact, Flat, PairModel, Vec3};

/// How many pairs are evaluated together: several vectors side by side, which together stay in the first cache.
const WIDTH: usize = 32;
/// Largest number of arguments and of results of a law.
pub(crate) const MOST: usize = 48;
/// One number for each of the pairs that are evaluated together.
type Row = [f64; WIDTH];

impl<M: PairModel> Pairs<M> {
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
            let share = self.share(spheres, pair);
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
                let stored = self.stored(&contact, pair, &self.memory(pair));
                for (k, sum) in totals.stored.iter_mut().enumerate() {
                    *sum += share * *stored.at(k);
                }
            }
        }
        Ok(())
    }
}

/// A step of all pairs of a list.
pub(crate) struct Step<'a, 'b, M: PairModel> {
    pub(crate) pairs: &'a mut Pairs<M>,
    pub(crate) spheres: &'a mut Spheres<'b>,
    pub(crate) totals: &'a mut Totals<'b>,
    pub(crate) dt: f64,
    pub(crate) advance: bool,
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
