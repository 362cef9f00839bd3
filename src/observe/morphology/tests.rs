//! The values are independent: computed with 50 digits from the definitions.

use super::*;
use crate::geometry::{SphereExtent, gyration_radius, square_gyration_radius};
use crate::initial::aggregate::components;
use crate::interrupt::Interrupt;
use crate::spec::Real;
use proptest::prelude::*;

fn spheres(places: &[[f64; 3]], radius: f64) -> Vec<Sphere> {
    places.iter().map(|&x| Sphere { centre: Vec3(x), radius }).collect()
}

fn chain(n: usize, r: f64) -> Vec<Sphere> {
    (0..n).map(|k| Sphere { centre: Vec3([2.0 * r * k as f64, 0.0, 0.0]), radius: r }).collect()
}

fn cube(d: f64) -> Vec<Sphere> {
    let corner = |k: usize| Vec3([k & 4, k & 2, k & 1].map(|bit| if bit > 0 { d } else { 0.0 }));
    (0..8).map(|k| Sphere { centre: corner(k), radius: 0.5 * d }).collect()
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-14 * expected.abs()
}

#[test]
fn gyration_radii_of_a_chain_and_of_scattered_points() {
    let radius = |s: &[Sphere]| gyration_radius(s, SphereExtent::Centres);
    assert_eq!(radius(&chain(1, 14.0)), 0.0);
    assert!(close(radius(&chain(3, 14.0)), 22.861904265976328));
    let scattered = [[1.0, 2.0, 3.0], [-4.0, 0.5, 2.5], [1e-9, -3e-9, 2e-9], [0.0, 0.0, 1.0]];
    assert!(close(radius(&spheres(&scattered, 1.0)), 2.404423007643934));
    assert!(close(radius(&spheres(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 1.0)), 0.75));
}

#[test]
fn alone_a_sphere_has_its_radius_where_its_extent_counts() {
    assert!(close(gyration_radius(&chain(1, 2.0), SphereExtent::Radii), 2.0));
    let (bare, full) = (
        square_gyration_radius(&cube(2.0), SphereExtent::Centres),
        square_gyration_radius(&cube(2.0), SphereExtent::Radii),
    );
    assert!(close(full - bare, 1.0));
}

#[test]
fn neighbours_are_nearer_than_a_hundredth_of_the_diameter() {
    assert_eq!(coordination_number(&chain(1, 14.0)), 0.0);
    let loose = |d: f64| spheres(&[[0.0; 3], [d, 0.0, 0.0], [2.0 * d, 0.0, 0.0]], 14.0);
    assert!(close(coordination_number(&loose(28.027999999999995)), 4.0 / 3.0));
    assert!(close(coordination_number(&loose(28.2772)), 4.0 / 3.0));
    assert_eq!(
        (coordination_number(&loose(28.2828)), components(&loose(28.2828), &Interrupt::default()).unwrap()),
        (0.0, 3)
    );
    assert_eq!(coordination_number(&cube(28.0)), 3.0);
    // The gap is 2 % of the smaller diameter and 1/3 % of the mean.
    assert_eq!(
        components(
            &[Sphere { centre: Vec3::zero(), radius: 1.0 }, Sphere { centre: Vec3([12.04, 0.0, 0.0]), radius: 11.0 }],
            &Interrupt::default()
        )
        .unwrap(),
        1
    );
}

#[test]
fn convexity_of_chain_triangle_hexagon_and_octahedron() {
    let value = |s: &[Sphere]| convexity(s).value;
    let r = 14.0;
    assert!(close(value(&chain(1, r)), 1.0));
    assert!(close(value(&chain(3, r)), 0.75));
    let h = 3f64.sqrt();
    let scaled = |places: &[[f64; 3]]| spheres(&places.iter().map(|x| x.map(|c| c * r)).collect::<Vec<_>>(), r);
    assert!(close(value(&scaled(&[[0.0; 3], [2.0, 0.0, 0.0], [1.0, h, 0.0]])), 0.7358363743843776));
    let hexagon =
        [[0.0; 3], [2.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [1.0, h, 0.0], [-1.0, h, 0.0], [1.0, -h, 0.0], [-1.0, -h, 0.0]];
    assert!(close(value(&scaled(&hexagon)), 0.6690906828796954));
    let a = 2f64.sqrt();
    let octahedron = [[a, 0.0, 0.0], [-a, 0.0, 0.0], [0.0, a, 0.0], [0.0, -a, 0.0], [0.0, 0.0, a], [0.0, 0.0, -a]];
    assert!(close(value(&scaled(&octahedron)), 0.6869131527304859));
}

#[test]
fn the_bounds_of_unequal_spheres_hold_two_of_known_hull() {
    // Spheres of radii 2 and 1 at distance 3: caps and a cone that touches both.
    let two = [Sphere { centre: Vec3::zero(), radius: 2.0 }, Sphere { centre: Vec3([3.0, 0.0, 0.0]), radius: 1.0 }];
    let cap = |r: f64, h: f64| f64::pi() * h * h * (r - h / 3.0);
    let (s, c) = (1.0 / 3.0, (8.0f64 / 9.0).sqrt()); // of the half angle of the cone
    let frustum = f64::pi() / 3.0 * (3.0 - s) * c * c * (4.0 + 2.0 + 1.0);
    let hull = cap(2.0, 2.0 + 2.0 * s) + cap(1.0, 1.0 - s) + frustum;
    let exact = 4.0 / 3.0 * f64::pi() * 9.0 / hull;
    let found = convexity(&two);
    assert!((found.value - exact).abs() < found.error && found.error < 0.02, "{found:?} {exact}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]
    #[test]
    fn the_bounds_hold_the_exact_value_of_almost_equal_spheres(
        places in prop::collection::vec([-5.0..5.0f64, -5.0..5.0f64, -5.0..5.0f64], 1..12),
    ) {
        let mut all = spheres(&places, 1.0);
        let exact = convexity(&all).value;
        all[0].radius += 1e-12;
        let found = convexity(&all);
        prop_assert!((found.value - exact).abs() < found.error + 1e-9);
    }
}
