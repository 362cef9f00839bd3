//! The state of a simulation: spheres in a periodic box, some of them forming rigid bodies or walls.

mod body;
mod domain;
mod history;
mod mesh;
mod sound;
mod steering;
mod surface;
mod wall;

pub use body::{Body, Pose};
pub use domain::{Domain, Image};
pub use history::{Bond, Springs};
pub use mesh::Mesh;
pub(crate) use mesh::{Leaf, Tree};
pub(crate) use sound::bounded;
pub use steering::Steering;
pub use surface::{ContactTable, Forces, PrescribedMotion, Shape, Surface};
pub use wall::{Motion, Wall};

use crate::spec::Vec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Smallest number of particles for which another thread pays.
const LEAST: usize = 4096;

/// The spheres. All vectors have the same length and are permuted together when the neighbour list is built, so a sphere
/// keeps its `id`, not its place. Units: nm, m/s, 1/ns, ag.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Particles {
    /// Centre, never folded back into the box: displacements need no bookkeeping.
    pub x: Vec<Vec3<f64>>,
    /// Velocity.
    pub v: Vec<Vec3<f64>>,
    /// Angular velocity.
    pub w: Vec<Vec3<f64>>,
    /// Radius.
    pub radius: Vec<f64>,
    /// Mass.
    pub mass: Vec<f64>,
    /// 0 for a free sphere, `k` for a member of `walls[k - 1]`.
    pub wall: Vec<u32>,
    /// 0 for a single sphere, `k` for a member of `bodies[k - 1]`.
    pub body: Vec<u32>,
    /// Position of a member in the frame of its body.
    pub arm: Vec<Vec3<f64>>,
    /// The persistent, unique id of the sphere.
    pub id: Vec<u32>,
    /// The body it belonged to at the beginning.
    pub tag: Vec<u32>,
}

impl Particles {
    /// Number of spheres.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// True when there is no sphere.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// The places of the spheres, by their ids.
    pub fn by_id(&self) -> Vec<usize> {
        let mut places: Vec<usize> = (0..self.len()).collect();
        places.sort_unstable_by_key(|&p| self.id[p]);
        places
    }

    /// Appends a free sphere at rest; its id is its place.
    pub fn push(&mut self, x: Vec3<f64>, radius: f64, mass: f64, tag: u32) {
        self.id.push(self.len() as u32);
        self.x.push(x);
        self.v.push(Vec3::zero());
        self.w.push(Vec3::zero());
        self.radius.push(radius);
        self.mass.push(mass);
        self.wall.push(0);
        self.body.push(0);
        self.arm.push(Vec3::zero());
        self.tag.push(tag);
    }

    /// The spheres at the given places, in that order.
    pub fn pick(&self, places: &[u32]) -> Self {
        fn at<T: Copy + Send + Sync>(values: &[T], places: &[u32]) -> Vec<T> {
            places.par_iter().with_min_len(LEAST).map(|&p| values[p as usize]).collect()
        }
        Self {
            x: at(&self.x, places),
            v: at(&self.v, places),
            w: at(&self.w, places),
            radius: at(&self.radius, places),
            mass: at(&self.mass, places),
            wall: at(&self.wall, places),
            body: at(&self.body, places),
            arm: at(&self.arm, places),
            id: at(&self.id, places),
            tag: at(&self.tag, places),
        }
    }
}

/// Spheres, box, walls, and where in time they are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct System {
    /// The spheres.
    pub particles: Particles,
    /// The box.
    pub domain: Domain,
    /// The rigid bodies.
    pub bodies: Vec<Body>,
    /// The rigid walls.
    pub walls: Vec<Wall>,
    /// The surfaces.
    pub surfaces: Vec<Surface>,
    /// The springs at centres of mass; for steps of [`HalfStep`](crate::simulation::Integrator::HalfStep).
    pub steerings: Vec<Steering>,
    /// Necks between spheres: ids, the lower first, in ascending order.
    pub necks: Vec<(u32, u32)>,
    /// Initial contact history of the next simulation; empty while a simulation is running.
    pub springs: Springs,
    /// Time by which the velocities of the spheres are behind their positions, ns; zero for velocities that are given.
    pub lag: f64,
    /// Simulated time, ns.
    pub time: f64,
    /// Steps taken.
    pub step: u64,
}

impl System {
    /// Spheres at rest in a box, at time zero.
    pub fn new(particles: Particles, domain: Domain) -> Self {
        Self {
            particles,
            domain,
            bodies: Vec::new(),
            walls: Vec::new(),
            surfaces: Vec::new(),
            steerings: Vec::new(),
            necks: Vec::new(),
            springs: Springs::default(),
            lag: 0.0,
            time: 0.0,
            step: 0,
        }
    }

    /// Makes the spheres that `member` picks into one rigid wall, whose mass is theirs. Bodies are picked whole.
    pub fn add_wall(&mut self, motion: [Motion; 3], member: impl Fn(&Particles, usize) -> bool) {
        let number = self.walls.len() as u32 + 1;
        let mut mass = 0.0;
        for i in 0..self.particles.len() {
            if member(&self.particles, i) {
                self.particles.wall[i] = number;
                mass += self.particles.mass[i];
            }
        }
        self.walls.push(Wall::new(motion, mass));
        let velocity = self.walls[number as usize - 1].velocity;
        for i in 0..self.particles.len() {
            if self.particles.wall[i] == number {
                self.particles.v[i] = velocity;
                self.particles.w[i] = Vec3::zero();
                if let Some(body) = (self.particles.body[i] as usize).checked_sub(1) {
                    let body = &mut self.bodies[body];
                    (body.wall, body.v, body.l) = (number, velocity, Vec3::zero());
                }
            }
        }
    }

    /// Sets all spheres free.
    pub fn remove_walls(&mut self) {
        self.walls.clear();
        self.particles.wall.fill(0);
        for body in &mut self.bodies {
            body.wall = 0;
        }
    }

    /// The place of the sphere with this id.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn place(&self, id: u32) -> usize {
        self.particles.id.iter().position(|&other| other == id).expect("a sphere of the system")
    }

    /// The place of every sphere, by id.
    pub fn places(&self) -> BTreeMap<u32, usize> {
        self.particles.id.iter().copied().zip(0..).collect()
    }
}

#[cfg(test)]
mod tests;
