//! Two equal spheres in motion, for the laws of the composed law.

use super::super::*;
use crate::mechanics::sphere::moment_of_inertia;
use crate::mechanics::symplectic_euler::symplectic_euler;
use crate::wear::def_contact::Losses;

/// Two equal spheres and their spring.
pub(super) struct Pair {
    pub law: Wear,
    pub r: f64,
    pub m: f64,
    pub x: [Vec3<f64>; 2],
    pub v: [Vec3<f64>; 2],
    pub omega: [Vec3<f64>; 2],
    pub spring: Vec3<f64>,
    pub lost: f64,
}

impl Pair {
    /// At rest along the first axis.
    pub(super) fn new(law: Wear, r: f64, m: f64, gap: f64) -> Self {
        let x = Vec3::new(r + 0.5 * gap, 0.0, 0.0);
        Self { law, r, m, x: [x, -x], v: [Vec3::zero(); 2], omega: [Vec3::zero(); 2], spring: Vec3::zero(), lost: 0.0 }
    }
    pub(super) fn contact(&self) -> Contact<f64> {
        let ([x_i, x_j], [v_i, v_j]) = (self.x, self.v);
        Contact::new(x_i - x_j, v_i - v_j, self.omega[0], self.omega[1], self.r, self.r)
    }
    pub(super) fn coefficients(&self) -> Parameters<f64> {
        self.law.coefficients(self.r, self.r, self.m, self.m)
    }
    pub(super) fn step(&mut self, dt: f64) {
        let outcome = self.law.pair(&self.contact(), &self.coefficients(), self.spring, dt);
        let (force, inertia) = (outcome.wrench.force, moment_of_inertia(self.m, self.r));
        let torques = [outcome.wrench.torque_i, outcome.wrench.torque_j];
        for (i, force) in [force, -force].into_iter().enumerate() {
            (self.v[i], self.x[i], self.omega[i]) =
                symplectic_euler(self.x[i], self.v[i], self.omega[i], force, torques[i], self.m, inertia, dt);
        }
        self.spring = outcome.memory;
        let Losses { normal_damping: normal, tangential_damping: tangential, slip } = outcome.losses;
        self.lost += normal + tangential + slip;
    }
    pub(super) fn energy(&self) -> f64 {
        let stored = self.law.stored(&self.contact(), &self.coefficients(), &self.spring);
        let inertia = moment_of_inertia(self.m, self.r);
        let kinetic: f64 = (0..2)
            .map(|i| 0.5 * self.m * self.v[i].dot(self.v[i]) + 0.5 * inertia * self.omega[i].dot(self.omega[i]))
            .sum();
        kinetic + stored.normal + stored.tangential
    }
    pub(super) fn angular_momentum(&self) -> Vec3<f64> {
        let inertia = moment_of_inertia(self.m, self.r);
        let of = |i: usize| self.x[i].cross(self.v[i]) * self.m + self.omega[i] * inertia;
        of(0) + of(1)
    }
}
