//! What has been deposited, in cells, so that a falling aggregate soon knows how much room it has.

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
pub struct Room {
    /// The distance of the surfaces, or a lower bound of it.
    pub gap: f64,
    /// From what.
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
    /// A column without any spheres; none will be larger than the `largest` radius.
    pub fn new(sides: [f64; 2], largest: f64) -> Self {
        let least = 2.0 * CELL * largest;
        let count = sides.map(|side| ((side / least) as i64).max(1));
        let cell = [sides[0] / count[0] as f64, sides[1] / count[1] as f64, least];
        Self { sides, cell, count, largest, top: 0.0, head: Vec::new(), away: Vec::new(), spheres: Vec::new() }
    }

    /// Height of the highest point.
    pub fn top(&self) -> f64 {
        self.top
    }

    /// The room of a sphere, of which no more matters than `enough`.
    pub fn room(&self, x: Vec3<f64>, radius: f64, enough: Room) -> Room {
        let mut best = enough;
        let floor = x.0[2] - radius;
        if floor < best.gap {
            best = Room { gap: floor, nearest: Nearest::Floor };
        }
        // Whatever is above the film is far from it.
        let bound = floor - self.top;
        if bound >= best.gap {
            return best;
        }
        let place = self.place(x);
        let layers = self.layers();
        if place[2] >= layers {
            return Room { gap: bound, nearest: Nearest::Unknown };
        }
        let away = i64::from(self.away[self.index(place)]);
        let beyond = |cells: i64| {
            (cells - 1) as f64 * self.cell.into_iter().fold(f64::INFINITY, f64::min) - radius - self.largest
        };
        if away >= 2 {
            let bound = bound.max(beyond(away));
            return if bound < best.gap { Room { gap: bound, nearest: Nearest::Unknown } } else { best };
        }
        if beyond(2) < best.gap {
            best = Room { gap: beyond(2), nearest: Nearest::Unknown };
        }
        for i in place[0] - 1..=place[0] + 1 {
            for j in place[1] - 1..=place[1] + 1 {
                let shift = [(i, 0), (j, 1)].map(|(k, a)| k.div_euclid(self.count[a]) as f64 * self.sides[a]);
                for k in (place[2] - 1).max(0)..(place[2] + 2).min(layers) {
                    let mut next = self.head[self.index([i, j, k])];
                    while next != NONE {
                        let other = &self.spheres[next as usize];
                        let to = other.centre + Vec3([shift[0], shift[1], 0.0]) - x;
                        let reach = best.gap + radius + other.radius;
                        let square = to.dot(to);
                        if square < reach * reach {
                            let distance = square.sqrt();
                            best = Room {
                                gap: distance - radius - other.radius,
                                nearest: Nearest::Sphere(to * (1.0 / distance)),
                            };
                        }
                        next = other.next;
                    }
                }
            }
        }
        best
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
