//! A film of aggregates, Section 5.3 of Laube et al. 2018: polydisperse particles form fractal aggregates, which diffuse and drift
//! down one by one and stay where they touch the floor or an earlier one.
//!
//! Choices where the paper is silent: gyration radii count a sphere alone by its radius, as the work does that the paper takes its
//! algorithm from (Filippov, Zurita & Rosner 2000), weighted by mass; an aggregate falls in a random orientation and does
//! not turn; two spheres touch at their distance at rest, which is half the sum of their nominal diameters.

mod aggregates;
pub mod column;
mod deposition;
mod system;

use super::aggregate::Failure as Ungrown;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use column::Column;
use serde::{Deserialize, Serialize};
use std::fmt;
pub use system::Bonding;

/// What is to be built. Lengths in nm, the other quantities in the engine's units too.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmPlan {
    /// Number of spheres; the aggregate that reaches it is the last.
    pub spheres: usize,
    /// Sides of the column, periodic.
    pub sides: [f64; 2],
    /// The nominal diameters.
    pub diameters: Diameters,
    /// The numbers of spheres of the aggregates.
    pub numbers: Numbers,
    /// Spheres of the clusters that aggregates are joined of.
    pub cluster: usize,
    /// Prefactor of the fractal law.
    pub k_f: f64,
    /// Fractal dimension.
    pub d_f: f64,
    /// The gas that aggregates diffuse in.
    pub gas: Gas,
    /// Velocity with which they drift down.
    pub drift: f64,
}

/// A log-normal distribution of whole nanometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diameters {
    /// Median before the discretisation.
    pub median: f64,
    /// Geometric standard deviation.
    pub deviation: f64,
    /// Smallest diameter.
    pub smallest: u32,
    /// Largest diameter.
    pub largest: u32,
}

/// A log-normal distribution of whole numbers from 1 on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    /// Median.
    pub median: f64,
    /// Standard deviation of the logarithm.
    pub deviation: f64,
    /// Largest number.
    pub largest: u32,
}

/// A gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gas {
    /// Temperature, K.
    pub temperature: f64,
    /// Viscosity.
    pub viscosity: f64,
    /// Mean free path.
    pub free_path: f64,
}

/// A film: its aggregates in the order in which they came, each whole, with its centre of mass inside the column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DepositedFilm {
    /// The spheres, one aggregate after the other.
    pub spheres: Vec<FilmSphere>,
    /// Of each aggregate, whether it lies on the floor, which is at height zero.
    pub on_floor: Vec<bool>,
    /// Sides of the column, periodic, nm.
    pub sides: [f64; 2],
    /// Height of the highest point, nm.
    pub thickness: f64,
}

/// A sphere of a film.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FilmSphere {
    /// Centre, nm.
    pub centre: Vec3<f64>,
    /// Nominal diameter, nm: spheres are at rest half the sum of theirs apart.
    pub diameter: f64,
    /// The aggregate that it belongs to.
    pub aggregate: u32,
}

/// Why a film cannot be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// An aggregate cannot be grown.
    Ungrown(Ungrown),
    /// An aggregate does not fit into the column without touching its own periodic image.
    Wide {
        /// Number of its spheres.
        number: usize,
        /// Its extent, nm.
        extent: f64,
    },
    /// A side of the column is shorter than a cell for the largest spheres.
    Narrow {
        /// The shortest that a side may be, nm.
        least: f64,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ungrown(failure) => failure.fmt(f),
            Self::Wide { number, extent } => write!(
                f,
                "an aggregate of {number} spheres is {extent:.0} nm long and touches its own periodic image: the column is too narrow"
            ),
            Self::Narrow { least } => write!(f, "the column is too narrow, its sides must not be below {least} nm"),
        }
    }
}

impl std::error::Error for Failure {}

impl Failure {
    /// The error of a case whose section `key` asked for the film.
    pub fn of(self, key: &str) -> Error {
        match self {
            Self::Ungrown(failure) => failure.of(key),
            other => Error::of_key(key, other.to_string()),
        }
    }
}

impl FilmPlan {
    /// The film of the paper in a column of these sides; the gas is air at 300 K and atmospheric pressure, of which the paper does not tell.
    pub fn paper(spheres: usize, sides: [f64; 2]) -> Self {
        Self {
            spheres,
            sides,
            diameters: Diameters { median: 9.0, deviation: 1.45, smallest: 3, largest: 23 },
            numbers: Numbers { median: 36.0, deviation: 0.5, largest: 128 },
            cluster: 6,
            k_f: 1.0,
            d_f: 1.8,
            gas: Gas { temperature: 300.0, viscosity: 1.85e-2, free_path: 68.0 },
            drift: 0.1,
        }
    }

    /// Builds the film: the same for the same seed, on any number of threads.
    ///
    /// # Errors
    ///
    /// Why it cannot be built, or that it was interrupted.
    pub fn build(&self, seed: u64, interrupt: &Interrupt) -> Result<DepositedFilm, Failure> {
        let least = Column::least_side(0.5 * f64::from(self.diameters.largest));
        if self.sides.iter().any(|&side| side < least) {
            return Err(Failure::Narrow { least });
        }
        let aggregates = aggregates::aggregates(self, seed, interrupt)?;
        deposition::deposited(self, aggregates, seed, interrupt)
    }
}

impl DepositedFilm {
    /// Number of aggregates.
    pub fn aggregates(&self) -> usize {
        self.on_floor.len()
    }
}

#[cfg(test)]
mod tests;
