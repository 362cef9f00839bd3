//! What became of a junction: the series that a run records, and the verdict drawn from it.

use super::third_body::{Motions, Mover, Window};
use super::{Link, upper_wall};
use crate::build::Body;
use crate::spec::Vec3;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// One row of the record: what happened over one window of sliding.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Displacement of the upper body along x since the beginning, nm.
    pub slid: f64,
    /// Displacement of the upper body along x in this window, nm.
    pub window: f64,
    /// Distance of the two bodies' surfaces: the junction's height, and how far the upper wall has risen since, nm.
    pub separation: f64,
    /// Force that drags the upper wall, pN: positive resists the sliding.
    pub friction: f64,
    /// Force that the spheres push the upper wall away with, pN.
    pub normal: f64,
    /// Spheres in the third body.
    pub third_size: usize,
    /// Those of them that were the junction.
    pub third_from_junction: usize,
    /// Mass of the third body, ag.
    pub third_mass: f64,
    /// Its extent along the normal, nm.
    pub third_height: f64,
    /// Rotation of the third body in this window, rad.
    pub rolled: f64,
    /// Rotations of the third body since the beginning.
    pub turns: f64,
    /// Share of the third body's motion that a rotation explains.
    pub rigidity: f64,
    /// Links between the third body and the lower body.
    pub links_to_bottom: usize,
    /// Links between the third body and the upper body.
    pub links_to_top: usize,
    /// Links between the two bodies themselves.
    pub links_direct: usize,
}

/// Watches a junction while it is sheared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    height: f64,
    start: [f64; 3],
    mark: [f64; 3],
    before: Vec<[f64; 3]>,
    /// What was seen so far.
    pub rows: Vec<Row>,
}

impl Witness {
    /// Begins to watch: `height` is the distance of the bodies at the beginning, nm.
    pub fn new(system: &System, height: f64) -> Self {
        let start = upper_wall(system).0;
        Self { height, start, mark: start, before: by_id(system), rows: Vec::new() }
    }

    /// Closes a window and opens the next.
    pub fn look(&mut self, system: &System, links: &[Link]) -> &Row {
        let now = upper_wall(system);
        let slid = now - Vec3(self.mark);
        let before: Vec<Vec3<f64>> = self.before.iter().map(|&x| Vec3(x)).collect();
        let motions = Motions::find(system, links, &Window { before: &before, slid });
        let third = motions.third.as_ref();
        let rolled = third.map_or(0.0, |t| t.rolled);
        let members = third.map_or(&[][..], |t| &t.members);
        let turned = self.rows.last().map_or(0.0, |row| row.turns);
        let wall = system.walls[1].force;
        self.rows.push(Row {
            slid: (now - Vec3(self.start)).0[0],
            window: slid.0[0],
            separation: self.height + (now - Vec3(self.start)).0[1],
            friction: -wall.0[0],
            normal: wall.0[1],
            third_size: members.len(),
            third_from_junction: members.iter().filter(|&&i| Body::is_junction(system.particles.tag[i])).count(),
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

    /// What became of the junction.
    pub fn fate(&self) -> Fate {
        Fate::of(&self.rows, self.height)
    }
}

fn by_id(system: &System) -> Vec<[f64; 3]> {
    let p = &system.particles;
    let mut x = vec![[0.0; 3]; p.len()];
    for i in 0..p.len() {
        x[p.id[i] as usize] = p.x[i].0;
    }
    x
}

/// What became of a junction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// The bodies have come closer than half the junction's height: it was squeezed flat between them.
    Flattened,
    /// A third body turns rigidly between the bodies and holds them apart.
    Rolls,
    /// The bodies slide apart without touching each other and nothing turns between them: the junction was cut.
    Cut,
    /// None of these: the junction still links the bodies and deforms.
    Attached,
}

/// A junction that keeps its volume and loses half of its height has spread to twice its section.
const FLAT: f64 = 0.5;
/// Halfway between a round body in simple shear, which turns by 1/2 of sliding over height and whose motion is by 1/2 a
/// rotation, and a rolling one, for which both are 1.
const ROLLING: f64 = 0.75;

impl Fate {
    /// The verdict on the last third of the sliding, when the beginning is forgotten.
    pub fn of(rows: &[Row], height: f64) -> Self {
        let Some(last) = rows.last() else { return Self::Attached };
        let late: Vec<&Row> = rows.iter().filter(|row| 3.0 * row.slid >= 2.0 * last.slid).collect();
        let mean = |f: &dyn Fn(&Row) -> f64| late.iter().map(|row| f(row)).sum::<f64>() / late.len() as f64;
        if mean(&|row| row.separation) < FLAT * height {
            return Self::Flattened;
        }
        // Sliding that the rotation accounts for: a rolling body of that height turns by sliding over height.
        let rolling = mean(&|row| row.rolled * row.third_height) / mean(&|row| row.window);
        if rolling > ROLLING && mean(&|row| row.rigidity) > ROLLING {
            return Self::Rolls;
        }
        let linked = |row: &Row| row.links_direct + row.links_to_bottom.min(row.links_to_top) > 0;
        if late.iter().any(|row| linked(row)) { Self::Attached } else { Self::Cut }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    fn fate(separation: f64, rolled: f64, rigidity: f64, links: usize) -> Fate {
        let mut rows: Vec<Row> = (1..=60).map(|k| row(f64::from(k), 10.0, 0.0, 0.0, 9)).collect();
        rows[35..].fill(row(0.0, separation, rolled, rigidity, links));
        for (k, row) in rows.iter_mut().enumerate() {
            row.slid = (k + 1) as f64;
        }
        Fate::of(&rows, 10.0)
    }

    #[test]
    fn the_verdict_follows_the_measures_of_the_last_third() {
        assert_eq!(fate(4.9, 0.0, 0.0, 9), Fate::Flattened);
        assert_eq!(fate(12.0, 0.8 / 12.0, 0.9, 9), Fate::Rolls);
        assert_eq!(fate(12.0, 0.5 / 12.0, 0.5, 9), Fate::Attached);
        assert_eq!(fate(10.0, 0.0, 0.0, 0), Fate::Cut);
    }

    #[test]
    fn a_round_body_in_simple_shear_does_not_roll() {
        assert_eq!(fate(12.0, 0.5 / 12.0, 0.9, 9), Fate::Attached);
        assert_eq!(fate(12.0, 1.0 / 12.0, 0.5, 9), Fate::Attached);
    }
}
