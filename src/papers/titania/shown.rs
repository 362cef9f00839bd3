//! What the book shows of the paper beside its equations.

use super::case::Titania;
use crate::case::section::defaults;
use crate::case::units::from_engine;
use crate::papers::shown::{Law, Table};

pub(super) const TABLES: &[Table] = &[
    Table {
        number: "Table 1",
        title: "Parameters of the contact",
        case: "cases/titania/pair.yaml",
        keys: &[
            "solvation_period",
            "solvation_force",
            "solvation_growth",
            "damping_constant",
            "layer",
            "slip_period",
            "sliding_strength",
            "rolling_strength",
        ],
    },
    Table { number: "Section 2", title: "All parameters of the model", case: "cases/titania/pair.yaml", keys: &[] },
];

/// Two particles with a nominal diameter of 8 nm.
pub(super) fn laws() -> Vec<Law> {
    let (radius, mass) = defaults::<Titania>().particle(8.0);
    let (r, mass) = (from_engine(radius, "m"), from_engine(mass, "kg"));
    vec![Law {
        id: "titania-law",
        title: "Water-covered titania particles with a nominal diameter of 8 nm; radii and gap are those of the contact spheres",
        gaps: [-0.4e-9, 1.6e-9],
        gap: -0.15e-9,
        path: 1.5e-9,
        values: vec![("r_i", r), ("r_j", r), ("m_i", mass), ("m_j", mass)],
    }]
}
