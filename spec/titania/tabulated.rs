//! The contact law for many particles of a few sizes: the attraction of every pair of sizes is tabulated.

use super::law::{Act, Held, Lost, Parameters, Titania};
use super::table::{Lists, Piece};
use crate::{Contact, Flat, PairModel, Real, Turns, Vec3};

/// The contact law with its attraction in tables.
#[derive(Clone, Debug)]
pub struct Tabulated {
    law: Titania,
    /// Half-way between each radius and the next.
    borders: Vec<f64>,
    /// For every two sizes what a pair of them needs, `WIDTH` numbers each; as long as a power of two.
    numbers: Vec<f64>,
    lists: Lists,
    error: f64,
}

/// Numbers of a pair of sizes: the piece, the contact stiffness, the range.
const WIDTH: usize = Piece::<f64>::LEN + 2;
const STIFFNESS: usize = Piece::<f64>::LEN;
const RANGE: usize = STIFFNESS + 1;

impl Tabulated {
    /// The law for contact spheres of these radii, in ascending order, with tables whose error is at most `tolerance`.
    ///
    /// # Panics
    ///
    /// If there is no radius.
    pub fn new(law: Titania, radii: &[f64], tolerance: f64) -> Self {
        let sizes = || radii.iter().flat_map(|&r_i| radii.iter().map(move |&r_j| (r_i, r_j)));
        let tables: Vec<_> =
            sizes().filter(|(r_i, r_j)| r_i <= r_j).map(|(r_i, r_j)| law.table(r_i, r_j, tolerance)).collect();
        let error = tables.iter().map(|table| table.error()).fold(0.0, f64::max);
        let (pieces, lists) = Lists::join(tables);
        let mut upper = pieces.iter();
        let mut of = vec![None; radii.len() * radii.len()];
        for i in 0..radii.len() {
            for j in i..radii.len() {
                let piece = upper.next();
                (of[i * radii.len() + j], of[j * radii.len() + i]) = (piece, piece);
            }
        }
        let mut numbers = Vec::new();
        for (piece, (r_i, r_j)) in of.into_iter().zip(sizes()) {
            let piece = piece.expect("a table for every two sizes");
            numbers.extend((0..Piece::<f64>::LEN).map(|k| *piece.at(k)));
            numbers.extend([law.stiffness(r_i, r_j), piece.end.max(r_i + r_j)]);
        }
        numbers.resize(numbers.len().next_power_of_two(), 0.0);
        let borders = radii.windows(2).map(|r| 0.5 * (r[0] + r[1])).collect();
        Self { law, borders, numbers, lists, error }
    }

    /// The law without tables.
    pub fn law(&self) -> &Titania {
        &self.law
    }

    /// The largest [error](super::table::Table::error) of any table. Nearer than its kink the attraction is a line, which is farther from
    /// the law: by 0.4 pN 0.05 nm nearer, by 24 pN 0.4 nm nearer, where two particles of 3 nm press each other with 10 to 20 nN.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Index of the size of a radius.
    fn size<R: Real>(&self, r: R) -> R {
        self.borders.iter().fold(R::zero(), |size, &border| size + R::select(r.gt(R::lit(border)), R::one(), R::zero()))
    }

    /// A number of a pair of sizes.
    fn number<R: Real>(&self, r_i: R, r_j: R) -> impl Fn(usize) -> R {
        let sizes = R::lit((self.borders.len() + 1) as f64);
        let begin = (self.size(r_i) * sizes + self.size(r_j)) * R::lit(WIDTH as f64);
        move |k| R::entry(&self.numbers, begin + R::lit(k as f64))
    }
}

impl PairModel for Tabulated {
    type Coefficients<R: Real> = (Parameters<R>, Piece<R>);
    type Memory<R: Real> = Vec3<R>;
    type Losses<R: Real> = Lost<R>;
    type Stored<R: Real> = Held<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Self::Coefficients<R> {
        let number = self.number(r_i, r_j);
        (self.law.parameters_with(number(STIFFNESS), r_i, r_j, m_i, m_j), Piece::from_fn(number))
    }

    const FRICTION_STOPS: bool = true;

    fn turning<R: Real>(&self, (contact, piece): Self::Coefficients<R>, inertia: R) -> Self::Coefficients<R> {
        (Parameters { inertia: self.law.stoppable(inertia), ..contact }, piece)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.number(r_i, r_j)(RANGE)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        (contact, piece): &Self::Coefficients<R>,
        spring: Vec3<R>,
        dt: R,
    ) -> Act<R> {
        let f_na = || piece.force(&self.lists, c.distance);
        self.law.act(contact, self.law.arms.of(c, self.law.h_n), c, f_na, spring, dt)
    }

    fn stored<R: Real>(&self, c: &Contact<R>, (contact, piece): &Self::Coefficients<R>, spring: &Vec3<R>) -> Held<R> {
        self.law.held(contact, c, piece.potential(&self.lists, c.distance), spring)
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        self.law.critical_time_step(r, m)
    }
}

impl Turns for Tabulated {
    #[inline(always)]
    fn turned<R: Real>(spring: Vec3<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Vec3<R> {
        turn(spring)
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Lanes};
    use proptest::prelude::*;
    use std::sync::LazyLock;

    const DIAMETERS: [f64; 3] = [3.0, 9.0, 23.0];
    const TOLERANCE: f64 = 1e-4;

    static MODEL: LazyLock<Tabulated> = LazyLock::new(|| {
        let law = Titania::paper(1.0, 1.0, 1.0);
        Tabulated::new(law, &DIAMETERS.map(|d| law.contact_radius(d)), TOLERANCE)
    });

    fn contact<R: Real>(r_i: f64, r_j: f64, d: R) -> Contact<R> {
        let across = Vec3::new(R::lit(0.3), R::lit(-0.1), R::lit(0.2));
        Contact::new(Vec3::new(d, R::zero(), R::zero()), across, across, -across, R::lit(r_i), R::lit(r_j))
    }
    fn radius(size: usize) -> f64 {
        MODEL.law().contact_radius(DIAMETERS[size])
    }

    proptest! {
        #[test]
        fn does_what_the_law_does_within_the_tolerance(i in 0..3usize, j in 0..3usize, beyond in -0.2..1.5) {
            let (law, r_i, r_j) = (MODEL.law(), radius(i), radius(j));
            let c = contact(r_i, r_j, law.equilibrium(r_i, r_j) + beyond);
            let (exact, fast) = (law.coefficients(r_i, r_j, 1.0, 2.0), MODEL.coefficients(r_i, r_j, 1.0, 2.0));
            let spring = Vec3::new(0.0, 0.1, 0.2);
            let (exact, fast) = (law.pair(&c, &exact, spring, 0.1), MODEL.pair(&c, &fast, spring, 0.1));
            prop_assert!(MODEL.error() <= TOLERANCE);
            prop_assert!((exact.wrench.force - fast.wrench.force).norm() <= TOLERANCE);
            prop_assert_eq!(exact.wrench.torque_i, fast.wrench.torque_i);
            prop_assert_eq!(exact.memory, fast.memory);
            prop_assert_eq!(law.range(r_i, r_j), MODEL.range(r_i, r_j));
        }

        #[test]
        fn the_normal_force_is_minus_the_gradient_of_what_is_stored(i in 0..3usize, j in 0..3usize, beyond in -0.2..0.8) {
            let (r_i, r_j) = (radius(i), radius(j));
            let d = MODEL.law().equilibrium(r_i, r_j) + beyond;
            let still = |d: Dual| Contact { v: Vec3::zero(), ..contact(r_i, r_j, d) };
            let k = MODEL.coefficients(Dual::constant(r_i), Dual::constant(r_j), Dual::constant(1.0), Dual::constant(1.0));
            let c = still(Dual::variable(d));
            let held = MODEL.stored(&c, &k, &Vec3::zero());
            let force = MODEL.pair(&c, &k, Vec3::zero(), Dual::constant(0.0)).wrench.force.0[0].value;
            let slope = held.repulsion.slope + held.attraction.slope;
            prop_assert!((force + slope).abs() < 1e-9 * (1.0 + force.abs()), "{force} {slope}");
        }

        #[test]
        fn eight_pairs_at_once_have_the_bits_of_one(places in prop::array::uniform8(-0.2..1.5)) {
            let (r_i, r_j) = (radius(1), radius(2));
            let d = places.map(|beyond: f64| MODEL.law().equilibrium(r_i, r_j) + beyond);
            let lanes = Lanes::<8>::lit;
            let k = MODEL.coefficients(lanes(r_i), lanes(r_j), lanes(1.0), lanes(2.0));
            let together = MODEL.pair(&contact(r_i, r_j, Lanes(d)), &k, Vec3::zero(), lanes(0.1)).wrench.force;
            let k = MODEL.coefficients(r_i, r_j, 1.0, 2.0);
            for (lane, d) in d.into_iter().enumerate() {
                let alone = MODEL.pair(&contact(r_i, r_j, d), &k, Vec3::zero(), 0.1).wrench.force;
                prop_assert_eq!(alone, Vec3(together.0.map(|component| component.0[lane])));
            }
        }
    }
}
