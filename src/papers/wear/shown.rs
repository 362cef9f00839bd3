//! What the book shows of the paper beside its equations.

use super::claims::{SILICA_DENSITY, silica};
use crate::case::units::from_engine;
use crate::papers::shown::{Law, Table};
use crate::spec::mechanics::sphere::sphere_mass;

const MATERIAL: &[&str] = &[
    "young_modulus",
    "poisson_ratio",
    "tensile_strength",
    "shear_strength",
    "surface_energy",
    "restitution",
    "density",
];

pub(super) const TABLES: &[Table] = &[
    Table {
        number: "Table 4",
        title: "Material of the patch tests, in any coherent units",
        case: "cases/wear/patch-hcp.yaml",
        keys: MATERIAL,
    },
    Table { number: "Table 5", title: "Amorphous silica", case: "cases/wear/junction.yaml", keys: MATERIAL },
];

/// Two spheres of silica of the finest junction, 1.5 nm in diameter.
pub(super) fn laws() -> Vec<Law> {
    let (silica, radius) = (silica(), 0.75);
    let mass = from_engine(sphere_mass(SILICA_DENSITY, radius), "kg");
    let r = from_engine(radius, "m");
    vec![Law {
        id: "wear-contact",
        title: "Cohesive spheres of silica of 1.5 nm in diameter",
        gaps: [-0.2e-9, 0.5e-9],
        gap: -0.05e-9,
        path: 0.6e-9,
        values: vec![
            ("r_i", r),
            ("r_j", r),
            ("m_i", mass),
            ("m_j", mass),
            ("e", from_engine(silica.young_modulus, "Pa")),
            ("nu", silica.poisson_ratio),
            ("sigma_mn", from_engine(silica.tensile_strength, "Pa")),
            ("sigma_mt", from_engine(silica.shear_strength, "Pa")),
            ("gamma", from_engine(silica.surface_energy, "J/m^2")),
            ("eta", silica.restitution),
            ("s", silica.scaling),
        ],
    }]
}
