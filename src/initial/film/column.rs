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
