//! The sections of a film of the titania paper and of its test under a tip. Defaults are the published values.

use crate::case::InSteps;
use crate::case::quantity::{Drag, Force, Length, Quantity, Scaled, Temperature, Time, Velocity, Viscosity, quantity};
use crate::case::section::{defaults, section};
use crate::initial::aggregate::import::Import;
use crate::initial::film::{Diameters, FilmPlan, Gas, Numbers};
use std::path::PathBuf;

section! {
    /// A film of aggregates deposited one after the other, each of which sticks where it first touches, Section 5.3.
    pub struct Film {
        /// Number of particles.
        particles: u64 = 200_000,
        /// Side lengths of the base of the periodic column.
        sides: [Quantity<Length>; 2] = [quantity("1.5814 µm"), quantity("1.5814 µm")],
        /// Nominal diameters of the particles, in whole nanometres.
        diameters: DiametersOfFilm = defaults(),
        /// Number of particles per aggregate.
        aggregates: NumbersOfFilm = defaults(),
        /// Number of particles in the clusters from which aggregates are assembled.
        cluster: u64 = 6,
        /// Prefactor of the fractal law.
        prefactor: f64 = 1.0,
        /// Fractal dimension.
        dimension: f64 = 1.8,
        /// The gas through which the aggregates are deposited.
        gas: GasOfFilm = defaults(),
        /// Drift velocity of the deposition.
        drift: Quantity<Velocity> = quantity("0.1 m/s"),
        /// Imports the particles from a file instead of depositing aggregates; of the keys above only `sides` counts then. Radii in the file are nominal: particles at rest touch there. The
        /// floor is z = 0: bodies of which a particle touches it are fixed. Where necks join particles instead (`neck_springs`), they are those in its file of necks, or join all particles
        /// of a body that touch.
        import: Option<Import> = None,
        /// File in which the relaxed film is saved.
        save: Option<PathBuf> = None,
        /// File with a relaxed film to start from; it must have been made with the same model, relaxation, seed and values of the keys above.
        load: Option<PathBuf> = None,
    }
}

section! {
    /// A log-normal distribution of diameters.
    pub struct DiametersOfFilm {
        /// Median.
        median: Quantity<Length> = quantity("9 nm"),
        /// Geometric standard deviation.
        deviation: f64 = 1.45,
        /// Smallest.
        smallest: Quantity<Length> = quantity("3 nm"),
        /// Largest.
        largest: Quantity<Length> = quantity("23 nm"),
    }
}

section! {
    /// A log-normal distribution of the number of particles.
    pub struct NumbersOfFilm {
        /// Median.
        median: f64 = 36.0,
        /// Standard deviation of the logarithm.
        deviation: f64 = 0.5,
        /// Largest.
        largest: u64 = 128,
    }
}

section! {
    /// Air, unless stated otherwise.
    pub struct GasOfFilm {
        /// Temperature.
        temperature: Quantity<Temperature> = quantity("300 K"),
        /// Dynamic viscosity.
        viscosity: Quantity<Viscosity> = quantity("1.85e-5 Pa s"),
        /// Mean free path of its molecules.
        free_path: Quantity<Length> = quantity("68 nm"),
    }
}

section! {
    /// Force spectroscopy of a film with the tip of an atomic force microscope, Section 5.4.
    pub struct Spectroscopy {
        /// Duration of the relaxation of the film before.
        relaxation: InSteps = Scaled::Absolute(quantity("100 ns")),
        /// Drag coefficient of every particle during the relaxation.
        drag: Quantity<Drag> = quantity("1e-11 kg/s"),
        /// The tip.
        tip: Tip = defaults(),
        /// Speed of the tip during loading and unloading.
        speed: Quantity<Velocity> = quantity("0.5 m/s"),
        /// Force at which loading ends.
        setpoint: Quantity<Force> = quantity("2 nN"),
        /// Time that the reversal of the motion takes.
        reversal: Quantity<Time> = quantity("0.2 us"),
        /// Averaging time of the force.
        average: Quantity<Time> = quantity("10 ns"),
        /// Largest displacement of the tip during loading.
        depth: Quantity<Length>,
        /// Largest displacement of the tip during unloading; it stops 50 nm after the film has ruptured.
        retraction: Quantity<Length> = quantity("2 um"),
        /// Time step.
        dt: Quantity<Time> = quantity("0.5 ps"),
    }
}

section! {
    /// A pyramid of spheres, apex down.
    pub struct Tip {
        /// Nominal radius of its spheres.
        radius: Quantity<Length> = quantity("20 nm"),
        /// Side of its base.
        side: Quantity<Length> = quantity("0.8 um"),
        /// Initial height above the film.
        clearance: Quantity<Length> = quantity("2 nm"),
    }
}

impl Film {
    /// The parameters of its construction, in engine units.
    pub fn plan(&self) -> FilmPlan {
        let Self { particles, sides, diameters, aggregates, cluster, prefactor, dimension, gas, drift, .. } = self;
        let whole = |d: &Quantity<Length>| d.value.round() as u32;
        FilmPlan {
            spheres: *particles as usize,
            sides: [sides[0].value, sides[1].value],
            diameters: Diameters {
                median: diameters.median.value,
                deviation: diameters.deviation,
                smallest: whole(&diameters.smallest),
                largest: whole(&diameters.largest),
            },
            numbers: Numbers {
                median: aggregates.median,
                deviation: aggregates.deviation,
                largest: aggregates.largest as u32,
            },
            cluster: *cluster as usize,
            k_f: *prefactor,
            d_f: *dimension,
            gas: Gas {
                temperature: gas.temperature.value,
                viscosity: gas.viscosity.value,
                free_path: gas.free_path.value,
            },
            drift: drift.value,
        }
    }

    /// Number of particles; those of a file that cannot be read do not count.
    pub fn number(&self) -> u64 {
        match &self.import {
            Some(import) => import.sizes().map_or(0, |sizes| sizes.number as u64),
            None => self.particles,
        }
    }

    /// All admissible nominal diameters of its particles, nm.
    pub fn sizes(&self) -> Vec<f64> {
        let Diameters { smallest, largest, .. } = self.plan().diameters;
        (smallest..=largest).map(f64::from).collect()
    }
}
