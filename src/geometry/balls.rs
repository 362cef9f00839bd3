//! Spheres in a tree of balls, which finds the distance of the nearest surface without a look at all of them.

use super::Sphere;
use crate::spec::Vec3;

/// Spheres that are not divided further.
const FEW: usize = 16;
/// Factor by which balls are larger than what they hold, so that rounding hides nothing.
const ROOM: f64 = 1.0 + 1e-9;

/// A ball, and the spheres in it.
pub(super) struct Ball {
    bound: Sphere,
    content: Content,
}

enum Content {
    Spheres(Vec<Sphere>),
    Balls(Box<[Ball; 2]>),
}

impl Ball {
    /// The tree of some spheres, at least one.
    pub(super) fn of(mut spheres: Vec<Sphere>) -> Self {
        let sides: [[f64; 2]; 3] = std::array::from_fn(|axis| {
            let along = spheres.iter().map(|s| s.centre.0[axis]);
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        });
        let centre = Vec3(sides.map(|[low, high]| 0.5 * (low + high)));
        let radius = spheres.iter().map(|s| (s.centre - centre).norm() + s.radius).fold(0.0, f64::max);
        let bound = Sphere { centre, radius: ROOM * radius };
        if spheres.len() <= FEW {
            return Self { bound, content: Content::Spheres(spheres) };
        }
        let width = |axis: &usize| sides[*axis][1] - sides[*axis][0];
        let widest = (0..3).max_by(|a, b| width(a).total_cmp(&width(b))).expect("there are three axes");
        spheres.sort_unstable_by(|a, b| a.centre.0[widest].total_cmp(&b.centre.0[widest]));
        let upper = spheres.split_off(spheres.len() / 2);
        Self { bound, content: Content::Balls(Box::new([spheres, upper].map(Self::of))) }
    }

    /// The distance of a point from the nearest surface, negative inside a sphere: the least over all spheres, bit by bit.
    pub(super) fn distance(&self, from: Vec3<f64>) -> f64 {
        self.nearer(from, f64::INFINITY)
    }

    /// The distance of the nearest surface if it is nearer than `least`, or `least`.
    fn nearer(&self, from: Vec3<f64>, least: f64) -> f64 {
        match &self.content {
            Content::Spheres(spheres) => spheres.iter().map(|s| distance(from, s)).fold(least, f64::min),
            Content::Balls(balls) => {
                let [one, other] = balls.each_ref().map(|ball| (distance(from, &ball.bound), ball));
                let nearest_first = if one.0 <= other.0 { [one, other] } else { [other, one] };
                nearest_first.into_iter().fold(
                    least,
                    |least, (bound, ball)| {
                        if bound < least { ball.nearer(from, least) } else { least }
                    },
                )
            }
        }
    }
}

fn distance(from: Vec3<f64>, sphere: &Sphere) -> f64 {
    (from - sphere.centre).norm() - sphere.radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_surface_is_nearer_than_the_nearest(
            spheres in prop::collection::vec(([-9.0..9.0, -9.0..9.0, -1.0..1.0], 0.01..2.0), 1..200),
            from in [-20.0..20.0, -20.0..20.0, -20.0..20.0],
        ) {
            let spheres: Vec<Sphere> = spheres.into_iter().map(|(x, radius)| Sphere { centre: Vec3(x), radius }).collect();
            let least = spheres.iter().map(|s| distance(Vec3(from), s)).fold(f64::INFINITY, f64::min);
            prop_assert_eq!(Ball::of(spheres).distance(Vec3(from)), least);
        }
    }
}
