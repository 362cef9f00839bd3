//! The deposited spheres, in cells, for fast queries of the free distance around a falling aggregate.

use crate::spec::Vec3;

/// Sides of the cells, in largest diameters: what is beyond the next cell leaves at least half a diameter of room.
const CELL: f64 = 1.5;
/// How many cells away free cells still know of occupied ones.
const SIGHT: i64 = 6;
/// No sphere.
const NONE: u32 = u32::MAX;

/// The deposited spheres in a column with a floor at height zero, periodic sideways.
pub struct Column {
    sides: [f64; 2],
    cell: [f64; 3],
    count: [i64; 2],
    largest: f64,
    top: f64,
    /// The last sphere of each cell, layer by layer.
    head: Vec<u32>,
    /// How many cells away the next occupied one is, at most one more than the sight.
    away: Vec<u8>,
    spheres: Vec<Deposited>,
}

struct Deposited {
    centre: Vec3<f64>,
    radius: f64,
    /// The next in the same cell.
    next: u32,
}

/// How far a sphere may move.
#[derive(Clone, Copy)]
pub struct FreeDistance {
    /// The distance of the surfaces, or a lower bound of it.
    pub gap: f64,
    /// The nearest object.
    pub nearest: Nearest,
}

/// What a sphere is near to.
#[derive(Clone, Copy)]
pub enum Nearest {
    /// Something that is too far to tell.
    Unknown,
    /// The floor.
    Floor,
    /// A sphere in this direction.
    Sphere(Vec3<f64>),
}

impl Column {
    /// The shortest side of a column of spheres up to the `largest` radius.
    pub fn least_side(largest: f64) -> f64 {
        2.0 * CELL * largest
    }

    /// A column without any spheres; none will be larger than the `largest` radius.
    pub fn new(sides: [f64; 2], largest: f64) -> Self {
        let least = Self::least_side(largest);
        let count = sides.map(|side| ((side / least) as i64).max(1));
        let cell = [sides[0] / count[0] as f64, sides[1] / count[1] as f64, least];
        Self { sides, cell, count, largest, top: 0.0, head: Vec::new(), away: Vec::new(), spheres: Vec::new() }
    }

    /// Height of the highest point.
    pub fn top(&self) -> f64 {
        self.top
    }

    /// The room of a sphere, of which no more matters than `enough`.
    pub fn room(&self, x: Vec3<f64>, radius: f64, enough: FreeDistance) -> FreeDistance {
        let mut best = enough;
        let floor = x.0[2] - radius;
        if floor < best.gap {
            best = FreeDistance { gap: floor, nearest: Nearest::Floor };
        }
        // Whatever is above the film is far from it.
        let bound = floor - self.top;
        if bound >= best.gap {
            return best;
        }
        let place = self.place(x);
        let layers = self.layers();
        if place[2] >= layers {
            return FreeDistance { gap: bound, nearest: Nearest::Unknown };
        }
        let away = i64::from(self.away[self.index(place)]);
        let beyond = |cells: i64| (cells - 1) as f64 * self.narrowest() - radius - self.largest;
        if away >= 2 {
            let bound = bound.max(beyond(away));
            return if bound < best.gap { FreeDistance { gap: bound, nearest: Nearest::Unknown } } else { best };
        }
        if beyond(2) < best.gap {
            best = FreeDistance { gap: beyond(2), nearest: Nearest::Unknown };
        }
        for i in -1..=1 {
            for j in -1..=1 {
                for k in -1..=1 {
                    best = self.room_of_cell([place[0] + i, place[1] + j, place[2] + k], x, radius, best);
                }
            }
        }
        best
    }

    /// Distance of a point from the nearest surface, the floor's too; negative inside a sphere.
    pub fn clearance(&self, x: Vec3<f64>) -> f64 {
        let mut best = FreeDistance { gap: x.0[2], nearest: Nearest::Floor };
        let place = self.place(x);
        for ring in 0i64.. {
            if (ring - 1) as f64 * self.narrowest() - self.largest >= best.gap {
                break;
            }
            for i in -ring..=ring {
                for j in -ring..=ring {
                    // Inside the ring only its two lids are new.
                    let rim = i.abs() == ring || j.abs() == ring;
                    let step = if rim || ring == 0 { 1 } else { 2 * ring as usize };
                    for k in (-ring..=ring).step_by(step) {
                        best = self.room_of_cell([place[0] + i, place[1] + j, place[2] + k], x, 0.0, best);
                    }
                }
            }
        }
        best.gap
    }

    fn room_of_cell(&self, cell: [i64; 3], x: Vec3<f64>, radius: f64, mut best: FreeDistance) -> FreeDistance {
        if cell[2] < 0 || cell[2] >= self.layers() {
            return best;
        }
        let shift = [0, 1].map(|a| cell[a].div_euclid(self.count[a]) as f64 * self.sides[a]);
        let mut next = self.head[self.index(cell)];
        while next != NONE {
            let other = &self.spheres[next as usize];
            let to = other.centre + Vec3([shift[0], shift[1], 0.0]) - x;
            let reach = best.gap + radius + other.radius;
            let square = to.dot(to);
            if square < reach * reach {
                let distance = square.sqrt();
                let gap = distance - radius - other.radius;
                best = FreeDistance { gap, nearest: Nearest::Sphere(to * (1.0 / distance)) };
            }
            next = other.next;
        }
        best
    }

    fn narrowest(&self) -> f64 {
        self.cell.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Adds a sphere.
    pub fn add(&mut self, x: Vec3<f64>, radius: f64) {
        let place = self.place(x);
        while self.layers() < place[2] + 1 + SIGHT {
            let layer = (self.count[0] * self.count[1]) as usize;
            self.head.extend(std::iter::repeat_n(NONE, layer));
            self.away.extend(std::iter::repeat_n(SIGHT as u8 + 1, layer));
        }
        let cell = self.index(place);
        if self.head[cell] == NONE {
            self.occupy(place);
        }
        let folded = |a: usize| x.0[a] - place[a].div_euclid(self.count[a]) as f64 * self.sides[a];
        let centre = Vec3([folded(0), folded(1), x.0[2]]);
        self.spheres.push(Deposited { centre, radius, next: self.head[cell] });
        self.head[cell] = (self.spheres.len() - 1) as u32;
        self.top = self.top.max(x.0[2] + radius);
    }

    /// Tells the cells around that one is no longer free.
    fn occupy(&mut self, place: [i64; 3]) {
        for i in -SIGHT..=SIGHT {
            for j in -SIGHT..=SIGHT {
                for k in -SIGHT..=SIGHT {
                    let [x, y, z] = [place[0] + i, place[1] + j, place[2] + k];
                    if z >= 0 && z < self.layers() {
                        let cell = self.index([x, y, z]);
                        let away = i.abs().max(j.abs()).max(k.abs()) as u8;
                        self.away[cell] = self.away[cell].min(away);
                    }
                }
            }
        }
    }

    fn layers(&self) -> i64 {
        self.head.len() as i64 / (self.count[0] * self.count[1])
    }

    /// The cell of a point, not folded into the column.
    fn place(&self, x: Vec3<f64>) -> [i64; 3] {
        std::array::from_fn(|a| (x.0[a] / self.cell[a]).floor() as i64)
    }

    fn index(&self, place: [i64; 3]) -> usize {
        let [i, j] = [0, 1].map(|a| place[a].rem_euclid(self.count[a]));
        ((place[2] * self.count[1] + j) * self.count[0] + i) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANYTHING: FreeDistance = FreeDistance { gap: f64::INFINITY, nearest: Nearest::Unknown };

    /// A column of four by four cells of side 15 with one sphere of radius 5.
    fn column() -> Column {
        let mut column = Column::new([60.0; 2], 5.0);
        column.add(Vec3([7.0, 7.0, 7.0]), 5.0);
        column
    }

    /// The gap, and what is near: nothing known, the floor, or a sphere in a direction.
    fn told(FreeDistance { gap, nearest }: FreeDistance) -> (f64, &'static str, Option<Vec3<f64>>) {
        match nearest {
            Nearest::Unknown => (gap, "unknown", None),
            Nearest::Floor => (gap, "floor", None),
            Nearest::Sphere(towards) => (gap, "sphere", Some(towards)),
        }
    }

    #[test]
    fn cells_fill_the_column_and_are_no_narrower_than_three_largest_radii() {
        assert_eq!(Column::least_side(5.0), 15.0);
        let cells = |sides| {
            let Column { cell, count, .. } = Column::new(sides, 5.0);
            (cell, count)
        };
        assert_eq!(cells([44.0, 80.0]), ([22.0, 16.0, 15.0], [2, 5]));
        assert_eq!(cells([15.0, 14.0]), ([15.0, 14.0, 15.0], [1, 1]));
        let empty = Column::new([60.0; 2], 5.0);
        assert_eq!((empty.top(), column().top()), (0.0, 12.0));
        assert_eq!(told(empty.room(Vec3([1.0, 2.0, 9.0]), 2.0, ANYTHING)), (7.0, "floor", None));
    }

    #[test]
    fn free_cells_know_how_far_the_next_occupied_one_is_as_far_as_they_see() {
        let mut column = Column::new([300.0; 2], 5.0);
        column.add(Vec3([7.0, 7.0, 7.0]), 5.0);
        assert_eq!(column.layers(), 7);
        for (place, expected) in [
            ([0, 0, 0], 0),
            ([1, 0, 0], 1),
            ([5, 6, 2], 6),
            ([0, 7, 0], 7),
            ([10, 0, 0], 7),
            ([0, 0, 6], 6),
            ([-3, 0, 0], 3),
            ([17, 18, 1], 3),
            ([0, -6, 0], 6),
            ([13, 0, 0], 7),
        ] {
            assert_eq!(column.away[column.index(place)], expected, "{place:?}");
        }
        column.add(Vec3([7.0, 7.0, 100.0]), 5.0);
        assert_eq!(column.layers(), 13);
        for (layer, expected) in [(2, 2), (3, 3), (4, 2), (6, 0), (12, 6)] {
            assert_eq!(column.away[column.index([0, 0, layer])], expected, "{layer}");
        }
    }

    #[test]
    fn room_is_exact_next_to_a_sphere_and_a_lower_bound_farther_away() {
        let column = column();
        for (x, gap, nearest) in [
            // Two cells away: what is above the top, or one free cell less both radii.
            ([7.0, 7.0, 30.0], 17.0, "unknown"),
            ([37.0, 7.0, 20.0], 9.0, "unknown"),
            ([37.0, 37.0, 20.0], 9.0, "unknown"),
            ([37.0, 7.0, 7.0], 6.0, "floor"),
            // As near as what is not told apart.
            ([37.0, 7.0, 10.0], 9.0, "floor"),
            ([22.0, 7.0, 10.0], 9.0, "floor"),
            // Higher than any cell.
            ([7.0, 7.0, 200.0], 187.0, "unknown"),
            // In the next cell, but farther than what may be beyond it.
            ([22.0, 7.0, 16.0], 9.0, "unknown"),
        ] {
            assert_eq!(told(column.room(Vec3(x), 1.0, ANYTHING)), (gap, nearest, None), "{x:?}");
        }
        for (x, to) in [
            ([17.0, 7.0, 16.0], [-10.0, 0.0, -9.0]),
            ([7.0, 16.0, 16.0], [0.0, -9.0, -9.0]),
            // Across the period.
            ([58.0, 7.0, 16.0], [9.0, 0.0, -9.0]),
            ([-2.0, 7.0, 16.0], [9.0, 0.0, -9.0]),
            ([7.0, 58.0, 16.0], [0.0, 9.0, -9.0]),
            ([67.0, 7.0, 18.0], [0.0, 0.0, -11.0]),
            // Overlapping.
            ([7.0, 7.0, 12.0], [0.0, 0.0, -5.0]),
        ] {
            let (gap, nearest, towards) = told(column.room(Vec3(x), 1.0, ANYTHING));
            let distance = Vec3(to).norm();
            assert!(nearest == "sphere" && (gap - (distance - 6.0)).abs() < 1e-12, "{x:?}: {gap}");
            assert!((towards.expect("a sphere") - Vec3(to) * (1.0 / distance)).norm() < 1e-12, "{x:?}");
        }
    }

    #[test]
    fn no_more_room_is_found_than_is_asked_for() {
        let column = column();
        let asked =
            |x: [f64; 3], gap: f64| told(column.room(Vec3(x), 1.0, FreeDistance { gap, nearest: Nearest::Unknown }));
        // As near as the floor, nearer than the sphere, nearer than what is above the top.
        assert_eq!(asked([37.0, 7.0, 7.0], 6.0), (6.0, "unknown", None));
        assert_eq!(asked([37.0, 7.0, 7.0], 6.1), (6.0, "floor", None));
        assert_eq!(asked([17.0, 7.0, 16.0], 7.0), (7.0, "unknown", None));
        assert_eq!(asked([7.0, 7.0, 30.0], 16.0), (16.0, "unknown", None));
        assert_eq!(asked([37.0, 7.0, 20.0], 8.0), (8.0, "unknown", None));
        assert_eq!(asked([22.0, 7.0, 16.0], 8.0), (8.0, "unknown", None));
    }

    #[test]
    fn clearance_is_that_of_the_nearest_surface_however_far() {
        let mut column = Column::new([300.0, 150.0], 5.0);
        column.add(Vec3([7.0, 7.0, 107.0]), 5.0);
        column.add(Vec3([295.0, 7.0, 50.0]), 2.0);
        for (x, expected) in [
            ([7.0, 7.0, 60.0], Vec3([12.0, 0.0, 10.0]).norm() - 2.0),
            ([7.0, 7.0, 10.0], 10.0),
            ([7.0, 7.0, 150.0], 38.0),
            ([150.0, 80.0, 90.0], 90.0),
            ([150.0, 80.0, 300.0], Vec3([143.0, 73.0, 193.0]).norm() - 5.0),
            ([307.0, 157.0, 107.0], -5.0),
            ([295.0, 7.0, 51.0], -1.0),
        ] {
            assert!((column.clearance(Vec3(x)) - expected).abs() < 1e-12, "{x:?}: {}", column.clearance(Vec3(x)));
        }
    }
}
