//! Assembles a surface from separate triangles.

use crate::spec::{Real, Vec3};
use crate::system::Mesh;
use std::collections::BTreeMap;
use std::fmt;

/// Corners closer than this part of the extent of the surface are one.
const WELD: f64 = 1e-6;

/// What keeps triangles from being a surface. Triangles are counted from one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// There is none with an area.
    Empty,
    /// A coordinate is not a finite number.
    NotFinite(usize),
    /// An edge of the two triangles is shared by more than two, or is passed by both in the same direction.
    Edge(usize, usize),
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("has no triangle with an area"),
            Self::NotFinite(t) => write!(f, "triangle {t} has a coordinate that is not a finite number"),
            Self::Edge(s, t) => write!(
                f,
                "triangles {s} and {t} pass a common edge in the same direction, expected opposite normals or two triangles to an edge"
            ),
        }
    }
}

impl Mesh {
    /// A surface of triangles, each counterclockwise as seen from outside. Corners that coincide are joined, triangles without area are
    /// dropped.
    ///
    /// # Errors
    ///
    /// If a coordinate is not finite, no triangle is left, or an edge belongs to more than two triangles or to two of opposite orientation.
    pub fn new(loose: &[[Vec3<f64>; 3]]) -> Result<Self, Flaw> {
        if loose.is_empty() {
            return Err(Flaw::Empty);
        }
        let finite = |corner: &Vec3<f64>| corner.0.iter().all(|x| x.is_finite());
        if let Some(t) = loose.iter().position(|triangle| !triangle.iter().all(finite)) {
            return Err(Flaw::NotFinite(t + 1));
        }
        let all = loose.as_flattened();
        let bounds = bounds(all);
        let weld = WELD * (bounds[1] - bounds[0]).norm();
        let (vertices, names) = welded(all, weld);
        let (mut faces, mut corners) = (Vec::new(), vec![Vec3::zero(); vertices.len()]);
        let (mut triangles, mut numbers): (Vec<[u32; 3]>, Vec<usize>) = (Vec::new(), Vec::new());
        for (t, triangle) in names.chunks_exact(3).enumerate() {
            let triangle = [triangle[0], triangle[1], triangle[2]];
            let [a, b, c] = triangle.map(|v| vertices[v as usize]);
            let area = (b - a).cross(c - a);
            let longest = [b - a, c - b, a - c].iter().map(|side| side.norm()).fold(0.0, f64::max);
            if area.norm() <= weld * longest {
                continue;
            }
            triangles.push(triangle);
            numbers.push(t + 1);
            let normal = area * (1.0 / area.norm());
            faces.push(normal);
            for (v, [at, next, last]) in triangle.iter().zip([[a, b, c], [b, c, a], [c, a, b]]) {
                let (to, back) = (next - at, last - at);
                let angle = Real::acos((to.dot(back) / (to.norm() * back.norm())).clamp(-1.0, 1.0));
                corners[*v as usize] = corners[*v as usize] + normal * angle;
            }
        }
        if triangles.is_empty() {
            return Err(Flaw::Empty);
        }
        let across = across(&triangles, &numbers)?;
        let closed = across.iter().flatten().all(|&neighbour| neighbour != u32::MAX);
        Ok(Self { vertices, triangles, across, faces, corners, closed, bounds, tree: Default::default() })
    }

    /// The same surface displaced.
    pub fn displaced(&self, by: Vec3<f64>) -> Self {
        let mut mesh = Self { tree: Default::default(), ..self.clone() };
        mesh.vertices.iter_mut().chain(&mut mesh.bounds).for_each(|x| *x = *x + by);
        mesh
    }
}

fn bounds(points: &[Vec3<f64>]) -> [Vec3<f64>; 2] {
    let fold = |first: f64, choose: fn(f64, f64) -> f64| {
        Vec3(std::array::from_fn(|a| points.iter().map(|p| p.0[a]).fold(first, choose)))
    };
    [fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)]
}

/// Points that are not closer than `weld` to one before them, and which of those each point is.
fn welded(points: &[Vec3<f64>], weld: f64) -> (Vec<Vec3<f64>>, Vec<u32>) {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&p, &q| points[p].0[0].total_cmp(&points[q].0[0]).then(p.cmp(&q)));
    let (mut vertices, mut names): (Vec<Vec3<f64>>, _) = (Vec::new(), vec![0; points.len()]);
    for p in order {
        let near = vertices.iter().rev().take_while(|v| points[p].0[0] - v.0[0] <= weld);
        let back = near.take(vertices.len()).position(|v| (points[p] - *v).norm() <= weld);
        names[p] = match back {
            Some(back) => vertices.len() - 1 - back,
            None => {
                vertices.push(points[p]);
                vertices.len() - 1
            }
        } as u32;
    }
    (vertices, names)
}

/// The triangle across each edge; `numbers` are those of the triangles in an error.
fn across(triangles: &[[u32; 3]], numbers: &[usize]) -> Result<Vec<[u32; 3]>, Flaw> {
    let mut edges = BTreeMap::new();
    for (number, triangle) in triangles.iter().enumerate() {
        for k in 0..3 {
            if let Some(other) = edges.insert((triangle[k], triangle[(k + 1) % 3]), number) {
                return Err(Flaw::Edge(numbers[other], numbers[number]));
            }
        }
    }
    let neighbour = |from: u32, to: u32| edges.get(&(to, from)).map_or(u32::MAX, |&number| number as u32);
    Ok(triangles.iter().map(|t| std::array::from_fn(|k| neighbour(t[k], t[(k + 1) % 3]))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_coincide_are_one_without_any_tolerance() {
        let [a, b] = [[1.0, 2.0, 3.0], [1.0, 2.0, 3.5]].map(Vec3);
        assert_eq!(welded(&[a, b, a], 0.0), (vec![a, b], vec![0, 1, 0]));
        assert_eq!(welded(&[a, b, a], 0.51), (vec![a], vec![0, 0, 0]));
    }

    #[test]
    fn a_point_is_joined_to_any_before_it_along_x() {
        let points = [[3.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.1, 0.0, 0.0], [3.1, 0.0, 0.0]].map(Vec3);
        let (vertices, names) = welded(&points, 0.2);
        assert_eq!((vertices, names), (vec![points[1], points[2], points[0]], vec![2, 0, 1, 0, 2]));
    }
}
