//! The claims of the soot paper.

pub mod ensemble;
pub mod exact;
pub mod indentation;
pub mod restructuring;

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
];
