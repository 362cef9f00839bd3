//! The necks of a case of the soot paper: their springs and their strengths.

use super::Soot;
use crate::case::quantity::{Length, Pressure, Quantity};
use crate::case::section::{choice, section, words};
use crate::case::springs::{FourSprings, four_springs};
use crate::spec::soot;
use std::path::PathBuf;

words! {
    /// The two published sets of springs of a neck.
    pub enum NeckSet {
        /// 1e5 N/m for all springs, for deposition and indentation; stable at 50 fs.
        S = "S",
        /// 1e6 N/m for the normal spring, 1e7 N/m for the others, for restructuring; needs 5 fs.
        P = "P",
    }
}

section! {
    /// Strength of a neck, taken as an elastic beam of circular cross-section.
    pub struct NeckStrength {
        /// Tensile strength, reached by tension and bending combined.
        tension: Quantity<Pressure>,
        /// Shear strength, reached by shear and torsion combined.
        shear: Quantity<Pressure>,
        /// Radius of the cross-section.
        neck_radius: Quantity<Length>,
    }
}

choice! {
    /// Where the strengths of single necks come from. What is drawn depends on the seed of the case and the two spheres.
    pub enum NeckStrengths {
        /// The distribution of Weibull.
        Weibull = "weibull": WeibullStrengths,
        /// The normal distribution above zero: what is not positive is drawn again.
        Normal = "normal": NormalStrengths,
        /// A file with rows `i,j,strength`: two spheres, counted from 0, and the strength of their neck. It may have more necks than the aggregate.
        File = "file": PathBuf,
    }
}

section! {
    /// Strengths of which the share exp(-(x/scale)^shape) exceeds x.
    pub struct WeibullStrengths {
        /// The strength that one neck in e exceeds.
        scale: f64 = 1.0,
        /// Weibull modulus: the larger, the more alike the necks are.
        shape: f64,
    }
}

section! {
    /// Strengths with a normal distribution, of which those below zero are left out.
    pub struct NormalStrengths {
        /// Mean.
        mean: f64 = 1.0,
        /// Standard deviation.
        deviation: f64,
    }
}

impl NeckSet {
    /// The springs of the set.
    pub fn springs(self) -> FourSprings {
        match self {
            Self::S => four_springs(["1e5 N/m"; 4], ["1.25e-7 kg/s", "2.5e-8 kg/s", "6.25e-9 kg/s", "6.25e-9 kg/s"]),
            Self::P => four_springs(
                ["1e6 N/m", "1e7 N/m", "1e7 N/m", "1e7 N/m"],
                ["1.25e-6 kg/s", "2.5e-7 kg/s", "6.25e-8 kg/s", "6.25e-8 kg/s"],
            ),
        }
    }
}

impl Soot {
    /// The strength of a neck.
    pub fn strength(&self) -> soot::Strength {
        let stress = self.break_stress.as_ref();
        soot::Strength {
            energy: self.break_energy.as_ref().map(|energy| energy.value),
            stress: stress
                .map(|NeckStrength { tension, shear, neck_radius }| [tension.value, shear.value, neck_radius.value]),
        }
    }

    /// The file of the strengths of single necks.
    pub fn strengths_file(&self) -> Option<&PathBuf> {
        if let Some(NeckStrengths::File(file)) = &self.neck_strengths { Some(file) } else { None }
    }
}
