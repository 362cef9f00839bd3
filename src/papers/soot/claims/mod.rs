//! The claims of the soot paper.

mod closures;
pub mod ensemble;
pub mod exact;
pub mod indentation;
mod listed;
mod pathway;
pub mod restructuring;

pub use listed::LISTED;

use crate::reproduce::Chapter;

/// The chapters.
pub const CHAPTERS: &[Chapter] = &[
    Chapter {
        name: "exact",
        about: "consequences of the equations",
        title: "Consequences of the equations",
        compute: |_| Ok(exact::chapter()),
    },
    Chapter {
        name: "indentation",
        about: "deposition and indentation of aggregates, Section 3.1",
        title: "Deposition and indentation",
        compute: |setting| indentation::chapter(setting),
    },
    Chapter {
        name: "restructuring",
        about: "restructuring of coated aggregates, Section 3.2",
        title: "Restructuring",
        compute: |setting| restructuring::chapter(setting),
    },
    Chapter {
        name: "pathway",
        about: "what decides how aggregates restructure, Sections 3.2 and 4",
        title: "Paths of restructuring",
        compute: |setting| pathway::chapter(setting),
    },
];
