use super::*;
use proptest::prelude::*;
use std::f64::consts::PI;

fn close(found: Measures, volume: f64, surface: f64, curvature: f64) -> bool {
    let near = |x: f64, y: f64| (x - y).abs() <= 1e-12 * y.abs().max(1.0);
    near(found.volume, volume) && near(found.surface, surface) && near(found.curvature, curvature)
}

/// A grid of points, turned and moved: many of them on faces and edges, some exactly so and some to rounding.
fn block(n: [usize; 3], angle: f64) -> Vec<Vec3<f64>> {
    let (s, c) = angle.sin_cos();
    let turned = |[x, y, z]: [f64; 3]| {
        let [x, y] = [c * x - s * y, s * x + c * y];
        let [y, z] = [c * y - s * z, s * y + c * z];
        Vec3([x, y, z])
    };
    (0..n[0] * n[1] * n[2]).map(|k| turned([k % n[0], k / n[0] % n[1], k / n[0] / n[1]].map(|k| k as f64))).collect()
}

proptest! {
    #[test]
    fn a_block_has_its_volume_surface_and_curvature_however_it_is_turned(
        n in [1usize..5, 1usize..5, 1usize..5], angle in prop_oneof![Just(0.0), 0.0..6.3],
    ) {
        let [a, b, c] = n.map(|k| (k - 1) as f64);
        let found = measures(&block(n, angle));
        prop_assert!(close(found, a * b * c, 2.0 * (a * b + b * c + c * a), PI * (a + b + c)), "{found:?}");
    }

    #[test]
    fn no_point_is_outside_and_the_mean_width_is_that_of_the_projections(
        points in prop::collection::vec([-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64].prop_map(Vec3), 5..60),
    ) {
        let hull = Polyhedron::new(&points, tetrahedron(&points).unwrap());
        for face in (0..hull.faces.len()).filter(|&k| !hull.faces[k].removed) {
            prop_assert!((0..points.len()).all(|p| hull.above(face, p) <= 0.0));
        }
        // Steiner: the curvature is two pi times the mean width; here by the midpoint rule over directions.
        let steps = 60;
        let mut mean = 0.0;
        for k in 0..steps {
            for l in 0..2 * steps {
                let z = (2 * k + 1) as f64 / steps as f64 - 1.0;
                let (s, c) = (PI * l as f64 / steps as f64).sin_cos();
                let u = Vec3([(1.0 - z * z).sqrt() * c, (1.0 - z * z).sqrt() * s, z]);
                mean += points.iter().map(|p| p.dot(u)).fold(f64::MIN, f64::max);
            }
        }
        let width = 2.0 * mean / (2 * steps * steps) as f64;
        let found = measures(&points).curvature;
        prop_assert!((found / (2.0 * PI * width) - 1.0).abs() < 2e-3, "{found} {width}");
    }
}

#[test]
fn points_that_coincide_or_lie_in_a_line_have_a_hull() {
    let p = Vec3([1.0, -2.0, 0.3]);
    assert!(close(measures(&[p]), 0.0, 0.0, 0.0));
    assert!(close(measures(&[p, p, p]), 0.0, 0.0, 0.0));
    let line: Vec<_> = (0..7).map(|k| p * (0.1 * f64::from(k))).collect();
    assert!(close(measures(&line), 0.0, 0.0, 0.6 * PI * p.norm()));
}

#[test]
fn a_polygon_has_two_sides_however_small_it_is_and_wherever_it_lies() {
    for size in [1e-6, 1.0, 1e6] {
        for axis in 0..3 {
            let corner = |x: f64, y: f64| {
                let mut place = [0.0, 3.0 * x, 4.0 * y];
                place.rotate_left(axis);
                Vec3(place) * size
            };
            let triangle = [corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(0.2, 0.2)];
            let found = measures(&triangle);
            let found = [found.volume, found.surface / (size * size), found.curvature / size];
            let expected = [0.0, 12.0, 6.0 * PI];
            assert!(found.iter().zip(expected).all(|(found, known)| (found - known).abs() < 1e-10), "{size} {found:?}");
        }
    }
}

#[test]
fn the_inner_radius_is_the_distance_of_the_nearest_face() {
    let corners =
        |[x, y, z]: [[f64; 2]; 3]| (0..8).map(|k| Vec3([x[k & 1], y[k >> 1 & 1], z[k >> 2]])).collect::<Vec<_>>();
    for (sides, expected) in [
        ([[-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0]], 1.0),
        ([[-1.0, 3.0], [-2.0, 0.5], [-4.0, 4.0]], 0.5),
        ([[-3.0, 3.0], [-3.0, 3.0], [-0.25, 7.0]], 0.25),
    ] {
        assert!((inner_radius(&corners(sides)) - expected).abs() < 1e-15, "{sides:?}");
    }
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Vec3);
    assert!((inner_radius(&tetrahedron) - 1.0 / 3f64.sqrt()).abs() < 1e-15);
    // An octahedron, and points inside it that count for nothing.
    let six = [[2.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, -2.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, -2.0]];
    let points: Vec<_> = six.iter().chain(&[[0.5, 0.5, 0.5], [0.0; 3]]).map(|&x| Vec3(x)).collect();
    assert!((inner_radius(&points) - 2.0 / 3f64.sqrt()).abs() < 1e-15);
}

#[test]
fn polyhedra_have_their_volume_surface_and_curvature_in_any_order_of_points() {
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Vec3);
    // Edges of sqrt(8), dihedral angles whose cosine is a third.
    let edge = 8f64.sqrt();
    let curvature = 0.5 * 6.0 * edge * (PI - (1.0f64 / 3.0).acos());
    for turn in 0..4 {
        let mut points = tetrahedron;
        points.rotate_left(turn);
        assert!(close(measures(&points), 8.0 / 3.0, 8.0 * 3f64.sqrt(), curvature), "{:?}", measures(&points));
        points.swap(0, 1);
        assert!(close(measures(&points), 8.0 / 3.0, 8.0 * 3f64.sqrt(), curvature), "{:?}", measures(&points));
    }
    // Flat ones have two sides, wherever they lie: a triangle with the sides 3, 4 and 5, and a point in it.
    for place in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let flat = [[0.0, 0.0, 1.0], [3.0, 0.0, 1.0], [0.0, 4.0, 1.0], [1.0, 1.0, 1.0]];
        let flat = flat.map(|x| Vec3(place.map(|k: usize| x[k])));
        assert!(close(measures(&flat), 0.0, 12.0, 12.0 * PI / 2.0), "{:?}", measures(&flat));
    }
    // Tilted, so that it looks shortest along the axis that has to be left out.
    let tilted = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.125], [0.0, 1.0, 0.25], [1.0, 1.0, 0.375]].map(Vec3);
    let (a, b) = (1.015625f64.sqrt(), 1.0625f64.sqrt());
    assert!(close(measures(&tilted), 0.0, 2.0 * 1.078125f64.sqrt(), PI * (a + b)), "{:?}", measures(&tilted));
}
