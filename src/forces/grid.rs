//! Who is near whom: cell grids, one for each octave of radii.
//!
//! A sphere is entered in the grid of its octave and looks for partners there and in the grids of larger octaves only. The
//! cells of a grid fit its own spheres, so a few large spheres cost the many small ones nothing.

use crate::spec::{Real, Vec3};
use crate::system::{Domain, Image};
use rayon::prelude::*;

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
    neighbours_but(x, radius, domain, reach, |_, _, _| false)
}

/// [`neighbours`], but for those that are `left_out(p, q, image)`, which must not depend on the order of `p` and `q`.
pub fn neighbours_but(
    x: &[Vec3<f64>],
    radius: &[f64],
    domain: &Domain,
    reach: impl Fn(f64, f64) -> f64 + Sync,
    left_out: impl Fn(usize, usize, Image) -> bool + Sync,
) -> Vec<Neighbour> {
    let smallest = radius.iter().copied().fold(f64::INFINITY, f64::min);
    let octave = |r: f64| (r / smallest).log2().floor() as usize;
    let octaves = radius.iter().map(|&r| octave(r) + 1).max().unwrap_or(0);
    let grids: Vec<Grid> = (0..octaves)
        .filter_map(|o| {
            let members: Vec<u32> = (0..x.len() as u32).filter(|&p| octave(radius[p as usize]) == o).collect();
            let largest = members.iter().map(|&p| radius[p as usize]).fold(0.0, f64::max);
            (!members.is_empty()).then(|| Grid::new(x, domain, members, largest, reach(largest, largest), o))
        })
        .collect();

    let of_one = |p: usize| {
        let own_octave = octave(radius[p]);
        let mut found = Vec::new();
        for grid in grids.iter().filter(|g| g.octave >= own_octave) {
            let same = grid.octave == own_octave;
            let farthest = reach(radius[p], grid.largest);
            grid.visit(x[p], farthest, |q, image| {
                // A pair of one octave is met from both ends, a sphere and its own copy from both sides: keep one.
                if same && (q, image) <= (p as u32, [0; 3]) {
                    return;
                }
                // In this order of operations its length is the same seen from either end.
                let apart = (x[p] - x[q as usize]) - domain.shift(image);
                // The exact reach is dear: most candidates fall short of any.
                let squared = apart.dot(apart);
                if squared < farthest * farthest
                    && !left_out(p, q as usize, image)
                    && squared < reach(radius[p], radius[q as usize]).squared()
                {
                    found.push(ordered(p as u32, q, image));
                }
            });
        }
        found
    };
    let mut all: Vec<Neighbour> = (0..x.len()).into_par_iter().flat_map_iter(of_one).collect();
    all.sort_unstable();
    all
}

fn ordered(p: u32, q: u32, image: Image) -> Neighbour {
    if q < p { Neighbour { p: q, q: p, image: image.map(|k| -k) } } else { Neighbour { p, q, image } }
}

/// The spheres of one octave, sorted into equal cells.
struct Grid<'a> {
    domain: &'a Domain,
    octave: usize,
    largest: f64,
    origin: [f64; 3],
    cell: [f64; 3],
    count: [i64; 3],
    /// Where the spheres of each cell begin in `members`.
    start: Vec<u32>,
    members: Vec<(u32, Image)>,
}

impl<'a> Grid<'a> {
    fn new(x: &[Vec3<f64>], domain: &'a Domain, members: Vec<u32>, largest: f64, size: f64, octave: usize) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for p in x {
            low = std::array::from_fn(|a| low[a].min(p.0[a]));
            high = std::array::from_fn(|a| high[a].max(p.0[a]));
        }
        let origin = std::array::from_fn(|a| if domain.periodic[a] { 0.0 } else { low[a] });
        let extent: [f64; 3] =
            std::array::from_fn(|a| if domain.periodic[a] { domain.sides[a] } else { high[a] - low[a] });
        // More cells than spheres would only cost memory.
        let finest = (extent.iter().product::<f64>() / (members.len() as f64)).cbrt().max(size);
        let count = extent.map(|length| ((length / finest) as i64).max(1));
        let cell = std::array::from_fn(|a| (extent[a] / count[a] as f64).max(f64::MIN_POSITIVE));
        let mut grid = Self { domain, octave, largest, origin, cell, count, start: Vec::new(), members: Vec::new() };

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
        ((coordinate - self.origin[a]) / self.cell[a]).floor() as i64
    }

    fn index(&self, place: [i64; 3]) -> usize {
        ((place[0] * self.count[1] + place[1]) * self.count[2] + place[2]) as usize
    }

    /// Calls `found(q, image)` for every member whose cell is within `reach` of the stored position `x`.
    fn visit(&self, x: Vec3<f64>, reach: f64, mut found: impl FnMut(u32, Image)) {
        let home = self.domain.image_of(x);
        let folded = self.domain.folded(x);
        let span: [_; 3] = std::array::from_fn(|a| {
            let (low, high) = (self.along(a, folded.0[a] - reach), self.along(a, folded.0[a] + reach));
            if self.domain.periodic[a] { low..=high } else { low.max(0)..=high.min(self.count[a] - 1) }
        });
        for i in span[0].clone() {
            for j in span[1].clone() {
                for k in span[2].clone() {
                    let place = [i, j, k];
                    let cell = self.index(std::array::from_fn(|a| place[a].rem_euclid(self.count[a])));
                    let copy: Image = std::array::from_fn(|a| place[a].div_euclid(self.count[a]) as i16 + home[a]);
                    for &(q, home_q) in &self.members[self.start[cell] as usize..self.start[cell + 1] as usize] {
                        found(q, std::array::from_fn(|a| copy[a] - home_q[a]));
                    }
                }
            }
        }
    }
}
