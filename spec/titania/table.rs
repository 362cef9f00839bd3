//! A function tabulated to a tolerance, for a fast evaluation of the attraction.

use crate::{Real, flat_struct};

/// A force against the distance of two centres that ends with a jump where its slope is infinite, such as that of a meniscus.
///
/// It consists of cells that are evenly spaced in the square root of the distance left before the end, which is where the first of them begins. In each it is the polynomial in this
/// root with the exact force and slope at both ends and in the middle. The potential is the exact integral of the polynomials, so energy is conserved as if they were the law.
#[derive(Clone, Debug)]
pub struct Table {
    piece: Piece<f64>,
    lists: Lists,
    error: f64,
}

flat_struct! {
    /// Position of a table's cells in a list, and the ends of the table.
    pub struct Piece {
        /// Distance beyond which the force is zero.
        pub end,
        /// Cells per root of the distance.
        pub per_width,
        /// Number of cells minus one.
        pub last,
        /// Place of the first cell in the list.
        pub first,
        /// Distance below which the force is a line.
        pub start,
        /// Force there.
        pub force,
        /// Slope of the line.
        pub slope,
        /// Energy where the line begins.
        pub energy,
    }
}

/// Nodes of a cell, its ends included: with three, the tables of many sizes are a third as large as with two.
const NODES: usize = 3;
/// Coefficients of a cell: a value and a slope at each node.
const LEN: usize = 2 * NODES;
/// The coefficients of a polynomial, from the constant up, in the place within a cell from 0 to 1.
type Polynomial<R> = [R; LEN];

/// The polynomials of the cells of tables, end to end, and the energy at the far end of each cell; as long as powers of two.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    cells: Vec<Polynomial<f64>>,
    energies: Vec<f64>,
}

impl Lists {
    fn new(cells: &[Polynomial<f64>], energies: &[f64]) -> Self {
        let mut lists = Self { cells: cells.to_vec(), energies: energies.to_vec() };
        lists.cells.resize(lists.cells.len().next_power_of_two(), [0.0; LEN]);
        lists.energies.resize(lists.energies.len().next_power_of_two(), 0.0);
        lists
    }

    /// Concatenates the lists of the tables and updates their pieces.
    pub fn join(tables: Vec<Table>) -> (Vec<Piece<f64>>, Self) {
        let (mut cells, mut energies, mut pieces) = (Vec::new(), Vec::new(), Vec::new());
        for Table { piece, lists, .. } in tables {
            pieces.push(Piece { first: cells.len() as f64, ..piece });
            let count = piece.last as usize + 1;
            cells.extend(&lists.cells[..count]);
            energies.extend(&lists.energies[..count]);
        }
        (pieces, Self::new(&cells, &energies))
    }
}

impl<R: Real> Piece<R> {
    /// The cell that contains a distance, and the position within it.
    #[inline(always)]
    fn place(&self, d: R) -> (R, R) {
        let place = (self.end - d).max(R::zero()).sqrt() * self.per_width;
        let cell = place.floor().min(self.last);
        (cell, place - cell)
    }

    #[inline(always)]
    fn polynomial(&self, lists: &Lists, cell: R) -> Polynomial<R> {
        R::entries(&lists.cells, self.first + cell)
    }

    /// Force at a given distance.
    #[inline(always)]
    pub fn force(&self, lists: &Lists, d: R) -> R {
        let (cell, t) = self.place(d);
        let inside = value(self.polynomial(lists, cell), t);
        let deep = self.force + self.slope * (d - self.start);
        R::select(d.lt(self.end), R::select(d.lt(self.start), deep, inside), R::zero())
    }

    /// Potential at a given distance, zero beyond the end.
    #[inline(always)]
    pub fn potential(&self, lists: &Lists, d: R) -> R {
        let (cell, t) = self.place(d);
        let beyond = R::entry(&lists.energies, self.first + cell);
        let inside = beyond + work(self.polynomial(lists, cell), cell, R::one() / self.per_width, t);
        let below = d - self.start;
        let deep = self.energy - below * (self.force + R::lit(0.5) * self.slope * below);
        R::select(d.lt(self.end), R::select(d.lt(self.start), deep, inside), R::zero())
    }
}

/// Largest number of cells of a table; a tolerance that requires more is not met.
const MOST_CELLS: usize = 1 << 14;
/// Number of cells of a table to begin with.
const FEWEST_CELLS: usize = 4;

impl Table {
    /// Tabulates from the distance `start` to `end` the function that `rooted` gives with its slope, both against the square root of what is left to
    /// `end`, so finely that [`Table::error`] is at most `tolerance`. Nearer than `start` the force is a line of the given `slope`.
    pub fn new(rooted: impl Fn(f64) -> (f64, f64), start: f64, end: f64, slope: f64, tolerance: f64) -> Self {
        let length = (end - start).sqrt();
        let mut count = FEWEST_CELLS;
        loop {
            let width = length / count as f64;
            let cells = cells(&rooted, width, count);
            let error = error(&rooted, width, &cells);
            if error <= tolerance || count >= MOST_CELLS {
                return Self::of(&cells, width, start, end, slope, error);
            }
            // the error goes with this power of the width
            let finer = 1.02 * libm::pow(error / tolerance, 1.0 / LEN as f64);
            count = (count as f64 * finer.min(8.0)).ceil() as usize;
        }
    }

    fn of(cells: &[Polynomial<f64>], width: f64, start: f64, end: f64, slope: f64, error: f64) -> Self {
        let mut energies = vec![0.0];
        for (k, &cell) in cells.iter().enumerate() {
            energies.push(energies[k] + work(cell, k as f64, width, 1.0));
        }
        let last = cells.len() - 1;
        let (force, energy) = (value(cells[last], 1.0), energies[cells.len()]);
        let (per_width, last) = (1.0 / width, last as f64);
        let piece = Piece { end, per_width, last, first: 0.0, start, force, slope, energy };
        Self { piece, lists: Lists::new(cells, &energies), error }
    }

    /// Twice the largest difference, where it is largest in each cell, between the table and the function it was made of from `start` on: more than what was found anywhere between.
    pub fn error(&self) -> f64 {
        self.error
    }
    /// Distance beyond which the force is zero.
    pub fn end(&self) -> f64 {
        self.piece.end
    }
    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.piece.last as usize + 1
    }
    /// Force at a given distance.
    pub fn force(&self, d: f64) -> f64 {
        self.piece.force(&self.lists, d)
    }
    /// Potential at a given distance, zero beyond the end.
    pub fn potential(&self, d: f64) -> f64 {
        self.piece.potential(&self.lists, d)
    }
}

/// The polynomials of all cells, with the values and slopes of the function at their nodes.
fn cells(rooted: &impl Fn(f64) -> (f64, f64), width: f64, count: usize) -> Vec<Polynomial<f64>> {
    let gap = 1.0 / (NODES - 1) as f64;
    let known: Vec<_> = (0..=count * (NODES - 1)).map(|k| rooted(k as f64 * gap * width)).collect();
    let scaled = |&(value, slope): &(f64, f64)| (value, slope * width);
    let of_cell = |k: usize| std::array::from_fn(|node| scaled(&known[k * (NODES - 1) + node]));
    (0..count).map(|k| hermite(of_cell(k), gap)).collect()
}

/// The polynomial with the values and slopes at nodes that are evenly spaced from 0 on, by Newton's divided differences with every node twice.
fn hermite(known: [(f64, f64); NODES], gap: f64) -> Polynomial<f64> {
    let node = |k: usize| (k / 2) as f64 * gap;
    let mut differences: Polynomial<f64> = std::array::from_fn(|k| known[k / 2].0);
    for order in 1..LEN {
        for k in (order..LEN).rev() {
            let slope = order == 1 && k % 2 == 1;
            let apart = node(k) - node(k - order);
            differences[k] = if slope { known[k / 2].1 } else { (differences[k] - differences[k - 1]) / apart };
        }
    }
    let mut powers = [0.0; LEN];
    for k in (0..LEN).rev() {
        // what there is times the distance from the node, plus the difference
        for n in (1..LEN).rev() {
            powers[n] = powers[n - 1] - node(k) * powers[n];
        }
        powers[0] = differences[k] - node(k) * powers[0];
    }
    powers
}

#[inline(always)]
fn value<R: Real>(powers: Polynomial<R>, t: R) -> R {
    let mut sum = powers[LEN - 1];
    for k in (0..LEN - 1).rev() {
        sum = powers[k] + t * sum;
    }
    sum
}

/// Integral of a polynomial over the distance, from the far end of its cell to the place `t` in it: the distance changes by twice the root.
#[inline(always)]
fn work<R: Real>(powers: Polynomial<R>, k: R, width: R, t: R) -> R {
    let over = |first: usize| std::array::from_fn(|n| powers[n] / R::lit((n + first) as f64));
    let (even, odd) = (t * value(over(1), t), t * t * value(over(2), t));
    R::lit(2.0) * width * width * (k * even + odd)
}

/// A bound of the error. The error of a Hermite polynomial is a derivative times the square of $t (t - 1/2) (t - 1)$, which is largest at
/// $1/2 \pm 1/\sqrt{12}$; where the derivative hardly changes within a cell, the error at one of these two places is the largest, and
/// twice the largest of all is a bound.
fn error(rooted: &impl Fn(f64) -> (f64, f64), width: f64, cells: &[Polynomial<f64>]) -> f64 {
    let at = |k: usize, t: f64| (value(cells[k], t) - rooted((k as f64 + t) * width).0).abs();
    let aside = 1.0 / 12f64.sqrt();
    2.0 * (0..cells.len()).map(|k| at(k, 0.5 - aside).max(at(k, 0.5 + aside))).fold(0.0, f64::max)
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::Titania;
    use proptest::prelude::*;
    use std::sync::LazyLock;

    const TOLERANCE: f64 = 1e-5;
    const SIZES: [f64; 4] = [3.0, 8.0, 14.0, 23.0];

    /// Pairs of sizes in nm and nN, law and table.
    static PAIRS: LazyLock<Vec<(crate::titania::Attraction<f64>, Table)>> = LazyLock::new(|| {
        let law = Titania::paper(1.0, 1.0, 1.0);
        let radius = |d: f64| law.contact_radius(d);
        let pairs = SIZES.iter().flat_map(|d_i| SIZES.iter().map(move |d_j| (*d_i, *d_j)));
        pairs
            .filter(|(d_i, d_j)| d_i <= d_j)
            .map(|(d_i, d_j)| {
                let (r_i, r_j) = (radius(d_i), radius(d_j));
                (law.attraction(r_i, r_j), law.table(r_i, r_j, TOLERANCE))
            })
            .collect()
    });

    proptest! {
        #[test]
        fn the_table_is_as_near_as_its_error_says(pair in 0..10usize, share in 0.0..1.0) {
            let (law, table) = &PAIRS[pair];
            prop_assert!(table.error() <= TOLERANCE);
            let d = law.kink() + share * (law.rupture() - law.kink());
            prop_assert!((table.force(d) - law.force(d)).abs() <= table.error(), "{} {}", table.force(d), law.force(d));
        }

        #[test]
        fn the_force_is_minus_the_gradient_of_the_potential(pair in 0..10usize, share in -0.3..0.999) {
            let (law, table) = &PAIRS[pair];
            let d = law.kink() + share * (law.rupture() - law.kink());
            let h = 1e-5;
            let gradient = (table.potential(d + h) - table.potential(d - h)) / (2.0 * h);
            prop_assert!((table.force(d) + gradient).abs() < 1e-3, "{} {gradient}", table.force(d));
        }

        #[test]
        fn potential_and_law_agree(pair in 0..10usize, share in 0.0..1.0) {
            let (law, table) = &PAIRS[pair];
            let d = law.kink() + share * (law.rupture() - law.kink());
            prop_assert!((table.potential(d) - law.potential(d)).abs() <= 2.0 * table.error() + 1e-9);
        }

        #[test]
        fn tighter_tolerances_are_met(exponent in -8..-2) {
            let tolerance = 10f64.powi(exponent);
            let table = Table::new(|u| (Real::exp(u) * Real::cos(5.0 * u), Real::exp(u) * (Real::cos(5.0 * u) - 5.0 * Real::sin(5.0 * u))), 0.0, 1.5, 0.0, tolerance);
            prop_assert!(table.error() <= tolerance);
            for k in 0..1000 {
                let d = 1.5 * (f64::from(k) + 0.5) / 1000.0;
                let u = Real::sqrt(1.5 - d);
                prop_assert!((table.force(d) - Real::exp(u) * Real::cos(5.0 * u)).abs() <= tolerance);
            }
        }
    }

    #[test]
    fn joined_tables_have_the_bits_of_each() {
        let tables: Vec<Table> = PAIRS.iter().map(|(_, table)| table.clone()).collect();
        let (pieces, lists) = Lists::join(tables.clone());
        for (table, piece) in tables.iter().zip(&pieces) {
            for k in -200..2000 {
                let d = table.end() - 1e-3 * f64::from(k);
                assert_eq!(piece.force(&lists, d), table.force(d));
                assert_eq!(piece.potential(&lists, d), table.potential(d));
            }
        }
    }

    #[test]
    fn beyond_the_end_nothing_is_left_of_force_and_potential() {
        for (_, table) in PAIRS.iter() {
            for d in [table.end(), table.end().next_up(), 2.0 * table.end()] {
                assert_eq!([table.force(d), table.potential(d)], [0.0; 2]);
            }
        }
    }

    #[test]
    fn a_constant_needs_no_more_than_the_first_cells_and_errors_of_either_sign_are_found() {
        let constant = Table::new(|_| (2.0, 0.0), 0.0, 1.5, 0.0, 0.0);
        assert_eq!((constant.cells(), constant.error()), (FEWEST_CELLS, 0.0));
        // the sixth derivative has one sign, and with it the difference between function and polynomials
        for sign in [1.0, -1.0] {
            let table = Table::new(|u| (sign * Real::exp(u), sign * Real::exp(u)), 0.0, 1.5, 0.0, 1e-12);
            assert!(
                table.cells() > FEWEST_CELLS && table.error() > 0.7e-12 && table.error() <= 1e-12,
                "{}",
                table.error()
            );
        }
    }

    #[test]
    fn the_error_is_twice_the_largest_difference_of_any_cell_on_either_side_of_its_middle() {
        let width = 0.5;
        for (tilt, weights) in [(0.0f64, [1.0, 0.0]), (0.4, [1.0, 2.0]), (-0.4, [3.0, 2.0])] {
            // Zero at the nodes, with its slope.
            let apart = |u: f64| {
                let (k, t) = ((u / width).floor(), (u / width).fract());
                let level = t * (t - 0.5) * (t - 1.0);
                (weights[k as usize] * level * level * (1.0 + tilt * (t - 0.5)), 0.0)
            };
            // The square is 1/432 at most, 0.28867 beside the middle.
            let largest = weights[0].max(weights[1]) * (1.0 + tilt.abs() * 0.288_675_134_594_812_9) / 432.0;
            let found = error(&apart, width, &[[0.0; LEN]; 2]);
            assert!((found / (2.0 * largest) - 1.0).abs() < 1e-12, "{found} {largest}");
        }
    }

    #[test]
    fn line_and_cells_meet() {
        for (_, table) in PAIRS.iter() {
            let start = table.piece.start;
            let [below, here, above] = [start.next_down(), start, start.next_up()];
            for [below, here, above] in
                [[below, here, above].map(|d| table.force(d)), [below, here, above].map(|d| table.potential(d))]
            {
                assert!((below - here).abs() < 1e-10 && (above - here).abs() < 1e-10, "{below} {here} {above}");
            }
            let slope = (table.force(start) - table.force(start - 1e-3)) / 1e-3;
            assert!((slope - table.piece.slope).abs() < 1e-9);
        }
    }

    #[test]
    fn a_table_is_as_fine_as_it_must_be_and_no_finer() {
        let waves = |tolerance: f64| {
            let rooted = |u: f64| (Real::cos(5.0 * u), -5.0 * Real::sin(5.0 * u));
            (rooted, Table::new(rooted, 0.0, 1.5, 0.0, tolerance))
        };
        assert_eq!([1.0, 0.0].map(|tolerance| waves(tolerance).1.cells()), [FEWEST_CELLS, MOST_CELLS]);
        for tolerance in [1e-8, 1e-9, 1e-10] {
            let (rooted, table) = waves(tolerance);
            assert!(table.error() > 0.7 * tolerance, "{} {tolerance}", table.error());
            let found = (0..20_000).map(|k| {
                let d = 1.5 * f64::from(k) / 20_000.0;
                (table.force(d) - rooted(Real::sqrt(1.5 - d)).0).abs()
            });
            let largest = found.fold(0.0, f64::max);
            assert!(largest > 0.45 * table.error() && largest < 0.6 * table.error(), "{largest} {}", table.error());
        }
    }

    #[test]
    fn the_end_is_the_rupture_and_the_start_continues_along_a_line() {
        for (law, table) in PAIRS.iter() {
            assert_eq!((table.end(), table.force(table.end())), (law.rupture(), 0.0));
            let last = table.end() * (1.0 - 1e-15);
            assert!((table.force(last) - law.rooted(0.0).0).abs() < 1e-5);
            let d = law.kink() - 0.1;
            assert!((table.force(d) - law.force(d)).abs() < 0.01, "{} {}", table.force(d), law.force(d));
            assert!(table.cells() < 300, "{}", table.cells());
        }
    }
}
