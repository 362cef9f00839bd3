//! One contact for one contact, wherever it is and however the surface is cut.

use super::*;
use crate::spec::Real;
use crate::system::Leaf;
use proptest::prelude::*;
use rstar::{AABB, RTree};

type Corners = [Vec3<f64>; 3];

/// The surface of a box from the origin to `sides`, each face cut into `cuts` by `cuts` squares of two triangles.
fn cuboid(sides: [f64; 3], cuts: usize) -> Vec<Corners> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for far in [false, true] {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let corner = |i: usize, j: usize| {
                let mut x = [0.0; 3];
                x[axis] = if far { sides[axis] } else { 0.0 };
                (x[u], x[v]) = (sides[u] * i as f64 / cuts as f64, sides[v] * j as f64 / cuts as f64);
                Vec3(x)
            };
            for (i, j) in (0..cuts).flat_map(|i| (0..cuts).map(move |j| (i, j))) {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                let halves = [[a, b, c], [a, c, d]];
                triangles.extend(if far { halves } else { halves.map(|[a, b, c]| [a, c, b]) });
            }
        }
    }
    triangles
}

/// Every triangle cut into four.
fn quartered(triangles: &[Corners]) -> Vec<Corners> {
    let cut = |&[a, b, c]: &Corners| {
        let [ab, bc, ca] = [(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5];
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    };
    triangles.iter().flat_map(cut).collect()
}

/// A rotation about an axis.
fn turned(x: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Vec3<f64> {
    let n = axis * (1.0 / axis.norm());
    let (sin, cos) = (Real::sin(angle), Real::cos(angle));
    x * cos + n.cross(x) * sin + n * (n.dot(x) * (1.0 - cos))
}

fn mesh(triangles: &[Corners]) -> Mesh {
    Mesh::new(triangles).expect("a surface")
}

/// A triangle that every search finds.
fn anywhere(triangle: usize) -> Leaf {
    let [low, high] = [-1e9, 1e9f64].map(|place| [place, place, place, place.signum(), place.signum(), place.signum()]);
    Leaf { triangle, envelope: AABB::from_corners(low, high) }
}

fn seen(mesh: &Mesh, p: Vec3<f64>, touch: f64) -> Vec<DistanceMinimum> {
    let mut found = Vec::new();
    mesh.distance_minima(p, touch, &mut found);
    found
}

fn vector(range: std::ops::Range<f64>) -> impl Strategy<Value = Vec3<f64>> {
    prop::array::uniform3(range).prop_map(Vec3)
}

/// The nearest point of a box.
fn clamped(p: Vec3<f64>, sides: [f64; 3]) -> Vec3<f64> {
    Vec3(std::array::from_fn(|a| p.0[a].clamp(0.0, sides[a])))
}

const SIDES: [f64; 3] = [2.0, 3.0, 4.0];

/// Places where rounding may go either way: on corners, edges, diagonals and middles, beside random ones.
fn places() -> impl Strategy<Value = Vec3<f64>> {
    let coordinate = |side: f64| {
        prop_oneof![
            -1.0..side + 1.0,
            prop::sample::select(vec![-0.5, 0.0, 0.25, 0.5, 0.75, 1.0, 1.25]).prop_map(move |part| part * side)
        ]
    };
    (coordinate(2.0), coordinate(3.0), coordinate(4.0)).prop_map(|(x, y, z)| Vec3([x, y, z]))
}

proptest! {
    #[test]
    fn a_box_has_one_contact_from_everywhere_outside(p in places(), cuts in 1usize..4) {
        let nearest = clamped(p, SIDES);
        prop_assume!((p - nearest).norm() > 1e-3);
        let found = seen(&mesh(&cuboid(SIDES, cuts)), p, 50.0);
        prop_assert_eq!(found.len(), 1, "{:?}", found);
        prop_assert!((found[0].place - nearest).norm() < 1e-12);
        prop_assert!((found[0].distance - (p - nearest).norm()).abs() < 1e-12);
        prop_assert!((found[0].n * found[0].distance - (p - nearest)).norm() < 1e-12);
    }

    #[test]
    fn inside_a_box_the_way_out_is_seen(p in (0.05..1.95, 0.05..2.95, 0.05..3.95)) {
        let p = Vec3::<f64>([p.0, p.1, p.2]);
        let depth = (0..3).map(|a| p.0[a].min(SIDES[a] - p.0[a])).fold(f64::INFINITY, f64::min);
        let found = seen(&mesh(&cuboid(SIDES, 2)), p, 50.0);
        prop_assert_eq!(found.len(), 1);
        prop_assert!((found[0].distance + depth).abs() < 1e-12);
    }

    #[test]
    fn finer_triangles_change_nothing(corners in prop::array::uniform4(vector(-2.0..2.0)), p in vector(-4.0..4.0)) {
        let [a, b, c, d] = corners;
        let volume = (b - a).cross(c - a).dot(d - a);
        prop_assume!(volume.abs() > 1.0);
        let [c, d] = if volume > 0.0 { [c, d] } else { [d, c] };
        let coarse = [[a, c, b], [a, b, d], [b, c, d], [a, d, c]];
        let (fine, coarse) = (mesh(&quartered(&quartered(&coarse))), mesh(&coarse));
        let (few, many) = (seen(&coarse, p, 50.0), seen(&fine, p, 50.0));
        prop_assert_eq!((few.len(), many.len()), (1, 1));
        prop_assert!((few[0].place - many[0].place).norm() < 1e-9 && (few[0].n - many[0].n).norm() < 1e-6);
    }

    #[test]
    fn a_tree_finds_what_looking_at_every_triangle_finds(p in places(), cuts in 1usize..5, reach in 0.1..9.0, open in any::<bool>(), order in any::<u64>()) {
        // A box, or a box without its last face: its inside is a room with concave corners.
        let mut triangles = cuboid(SIDES, cuts);
        triangles.truncate(triangles.len() - if open { 2 * cuts * cuts } else { 0 });
        let (tree, all) = (mesh(&triangles), mesh(&triangles));
        let leaves = RTree::bulk_load((0..triangles.len()).map(anywhere).collect());
        let every = Tree { leaves, ..Tree::of(&all) };
        all.tree.0.set(Box::new(every)).expect("no tree yet");
        let found = seen(&tree, p, reach);
        // On the surface there is no normal.
        prop_assume!(found.iter().all(|minimum| minimum.distance.abs() > 1e-3));
        prop_assert_eq!(&found, &seen(&all, p, reach));
        // The order of the triangles is of no account, unless several places inside a body are equally near.
        prop_assume!(found.iter().all(|minimum| minimum.distance > 0.0));
        let shift = order as usize % triangles.len();
        triangles.rotate_left(shift);
        let other = seen(&mesh(&triangles), p, reach);
        prop_assert_eq!(found.len(), other.len());
        for a in found {
            prop_assert!(other.iter().any(|b| (a.place - b.place).norm() < 1e-9 && (a.n - b.n).norm() < 1e-6), "{:?} {:?}", a, other);
        }
    }

    #[test]
    fn a_turned_surface_is_seen_turned(p in places(), axis in vector(-1.0..1.0), angle in 0.0..6.0) {
        prop_assume!(axis.norm() > 0.1 && (p - clamped(p, SIDES)).norm() > 1e-3);
        let turn = |x: Vec3<f64>| turned(x, axis, angle);
        let straight = seen(&mesh(&cuboid(SIDES, 2)), p, 50.0);
        let tilted: Vec<Corners> = cuboid(SIDES, 2).into_iter().map(|triangle| triangle.map(turn)).collect();
        let tilted = seen(&mesh(&tilted), turn(p), 50.0);
        prop_assert_eq!((straight.len(), tilted.len()), (1, 1));
        prop_assert!((turn(straight[0].place) - tilted[0].place).norm() < 1e-9);
        prop_assert!((turn(straight[0].n) - tilted[0].n).norm() < 1e-7);
    }

    #[test]
    fn the_rounding_of_files_makes_no_second_contact(axis in vector(-1.0..1.0), angle in 0.0..6.0, place in (0usize..8, 0usize..8), lift in 0.1..1.0) {
        prop_assume!(axis.norm() > 0.1);
        // A box far from the origin, in the single precision of STL files: flat no more.
        let put = |x: Vec3<f64>| turned(x, axis, angle) + Vec3([300.0, -200.0, 100.0]);
        let rounded = |x: Vec3<f64>| Vec3(put(x).0.map(|c| f64::from(c as f32)));
        let cut: Vec<Corners> = cuboid([8.0; 3], 8).into_iter().map(|triangle| triangle.map(rounded)).collect();
        let body = mesh(&cut);
        // Above corners, edges and diagonals of its upper face.
        for [x, y] in [[0.5, 0.5], [0.5, 0.0], [0.0, 0.5], [0.0, 0.0]] {
            let p = Vec3([place.0 as f64 + x, place.1 as f64 + y, 8.0 + lift]);
            prop_assert_eq!(seen(&body, put(p), 1.1 * lift).len(), 1);
        }
    }

    #[test]
    fn the_way_from_face_to_edge_to_face_has_no_jump(from in vector(-3.0..6.0), to in vector(-3.0..6.0)) {
        let body = mesh(&cuboid(SIDES, 2));
        let at = |k: usize| from + (to - from) * (k as f64 / 200.0);
        let outside = (0..=200).all(|k| (at(k) - clamped(at(k), SIDES)).norm() > 0.3);
        prop_assume!(outside);
        let step = (to - from).norm() / 200.0;
        for k in 0..200 {
            let (before, after) = (seen(&body, at(k), 50.0), seen(&body, at(k + 1), 50.0));
            prop_assert!((before[0].distance - after[0].distance).abs() <= step * (1.0 + 1e-9));
            prop_assert!((before[0].n - after[0].n).norm() <= 2.0 * step / 0.3);
            // Springs are found again by place: it moves no farther than the sphere.
            prop_assert!((before[0].place - after[0].place).norm() <= step * (1.0 + 1e-9) + 1e-12);
        }
    }
}

#[test]
fn a_box_bounds_its_volume_and_turned_inside_out_less_than_none() {
    let triangles = cuboid([1.0, 2.0, 3.0], 2);
    let turned: Vec<Corners> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    assert!((mesh(&triangles).volume() - 6.0).abs() < 1e-12 && (mesh(&turned).volume() + 6.0).abs() < 1e-12);
}

#[test]
fn a_square_of_two_triangles_is_a_plane_on_both_sides_and_ends_at_its_border() {
    let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vec3([x, y, 0.0]));
    let sheet = mesh(&[[a, b, c], [a, c, d]]);
    assert!(!sheet.is_closed());
    for height in [0.3, -0.3] {
        // On the diagonal, beside it, at a corner.
        for [x, y] in [[0.5, 0.5], [0.1, 0.9], [0.0, 0.0], [1.0, 0.2]] {
            let found = seen(&sheet, Vec3([x, y, height]), 1.0);
            assert_eq!(found.len(), 1);
            assert_eq!((found[0].place, found[0].distance), (Vec3([x, y, 0.0]), 0.3));
        }
    }
    let beyond = seen(&sheet, Vec3([1.4, 0.5, 0.3]), 1.0);
    assert_eq!(beyond.len(), 1);
    assert!((beyond[0].distance - 0.5).abs() < 1e-15);
}

#[test]
fn a_sphere_in_a_groove_has_two_contacts() {
    let at = |x: f64, y: f64, z: f64| Vec3([x, y, z]);
    let (low, high) = ([at(0.0, -5.0, 0.0), at(0.0, 5.0, 0.0)], 4.0);
    let wall = |side: f64| [at(side * high, -5.0, high), at(side * high, 5.0, high)];
    let ([l, k], [r, s]) = (wall(-1.0), wall(1.0));
    let groove = mesh(&[[l, low[0], low[1]], [l, low[1], k], [low[0], r, s], [low[0], s, low[1]]]);
    let found = seen(&groove, at(0.0, 0.3, 2f64.sqrt()), 1.1);
    assert_eq!(found.len(), 2);
    assert!(found.iter().all(|seen| (seen.distance - 1.0).abs() < 1e-12));
    // Beside the bottom of one wall only the nearer one is within touch.
    assert_eq!(seen(&groove, at(1.5, 0.3, 2f64.sqrt() + 1.5), 1.1).len(), 1);
}

#[test]
fn what_is_no_surface_is_refused() {
    let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3);
    let flaw = |triangles: &[Corners]| Mesh::new(triangles).expect_err("no surface");
    assert_eq!(flaw(&[]), Flaw::Empty);
    assert_eq!(flaw(&[[a, b, b], [a, b, (a + b) * 0.5]]), Flaw::Empty);
    assert_eq!(flaw(&[[a, b, c], [a, b, b], [a, b, d]]), Flaw::Edge(1, 3));
    assert_eq!(flaw(&[[a, b, Vec3([f64::NAN, 0.0, 0.0])]]), Flaw::NotFinite(1));
}

#[test]
fn a_triangle_without_area_is_dropped() {
    let [a, b, c] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Vec3);
    assert_eq!(mesh(&[[a, b, c], [a, b, b]]).triangles(), mesh(&[[a, b, c]]).triangles());
}

#[test]
fn above_a_flat_wall_only_the_triangles_below_are_looked_at() {
    let cuts = 20;
    let all = cuboid([20.0; 3], cuts);
    let body = mesh(&all);
    for axis in 0..3 {
        for height in [21.0, -1.0] {
            let mut p = [8.5, 9.25, 10.5];
            p[axis] = height;
            let looked_at = |reach: f64, leeway: f64| body.candidates(Vec3(p), reach, leeway).count();
            assert_eq!(looked_at(1.5, 0.0), 2, "{axis} {height}");
            assert_eq!(looked_at(0.99, 0.0), 0);
            assert!(looked_at(0.99, 0.02) > 0 && looked_at(1.5, 2.0) > 2);
        }
    }
}

#[test]
fn a_minimum_is_seen_up_to_its_distance_and_not_farther() {
    let body = mesh(&cuboid(SIDES, 2));
    for (p, distance) in [([1.0, 1.0, 6.0], 2.0), ([5.0, 1.0, 8.0], 5.0), ([-2.0, -3.0, -6.0], 7.0)] {
        assert_eq!(seen(&body, Vec3(p), distance).len(), 1, "{p:?}");
        assert_eq!(seen(&body, Vec3(p), 0.999 * distance).len(), 0, "{p:?}");
    }
}

#[test]
fn sight_changes_as_the_point_that_sees_moves_along_its_support() {
    let body = mesh(&cuboid(SIDES, 1));
    let u = Vec3([1e-6, -2e-6, 3e-6]);
    for p in [[0.5, 1.0, 6.0], [5.0, 1.5, 8.0], [-1.0, -2.0, -3.0], [1.0, -1.0, -1.0]] {
        let (before, after) = (seen(&body, Vec3(p), 50.0)[0], seen(&body, Vec3(p) + u, 50.0)[0]);
        assert!((before.sight() - (Vec3(p) - before.place)).norm() < 1e-12);
        assert!((after.sight() - before.sight() - before.change_of_sight(u)).norm() < 1e-9, "{p:?}");
    }
}

#[test]
fn a_sliver_has_no_area_if_it_is_lower_than_the_weld() {
    for size in [1000.0, 1e-3] {
        // The extent is the square root of two: corners nearer than a millionth of it are one.
        let at = |x: f64, y: f64| Vec3([x - 0.5, y - 0.5, 0.0]) * size;
        for turn in 0..3 {
            let sliver = |height: f64| {
                let mut low = [at(0.0, 0.0), at(1.0, 0.0), at(0.5, -height)];
                low.rotate_left(turn);
                mesh(&[low, [at(1.0, 0.0), at(0.0, 0.0), at(1.0, 1.0)]]).triangles().len()
            };
            assert_eq!([0.0, 1.3e-6, 1.5e-6].map(sliver), [1, 1, 2], "{size} {turn}");
        }
        let gap = |gap: f64| {
            let upper = [at(0.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
            let lower = [at(gap, 0.0), at(1.0, 0.0), at(1.0, 1.0)];
            mesh(&[upper, lower]).vertices().len()
        };
        assert_eq!([0.0, 1.3e-6, 1.5e-6].map(gap), [4, 4, 5], "{size}");
    }
    let point = Vec3([1.0, 2.0, 3.0]);
    assert_eq!(Mesh::new(&[[point; 3]]).expect_err("a point"), Flaw::Empty);
}

#[test]
fn from_inside_the_normal_leads_out() {
    let found = seen(&mesh(&cuboid(SIDES, 2)), Vec3([0.5, 1.0, 2.5]), 50.0);
    assert!(found.len() == 1 && found[0].distance < 0.0 && found[0].support == Support::Face, "{found:?}");
    assert!(
        (found[0].n - Vec3([-1.0, 0.0, 0.0])).norm() < 1e-14 && (found[0].place - Vec3([0.0, 1.0, 2.5])).norm() < 1e-14
    );
    assert!((mesh(&cuboid(SIDES, 1)).displaced(Vec3([1.0, -2.0, 3.0])).volume() - 24.0).abs() < 1e-12);
}

#[test]
fn contacts_in_a_shallow_groove_are_two_at_any_distance() {
    let at = |x: f64, y: f64| Vec3([x, y, 0.1 * x.abs()]);
    let [l, k, a, b, r, s] = [at(-4.0, -5.0), at(-4.0, 5.0), at(0.0, -5.0), at(0.0, 5.0), at(4.0, -5.0), at(4.0, 5.0)];
    let groove = mesh(&[[l, a, b], [l, b, k], [a, r, s], [a, s, b]]);
    for height in [0.01, 1.0, 20.0] {
        let found = seen(&groove, Vec3([0.0, 0.3, height]), 1.1 * height);
        assert_eq!(found.len(), 2, "{height}");
        assert!(found.iter().all(|seen| (seen.distance - height / 1.01f64.sqrt()).abs() < 1e-12 * height));
    }
}

#[test]
fn normals_of_corners_are_weighted_by_angles() {
    let body = mesh(&cuboid(SIDES, 1));
    // Three right angles meet at a corner, however the faces are cut.
    for (corner, normal) in body.vertices.iter().zip(&body.corners) {
        let outward = Vec3(std::array::from_fn(|a| if corner.0[a] > 0.0 { 1.0 } else { -1.0 }));
        assert!((*normal - outward * (0.5 * f64::pi())).norm() < 1e-12, "{corner:?} {normal:?}");
    }
    assert_eq!(body.bounds(), [Vec3::zero(), Vec3(SIDES)]);
    let by = Vec3([1.0, -2.0, 3.0]);
    let other = body.displaced(by);
    assert_eq!(other.bounds(), [by, Vec3(SIDES) + by]);
    assert_eq!(other.vertices()[0], body.vertices()[0] + by);
    assert_eq!((other.triangles(), other.is_closed()), (body.triangles(), true));
}

#[test]
fn flaws_are_told_with_the_numbers_of_triangles() {
    for (flaw, text) in [
        (Flaw::Empty, "has no triangle with an area"),
        (Flaw::NotFinite(3), "triangle 3 has a coordinate that is not a finite number"),
        (
            Flaw::Edge(1, 2),
            "triangles 1 and 2 pass a common edge in the same direction, expected opposite normals or two triangles to an edge",
        ),
    ] {
        assert_eq!(flaw.to_string(), text);
    }
    let [a, b, c] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Vec3);
    let wrong = Vec3([0.0, f64::INFINITY, 0.0]);
    assert_eq!(Mesh::new(&[[a, b, c], [a, wrong, b]]).expect_err("not finite"), Flaw::NotFinite(2));
}
