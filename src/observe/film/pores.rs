//! Pore sizes: the largest empty sphere that contains a point (Gelb & Gubbins, Langmuir 15, 305, 1999), by Monte Carlo.

use super::radius;
use crate::geometry::directions::direction;
use crate::initial::film::DepositedFilm;
use crate::initial::film::column::Column;
use crate::random::Stream;
use crate::spec::Vec3;

/// Empty balls that are looked for.
const BALLS: usize = 4000;
/// Places that each of them tries on its way to where it is largest.
const MOVES: usize = 60;
/// Points that are asked.
const POINTS: usize = 2000;
/// Parts of the points.
const QUANTILES: [f64; 3] = [0.1, 0.5, 0.9];

/// Quantiles of the pore diameters of the bulk, nm: lower bounds, for larger balls may have been missed.
pub(super) fn pores(film: &DepositedFilm, bulk: [f64; 2], seed: u64) -> [f64; 3] {
    let largest = film.spheres.iter().map(radius).fold(0.0, f64::max);
    let mut column = Column::new(film.sides, largest);
    for s in &film.spheres {
        column.add(s.centre, radius(s));
    }
    let mut stream = Stream::new(seed, "pores");
    let mut empty = || loop {
        let [x, y, z] = [0.0; 3].map(|_: f64| stream.uniform());
        let x = Vec3([x * film.sides[0], y * film.sides[1], bulk[0] + z * (bulk[1] - bulk[0])]);
        let room = column.clearance(x);
        if room > 0.0 {
            return (x, room);
        }
    };
    let points: Vec<_> = (0..POINTS).map(|_| empty()).collect();
    let begun: Vec<_> = (0..BALLS).map(|_| empty()).collect();
    let balls: Vec<_> = begun.into_iter().map(|ball| grown(ball, &column, bulk, &mut stream)).collect();
    let apart = |x: Vec3<f64>, y: Vec3<f64>| {
        let to = x - y;
        let nearest = |a: usize| to.0[a] - (to.0[a] / film.sides[a]).round() * film.sides[a];
        Vec3([nearest(0), nearest(1), to.0[2]]).norm()
    };
    let size = |&(x, own): &(Vec3<f64>, f64)| {
        let holding = balls.iter().filter(|&&(centre, room)| room > own && apart(x, centre) < room);
        2.0 * holding.map(|ball| ball.1).fold(own, f64::max)
    };
    let mut sizes: Vec<f64> = points.iter().map(size).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    QUANTILES.map(|part| sizes[(part * POINTS as f64) as usize])
}

/// A ball moved, inside the bulk, to where it finds more room.
fn grown(ball: (Vec3<f64>, f64), column: &Column, bulk: [f64; 2], stream: &mut Stream) -> (Vec3<f64>, f64) {
    let (mut at, mut room) = ball;
    let mut step = room;
    for _ in 0..MOVES {
        let there = at + direction(stream) * step;
        let inside = there.0[2] >= bulk[0] && there.0[2] <= bulk[1];
        let more = if inside { column.clearance(there) } else { 0.0 };
        if more > room {
            (at, room) = (there, more);
        } else {
            step *= 0.9;
        }
    }
    (at, room)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_grows_and_stays_inside_the_bulk() {
        // A low ceiling over the middle: more room is above and below the bulk, and beside the middle.
        let mut column = Column::new([100.0; 2], 40.0);
        column.add(Vec3([50.0, 50.0, 60.0]), 40.0);
        let begin = Vec3([50.0, 50.0, 15.0]);
        let begun = column.clearance(begin);
        for bulk in [[12.0, 20.0], [0.0, 90.0]] {
            for seed in 0..20 {
                let mut stream = Stream::new(seed, "test");
                let (at, room) = grown((begin, begun), &column, bulk, &mut stream);
                assert!((bulk[0]..=bulk[1]).contains(&at.0[2]), "{bulk:?} {at:?}");
                assert!(room > begun && room == column.clearance(at), "{room} {begun}");
            }
        }
    }
}
