//! The convex hull of points, by quickhull with exact predicates: no point set is too flat, too thin or too regular for it.
//!
//! Which side of a plane a point lies on is never rounded, so the faces always close; points in the plane of a face do not
//! count as outside.

use crate::spec::mechanics::convex_hull::edge_curvature;
use crate::spec::{Real, Vec3};
use qd::Quad;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// What Steiner's formula needs of a convex body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Volume, nm^3.
    pub volume: f64,
    /// Surface, nm^2; of a flat body, both sides.
    pub surface: f64,
    /// Integral of the mean curvature, nm.
    pub curvature: f64,
}

/// The hull of at least one point.
pub fn measures(points: &[Vec3<f64>]) -> Measures {
    match tetrahedron(points) {
        Some(corners) => Polyhedron::new(points, corners).measures(),
        None => flat(points),
    }
}

/// Radius of the largest ball about the origin in the hull of points that do not lie in one plane.
pub fn inner_radius(points: &[Vec3<f64>]) -> f64 {
    let corners = tetrahedron(points).expect("the points span space");
    let hull = Polyhedron::new(points, corners);
    let distance = |face: &Face| {
        let corners = face.corners.map(|k| points[k]);
        let n = normal(corners);
        n.dot(corners[0]) / n.norm()
    };
    hull.faces.iter().filter(|face| !face.removed).map(distance).fold(f64::INFINITY, f64::min)
}

/// A face with its corners counter-clockwise as seen from outside.
struct Face {
    corners: [usize; 3],
    /// The faces across the edges from corner `k` to corner `k + 1`.
    beyond: [usize; 3],
    /// Points that see it from outside and have not been dealt with.
    outside: Vec<usize>,
    removed: bool,
}

struct Polyhedron<'a> {
    points: &'a [Vec3<f64>],
    faces: Vec<Face>,
}

impl<'a> Polyhedron<'a> {
    fn new(points: &'a [Vec3<f64>], [a, b, c, d]: [usize; 4]) -> Self {
        let face = |corners, beyond| Face { corners, beyond, outside: Vec::new(), removed: false };
        // Opposite to d, a, b, c.
        let faces = vec![
            face([a, b, c], [3, 1, 2]),
            face([b, d, c], [3, 2, 0]),
            face([c, d, a], [1, 3, 0]),
            face([a, d, b], [2, 1, 0]),
        ];
        let mut hull = Self { points, faces };
        hull.share(0..points.len(), 0);
        let mut next = 0;
        while next < hull.faces.len() {
            if !hull.faces[next].removed && !hull.faces[next].outside.is_empty() {
                hull.grow(next);
            }
            next += 1;
        }
        hull
    }

    /// How far a point is outside the plane of a face, times twice the area of the face; the sign is exact.
    fn above(&self, face: usize, point: usize) -> f64 {
        let [a, b, c] = self.faces[face].corners.map(|k| space(self.points[k]));
        -orient3d(a, b, c, space(self.points[point]))
    }

    /// Gives each point to a face, of those from `first` on, that it is outside of.
    fn share(&mut self, points: impl IntoIterator<Item = usize>, first: usize) {
        for point in points {
            if let Some(face) = (first..self.faces.len()).find(|&face| self.above(face, point) > 0.0) {
                self.faces[face].outside.push(point);
            }
        }
    }

    /// Takes in the outermost of the points outside a face.
    fn grow(&mut self, face: usize) {
        let farther = |&p: &usize, &q: &usize| self.above(face, p).total_cmp(&self.above(face, q));
        let point = self.faces[face].outside.iter().copied().max_by(farther).expect("a point is outside");
        let (mut seen, mut horizon) = (vec![face], Vec::new());
        self.faces[face].removed = true;
        let mut next = 0;
        while next < seen.len() {
            for k in 0..3 {
                let other = self.faces[seen[next]].beyond[k];
                if !self.faces[other].removed && self.above(other, point) > 0.0 {
                    self.faces[other].removed = true;
                    seen.push(other);
                }
            }
            next += 1;
        }
        for &gone in &seen {
            for k in 0..3 {
                let beyond = self.faces[gone].beyond[k];
                if !self.faces[beyond].removed {
                    let [from, to] = [k, (k + 1) % 3].map(|k| self.faces[gone].corners[k]);
                    horizon.push((from, to, beyond));
                }
            }
        }
        let first = self.faces.len();
        let number = |corner: usize, end: fn(&(usize, usize, usize)) -> usize| {
            first + horizon.iter().position(|edge| end(edge) == corner).expect("the horizon is closed")
        };
        for &(from, to, beyond) in &horizon {
            let sides = [beyond, number(to, |edge| edge.0), number(from, |edge| edge.1)];
            let new = self.faces.len();
            let back = (0..3).find(|&k| self.faces[beyond].corners[k] == to).expect("neighbours share an edge");
            self.faces[beyond].beyond[back] = new;
            self.faces.push(Face { corners: [from, to, point], beyond: sides, outside: Vec::new(), removed: false });
        }
        let orphans: Vec<usize> = seen.iter().flat_map(|&gone| std::mem::take(&mut self.faces[gone].outside)).collect();
        self.share(orphans.into_iter().filter(|&p| p != point), first);
    }

    fn measures(&self) -> Measures {
        let normals: Vec<Vec3<f64>> = self.faces.iter().map(|f| normal(f.corners.map(|k| self.points[k]))).collect();
        let origin = self.points[self.faces[0].corners[0]];
        let mut sum = Measures { volume: 0.0, surface: 0.0, curvature: 0.0 };
        for (here, face) in self.faces.iter().enumerate().filter(|(_, face)| !face.removed) {
            sum.volume += normals[here].dot(self.points[face.corners[0]] - origin) / 6.0;
            sum.surface += normals[here].norm() / 2.0;
            for k in 0..3 {
                let there = face.beyond[k];
                if here < there {
                    let length = (self.points[face.corners[(k + 1) % 3]] - self.points[face.corners[k]]).norm();
                    let (n, m) = (normals[here], normals[there]);
                    sum.curvature += edge_curvature(length, libm::atan2(n.cross(m).norm(), n.dot(m)));
                }
            }
        }
        sum
    }
}

/// A hull without volume: a point, a segment or a polygon, which has two sides and edges that turn by half a circle each;
/// a segment is a polygon of two edges.
fn flat(points: &[Vec3<f64>]) -> Measures {
    let by_place = |a: &&Vec3<f64>, b: &&Vec3<f64>| a.0.partial_cmp(&b.0).expect("places are numbers");
    let start = *points.iter().min_by(by_place).expect("there is a point");
    let end = farthest(points, |p| (p - start).norm());
    let side = farthest(points, |p| normal([start, end, p]).norm());
    // Seen along the axis that shortens the polygon least.
    let across = [0, 1, 2].map(|k| orient2d(shadow(start, k), shadow(end, k), shadow(side, k)).abs());
    let drop = if across.iter().any(|&size| size > 0.0) {
        (0..3).max_by(|&k, &l| across[k].total_cmp(&across[l]))
    } else {
        (0..3).min_by(|&k, &l| (end - start).0[k].abs().total_cmp(&(end - start).0[l].abs()))
    };
    let drop = drop.expect("there are three axes");
    let shadow = |p| shadow(p, drop);
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| {
        (shadow(*p).x, shadow(*p).y).partial_cmp(&(shadow(*q).x, shadow(*q).y)).expect("places are numbers")
    });
    let chain = |points: &mut dyn Iterator<Item = Vec3<f64>>| {
        let mut kept: Vec<Vec3<f64>> = Vec::new();
        for p in points {
            while let [.., a, b] = kept[..]
                && orient2d(shadow(a), shadow(b), shadow(p)) <= 0.0
            {
                kept.pop();
            }
            kept.push(p);
        }
        kept
    };
    let mut corners = chain(&mut sorted.iter().copied());
    corners.pop();
    corners.extend(chain(&mut sorted.iter().rev().copied()));
    corners.pop();
    let edges = || (0..corners.len()).map(|k| (corners[k], corners[(k + 1) % corners.len()]));
    Measures {
        volume: 0.0,
        surface: edges().map(|(p, q)| normal([start, p, q]).norm()).sum(),
        curvature: edges().map(|(p, q)| edge_curvature((q - p).norm(), f64::pi())).sum(),
    }
}

/// Four points that span space, turned so that the fourth is below the plane of the others; none if all lie in one plane.
fn tetrahedron(points: &[Vec3<f64>]) -> Option<[usize; 4]> {
    let most = |size: &dyn Fn(Vec3<f64>) -> f64| {
        (0..points.len()).max_by(|&k, &l| size(points[k]).total_cmp(&size(points[l]))).expect("there is a point")
    };
    let a = most(&|p| p.0[0]);
    let b = most(&|p| (p - points[a]).norm());
    let c = most(&|p| normal([points[a], points[b], p]).norm());
    let side = |p| orient3d(space(points[a]), space(points[b]), space(points[c]), space(p));
    let d = most(&|p| side(p).abs());
    match side(points[d]) {
        below if below > 0.0 => Some([a, b, c, d]),
        above if above < 0.0 => Some([a, c, b, d]),
        _ => None,
    }
}

fn farthest(points: &[Vec3<f64>], size: impl Fn(Vec3<f64>) -> f64) -> Vec3<f64> {
    points.iter().copied().max_by(|&p, &q| size(p).total_cmp(&size(q))).expect("there is a point")
}

/// Twice the area of a triangle, along its normal. The products of a sliver cancel: they are taken with twice as many digits.
fn normal([a, b, c]: [Vec3<f64>; 3]) -> Vec3<f64> {
    let side = |p: Vec3<f64>, k: usize| Quad::from(p.0[k % 3]) - Quad::from(a.0[k % 3]);
    Vec3(std::array::from_fn(|k| (side(b, k + 1) * side(c, k + 2) - side(b, k + 2) * side(c, k + 1)).0))
}

/// A point as seen along an axis.
fn shadow(p: Vec3<f64>, axis: usize) -> Coord<f64> {
    Coord { x: p.0[(axis + 1) % 3], y: p.0[(axis + 2) % 3] }
}

fn space(p: Vec3<f64>) -> Coord3D<f64> {
    let [x, y, z] = p.0;
    Coord3D { x, y, z }
}

#[cfg(test)]
mod tests;
