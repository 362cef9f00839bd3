//! Deposition of aggregates, one after the other.
//!
//! An aggregate begins anywhere above the highest point of the film, where every place is as likely as any other, and goes from ball
//! to ball: as far in one step as there is room, exactly (`exit_cosine` of the specification). What it is about to touch it touches.

use super::aggregates::Aggregate;
use super::column::{Column, FreeDistance, Nearest};
use super::{DepositedFilm, Failure, FilmPlan, FilmSphere, Ungrown};
use crate::geometry::Sphere;
use crate::geometry::directions::{cone, direction, frame, turn};
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::Vec3;
use crate::spec::mechanics::diffusion::exit_cosine;

/// Gap below which an aggregate touches, relative to the largest radius.
const GRAZE: f64 = 1e-4;
/// Orientations that are tried before an aggregate is too wide for the column.
const TURNS: usize = 100;
const DOWN: Vec3<f64> = Vec3([0.0, 0.0, -1.0]);

/// The film of some aggregates.
pub(super) fn deposited(
    plan: &FilmPlan,
    aggregates: Vec<Aggregate>,
    seed: u64,
    interrupt: &Interrupt,
) -> Result<DepositedFilm, Failure> {
    let mut stream = Stream::new(seed, "film deposition");
    let largest = 0.5 * f64::from(plan.diameters.largest);
    let mut column = Column::new(plan.sides, largest);
    let mut film = DepositedFilm { spheres: Vec::new(), on_floor: Vec::new(), sides: plan.sides, thickness: 0.0 };
    for Aggregate { mut spheres, diffusion } in aggregates {
        orient(&mut spheres, plan.sides, &mut stream)?;
        let path = Path { drift: plan.drift, diffusion, graze: GRAZE * largest };
        let (at, on_floor) = path.fall(&column, &spheres, plan.sides, &mut stream, interrupt)?;
        let folded = |a: usize| at.0[a] - (at.0[a] / plan.sides[a]).floor() * plan.sides[a];
        let at = Vec3([folded(0), folded(1), at.0[2]]);
        let aggregate = film.on_floor.len() as u32;
        for s in spheres {
            let centre = s.centre + at;
            column.add(centre, s.radius);
            film.spheres.push(FilmSphere { centre, diameter: 2.0 * s.radius, aggregate });
        }
        film.on_floor.push(on_floor);
    }
    film.thickness = column.top();
    Ok(film)
}

/// Turns an aggregate at random, so that it does not touch its own periodic image.
fn orient(spheres: &mut [Sphere], sides: [f64; 2], stream: &mut Stream) -> Result<(), Failure> {
    for _ in 0..TURNS {
        let axes = frame(direction(stream), turn(stream));
        for s in spheres.iter_mut() {
            let [x, y, z] = s.centre.0;
            s.centre = axes[0] * x + axes[1] * y + axes[2] * z;
        }
        if !meets_itself(spheres, sides) {
            return Ok(());
        }
    }
    let reach = spheres.iter().map(|s| s.centre.norm() + s.radius).fold(0.0, f64::max);
    Err(Failure::Wide { number: spheres.len(), extent: 2.0 * reach })
}

fn meets_itself(spheres: &[Sphere], sides: [f64; 2]) -> bool {
    let extent = [0, 1].map(|a| {
        let high = spheres.iter().map(|s| s.centre.0[a] + s.radius).fold(f64::NEG_INFINITY, f64::max);
        high - spheres.iter().map(|s| s.centre.0[a] - s.radius).fold(f64::INFINITY, f64::min)
    });
    let copies = [0, 1].map(|a| (extent[a] / sides[a]).floor() as i64);
    let shifts = (-copies[0]..=copies[0]).flat_map(|i| (-copies[1]..=copies[1]).map(move |j| (i, j)));
    shifts.filter(|&shift| shift != (0, 0)).any(|(i, j)| {
        let shift = Vec3([i as f64 * sides[0], j as f64 * sides[1], 0.0]);
        let meets = |s: &Sphere, t: &Sphere| (s.centre + shift - t.centre).norm() <= s.radius + t.radius;
        spheres.iter().any(|s| spheres.iter().any(|t| meets(s, t)))
    })
}

/// How an aggregate moves.
pub(super) struct Path {
    /// Velocity downwards.
    pub drift: f64,
    /// Coefficient of diffusion.
    pub diffusion: f64,
    /// Gap below which it touches.
    pub graze: f64,
}

impl Path {
    /// Where the centre of mass comes to rest, and whether on the floor.
    pub(super) fn fall(
        &self,
        column: &Column,
        spheres: &[Sphere],
        sides: [f64; 2],
        stream: &mut Stream,
        interrupt: &Interrupt,
    ) -> Result<(Vec3<f64>, bool), Failure> {
        let lowest = spheres.iter().map(|s| s.centre.0[2] - s.radius).fold(f64::INFINITY, f64::min);
        let mut at = Vec3([sides[0] * stream.uniform(), sides[1] * stream.uniform(), column.top() - lowest]);
        loop {
            if interrupt.is_due() {
                return Err(Failure::Ungrown(Ungrown::Interrupted));
            }
            let anything = FreeDistance { gap: f64::INFINITY, nearest: Nearest::Unknown };
            let room = spheres.iter().fold(anything, |room, s| column.room(at + s.centre, s.radius, room));
            match room.nearest {
                Nearest::Floor if room.gap < self.graze => return Ok((at + DOWN * room.gap, true)),
                Nearest::Sphere(towards) if room.gap < self.graze => return Ok((at + towards * room.gap, false)),
                _ => {}
            }
            let cosine = exit_cosine(1.0 - stream.uniform(), self.drift, room.gap, self.diffusion).clamp(-1.0, 1.0);
            at = at + cone(DOWN, cosine, stream) * room.gap;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spheres(places: &[[f64; 3]], radius: f64) -> Vec<Sphere> {
        places.iter().map(|&x| Sphere { centre: Vec3(x), radius }).collect()
    }

    #[test]
    fn an_aggregate_meets_copies_of_itself_in_any_number_of_periods() {
        let sides = [10.0, 14.0];
        for (places, radius, expected) in [
            (&[[0.0; 3]][..], 5.0, true),
            (&[[0.0; 3]], 4.9, false),
            // The ends of a rod, along either axis.
            (&[[0.0; 3], [8.0, 0.0, 0.0]], 1.0, true),
            (&[[0.0; 3], [7.9, 0.0, 0.0]], 1.0, false),
            (&[[0.0; 3], [0.0, -12.0, 0.0]], 1.0, true),
            (&[[0.0; 3], [0.0, -11.9, 0.0]], 1.0, false),
            (&[[0.0; 3], [10.0, 0.0, 3.0]], 1.0, false),
            (&[[0.0; 3], [0.0, 14.0, 3.0]], 1.0, false),
            (&[[20.0, 0.0, 0.0], [28.0, 0.0, 0.0]], 1.0, true),
            // Two periods apart, or one along each axis; up and down there is no period.
            (&[[0.0; 3], [10.0, 0.0, 30.0], [20.0, 1.0, 0.0]], 1.0, true),
            (&[[0.0; 3], [0.0, 14.0, 30.0], [1.0, -28.0, 0.0]], 1.0, true),
            (&[[0.0; 3], [10.0, -14.0, 1.0]], 1.0, true),
            (&[[0.0; 3], [10.0, 14.0, 1.0]], 1.0, true),
            (&[[0.0; 3], [0.0, 0.0, 10.0], [0.0, 0.0, 14.0]], 1.0, false),
            // Copies one period apart of what is several periods wide.
            (&[[0.0; 3], [10.0, 0.5, 0.0], [35.0, 44.0, 30.0]], 1.0, true),
            (&[[0.0; 3], [0.5, 14.0, 0.0], [35.0, 44.0, 30.0]], 1.0, true),
            (&[[0.0; 3], [10.0, -14.0, 1.0], [35.0, 44.0, 30.0]], 1.0, true),
            (&[[0.0; 3], [5.0, 7.0, 0.0], [35.0, 44.0, 30.0]], 1.0, false),
        ] {
            assert_eq!(meets_itself(&spheres(places, radius), sides), expected, "{places:?} {radius}");
        }
    }

    #[test]
    fn an_aggregate_turns_as_a_whole_and_may_be_too_wide() {
        let begin = spheres(&[[0.0; 3], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 5.0]], 1.0);
        let mut turned = begin.clone();
        orient(&mut turned, [20.0; 2], &mut Stream::new(1, "test")).expect("room");
        assert!((turned[1].centre - begin[1].centre).norm() > 0.1);
        for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
            let [before, after] = [&begin, &turned].map(|s| (s[i].centre - s[j].centre).norm());
            assert!((before - after).abs() < 1e-12);
        }
        let volume = |s: &[Sphere]| s[1].centre.cross(s[2].centre).dot(s[3].centre);
        assert!((volume(&turned) - volume(&begin)).abs() < 1e-12);
        let wide = orient(&mut spheres(&[[0.0; 3], [0.0, 8.0, 6.0]], 3.0), [5.0; 2], &mut Stream::new(1, "test"));
        let Err(Failure::Wide { number: 2, extent }) = wide else { panic!("{wide:?}") };
        assert!((extent - 26.0).abs() < 1e-12, "{extent}");
        let small = orient(&mut spheres(&[[0.0; 3]], 0.25), [0.5; 2], &mut Stream::new(1, "test"));
        assert_eq!(small, Err(Failure::Wide { number: 1, extent: 0.5 }));
    }

    #[test]
    fn a_fall_begins_anywhere_above_the_column() {
        let (sides, column) = ([100.0, 20.0], Column::new([100.0, 20.0], 5.0));
        let path = Path { drift: 1.0, diffusion: 1.0, graze: 1e-3 };
        let fall = |seed| {
            let mut stream = Stream::new(seed, "test");
            path.fall(&column, &spheres(&[[0.0; 3]], 1.0), sides, &mut stream, &Interrupt::default())
                .expect("a place")
                .0
        };
        let places: Vec<Vec3<f64>> = (0..100).map(fall).collect();
        for (axis, side) in sides.into_iter().enumerate() {
            let along = || places.iter().map(|place| place.0[axis]);
            assert!(
                along().all(|x| (0.0..side).contains(&x))
                    && along().any(|x| x < 0.1 * side)
                    && along().any(|x| x > 0.9 * side)
            );
        }
    }

    #[test]
    fn a_fall_ends_where_the_lowest_or_the_next_sphere_touches() {
        let sides = [60.0; 2];
        let path = Path { drift: 1e6, diffusion: 1.0, graze: 1e-3 };
        let falling = spheres(&[[0.0, 0.0, 1.0], [0.0, 0.0, -3.0]], 2.0);
        let fall = |column: &Column, seed| {
            path.fall(column, &falling, sides, &mut Stream::new(seed, "test"), &Interrupt::default()).expect("a place")
        };
        let mut column = Column::new(sides, 10.0);
        let (at, on_floor) = fall(&column, 1);
        assert!(on_floor && (at.0[2] - 5.0).abs() < 1e-12, "{at:?}");
        // A floor of spheres: it rests upon them.
        for (x, y) in (0..6).flat_map(|x| (0..6).map(move |y| (10.0 * f64::from(x), 10.0 * f64::from(y)))) {
            column.add(Vec3([x, y, 10.0]), 10.0);
        }
        for seed in 0..20 {
            let (at, on_floor) = fall(&column, seed);
            let low = at + falling[1].centre;
            let gap = (0..6).flat_map(|x| (0..6).map(move |y| Vec3([10.0 * f64::from(x), 10.0 * f64::from(y), 10.0])));
            let period = |u: f64| u - 60.0 * (u / 60.0).round();
            let gap = gap.map(|s| s - low).map(|s| Vec3([period(s.0[0]), period(s.0[1]), s.0[2]]).norm() - 12.0);
            let gap = gap.fold(f64::INFINITY, f64::min);
            assert!(!on_floor && gap.abs() < 1e-9, "{gap}");
        }
        let interrupt = Interrupt::default();
        interrupt.request();
        let stopped = path.fall(&column, &falling, sides, &mut Stream::new(1, "test"), &interrupt);
        assert!(matches!(stopped, Err(Failure::Ungrown(Ungrown::Interrupted))));
    }
}
