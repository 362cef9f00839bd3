use super::super::law::Form;
use super::*;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn cluster(spheres: &[([f64; 3], f64)], form: Form) -> Cluster {
    let sphere = |&(x, radius): &([f64; 3], f64)| Sphere { centre: Vec3(x), radius };
    let law = Law { k_f: 1.0, d_f: 1.0, form };
    Cluster::new(spheres.iter().map(sphere).collect(), law.extent())
}

/// A bent row of three, a pair of unequal spheres, and one sphere.
fn three() -> Cluster {
    cluster(&[([0.0; 3], 1.0), ([2.0, 0.0, 0.0], 1.0), ([2.0, 1.5, 0.0], 0.5)], Form::GeometricMean)
}

fn two() -> Cluster {
    cluster(&[([0.0; 3], 0.8), ([0.0, 0.0, 1.5], 0.7)], Form::GeometricMean)
}

fn one() -> Cluster {
    cluster(&[([0.0; 3], 1.2)], Form::GeometricMean)
}

/// Four spheres that are not their mirror image; the outermost is not the one whose centre is farthest out.
fn four() -> Cluster {
    let spheres = [([0.0; 3], 1.0), ([2.0, 0.0, 0.0], 1.0), ([2.0, 1.3, 0.0], 0.3), ([2.0, 1.3, 0.6], 0.3)];
    cluster(&spheres, Form::GeometricMean)
}

/// Six times the volume between the first four spheres, negative for their mirror image.
fn handedness(spheres: &[Sphere]) -> f64 {
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| spheres[k].centre);
    (b - a).cross(c - a).dot(d - a)
}

/// The first cluster has stayed, the other is the same as before but for where it is, they touch once and overlap nowhere; the centre of the other.
fn joined(a: &Cluster, b: &Cluster, spheres: &[Sphere]) -> Vec3<f64> {
    let (here, there) = spheres.split_at(a.spheres.len());
    assert_eq!(here, a.spheres);
    for (i, j) in (0..there.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
        assert!((there[i].gap(&there[j]) - b.spheres[i].gap(&b.spheres[j])).abs() < 1e-12);
    }
    assert!(there.len() < 4 || (handedness(there) - handedness(&b.spheres)).abs() < 1e-12);
    assert!(there.iter().map(|s| s.radius).eq(b.spheres.iter().map(|s| s.radius)));
    let gaps: Vec<f64> = here.iter().flat_map(|s| there.iter().map(|t| s.gap(t))).collect();
    assert!(gaps.iter().all(|&gap| gap > -1e-12), "{gaps:?}");
    assert_eq!(gaps.iter().filter(|gap| gap.abs() < 1e-12).count(), 1, "{gaps:?}");
    crate::geometry::centre_of_mass(there)
}

#[test]
fn placed_clusters_touch_at_one_point_at_the_distance_that_is_wanted() {
    let mut stream = Stream::new(1, "test");
    for (a, b, distances) in [
        (one(), two(), [1.95, 2.3, 2.6]),
        (two(), one(), [1.95, 2.3, 2.6]),
        (three(), one(), [2.1, 2.6, 3.2]),
        (three(), two(), [2.4, 3.0, 3.6]),
        (two(), three(), [2.4, 3.0, 3.6]),
        (two(), four(), [2.4, 2.8, 3.4]),
    ] {
        for distance in distances {
            let placed: Vec<Vec3<f64>> = (0..400)
                .filter_map(|_| place(&a, &b, distance, &mut stream))
                .map(|spheres| joined(&a, &b, &spheres))
                .collect();
            assert!(!placed.is_empty(), "{distance}");
            assert!(placed.iter().all(|centre| (centre.norm() - distance).abs() < 1e-12));
        }
        // Too far for any two spheres to touch, and too near for none to overlap.
        for distance in [1.001 * (a.reach + b.reach), 0.2] {
            assert!((0..400).all(|_| place(&a, &b, distance, &mut stream).is_none()), "{distance}");
        }
    }
}

#[test]
fn a_pair_is_placed_at_every_angle() {
    // The distance of the sphere that is touched from the centre of the other cluster: its square is spread evenly.
    let (a, b) = (one(), cluster(&[([-5.0, 0.0, 0.0], 1.0), ([5.0, 0.0, 0.0], 1.0)], Form::GeometricMean));
    let (c, mut stream) =
        (cluster(&[([-6.0, 0.0, 0.0], 1.0), ([6.0, 0.0, 0.0], 1.0)], Form::GeometricMean), Stream::new(1, "test"));
    assert!(place(&a, &b, 5.0, &mut stream).is_some());
    let mut shares = Vec::new();
    while shares.len() < 2000 {
        let Some(spheres) = place(&c, &b, 5.0, &mut stream) else { continue };
        let at = joined(&c, &b, &spheres);
        let touched = (0..2).find(|&i| spheres[2..].iter().any(|t| spheres[i].gap(t).abs() < 1e-9)).expect("a contact");
        // From 5 - 2 to 5 + 2, the reach of a sphere of the other.
        let square = (spheres[touched].centre - at).norm().powi(2);
        assert!((9.0 - 1e-9..=49.0 + 1e-9).contains(&square), "{square}");
        shares.push((square - 9.0) / 40.0);
    }
    let [low, high] = [f64::min, f64::max].map(|choose| shares.iter().copied().reduce(choose).expect("shares"));
    assert!(low < 0.02 && high > 0.98, "{low} {high}");
}

#[test]
fn clusters_in_line_touch_with_their_outermost_spheres() {
    for (a, b) in [(one(), one()), (one(), three()), (three(), two()), (two(), three()), (four(), four())] {
        let spheres = in_line(&a, &b);
        let at = joined(&a, &b, &spheres);
        assert!((at.norm() - (a.reach + b.reach)).abs() < 1e-12);
        let farthest = |s: &&Sphere| s.centre.norm() + s.radius;
        let outermost = a.spheres.iter().max_by(|s, t| farthest(s).total_cmp(&farthest(t))).expect("a sphere");
        assert!((outermost.centre.cross(at)).norm() < 1e-12);
    }
}

#[test]
fn a_join_meets_the_law_or_comes_as_near_as_it_can() {
    let law = |k_f: f64| Law { k_f, d_f: 1.0, form: Form::GeometricMean };
    let pair = cluster(&[([-1.0, 0.0, 0.0], 1.0), ([1.0, 0.0, 0.0], 1.0)], Form::GeometricMean);
    let single = cluster(&[([0.0; 3], 1.0)], Form::GeometricMean);
    // The gyration radius of three equal spheres of dimension one is 3 / k_f.
    let radius = |k_f: f64, seed: u64| {
        let whole =
            join(&single, &pair, &law(k_f), &mut Stream::new(seed, "test"), &Interrupt::default()).expect("spheres");
        assert_eq!(whole.spheres.len(), 3);
        whole.square.sqrt()
    };
    let (triangle, row) = ((4.0f64 / 3.0).sqrt(), (8.0f64 / 3.0).sqrt());
    for seed in 0..5 {
        assert!((radius(3.0 / 1.4, seed) - 1.4).abs() < 1e-12);
        assert!((radius(3.0 / 2.0, seed) - row).abs() < 1e-12);
    }
    let nearest = radius(3.0 / 0.1, 1);
    assert!(nearest > triangle - 1e-9 && nearest < 1.02 * triangle, "{nearest} {triangle}");
    let two = join(&single, &single, &law(1.0), &mut Stream::new(1, "test"), &Interrupt::default()).expect("two");
    assert!(two.spheres[0].gap(&two.spheres[1]).abs() < 1e-15 && (two.square - 1.0).abs() < 1e-15);
    let interrupt = Interrupt::default();
    interrupt.request();
    let stopped = join(&single, &pair, &law(1.0), &mut Stream::new(1, "test"), &interrupt);
    assert!(matches!(stopped.map(|whole| whole.square), Err(Failure::Interrupted)));
}

/// Where a sphere is after a turn about the axis of the rings.
fn turned(ring: &Ring, by: f64) -> Sphere {
    let (s, c) = (ring.angle + by).sin_cos();
    Sphere { centre: Vec3([ring.height, ring.distance * c, ring.distance * s]), radius: ring.radius }
}

fn overlap(fixed: &[Ring], turning: &[Ring], by: f64, margin: f64) -> bool {
    fixed.iter().any(|k| turning.iter().any(|l| turned(k, 0.0).gap(&turned(l, by)) < margin))
}

fn rings(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 4]>> {
    let ring = (-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64, 0.2..1.5f64).prop_map(|(height, x, y, r)| [height, x, y, r]);
    prop::collection::vec(ring, count)
}

proptest! {
    #[test]
    fn a_free_angle_is_free_and_there_is_none_only_if_every_angle_is_taken(fixed in rings(0..4), turning in rings(1..4), seed: u64) {
        let rings = |numbers: &[[f64; 4]]| numbers.iter().map(|&[height, x, y, r]| Ring::new(height, x, y, r)).collect::<Vec<_>>();
        let (fixed, others) = (rings(&fixed), rings(&turning));
        match free_angle(&fixed, rings(&turning), &mut Stream::new(seed, "test")) {
            Some(angle) => prop_assert!(!overlap(&fixed, &others, angle, -1e-9), "{angle}"),
            None => prop_assert!((0..720).all(|k| overlap(&fixed, &others, f64::from(k) * TAU / 720.0, 1e-6))),
        }
    }
}

#[test]
fn every_free_angle_is_as_likely_as_any_other() {
    // Spheres of radius 1 on a circle of radius 2 overlap within a sixth of a turn.
    let ring = |angle: f64, radius: f64| Ring { height: 0.0, distance: 2.0, angle, radius };
    let fixed = [ring(1.0, 1.0), ring(1.0 + 0.5 * PI + PI / 3.0 * 2.0, 1.0)];
    let mut stream = Stream::new(1, "test");
    let n = 4000;
    let angles: Vec<f64> =
        (0..n).map(|_| free_angle(&fixed, vec![ring(0.5, 1.0)], &mut stream).expect("room")).collect();
    let begin = 1.0 + PI / 3.0 - 0.5;
    let from_begin: Vec<f64> = angles.iter().map(|angle| (angle - begin).rem_euclid(TAU)).collect();
    // Free are a quarter of a turn, and after a third of one the rest, a twelfth.
    let (first, last) = (0.5 * PI, TAU - 2.0 * PI / 3.0);
    let rest = last - first - 2.0 * PI / 3.0;
    assert!(from_begin.iter().all(|&a| a < first + 1e-6 || (first + 2.0 * PI / 3.0 - 1e-6..last + 1e-6).contains(&a)));
    let share = |low: f64, high: f64| {
        let expected = (high - low) / (first + rest);
        let found = from_begin.iter().filter(|&&a| a >= low && a < high).count() as f64 / f64::from(n);
        let error = 5.0 * (expected * (1.0 - expected) / f64::from(n)).sqrt();
        assert!((found - expected).abs() < error, "{low} {high}: {found} {expected}");
    };
    share(0.0, 0.5 * first);
    share(0.5 * first, first);
    share(last - rest, last - 0.5 * rest);
    share(last - 0.5 * rest, last);
}

#[test]
fn rings_may_touch_if_they_come_nearer_than_their_radii() {
    let ring = |height: f64, x: f64, y: f64, radius: f64| Ring::new(height, x, y, radius);
    let found = ring(1.0, 3.0, 4.0, 2.0);
    assert_eq!((found.height, found.distance, found.radius), (1.0, 5.0, 2.0));
    assert!((found.angle - (4.0f64 / 3.0).atan()).abs() < 1e-15);
    // Three along the axis and four across it are five.
    let near = |a: f64, b: f64| ring(1.0, 0.0, 2.0, a).may_touch(&ring(-2.0, -6.0, 0.0, b));
    assert_eq!([near(2.5, 2.5), near(1.0, 4.1), near(2.4, 2.5), near(4.0, 0.9)], [true, true, false, false]);
}

#[test]
fn triangles_have_cosines_and_vectors_directions() {
    for (a, b, square, expected) in [
        (3.0, 4.0, 25.0, 0.0),
        (1.0, 1.0, 1.0, 0.5),
        (2.0, 3.0, 19.0, -0.5),
        (2.0, 3.0, 1.0, 1.0),
        (2.0, 3.0, 0.9, 1.0),
        (2.0, 3.0, 26.0, -1.0),
        (0.0, 3.0, 9.0, 1.0),
    ] {
        assert!((cosine(a, b, square) - expected).abs() < 1e-15, "{a} {b} {square}");
    }
    let mut stream = Stream::new(1, "test");
    assert_eq!(unit(Vec3([0.0, -4.0, 0.0]), &mut stream), Vec3([0.0, -1.0, 0.0]));
    assert!((unit(Vec3::zero(), &mut stream).norm() - 1.0).abs() < 1e-14);
    let mut counts = [0; 3];
    (0..3000).for_each(|_| counts[pick(&three(), &mut stream)] += 1);
    // Five standard deviations.
    assert!(counts.iter().all(|&count: &i32| (count - 1000).abs() < 130), "{counts:?}");
}

#[test]
fn angles_are_free_until_the_spheres_touch() {
    // Rings at different heights, of different sizes and spheres.
    let (fixed, turning) = ([Ring::new(0.0, 2.0, 0.5, 1.0)], || vec![Ring::new(1.0, -1.0, 1.2, 0.8)]);
    let mut stream = Stream::new(1, "test");
    let gaps: Vec<f64> = (0..2000)
        .map(|_| free_angle(&fixed, turning(), &mut stream).expect("room"))
        .map(|angle| turned(&fixed[0], 0.0).gap(&turned(&turning()[0], angle)))
        .collect();
    let [least, largest] = [f64::min, f64::max].map(|choose| gaps.iter().copied().reduce(choose).expect("gaps"));
    // At most both are on opposite sides of the axis.
    let apart = (1.0 + (4.25f64.sqrt() + 2.44f64.sqrt()).powi(2)).sqrt() - 1.8;
    assert!(
        (-1e-9..0.01).contains(&least) && (apart - 0.01..apart + 1e-9).contains(&largest),
        "{least} {largest} {apart}"
    );
}
