//! The general sections and keys of every case file, with their defaults. The sections below `model`, `sample` and `experiment` are type parameters.

use super::moments::Moments;
use super::quantity::{Scaled, Step, Time};
use super::section::{Field, Key, defaults, section, words};

/// A duration, or a number of steps.
pub type InSteps = Scaled<Time, Step>;

section! {
    /// A case: the contact model, the sample and the experiment.
    pub struct Case<M, S, E> {
        /// One-line description.
        title: String,
        /// Seed of all random streams.
        seed: u64 = 1,
        /// The contact model and its material.
        model: M,
        /// The particles in their initial state.
        sample: S,
        /// The experiment on the sample.
        experiment: E,
        /// Output intervals.
        output: Output = defaults(),
        /// Limits beyond which a run halts.
        limits: Limits = defaults(),
    }
}

/// The keys of every case file; those below `model`, `sample` and `experiment` are the papers'.
pub fn keys() -> Vec<Key> {
    Case::<(), (), ()>::keys()
}

section! {
    /// Output intervals.
    pub struct Output {
        /// Time between rows of the series.
        series: InSteps = Scaled::times(100.0),
        /// Time between frames, or a list of times since the beginning of a stage; the first and the last state of a stage have frames always.
        frames: Moments = Moments::Every(Scaled::times(5000.0)),
        /// Time between checkpoints.
        checkpoints: InSteps = Scaled::times(10_000.0),
        /// The formats of frames.
        format: Vec<Format> = vec![Format::Extxyz],
        /// Significant digits of the numbers in frames.
        digits: Digits = Digits::Seven,
        /// Further columns of frames.
        columns: Vec<Extra> = Vec::new(),
    }
}

words! {
    /// A format of frames.
    pub enum Format {
        /// Extended XYZ for OVITO and ASE, with local dumps of LAMMPS for the pairs and Wavefront files for surfaces.
        Extxyz = "extxyz",
        /// VTK poly data with collections for ParaView.
        Vtp = "vtp",
        /// VTKHDF for ParaView, with the names of quantities of the European network ON-DEM.
        Vtkhdf = "vtkhdf",
    }
}

words! {
    /// Digits of the numbers in frames.
    pub enum Digits {
        /// Those of single precision.
        Seven = "seven",
        /// As many as are needed to read the same numbers back.
        All = "all",
    }
}

words! {
    /// A column of frames that is written only on request.
    pub enum Extra {
        /// Torque of pairs and surfaces, pN nm.
        Torque = "torque",
        /// Force over mass, nm/ns²: the acceleration of a sphere that is part of no rigid body or wall.
        Acceleration = "acceleration",
        /// Torque over moment of inertia, 1/ns².
        AngularAcceleration = "angular_acceleration",
    }
}

section! {
    /// Limits beyond which a run halts.
    pub struct Limits {
        /// Largest overlap of two particles after the relaxation, as a fraction of the sum of their radii.
        overlap: f64 = 0.8,
    }
}
