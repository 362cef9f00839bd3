//! The contact law as a pair style of LAMMPS with the plugin of `bindings/lammps`.

use super::case;
use crate::spec::mechanics::four_springs::{Friction, Springs};
use crate::spec::{Flat, soot};

/// The style: its name and its keys with their values in nm, ns and ag.
pub(super) fn pair_style<S>(case: &case::Soot, law: &soot::Soot<S>) -> String {
    let numbers = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let springs = |springs: &Springs<f64>| numbers(&(0..8).map(|k| *springs.at(k)).collect::<Vec<_>>());
    let Friction { static_t, static_r, static_o, dynamic_t, dynamic_r, dynamic_o } = law.friction;
    let soot::Attraction { a, delta_0, psi, kappa, d_cutoff, cutoff } = law.attraction;
    let (torsion, order, transport) = (case.torsion, case.springs_act, case.springs);
    let soot::Strength { energy, stress } = case.strength();
    let energy = energy.map_or(String::new(), |energy| format!(" break_energy {energy}"));
    let stress = stress.map_or(String::new(), |stress| format!(" break_stress {}", numbers(&stress)));
    let [substrate, tip] = law.walls.map(|wall| wall.hamaker);
    format!(
        "soot neck_springs {} contact {} friction_at_rest {} friction_in_motion {} hamaker_constant {a} \
         substrate_hamaker_constant {substrate} tip_hamaker_constant {tip} saturation {delta_0} capillary_force {psi} \
         capillary_sharpness {kappa} capillary_reach {d_cutoff} cutoff {cutoff} torsion {torsion} springs_act {order} springs {transport}{energy}{stress}",
        springs(&law.neck),
        springs(&law.contact),
        numbers(&[static_t, static_r, static_o]),
        numbers(&[dynamic_t, dynamic_r, dynamic_o]),
    )
}
