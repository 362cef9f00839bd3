//! The general sections and keys of every case file, with their defaults. The sections below `model`, `sample` and `experiment` are type parameters.

use super::quantity::{Scaled, Step, Time};
use super::section::{Field, Key, defaults, section};

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
        /// Time between rows of series.csv.
        series: InSteps = Scaled::times(100.0),
        /// Time between frames.
        frames: InSteps = Scaled::times(5000.0),
        /// Time between checkpoints.
        checkpoints: InSteps = Scaled::times(10_000.0),
    }
}

section! {
    /// Limits beyond which a run halts.
    pub struct Limits {
        /// Largest overlap of two particles after the relaxation, as a fraction of the sum of their radii.
        overlap: f64 = 0.8,
    }
}
