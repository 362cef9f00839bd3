//! Demidov, Gor & Khalizov 2024.

pub mod ensemble;
pub mod exact;
pub mod indentation;
pub mod restructuring;
