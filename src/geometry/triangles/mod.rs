//! Triangulated surfaces: their topology, and the nearest points to a given point.
//!
//! A sphere touches a surface wherever its distance has a minimum. On one triangle that is the nearest point; where this lies on an edge or a
//! corner, the surface goes on, and it is a minimum only if no triangle around that edge or corner comes nearer. So a sphere has one
//! contact on a face, on an edge and on a corner, however the surface is cut into triangles, and two in a groove.

mod build;
mod triangle;

pub use build::Flaw;
pub use triangle::{Part, nearest};

use crate::spec::Vec3;
use crate::system::Mesh;

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

    /// Adds to `found` the nearest place within `reach` of `p`, then every other minimum of the distance within `touch`.
    pub fn distance_minima(&self, p: Vec3<f64>, reach: f64, touch: f64, found: &mut Vec<DistanceMinimum>) {
        let [low, high] = self.bounds;
        if (0..3).any(|a| p.0[a] < low.0[a] - reach || p.0[a] > high.0[a] + reach) {
            return;
        }
        let mut candidates: Vec<Candidate> = (0..self.triangles.len())
            .filter(|&t| (p - self.vertices[self.triangles[t][0] as usize]).dot(self.faces[t]).abs() <= reach)
            .map(|t| {
                let (place, part) = nearest(self.triangle(t), p);
                Candidate { triangle: t, part, place, square: (p - place).dot(p - place) }
            })
            .filter(|candidate| candidate.square <= reach * reach)
            .collect();
        candidates.sort_by(|a, b| a.square.total_cmp(&b.square).then(a.triangle.cmp(&b.triangle)));
        let first = found.len();
        for (k, candidate) in candidates.iter().enumerate() {
            let is_nearest = k == 0;
            if !is_nearest && candidate.square >= touch * touch {
                return;
            }
            let passed =
                candidates[..k].iter().any(|other| other.square < candidate.square && self.share(candidate, other));
            let distance = candidate.square.sqrt();
            let twice = found[first..].iter().any(|seen| (seen.place - candidate.place).norm() <= SAME * distance);
            let n = (p - candidate.place) * (1.0 / distance);
            let behind = self.closed && n.dot(self.outward(candidate)) < 0.0;
            // From inside a body nothing but its nearest place is seen: the way out.
            if is_nearest && behind {
                found.push(DistanceMinimum { n: -n, distance: -distance, place: candidate.place });
                return;
            }
            if !passed && !twice && !behind {
                found.push(DistanceMinimum { n, distance, place: candidate.place });
            }
        }
    }

    /// Whether another triangle holds the edge or the corner that a candidate lies on.
    fn share(&self, candidate: &Candidate, other: &Candidate) -> bool {
        match candidate.part {
            Part::Face => false,
            Part::Edge(k) => self.across[candidate.triangle][k] as usize == other.triangle,
            Part::Corner(k) => self.triangles[other.triangle].contains(&self.triangles[candidate.triangle][k]),
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
