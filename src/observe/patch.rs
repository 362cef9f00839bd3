//! Tests between two walls: strain and stress of the sample between them, and the elastic constants.

use super::strain::displacement_gradient;
use super::stress::{Slab, stress};
use super::{Link, upper_wall};
use crate::spec::wear::def_elastic_constants::elastic_moduli;
use crate::spec::{Tensor, Vec3};
use crate::system::System;
use serde::{Deserialize, Serialize};

/// Observes the deformable part of a sample between two walls.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Gauge {
    slab: Slab,
    upper: Vec3<f64>,
    /// Initial positions of all spheres, in the order of ids.
    before: Vec<Vec3<f64>>,
    /// Stress at the beginning.
    rest: Tensor<f64>,
}

/// A reading of a gauge.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Displacement of the upper wall over the height between the walls.
    pub strain: Vec3<f64>,
    /// Mean virial stress between the walls, MPa, tension positive.
    pub stress: Tensor<f64>,
}

impl Gauge {
    /// Sets the gauge to zero.
    pub fn new(system: &System, links: &[Link], thickness: f64) -> Self {
        let slab = Slab { low: thickness, high: system.domain.sides[1] - thickness };
        let mut before = vec![Vec3::zero(); system.particles.len()];
        for (&id, &x) in system.particles.id.iter().zip(&system.particles.x) {
            before[id as usize] = x;
        }
        Self { slab, upper: upper_wall(system), before, rest: stress(system, links, slab) }
    }

    /// Number of spheres that it observes.
    pub fn spheres(&self) -> usize {
        self.before.len()
    }

    /// Strain of the sample as a whole and mean stress in it.
    pub fn read(&self, system: &System, links: &[Link]) -> Reading {
        let moved = upper_wall(system) - self.upper;
        let slab = Slab { high: self.slab.high + moved.0[1], ..self.slab };
        Reading { strain: moved * (1.0 / (self.slab.high - self.slab.low)), stress: stress(system, links, slab) }
    }

    /// Young's modulus and Poisson's ratio from a small confined compression along y: the stress that came with the load over the strain
    /// fitted to the displacements of the spheres between the walls.
    pub fn elasticity(&self, system: &System, links: &[Link]) -> Option<Elasticity> {
        let p = &system.particles;
        // Next to a rigid wall the deformation is not homogeneous: spheres nearer to one than it is thick are left out.
        let margin = self.slab.low;
        let inner = self.slab.low + margin..self.slab.high - margin;
        let free: Vec<usize> = (0..p.len()).filter(|&i| inner.contains(&self.before[p.id[i] as usize].0[1])).collect();
        let before: Vec<_> = free.iter().map(|&i| self.before[p.id[i] as usize]).collect();
        let after: Vec<_> = free.iter().map(|&i| p.x[i]).collect();
        let strain = displacement_gradient(&before, &after)?[1].0[1];
        let stress = self.read(system, links).stress;
        let risen = |a: usize| stress[a].0[a] - self.rest[a].0[a];
        let (c_11, c_12) = (risen(1) / strain, risen(0) / strain);
        let (poisson_ratio, young_modulus) = elastic_moduli(c_11, c_12);
        Some(Elasticity { young_modulus, poisson_ratio, c_11, c_12, strain })
    }
}

/// The elastic constants from a confined compression.
#[derive(Clone, Copy, Debug)]
pub struct Elasticity {
    /// Young's modulus, MPa.
    pub young_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Stiffness along the load, MPa.
    pub c_11: f64,
    /// Stiffness across, along x, MPa.
    pub c_12: f64,
    /// Strain along the load; negative.
    pub strain: f64,
}
