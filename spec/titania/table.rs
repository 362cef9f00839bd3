//! A function tabulated to a tolerance: what makes the attraction fast.

/// A force against the distance of two centres that ends with a jump where its slope is infinite, such as that of a meniscus.
///
/// Between the nodes it is a cubic in the square root of the distance left before the end, evenly spaced, with the force and its slope exact at the nodes.
/// The last node is the end itself. The potential is the exact integral of the cubics, so energy is conserved as if they were the law.
#[derive(Clone, Debug)]
pub struct Table {
    end: f64,
    width: f64,
    cells: Vec<[f64; 4]>,
    energies: Vec<f64>,
    deep: Line,
    error: f64,
}

/// How the force goes on below the tabulated range.
#[derive(Clone, Copy, Debug)]
struct Line {
    d: f64,
    force: f64,
    slope: f64,
    energy: f64,
}

/// Most cells of a table; a tolerance that asks for more is not met.
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
                return Self::of(cells, width, start, end, slope, error);
            }
            // the error goes with the fourth power of the width
            let finer = 1.05 * (error / tolerance).sqrt().sqrt();
            count = ((count as f64 * finer.min(8.0)).ceil() as usize).max(count + 1);
        }
    }

    fn of(cells: Vec<[f64; 4]>, width: f64, start: f64, end: f64, slope: f64, error: f64) -> Self {
        let mut energies = vec![0.0];
        for (k, cell) in cells.iter().enumerate() {
            energies.push(energies[k] + work(cell, k as f64, width, 1.0));
        }
        let (last, energy) = (cells[cells.len() - 1], energies[cells.len()]);
        let force = last.iter().sum();
        Self { end, width, cells, energies, deep: Line { d: start, force, slope, energy }, error }
    }

    /// A bound of the difference between the table and the function it was made of.
    pub fn error(&self) -> f64 {
        self.error
    }
    /// Distance from which on the force is zero.
    pub fn end(&self) -> f64 {
        self.end
    }
    /// Number of cubics.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Force at a distance.
    #[inline]
    pub fn force(&self, d: f64) -> f64 {
        if d >= self.end {
            return 0.0;
        }
        let place = (self.end - d).sqrt() / self.width;
        match self.cells.get(place as usize) {
            Some(cell) => cubic(cell, place - place.floor()),
            None => self.deep.force + self.deep.slope * (d - self.deep.d),
        }
    }

    /// Potential at a distance, zero from the end on.
    pub fn potential(&self, d: f64) -> f64 {
        if d >= self.end {
            return 0.0;
        }
        let place = (self.end - d).sqrt() / self.width;
        let k = place as usize;
        match self.cells.get(k) {
            Some(cell) => self.energies[k] + work(cell, k as f64, self.width, place - place.floor()),
            None => {
                let Line { d: start, force, slope, energy } = self.deep;
                energy - (d - start) * (force + 0.5 * slope * (d - start))
            }
        }
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

#[inline]
fn cubic(cell: &[f64; 4], t: f64) -> f64 {
    cell[0] + t * (cell[1] + t * (cell[2] + t * cell[3]))
}

/// Integral of a cubic over the distance, from the far end of its cell to the place `t` in it: the distance changes by twice the root.
fn work(cell: &[f64; 4], k: f64, width: f64, t: f64) -> f64 {
    let [a, b, c, e] = *cell;
    let even = t * (a + t * (b / 2.0 + t * (c / 3.0 + t * e / 4.0)));
    let odd = t * t * (a / 2.0 + t * (b / 3.0 + t * (c / 4.0 + t * e / 5.0)));
    2.0 * width * width * (k * even + odd)
}

/// A bound of the error. That of a cubic with the slopes at its ends is the fourth derivative times a shape that is largest in the
/// middle; where the derivative hardly changes in a cell, the error there is the largest, and twice the largest of all bounds it.
fn error(rooted: &impl Fn(f64) -> (f64, f64), width: f64, cells: &[[f64; 4]]) -> f64 {
    let middle = |(k, cell): (usize, &[f64; 4])| (cubic(cell, 0.5) - rooted((k as f64 + 0.5) * width).0).abs();
    2.0 * cells.iter().enumerate().map(middle).fold(0.0, f64::max)
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Real;
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
