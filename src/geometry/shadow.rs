//! The projected area of spheres: the area of a union of discs, exact by Green's theorem.

use crate::error::Error;
use crate::geometry::directions::{Covered, frame, spread};
use crate::geometry::{Sphere, pairs_within};
use crate::interrupt::Interrupt;
use crate::spec::{Real, Vec3};

/// Discs of so few spheres are compared one by one.
const FEW: usize = 200;
/// Factor by which discs are taken for larger when those are sought that may cover each other, so that rounding hides none.
const ROOM: f64 = 1.0 + 1e-9;

/// Mean projected area (nm^2) over a number of evenly distributed directions.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn mean_projected_area(spheres: &[Sphere], directions: usize, interrupt: &Interrupt) -> Result<f64, Error> {
    let areas = spread(directions).into_iter().map(|along| projected_area(spheres, along, interrupt));
    Ok(areas.sum::<Result<f64, Error>>()? / directions as f64)
}

/// Projected area (nm^2) of spheres along a unit vector.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn projected_area(spheres: &[Sphere], along: Vec3<f64>, interrupt: &Interrupt) -> Result<f64, Error> {
    let [_, e, f] = frame(along, 0.0);
    let discs: Vec<Disc> =
        spheres.iter().map(|s| Disc { x: s.centre.dot(e), y: s.centre.dot(f), r: s.radius }).collect();
    if discs.len() <= FEW {
        return Ok((0..discs.len()).map(|i| share(&discs, i, 0..discs.len())).sum());
    }
    let mut others = vec![Vec::new(); discs.len()];
    let flat: Vec<Sphere> = discs.iter().map(|d| Sphere { centre: Vec3([d.x, d.y, 0.0]), radius: d.r }).collect();
    // The pairs come in ascending order, hence the others of each.
    for (i, j) in pairs_within(&flat, |r, s| ROOM * (r + s), interrupt)? {
        others[i].push(j);
        others[j].push(i);
    }
    Ok(others.iter().enumerate().map(|(i, others)| share(&discs, i, others.iter().copied())).sum())
}

struct Disc {
    x: f64,
    y: f64,
    r: f64,
}

/// Half the integral of `x dy - y dx` along that part of the rim of the `i`-th disc that no other of `others` covers.
fn share(discs: &[Disc], i: usize, others: impl Iterator<Item = usize>) -> f64 {
    let own = &discs[i];
    let mut covered = Covered::default();
    for (j, other) in others.filter(|&j| j != i).map(|j| (j, &discs[j])) {
        let (x, y) = (other.x - own.x, other.y - own.y);
        let square = x * x + y * y;
        if square >= (own.r + other.r).squared() {
            continue;
        }
        if square <= (own.r - other.r).squared() {
            // One holds the other; of equal discs the first counts.
            if other.r > own.r || (other.r == own.r && j < i) {
                return 0.0;
            }
            continue;
        }
        let cosine = (square + own.r.squared() - other.r.squared()) / (2.0 * own.r * square.sqrt());
        let half = Real::acos(cosine.clamp(-1.0, 1.0));
        covered.cover(libm::atan2(y, x) - half, 2.0 * half);
    }
    let arc = |(from, length): (f64, f64)| {
        let to = from + length;
        let (sines, cosines) = (Real::sin(to) - Real::sin(from), Real::cos(to) - Real::cos(from));
        0.5 * own.r * (own.r * length + own.x * sines - own.y * cosines)
    };
    covered.gaps().into_iter().map(arc).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn area(spheres: &[Sphere], along: Vec3<f64>) -> f64 {
        projected_area(spheres, along, &Interrupt::default()).unwrap()
    }

    fn mean_area(spheres: &[Sphere], directions: usize) -> f64 {
        mean_projected_area(spheres, directions, &Interrupt::default()).unwrap()
    }

    const DOWN: Vec3<f64> = Vec3([0.0, 0.0, 1.0]);

    fn sphere(x: [f64; 3], radius: f64) -> Sphere {
        Sphere { centre: Vec3(x), radius }
    }

    fn random_spheres() -> impl Strategy<Value = Vec<Sphere>> {
        let one = ([-2.0..2.0, -2.0..2.0, -2.0..2.0], 0.2..1.5).prop_map(|(x, r)| sphere(x, r));
        prop::collection::vec(one, 1..9)
    }

    proptest! {
        #[test]
        fn the_shadow_is_the_area_that_chords_cover(spheres in random_spheres()) {
            let lines = 4000;
            let step = 8.0 / f64::from(lines);
            let [_, e, f] = frame(DOWN, 0.0);
            let mut chords_cover = 0.0;
            for k in 0..lines {
                let y = -4.0 + (f64::from(k) + 0.5) * step;
                let mut chords: Vec<(f64, f64)> = spheres.iter().filter_map(|s| {
                    let half = s.radius.powi(2) - (s.centre.dot(f) - y).powi(2);
                    (half > 0.0).then(|| (s.centre.dot(e) - half.sqrt(), s.centre.dot(e) + half.sqrt()))
                }).collect();
                chords.sort_by(|a, b| a.0.total_cmp(&b.0));
                let mut end = f64::NEG_INFINITY;
                for (from, to) in chords {
                    chords_cover += step * (to - from.max(end)).max(0.0);
                    end = end.max(to);
                }
            }
            prop_assert!((area(&spheres, DOWN) - chords_cover).abs() < 1e-3);
        }

        #[test]
        fn a_shadow_is_the_same_from_behind_and_anywhere(spheres in random_spheres(), shift in -3.0..3.0f64) {
            let expected = area(&spheres, DOWN);
            let moved: Vec<Sphere> = spheres.iter().map(|s| sphere([s.centre.0[0] + shift, s.centre.0[1] - shift, s.centre.0[2]], s.radius)).collect();
            prop_assert!((area(&spheres, -DOWN) - expected).abs() < 1e-12);
            prop_assert!((area(&moved, DOWN) - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn shadows_of_one_sphere_are_its_circle() {
        let one = [sphere([3.0, 1.0, -2.0], 1.5)];
        assert!((mean_area(&one, 56) - PI * 2.25).abs() < 1e-13);
        let twice = [sphere([0.0; 3], 1.0), sphere([0.0, 0.0, 2.0], 1.0)];
        assert!((area(&twice, DOWN) - PI).abs() < 1e-13);
    }

    #[test]
    fn the_mean_shadow_of_two_touching_spheres_is_known() {
        // Two circles less the mean of their lens over all directions, pi - 2 - 2/3.
        let two = [sphere([0.0; 3], 1.0), sphere([2.0, 0.0, 0.0], 1.0)];
        let exact = PI + 8.0 / 3.0;
        assert!((mean_area(&two, 4000) - exact).abs() < 1e-3);
        assert!((mean_area(&two, 56) / exact - 1.0).abs() < 0.01);
    }

    #[test]
    fn the_shadow_of_many_spheres_has_the_bits_of_comparing_all() {
        let mut stream = crate::random::Stream::new(1, "shadow");
        let mut one = || sphere(std::array::from_fn(|_| 30.0 * stream.uniform()), 0.5 + 2.0 * stream.uniform());
        let spheres: Vec<Sphere> = (0..3 * FEW).map(|_| one()).collect();
        let [_, e, f] = frame(DOWN, 0.0);
        let disc = |s: &Sphere| Disc { x: s.centre.dot(e), y: s.centre.dot(f), r: s.radius };
        let discs: Vec<Disc> = spheres.iter().map(disc).collect();
        let all: f64 = (0..discs.len()).map(|i| share(&discs, i, 0..discs.len())).sum();
        assert_eq!(area(&spheres, DOWN), all);
    }

    #[test]
    fn shadows_of_two_are_their_circles_less_what_both_cover() {
        let lens = |r: f64, s: f64, d: f64| {
            let half = |r: f64, s: f64| ((d * d + r * r - s * s) / (2.0 * d * r)).acos();
            let (a, b) = (half(r, s), half(s, r));
            r * r * (a - a.sin() * a.cos()) + s * s * (b - b.sin() * b.cos())
        };
        let circle = |r: f64| PI * r * r;
        for (r, s, d, covered) in [
            (2.0, 1.0, 2.5, lens(2.0, 1.0, 2.5)),
            (2.0, 1.0, 1.5, lens(2.0, 1.0, 1.5)),
            (1.0, 2.0, 1.75, lens(1.0, 2.0, 1.75)),
            (2.0, 1.0, 3.0, 0.0),
            (2.0, 1.0, 3.5, 0.0),
            (2.0, 1.0, 1.0, circle(1.0)),
            (2.0, 1.0, 0.5, circle(1.0)),
            (1.0, 2.0, 0.5, circle(1.0)),
            (1.0, 1.0, 0.0, circle(1.0)),
        ] {
            // In every direction in the plane, but for circles that touch: rounding would move them.
            let turns: &[f64] = if [1.0, 3.0].contains(&d) { &[0.0] } else { &[0.0, 0.7, 1.6, 3.0, 4.0, 5.5] };
            for turn in turns {
                let apart = |x: f64| [x + d * turn.cos(), 3.0 + d * turn.sin(), 5.0];
                let two = [sphere([0.25, 3.0, -1.0], r), sphere(apart(0.25), s)];
                let expected = circle(r) + circle(s) - covered;
                assert!((area(&two, DOWN) - expected).abs() < 1e-12, "{r} {s} {d} {turn}");
            }
        }
        let slant = Vec3([0.6, 0.0, 0.8]);
        let two = [sphere([0.0; 3], 1.0), sphere([2.0, 0.0, 0.0], 1.0)];
        assert!((area(&two, slant) - 2.0 * PI + lens(1.0, 1.0, 1.6)).abs() < 1e-12);
    }

    #[test]
    fn shadows_of_many_are_not_measured_when_it_is_asked_to_stop() {
        let interrupt = Interrupt::default();
        interrupt.request();
        let many: Vec<Sphere> = (0..=FEW).map(|k| sphere([3.0 * k as f64, 0.0, 0.0], 1.0)).collect();
        assert!(matches!(projected_area(&many, DOWN, &interrupt), Err(Error::Interrupted)));
        assert!((area(&many, DOWN) - 201.0 * PI).abs() < 1e-9 && (area(&many[1..], DOWN) - 200.0 * PI).abs() < 1e-9);
    }
}
