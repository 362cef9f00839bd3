//! The claims of the wear paper.

pub mod amorphous;
pub mod exact;
pub mod experiment;
pub mod junction;
pub mod lattice;
mod listed;

pub use listed::LISTED;

use crate::reproduce::Chapter;
use crate::spec::wear::Material;

/// The chapters.
pub const CHAPTERS: &[Chapter] = &[
    Chapter {
        name: "exact",
        about: "consequences of the equations",
        title: "Consequences of the equations",
        compute: |_| Ok(exact::chapter()),
    },
    Chapter {
        name: "lattice",
        about: "hexagonal close-packed lattices, Section 3.1",
        title: "Lattices",
        compute: |setting| lattice::chapter(setting),
    },
    Chapter {
        name: "amorphous",
        about: "amorphous samples, Sections 3.2 and 3.3",
        title: "Amorphous samples",
        compute: |setting| amorphous::chapter(setting),
    },
    Chapter {
        name: "junction",
        about: "sheared junctions, Section 4",
        title: "Junctions",
        compute: |setting| junction::chapter(setting),
    },
];

/// The material of the patch tests (Table 4), in any coherent units.
pub fn patch_material(poisson_ratio: f64, scaling: f64) -> Material {
    Material {
        young_modulus: 1.0,
        poisson_ratio,
        tensile_strength: 0.2,
        shear_strength: 0.1,
        surface_energy: 1.5,
        restitution: 0.95,
        scaling,
        forget_stretched_springs: false,
    }
}

/// The density of the patch tests.
pub const PATCH_DENSITY: f64 = 1.0;

/// Amorphous silica (Table 5) in engine units: MPa, and mN/m for the surface energy.
pub fn silica() -> Material {
    Material {
        young_modulus: 73e3,
        poisson_ratio: 0.17,
        tensile_strength: 16e3,
        shear_strength: 9e3,
        surface_energy: 1500.0,
        restitution: 0.9,
        scaling: 0.5,
        forget_stretched_springs: false,
    }
}

/// The density of silica, ag/nm^3.
pub const SILICA_DENSITY: f64 = 2.2e-3;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::near;

    #[test]
    fn silica_in_engine_units_has_the_wave_velocity_and_critical_diameter_of_the_paper() {
        use crate::spec::wear::eq18_critical_diameter::critical_diameter;
        use crate::spec::wear::eq22_critical_length::wave_velocity;
        let material = silica();
        assert!(near(wave_velocity(material.young_modulus, SILICA_DENSITY), 5760.4, 1e-4));
        let d_c = critical_diameter(material.surface_energy, material.young_modulus, material.tensile_strength);
        assert!(near(d_c, 1.7109, 1e-4));
    }
}
