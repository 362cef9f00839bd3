//! Triangulated surfaces: their topology, and the nearest points to a given point.
//!
//! A sphere touches a surface wherever its distance has a minimum. On one triangle that is the nearest point; where this lies on an edge or a
//! corner, the surface goes on, and it is a minimum only if no triangle around that edge or corner comes nearer. So a sphere has one
//! contact on a face, on an edge and on a corner, however the surface is cut into triangles, and two in a groove. A tree finds the triangles that
//! may hold a minimum.

mod build;
mod near;
mod tree;
mod triangle;

pub use build::Flaw;
pub use near::NearTriangles;
pub use triangle::{Part, nearest};

use crate::spec::Vec3;
use crate::system::{Mesh, Tree};

/// Two minima whose points are closer than this part of their distance are one, found twice by rounding: that of the single precision of STL files bends a flat surface of small triangles by some 1e-5.
const SAME: f64 = 1e-3;

/// A minimum of the distance between a point and a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceMinimum {
    /// Unit vector from the surface to the point that sees it.
    pub n: Vec3<f64>,
    /// Distance, nm: negative behind the surface.
    pub distance: f64,
    /// The place.
    pub place: Vec3<f64>,
    /// The part of the surface that it lies on.
    pub support: Support,
}

/// The part of a surface that a nearest point lies on, and moves along when the point that sees it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Support {
    /// A face.
    Face,
    /// An edge in this direction, a unit vector.
    Edge(Vec3<f64>),
    /// A corner.
    Corner,
}

impl DistanceMinimum {
    /// The vector from the place to the point that sees it, nm.
    pub fn sight(&self) -> Vec3<f64> {
        self.n * self.distance
    }

    /// The change of the [`sight`](Self::sight) when the point that sees it is displaced by `u`.
    pub fn change_of_sight(&self, u: Vec3<f64>) -> Vec3<f64> {
        match self.support {
            Support::Face => self.n * self.n.dot(u),
            Support::Edge(along) => u - along * along.dot(u),
            Support::Corner => u,
        }
    }
}

/// The nearest point of a triangle.
struct Candidate {
    triangle: usize,
    part: Part,
    place: Vec3<f64>,
    square: f64,
}

impl Mesh {
    /// What a closed one bounds, nm^3; negative if its normals point inwards.
    pub fn volume(&self) -> f64 {
        let under = |t| {
            let [a, b, c] = self.triangle(t);
            a.dot(b.cross(c)) / 6.0
        };
        (0..self.triangles.len()).map(under).sum()
    }

    /// The corners of a triangle.
    pub fn triangle(&self, t: usize) -> [Vec3<f64>; 3] {
        self.triangles[t].map(|v| self.vertices[v as usize])
    }

    /// Adds to `found` every minimum of the distance from `p` within `reach`, the nearest first.
    pub fn distance_minima(&self, p: Vec3<f64>, reach: f64, found: &mut Vec<DistanceMinimum>) {
        self.minima_among(self.candidates(p, reach, 0.0), p, reach, found);
    }

    fn tree(&self) -> &Tree {
        self.tree.0.get_or_init(|| Box::new(Tree::of(self)))
    }

    /// The triangles on which the distance from a point within `leeway` of `p` may have a minimum within `reach`.
    fn candidates(&self, p: Vec3<f64>, reach: f64, leeway: f64) -> impl Iterator<Item = usize> {
        self.tree().candidates(p, reach, leeway)
    }

    /// As [`distance_minima`](Self::distance_minima), on these triangles alone.
    fn minima_among(
        &self,
        triangles: impl Iterator<Item = usize>,
        p: Vec3<f64>,
        reach: f64,
        found: &mut Vec<DistanceMinimum>,
    ) {
        let all = triangles.map(|triangle| self.candidate(triangle, p));
        let mut candidates: Vec<Candidate> = all.filter(|candidate| candidate.square <= reach * reach).collect();
        candidates.sort_by(|a, b| a.square.total_cmp(&b.square).then(a.triangle.cmp(&b.triangle)));
        let first = found.len();
        for (k, candidate) in candidates.iter().enumerate() {
            let distance = candidate.square.sqrt();
            let n = (p - candidate.place) * (1.0 / distance);
            let behind = self.closed && n.dot(self.outward(candidate)) < 0.0;
            let minimum = DistanceMinimum { n, distance, place: candidate.place, support: self.support(candidate) };
            // From inside a body only its nearest place is seen: the way out.
            if k == 0 && behind {
                found.push(DistanceMinimum { n: -n, distance: -distance, ..minimum });
                return;
            }
            let twice = || found[first..].iter().any(|seen| (seen.place - candidate.place).norm() <= SAME * distance);
            if !behind && !self.goes_on_nearer(candidate, p) && !twice() {
                found.push(minimum);
            }
        }
    }

    fn candidate(&self, triangle: usize, p: Vec3<f64>) -> Candidate {
        let (place, part) = nearest(self.triangle(triangle), p);
        Candidate { triangle, part, place, square: (p - place).dot(p - place) }
    }

    /// Whether another triangle comes nearer that holds the edge or the corner on which a candidate lies.
    fn goes_on_nearer(&self, candidate: &Candidate, p: Vec3<f64>) -> bool {
        let nearer = |triangle: u32| self.candidate(triangle as usize, p).square < candidate.square;
        match candidate.part {
            Part::Face => false,
            Part::Edge(k) => Some(self.across[candidate.triangle][k]).filter(|&t| t != u32::MAX).is_some_and(nearer),
            Part::Corner(k) => self.tree().around(self.triangles[candidate.triangle][k]).iter().any(|&t| nearer(t)),
        }
    }

    fn support(&self, candidate: &Candidate) -> Support {
        match candidate.part {
            Part::Face => Support::Face,
            Part::Edge(k) => {
                let corners = self.triangle(candidate.triangle);
                let along = corners[(k + 1) % 3] - corners[k];
                Support::Edge(along * (1.0 / along.norm()))
            }
            Part::Corner(_) => Support::Corner,
        }
    }

    /// Normal of a face, sum of those at an edge, or of those around a corner: a point whose nearest place is the candidate's is outside if it lies in this direction.
    fn outward(&self, candidate: &Candidate) -> Vec3<f64> {
        let t = candidate.triangle;
        match candidate.part {
            Part::Face => self.faces[t],
            Part::Edge(k) => self.faces[t] + self.faces[self.across[t][k] as usize],
            Part::Corner(k) => self.corners[self.triangles[t][k] as usize],
        }
    }
}

#[cfg(test)]
mod tests;
