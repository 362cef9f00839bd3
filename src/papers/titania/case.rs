//! The sections of a case of the titania paper. Defaults are its published values, and those of the authors' program where it
//! is silent.

mod film;

pub use film::*;

use super::chain::Recipe;
use crate::case::InSteps;
use crate::case::quantity::{
    DampingPerArea, Density, Drag, Energy, Force, Length, Pressure, Quantity, Scaled, Stiffness, SurfaceEnergy,
    Temperature, Time, Velocity, Volume, quantity,
};
use crate::case::section::{choice, section, words};
use crate::case::springs::FourSprings;
use crate::case::units::{BOLTZMANN, in_unit, rounded};
use crate::spec::PairModel;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::thermal::thermal_energy;
use crate::spec::titania::def_radius::radii;
use crate::spec::titania::{self, eq02_torque, eq03_attraction, eq09_stiffness, eq12_sliding, eq13_rolling};
use std::path::PathBuf;

/// A case of the titania paper.
pub type Case = crate::case::Case<Model, Sample, Experiment>;

choice! {
    /// The contact model.
    pub enum Model {
        /// Laube et al. 2018: water-covered oxide nanoparticles.
        Titania = "titania": Titania,
    }
}

choice! {
    /// How the particles are arranged.
    pub enum Sample {
        /// Two water-covered particles.
        Pair = "pair": TwoParticles,
        /// A chain of water-covered particles of many sizes.
        Agglomerate = "agglomerate": Agglomerate,
        /// A film of aggregates.
        Film = "film": Film,
    }
}

choice! {
    /// What is done to a sample.
    pub enum Experiment {
        /// A particle is released near another, and moved over a slab.
        Contact = "contact": ContactTests,
        /// An agglomerate is stretched.
        Stretching = "stretching": Stretching,
        /// A film under the tip of a force microscope.
        Spectroscopy = "spectroscopy": Spectroscopy,
    }
}

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
        /// Another liquid than water.
        liquid: Option<Liquid> = None,
        /// Contact angle of the meniscus, in radians.
        contact_angle: f64 = 0.0,
        /// Distance of the bare surfaces of two particles at rest.
        core_gap: Quantity<Length> = quantity("0.57 nm"),
        /// Thickness h_n of the compressed water layer.
        layer: Quantity<Length> = quantity("0.36 nm"),
        /// Which way the solvation force acts.
        solvation: Convention = Convention::Israelachvili,
        /// Amplitude F_00 of the solvation force of vanishing particles.
        solvation_force: Quantity<Force> = quantity("-11 nN"),
        /// Its growth F_01 with the effective radius.
        solvation_growth: Quantity<Stiffness> = quantity("-2.4 N/m"),
        /// Period and decay length of the solvation force.
        solvation_period: Quantity<Length> = quantity("0.21 nm"),
        /// Damping constant gamma_0 of Eq. 7; the authors' program has ten times that of the paper.
        damping_constant: Quantity<DampingPerArea> = quantity("0.5e6 N s/m^3"),
        /// Shear strength tau_S of sliding.
        sliding_strength: Quantity<Pressure> = quantity("0.65 GPa"),
        /// Shear strength tau_R of rolling.
        rolling_strength: Quantity<Pressure> = quantity("0.25 GPa"),
        /// Period lambda_t of stick and slip.
        slip_period: Quantity<Length> = quantity("0.5 nm"),
        /// What a slip leaves of the tangential spring.
        slip: Slip = Slip::Reset,
        /// Whose equilibrium gives the contact stiffness of a pair, Eq. 9.
        contact_stiffness: ContactStiffness = ContactStiffness::Pair,
        /// Where the contact point of a pair is.
        moment_arms: MomentArms = MomentArms::HalfGap,
        /// What rolling resistance does to a particle that hardly rolls.
        rolling: Rolling = Rolling::Stopping,
        /// The springs of the necks between the particles of an aggregate, as the soot paper has them; without them aggregates are rigid.
        neck_springs: Option<FourSprings> = None,
        /// Energy of its four springs at which a neck breaks; without it necks never do.
        break_energy: Option<Quantity<Energy>> = None,
    }
}

words! {
    /// The surface tension of adsorbed water.
    pub enum Tension {
        /// Scaled to that of water.
        Experimental = "experimental",
        /// That of the water model TIP3P.
        Tip3p = "tip3p",
    }
}

section! {
    /// A liquid whose surface tension and layer depend neither on the humidity nor on the size of the particles.
    pub struct Liquid {
        /// Its surface tension.
        surface_tension: Quantity<SurfaceEnergy>,
        /// Volume of a molecule of it.
        molecule: Quantity<Volume>,
        /// Thickness of the layer on the particles.
        layer: Quantity<Length>,
    }
}

words! {
    /// Whose equilibrium gives the contact stiffness of a pair.
    pub enum ContactStiffness {
        /// Its own, as in the authors' program.
        Pair = "pair",
        /// Those of equal pairs of either size, whose compliances are averaged.
        Size = "size",
    }
}

words! {
    /// Where the contact point of a pair is.
    pub enum MomentArms {
        /// Half-way between the bare surfaces, as in the authors' program.
        HalfGap = "half-gap",
        /// Half a compressed layer above each, at any distance, as Section 2 may be read; angular momentum is not kept.
        HalfLayer = "half-layer",
    }
}

words! {
    /// What rolling resistance does in a step that would turn a rolling particle back.
    pub enum Rolling {
        /// It stops the particle.
        Stopping = "stopping",
        /// It turns it back, as in the authors' program.
        Unlimited = "unlimited",
    }
}

words! {
    /// The sign of the solvation force.
    pub enum Convention {
        /// As in the earlier work that the paper refers to.
        Israelachvili = "israelachvili",
        /// As Eqs. 3 to 5 have it.
        Printed = "printed",
    }
}

words! {
    /// What a slip leaves of the tangential spring.
    pub enum Slip {
        /// Nothing, as in the authors' program.
        Reset = "reset",
        /// What exceeds whole periods, as in Eq. 12.
        Remainder = "remainder",
    }
}

section! {
    /// Two particles.
    pub struct TwoParticles {
        /// Their nominal diameters: half their sum is the distance of their centres at rest.
        diameters: [Quantity<Length>; 2] = [quantity("8 nm"), quantity("8 nm")],
    }
}

section! {
    /// A chain in which every particle touches the two before it, Section 3.1.
    pub struct Agglomerate {
        /// Number of particles.
        particles: u64 = 14,
        /// Smallest nominal diameter.
        smallest: Quantity<Length> = quantity("8 nm"),
        /// Largest nominal diameter.
        largest: Quantity<Length> = quantity("20 nm"),
        /// Length of the chain, met within a twentieth.
        length: Quantity<Length> = quantity("100 nm"),
    }
}

section! {
    /// Tests of one contact, each from the start.
    pub struct ContactTests {
        /// Both particles released at a distance, Fig. 3.
        approach: Option<Approach> = None,
        /// The first particle slid over a slab without turning, Fig. 8.
        slide: Option<Dragging> = None,
        /// The first particle rolled over a slab without sliding, Fig. 8.
        roll: Option<Dragging> = None,
        /// Time step: a fifth of the authors', for friction may at most stop a rolling particle in one step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

section! {
    /// Two particles released.
    pub struct Approach {
        /// How far from their distance at rest.
        from: Quantity<Length> = quantity("0.5 nm"),
        /// How long they are watched.
        duration: InSteps = Scaled::Absolute(quantity("3 ns")),
    }
}

section! {
    /// A particle moved over a slab under a load.
    pub struct Dragging {
        /// Nominal diameter of the sphere that stands for the slab.
        slab: Quantity<Length> = quantity("1 µm"),
        /// Load on the particle.
        load: Quantity<Force> = quantity("2 nN"),
        /// How long the particle has to come to rest under the load.
        settling: InSteps = Scaled::Absolute(quantity("2 ns")),
        /// Velocity of the particle.
        velocity: Quantity<Velocity> = quantity("1 m/s"),
        /// How far it is moved.
        distance: Quantity<Length> = quantity("3 nm"),
    }
}

section! {
    /// An agglomerate drawn at two of its particles, two others at the far end being held, Section 3.1.
    pub struct Stretching {
        /// How long it has to come to rest before, held at both ends.
        relaxation: InSteps = Scaled::Absolute(quantity("2 ns")),
        /// Drag on every particle meanwhile.
        drag: Quantity<Drag> = quantity("1e-11 kg/s"),
        /// Stiffness of the spring that draws.
        stiffness: Quantity<Stiffness> = quantity("160 N/m"),
        /// Velocity of its other end.
        velocity: Quantity<Velocity> = quantity("5 m/s"),
        /// How far that end moves.
        distance: Quantity<Length> = quantity("60 nm"),
        /// Time step: a fifth of the authors', for friction may at most stop a rolling particle in one step.
        dt: Quantity<Time> = quantity("0.1 ps"),
    }
}

/// What is done in a case of the titania paper, and to what.
#[derive(Clone, Copy, Debug)]
pub enum TitaniaTest<'a> {
    /// Two particles.
    Contact(&'a TwoParticles, &'a ContactTests),
    /// An agglomerate.
    Stretching(&'a Agglomerate, &'a Stretching),
    /// A film.
    Spectroscopy(&'a Film, &'a Spectroscopy),
}

impl TitaniaTest<'_> {
    /// The smallest nominal diameter, nm.
    pub fn smallest(&self) -> f64 {
        match self {
            Self::Contact(TwoParticles { diameters: [first, second] }, _) => first.value.min(second.value),
            Self::Stretching(agglomerate, _) => agglomerate.smallest.value,
            Self::Spectroscopy(film, _) => film.diameters.smallest.value,
        }
    }

    /// The time step, and its key.
    pub fn dt(&self) -> (&'static str, &Quantity<Time>) {
        match self {
            Self::Contact(_, tests) => ("experiment.contact.dt", &tests.dt),
            Self::Stretching(_, stretching) => ("experiment.stretching.dt", &stretching.dt),
            Self::Spectroscopy(_, test) => ("experiment.spectroscopy.dt", &test.dt),
        }
    }
}

impl Agglomerate {
    /// How it is built, in engine units.
    pub fn recipe(&self) -> Recipe {
        Recipe {
            particles: self.particles as usize,
            smallest: self.smallest.value,
            largest: self.largest.value,
            length: self.length.value,
        }
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
            ..paper
        }
    }

    /// Radius of the contact sphere and mass of a particle of a nominal diameter.
    pub fn particle(&self, diameter: f64) -> (f64, f64) {
        let r = self.law().contact_radius(diameter);
        (r, sphere_mass(self.density.value, r))
    }
}

/// The model of a case, and its test where sample and experiment go together.
pub fn parts(case: &Case) -> (&Titania, Option<TitaniaTest<'_>>) {
    let Model::Titania(titania) = &case.model;
    let test = match (&case.sample, &case.experiment) {
        (Sample::Pair(pair), Experiment::Contact(tests)) => TitaniaTest::Contact(pair, tests),
        (Sample::Agglomerate(chain), Experiment::Stretching(test)) => TitaniaTest::Stretching(chain, test),
        (Sample::Film(film), Experiment::Spectroscopy(test)) => TitaniaTest::Spectroscopy(film, test),
        _ => return (titania, None),
    };
    (titania, Some(test))
}

/// The model and the test of a checked case.
pub fn checked(case: &Case) -> (&Titania, TitaniaTest<'_>) {
    let (titania, test) = parts(case);
    (titania, test.expect("in a checked case, sample and experiment go together"))
}

/// The largest stable time step of a case, ns.
pub fn step_limit(titania: &Titania, test: &TitaniaTest) -> f64 {
    let (r, mass) = titania.particle(test.smallest());
    let limit = titania.law().critical_time_step(r, mass);
    let (Some(springs), TitaniaTest::Spectroscopy(film, _)) = (&titania.neck_springs, test) else { return limit };
    let largest = titania.particle(film.diameters.largest.value).0;
    limit.min(springs.spec().critical_time_step(r, mass, largest))
}

/// The files that a case reads.
pub fn reads(case: &Case) -> Vec<PathBuf> {
    if let Sample::Film(Film { load: Some(file), .. }) = &case.sample { vec![file.clone()] } else { Vec::new() }
}

/// The files that a case writes beside its run folder, with the sections that ask for them.
pub fn saves(case: &Case) -> Vec<(String, PathBuf)> {
    match &case.sample {
        Sample::Film(Film { save: Some(file), .. }) => vec![("sample.film".into(), file.clone())],
        _ => Vec::new(),
    }
}

/// What follows from a case, with units.
pub fn derived(case: &Case) -> Vec<(String, String)> {
    let (titania, test) = checked(case);
    let (law, d, limit) = (titania.law(), test.smallest(), step_limit(titania, &test));
    let (r, mass) = titania.particle(d);
    let attraction = law.attraction(r, r);
    let (key, dt) = test.dt();
    let share = rounded(dt.value / limit);
    let rows = [
        ("smallest diameter", in_unit(d, "nm")),
        ("its bare radius", in_unit(radii(d, law.core_gap, law.h_n).0, "nm")),
        ("its contact radius", in_unit(r, "nm")),
        ("its mass", in_unit(mass, "kg")),
        ("contact stiffness of two such particles", in_unit(law.parameters(r, r, mass, mass).k_n, "GPa")),
        ("attraction at rest", in_unit(-attraction.force(law.equilibrium(r, r)), "nN")),
        ("distance at which the meniscus ruptures", in_unit(attraction.rupture(), "nm")),
        ("largest stable time step", in_unit(limit, "fs")),
        (key, format!("{} = {share} of the largest stable step", in_unit(dt.value, "fs"))),
    ];
    rows.into_iter().map(|(key, value)| (key.into(), value)).collect()
}
