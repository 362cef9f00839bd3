//! Triangulated surfaces and their topology.

use crate::spec::Vec3;
use rstar::{AABB, RTree, RTreeObject};
use serde::{Deserialize, Serialize};
use std::sync::OnceLock;

/// A triangulated surface. A closed one bounds a body, acts on its outside, to which the normals point, and lets nothing in; an open one is a thin
/// sheet and acts on both sides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// Corners, nm.
    pub(crate) vertices: Vec<Vec3<f64>>,
    /// Triangles, by their corners, counterclockwise as seen from outside.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Triangles across the edges; none is `u32::MAX`.
    pub(crate) across: Vec<[u32; 3]>,
    /// Outward normals of the triangles.
    pub(crate) faces: Vec<Vec3<f64>>,
    /// Sums of the normals around each corner, weighted by the angle there.
    pub(crate) corners: Vec<Vec3<f64>>,
    /// Whether every edge has two triangles.
    pub(crate) closed: bool,
    /// Lowest and highest coordinates, nm.
    pub(crate) bounds: [Vec3<f64>; 2],
    /// Made when it is first needed.
    #[serde(skip)]
    pub(crate) tree: MeshTree,
}

/// The tree of a mesh. It follows from the mesh, so that any two are equal.
#[derive(Clone, Debug, Default)]
pub(crate) struct MeshTree(pub(crate) OnceLock<Box<Tree>>);

impl PartialEq for MeshTree {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// A tree over the triangles, and the triangles around each corner.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    pub(crate) leaves: RTree<Leaf>,
    pub(crate) around: Vec<Vec<u32>>,
}

/// A triangle in the tree, with the box of its corners and of the normals on it.
#[derive(Clone, Debug)]
pub(crate) struct Leaf {
    pub(crate) triangle: usize,
    pub(crate) envelope: AABB<[f64; 6]>,
}

impl RTreeObject for Leaf {
    type Envelope = AABB<[f64; 6]>;
    fn envelope(&self) -> Self::Envelope {
        self.envelope
    }
}

impl Mesh {
    /// The corners, nm.
    pub fn vertices(&self) -> &[Vec3<f64>] {
        &self.vertices
    }

    /// The triangles, by their corners.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Lowest and highest coordinates, nm.
    pub fn bounds(&self) -> [Vec3<f64>; 2] {
        self.bounds
    }

    /// True when it bounds a body.
    pub fn is_closed(&self) -> bool {
        self.closed
    }
}
