//! What a case of the soot paper must satisfy beyond its grammar.

use super::{Found, belongs, expect};
use crate::case::units::{decimal, in_unit};
use crate::case::{Case, Experiment, FourSprings, Sample, Soot};

/// All that is wrong with a case of the soot paper.
pub fn problems(case: &Case, found: &mut Found) {
    let Some((soot, sample, test)) = case.soot() else {
        let (sampled, tested) =
            (matches!(case.sample, Sample::Aggregate(_)), matches!(case.experiment, Experiment::Restructuring(_)));
        belongs(found, sampled, "sample", "`aggregate`", "soot");
        belongs(found, tested, "experiment", "`restructuring`", "soot");
        return;
    };
    interactions(soot, found);
    let at = |key: &str| format!("sample.aggregate.{key}");
    let r = sample.radius.value;
    expect(found, sample.spheres > 0, &at("spheres"), sample.spheres, "at least 1");
    expect(found, r > 0.0, &at("radius"), &sample.radius, "more than zero");
    let dimension = sample.fractal_dimension;
    expect(found, (1.0..=3.0).contains(&dimension), &at("fractal_dimension"), decimal(dimension), "1 to 3");
    expect(found, sample.prefactor > 0.0, &at("prefactor"), decimal(sample.prefactor), "more than zero");
    let deviation = sample.deviation;
    expect(found, deviation >= 1.0 && deviation.is_finite(), &at("deviation"), decimal(deviation), "at least 1");
    let fraction = sample.neck_fraction;
    expect(found, (0.0..=1.0).contains(&fraction), &at("neck_fraction"), decimal(fraction), "0 to 1");
    let distance = &sample.neck_distance;
    expect(found, distance.value > 0.0, &at("neck_distance"), distance, "more than zero");
    if found.is_empty() {
        let least = format!("more than the distance of two touching spheres, {}", in_unit(2.0 * r, "nm"));
        expect(found, soot.cutoff.value > 2.0 * r, "model.soot.cutoff", &soot.cutoff, &least);
        let limit = case.soot_step_limit();
        let text = format!("more than zero and less than the stability limit {}", in_unit(limit, "fs"));
        let dt = test.dt.value;
        expect(found, dt > 0.0 && dt < limit, "experiment.restructuring.dt", &test.dt, &text);
        let duration = &test.duration;
        expect(found, duration.number() > 0.0, "experiment.restructuring.duration", duration, "more than zero");
    }
}

fn interactions(soot: &Soot, found: &mut Found) {
    let at = |key: &str| format!("model.soot.{key}");
    for (key, value, text) in [
        ("density", soot.density.value, soot.density.to_string()),
        ("saturation", soot.saturation.value, soot.saturation.to_string()),
        ("capillary_reach", soot.capillary_reach.value, soot.capillary_reach.to_string()),
        ("capillary_sharpness", soot.capillary_sharpness.value, soot.capillary_sharpness.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    for (key, value, text) in [
        ("hamaker_constant", soot.hamaker_constant.value, soot.hamaker_constant.to_string()),
        ("capillary_force", soot.capillary_force.value, soot.capillary_force.to_string()),
    ] {
        expect(found, value >= 0.0, &at(key), text, "zero or more");
    }
    for (motion, (rest, moving)) in soot.friction.at_rest.iter().zip(soot.friction.in_motion).enumerate() {
        let key = |name: &str| at(&format!("friction.{name}[{motion}]"));
        expect(found, *rest >= 0.0, &key("at_rest"), decimal(*rest), "zero or more");
        let most = format!("zero or more and at most that at rest, {}", decimal(*rest));
        expect(found, (0.0..=*rest).contains(&moving), &key("in_motion"), decimal(moving), &most);
    }
    springs(&soot.contact, "contact", found);
    if let Some(neck) = &soot.neck_springs {
        springs(neck, "neck_springs", found);
    }
}

fn springs(springs: &FourSprings, section: &str, found: &mut Found) {
    let at = |key: &str| format!("model.soot.{section}.{key}");
    for (key, stiffness) in [
        ("normal_stiffness", &springs.normal_stiffness),
        ("tangential_stiffness", &springs.tangential_stiffness),
        ("rolling_stiffness", &springs.rolling_stiffness),
        ("torsional_stiffness", &springs.torsional_stiffness),
    ] {
        expect(found, stiffness.value > 0.0, &at(key), stiffness, "more than zero");
    }
    for (key, damping) in [
        ("normal_damping", &springs.normal_damping),
        ("tangential_damping", &springs.tangential_damping),
        ("rolling_damping", &springs.rolling_damping),
        ("torsional_damping", &springs.torsional_damping),
    ] {
        expect(found, damping.value >= 0.0, &at(key), damping, "zero or more");
    }
}
