//! Everything that is wrong with a system put together by hand.

use super::Builder;
use crate::error::Problem;
use crate::spec::Vec3;
use crate::system::Motion;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The problems found so far.
#[derive(Default)]
struct Found(Vec<Problem>);

impl Found {
    fn add(&mut self, key: String, what: impl Into<String>) {
        self.0.push(Problem { file: PathBuf::new(), line: None, key, what: what.into() });
    }
}

/// The body or wall of each sphere, if any.
type Groups = Vec<Option<usize>>;

impl Builder {
    /// All problems: of the box, the spheres, the bodies and walls, and the necks.
    pub(super) fn problems(&self) -> Vec<Problem> {
        let mut found = Found::default();
        self.check_spheres(&mut found);
        let bodies: Vec<&[u32]> = self.bodies.iter().map(Vec::as_slice).collect();
        let walls: Vec<&[u32]> = self.walls.iter().map(|wall| wall.0.as_slice()).collect();
        let body = self.groups("body", &bodies, &mut found);
        let wall = self.groups("wall", &walls, &mut found);
        self.check_motions(&mut found);
        self.check_bodies(&body, &wall, &mut found);
        self.check_necks(&body, &wall, &mut found);
        found.0
    }

    fn exists(&self, id: u32) -> bool {
        (id as usize) < self.particles.len()
    }

    fn no_sphere(&self, id: u32) -> String {
        format!("there is no sphere {id}, expected an id below {}", self.particles.len())
    }

    fn check_spheres(&self, found: &mut Found) {
        let particles = &self.particles;
        let is_positive = |value: f64| value > 0.0 && value.is_finite();
        for (axis, side) in self.domain.iter().flat_map(|domain| domain.sides).enumerate() {
            if !is_positive(side) {
                found.add("box".into(), format!("side {axis} is {side}, expected a positive number"));
            }
        }
        if particles.is_empty() {
            found.add("system".into(), "has no spheres, expected one at least");
        }
        let mut places = BTreeSet::new();
        for p in 0..particles.len() {
            let sphere = || format!("sphere {p}");
            for (name, value) in [("radius", particles.radius[p]), ("mass", particles.mass[p])] {
                if !is_positive(value) {
                    found.add(sphere(), format!("its {name} is {value}, expected a positive number"));
                }
            }
            for (name, u) in [("centre", particles.x[p]), ("velocity", particles.v[p]), ("spin", particles.w[p])] {
                if !u.0.iter().all(|a| a.is_finite()) {
                    found.add(sphere(), format!("its {name} is {:?}, expected finite numbers", u.0));
                }
            }
            let x = self.domain.map_or(particles.x[p], |domain| domain.folded(particles.x[p]));
            // Adding zero makes one zero of the two.
            if !places.insert(x.0.map(|a| (a + 0.0).to_bits())) {
                found.add(sphere(), "its centre coincides with the centre of another sphere");
            }
        }
    }

    /// Assigns the spheres to the groups of a kind; each may belong to one.
    fn groups(&self, kind: &str, groups: &[&[u32]], found: &mut Found) -> Groups {
        let mut of: Groups = vec![None; self.particles.len()];
        for (number, members) in groups.iter().enumerate() {
            let key = || format!("{kind} {number}");
            if members.is_empty() {
                found.add(key(), "has no spheres");
            }
            for &id in *members {
                match of.get_mut(id as usize) {
                    None => found.add(key(), self.no_sphere(id)),
                    Some(Some(other)) if *other == number => found.add(key(), format!("sphere {id} is given twice")),
                    Some(Some(other)) => found.add(key(), format!("sphere {id} belongs to {kind} {other} already")),
                    Some(none) => *none = Some(number),
                }
            }
        }
        of
    }

    fn check_motions(&self, found: &mut Found) {
        let makes_sense = |motion: &Motion| match *motion {
            Motion::Velocity(value) | Motion::Load(value) => value.is_finite(),
            Motion::Return { speed, turn } => speed.is_finite() && turn > 0.0,
        };
        for (number, (_, motion)) in self.walls.iter().enumerate() {
            for motion in motion.iter().filter(|motion| !makes_sense(motion)) {
                let what = format!("its motion is {motion:?}, expected finite numbers and a positive duration");
                found.add(format!("wall {number}"), what);
            }
        }
    }

    /// The spheres of a body have one velocity, one wall or none, and no spin.
    fn check_bodies(&self, body: &Groups, wall: &Groups, found: &mut Found) {
        let particles = &self.particles;
        for (number, members) in self.bodies.iter().enumerate() {
            let mut members = members.iter().filter(|&&id| self.exists(id)).map(|&id| id as usize);
            let Some(first) = members.next() else { continue };
            let pair = |p: usize| format!("spheres {first} and {p}");
            for p in members {
                let key = || format!("body {number}");
                if particles.v[p] != particles.v[first] {
                    found.add(key(), format!("{} have different velocities, expected one for all", pair(p)));
                }
                if wall[p] != wall[first] {
                    found.add(key(), format!("only one of the {} belongs to a wall, expected all or none", pair(p)));
                }
            }
        }
        for p in (0..particles.len()).filter(|&p| body[p].is_some() && particles.w[p] != Vec3::zero()) {
            found.add(format!("sphere {p}"), "it belongs to a body, expected no spin of its own");
        }
    }

    fn check_necks(&self, body: &Groups, wall: &Groups, found: &mut Found) {
        let mut joined = BTreeSet::new();
        for &(i, j) in &self.necks {
            let key = || format!("neck {i}-{j}");
            for id in [i, j].into_iter().filter(|&id| !self.exists(id)) {
                found.add(key(), self.no_sphere(id));
            }
            if i == j {
                found.add(key(), "joins a sphere to itself");
            }
            if !joined.insert((i, j)) {
                found.add(key(), "is given twice");
            }
            let group = |of: &Groups, id: u32| of.get(id as usize).copied().flatten();
            let together = |of: &Groups| group(of, i).is_some() && group(of, i) == group(of, j);
            if i != j && (together(body) || together(wall)) {
                found.add(key(), "joins two spheres of one rigid body or wall");
            }
        }
    }
}
