//! The spheres of a block: gather of forces, and one time step.

use crate::forces::{Block, Instructions, Load};
use crate::spec::mechanics::box_stress::momentum_flux;
use crate::spec::mechanics::drag::global_damping;
use crate::spec::mechanics::kick_and_drift::drift;
use crate::spec::mechanics::kinetic_energy::kinetic_energy;
use crate::spec::mechanics::sphere::moment_of_inertia;
use crate::spec::mechanics::symplectic_euler::symplectic_euler;
use crate::spec::mechanics::work::drag_loss;
use crate::spec::{PairModel, Vec3};
use crate::system::{Particles, Wall};
use std::borrow::Cow;

/// Moment of inertia of a sphere, ag nm^2.
pub fn inertia(particles: &Particles, p: usize) -> f64 {
    moment_of_inertia(particles.mass[p], particles.radius[p])
}

/// The state of the spheres of a block that are by themselves, and where they were when the neighbour list was built.
pub struct Spheres<'a> {
    /// Centres.
    pub x: &'a mut [Vec3<f64>],
    /// Velocities.
    pub v: &'a mut [Vec3<f64>],
    /// Angular velocities.
    pub w: &'a mut [Vec3<f64>],
    /// Radii.
    pub radius: &'a [f64],
    /// Masses.
    pub mass: &'a [f64],
    /// Walls they belong to.
    pub wall: &'a [u32],
    /// Centres when the neighbour list was built.
    pub listed: &'a [Vec3<f64>],
}

impl<'a> Spheres<'a> {
    /// The first `count` spheres, and the rest.
    pub fn split(self, count: usize) -> (Self, Self) {
        let (x, other_x) = self.x.split_at_mut(count);
        let (v, other_v) = self.v.split_at_mut(count);
        let (w, other_w) = self.w.split_at_mut(count);
        let (radius, other_radius) = self.radius.split_at(count);
        let (mass, other_mass) = self.mass.split_at(count);
        let (wall, other_wall) = self.wall.split_at(count);
        let (listed, other_listed) = self.listed.split_at(count);
        let rest = Self {
            x: other_x,
            v: other_v,
            w: other_w,
            radius: other_radius,
            mass: other_mass,
            wall: other_wall,
            listed: other_listed,
        };
        (Self { x, v, w, radius, mass, wall, listed }, rest)
    }
}

/// The parameters of a step, common to all spheres.
pub struct Step<'a> {
    /// Time step, ns.
    pub dt: f64,
    /// Coefficient of the global damping, ag/ns.
    pub damping: f64,
    /// The walls, already driven.
    pub walls: &'a [Wall],
    /// Factors by which the box grows.
    pub growth: [f64; 3],
    /// Factors by which it will have grown since the neighbour list was built.
    pub stretch: [f64; 3],
    /// Vector instructions in use.
    pub instructions: Instructions,
}

/// Sums over the spheres of a block in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionTotals {
    /// Kinetic energy after the step, zJ.
    pub kinetic: f64,
    /// Diagonal of the sum of `m v v` after the step, zJ.
    pub momentum_flux: [f64; 3],
    /// Energy lost to the global damping, zJ.
    pub drag: f64,
    /// What the integration scheme adds to the kinetic energy: `dt^2 (F^2 / m + T^2 / I) / 2`.
    pub scheme: f64,
    /// Least displacement since the neighbour list was built, by axis.
    pub least: [f64; 3],
    /// Largest displacement since the neighbour list was built, by axis.
    pub most: [f64; 3],
}

impl Default for MotionTotals {
    fn default() -> Self {
        Self {
            kinetic: 0.0,
            momentum_flux: [0.0; 3],
            drag: 0.0,
            scheme: 0.0,
            least: [f64::INFINITY; 3],
            most: [f64::NEG_INFINITY; 3],
        }
    }
}

impl MotionTotals {
    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            momentum_flux: std::array::from_fn(|a| self.momentum_flux[a] + other.momentum_flux[a]),
            drag: self.drag + other.drag,
            scheme: self.scheme + other.scheme,
            least: std::array::from_fn(|a| self.least[a].min(other.least[a])),
            most: std::array::from_fn(|a| self.most[a].max(other.most[a])),
        }
    }

    /// Adds the momentum flux of a mass.
    pub fn add_momentum_flux(&mut self, m: f64, v: Vec3<f64>) {
        for (sum, flux) in self.momentum_flux.iter_mut().zip(momentum_flux(m, v).0) {
            *sum += flux;
        }
    }

    /// Enters the displacement of a sphere since the neighbour list was built.
    pub fn stray(&mut self, way: Vec3<f64>) {
        for (a, way) in way.0.into_iter().enumerate() {
            self.least[a] = if way < self.least[a] { way } else { self.least[a] };
            self.most[a] = if way > self.most[a] { way } else { self.most[a] };
        }
    }

    /// No two spheres have come closer than this since the neighbour list was built, nm.
    pub fn approach(&self) -> f64 {
        let range = Vec3(std::array::from_fn(|a| self.most[a] - self.least[a])).norm();
        let farthest = Vec3(std::array::from_fn(|a| self.most[a].abs().max(self.least[a].abs()))).norm();
        range.min(2.0 * farthest)
    }
}

/// The loads on the first spheres of a block: its own, and those from the halos of other blocks.
pub fn gathered<M: PairModel>(blocks: &[Block<M>], number: usize, count: usize) -> Cow<'_, [Load]> {
    let block = &blocks[number];
    let own = &block.loads[..count];
    if block.incoming.is_empty() {
        return Cow::Borrowed(own);
    }
    let mut loads = own.to_vec();
    for &(to, from, place) in block.incoming.iter().take_while(|entry| (entry.0 as usize) < count) {
        let sum = &mut loads[to as usize];
        *sum = *sum + blocks[from as usize].loads[place as usize];
    }
    Cow::Owned(loads)
}

/// Moves the first spheres of a block by one step of Eq. 1.
pub fn advance<M: PairModel>(blocks: &[Block<M>], number: usize, spheres: Spheres, step: &Step) -> MotionTotals {
    let Step { dt, damping, .. } = *step;
    let loads = gathered(blocks, number, spheres.x.len());
    let mut moved = MotionTotals::default();
    for (p, load) in loads.iter().enumerate() {
        let (m, x, v, w) = (spheres.mass[p], spheres.x[p], spheres.v[p], spheres.w[p]);
        let (x, v, w) = if spheres.wall[p] == 0 {
            let i = moment_of_inertia(m, spheres.radius[p]);
            let [fx, fy, fz, tx, ty, tz, ..] = load.0;
            let (force, torque) = (Vec3([fx, fy, fz]) + global_damping(damping, v), Vec3([tx, ty, tz]));
            let (after, x, spin) = symplectic_euler(x, v, w, force, torque, m, i, dt);
            moved.kinetic += kinetic_energy(m, after, i, spin);
            moved.drag += drag_loss(damping, v, dt);
            moved.scheme += kinetic_energy(m, after - v, i, spin - w);
            moved.add_momentum_flux(m, after);
            (x, after, spin)
        } else {
            let Wall { velocity, spin, .. } = step.walls[spheres.wall[p] as usize - 1];
            (drift(x, velocity, dt), velocity, spin)
        };
        let x = Vec3(std::array::from_fn(|a| x.0[a] * step.growth[a]));
        let listed = Vec3(std::array::from_fn(|a| spheres.listed[p].0[a] * step.stretch[a]));
        moved.stray(x - listed);
        (spheres.x[p], spheres.v[p], spheres.w[p]) = (x, v, w);
    }
    moved
}
