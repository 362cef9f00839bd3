//! The papers' claims, tested.

pub mod experiment;
