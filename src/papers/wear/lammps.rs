//! The contact law as a pair style of LAMMPS with the plugin of `bindings/lammps`.

use super::case::Readings;
use crate::case::springs::Transport;
use crate::spec::wear::{Interaction, Material, Wear};

/// The style: its name and its keys with their values in nm, ns and ag.
pub(super) fn pair_style(Wear { material, interaction }: &Wear, readings: Readings, springs: Transport) -> String {
    let Material {
        young_modulus,
        poisson_ratio,
        tensile_strength,
        shear_strength,
        surface_energy,
        restitution,
        scaling,
        forget_stretched_springs,
    } = material;
    let interaction = match interaction {
        Interaction::Full => "full",
        Interaction::Normal => "normal",
        Interaction::Repulsive => "repulsive",
    };
    format!(
        "wear young_modulus {young_modulus} poisson_ratio {poisson_ratio} tensile_strength {tensile_strength} \
         shear_strength {shear_strength} surface_energy {surface_energy} restitution {restitution} scaling {scaling} \
         interaction {interaction} readings {readings} forget_stretched_springs {forget_stretched_springs} springs {springs}"
    )
}
