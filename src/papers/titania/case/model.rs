//! The model of a case of the titania paper: its section, and its readings.

use super::{Case, Model};
use crate::case::quantity::{
    DampingPerArea, Density, Energy, Force, Length, Pressure, Quantity, Stiffness, SurfaceEnergy, Temperature, Volume,
    quantity,
};
use crate::case::section::{defaults, section, words};
use crate::case::springs::{FourSprings, Transport};
use crate::case::units::BOLTZMANN;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::thermal::thermal_energy;
use crate::spec::titania::{
    self, eq02_torque, eq03_attraction, eq07_damping_coefficient, eq09_stiffness, eq12_sliding, eq13_rolling,
};

section! {
    /// Oxide particles of a few nanometres in humid air.
    pub struct Titania {
        /// Density of the particles.
        density: Quantity<Density> = quantity("4230 kg/m^3"),
        /// Relative humidity, between 0 and 1.
        humidity: f64 = 0.5,
        /// Temperature.
        temperature: Quantity<Temperature> = quantity("300 K"),
        /// Surface tension of the water.
        surface_tension: Tension = Tension::Experimental,
        /// A liquid other than water.
        liquid: Option<Liquid> = None,
        /// Contact angle of the meniscus, in radians.
        contact_angle: f64 = 0.0,
        /// Profile of the meniscus.
        meniscus: Meniscus = Meniscus::Circular,
        /// Equilibrium distance between the bare surfaces of two particles.
        core_gap: Quantity<Length> = quantity("0.57 nm"),
        /// Thickness h_n of the compressed water layer.
        layer: Quantity<Length> = quantity("0.36 nm"),
        /// Sign convention of the solvation force.
        solvation: Convention = Convention::Israelachvili,
        /// Amplitude F_00 of the solvation force, extrapolated to particles of size zero.
        solvation_force: Quantity<Force> = quantity("-11 nN"),
        /// Increase F_01 of this amplitude with the effective radius.
        solvation_growth: Quantity<Stiffness> = quantity("-2.4 N/m"),
        /// Period and decay length of the solvation force.
        solvation_period: Quantity<Length> = quantity("0.21 nm"),
        /// Whose reading of the paper is computed where there are several.
        readings: Readings = Readings::Own,
        /// Damping constant gamma_0 of Eq. 7; the authors' program uses ten times the value in the paper.
        damping_constant: Quantity<DampingPerArea> = quantity("0.5e6 N s/m^3"),
        /// Radii of which the effective radius R* of Eq. 7 is taken.
        damping_radius: DampingRadius = DampingRadius::Bare,
        /// Shear strength tau_S of sliding.
        sliding_strength: Quantity<Pressure> = quantity("0.65 GPa"),
        /// Shear strength tau_R of rolling.
        rolling_strength: Quantity<Pressure> = quantity("0.25 GPa"),
        /// Stick-slip period lambda_t.
        slip_period: Quantity<Length> = quantity("0.5 nm"),
        /// Elongation of the tangential spring after a slip.
        slip: Slip = Slip::Reset,
        /// Equilibrium from which the contact stiffness of a pair is derived, Eq. 9.
        contact_stiffness: ContactStiffness = ContactStiffness::Pair,
        /// Position of the contact point of a pair.
        moment_arms: MomentArms = MomentArms::HalfGap,
        /// Rolling resistance of a particle that has almost stopped rolling.
        rolling: Rolling = Rolling::Stopping,
        /// Angular velocity over whose length the rolling torque is spread.
        rolling_over: RollingOver = RollingOver::Rolling,
        /// Whether tangential springs, and those of necks, follow a pair that spins about its normal; `carried` is a reading that no paper takes.
        springs: Transport = Transport::Projected,
        /// Springs of the necks between the particles of an aggregate, as in the soot paper; without them aggregates are rigid.
        neck_springs: Option<FourSprings> = None,
        /// Energy stored in the four springs of a neck at which it breaks; without this key necks never break.
        break_energy: Option<Quantity<Energy>> = None,
    }
}

words! {
    /// The surface tension of adsorbed water.
    pub enum Tension {
        /// Scaled to the experimental value for water.
        Experimental = "experimental",
        /// The value of the water model TIP3P.
        Tip3p = "tip3p",
    }
}

section! {
    /// A liquid whose surface tension and adsorbed layer depend neither on the humidity nor on the size of the particles.
    pub struct Liquid {
        /// Surface tension.
        surface_tension: Quantity<SurfaceEnergy>,
        /// Molecular volume.
        molecule: Quantity<Volume>,
        /// Thickness of the adsorbed layer.
        layer: Quantity<Length>,
    }
}

words! {
    /// Equilibrium from which the contact stiffness of a pair is derived.
    pub enum ContactStiffness {
        /// The equilibrium of the pair itself, as in the authors' program.
        Pair = "pair",
        /// The equilibria of two pairs of equal particles, one of either size; their compliances are averaged.
        Size = "size",
    }
}

words! {
    /// Position of the contact point of a pair.
    pub enum MomentArms {
        /// Midway between the bare surfaces, as in the authors' program.
        HalfGap = "half-gap",
        /// Half a compressed layer above each bare surface, at any distance, a possible reading of Section 2; it does not conserve angular momentum.
        HalfLayer = "half-layer",
    }
}

words! {
    /// Rolling resistance in a step in which it would reverse the rolling of a particle.
    pub enum Rolling {
        /// The particle stops.
        Stopping = "stopping",
        /// The particle rolls back, as in the authors' program.
        Unlimited = "unlimited",
    }
}

words! {
    /// Angular velocity over whose length the rolling torque is spread.
    pub enum RollingOver {
        /// That of rolling: twisting about the normal does not count.
        Rolling = "rolling",
        /// The whole relative one, as in the authors' program: twisting weakens the resistance to rolling.
        Spin = "spin",
    }
}

words! {
    /// Radii of which the effective radius of the damping is taken.
    pub enum DampingRadius {
        /// Those of the bare particles.
        Bare = "bare",
        /// Those of the contact spheres, as in the authors' program.
        Contact = "contact",
    }
}

words! {
    /// Whose reading of the paper is computed.
    pub enum Readings {
        /// Ours.
        Own = "own",
        /// That of the authors' program, which decides these keys: `damping_constant: 5e6 N s/m^3`, `damping_radius: contact`, `rolling: unlimited`, `rolling_over: spin`. Its tables of the attraction and its elastic bonds of the released version are
        /// not reproduced.
        AsPublished = "as-published",
    }
}

words! {
    /// The profile of a meniscus.
    pub enum Meniscus {
        /// An arc of a circle, as in the earlier work that the paper refers to.
        Circular = "circular",
        /// The profile of constant curvature, a reading that the paper does not take: it attracts more, and ruptures farther out.
        Exact = "exact",
    }
}

words! {
    /// The sign of the solvation force.
    pub enum Convention {
        /// As in the earlier work cited by the paper.
        Israelachvili = "israelachvili",
        /// As printed in Eqs. 3 to 5.
        Printed = "printed",
    }
}

words! {
    /// Elongation of the tangential spring after a slip.
    pub enum Slip {
        /// Zero, as in the authors' program.
        Reset = "reset",
        /// The remainder beyond whole periods, as in Eq. 12.
        Remainder = "remainder",
    }
}

impl Titania {
    /// The contact law in engine units.
    pub fn law(&self) -> titania::Titania {
        let megapascal = 1e-6;
        let paper = titania::Titania::paper(1.0, 1e3, 1.0);
        titania::Titania {
            core_gap: self.core_gap.value,
            h_n: self.layer.value,
            humidity: self.humidity,
            thermal_pressure: match &self.liquid {
                None => titania::Titania::thermal_pressure_of_water(self.temperature.value) * megapascal,
                Some(Liquid { molecule, .. }) => thermal_energy(BOLTZMANN, self.temperature.value) / molecule.value,
            },
            contact_angle: self.contact_angle,
            liquid: match (&self.liquid, self.surface_tension) {
                (Some(Liquid { surface_tension, layer, .. }), _) => {
                    titania::Liquid::Other { gamma: surface_tension.value, h_w: layer.value }
                }
                (None, Tension::Experimental) => paper.liquid,
                (None, Tension::Tip3p) => titania::Liquid::Water { scale: 1.0 },
            },
            meniscus: match self.meniscus {
                Meniscus::Circular => titania::Meniscus::Circular,
                Meniscus::Exact => titania::Meniscus::Exact,
            },
            solvation: match self.solvation {
                Convention::Israelachvili => eq03_attraction::Solvation::Israelachvili,
                Convention::Printed => eq03_attraction::Solvation::Printed,
            },
            f_00: self.solvation_force.value,
            f_01: self.solvation_growth.value,
            sigma: self.solvation_period.value,
            gamma_0: self.damping_constant.value,
            tau_s: self.sliding_strength.value,
            tau_r: self.rolling_strength.value,
            lambda_t: self.slip_period.value,
            slip: match self.slip {
                Slip::Reset => eq12_sliding::Slip::Reset,
                Slip::Remainder => eq12_sliding::Slip::Remainder,
            },
            stiffness: match self.contact_stiffness {
                ContactStiffness::Pair => eq09_stiffness::Stiffness::PerPair,
                ContactStiffness::Size => eq09_stiffness::Stiffness::PerSize,
            },
            arms: match self.moment_arms {
                MomentArms::HalfGap => eq02_torque::Arms::HalfGap,
                MomentArms::HalfLayer => eq02_torque::Arms::HalfLayer,
            },
            rolling: match self.rolling {
                Rolling::Stopping => eq13_rolling::Rolling::Stopping,
                Rolling::Unlimited => eq13_rolling::Rolling::Unlimited,
            },
            rolling_over: match self.rolling_over {
                RollingOver::Rolling => eq13_rolling::RollingOver::Rolling,
                RollingOver::Spin => eq13_rolling::RollingOver::Spin,
            },
            damping_radius: match self.damping_radius {
                DampingRadius::Bare => eq07_damping_coefficient::DampingRadius::Bare,
                DampingRadius::Contact => eq07_damping_coefficient::DampingRadius::Contact,
            },
            ..paper
        }
    }

    /// Radius of the contact sphere and mass of a particle of a nominal diameter.
    pub fn particle(&self, diameter: f64) -> (f64, f64) {
        let r = self.law().contact_radius(diameter);
        (r, sphere_mass(self.density.value, r))
    }

    /// Nominal diameter of a particle with this contact radius.
    pub fn nominal(&self, radius: f64) -> f64 {
        2.0 * (radius - self.layer.value) + self.core_gap.value
    }
}

/// The damping constant of the authors' program.
const PROGRAMMED: &str = "5e6 N s/m^3";

/// Sets the keys that the authors' program decides, where they have their defaults.
pub fn read_as_published(case: &mut Case) {
    let Model::Titania(titania) = &mut case.model;
    if titania.readings == Readings::AsPublished {
        if titania.damping_constant == defaults::<Titania>().damping_constant {
            titania.damping_constant = quantity(PROGRAMMED);
        }
        titania.damping_radius = DampingRadius::Contact;
        titania.rolling = Rolling::Unlimited;
        titania.rolling_over = RollingOver::Spin;
    }
}

/// Finds what the authors' program reads otherwise than the case says.
pub fn unlike_published(titania: &Titania) -> Vec<(&'static str, String)> {
    let program = Titania { readings: Readings::AsPublished, ..defaults() };
    let written = |same: bool, key, value: String| (!same).then_some((key, value));
    let word = |word: &dyn std::fmt::Debug| format!("{word:?}").to_lowercase();
    let all = [
        written(
            titania.damping_constant.value == quantity::<DampingPerArea>(PROGRAMMED).value,
            "damping_constant",
            titania.damping_constant.to_string(),
        ),
        written(titania.slip == program.slip, "slip", word(&titania.slip)),
        written(
            titania.contact_stiffness == program.contact_stiffness,
            "contact_stiffness",
            word(&titania.contact_stiffness),
        ),
        written(titania.moment_arms == program.moment_arms, "moment_arms", "half-layer".into()),
        written(titania.solvation == program.solvation, "solvation", word(&titania.solvation)),
        written(titania.meniscus == program.meniscus, "meniscus", word(&titania.meniscus)),
        written(titania.springs == program.springs, "springs", word(&titania.springs)),
    ];
    if titania.readings == Readings::AsPublished { all.into_iter().flatten().collect() } else { Vec::new() }
}
