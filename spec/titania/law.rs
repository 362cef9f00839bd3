//! The contact law, composed from its equations, for an engine.

use super::attraction::{Attracted, Attraction, Meniscus};
use super::def_radius::{effective_radius, radii};
use super::def_water::{kelvin, surface_tension, water_layer};
use super::eq01_total_force::total_force;
use super::eq02_torque::{Arms, contact_torques};
use super::eq03_attraction::Solvation;
use super::eq05_amplitude::amplitude;
use super::eq06_normal_damping::dashpot;
use super::eq07_damping_coefficient::{DampingRadius, GAMMA_0, damping_coefficient};
use super::eq08_repulsion::hertz;
use super::eq09_stiffness::{Stiffness, mixed_stiffness, stiffness};
use super::eq11_contact_area::section;
use super::eq12_sliding::{Slip, sliding_spring, spring_energy};
use super::eq13_rolling::{Rolling, RollingOver, rolling_share, rolling_torque};
use super::table::Table;
use crate::mechanics::projected_spring::stretched_spring;
use crate::mechanics::reduced_mass::effective_mass;
use crate::mechanics::sphere::moment_of_inertia;
use crate::mechanics::stable_step::stable_time_step;
use crate::{Contact, Outcome, PairModel, Real, Turns, Vec3, Wrench, flat_struct};

/// The liquid that wets the particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Liquid {
    /// Water: its layer and surface tension follow the humidity, and the size of the particles.
    Water {
        /// Surface tension relative to the tables of TIP3P water.
        scale: f64,
    },
    /// Another liquid, with both given.
    Other {
        /// Surface tension, N/m.
        gamma: f64,
        /// Thickness of the layer, m.
        h_w: f64,
    },
}

/// The contact law and its parameters. The radius of a particle is that of its contact sphere, $R + h_n$.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Titania {
    /// Distance $\Delta$ of the bare surfaces at equilibrium, m.
    pub core_gap: f64,
    /// Thickness $h_n$ of the compressed water layer, m.
    pub h_n: f64,
    /// Relative humidity.
    pub humidity: f64,
    /// Thermal energy $k_B T$ per volume of a molecule of the liquid, Pa.
    pub thermal_pressure: f64,
    /// Contact angle $\theta$ of the meniscus, rad.
    pub contact_angle: f64,
    /// The liquid of the layer and the menisci.
    pub liquid: Liquid,
    /// The profile of a meniscus.
    pub meniscus: Meniscus,
    /// A nanometre in the caller's units.
    pub nanometre: f64,
    /// A newton per metre in the caller's units.
    pub newton_per_metre: f64,
    /// Sign convention of the solvation force.
    pub solvation: Solvation,
    /// Solvation amplitude of vanishing particles, N.
    pub f_00: f64,
    /// Growth of the solvation amplitude with the effective radius, N/m.
    pub f_01: f64,
    /// Period and decay length $\sigma_{solv}$ of the solvation force, m.
    pub sigma: f64,
    /// Damping constant $\gamma_0$ of Eq. 7, N s/m³.
    pub gamma_0: f64,
    /// Shear strength $\tau_S$ of sliding, Pa.
    pub tau_s: f64,
    /// Shear strength $\tau_R$ of rolling, Pa.
    pub tau_r: f64,
    /// Period $\lambda_t$ of stick and slip, m.
    pub lambda_t: f64,
    /// The tangential spring after a slip.
    pub slip: Slip,
    /// The equilibrium from which the contact stiffness of a pair is derived.
    pub stiffness: Stiffness,
    /// Position of the contact point of a pair.
    pub arms: Arms,
    /// Rolling resistance of a particle that hardly rolls.
    pub rolling: Rolling,
    /// The angular velocity over which the rolling torque is spread.
    pub rolling_over: RollingOver,
    /// The radii that count for the damping.
    pub damping_radius: DampingRadius,
}

flat_struct! {
    /// Constants of a pair while its particles are neighbours.
    pub struct Parameters {
        /// Contact stiffness, Pa.
        pub k_n,
        /// Half the effective radius of the contact spheres, m.
        pub r_eff,
        /// Damping coefficient, kg/s.
        pub gamma_n,
        /// Reduced moment of inertia of the two bodies, kg m²: the inertia that may be stopped in a step.
        pub inertia,
    }
}

flat_struct! {
    /// Energy that a pair dissipates in one time step, J, by cause.
    pub struct Lost {
        /// Dashpot along the normal.
        pub normal,
        /// Tangential springs that slipped.
        pub sliding,
        /// Rolling resistance.
        pub rolling,
        /// Tangential springs whose contact area decreased, negative where it increased: their stiffness follows the area without a
        /// corresponding force.
        pub contact_area,
    }
}

flat_struct! {
    /// Energy stored in a pair, J, by cause.
    pub struct Held {
        /// Compressed layers.
        pub repulsion,
        /// Meniscus and solvation, zero for particles far apart.
        pub attraction,
        /// Tangential spring.
        pub tangential,
    }
}

/// The constants of a pair with its attraction, for an engine that solves for the meniscus instead of tabulating it.
pub type Coefficients<R> = (Parameters<R>, Attracted<R>);

impl Titania {
    /// The parameters of the paper, at half humidity and 300 K, in units in which a nanometre, a nanonewton and a nanosecond have these values.
    pub fn paper(nanometre: f64, nanonewton: f64, nanosecond: f64) -> Self {
        let newton_per_metre = nanonewton / nanometre;
        let gigapascal = newton_per_metre / nanometre;
        Self {
            core_gap: 0.57 * nanometre,
            h_n: 0.36 * nanometre,
            humidity: 0.5,
            thermal_pressure: Self::thermal_pressure_of_water(300.0) * 1e-9 * gigapascal,
            contact_angle: 0.0,
            liquid: Liquid::Water { scale: 0.072 / 0.04729279 },
            meniscus: Meniscus::Circular,
            nanometre,
            newton_per_metre,
            solvation: Solvation::Israelachvili,
            f_00: -11.0 * nanonewton,
            f_01: -2.4 * newton_per_metre,
            sigma: 0.21 * nanometre,
            gamma_0: GAMMA_0.0 * 1e-9 * gigapascal * nanosecond / nanometre,
            tau_s: 0.65 * gigapascal,
            tau_r: 0.25 * gigapascal,
            lambda_t: 0.5 * nanometre,
            slip: Slip::Reset,
            stiffness: Stiffness::PerPair,
            arms: Arms::HalfGap,
            rolling: Rolling::Stopping,
            rolling_over: RollingOver::Rolling,
            damping_radius: DampingRadius::Bare,
        }
    }

    /// Gas constant times temperature (K) over the molar volume of water, Pa.
    pub fn thermal_pressure_of_water(temperature: f64) -> f64 {
        8.314462175 * temperature / 1.8047731e-5
    }

    /// Radius of the contact sphere of a particle of a nominal diameter.
    pub fn contact_radius<R: Real>(&self, d_nom: R) -> R {
        radii(d_nom, R::lit(self.core_gap), R::lit(self.h_n)).2
    }

    /// Bare radius of a particle.
    fn core<R: Real>(&self, r: R) -> R {
        r - R::lit(self.h_n)
    }

    /// The attraction between two particles.
    pub fn attraction<R: Real>(&self, r_i: R, r_j: R) -> Attraction<R> {
        let (core_i, core_j, one, rh) = (self.core(r_i), self.core(r_j), R::one(), R::lit(self.humidity));
        let (nanometre, sigma) = (R::lit(self.nanometre), R::lit(self.sigma));
        let d_core = R::lit(2.0) * core_i.min(core_j);
        let (gamma, h_w) = match self.liquid {
            Liquid::Water { scale } => {
                let gamma = surface_tension(d_core, rh, R::lit(scale), nanometre, R::lit(self.newton_per_metre));
                (gamma, water_layer(rh, nanometre))
            }
            Liquid::Other { gamma, h_w } => (R::lit(gamma), R::lit(h_w)),
        };
        let r_k = kelvin(gamma, R::lit(self.thermal_pressure), one, rh).1;
        let printed = amplitude(effective_radius(core_i, core_j).0, R::lit(self.f_00), R::lit(self.f_01));
        let (f_0, least) = match self.solvation {
            Solvation::Printed => (printed, -(core_i + core_j)),
            Solvation::Israelachvili => (-printed, R::lit(0.25) * sigma),
        };
        let theta = R::lit(self.contact_angle);
        Attraction::new(self.meniscus, core_i, core_j, h_w, gamma, r_k, theta, f_0, sigma, least)
    }

    /// The attraction between two particles as a table with an error of at most `tolerance`.
    pub fn table(&self, r_i: f64, r_j: f64, tolerance: f64) -> Table {
        let attraction = self.attraction(r_i, r_j);
        let start = attraction.kink().max(attraction.pair.cores);
        let slope = attraction.slope(start * (1.0 - 1e-12));
        Table::new(|u| attraction.rooted(u), start, attraction.rupture(), slope, tolerance)
    }

    /// Distance of the centres of two particles at rest.
    pub fn equilibrium<R: Real>(&self, r_i: R, r_j: R) -> R {
        self.core(r_i) + self.core(r_j) + R::lit(self.core_gap)
    }

    /// Area over which two particles touch.
    #[inline(always)]
    pub fn area<R: Real>(c: &Contact<R>) -> R {
        let outer = -c.gap * (c.r_i + c.r_j + c.distance);
        section(c.r_i, c.r_j, outer, c.distance.squared(), c.inverse.squared())
    }

    /// The constants of the contact of a pair of given radii (m) and masses (kg).
    pub fn parameters<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Parameters<R> {
        self.parameters_with(self.stiffness(r_i, r_j), r_i, r_j, m_i, m_j)
    }

    /// Contact stiffness of two particles, Pa.
    pub(super) fn stiffness<R: Real>(&self, r_i: R, r_j: R) -> R {
        match self.stiffness {
            Stiffness::PerPair => self.balanced_stiffness(r_i, r_j),
            Stiffness::PerSize => mixed_stiffness(self.balanced_stiffness(r_i, r_i), self.balanced_stiffness(r_j, r_j)),
        }
    }

    fn balanced_stiffness<R: Real>(&self, r_i: R, r_j: R) -> R {
        let (core_i, core_j, d) = (self.core(r_i), self.core(r_j), self.equilibrium(r_i, r_j));
        stiffness(self.attraction(r_i, r_j).force(d), r_i + r_j - d, core_i, core_j, R::lit(self.h_n))
    }

    /// The reduced moment of inertia whose rolling must not be reversed in a step.
    pub(super) fn stoppable<R: Real>(&self, inertia: R) -> R {
        match self.rolling {
            Rolling::Stopping => inertia,
            Rolling::Unlimited => R::lit(f64::INFINITY),
        }
    }

    /// The constants of the contact of a pair of known stiffness.
    pub(super) fn parameters_with<R: Real>(&self, k_n: R, r_i: R, r_j: R, m_i: R, m_j: R) -> Parameters<R> {
        let (damped_i, damped_j) = match self.damping_radius {
            DampingRadius::Bare => (self.core(r_i), self.core(r_j)),
            DampingRadius::Contact => (r_i, r_j),
        };
        let gamma_n = damping_coefficient(effective_radius(damped_i, damped_j).0, R::lit(self.gamma_0));
        Parameters {
            k_n,
            r_eff: effective_radius(r_i, r_j).1,
            gamma_n,
            inertia: self.stoppable(effective_mass(moment_of_inertia(m_i, r_i), moment_of_inertia(m_j, r_j))),
        }
    }
}

impl PairModel for Titania {
    type Coefficients<R: Real> = Coefficients<R>;
    type Memory<R: Real> = Vec3<R>;
    type Losses<R: Real> = Lost<R>;
    type Stored<R: Real> = Held<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Coefficients<R> {
        (self.parameters(r_i, r_j, m_i, m_j), self.attraction(r_i, r_j).pair)
    }

    const FRICTION_STOPS: bool = true;

    fn turning<R: Real>(&self, (contact, attraction): Coefficients<R>, inertia: R) -> Coefficients<R> {
        (Parameters { inertia: self.stoppable(inertia), ..contact }, attraction)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.attraction(r_i, r_j).rupture().max(r_i + r_j)
    }

    fn pair<R: Real>(&self, c: &Contact<R>, (contact, pair): &Coefficients<R>, spring: Vec3<R>, dt: R) -> Act<R> {
        let attraction = Attraction { meniscus: self.meniscus, pair: *pair };
        self.act(contact, self.arms.of(c, self.h_n), c, || attraction.force(c.distance), spring, dt)
    }

    fn stored<R: Real>(&self, c: &Contact<R>, (contact, pair): &Coefficients<R>, spring: &Vec3<R>) -> Held<R> {
        let attraction = Attraction { meniscus: self.meniscus, pair: *pair };
        self.held(contact, c, attraction.potential(c.distance), spring)
    }

    /// For two particles at rest; where attraction outweighs the contact there, as with Eqs. 3 to 5 as printed, for the contact alone.
    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        let (k, d) = (self.parameters(r, r, m, m), self.equilibrium(r, r));
        let (_, repulsion, _) = hertz(k.k_n, r + r - d, k.r_eff);
        let stiffness = repulsion - self.attraction(r, r).slope(d);
        stable_time_step(effective_mass(m, m), if stiffness > 0.0 { stiffness } else { repulsion }, k.gamma_n)
    }
}

impl Turns for Titania {
    fn turned<R: Real>(spring: Vec3<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Vec3<R> {
        turn(spring)
    }
}

/// Result of one step of a pair: forces and torques, the tangential spring for the next step, the energy lost.
pub type Act<R> = Outcome<R, Vec3<R>, Lost<R>>;

impl Titania {
    /// Eqs. 1 to 13 composed: the forces of a pair with the attraction that `f_na` gives along the normal (negative), its spring advanced by
    /// `dt`. Out of contact only the attraction acts, and the spring is reset.
    #[inline(always)]
    pub fn act<R: Real>(
        &self,
        k: &Parameters<R>,
        [arm_i, arm_j]: [R; 2],
        c: &Contact<R>,
        f_na: impl FnOnce() -> R,
        spring: Vec3<R>,
        dt: R,
    ) -> Act<R> {
        let (zero, delta_n) = (R::zero(), -c.gap);
        let (tau_s, tau_r, lambda_t) = (R::lit(self.tau_s), R::lit(self.tau_r), R::lit(self.lambda_t));
        let slip = R::lit(f64::from(u8::from(self.slip == Slip::Remainder)));
        let touches = delta_n.gt(zero);
        let a = Self::area(c);

        // The area before the step that led here, which the spring was left with.
        let apart = c.n * c.distance - c.v * dt;
        let square = apart.dot(apart);
        let before = section(c.r_i, c.r_j, (c.r_i + c.r_j).squared() - square, square, R::one() / square);

        // Between roots and divisions, which wait for nothing from memory: a table is read while they are at work.
        let f_na = f_na();
        let stretched = stretched_spring(spring, c.n, c.sliding_velocity(arm_i, arm_j), dt);
        let (f_t, kept) = sliding_spring(tau_s, a, lambda_t, stretched, slip);
        let kept = Vec3::select(touches, kept, Vec3::zero());

        let (f_nr, _, _) = hertz(k.k_n, delta_n, k.r_eff);
        let f_nd = Vec3::select(touches, dashpot(k.gamma_n, c), Vec3::zero());
        let rolling = rolling_torque(k.r_eff * tau_r * a, c.omega_i, c.omega_j, c.n, k.inertia, dt);
        let share = rolling_share(c.omega_i, c.omega_j, c.n);
        let rolling = rolling * R::select(R::always(self.rolling_over == RollingOver::Spin), share, R::one());
        let (torque_i, torque_j) = contact_torques(arm_i, arm_j, f_t, c.n, -rolling);
        let wrench = Wrench { force: total_force(c.n * f_na, c.n * f_nr, f_nd, f_t), torque_i, torque_j };
        let lost = Lost {
            normal: -(f_nd.dot(c.v) * dt),
            sliding: self.spring_energy(a, stretched) - self.spring_energy(a, kept),
            rolling: -(rolling.dot(c.omega_i - c.omega_j) * dt),
            contact_area: self.spring_energy(before, spring) - self.spring_energy(a, spring),
        };
        Outcome { wrench, memory: kept, losses: lost }
    }

    /// The energy of a pair whose attraction has the energy `potential`.
    #[inline(always)]
    pub fn held<R: Real>(&self, k: &Parameters<R>, c: &Contact<R>, potential: R, spring: &Vec3<R>) -> Held<R> {
        Held {
            repulsion: hertz(k.k_n, -c.gap, k.r_eff).2,
            attraction: potential,
            tangential: self.spring_energy(Self::area(c), *spring),
        }
    }

    #[inline(always)]
    fn spring_energy<R: Real>(&self, a: R, spring: Vec3<R>) -> R {
        spring_energy(R::lit(self.tau_s), a, R::lit(self.lambda_t), spring)
    }
}

#[cfg(test)]
mod laws;
