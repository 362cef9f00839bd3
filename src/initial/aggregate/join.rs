//! Joining of two clusters: they touch at one point, do not overlap, and have the prescribed radius of gyration.

use super::cluster::Cluster;
use super::law::Law;
use super::{Failure, going};
use crate::geometry::Sphere;
use crate::geometry::directions::{Covered, cone, direction, frame, turn};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::mechanics::gyration::joined_distance;
use crate::spec::{Real, Vec3};

/// How many pairs of spheres are tried at one distance of the clusters.
const TRIES: usize = 2000;

/// By how much the distance grows when none of them fits.
const WIDENING: f64 = 1.02;

/// Spheres that are not meant to touch stay apart by this fraction of their distance.
const NEAR: f64 = 1.0 + 1e-9;

/// Joins two clusters to one with the gyration radius of the law, or, where they cannot be placed so, with one as near as they can.
///
/// # Errors
///
/// That it was interrupted.
pub(super) fn join(
    a: &Cluster,
    b: &Cluster,
    law: &Law,
    stream: &mut Stream,
    interrupt: &Interrupt,
) -> Result<Cluster, Failure> {
    let farthest = a.reach + b.reach;
    let sums = a.sums.with(&b.sums);
    let whole = |spheres| Cluster::new(spheres, law.extent());
    if sums.number == 2 {
        return Ok(whole(united(a, &b.spheres, direction(stream) * farthest)));
    }
    let (mass_a, mass_b, total) = (a.sums.cubes, b.sums.cubes, sums.cubes);
    let radius = law.gyration_radius(&sums);
    let mut distance = joined_distance(mass_a, mass_b, total, a.square, b.square, radius).min(farthest);
    loop {
        for _ in 0..TRIES {
            going(interrupt)?;
            if let Some(spheres) = place(a, b, distance, stream) {
                return Ok(whole(spheres));
            }
        }
        // The outermost spheres, placed in one line, always fit.
        distance =
            if distance < farthest { (distance * WIDENING).min(farthest) } else { return Ok(whole(in_line(a, b))) };
        distance = distance.max(1e-3 * farthest);
    }
}

/// One attempt: a random sphere of `a` touches a random sphere of `b`, and `b` is turned about the line through the former
/// and its own centre, which keeps them in touch, to where nothing overlaps.
fn place(a: &Cluster, b: &Cluster, distance: f64, stream: &mut Stream) -> Option<Vec<Sphere>> {
    let (i, j) = (pick(a, stream), pick(b, stream));
    let (p, q) = (a.spheres[i], b.spheres[j]);
    let touch = p.radius + q.radius;
    let (from_a, from_b) = (p.centre.norm(), q.centre.norm());
    // The distance of p from the centre of b: two triangles have it as a side.
    let nearest = (distance - from_a).abs().max((from_b - touch).abs());
    let farthest = (distance + from_a).min(from_b + touch);
    if nearest > farthest * NEAR {
        return None;
    }
    let square = nearest.squared() + stream.uniform() * (farthest.squared() - nearest.squared()).max(0.0);
    let towards_p = unit(p.centre, stream);
    let at = cone(towards_p, cosine(distance, from_a, square), stream) * distance;
    let to_p = p.centre - at;
    let axis = unit(to_p, stream);
    let towards_q = cone(axis, cosine(to_p.norm(), from_b, touch.squared()), stream);

    let (old, new) = (frame(unit(q.centre, stream), 0.0), frame(towards_q, turn(stream)));
    let moved = |v: Vec3<f64>| new[0] * old[0].dot(v) + new[1] * old[1].dot(v) + new[2] * old[2].dot(v);
    let mut turned: Vec<Sphere> =
        b.spheres.iter().map(|s| Sphere { centre: moved(s.centre), radius: s.radius }).collect();
    // Seen from p nothing changes when b is turned.
    let clear = |(l, s): (usize, &Sphere)| l == j || (to_p - s.centre).norm() > NEAR * (p.radius + s.radius);
    if !turned.iter().enumerate().all(clear) {
        return None;
    }
    let [_, e, f] = frame(axis, 0.0);
    let ring = |v: Vec3<f64>, radius| Ring::new(v.dot(axis), v.dot(e), v.dot(f), radius);
    // Only what the other cluster can reach matters, whatever the angle.
    let (ball_a, ball_b) = (ring(-at, a.reach), ring(Vec3::zero(), b.reach));
    let fixed: Vec<Ring> = a
        .spheres
        .iter()
        .enumerate()
        .filter(|&(k, _)| k != i)
        .map(|(_, s)| ring(s.centre - at, s.radius))
        .filter(|ring| ring.may_touch(&ball_b))
        .collect();
    let turning: Vec<Ring> =
        turned.iter().map(|s| ring(s.centre, s.radius)).filter(|ring| ring.may_touch(&ball_a)).collect();
    let angle = free_angle(&fixed, turning, stream)?;
    let (sine, cosine) = (Real::sin(angle), Real::cos(angle));
    for s in &mut turned {
        let along = axis * axis.dot(s.centre);
        s.centre = along + (s.centre - along) * cosine + axis.cross(s.centre) * sine;
    }
    Some(united(a, &turned, at))
}

fn united(a: &Cluster, b: &[Sphere], at: Vec3<f64>) -> Vec<Sphere> {
    let moved = b.iter().map(|s| Sphere { centre: s.centre + at, ..*s });
    a.spheres.iter().copied().chain(moved).collect()
}

/// The two clusters with their outermost spheres touching and the centres of mass in line with them.
fn in_line(a: &Cluster, b: &Cluster) -> Vec<Sphere> {
    let outermost = |c: &Cluster| {
        let far = |s: &Sphere| s.centre.norm() + s.radius;
        c.spheres.iter().copied().max_by(|s, t| far(s).total_cmp(&far(t))).expect("a cluster has spheres").centre
    };
    let line = |v: Vec3<f64>| if v.norm() > 0.0 { v * (1.0 / v.norm()) } else { Vec3([1.0, 0.0, 0.0]) };
    let (here, there) = (line(outermost(a)), line(outermost(b)));
    let (old, new) = (frame(there, 0.0), frame(-here, 0.0));
    let moved = |v: Vec3<f64>| new[0] * old[0].dot(v) + new[1] * old[1].dot(v) + new[2] * old[2].dot(v);
    let turned: Vec<Sphere> = b.spheres.iter().map(|s| Sphere { centre: moved(s.centre), ..*s }).collect();
    united(a, &turned, here * (a.reach + b.reach))
}

/// The circle that a sphere describes about the axis.
struct Ring {
    height: f64,
    distance: f64,
    angle: f64,
    radius: f64,
}

impl Ring {
    fn new(height: f64, x: f64, y: f64, radius: f64) -> Self {
        Self { height, distance: (x * x + y * y).sqrt(), angle: libm::atan2(y, x), radius }
    }

    /// Whether there is an angle at which the spheres of the two rings are near.
    fn may_touch(&self, other: &Self) -> bool {
        let apart = (self.height - other.height).squared() + (self.distance - other.distance).squared();
        apart < (NEAR * (self.radius + other.radius)).squared()
    }
}

/// An angle by which the rings can be turned so that no two spheres overlap, each such angle as likely as any other.
fn free_angle(fixed: &[Ring], mut turning: Vec<Ring>, stream: &mut Stream) -> Option<f64> {
    let largest = turning.iter().map(|ring| ring.radius).fold(0.0, f64::max);
    turning.sort_unstable_by(|s, t| s.height.total_cmp(&t.height));
    let mut taken = Covered::default();
    for k in fixed {
        let window = NEAR * (k.radius + largest);
        let first = turning.partition_point(|l| l.height < k.height - window);
        for l in turning[first..].iter().take_while(|l| l.height <= k.height + window) {
            if !k.may_touch(l) {
                continue;
            }
            let level = (NEAR * (k.radius + l.radius)).squared() - (k.height - l.height).squared();
            if level >= (k.distance + l.distance).squared() {
                return None; // always too near
            }
            let half =
                Real::acos((k.distance.squared() + l.distance.squared() - level) / (2.0 * k.distance * l.distance));
            taken.cover(k.angle - l.angle - half, 2.0 * half);
        }
    }
    let gaps = taken.gaps();
    let free: f64 = gaps.iter().map(|gap| gap.1).sum();
    let mut left = free * stream.uniform();
    for (from, length) in gaps {
        if left < length {
            return Some(from + left);
        }
        left -= length;
    }
    None
}

fn pick(cluster: &Cluster, stream: &mut Stream) -> usize {
    (stream.uniform() * cluster.spheres.len() as f64) as usize
}

/// The direction of `v`; of the null vector, any.
fn unit(v: Vec3<f64>, stream: &mut Stream) -> Vec3<f64> {
    let length = v.norm();
    if length > 0.0 { v * (1.0 / length) } else { direction(stream) }
}

/// Cosine of the angle between the sides `a` and `b` of a triangle, given the square of the third.
fn cosine(a: f64, b: f64, square: f64) -> f64 {
    if a * b > 0.0 { ((a.squared() + b.squared() - square) / (2.0 * a * b)).clamp(-1.0, 1.0) } else { 1.0 }
}

#[cfg(test)]
mod tests;
