//! The claims of the soot paper.

pub mod ensemble;
pub mod exact;
pub mod indentation;
pub mod restructuring;

use crate::reproduce::Chapter;

/// The chapters.
pub const CHAPTERS: &[Chapter] = &[
    Chapter { name: "exact", about: "equations alone", title: "Equations alone", compute: |_| Ok(exact::chapter()) },
    Chapter {
        name: "indentation",
        about: "aggregates deposited and indented by a tip, Section 3.1",
        title: "Deposition and indentation",
        compute: |setting| indentation::chapter(setting),
    },
    Chapter {
        name: "restructuring",
        about: "aggregates under a coating, Section 3.2",
        title: "Restructuring",
        compute: |setting| restructuring::chapter(setting),
    },
];
