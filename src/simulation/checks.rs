//! The checks of every step.

use super::{Settings, Simulation};
use crate::error::{Halt, Reason, Stability};
use crate::spec::mechanics::coordinated_step::coordinated_time_step;
use crate::spec::{PairModel, Vec3};
use crate::system::{Domain, Particles, System};
use std::collections::BTreeSet;

/// Gap up to which spheres touch, as a fraction of the sum of their radii.
const TOUCHING: f64 = 1e-6;

/// Most copies of a box, along an axis, that a sphere may touch: any more are a mistake, and exhaust the memory.
const IMAGES: f64 = 16.0;

impl<M: PairModel> Simulation<M> {
    pub(super) fn halt(&self, reason: Reason) -> Halt {
        Halt { step: self.system.step, time: self.system.time, reason, unstable: None }
    }

    /// The halt with the sphere for which the time step may have been too long.
    pub fn explained(&self, halt: Halt) -> Halt {
        Halt { unstable: self.stability().filter(|stability| !stability.holds()).map(Box::new), ..halt }
    }

    /// The stability of the free sphere that, with all its contacts and necks, limits the time step most; none without contacts.
    pub fn stability(&self) -> Option<Stability> {
        let particles = &self.system.particles;
        let mut held = vec![(0, 0); particles.len()];
        for (i, j, contact, _) in self.contacts() {
            let neck = self.system.necks.binary_search(&(particles.id[i], particles.id[j])).is_ok();
            let touches = contact.gap <= TOUCHING * (contact.r_i + contact.r_j);
            for p in [i, j] {
                held[p].0 += usize::from(touches && !neck);
                held[p].1 += usize::from(neck);
            }
        }
        let largest = particles.radius.iter().copied().fold(0.0, f64::max);
        let free = (0..particles.len()).filter(|&p| particles.wall[p] == 0 && held[p] != (0, 0));
        let stability = free.map(|p| {
            let (contacts, necks) = held[p];
            let pair = self.model.critical_time_step_among(particles.radius[p], particles.mass[p], largest);
            let limit = coordinated_time_step(pair, (contacts + necks) as f64);
            Stability { dt: self.settings.dt, particle: particles.id[p], contacts, necks, limit }
        });
        stability.reduce(|least, other| if other.limit < least.limit { other } else { least })
    }

    /// The least stability limit of a free sphere in contact with an equal or with the largest one, ns, and the sphere that sets it.
    pub fn critical_time_step(&self) -> (f64, u32) {
        let particles = &self.system.particles;
        let largest = particles.radius.iter().copied().fold(0.0, f64::max);
        let limit = |p: usize| self.model.critical_time_step_among(particles.radius[p], particles.mass[p], largest);
        (0..particles.len())
            .filter(|&p| particles.wall[p] == 0)
            .map(|p| (limit(p), particles.id[p]))
            .fold((f64::INFINITY, 0), |least, limit| if limit.0 < least.0 { limit } else { least })
    }

    /// Settings that comparisons in the step loop take for granted.
    pub(super) fn check_settings(&self) -> Result<(), Halt> {
        let Settings { dt, damping, skin, max_overlap, far_every, .. } = self.settings;
        let (finite, positive) = ("a finite number, 0 or more", "a positive number");
        for (name, value, holds, expected) in [
            ("dt", dt, dt > 0.0, positive),
            ("damping", damping, damping >= 0.0 && damping.is_finite(), finite),
            ("skin", skin, skin >= 0.0 && skin.is_finite(), finite),
            ("max_overlap", max_overlap, max_overlap > 0.0, positive),
            ("far_every", far_every as f64, far_every > 0, "1 or more"),
        ] {
            if !holds {
                return Err(self.halt(Reason::Setting { name, value, expected }));
            }
        }
        self.check_images()?;
        self.check_time_step()
    }

    /// Whether the box is large enough for its copies to be counted.
    fn check_images(&self) -> Result<(), Halt> {
        let largest = self.system.particles.radius.iter().copied().fold(0.0, f64::max);
        let reach = self.model.range(largest, largest) + self.settings.skin;
        let Domain { sides, periodic } = self.system.domain;
        let narrow = (0..3).filter(|&axis| periodic[axis]).map(|axis| sides[axis]).find(|side| reach > IMAGES * side);
        let (name, expected) =
            ("periodic side", "at least a sixteenth of the range of the largest spheres and the skin");
        narrow.map_or(Ok(()), |value| Err(self.halt(Reason::Setting { name, value, expected })))
    }

    /// Whether all necks join spheres of the system.
    pub(super) fn check_necks(&self) -> Result<(), Halt> {
        if self.system.necks.is_empty() {
            return Ok(());
        }
        let ids: BTreeSet<u32> = self.system.particles.id.iter().copied().collect();
        let stranger = self.system.necks.iter().flat_map(|&(i, j)| [i, j]).find(|id| !ids.contains(id));
        stranger.map_or(Ok(()), |particle| Err(self.halt(Reason::NoSphere { particle })))
    }

    fn check_time_step(&self) -> Result<(), Halt> {
        let (limit, particle) = self.critical_time_step();
        let dt = self.settings.dt;
        if dt < limit { Ok(()) } else { Err(self.halt(Reason::TimeStep { dt, limit, particle })) }
    }

    /// A NaN anywhere makes the kinetic energy one, but for that of a box whose spheres are at rest.
    pub(super) fn check_finite(&self, kinetic: f64) -> Result<(), Halt> {
        if !self.box_motion.rate.iter().all(|rate| rate.is_finite()) {
            return Err(self.not_a_number("sides of the box"));
        }
        if kinetic.is_finite() {
            return Ok(());
        }
        let particles = &self.system.particles;
        let bad = |u: &Vec3<f64>| !u.dot(*u).is_finite();
        let mut lost = (0..particles.len()).find(|&p| [particles.x[p], particles.v[p], particles.w[p]].iter().any(bad));
        if let Some(body) = self.system.bodies.iter().position(|body| bad(&body.v) || !body.kinetic().is_finite()) {
            lost = particles.body.iter().position(|&number| number as usize == body + 1);
        }
        Err(self.halt(Reason::NotFinite { particle: lost.map_or(0, |p| particles.id[p]) }))
    }

    /// Checks the state that a frame holds: spheres, box, walls and surfaces.
    ///
    /// # Errors
    ///
    /// The first quantity that is not finite, or too large for the single precision of a frame.
    pub fn check_frame(&self) -> Result<(), Halt> {
        let bad = |u: &Vec3<f64>| u.0.iter().any(|&x| !(x as f32).is_finite());
        let System { particles: Particles { x, v, w, radius, mass, id, .. }, domain, walls, surfaces, .. } =
            &self.system;
        let sphere = |p: &usize| [x[*p], v[*p], w[*p], Vec3([radius[*p], mass[*p], 0.0])].iter().any(bad);
        if let Some(p) = (0..x.len()).find(sphere) {
            return Err(self.halt(Reason::NotFinite { particle: id[p] }));
        }
        let of_walls = walls.iter().enumerate().map(|(k, wall)| (format!("velocity of wall {}", k + 1), wall.velocity));
        let of_surfaces = surfaces.iter().map(|surface| (format!("position of the {}", surface.name), surface.way));
        let of_box = [("sides of the box".into(), Vec3(domain.sides))];
        let wrong = of_box.into_iter().chain(of_walls).chain(of_surfaces).find(|(_, vector)| bad(vector));
        wrong.map_or(Ok(()), |(quantity, _)| Err(self.not_a_number(quantity)))
    }

    /// The halt of a quantity that is not finite.
    pub fn not_a_number(&self, quantity: impl Into<String>) -> Halt {
        self.halt(Reason::NotANumber { quantity: quantity.into() })
    }

    /// The pair that overlaps most.
    pub fn largest_overlap(&self) -> Option<((u32, u32), f64)> {
        let id = &self.system.particles.id;
        self.pairs()
            .map(|pair| ((id[pair.i], id[pair.j]), -pair.contact.gap / (pair.contact.r_i + pair.contact.r_j)))
            .reduce(|most, pair| if pair.1 > most.1 { pair } else { most })
    }

    pub(super) fn overlapping(&self) -> Halt {
        let (pair, ratio) = self.largest_overlap().unwrap_or(((0, 0), f64::NAN));
        self.halt(Reason::Overlap { pair, ratio, limit: self.settings.max_overlap })
    }
}
