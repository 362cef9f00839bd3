//! Checks of a case of the wear paper beyond its grammar.

use super::case::{Case, Deformation, Experiment, Readings, Sample, Sliding};
use super::derived::{Critical, Scales, dampings, material, spheres, time_steps};
use crate::case::check::{Found, expect};
use crate::case::springs::Transport;
use crate::case::units::{decimal, in_unit, rounded};
use crate::spec::wear::eq19_minimum_diameter::minimum_diameter;

/// Checks a case.
pub(super) fn problems(case: &Case, found: &mut Found) {
    properties(case, found);
    sample(case, found);
    if found.is_empty() {
        // Scales follow from the material and the sample, which must be valid first.
        experiment(case, found);
        stepping(case, found);
    }
}

/// Finds values that are accepted but may not mean what their author thinks.
pub(super) fn doubts(case: &Case, found: &mut Found) {
    let (scales, own) = (Scales::of(case), material(case));
    let d_min = minimum_diameter(own.surface_energy.value, own.tensile_strength.value);
    let (section, smallest) = match &case.sample {
        Sample::Hcp(_) => ("sample.hcp.diameter", "the diameter"),
        Sample::Amorphous(_) => ("sample.amorphous.smallest", "the smallest diameter"),
    };
    let below = format!("{smallest}, {}, is below d_min = {}", in_unit(scales.d_s, "nm"), in_unit(d_min, "nm"));
    let why = "(Eq. 19): such spheres cannot have the surface energy and the strength that the case asks for";
    if scales.d_s < d_min {
        found.push((section.into(), format!("{below} {why}")));
    }
    let modulus = own.young_modulus.value;
    let loads = match &case.experiment {
        Experiment::Patch(patch) => {
            patch.compression.as_ref().map(|test| ("experiment.patch.compression.stress", test.stress.value(modulus)))
        }
        Experiment::Junction(junction) => {
            Some(("experiment.junction.normal_stress", junction.normal_stress.value(modulus)))
        }
        Experiment::Sliding(sliding) => {
            Some(("experiment.sliding.normal_stress", sliding.normal_stress.value(modulus)))
        }
    };
    let strength = own.tensile_strength.value;
    for (key, load) in loads.into_iter().filter(|(_, load)| *load > strength) {
        let [load, strength] = [load, strength].map(|stress| in_unit(stress, "GPa"));
        found.push((key.into(), format!("the load, {load}, is beyond the tensile strength, {strength}")));
    }
}

fn properties(case: &Case, found: &mut Found) {
    let m = material(case);
    let at = |key: &str| format!("model.wear.{key}");
    for (key, value, text) in [
        ("young_modulus", m.young_modulus.value, m.young_modulus.to_string()),
        ("tensile_strength", m.tensile_strength.value, m.tensile_strength.to_string()),
        ("shear_strength", m.shear_strength.value, m.shear_strength.to_string()),
        ("surface_energy", m.surface_energy.value, m.surface_energy.to_string()),
        ("density", m.density.value, m.density.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    let nu = m.poisson_ratio;
    let limit = "more than -1 and at most 1/4: above 1/4 the tangential stiffness would be negative";
    expect(found, nu > -1.0 && nu <= 0.25, &at("poisson_ratio"), decimal(nu), limit);
    expect(found, (0.0..=1.0).contains(&m.restitution), &at("restitution"), decimal(m.restitution), "0 to 1");
    let projects = m.readings == Readings::Own || m.springs == Transport::Projected;
    expect(found, projects, &at("springs"), "carried", "`projected` with `readings: as-published`");
    expect(found, m.scaling >= 0.0 && m.scaling.is_finite(), &at("scaling"), decimal(m.scaling), "zero or more");
}

fn sample(case: &Case, found: &mut Found) {
    let (section, diameter, size) = match &case.sample {
        Sample::Hcp(hcp) => ("sample.hcp", &hcp.diameter, &hcp.size),
        Sample::Amorphous(amorphous) => ("sample.amorphous", &amorphous.diameter, &amorphous.size),
    };
    expect(found, diameter.number() > 0.0, &format!("{section}.diameter"), diameter, "more than zero");
    for (axis, side) in size.iter().enumerate() {
        expect(found, side.number() > 0.0, &format!("{section}.size[{axis}]"), side, "more than zero");
    }
    let Sample::Amorphous(a) = &case.sample else { return };
    let at = |key: &str| format!("{section}.{key}");
    expect(found, a.smallest.number() > 0.0, &at("smallest"), &a.smallest, "more than zero");
    let phi = a.volume_fraction;
    let dense = "0.5 to 1: looser spheres do not become a solid";
    expect(found, (0.5..=1.0).contains(&phi), &at("volume_fraction"), decimal(phi), dense);
    let relaxation = &a.relaxation;
    let stress = &relaxation.residual_stress;
    expect(found, stress.number() > 0.0, &at("relaxation.residual_stress"), stress, "more than zero");
    for (key, steps) in [("repulsion_steps", relaxation.repulsion_steps), ("max_steps", relaxation.max_steps)] {
        expect(found, steps > 0, &at(&format!("relaxation.{key}")), steps, "at least 1");
    }
    if found.is_empty() {
        let Scales { d_0, d_s, d_l, size, .. } = Scales::of(case);
        let nm = |d: f64| in_unit(d, "nm");
        expect(
            found,
            d_s <= d_0,
            &at("smallest"),
            &a.smallest,
            &format!("at most the most frequent diameter, {}", nm(d_0)),
        );
        expect(
            found,
            d_l >= d_0,
            &at("largest"),
            &a.largest,
            &format!("at least the most frequent diameter, {}", nm(d_0)),
        );
        for (axis, side) in size.into_iter().enumerate() {
            let least = format!("at least twice the largest diameter, {}", nm(2.0 * d_l));
            expect(found, side >= 2.0 * d_l, &at(&format!("size[{axis}]")), &a.size[axis], &least);
        }
    }
    if found.is_empty() {
        let number = spheres(case);
        expect(found, number <= MOST, &at("size"), format!("{number:.1e} spheres"), &format!("at most {MOST:.0e}"));
    }
}

/// Largest number of spheres of a sample, whose ids have 32 bits.
const MOST: f64 = 4e9;

fn experiment(case: &Case, found: &mut Found) {
    let Scales { size: [length, height, depth], walls, d_0, .. } = Scales::of(case);
    let nm = |d: f64| in_unit(d, "nm");
    let thick = format!("at least half the most frequent diameter, {}: a thinner wall has no spheres", nm(0.5 * d_0));
    match &case.experiment {
        Experiment::Patch(patch) => {
            let key = "experiment.patch.walls";
            expect(found, walls >= 0.5 * d_0, key, &patch.walls, &thick);
            let room = format!("at most {}, which leaves a diameter between the walls", nm(0.5 * (height - d_0)));
            expect(found, walls <= 0.5 * (height - d_0), key, &patch.walls, &room);
            if patch.compression.is_none() && patch.tension.is_none() && patch.shear.is_none() {
                let what = "expected at least one of the keys `compression`, `tension`, `shear`";
                found.push(("experiment.patch".into(), what.into()));
            }
            for (name, test) in [("tension", &patch.tension), ("shear", &patch.shear)] {
                let Some(Deformation { strain_per_step, strain, .. }) = test else { continue };
                let at = |key: &str| format!("experiment.patch.{name}.{key}");
                let small = *strain_per_step > 0.0 && *strain_per_step < 1e-2;
                expect(
                    found,
                    small,
                    &at("strain_per_step"),
                    decimal(*strain_per_step),
                    "more than 0 and less than 0.01",
                );
                expect(found, *strain > 0.0, &at("strain"), decimal(*strain), "more than zero");
            }
            if let Some(test) = &patch.compression {
                let at = |key: &str| format!("experiment.patch.compression.{key}");
                expect(found, test.stress.number() > 0.0, &at("stress"), &test.stress, "more than zero");
                expect(found, test.duration.number() > 0.0, &at("duration"), &test.duration, "more than zero");
            }
        }
        Experiment::Junction(junction) => {
            let at = |key: &str| format!("experiment.junction.{key}");
            let d = junction.diameter.value;
            expect(found, d > 0.0, &at("diameter"), &junction.diameter, "more than zero");
            let width = length.min(depth);
            let fits = format!("less than the width of the box, {}", nm(width));
            expect(found, d < width, &at("diameter"), &junction.diameter, &fits);
            let bodies = junction.height.value(d) + 2.0 * walls;
            expect(found, junction.height.number() > 0.0, &at("height"), &junction.height, "more than zero");
            let fits = format!("a height that fits between the walls in the box of height {}", nm(height));
            expect(found, bodies < height, &at("height"), &junction.height, &fits);
            expect(found, walls >= 0.5 * d_0, &at("walls"), &junction.walls, &thick);
            expect(found, junction.duration.number() > 0.0, &at("duration"), &junction.duration, "more than zero");
        }
        Experiment::Sliding(sliding) => {
            let at = |key: &str| format!("experiment.sliding.{key}");
            let Sliding { asperities, asperity_height, shear_velocity, window, duration, .. } = sliding;
            let most = (length / (2.0 * d_0)).floor();
            let each = format!("1 to {most}, each at least two of the most frequent diameters long");
            expect(found, *asperities >= 1 && *asperities as f64 <= most, &at("asperities"), asperities, &each);
            let (least, gap) = (asperity_height.number() >= 0.0, 2.0 * asperity_height.value(d_0));
            expect(found, least, &at("asperity_height"), asperity_height, "zero or more");
            let fits = format!("asperities that fit between the walls in the box of height {}", nm(height));
            expect(found, gap + 2.0 * walls < height, &at("asperity_height"), asperity_height, &fits);
            expect(found, walls >= 0.5 * d_0, &at("walls"), &sliding.walls, &thick);
            expect(found, shear_velocity.value > 0.0, &at("shear_velocity"), shear_velocity, "more than zero");
            expect(found, duration.number() > 0.0, &at("duration"), duration, "more than zero");
            expect(found, window.number() > 0.0, &at("window"), window, "more than zero");
        }
    }
}

fn stepping(case: &Case, found: &mut Found) {
    let critical = Critical::of_case(case);
    for (key, dt) in time_steps(case) {
        let limit = format!(
            "more than zero and less than the stability limit {} ({} dt_c)",
            in_unit(critical.limit, "fs"),
            rounded(critical.limit / critical.dt)
        );
        let value = dt.value(critical.dt);
        expect(found, value > 0.0 && value < critical.limit, key, dt, &limit);
    }
    for (key, damping) in dampings(case) {
        expect(found, damping.number() >= 0.0, key, damping, "zero or more");
    }
}
