//! Neighbour search: cell grids, one for each octave of radii.
//!
//! A sphere is entered in the grid of its octave and looks for partners there and in the grids of larger octaves only. The
//! cells of a grid fit its own spheres, so a few large spheres cost the many small ones nothing.

use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::spec::{Real, Vec3};
use crate::system::{Domain, Image};
use rayon::prelude::*;

/// Number of spheres whose partners are found between two questions whether to stop.
const ASKED: usize = 64;
/// Most cells of a grid for each sphere in it.
const CELLS_PER_SPHERE: f64 = 8.0;

/// A pair `p < q` (or a sphere and its own copy): sphere `q`, displaced by `image` boxes, is near sphere `p`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Neighbour {
    /// Place of the first sphere.
    pub p: u32,
    /// Place of the second sphere.
    pub q: u32,
    /// The copy of `q` that is meant.
    pub image: Image,
}

/// All pairs whose centres are closer than `reach(r_p, r_q)`, which must not decrease with either radius; in ascending order.
pub fn neighbours(
    x: &[Vec3<f64>],
    radius: &[f64],
    domain: &Domain,
    reach: impl Fn(f64, f64) -> f64 + Sync,
) -> Vec<Neighbour> {
    neighbours_but(x, radius, domain, reach, |_, _, _| false, &Interrupt::default()).expect("nothing asks to stop")
}

/// [`neighbours`], but for those that are `left_out(p, q, image)`, which must not depend on the order of `p` and `q`.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn neighbours_but(
    x: &[Vec3<f64>],
    radius: &[f64],
    domain: &Domain,
    reach: impl Fn(f64, f64) -> f64 + Sync,
    left_out: impl Fn(usize, usize, Image) -> bool + Sync,
    interrupt: &Interrupt,
) -> Result<Vec<Neighbour>, Error> {
    let smallest = radius.iter().copied().fold(f64::INFINITY, f64::min);
    let octave_of =
        |&r: &f64| std::iter::successors(Some(2.0 * smallest), |b| Some(2.0 * b)).take_while(|&b| r >= b).count();
    let octave: Vec<usize> = radius.iter().map(octave_of).collect();
    let octaves = octave.iter().map(|o| o + 1).max().unwrap_or(0);
    let grids: Vec<Grid> = (0..octaves)
        .filter_map(|o| {
            let members: Vec<u32> = (0..x.len() as u32).filter(|&p| octave[p as usize] == o).collect();
            let largest = members.iter().map(|&p| radius[p as usize]).fold(0.0, f64::max);
            (!members.is_empty()).then(|| Grid::new(x, domain, members, largest, reach(largest, largest), o))
        })
        .collect();

    let of_one = |p: usize| {
        let own_octave = octave[p];
        let home = domain.image_of(x[p]);
        let folded = x[p] - domain.shift(home);
        let mut found = Vec::new();
        for grid in grids.iter().filter(|g| g.octave >= own_octave) {
            let same = grid.octave == own_octave;
            let farthest = reach(radius[p], grid.largest);
            grid.visit(folded, home, farthest, |q, image| {
                // A pair of one octave is met from both ends, a sphere and its own copy from both sides: keep one.
                if same && (q, image) <= (p as u32, [0; 3]) || left_out(p, q as usize, image) {
                    return;
                }
                // In this order of operations its length is the same seen from either end.
                let apart = (x[p] - x[q as usize]) - domain.shift(image);
                // The exact reach is dear: most candidates fall short of any.
                let squared = apart.dot(apart);
                if squared < farthest * farthest && squared < reach(radius[p], radius[q as usize]).squared() {
                    found.push(ordered(p as u32, q, image));
                }
            });
        }
        found
    };
    let of_some = |first: usize| {
        interrupt.check()?;
        Ok((first..x.len().min(first + ASKED)).flat_map(of_one).collect())
    };
    let parts = (0..x.len()).into_par_iter().step_by(ASKED).map(of_some).collect::<Result<Vec<Vec<_>>, Error>>()?;
    let mut all = parts.concat();
    interrupt.check()?;
    all.par_sort_unstable();
    Ok(all)
}

fn ordered(p: u32, q: u32, image: Image) -> Neighbour {
    if q < p { Neighbour { p: q, q: p, image: image.map(i16::saturating_neg) } } else { Neighbour { p, q, image } }
}

/// The spheres of one octave, sorted into equal cells.
struct Grid<'a> {
    domain: &'a Domain,
    octave: usize,
    largest: f64,
    origin: [f64; 3],
    cells_per_length: [f64; 3],
    count: [i64; 3],
    /// Where the spheres of each cell begin in `members`.
    start: Vec<u32>,
    members: Vec<(u32, Image)>,
}

impl<'a> Grid<'a> {
    fn new(x: &[Vec3<f64>], domain: &'a Domain, members: Vec<u32>, largest: f64, size: f64, octave: usize) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for &q in &members {
            low = std::array::from_fn(|a| low[a].min(x[q as usize].0[a]));
            high = std::array::from_fn(|a| high[a].max(x[q as usize].0[a]));
        }
        let origin = std::array::from_fn(|a| if domain.periodic[a] { 0.0 } else { low[a] });
        let extent: [f64; 3] =
            std::array::from_fn(|a| if domain.periodic[a] { domain.sides[a] } else { high[a] - low[a] });
        // More cells than that would only cost memory; spheres that fill a part of the space need some that are empty.
        let most = CELLS_PER_SPHERE * members.len() as f64;
        let cells = |size: f64| extent.map(|length| ((length / size) as i64).max(1));
        let mut finest = (extent.iter().product::<f64>() / most).cbrt().max(size);
        // Spheres in a plane or a row have no volume.
        while cells(finest).iter().map(|&count| count as f64).product::<f64>() > most {
            finest *= 2.0;
        }
        let count = cells(finest);
        let cells_per_length = std::array::from_fn(|a| count[a] as f64 / extent[a].max(f64::MIN_POSITIVE));
        let mut grid =
            Self { domain, octave, largest, origin, cells_per_length, count, start: Vec::new(), members: Vec::new() };

        let cell_of = |q: u32| {
            let folded = domain.folded(x[q as usize]);
            let place: [i64; 3] = std::array::from_fn(|a| grid.along(a, folded.0[a]).clamp(0, grid.count[a] - 1));
            grid.index(place)
        };
        let mut keyed: Vec<(usize, u32)> = members.into_iter().map(|q| (cell_of(q), q)).collect();
        keyed.sort_unstable();
        let mut start = vec![0u32; count.iter().product::<i64>() as usize + 1];
        for &(cell, _) in &keyed {
            start[cell + 1] += 1;
        }
        for cell in 1..start.len() {
            start[cell] += start[cell - 1];
        }
        grid.members = keyed.into_iter().map(|(_, q)| (q, domain.image_of(x[q as usize]))).collect();
        grid.start = start;
        grid
    }

    /// The cell, counted along one axis, that a coordinate lies in; not yet folded into the grid.
    fn along(&self, a: usize, coordinate: f64) -> i64 {
        let place = (coordinate - self.origin[a]) * self.cells_per_length[a];
        let cut = place as i64;
        cut.saturating_sub(i64::from(place < cut as f64))
    }

    fn index(&self, place: [i64; 3]) -> usize {
        ((place[0] * self.count[1] + place[1]) * self.count[2] + place[2]) as usize
    }

    /// The cell of the grid that a cell is a copy of, and the copy of the box it is in.
    fn wrapped(&self, a: usize, place: i64) -> (i64, i16) {
        let count = self.count[a];
        // Divisions are dear, and hardly any cell needs them.
        if (0..count).contains(&place) { (place, 0) } else { (place.rem_euclid(count), place.div_euclid(count) as i16) }
    }

    /// Calls `found(q, image)` for every member whose cell is within `reach` of a point in the box that stands for its copy in `home`.
    fn visit(&self, point: Vec3<f64>, home: Image, reach: f64, mut found: impl FnMut(u32, Image)) {
        let span: [_; 3] = std::array::from_fn(|a| {
            let (low, high) = (self.along(a, point.0[a] - reach), self.along(a, point.0[a] + reach));
            if self.domain.periodic[a] { low..=high } else { low.max(0)..=high.min(self.count[a] - 1) }
        });
        for (i, copy_x) in span[0].clone().map(|i| self.wrapped(0, i)) {
            for (j, copy_y) in span[1].clone().map(|j| self.wrapped(1, j)) {
                // Cells in a row along the last axis lie side by side in memory: visit them at once.
                let (first, last) = (*span[2].start(), *span[2].end());
                let in_a_row = first >= 0 && last < self.count[2];
                for k in first..=if in_a_row { last.min(first) } else { last } {
                    let (k, copy_z) = self.wrapped(2, k);
                    let cells = self.index([i, j, k])..self.index([i, j, if in_a_row { last } else { k }]) + 1;
                    // A sphere that was thrown out of the box is in a copy beyond all that are counted, and near nothing.
                    let copies = [copy_x, copy_y, copy_z];
                    let copy: Image = std::array::from_fn(|a| copies[a].saturating_add(home[a]));
                    for &(q, home_q) in &self.members[self.start[cells.start] as usize..self.start[cells.end] as usize]
                    {
                        found(q, std::array::from_fn(|a| copy[a].saturating_sub(home_q[a])));
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Domain = Domain { sides: [10.0, 10.0, 4.0], periodic: [true, false, true] };

    /// Pairs of spheres whose surfaces are less than 1 apart.
    fn found(spheres: &[([f64; 3], f64)], domain: &Domain) -> Vec<(u32, u32, Image)> {
        let (x, radius): (Vec<_>, Vec<_>) = spheres.iter().map(|&(x, radius)| (Vec3(x), radius)).unzip();
        let pairs = neighbours(&x, &radius, domain, |r, s| r + s + 1.0);
        pairs.into_iter().map(|Neighbour { p, q, image }| (p, q, image)).collect()
    }

    #[test]
    fn a_neighbour_is_seen_in_the_copy_that_is_near() {
        let at = |x: f64, y: f64, z: f64| ([x, y, z], 0.5);
        for (spheres, expected) in [
            (vec![at(1.0, 1.0, 1.0), at(2.9, 1.0, 1.0)], vec![(0, 1, [0, 0, 0])]),
            // Nearer than the reach, not as near.
            (vec![at(1.0, 1.0, 1.0), at(3.0, 1.0, 1.0)], vec![]),
            (vec![at(9.5, 1.0, 1.0), at(0.5, 1.0, 1.0)], vec![(0, 1, [1, 0, 0])]),
            (vec![at(0.5, 1.0, 1.0), at(9.5, 1.0, 1.0)], vec![(0, 1, [-1, 0, 0])]),
            (vec![at(0.5, 1.0, 0.5), at(9.5, 1.0, 3.5)], vec![(0, 1, [-1, 0, -1])]),
            (vec![at(0.5, 1.0, 3.5), at(9.5, 1.0, 0.5)], vec![(0, 1, [-1, 0, 1])]),
            // Along the axis without periods there are no copies, and places may be anywhere.
            (vec![at(1.0, 0.5, 1.0), at(1.0, 9.5, 1.0)], vec![]),
            (vec![at(1.0, -50.5, 1.0), at(1.0, -49.5, 1.0)], vec![(0, 1, [0, 0, 0])]),
            // Spheres that have left the box by other numbers of periods.
            (vec![at(31.0, 1.0, 1.0), at(-8.5, 1.0, 1.0)], vec![(0, 1, [4, 0, 0])]),
            (vec![at(1.0, 1.0, -7.0), at(1.0, 1.0, 6.0)], vec![(0, 1, [0, 0, -3])]),
            // Two copies of one may be near.
            (vec![at(1.0, 1.0, 1.0), at(1.0, 1.0, 3.0), at(1.5, 1.5, 2.0)], vec![(0, 2, [0, 0, 0]), (1, 2, [0, 0, 0])]),
        ] {
            assert_eq!(found(&spheres, &BOX), expected, "{spheres:?}");
        }
        assert_eq!(found(&[], &BOX), []);
    }

    #[test]
    fn spheres_of_all_sizes_find_each_other_and_their_own_copies() {
        // A sphere as wide as the box is near its copies above and below; each pair is named once.
        let large = ([5.0, 5.0, 2.0], 1.6);
        assert_eq!(found(&[large], &BOX), [(0, 0, [0, 0, 1])]);
        let small = ([5.0, 5.0, 0.2], 0.1);
        assert_eq!(found(&[small, large], &BOX), [(0, 1, [0, 0, -1]), (0, 1, [0, 0, 0]), (1, 1, [0, 0, 1])]);
        assert_eq!(found(&[large, small], &BOX), [(0, 0, [0, 0, 1]), (0, 1, [0, 0, 0]), (0, 1, [0, 0, 1])]);
        // Octaves apart.
        let sizes = [([0.0, 0.0, 1.0], 0.1), ([2.0, 0.0, 1.0], 0.95), ([2.0, 3.5, 1.0], 1.6), ([0.0, 1.15, 1.0], 0.1)];
        let open = Domain { periodic: [false; 3], ..BOX };
        assert_eq!(found(&sizes, &open), [(0, 1, [0; 3]), (0, 3, [0; 3]), (1, 2, [0; 3])]);
    }

    #[test]
    fn what_is_thrown_far_out_is_near_nothing_and_pairs_may_be_left_out() {
        let far = [([1.0; 3], 0.5), ([1e9, 1.0, 1.0], 0.5), ([1.5, 1.0, 1.0], 0.5)];
        assert_eq!(found(&far, &BOX), [(0, 2, [0; 3])]);
        let x: Vec<Vec3<f64>> = (0..200).map(|k| Vec3([0.0, f64::from(k), 0.0])).collect();
        let open = Domain { periodic: [false; 3], ..BOX };
        let stop = Interrupt::default();
        let pairs = |interrupt: &Interrupt| {
            neighbours_but(&x, &[0.5; 200], &open, |r, s| r + s + 0.5, |p, q, _| p.min(q).is_multiple_of(2), interrupt)
        };
        let named = pairs(&stop).unwrap().into_iter().map(|pair| (pair.p, pair.q));
        assert!(named.eq((1..199).step_by(2).map(|p| (p, p + 1))));
        stop.request();
        assert!(matches!(pairs(&stop), Err(Error::Interrupted)));
    }
}
