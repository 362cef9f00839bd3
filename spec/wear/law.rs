//! The contact law, composed from its equations, for an engine.

use super::def_contact::{Losses, Parameters};
use super::def_parameters::force_parameters;
use super::def_potential::potential;
use super::eq06_critical_time_step::critical_time_step;
use super::eq17_effective_mass::effective_mass;
use crate::mechanics::projected_spring::spring_energy;
use crate::mechanics::sphere::sliding_mass;
use crate::mechanics::stable_step::stable_time_step;
use crate::{Carried, Contact, Outcome, PairModel, Real, Turns, Vec3, flat_struct};

/// The material to be matched: Table 3 of the paper, and the scaling parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus $E$, Pa.
    pub young_modulus: f64,
    /// Poisson's ratio $\nu$, at most 1/4.
    pub poisson_ratio: f64,
    /// Tensile strength $\sigma_{m,N}$, Pa.
    pub tensile_strength: f64,
    /// Shear strength $\sigma_{m,T}$, Pa.
    pub shear_strength: f64,
    /// Surface energy $\gamma$, J/m².
    pub surface_energy: f64,
    /// Restitution coefficient $\eta$.
    pub restitution: f64,
    /// Scaling parameter $s$: how the strength falls with the size of particles beyond the critical diameter.
    pub scaling: f64,
    /// Follows the authors' published program, in which a pair that does not touch loses its tangential spring whenever the neighbour
    /// list is rebuilt: results then depend on the frequency of rebuilds.
    pub forget_stretched_springs: bool,
}

/// The active forces: all of them, or the forces of one phase of the relaxation (Section 3.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interaction {
    /// Only normal repulsion: the first phase.
    Repulsive,
    /// Normal repulsion and cohesion: the second phase.
    Normal,
    /// All forces.
    Full,
}

flat_struct! {
    /// Energy stored in a pair, J.
    pub struct Stored {
        /// Potential of the force along the normal.
        pub normal,
        /// Spring in the contact plane.
        pub tangential,
    }
}

/// The contact law of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wear {
    /// The material to be matched.
    pub material: Material,
    /// Which forces act.
    pub interaction: Interaction,
}

impl PairModel for Wear {
    type Coefficients<R: Real> = Parameters<R>;
    type Memory<R: Real> = Vec3<R>;
    type Losses<R: Real> = Losses<R>;
    type Stored<R: Real> = Stored<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Parameters<R> {
        let zero = R::zero();
        let material = &self.material;
        let (k_n, k_t, delta_e, delta_f, f_mt, c_n, c_t) = force_parameters(
            R::lit(material.young_modulus),
            R::lit(material.poisson_ratio),
            R::lit(material.tensile_strength),
            R::lit(material.shear_strength),
            R::lit(material.surface_energy),
            R::lit(material.restitution),
            R::lit(material.scaling),
            r_i,
            r_j,
            m_i,
            m_j,
        );
        let full = Parameters { k_n, k_t, delta_e, delta_f, f_mt, c_n, c_t };
        let normal = Parameters { k_t: zero, f_mt: zero, c_t: zero, ..full };
        match self.interaction {
            Interaction::Repulsive => Parameters { delta_e: zero, delta_f: zero, ..normal },
            Interaction::Normal => normal,
            Interaction::Full => full,
        }
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        // The fracture separation does not depend on the masses.
        r_i + r_j + self.coefficients(r_i, r_j, 1.0, 1.0).delta_f
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Parameters<R>,
        spring: Vec3<R>,
        dt: R,
    ) -> Outcome<R, Vec3<R>, Losses<R>> {
        k.act(c, spring, dt)
    }

    fn relisted<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: Vec3<R>) -> (Vec3<R>, Losses<R>) {
        let forgotten = self.material.forget_stretched_springs;
        let kept = if forgotten { Vec3::select(c.gap.gt(R::zero()), Vec3::zero(), spring) } else { spring };
        let slip = spring_energy(k.k_t, spring) - spring_energy(k.k_t, kept);
        (kept, Losses { normal_damping: R::zero(), tangential_damping: R::zero(), slip })
    }

    #[inline(always)]
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: &Vec3<R>) -> Stored<R> {
        Stored { normal: potential(k.k_n, k.delta_e, k.delta_f, c.gap), tangential: spring_energy(k.k_t, *spring) }
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        let k = self.coefficients(r, r, m, m);
        let m_eff = effective_mass(m, m);
        critical_time_step(m, k.k_n).min(stable_time_step(m_eff, k.k_n, k.c_n)).min(stable_time_step(
            sliding_mass(m_eff),
            k.k_t,
            k.c_t,
        ))
    }
}

impl Turns for Wear {
    #[inline(always)]
    fn turned<R: Real>(spring: Vec3<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Vec3<R> {
        turn(spring)
    }
}

impl From<Wear> for Carried<Wear> {
    fn from(law: Wear) -> Self {
        Self(law)
    }
}

#[cfg(test)]
mod laws;
