//! The contact law as a pair style of LAMMPS with the plugin of `bindings/lammps`.

use super::case;
use crate::spec::Flat;
use crate::spec::titania::eq02_torque::Arms;
use crate::spec::titania::eq03_attraction::Solvation;
use crate::spec::titania::eq07_damping_coefficient::DampingRadius;
use crate::spec::titania::eq09_stiffness::Stiffness;
use crate::spec::titania::eq12_sliding::Slip;
use crate::spec::titania::eq13_rolling::{Rolling, RollingOver};
use crate::spec::titania::{Liquid, Meniscus, Titania};

/// The style: its name and its keys with their values in nm, ns and ag.
pub(super) fn pair_style(case: &case::Titania) -> String {
    let law = case.law();
    let Titania { core_gap, h_n, humidity, contact_angle, f_00, f_01, sigma, gamma_0, tau_s, tau_r, lambda_t, .. } =
        law;
    let liquid = match law.liquid {
        Liquid::Other { gamma, h_w } => format!("liquid {gamma} {} {h_w}", law.thermal_pressure),
        Liquid::Water { scale } => {
            let tension = if scale == 1.0 { "tip3p" } else { "experimental" };
            format!("temperature {} surface_tension {tension}", case.temperature.value)
        }
    };
    let meniscus = match law.meniscus {
        Meniscus::Circular => "circular",
        Meniscus::Exact => "exact",
    };
    let solvation = match law.solvation {
        Solvation::Israelachvili => "israelachvili",
        Solvation::Printed => "printed",
    };
    let slip = match law.slip {
        Slip::Reset => "reset",
        Slip::Remainder => "remainder",
    };
    let stiffness = match law.stiffness {
        Stiffness::PerPair => "pair",
        Stiffness::PerSize => "size",
    };
    let arms = match law.arms {
        Arms::HalfGap => "half-gap",
        Arms::HalfLayer => "half-layer",
    };
    let rolling = match law.rolling {
        Rolling::Stopping => "stopping",
        Rolling::Unlimited => "unlimited",
    };
    let over = match law.rolling_over {
        RollingOver::Rolling => "rolling",
        RollingOver::Spin => "spin",
    };
    let radius = match law.damping_radius {
        DampingRadius::Bare => "bare",
        DampingRadius::Contact => "contact",
    };
    let necks = case.neck_springs.as_ref().map_or(String::new(), |springs| {
        let springs = springs.spec();
        format!(" neck_springs{}", (0..8).map(|k| format!(" {}", springs.at(k))).collect::<String>())
    });
    let energy = case.break_energy.as_ref().map_or(String::new(), |energy| format!(" break_energy {}", energy.value));
    format!(
        "titania {liquid} humidity {humidity} contact_angle {contact_angle} meniscus {meniscus} core_gap {core_gap} layer {h_n} solvation {solvation} \
         solvation_force {f_00} solvation_growth {f_01} solvation_period {sigma} damping_constant {gamma_0} \
         damping_radius {radius} sliding_strength {tau_s} rolling_strength {tau_r} slip_period {lambda_t} slip {slip} \
         contact_stiffness {stiffness} moment_arms {arms} rolling {rolling} rolling_over {over} springs {}{necks}{energy}",
        case.springs
    )
}
