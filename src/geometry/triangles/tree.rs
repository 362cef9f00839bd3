//! A tree over triangles that finds those on which the distance from a point may have a minimum.
//!
//! There the direction to the point is normal to the surface: to a face, or, on an edge or a corner, to something between the normals of
//! the faces that meet there. So every triangle has a box of six sides, three around its corners and three around the normals on it,
//! and from a point above a flat wall of thousands of triangles only those below it are looked at.

use crate::spec::Vec3;
use crate::system::{Leaf, Mesh, Tree};
use rstar::{AABB, RTree, SelectionFunction};

/// Tolerance of the normals, well above their rounding.
const SLACK: f64 = 1e-6;

impl Tree {
    /// The tree of a mesh.
    pub(super) fn of(mesh: &Mesh) -> Self {
        let mut around = vec![Vec::new(); mesh.vertices.len()];
        let mut on_rim = vec![false; mesh.vertices.len()];
        for (t, (triangle, across)) in mesh.triangles.iter().zip(&mesh.across).enumerate() {
            for (k, &corner) in triangle.iter().enumerate() {
                around[corner as usize].push(t as u32);
                if across[k] == u32::MAX {
                    on_rim[corner as usize] = true;
                    on_rim[triangle[(k + 1) % 3] as usize] = true;
                }
            }
        }
        let leaf = |(t, triangle): (usize, &[u32; 3])| {
            let corners = triangle.map(|v| v as usize);
            let normals: Vec<Vec3<f64>> = if corners.iter().any(|&v| on_rim[v]) {
                // The rim is normal to all directions that lead away from the surface.
                vec![Vec3([-1.0; 3]), Vec3([1.0; 3])]
            } else {
                corners.iter().flat_map(|&v| &around[v]).map(|&t| mesh.faces[t as usize]).collect()
            };
            let places = corners.map(|v| mesh.vertices[v]);
            let bound = |choose: fn(f64, f64) -> f64, slack: f64| {
                let over = |vectors: &[Vec3<f64>], axis: usize| vectors.iter().map(|u| u.0[axis]).reduce(choose);
                std::array::from_fn(|k| match k {
                    0..3 => over(&places, k).expect("three corners"),
                    _ => over(&normals, k - 3).expect("its own normal") + slack,
                })
            };
            let envelope = AABB::from_corners(bound(f64::min, -SLACK), bound(f64::max, SLACK));
            Leaf { triangle: t, envelope }
        };
        let leaves = mesh.triangles.iter().enumerate().map(leaf).collect();
        Self { leaves: RTree::bulk_load(leaves), around }
    }

    /// The triangles on which the distance from a point within `leeway` of `p` may have a minimum within `reach`, in no particular order.
    pub(super) fn candidates(&self, p: Vec3<f64>, reach: f64, leeway: f64) -> impl Iterator<Item = usize> {
        self.leaves.locate_with_selection_function(Normal { p, reach, leeway }).map(|leaf| leaf.triangle)
    }

    /// The triangles that meet at a corner.
    pub(super) fn around(&self, corner: u32) -> &[u32] {
        &self.around[corner as usize]
    }
}

/// Selects the boxes that may hold a minimum of the distance from a point near `p`.
struct Normal {
    p: Vec3<f64>,
    reach: f64,
    leeway: f64,
}

impl Normal {
    fn may_be_in(&self, envelope: &AABB<[f64; 6]>) -> bool {
        let (low, high) = (envelope.lower(), envelope.upper());
        let Self { p, reach, leeway } = self;
        let away: [[f64; 2]; 3] = std::array::from_fn(|k| [p.0[k] - high[k] - leeway, p.0[k] - low[k] + leeway]);
        let gaps = away.map(|[low, high]| low.max(-high).max(0.0));
        let normal = |k: usize| [low[3 + k], high[3 + k]];
        // The vector product of parallel vectors is zero.
        let parallel = |a: usize, b: usize| {
            let (left, right) = (times(away[a], normal(b)), times(away[b], normal(a)));
            left[0] <= right[1] && right[0] <= left[1]
        };
        gaps.iter().map(|gap| gap * gap).sum::<f64>() <= reach * reach
            && parallel(0, 1)
            && parallel(1, 2)
            && parallel(2, 0)
    }
}

impl SelectionFunction<Leaf> for Normal {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 6]>) -> bool {
        self.may_be_in(envelope)
    }
    fn should_unpack_leaf(&self, leaf: &Leaf) -> bool {
        self.may_be_in(&leaf.envelope)
    }
}

/// The product of two intervals.
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    let products = [a * c, a * d, b * c, b * d];
    [products.into_iter().fold(f64::INFINITY, f64::min), products.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}
