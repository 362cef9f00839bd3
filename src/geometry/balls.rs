//! Spheres in a tree of balls, which finds the distance of the nearest surface without a look at all of them.

use super::Sphere;
use crate::spec::Vec3;
use crate::spec::numbers::{Instructions, Work};

/// Spheres that are not divided further: with vector instructions all of them are faster than a tree of them.
const FEW: usize = 64;
/// Spheres whose distances are taken together.
const LANES: usize = 8;
/// Factor by which balls are larger than what they hold, so that rounding hides nothing.
const ROOM: f64 = 1.0 + 1e-9;

/// A ball, and the spheres in it.
pub(super) struct Ball {
    bound: Sphere,
    content: Content,
}

enum Content {
    Spheres(Vec<Row>),
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
            return Self { bound, content: Content::Spheres(spheres.chunks(LANES).map(row).collect()) };
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
            Content::Spheres(rows) => Instructions::best().run(Nearest { rows, from, least }),
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

/// Centres and radii of spheres side by side; the first fills the places that are left.
type Row = [[f64; LANES]; 4];

fn row(spheres: &[Sphere]) -> Row {
    let of = |lane: usize| spheres.get(lane).unwrap_or(&spheres[0]);
    let centre = |axis: usize| std::array::from_fn(|lane| of(lane).centre.0[axis]);
    [centre(0), centre(1), centre(2), std::array::from_fn(|lane| of(lane).radius)]
}

/// The least distance of a point from spheres.
struct Nearest<'a> {
    rows: &'a [Row],
    from: Vec3<f64>,
    least: f64,
}

impl Work for Nearest<'_> {
    type Outcome = f64;

    #[inline(always)]
    fn run(self) -> f64 {
        let mut least = [self.least; LANES];
        for [x, y, z, radius] in self.rows {
            for lane in 0..LANES {
                let distance = (self.from - Vec3([x[lane], y[lane], z[lane]])).norm() - radius[lane];
                least[lane] = if distance < least[lane] { distance } else { least[lane] };
            }
        }
        least.into_iter().fold(self.least, f64::min)
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

    #[test]
    fn a_ball_holds_its_spheres_and_is_no_larger_than_they_need() {
        // The longest side is not the farthest from the origin, and neighbours in the row are not neighbours in the list.
        let at = |y: f64| Vec3([90.0, y - 50.0, 0.0]);
        let place = |k: usize, n: usize| if 2 * k < n { 2 * k } else { 2 * (n - 1 - k) + 1 };
        let row =
            |n: usize| (0..n).map(|k| Sphere { centre: at(place(k, n) as f64), radius: 0.25 }).collect::<Vec<_>>();
        for n in [1, 2, FEW, FEW + 1, 4 * FEW] {
            let ball = Ball::of(row(n));
            let half = 0.5 * (n - 1) as f64;
            assert_eq!(ball.bound.centre, at(half));
            assert!(ball.bound.radius >= half + 0.25 && ball.bound.radius < (half + 0.25) * (1.0 + 1e-8));
            // Many are divided across the longest side into halves.
            match (&ball.content, n <= FEW) {
                (Content::Spheres(rows), true) => assert_eq!(rows.len(), n.div_ceil(LANES)),
                (Content::Balls(balls), false) => {
                    let lower = (n / 2) as f64;
                    assert_eq!(balls[0].bound.centre, at(0.5 * (lower - 1.0)));
                    assert_eq!(balls[1].bound.centre, at(0.5 * (lower + (n - 1) as f64)));
                }
                _ => panic!("{n}"),
            }
        }
    }
}
