//! A function tabulated to a tolerance, for a fast evaluation of the attraction.

use crate::{Real, flat_struct};

/// A force against the distance of two centres that ends with a jump where its slope is infinite, such as that of a meniscus.
///
/// Between the nodes it is a cubic in the square root of the distance left before the end, evenly spaced, with the force and its slope exact at the nodes.
/// The last node is the end itself. The potential is the exact integral of the cubics, so energy is conserved as if they were the law.
#[derive(Clone, Debug)]
pub struct Table {
    piece: Piece<f64>,
    lists: Lists,
    error: f64,
}

flat_struct! {
    /// Position of a table's cubics in a list, and the ends of the table.
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

/// The cubics of tables, end to end, four numbers a cell, and the energy at the far end of each cell; as long as powers of two.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    cells: Vec<f64>,
    energies: Vec<f64>,
}

impl Lists {
    fn new(cells: &[[f64; 4]], energies: &[f64]) -> Self {
        let mut lists = Self { cells: cells.concat(), energies: energies.to_vec() };
        lists.cells.resize(lists.cells.len().next_power_of_two(), 0.0);
        lists.energies.resize(lists.energies.len().next_power_of_two(), 0.0);
        lists
    }

    /// Concatenates the lists of the tables and updates their pieces.
    pub fn join(tables: Vec<Table>) -> (Vec<Piece<f64>>, Self) {
        let (mut cells, mut energies, mut pieces) = (Vec::new(), Vec::new(), Vec::new());
        for Table { piece, lists, .. } in tables {
            pieces.push(Piece { first: cells.len() as f64, ..piece });
            let count = piece.last as usize + 1;
            cells.extend(lists.cells[..4 * count].chunks(4).map(|cell| [cell[0], cell[1], cell[2], cell[3]]));
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
    fn cubic(&self, lists: &Lists, cell: R) -> [R; 4] {
        let begin = (self.first + cell) * R::lit(4.0);
        let coefficient = |k| R::entry(&lists.cells, begin + R::lit(k));
        // one by one: in a loop over a pair's coefficients the compiler loses the loop over pairs
        [coefficient(0.0), coefficient(1.0), coefficient(2.0), coefficient(3.0)]
    }

    /// Force at a given distance.
    #[inline(always)]
    pub fn force(&self, lists: &Lists, d: R) -> R {
        let (cell, t) = self.place(d);
        let inside = cubic(self.cubic(lists, cell), t);
        let deep = self.force + self.slope * (d - self.start);
        R::select(d.lt(self.end), R::select(d.lt(self.start), deep, inside), R::zero())
    }

    /// Potential at a given distance, zero beyond the end.
    #[inline(always)]
    pub fn potential(&self, lists: &Lists, d: R) -> R {
        let (cell, t) = self.place(d);
        let beyond = R::entry(&lists.energies, self.first + cell);
        let inside = beyond + work(self.cubic(lists, cell), cell, R::one() / self.per_width, t);
        let below = d - self.start;
        let deep = self.energy - below * (self.force + R::lit(0.5) * self.slope * below);
        R::select(d.lt(self.end), R::select(d.lt(self.start), deep, inside), R::zero())
    }
}

/// Largest number of cells of a table; a tolerance that requires more is not met.
const MOST_CELLS: usize = 1 << 16;

impl Table {
    /// Tabulates from the distance `start` to `end` the function that `rooted` gives with its slope, both against the square root of what is left to
    /// `end`, so finely that [`Table::error`] is at most `tolerance`. Nearer than `start` the force is a line of the given `slope`.
    pub fn new(rooted: impl Fn(f64) -> (f64, f64), start: f64, end: f64, slope: f64, tolerance: f64) -> Self {
        let length = (end - start).sqrt();
        let mut count = 16;
        loop {
            let width = length / count as f64;
            let cells = cells(&rooted, width, count);
            let error = error(&rooted, width, &cells);
            if error <= tolerance || count >= MOST_CELLS {
                return Self::of(&cells, width, start, end, slope, error);
            }
            // the error goes with the fourth power of the width
            let finer = 1.05 * (error / tolerance).sqrt().sqrt();
            count = (count as f64 * finer.min(8.0)).ceil() as usize;
        }
    }

    fn of(cells: &[[f64; 4]], width: f64, start: f64, end: f64, slope: f64, error: f64) -> Self {
        let mut energies = vec![0.0];
        for (k, &cell) in cells.iter().enumerate() {
            energies.push(energies[k] + work(cell, k as f64, width, 1.0));
        }
        let last = cells.len() - 1;
        let (force, energy) = (cubic(cells[last], 1.0), energies[cells.len()]);
        let (per_width, last) = (1.0 / width, last as f64);
        let piece = Piece { end, per_width, last, first: 0.0, start, force, slope, energy };
        Self { piece, lists: Lists::new(cells, &energies), error }
    }

    /// Twice the largest difference, at the middles of the cells, between the table and the function it was made of from `start` on: more than what was found anywhere between.
    pub fn error(&self) -> f64 {
        self.error
    }
    /// Distance beyond which the force is zero.
    pub fn end(&self) -> f64 {
        self.piece.end
    }
    /// Number of cubics.
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

/// Powers of the place within each cell: the cubic with the values and slopes at both ends.
fn cells(rooted: &impl Fn(f64) -> (f64, f64), width: f64, count: usize) -> Vec<[f64; 4]> {
    let nodes: Vec<(f64, f64)> = (0..=count).map(|k| rooted(k as f64 * width)).collect();
    let cell = |ends: &[(f64, f64)]| {
        let ((f_0, s_0), (f_1, s_1)) = (ends[0], ends[1]);
        let (s_0, s_1, rise) = (s_0 * width, s_1 * width, f_1 - f_0);
        [f_0, s_0, 3.0 * rise - 2.0 * s_0 - s_1, s_0 + s_1 - 2.0 * rise]
    };
    nodes.windows(2).map(cell).collect()
}

#[inline(always)]
fn cubic<R: Real>([a, b, c, e]: [R; 4], t: R) -> R {
    a + t * (b + t * (c + t * e))
}

/// Integral of a cubic over the distance, from the far end of its cell to the place `t` in it: the distance changes by twice the root.
#[inline(always)]
fn work<R: Real>([a, b, c, e]: [R; 4], k: R, width: R, t: R) -> R {
    let over = |x: R, n: f64| x / R::lit(n);
    let even = t * (a + t * (over(b, 2.0) + t * (over(c, 3.0) + t * over(e, 4.0))));
    let odd = t * t * (over(a, 2.0) + t * (over(b, 3.0) + t * (over(c, 4.0) + t * over(e, 5.0))));
    R::lit(2.0) * width * width * (k * even + odd)
}

/// A bound of the error. The error of a Hermite cubic is the fourth derivative times a function that is largest at the midpoint;
/// where the derivative hardly changes within a cell, the error at its midpoint is the largest, and twice the largest of all is a
/// bound.
fn error(rooted: &impl Fn(f64) -> (f64, f64), width: f64, cells: &[[f64; 4]]) -> f64 {
    let middle = |(k, cell): (usize, &[f64; 4])| (cubic(*cell, 0.5) - rooted((k as f64 + 0.5) * width).0).abs();
    2.0 * cells.iter().enumerate().map(middle).fold(0.0, f64::max)
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
        assert_eq!((constant.cells(), constant.error()), (16, 0.0));
        // the fourth derivative has one sign, and with it the difference between function and cubics
        for sign in [1.0, -1.0] {
            let table = Table::new(|u| (sign * Real::exp(u), sign * Real::exp(u)), 0.0, 1.5, 0.0, 1e-9);
            assert!(table.cells() > 16 && table.error() > 0.7e-9 && table.error() <= 1e-9, "{}", table.error());
        }
    }

    #[test]
    fn line_and_cubics_meet() {
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
        assert_eq!([1.0, 0.0].map(|tolerance| waves(tolerance).1.cells()), [16, MOST_CELLS]);
        for tolerance in [3e-5, 1e-6, 1e-7] {
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
            assert!(table.cells() < 1500, "{}", table.cells());
        }
    }
}
