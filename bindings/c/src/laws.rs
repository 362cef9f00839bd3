//! The contact laws by name, with the keys of a case file. Numbers are in nm, ns and ag, hence pN, zJ, MPa and mN/m.

use crate::error::{Done, wrong};
use crate::law::{Breaks, Law, Of};
use crate::words::{Key, Values, Words};
use std::sync::Arc;
use veridem_spec::mechanics::four_springs::{Friction, Springs};
use veridem_spec::soot::{self, Along, Following, Lagging, Printed, Programmed, Reading, Soot};
use veridem_spec::titania::eq02_torque::Arms;
use veridem_spec::titania::eq03_attraction::Solvation;
use veridem_spec::titania::eq07_damping_coefficient::DampingRadius;
use veridem_spec::titania::eq09_stiffness::Stiffness;
use veridem_spec::titania::eq12_sliding::Slip;
use veridem_spec::titania::eq13_rolling::{Rolling, RollingOver};
use veridem_spec::titania::{Liquid, Meniscus, Tabulated, Titania};
use veridem_spec::wear::{Interaction, Material, Published, Wear};
use veridem_spec::{Carried, Flat, Necked, Turns};

/// The law of this name. For `titania`, `radii` are those of all spheres, in ascending order: the attraction of every two is tabulated.
pub(crate) fn named(name: &str, words: &[&str], radii: &[f64]) -> Done<Box<dyn Law>> {
    match name {
        "wear" => wear(&Words::parse("wear", WEAR, words)?),
        "soot" => soot(&Words::parse("soot", SOOT, words)?),
        "titania" => titania(&Words::parse("titania", TITANIA, words)?, radii),
        _ => wrong(format!("found the law `{name}`, expected `wear`, `soot` or `titania`")),
    }
}

const ABOVE: Values = Values::Numbers(1, "> 0");
const NOT_BELOW: Values = Values::Numbers(1, ">= 0");
const SPRINGS: Values = Values::Numbers(8, ">= 0");

const WEAR: &[Key] = &[
    ("young_modulus", ABOVE),
    ("poisson_ratio", Values::Numbers(1, "(-1, 0.25]")),
    ("tensile_strength", ABOVE),
    ("shear_strength", NOT_BELOW),
    ("surface_energy", ABOVE),
    ("restitution", Values::Numbers(1, "[0, 1]")),
    ("scaling", NOT_BELOW),
    ("interaction", Values::OneOf(&["full", "normal", "repulsive"])),
    ("readings", Values::OneOf(&["own", "as-published"])),
    ("forget_stretched_springs", Values::OneOf(&["false", "true"])),
    ("springs", Values::OneOf(&["projected", "carried"])),
];

fn wear(words: &Words) -> Done<Box<dyn Law>> {
    let as_published = words.choice("readings")? == 1;
    let material = Material {
        young_modulus: words.required("young_modulus")?,
        poisson_ratio: words.required("poisson_ratio")?,
        tensile_strength: words.required("tensile_strength")?,
        shear_strength: words.required("shear_strength")?,
        surface_energy: words.required("surface_energy")?,
        restitution: words.required("restitution")?,
        scaling: words.required("scaling")?,
        forget_stretched_springs: as_published || words.choice("forget_stretched_springs")? == 1,
    };
    let interaction = [Interaction::Full, Interaction::Normal, Interaction::Repulsive][words.choice("interaction")?];
    let law = Wear { material, interaction };
    let forgets = material.forget_stretched_springs;
    Ok(match (as_published, words.choice("springs")? == 1) {
        (false, false) => Of::forgetting(law, forgets),
        (false, true) => Of::forgetting(Carried(law), forgets),
        (true, false) => Of::forgetting(Published(law), forgets),
        (true, true) => {
            return wrong("wear: found `springs carried`, expected `projected` with `readings as-published`");
        }
    })
}

const SOOT: &[Key] = &[
    ("neck_springs", SPRINGS),
    ("contact", SPRINGS),
    ("friction_at_rest", Values::Numbers(3, ">= 0")),
    ("friction_in_motion", Values::Numbers(3, ">= 0")),
    ("hamaker_constant", NOT_BELOW),
    ("substrate_hamaker_constant", NOT_BELOW),
    ("tip_hamaker_constant", NOT_BELOW),
    ("saturation", ABOVE),
    ("capillary_force", NOT_BELOW),
    ("capillary_reach", ABOVE),
    ("capillary_sharpness", ABOVE),
    ("cutoff", ABOVE),
    ("break_energy", ABOVE),
    ("break_stress", Values::Numbers(3, "> 0")),
    ("torsion", Values::OneOf(&["spring", "as-printed", "as-published"])),
    ("springs_act", Values::OneOf(&["after-stretching", "before-stretching"])),
    ("springs", Values::OneOf(&["projected", "carried"])),
];

fn springs(words: &Words, key: &str) -> Done<Springs<f64>> {
    match words.numbers::<8>(key)? {
        Some(numbers) => Ok(Springs::from_fn(|k| numbers[k])),
        None => wrong(format!("`{key}` is missing: four stiffnesses and four damping coefficients")),
    }
}

fn soot(words: &Words) -> Done<Box<dyn Law>> {
    let contact = springs(words, "contact")?;
    let at_rest = words.numbers::<3>("friction_at_rest")?.unwrap_or([1.0, 0.1, 0.1]);
    let in_motion = words.numbers::<3>("friction_in_motion")?.unwrap_or(at_rest);
    let friction = Friction::from_fn(|k| if k < 3 { at_rest[k] } else { in_motion[k - 3] });
    let (delta_0, cutoff) = (words.number("saturation", 1.0)?, words.number("cutoff", 70.0)?);
    let wall = |hamaker| soot::Wall { contact, friction, hamaker, delta_0, cutoff };
    let law = Soot {
        neck: springs(words, "neck_springs")?,
        contact,
        friction,
        attraction: soot::Attraction {
            a: words.number("hamaker_constant", 100.0)?,
            delta_0,
            psi: words.number("capillary_force", 0.0)?,
            kappa: words.number("capillary_sharpness", 0.178571429)?,
            d_cutoff: words.number("capillary_reach", 56.0)?,
            cutoff,
        },
        reading: (),
        walls: [
            wall(words.number("substrate_hamaker_constant", 100.0)?),
            wall(words.number("tip_hamaker_constant", 1000.0)?),
        ],
    };
    let energy = words.numbers("break_energy")?.map(|[energy]| energy);
    let strength = soot::Strength { energy, stress: words.numbers("break_stress")? };
    Ok(match (words.choice("torsion")?, words.choice("springs_act")?) {
        (0, 0) if words.choice("springs")? == 1 => breaking(read(law, Following), strength),
        _ if words.choice("springs")? == 1 => {
            return wrong(
                "soot: found `springs carried`, expected `torsion spring` and `springs_act after-stretching` beside it",
            );
        }
        (0, 0) => breaking(read(law, Along), strength),
        (0, _) => breaking(read(law, Lagging), strength),
        (1, 0) => breaking(read(law, Printed), strength),
        _ => breaking(read(law, Programmed), strength),
    })
}

/// The same with springs read in some way.
fn read<S>(law: Soot<()>, reading: S) -> Soot<S> {
    let Soot { neck, contact, friction, attraction, walls, reading: () } = law;
    Soot { neck, contact, friction, attraction, walls, reading }
}

/// The law with necks of this strength.
fn breaking<S: Reading + 'static>(law: Soot<S>, strength: soot::Strength) -> Box<dyn Law> {
    let breaks =
        move |law: &Soot<S>, contact: &_, memory: &_, held: &_| law.neck_breaks(contact, memory, held, &strength);
    Of::breaking(law, (strength != soot::Strength::default()).then(|| Arc::new(breaks) as _))
}

const TITANIA: &[Key] = &[
    ("humidity", Values::Numbers(1, "(0, 1)")),
    ("temperature", ABOVE),
    ("surface_tension", Values::OneOf(&["experimental", "tip3p"])),
    ("liquid", Values::Numbers(3, "> 0")),
    ("contact_angle", NOT_BELOW),
    ("meniscus", Values::OneOf(&["circular", "exact"])),
    ("core_gap", ABOVE),
    ("layer", ABOVE),
    ("solvation", Values::OneOf(&["israelachvili", "printed"])),
    ("solvation_force", Values::Numbers(1, "any")),
    ("solvation_growth", Values::Numbers(1, "any")),
    ("solvation_period", ABOVE),
    ("damping_constant", NOT_BELOW),
    ("damping_radius", Values::OneOf(&["bare", "contact"])),
    ("sliding_strength", NOT_BELOW),
    ("rolling_strength", NOT_BELOW),
    ("slip_period", ABOVE),
    ("slip", Values::OneOf(&["reset", "remainder"])),
    ("contact_stiffness", Values::OneOf(&["pair", "size"])),
    ("moment_arms", Values::OneOf(&["half-gap", "half-layer"])),
    ("rolling", Values::OneOf(&["stopping", "unlimited"])),
    ("rolling_over", Values::OneOf(&["rolling", "spin"])),
    ("springs", Values::OneOf(&["projected", "carried"])),
    ("neck_springs", SPRINGS),
    ("break_energy", ABOVE),
];

/// Largest error of the tables of the attraction, pN.
const TOLERANCE: f64 = 0.1;

fn titania(words: &Words, radii: &[f64]) -> Done<Box<dyn Law>> {
    let paper = Titania::paper(1.0, 1e3, 1.0);
    let megapascal = 1e-6;
    let (mut liquid, mut thermal_pressure) = (paper.liquid, paper.thermal_pressure);
    if let Some([temperature]) = words.numbers("temperature")? {
        thermal_pressure = Titania::thermal_pressure_of_water(temperature) * megapascal;
    }
    if words.choice("surface_tension")? == 1 {
        liquid = Liquid::Water { scale: 1.0 };
    }
    // Surface tension, thermal energy per volume of a molecule, thickness of the layer.
    if let Some([gamma, pressure, h_w]) = words.numbers("liquid")? {
        (liquid, thermal_pressure) = (Liquid::Other { gamma, h_w }, pressure);
    }
    let law = Titania {
        core_gap: words.number("core_gap", paper.core_gap)?,
        h_n: words.number("layer", paper.h_n)?,
        humidity: words.number("humidity", paper.humidity)?,
        thermal_pressure,
        contact_angle: words.number("contact_angle", paper.contact_angle)?,
        meniscus: [Meniscus::Circular, Meniscus::Exact][words.choice("meniscus")?],
        liquid,
        solvation: [Solvation::Israelachvili, Solvation::Printed][words.choice("solvation")?],
        f_00: words.number("solvation_force", paper.f_00)?,
        f_01: words.number("solvation_growth", paper.f_01)?,
        sigma: words.number("solvation_period", paper.sigma)?,
        gamma_0: words.number("damping_constant", paper.gamma_0)?,
        tau_s: words.number("sliding_strength", paper.tau_s)?,
        tau_r: words.number("rolling_strength", paper.tau_r)?,
        lambda_t: words.number("slip_period", paper.lambda_t)?,
        slip: [Slip::Reset, Slip::Remainder][words.choice("slip")?],
        stiffness: [Stiffness::PerPair, Stiffness::PerSize][words.choice("contact_stiffness")?],
        arms: [Arms::HalfGap, Arms::HalfLayer][words.choice("moment_arms")?],
        rolling: [Rolling::Stopping, Rolling::Unlimited][words.choice("rolling")?],
        rolling_over: [RollingOver::Rolling, RollingOver::Spin][words.choice("rolling_over")?],
        damping_radius: [DampingRadius::Bare, DampingRadius::Contact][words.choice("damping_radius")?],
        ..paper
    };
    if let Some(r) = radii.iter().find(|&&r| r <= law.h_n) {
        return wrong(format!("titania: found a sphere of radius {r}, expected more than the layer of {}", law.h_n));
    }
    // The spheres of the contact law overlap at rest by the layers on both.
    let (neck, layer) = (words.numbers("neck_springs")?, law.h_n - 0.5 * law.core_gap);
    let energy = words.numbers("break_energy")?.map(|[energy]| energy);
    if energy.is_some() && neck.is_none() {
        return wrong("titania: found `break_energy`, expected `neck_springs` beside it");
    }
    let carried = words.choice("springs")? == 1;
    Ok(match radii {
        [] => necked(law, neck, layer, energy, carried),
        radii => necked(Tabulated::new(law, radii, TOLERANCE), neck, layer, energy, carried),
    })
}

/// The law with necks of these springs, if there are any, that break at this energy, if they do, and with springs that may follow a pair which spins.
fn necked<M: Turns + Send + 'static>(
    law: M,
    neck: Option<[f64; 8]>,
    layer: f64,
    energy: Option<f64>,
    carried: bool,
) -> Box<dyn Law> {
    let Some(neck) = neck else { return if carried { Of::boxed(Carried(law)) } else { Of::boxed(law) } };
    let law = Necked { law, neck: Springs::from_fn(|k| neck[k]), layer };
    if carried {
        let breaks = |energy| {
            Arc::new(move |_: &_, _: &_, _: &_, held: &_| Necked::<M>::neck_breaks(held, energy)) as Breaks<Carried<_>>
        };
        return Of::breaking(Carried(law), energy.map(breaks));
    }
    let breaks =
        |energy| Arc::new(move |_: &_, _: &_, _: &_, held: &_| Necked::<M>::neck_breaks(held, energy)) as Breaks<_>;
    Of::breaking(law, energy.map(breaks))
}
