//! The triangles near a sphere, found anew only after it has moved a little.

use super::DistanceMinimum;
use crate::spec::Vec3;
use crate::system::{Mesh, Shape, Surface};

/// Displacement after which triangles are searched anew, as a fraction of the reach.
const LEEWAY: f64 = 0.02;

/// The triangles on which the distance from a sphere may have a minimum while it moves by less than the leeway.
#[derive(Clone, Debug, Default)]
pub struct NearTriangles {
    /// The place of the search and its reach.
    searched: Option<(Vec3<f64>, f64)>,
    triangles: Vec<u32>,
}

impl NearTriangles {
    /// As [`Surface::distance_minima`], at less cost for a sphere that moves little from call to call.
    pub fn distance_minima(&mut self, surface: &Surface, x: Vec3<f64>, reach: f64, found: &mut Vec<DistanceMinimum>) {
        match &surface.shape {
            Shape::Plane { .. } => surface.distance_minima(x, reach, found),
            Shape::Mesh(mesh) => {
                let p = x - surface.way;
                self.search(mesh, p, reach);
                mesh.minima_among(self.triangles.iter().map(|&t| t as usize), p, reach, found);
            }
        }
    }

    fn search(&mut self, mesh: &Mesh, p: Vec3<f64>, reach: f64) {
        let leeway = LEEWAY * reach;
        let valid = |(place, of): (Vec3<f64>, f64)| of == reach && (p - place).norm() <= leeway;
        if !self.searched.is_some_and(valid) {
            self.searched = Some((p, reach));
            self.triangles.clear();
            self.triangles.extend(mesh.candidates(p, reach, leeway).map(|t| t as u32));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{ContactTable, Forces, PrescribedMotion};

    /// A square of 2 by 50 by 50 triangles, one to a side.
    fn sheet() -> Mesh {
        let squares = (0..50).flat_map(|i| (0..50).map(move |j| [f64::from(i), f64::from(j)]));
        let halves = |[x, y]: [f64; 2]| {
            let at = |i: f64, j: f64| Vec3([x + i, y + j, 0.0]);
            [[at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0)], [at(0.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]]
        };
        Mesh::new(&squares.flat_map(halves).collect::<Vec<_>>()).expect("a surface")
    }

    fn near(mesh: &Mesh, searches: &[([f64; 3], f64)]) -> NearTriangles {
        let mut near = NearTriangles::default();
        searches.iter().for_each(|&(p, reach)| near.search(mesh, Vec3(p), reach));
        near
    }

    #[test]
    fn triangles_are_searched_anew_after_the_leeway_and_those_of_before_forgotten() {
        let mesh = sheet();
        let (begin, reach) = ([20.5, 20.5, 1.0], 2.0);
        let alone = |p: [f64; 3], reach: f64| near(&mesh, &[(p, reach)]).triangles;
        assert!(!alone(begin, reach).is_empty());
        let after = |p: [f64; 3], of: f64| near(&mesh, &[(begin, reach), (p, of)]);
        // The leeway is a fiftieth of the reach: 0.04.
        for (p, of, kept) in [
            (begin, reach, true),
            ([20.539, 20.5, 1.0], reach, true),
            ([20.541, 20.5, 1.0], reach, false),
            ([20.5, 20.5, 0.9], reach, false),
            (begin, 2.5, false),
            (begin, 1.5, false),
            ([30.5, 9.5, 1.0], reach, false),
        ] {
            let found = after(p, of);
            assert_eq!(found.searched, Some(if kept { (Vec3(begin), reach) } else { (Vec3(p), of) }), "{p:?} {of}");
            assert_eq!(found.triangles, if kept { alone(begin, reach) } else { alone(p, of) }, "{p:?} {of}");
        }
    }

    #[test]
    fn a_surface_is_seen_from_where_it_has_moved() {
        let zero = Vec3::zero();
        let surface = |shape| Surface {
            name: "sheet".into(),
            material: 0,
            shape,
            motion: PrescribedMotion::Still,
            velocity: zero,
            way: Vec3([1.0, 2.0, -3.0]),
            age: 0.0,
            force: Forces { contact: zero, friction: zero, van_der_waals: zero },
            contacts: ContactTable::default(),
        };
        let plane = Shape::Plane { point: zero, normal: Vec3([0.0, 0.0, 1.0]) };
        for surface in [surface(plane), surface(Shape::Mesh(sheet()))] {
            let mut near = NearTriangles::default();
            for (height, seen) in [(0.75, true), (1.0, true), (1.01, false)] {
                let (mut found, mut again) = (Vec::new(), Vec::new());
                surface.distance_minima(Vec3([21.25, 22.75, height - 3.0]), 1.0, &mut found);
                near.distance_minima(&surface, Vec3([21.25, 22.75, height - 3.0]), 1.0, &mut again);
                assert_eq!((found.len(), &found), (usize::from(seen), &again), "{height}");
                for minimum in found {
                    assert_eq!((minimum.distance, minimum.n), (height, Vec3([0.0, 0.0, 1.0])));
                    assert_eq!(minimum.place, Vec3([20.25, 20.75, 0.0]));
                }
            }
        }
    }
}
