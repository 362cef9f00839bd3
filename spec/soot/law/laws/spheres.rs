//! A few spheres in motion, for the laws of the composed law.

use super::super::*;
use crate::mechanics::four_springs::Losses;
use crate::mechanics::primary_particle::solid_inertia;
use crate::mechanics::verlet::{half_step, half_step_start};

/// Solid spheres, of unit mass and radius unless they are given other radii, every pair with the same law.
pub(super) struct Spheres<const N: usize, S: Reading = Along> {
    pub law: Soot<S>,
    pub bonded: f64,
    pub radii: [f64; N],
    pub x: [Vec3<f64>; N],
    pub v: [Vec3<f64>; N],
    pub omega: [Vec3<f64>; N],
    pub springs: Vec<Memory<f64, S::Torsion<f64>>>,
    pub lost: f64,
}

/// Of a sphere of unit mass and radius.
pub(super) const INERTIA: f64 = 0.4;

impl<const N: usize, S: Reading> Spheres<N, S> {
    pub(super) fn new(law: Soot<S>, bonded: f64, x: [Vec3<f64>; N]) -> Self {
        let none = [Vec3::zero(); N];
        Self { law, bonded, radii: [1.0; N], x, v: none, omega: none, springs: vec![Memory::zero(); N * N], lost: 0.0 }
    }
    fn mass(&self, i: usize) -> f64 {
        self.radii[i].powi(3)
    }
    fn inertia(&self, i: usize) -> f64 {
        solid_inertia(self.mass(i), self.radii[i])
    }
    fn pairs() -> impl Iterator<Item = (usize, usize)> {
        (0..N).flat_map(|i| (0..i).map(move |j| (i, j)))
    }
    pub(super) fn contact(&self, i: usize, j: usize) -> Contact<f64> {
        Contact::new(
            self.x[i] - self.x[j],
            self.v[i] - self.v[j],
            self.omega[i],
            self.omega[j],
            self.radii[i],
            self.radii[j],
        )
    }
    pub(super) fn gap(&self) -> f64 {
        self.contact(1, 0).gap
    }
    /// Forces and torques, the springs advanced by `dt`.
    fn forces(&mut self, dt: f64) -> [(Vec3<f64>, Vec3<f64>); N] {
        let mut on = [(Vec3::zero(), Vec3::zero()); N];
        for (i, j) in Self::pairs() {
            let k = Coefficients { bonded: self.bonded };
            let SpringsOutcome { wrench, memory, losses } =
                self.law.pair(&self.contact(i, j), &k, self.springs[i * N + j], dt);
            self.springs[i * N + j] = memory;
            on[i] = (on[i].0 + wrench.force, on[i].1 + wrench.torque_i);
            on[j] = (on[j].0 - wrench.force, on[j].1 + wrench.torque_j);
            let Losses { normal, tangential, rolling, torsion, slip } = losses;
            self.lost += normal + tangential + rolling + torsion + slip;
        }
        on
    }
    /// Takes the velocities back by half a step.
    pub(super) fn start(&mut self, dt: f64) {
        let springs = self.springs.clone();
        for (i, (force, torque)) in self.forces(0.0).into_iter().enumerate() {
            let (m, inertia) = (self.mass(i), self.inertia(i));
            (self.v[i], self.omega[i]) = half_step_start(self.v[i], self.omega[i], force, torque, m, inertia, dt);
        }
        (self.springs, self.lost) = (springs, 0.0);
    }
    pub(super) fn step(&mut self, dt: f64) {
        assert_eq!(INERTIA, solid_inertia(1.0, 1.0));
        for (i, (force, torque)) in self.forces(dt).into_iter().enumerate() {
            let (m, inertia) = (self.mass(i), self.inertia(i));
            (self.v[i], self.x[i], self.omega[i]) =
                half_step(self.x[i], self.v[i], self.omega[i], force, torque, m, inertia, dt);
        }
    }
    /// Kinetic and stored energy; the former half a step behind.
    pub(super) fn energy(&self) -> f64 {
        let twice =
            |i: usize| self.mass(i) * self.v[i].dot(self.v[i]) + self.inertia(i) * self.omega[i].dot(self.omega[i]);
        let kinetic = (0..N).map(|i| 0.5 * twice(i));
        let stored = Self::pairs().map(|(i, j)| {
            let k = Coefficients { bonded: self.bonded };
            let s = self.law.stored(&self.contact(i, j), &k, &self.springs[i * N + j]);
            (0..7).map(|k| *s.at(k)).sum::<f64>()
        });
        kinetic.sum::<f64>() + stored.sum::<f64>()
    }
    pub(super) fn momentum(&self) -> Vec3<f64> {
        (0..N).fold(Vec3::zero(), |sum, i| sum + self.v[i] * self.mass(i))
    }
    pub(super) fn angular_momentum(&self) -> Vec3<f64> {
        (0..N).fold(Vec3::zero(), |sum, i| {
            sum + self.x[i].cross(self.v[i]) * self.mass(i) + self.omega[i] * self.inertia(i)
        })
    }
}
