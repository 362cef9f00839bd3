//! The fate of a junction: the series that a run records, and the verdict derived from it.

use super::junction::JunctionPart;
use crate::observe::third_body::{Motions, Mover, Window};
use crate::observe::{Link, upper_wall};
use crate::spec::Vec3;
use crate::system::{System, Wall};
use serde::{Deserialize, Serialize};

/// Sliding distance between two searches for the third body, nm.
pub const WINDOW: f64 = 1.0;

/// One row of the record: the motion within one window of sliding.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Displacement of the upper body along x since the beginning, nm.
    pub slid: f64,
    /// Displacement of the upper body along x in this window, nm.
    pub window: f64,
    /// Distance between the surfaces of the two bodies: the initial height of the junction plus the rise of the upper wall, nm.
    pub separation: f64,
    /// Mean friction force on the upper wall, pN: positive if it resists the sliding.
    pub friction: f64,
    /// Mean normal force of the spheres on the upper wall, pN.
    pub normal: f64,
    /// Number of spheres in the third body.
    pub third_size: usize,
    /// Number of them that belonged to the junction.
    pub third_from_junction: usize,
    /// Mass of the third body, ag.
    pub third_mass: f64,
    /// Its height along the normal, nm.
    pub third_height: f64,
    /// Rotation of the third body in this window, rad.
    pub rolled: f64,
    /// Rotations of the third body since the beginning.
    pub turns: f64,
    /// Fraction of the third body's motion explained by a rigid rotation.
    pub rigidity: f64,
    /// Number of links between the third body and the lower body.
    pub links_to_bottom: usize,
    /// Number of links between the third body and the upper body.
    pub links_to_top: usize,
    /// Number of direct links between the two bodies.
    pub links_direct: usize,
}

/// Friction and normal force of the spheres on the upper wall, pN, summed over steps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct WallForces {
    sum: [f64; 2],
    steps: u64,
}

impl WallForces {
    pub(super) fn add(&mut self, wall: &Wall) {
        let [x, y, _] = wall.force.0;
        self.sum = [self.sum[0] - x, self.sum[1] + y];
        self.steps += 1;
    }
    pub(super) fn mean(&self) -> [f64; 2] {
        self.sum.map(|sum| sum / self.steps as f64)
    }
}

/// Observes a junction during shearing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    height: f64,
    start: [f64; 3],
    mark: [f64; 3],
    before: Vec<[f64; 3]>,
    /// The forces in the window, and since the beginning.
    window: WallForces,
    total: WallForces,
    /// Ids of the third body in the last window, in ascending order.
    members: Vec<u32>,
    /// The rows so far.
    pub rows: Vec<Row>,
}

impl Witness {
    /// Starts observing; `height` is the initial distance between the bodies, nm.
    pub fn new(system: &System, height: f64) -> Self {
        let start = upper_wall(system).0;
        let (window, total) = (WallForces::default(), WallForces::default());
        Self { height, start, mark: start, before: by_id(system), window, total, members: Vec::new(), rows: Vec::new() }
    }

    /// Number of spheres that it observes.
    pub fn spheres(&self) -> usize {
        self.before.len()
    }

    /// Observes a step.
    pub fn follow(&mut self, system: &System) {
        self.window.add(&system.walls[1]);
        self.total.add(&system.walls[1]);
    }

    /// Mean friction and normal force since the beginning, pN.
    pub fn mean_forces(&self) -> [f64; 2] {
        self.total.mean()
    }

    /// Ids of the third body in the last window, in ascending order.
    pub fn members(&self) -> &[u32] {
        &self.members
    }

    /// Closes a window, after its last step has been observed, and opens the next.
    pub fn look(&mut self, system: &System, links: &[Link]) -> &Row {
        let now = upper_wall(system);
        let slid = now - Vec3(self.mark);
        let before: Vec<Vec3<f64>> = self.before.iter().map(|&x| Vec3(x)).collect();
        let motions = Motions::find(system, links, &Window { before: &before, slid });
        let third = motions.third.as_ref();
        let rolled = third.map_or(0.0, |t| t.rolled);
        let members = third.map_or(&[][..], |t| &t.members);
        let turned = self.rows.last().map_or(0.0, |row| row.turns);
        let [friction, normal] = std::mem::take(&mut self.window).mean();
        self.members = members.iter().map(|&i| system.particles.id[i]).collect();
        self.members.sort_unstable();
        self.rows.push(Row {
            slid: (now - Vec3(self.start)).0[0],
            window: slid.0[0],
            separation: self.height + (now - Vec3(self.start)).0[1],
            friction,
            normal,
            third_size: members.len(),
            third_from_junction: members
                .iter()
                .filter(|&&i| JunctionPart::is_junction(system.particles.tag[i]))
                .count(),
            third_mass: third.map_or(0.0, |t| t.mass),
            third_height: third.map_or(0.0, |t| t.height),
            rolled,
            turns: turned + rolled / std::f64::consts::TAU,
            rigidity: third.map_or(0.0, |t| t.rigidity),
            links_to_bottom: motions.links_between(links, Mover::Third, Mover::Bottom),
            links_to_top: motions.links_between(links, Mover::Third, Mover::Top),
            links_direct: motions.links_between(links, Mover::Bottom, Mover::Top),
        });
        self.mark = now.0;
        self.before = by_id(system);
        &self.rows[self.rows.len() - 1]
    }

    /// The fate of the junction.
    pub fn fate(&self) -> Fate {
        Fate::of(&self.rows, self.height)
    }
}

/// The centres of all spheres, nm, in the order of their ids.
pub(super) fn by_id(system: &System) -> Vec<[f64; 3]> {
    let p = &system.particles;
    let mut x = vec![[0.0; 3]; p.len()];
    for i in 0..p.len() {
        x[p.id[i] as usize] = p.x[i].0;
    }
    x
}

/// The fate of a junction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// The bodies came closer than [`FLAT`] of the junction's height: it was squeezed flat between them.
    Flattened,
    /// A third body rolled by [`ROLLED`] between the bodies and kept them apart.
    Rolls,
    /// Neither, and the bodies are separated at the end: the junction was cut.
    Cut,
    /// Neither, and the junction still joins the bodies.
    Attached,
}

/// A junction that keeps its volume and loses a third of its height has spread to one and a half times its cross-section. A
/// rolling junction lifts the bodies instead: rolled into a ball, a cylinder twice as wide as high becomes 1.8 times as high.
pub const FLAT: f64 = 2.0 / 3.0;
/// Turns after which a body has rolled: by a quarter, the faces that were torn off the two bodies stand upright.
pub const ROLLED: f64 = 0.25;
/// The smallest rotation, times height over sliding distance, that counts as rolling: midway between 1/2, the value of a round
/// body in simple shear, and 1, the value of a rolling body.
pub const ROLLING: f64 = 0.75;
/// Sliding distance over which the separation is averaged, in heights, because the bodies vibrate.
const SMOOTHING: f64 = 0.5;

impl Fate {
    /// The verdict: flattening or rolling, whichever came first.
    pub fn of(rows: &[Row], height: f64) -> Self {
        let (mut slid, mut swept) = (0.0, 0.0);
        for (k, row) in rows.iter().enumerate() {
            slid += row.window;
            swept += row.rolled * row.third_height;
            let recent = rows[..=k].iter().rev().take_while(|past| row.slid - past.slid < SMOOTHING * height);
            let (sum, count) = recent.fold((0.0, 0.0), |(sum, count), past| (sum + past.separation, count + 1.0));
            if sum < FLAT * height * count {
                return Self::Flattened;
            }
            if row.turns >= ROLLED && swept >= ROLLING * slid {
                return Self::Rolls;
            }
        }
        let joined = |row: &Row| row.links_direct + row.links_to_bottom.min(row.links_to_top) > 0;
        if rows.last().is_none_or(joined) { Self::Attached } else { Self::Cut }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Domain, Motion, Particles};

    fn row(slid: f64, separation: f64, rolled: f64, rigidity: f64, links: usize) -> Row {
        Row {
            slid,
            window: 1.0,
            separation,
            friction: 0.0,
            normal: 0.0,
            third_size: 0,
            third_from_junction: 0,
            third_mass: 0.0,
            third_height: 12.0,
            rolled,
            turns: 0.0,
            rigidity,
            links_to_bottom: links,
            links_to_top: links,
            links_direct: 0,
        }
    }

    /// Sixty windows of 1 nm, from the eleventh on with the given separation and rotation; the junction is 10 nm high.
    fn fate(separation: f64, rolled: f64, links: usize) -> Fate {
        let mut rows: Vec<Row> = Vec::new();
        for k in 1..=60 {
            let (separation, rolled) = if k > 10 { (separation, rolled) } else { (10.0, 0.0) };
            let turns = rows.last().map_or(0.0, |row| row.turns) + rolled / std::f64::consts::TAU;
            rows.push(Row { turns, ..row(f64::from(k), separation, rolled, 0.9, links) });
        }
        Fate::of(&rows, 10.0)
    }

    #[test]
    fn the_verdict_is_what_came_first() {
        assert_eq!(fate(6.0, 0.0, 9), Fate::Flattened);
        assert_eq!(fate(6.0, 1.0 / 12.0, 9), Fate::Flattened);
        assert_eq!(fate(12.0, 1.0 / 12.0, 9), Fate::Rolls);
        assert_eq!(fate(8.0, 0.0, 9), Fate::Attached);
        assert_eq!(fate(8.0, 0.0, 0), Fate::Cut);
    }

    #[test]
    fn a_round_body_in_simple_shear_does_not_roll_however_far_it_turns() {
        assert_eq!(fate(12.0, 0.5 / 12.0, 9), Fate::Attached);
    }

    #[test]
    fn a_vibration_is_no_flattening() {
        let mut rows: Vec<Row> = (1..=20).map(|k| row(f64::from(k), 10.0, 0.0, 0.0, 9)).collect();
        rows[12].separation = 5.0;
        assert_eq!(Fate::of(&rows, 10.0), Fate::Attached);
    }

    #[test]
    fn the_first_window_counts_and_so_does_the_last() {
        let only = |separation: f64, turns: f64, links: usize| {
            Fate::of(&[Row { turns, ..row(1.0, separation, 1.0 / 12.0, 0.9, links) }], 10.0)
        };
        assert_eq!(only(6.0, 0.0, 9), Fate::Flattened);
        assert_eq!(only(12.0, ROLLED, 9), Fate::Rolls);
        assert_eq!([only(12.0, 0.0, 9), only(12.0, 0.0, 0)], [Fate::Attached, Fate::Cut]);
        // the mean over half a height falls below two thirds with the fifth window, the last
        let mut rows: Vec<Row> = (1..=20).map(|k| row(f64::from(k), 10.0, 0.0, 0.0, 0)).collect();
        rows[15..].iter_mut().for_each(|row| row.separation = 6.0);
        assert_eq!([Fate::of(&rows[..19], 10.0), Fate::of(&rows, 10.0)], [Fate::Cut, Fate::Flattened]);
        // links of the last window decide, the way of the first is part of the whole
        rows.iter_mut().for_each(|row| row.separation = 10.0);
        (rows[19].links_direct, rows[19].links_to_top) = (1, 9);
        assert_eq!([Fate::of(&rows[..19], 10.0), Fate::of(&rows, 10.0)], [Fate::Cut, Fate::Attached]);
        rows[19].links_direct = 0;
        assert_eq!(Fate::of(&rows, 10.0), Fate::Cut);
        (rows[0].window, rows[0].rolled, rows[19].turns) = (1.0, 15.1 / 12.0, ROLLED);
        assert_eq!(Fate::of(&rows, 10.0), Fate::Rolls);
        rows[0].window = 1.2;
        assert_eq!(Fate::of(&rows, 10.0), Fate::Cut);
    }

    #[test]
    fn a_window_without_a_third_body_has_no_rotation() {
        let mut particles = Particles::default();
        [0.0, 10.0].into_iter().for_each(|y| particles.push(Vec3([0.0, y, 0.0]), 0.5, 1.0, 0));
        let mut system = System::new(particles, Domain::periodic([20.0; 3]));
        for member in 0..2 {
            system.add_wall([Motion::Velocity(0.0); 3], |_, p| p == member);
        }
        let mut witness = Witness::new(&system, 9.0);
        system.particles.x[1] = Vec3([2.0, 11.0, 0.0]);
        system.walls[1].force = Vec3([-3.0, 5.0, 0.0]);
        witness.follow(&system);
        let found = witness.look(&system, &[]);
        let expected = Row { friction: 3.0, normal: 5.0, third_height: 0.0, ..row(2.0, 10.0, 0.0, 0.0, 0) };
        assert_eq!(*found, Row { window: 2.0, ..expected });
    }
}
