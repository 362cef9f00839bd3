//! Directions: random ones, evenly spread ones, frames; and the free part of a circle.

use crate::random::Stream;
use crate::spec::{Real, Vec3};

/// A random angle of a full turn.
pub fn turn(stream: &mut Stream) -> f64 {
    2.0 * f64::pi() * stream.uniform()
}

/// A random direction.
pub fn direction(stream: &mut Stream) -> Vec3<f64> {
    let z = 2.0 * stream.uniform() - 1.0;
    let angle = turn(stream);
    let across = (1.0 - z.squared()).max(0.0).sqrt();
    Vec3([-Real::sin(angle) * across, Real::cos(angle) * across, z])
}

/// A random direction at an angle to the axis.
pub fn cone(axis: Vec3<f64>, cosine: f64, stream: &mut Stream) -> Vec3<f64> {
    axis * cosine + frame(axis, turn(stream))[1] * (1.0 - cosine.squared()).max(0.0).sqrt()
}

/// A right-handed orthonormal frame with a given first axis, turned about it.
pub fn frame(axis: Vec3<f64>, angle: f64) -> [Vec3<f64>; 3] {
    let [x, y, z] = axis.0.map(f64::abs);
    let least = if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let across = axis.cross(Vec3(least));
    let across = across * (1.0 / across.norm());
    let third = axis.cross(across);
    let (s, c) = (Real::sin(angle), Real::cos(angle));
    [axis, across * c + third * s, third * c - across * s]
}

/// A number of directions, distributed evenly along a spiral.
pub fn spread(number: usize) -> Vec<Vec3<f64>> {
    let golden = f64::pi() * (3.0 - 5f64.sqrt());
    let point = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / number as f64;
        let (rho, angle) = ((1.0 - z * z).sqrt(), golden * k as f64);
        Vec3([rho * Real::cos(angle), rho * Real::sin(angle), z])
    };
    (0..number).map(point).collect()
}

/// The parts of a circle that are covered.
#[derive(Default)]
pub struct Covered(Vec<(f64, f64)>);

impl Covered {
    /// Covers the angles from `from` on; `length` is at most a full turn.
    pub fn cover(&mut self, from: f64, length: f64) {
        let full = 2.0 * f64::pi();
        let from = from - full * (from / full).floor();
        self.0.push((from, from + length));
        if from + length > full {
            self.0.push((0.0, from + length - full));
        }
    }

    /// Where each gap begins, between 0 and a full turn, and how long it is.
    pub fn gaps(mut self) -> Vec<(f64, f64)> {
        let full = 2.0 * f64::pi();
        self.0.sort_unstable_by(|s, t| s.0.total_cmp(&t.0));
        self.0.push((full, full));
        let mut end = 0.0;
        let mut gaps = Vec::new();
        for (from, to) in self.0 {
            if from > end {
                gaps.push((end, from - end));
            }
            end = end.max(to);
        }
        gaps
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quickcheck::quickcheck;
    use std::f64::consts::TAU;

    quickcheck! {
        fn gaps_are_what_no_arc_covers(arcs: Vec<(u8, u8)>, probe: u16) -> bool {
            // Arcs of whole 256ths of a turn; the probe is in the middle of one.
            let part = TAU / 256.0;
            let mut covered = Covered::default();
            for &(from, length) in &arcs {
                covered.cover(f64::from(from) * part, f64::from(length) * part);
            }
            let place = probe % 256;
            let inside = arcs.iter().any(|&(from, length)| (place + 256 - u16::from(from)) % 256 < u16::from(length));
            let angle = (f64::from(place) + 0.5) * part;
            let free = covered.gaps().iter().any(|&(from, length)| angle > from && angle < from + length);
            inside != free
        }

        fn frames_are_right_handed_and_orthonormal(seed: u64) -> bool {
            let mut stream = Stream::new(seed, "test");
            let axis = direction(&mut stream);
            let [e, f, g] = frame(axis, turn(&mut stream));
            let unit = [e, f, g].iter().all(|v| (v.norm() - 1.0).abs() < 1e-14);
            unit && e.dot(f).abs() < 1e-14 && (e.cross(f) - g).norm() < 1e-14
        }
    }

    #[test]
    fn spread_directions_have_the_moments_of_all_directions() {
        let all = spread(400);
        for axis in 0..3 {
            let mean = |power: i32| all.iter().map(|v| v.0[axis].powi(power)).sum::<f64>() / 400.0;
            assert!(mean(1).abs() < 1e-3 && (mean(2) - 1.0 / 3.0).abs() < 1e-3);
        }
    }

    #[test]
    fn random_directions_have_the_moments_of_all_directions() {
        let mut stream = Stream::new(1, "test");
        let n = 20_000;
        let all: Vec<Vec3<f64>> = (0..n).map(|_| direction(&mut stream)).collect();
        let mean = |part: &dyn Fn(&Vec3<f64>) -> f64| all.iter().map(part).sum::<f64>() / f64::from(n);
        // Five standard errors: the deviations of a component, its square and the product of two are below 0.58, 0.3 and 0.26.
        let error = 5.0 / f64::from(n).sqrt();
        for a in 0..3 {
            assert!(mean(&|v| v.0[a]).abs() < 0.58 * error);
            assert!((mean(&|v| v.0[a] * v.0[a]) - 1.0 / 3.0).abs() < 0.3 * error);
            assert!(mean(&|v| v.0[a] * v.0[(a + 1) % 3]).abs() < 0.26 * error);
        }
        assert!(all.iter().all(|v| (v.norm() - 1.0).abs() < 1e-14));
        let turns: Vec<f64> = (0..n).map(|_| turn(&mut stream)).collect();
        assert!(turns.iter().all(|angle| (0.0..TAU).contains(angle)));
        assert!((turns.iter().sum::<f64>() / f64::from(n) / TAU - 0.5).abs() < 0.29 * error);
    }

    #[test]
    fn a_cone_holds_the_directions_at_an_angle_and_all_of_them() {
        let axis = Vec3([2.0, -1.0, 2.0]) * (1.0 / 3.0);
        let mut stream = Stream::new(2, "test");
        for cosine in [-1.0, -0.3, 0.0, 0.8, 1.0] {
            let n = 5000;
            let all: Vec<Vec3<f64>> = (0..n).map(|_| cone(axis, cosine, &mut stream)).collect();
            assert!(all.iter().all(|v| (v.norm() - 1.0).abs() < 1e-14 && (v.dot(axis) - cosine).abs() < 1e-14));
            let mean = all.iter().fold(Vec3::zero(), |sum, v| sum + *v) * (1.0 / f64::from(n));
            // Five standard errors of the part across.
            assert!(
                (mean - axis * cosine).norm() <= 5.0 * (1.0 - cosine * cosine).sqrt() / f64::from(n).sqrt() + 1e-12
            );
        }
    }

    #[test]
    fn a_frame_turns_about_its_axis_by_the_angle() {
        for axis in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.8, -0.6]].map(Vec3) {
            let [_, e, f] = frame(axis, 0.0);
            // The axis along which it is shortest, the first of equals, is across the second.
            let sizes = axis.0.map(f64::abs);
            let least = (0..3).min_by(|&a, &b| sizes[a].total_cmp(&sizes[b])).expect("three axes");
            assert!(e.0[least].abs() < 1e-14 && e.dot(axis).abs() < 1e-14, "{axis:?}");
            for angle in [0.3, 2.0, -1.0f64] {
                let turned = frame(axis, angle);
                assert_eq!(turned[0], axis);
                assert!((turned[1] - (e * angle.cos() + f * angle.sin())).norm() < 1e-14);
                assert!((turned[2] - (f * angle.cos() - e * angle.sin())).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn the_spiral_goes_down_in_equal_steps_and_round_by_the_golden_angle() {
        let all = spread(7);
        // The full turn less the golden part of it.
        let golden = TAU * (1.0 - (5f64.sqrt() - 1.0) / 2.0);
        for (k, v) in all.iter().enumerate() {
            assert!((v.norm() - 1.0).abs() < 1e-14 && (v.0[2] - (6.0 - 2.0 * k as f64) / 7.0).abs() < 1e-14);
            let across = (1.0 - v.0[2] * v.0[2]).sqrt();
            let (s, c) = (golden * k as f64).sin_cos();
            assert!((v.0[0] - across * c).abs() < 1e-14 && (v.0[1] - across * s).abs() < 1e-14);
        }
        assert_eq!((all.len(), spread(1).len()), (7, 1));
    }

    #[test]
    fn gaps_are_between_arcs_wherever_they_begin() {
        let gaps = |arcs: &[(f64, f64)]| {
            let mut covered = Covered::default();
            arcs.iter().for_each(|&(from, length)| covered.cover(from, length));
            covered.gaps()
        };
        let near = |found: Vec<(f64, f64)>, expected: &[(f64, f64)]| {
            let same = |(x, y): (&(f64, f64), &(f64, f64))| (x.0 - y.0).abs() < 1e-14 && (x.1 - y.1).abs() < 1e-14;
            assert!(found.len() == expected.len() && found.iter().zip(expected).all(same), "{found:?} {expected:?}");
        };
        near(gaps(&[]), &[(0.0, TAU)]);
        near(gaps(&[(1.0, 2.0)]), &[(0.0, 1.0), (3.0, TAU - 3.0)]);
        near(gaps(&[(1.0 + 2.0 * TAU, 2.0)]), &[(0.0, 1.0), (3.0, TAU - 3.0)]);
        near(gaps(&[(-1.0, 2.0)]), &[(1.0, TAU - 2.0)]);
        near(gaps(&[(-1.0 - TAU, 2.0)]), &[(1.0, TAU - 2.0)]);
        // Arcs that touch, that hold each other, and that cover all.
        near(gaps(&[(3.0, 1.0), (2.0, 1.0), (0.0, 2.0)]), &[(4.0, TAU - 4.0)]);
        near(gaps(&[(1.0, 3.0), (2.0, 0.5), (5.0, 0.25)]), &[(0.0, 1.0), (4.0, 1.0), (5.25, TAU - 5.25)]);
        near(gaps(&[(0.0, TAU)]), &[]);
        near(gaps(&[(2.0, TAU)]), &[]);
    }
}
