//! The contact law, composed of its equations: what an engine runs.

use super::def_potential::potential;
use super::def_sphere::sliding_mass;
use super::def_stable_step::stable_time_step;
use super::eq02_pair_force::{normal_part, tangential_part};
use super::eq03_normal_force::normal_force;
use super::eq04_tangential_force::kept_fraction;
use super::eq05_rescaled_maximum::rescaled_maximum;
use super::eq06_critical_time_step::critical_time_step;
use super::eq07_normal_stiffness::normal_stiffness;
use super::eq08_tangential_stiffness::tangential_stiffness;
use super::eq09_elastic_separation::elastic_separation;
use super::eq10_fracture_separation::fracture_separation;
use super::eq11_maximum_tangential_force::maximum_tangential_force;
use super::eq12_normal_damping::normal_damping;
use super::eq13_tangential_damping::tangential_damping;
use super::eq14_effective_radius::effective_radius;
use super::eq15_normal_cross_section::normal_cross_section;
use super::eq16_tangential_cross_section::tangential_cross_section;
use super::eq17_effective_mass::effective_mass;
use super::eq18_critical_diameter::critical_diameter;
use crate::{Contact, Losses, Outcome, PairModel, Real, Stored, Vec3, Wrench, flat_struct};

/// The material to be matched: Table 3 of the paper, and the scaling parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<R> {
    /// Young's modulus $E$, Pa.
    pub young_modulus: R,
    /// Poisson's ratio $\nu$, at most 1/4.
    pub poisson_ratio: R,
    /// Tensile strength $\sigma_{m,N}$, Pa.
    pub tensile_strength: R,
    /// Shear strength $\sigma_{m,T}$, Pa.
    pub shear_strength: R,
    /// Surface energy $\gamma$, J/m².
    pub surface_energy: R,
    /// Restitution coefficient $\eta$.
    pub restitution: R,
    /// Scaling parameter $s$: how the strength falls with the size of particles beyond the critical diameter.
    pub scaling: R,
}

impl Material<f64> {
    fn lift<R: Real>(&self) -> Material<R> {
        Material {
            young_modulus: R::lit(self.young_modulus),
            poisson_ratio: R::lit(self.poisson_ratio),
            tensile_strength: R::lit(self.tensile_strength),
            shear_strength: R::lit(self.shear_strength),
            surface_energy: R::lit(self.surface_energy),
            restitution: R::lit(self.restitution),
            scaling: R::lit(self.scaling),
        }
    }
}

flat_struct! {
    /// The force parameters of a pair: Table 2 of the paper.
    pub struct Parameters {
        /// Normal stiffness, N/m.
        pub k_n,
        /// Tangential stiffness, N/m.
        pub k_t,
        /// Elastic separation, m.
        pub delta_e,
        /// Fracture separation, m.
        pub delta_f,
        /// Largest tangential force in contact, N.
        pub f_mt,
        /// Normal damping factor, kg/s.
        pub c_n,
        /// Tangential damping factor, kg/s.
        pub c_t,
    }
}

impl<R: Real> Parameters<R> {
    /// Eqs. 7 to 18: the force parameters that match a material for a pair of given radii and masses.
    pub fn matching(material: &Material<R>, r_i: R, r_j: R, m_i: R, m_j: R) -> Self {
        let Material { young_modulus: e, poisson_ratio: nu, tensile_strength: sigma_mn, surface_energy: gamma, .. } =
            *material;
        let (r_eff, m_eff) = (effective_radius(r_i, r_j), effective_mass(m_i, m_j));
        let (a_n, a_t) = (normal_cross_section(r_eff, nu), tangential_cross_section(r_eff, nu));
        let (k_n, k_t) = (normal_stiffness(a_n, e, r_i, r_j), tangential_stiffness(a_t, e, r_i, r_j));
        let delta_e = elastic_separation(r_i, r_j, sigma_mn, e);
        let d_c = critical_diameter(gamma, e, sigma_mn);
        Self {
            k_n,
            k_t,
            delta_e,
            delta_f: fracture_separation(gamma, sigma_mn, r_i, r_j, d_c, delta_e, material.scaling),
            f_mt: maximum_tangential_force(a_t, material.shear_strength),
            c_n: normal_damping(material.restitution, k_n, m_eff),
            c_t: tangential_damping(material.restitution, k_t, m_eff),
        }
    }

    /// The force and torques of a contact (Eqs. 2 to 5), its spring advanced by `dt`.
    ///
    /// The spring is a vector in the contact plane. It follows the plane by projection, grows with the sliding velocity and slips
    /// where its force would exceed the cap. The contact point lies half way between the surfaces, so that the arms of the torques
    /// add up to the distance of the centres and angular momentum is conserved. Beyond the fracture separation all is zero.
    #[inline(always)]
    pub fn act(&self, c: &Contact<R>, spring: Vec3<R>, dt: R) -> Outcome<R, Vec3<R>> {
        let zero = R::zero();
        let in_range = c.gap.le(self.delta_f);
        let half_gap = R::lit(0.5) * c.gap;
        let (arm_i, arm_j) = (c.r_i + half_gap, c.r_j + half_gap);
        let v_n = R::select(in_range, c.normal_velocity(), zero);
        let v_t = Vec3::select(in_range, c.sliding_velocity(arm_i, arm_j), Vec3::zero());

        let stretched = spring.perpendicular_to(c.n) + v_t * dt;
        let stretched_squared = stretched.dot(stretched);
        let cap = rescaled_maximum(c.gap, self.delta_f, self.f_mt);
        let kept = kept_fraction(self.k_t, stretched_squared.sqrt(), cap);
        let spring = Vec3::select(in_range, stretched * kept, Vec3::zero());

        let f_n = normal_force(self.k_n, self.delta_e, self.delta_f, c.gap);
        let f_t = tangential_part(spring * self.k_t, self.c_t, v_t);
        let turn = f_t.cross(c.n);
        Outcome {
            wrench: Wrench {
                force: normal_part(f_n, self.c_n, v_n, c.n) + f_t,
                torque_i: turn * arm_i,
                torque_j: turn * arm_j,
            },
            memory: spring,
            losses: Losses {
                normal: self.c_n * v_n.squared() * dt,
                tangential: self.c_t * v_t.dot(v_t) * dt,
                slip: spring_energy(self.k_t, stretched_squared) - spring_energy(self.k_t, spring.dot(spring)),
            },
        }
    }
}

/// Energy of the tangential spring, J.
#[inline(always)]
fn spring_energy<R: Real>(k_t: R, length_squared: R) -> R {
    R::lit(0.5) * k_t * length_squared
}

/// Which forces act: all of them, or those of a phase of the relaxation (Section 3.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interaction {
    /// Normal repulsion alone: the first phase.
    Repulsive,
    /// Normal repulsion and cohesion: the second phase.
    Normal,
    /// Everything.
    Full,
}

/// The contact law of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wear {
    /// The material to be matched.
    pub material: Material<f64>,
    /// Which forces act.
    pub interaction: Interaction,
}

impl PairModel for Wear {
    type Coefficients<R: Real> = Parameters<R>;
    type Memory<R: Real> = Vec3<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Parameters<R> {
        let zero = R::zero();
        let full = Parameters::matching(&self.material.lift(), r_i, r_j, m_i, m_j);
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
    fn pair<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: Vec3<R>, dt: R) -> Outcome<R, Vec3<R>> {
        k.act(c, spring, dt)
    }

    #[inline(always)]
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: &Vec3<R>) -> Stored<R> {
        Stored {
            normal: potential(k.k_n, k.delta_e, k.delta_f, c.gap),
            tangential: spring_energy(k.k_t, spring.dot(*spring)),
        }
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
