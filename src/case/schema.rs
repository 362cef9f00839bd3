//! What every case file has: its general sections and keys, with their defaults. The sections below `model`, `sample` and `experiment` are left open.

use super::quantity::{Scaled, Step, Time};
use super::section::{Field, Key, defaults, section};

/// A duration, or a number of steps.
pub type InSteps = Scaled<Time, Step>;

section! {
    /// A case: what is built, of what, and what is done to it.
    pub struct Case<M, S, E> {
        /// One line for people.
        title: String,
        /// Seed of every random stream.
        seed: u64 = 1,
        /// The contact model and its material.
        model: M,
        /// The particles before anything is done to them.
        sample: S,
        /// What is done to the sample.
        experiment: E,
        /// What is written, and how often.
        output: Output = defaults(),
        /// When a run is given up.
        limits: Limits = defaults(),
    }
}

/// The keys of every case file; those below `model`, `sample` and `experiment` are the papers'.
pub fn keys() -> Vec<Key> {
    Case::<(), (), ()>::keys()
}

section! {
    /// What is written, and how often.
    pub struct Output {
        /// Time between two rows of series.csv.
        series: InSteps = Scaled::times(100.0),
        /// Time between two frames.
        frames: InSteps = Scaled::times(5000.0),
        /// Time between two checkpoints.
        checkpoints: InSteps = Scaled::times(10_000.0),
    }
}

section! {
    /// When a run is given up.
    pub struct Limits {
        /// Largest overlap of two particles, as a part of the sum of their radii, once they have been relaxed.
        overlap: f64 = 0.8,
    }
}
