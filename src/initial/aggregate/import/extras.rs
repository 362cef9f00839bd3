//! What a file may say of spheres beyond their centres and radii.

use super::Source;
use crate::error::Error;
use crate::spec::Vec3;

/// Rigid bodies and velocities: each list has an entry for every sphere, or none at all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extras {
    /// The numbers of the rigid bodies to which the spheres belong; 0 for a sphere by itself.
    pub bodies: Vec<u32>,
    /// Velocities, m/s.
    pub v: Vec<Vec3<f64>>,
    /// Angular velocities, 1/ns.
    pub w: Vec<Vec3<f64>>,
}

impl Extras {
    /// The numbers of the spheres of each body, in the order in which the bodies come up in the file; spheres by themselves are left out.
    pub fn members(&self) -> Vec<Vec<usize>> {
        let mut places = std::collections::BTreeMap::new();
        let mut members: Vec<Vec<usize>> = Vec::new();
        for (sphere, &body) in self.bodies.iter().enumerate().filter(|(_, body)| **body > 0) {
            let place = *places.entry(body).or_insert(members.len());
            if place == members.len() {
                members.push(Vec::new());
            }
            members[place].push(sphere);
        }
        members
    }

    /// Appends the number of a body.
    pub(super) fn push_body(&mut self, source: &Source, line: usize, word: &str) -> Result<(), Error> {
        // Tables that hold numbers only write 1 as 1.0.
        let number = source.number(line, word).ok().filter(|number| number.fract() == 0.0);
        let Some(number) = number.filter(|number| (0.0..=f64::from(u32::MAX)).contains(number)) else {
            let what = format!("found `{word}`, expected the number of a rigid body, or 0 for a sphere by itself");
            return Err(source.at(line, &what));
        };
        self.bodies.push(number as u32);
        Ok(())
    }

    /// Appends a velocity, and one of rotation, if they are given.
    pub(super) fn push_motion(
        &mut self,
        source: &Source,
        line: usize,
        v: Option<[&str; 3]>,
        w: Option<[&str; 3]>,
    ) -> Result<(), Error> {
        for (list, words) in [(&mut self.v, v), (&mut self.w, w)] {
            if let Some([x, y, z]) = words {
                let number = |word| source.number(line, word);
                list.push(Vec3([number(x)?, number(y)?, number(z)?]));
            }
        }
        Ok(())
    }

    /// The same in units of the engine: angular velocities are given in m/s per unit of length of the file, of this many nm.
    pub(super) fn scaled(mut self, unit: f64) -> Self {
        self.w.iter_mut().for_each(|w| *w = *w * (1.0 / unit));
        self
    }
}
