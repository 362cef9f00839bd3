//! Capacities of bodies of spheres.

use std::f64::consts::TAU;
use veridem::geometry::Sphere;
use veridem::geometry::capacity::capacity;
use veridem::interrupt::Interrupt;
use veridem::random::Stream;
use veridem::spec::Vec3;

/// The capacity of a body by ten repetitions of `walks` walks each: Student's t for the difference from `expected`, and the ratio of the variance among them to the one that each reports. The bounds leave out one per cent of
/// all sets of seeds: t of nine degrees of freedom, and chi squared.
fn agrees(spheres: &[Sphere], walks: usize, expected: f64) {
    let one = |seed: u64| capacity(spheres, walks, &mut Stream::new(seed, "others"), &Interrupt::default()).unwrap();
    let all: Vec<[f64; 2]> = (0..10).map(one).collect();
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| all.iter().map(of).sum::<f64>() / 10.0;
    let found = mean(&|[capacity, _]| *capacity);
    let variance = mean(&|[capacity, _]| (capacity - found).powi(2)) / 0.9;
    let t = (found - expected) / (variance / 10.0).sqrt();
    assert!(t.abs() < 3.25, "{found}, expected {expected}: t = {t}");
    let chi = 9.0 * variance / mean(&|[_, deviation]| deviation * deviation);
    assert!((1.73..23.59).contains(&chi), "chi squared {chi}");
    assert!(variance.sqrt() < 0.02 * found, "walks that tell little: {found} +- {}", variance.sqrt());
}

fn at(centre: [f64; 3], radius: f64) -> Sphere {
    Sphere { centre: Vec3(centre), radius }
}

/// ZENO, validation of version 5: the capacity of touching spheres of radii 1 and 1/4 in radii of the larger.
///
/// Equations: `titania-capacity`, `titania-return`, `titania-return-cosine`.
#[test]
fn a_small_sphere_on_a_large_one_adds_to_its_capacity_as_in_zeno() {
    agrees(&[at([0.0; 3], 1.0), at([1.25, 0.0, 0.0], 0.25)], 20_000, 1.01992);
}

/// ZENO, validation of version 5: a torus of radii 4 and 1 made of 416 spheres that overlap, by 3e11 walks.
///
/// Equations: `titania-capacity`, `titania-return`, `titania-return-cosine`.
#[test]
fn hundreds_of_overlapping_spheres_have_the_capacity_of_zeno() {
    agrees(&torus().collect::<Vec<_>>(), 5_000, 3.72748);
}

/// ZENO, the same torus: smaller spheres inside its surface, 624 of four sizes, change nothing.
///
/// Equations: `titania-capacity`, `titania-return`, `titania-return-cosine`.
#[test]
fn hundreds_of_unequal_spheres_have_the_capacity_of_zeno() {
    let inner = torus().enumerate().filter(|(k, _)| k % 2 == 0).map(|(k, sphere)| {
        let size = 0.25 * (1 + k / 2 % 3) as f64;
        // They touch the surface from within, on the outer or the inner side of the ring.
        let side = if k % 4 == 0 { 1.0 } else { -1.0 };
        Sphere { centre: sphere.centre * (1.0 + 0.25 * side * (1.0 - size)), radius: size }
    });
    agrees(&torus().chain(inner).collect::<Vec<_>>(), 5_000, 3.72748);
}

fn torus() -> impl Iterator<Item = Sphere> {
    (0..416).map(|k| TAU * f64::from(k) / 416.0).map(|a| at([4.0 * a.cos(), 4.0 * a.sin(), 0.0], 1.0))
}
