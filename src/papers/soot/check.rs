//! Checks of a case of the soot paper beyond its grammar.

use super::case::{
    Aggregate, Case, Deposition, Experiment, Indentation, Model, NeckStrength, NeckStrengths, NormalStrengths, Path,
    Restructuring, Solid, Soot, SootStage, Torsion, TwoSpheres, WeibullStrengths, key, parts, path,
};
use crate::case::check::{Found, expect};
use crate::case::springs::{Transport, necks, springs};
use crate::case::units::{decimal, in_unit};
use crate::papers::path::legs;
use crate::spec::soot::eq24_fractal::gyration_radius;

/// Lower bound, for three to a few hundred equal spheres, of the radius of gyration over radius and cube root of their number: 0.77 for four spheres and for twelve around one, 0.86 for an infinite close packing.
const DENSEST: f64 = 0.77;

/// Largest number of spheres of an aggregate: a few gigabytes of memory.
const MOST: u64 = 10_000_000;

/// Checks a case of the soot paper.
pub fn problems(case: &Case, found: &mut Found) {
    let Model::Soot(soot) = &case.model;
    interactions(soot, found);
    if let Some((_, pair, path)) = path(case) {
        return of_pair(soot, pair, path, found);
    }
    let Some((_, sample, stages)): Option<(_, &Aggregate, _)> = parts(case) else {
        let sample = if matches!(case.experiment, Experiment::Path(_)) { "`pair`" } else { "`aggregate`" };
        return found.push(("sample".into(), format!("expected {sample} for this experiment")));
    };
    let at = |key: &str| format!("sample.aggregate.{key}");
    let r = sample.radius.value;
    let most = format!("1 to {MOST}");
    expect(found, (1..=MOST).contains(&sample.spheres), &at("spheres"), sample.spheres, &most);
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
    let energy = sample.initial_energy;
    expect(found, energy >= 0.0 && energy.is_finite(), &at("initial_energy"), decimal(energy), "zero or more");
    if found.is_empty() && sample.radii() == Some([r, r]) {
        let number = sample.spheres as f64;
        let (wanted, least) = (gyration_radius(sample.prefactor, number, r, dimension), DENSEST * r * number.cbrt());
        let what = format!("a prefactor with which the radius of gyration is at least {}", in_unit(least, "nm"));
        expect(found, wanted >= least || number < 3.0, &at("prefactor"), decimal(sample.prefactor), &what);
    }
    if found.is_empty() {
        expect(found, !stages.is_empty(), "experiment.sequence", "nothing", "at least one stage");
        let mut deposited = sample.deposited.is_some() || sample.on_substrate;
        if sample.on_substrate && (sample.import.is_none() || sample.deposited.is_some()) {
            let what = "expected an `import` beside it, and no `deposited`: it is about the spheres of a file";
            found.push((at("on_substrate"), what.into()));
        }
        for (number, stage) in stages.iter().enumerate() {
            let key = key(case, number, stage);
            self::stage(stage, &key, found);
            let follows = deposited || !matches!(stage, SootStage::Indentation(_));
            expect(found, follows, &key, "an indentation", "a deposition before it");
            let deposits = matches!(stage, SootStage::Deposition(_));
            if sample.on_substrate && deposits {
                found.push((key.clone(), "expected no deposition of an aggregate that lies `on_substrate`".into()));
            }
            deposited |= deposits;
        }
        if let Some(radii) = sample.radii() {
            let keys = stages.iter().enumerate().map(|(number, stage)| (stage, key(case, number, stage)));
            sized(soot, radii, keys, found);
        }
    }
}

fn of_pair(soot: &Soot, pair: &TwoSpheres, path: &Path, found: &mut Found) {
    if soot.strengths_file().is_some() {
        found.push(("model.soot.neck_strengths".into(), "expected `weibull` or `normal` for a single neck".into()));
    }
    for (place, radius) in pair.radii.iter().enumerate() {
        expect(found, radius.value > 0.0, &format!("sample.pair.radii[{place}]"), radius, "more than zero");
    }
    expect(found, path.distance.value > 0.0, "experiment.path.distance", &path.distance, "more than zero");
    legs(&path.legs, &path.dt, found);
    if found.is_empty() {
        let (radii, dt) = (pair.radii(), &path.dt);
        sized(soot, radii, std::iter::empty(), found);
        let limit = soot.step_limit(radii);
        let text = format!("less than the stability limit of two spheres, {}", in_unit(limit, "fs"));
        expect(found, dt.value < limit, "experiment.path.dt", dt, &text);
    }
}

/// Checks the time steps of these stages, the cutoff and the necks for spheres whose radii lie in this range.
pub fn sized<'a>(
    soot: &Soot,
    radii: [f64; 2],
    stages: impl Iterator<Item = (&'a SootStage, String)>,
    found: &mut Found,
) {
    let ([least, largest], limit) = (radii, soot.step_limit(radii));
    let text = format!("more than zero and less than the stability limit of two spheres, {}", in_unit(limit, "fs"));
    for (stage, key) in stages {
        let dt = stage.dt();
        expect(found, dt.value > 0.0 && dt.value < limit, &format!("{key}.dt"), dt, &text);
    }
    let text = format!("more than the centre distance of two touching spheres, {}", in_unit(2.0 * largest, "nm"));
    expect(found, soot.cutoff.value > 2.0 * largest, "model.soot.cutoff", &soot.cutoff, &text);
    if let Some(NeckStrength { neck_radius, .. }) = &soot.break_stress {
        let text = format!("at most the radius of the smallest sphere, {}", in_unit(least, "nm"));
        expect(found, neck_radius.value <= least, "model.soot.break_stress.neck_radius", neck_radius, &text);
    }
}

fn stage(stage: &SootStage, key: &str, found: &mut Found) {
    let at = |name: &str| format!("{key}.{name}");
    let mut positive = |name: &str, value: f64, text: String| {
        expect(found, value > 0.0, &at(name), text, "more than zero");
    };
    positive("duration", stage.duration().number(), stage.duration().to_string());
    match stage {
        SootStage::Deposition(Deposition { velocity, gap, .. }) => {
            positive("velocity", velocity.value, velocity.to_string());
            positive("gap", gap.number(), gap.to_string());
        }
        SootStage::Indentation(Indentation { velocity, gap, turn_rate, turn, cantilever, .. }) => {
            positive("gap", gap.number(), gap.to_string());
            positive("velocity", velocity.value, velocity.to_string());
            positive("turn_rate", turn_rate.value, turn_rate.to_string());
            positive("turn", turn.value, turn.to_string());
            positive("cantilever", cantilever.value, cantilever.to_string());
        }
        SootStage::Restructuring(_) => {}
    }
    if let SootStage::Indentation(Indentation { keep_necks, .. })
    | SootStage::Restructuring(Restructuring { keep_necks, .. }) = stage
    {
        expect(found, (0.0..=1.0).contains(keep_necks), &at("keep_necks"), decimal(*keep_necks), "0 to 1");
    }
    if let Some(Solid { unit, .. }) = stage.solid() {
        let name = if matches!(stage, SootStage::Deposition(_)) { "substrate.unit" } else { "tip.unit" };
        expect(found, unit.value > 0.0, &at(name), unit, "more than zero");
    }
    let every = stage.attraction_every();
    expect(found, every > 0, &at("attraction_every"), every, "at least 1");
    let (dt, duration) = (stage.dt(), stage.duration());
    let least = format!("at least a time step, {dt}");
    expect(found, duration.value(dt.value) >= dt.value, &at("duration"), duration, &least);
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
        (
            "substrate_hamaker_constant",
            soot.substrate_hamaker_constant.value,
            soot.substrate_hamaker_constant.to_string(),
        ),
        ("tip_hamaker_constant", soot.tip_hamaker_constant.value, soot.tip_hamaker_constant.to_string()),
        ("capillary_force", soot.capillary_force.value, soot.capillary_force.to_string()),
    ] {
        expect(found, value >= 0.0, &at(key), text, "zero or more");
    }
    for (motion, (rest, moving)) in soot.friction.at_rest.iter().zip(soot.friction.in_motion).enumerate() {
        let key = |name: &str| at(&format!("friction.{name}[{motion}]"));
        expect(found, *rest >= 0.0, &key("at_rest"), decimal(*rest), "zero or more");
        let most = format!("zero or more and at most the static coefficient, {}", decimal(*rest));
        expect(found, (0.0..=*rest).contains(&moving), &key("in_motion"), decimal(moving), &most);
    }
    let projects = (soot.torsion == Torsion::Spring && !soot.lags()) || soot.springs == Transport::Projected;
    let what = "`projected` with other `torsion` than `spring`, or with `springs_act: before-stretching`";
    expect(found, projects, &at("springs"), "carried", what);
    springs(&soot.contact, "model.soot.contact", found);
    if soot.necks.is_some() && soot.neck_springs.is_some() {
        found.push((at("necks"), "expected no `necks` beside `neck_springs`, which replace them".into()));
    }
    necks("model.soot", &soot.neck_springs, &soot.break_energy, found);
    if let Some(NeckStrength { tension, shear, neck_radius }) = &soot.break_stress {
        for (key, value, text) in [
            ("tension", tension.value, tension.to_string()),
            ("shear", shear.value, shear.to_string()),
            ("neck_radius", neck_radius.value, neck_radius.to_string()),
        ] {
            expect(found, value > 0.0, &at(&format!("break_stress.{key}")), text, "more than zero");
        }
    }
    let single = soot.neck_strengths.as_ref();
    let breaks = soot.break_energy.is_some() || soot.break_stress.is_some();
    if single.is_some() && !breaks {
        found.push((at("neck_strengths"), "expected `break_energy` or `break_stress` beside it".into()));
    }
    let mut number = |key: &str, value: f64, fits: bool, what: &str| {
        expect(found, fits, &at(&format!("neck_strengths.{key}")), decimal(value), what);
    };
    match single {
        Some(NeckStrengths::Weibull(WeibullStrengths { scale, shape })) => {
            number("weibull.scale", *scale, *scale > 0.0, "more than zero");
            number("weibull.shape", *shape, *shape >= 0.1, "at least 0.1");
        }
        Some(NeckStrengths::Normal(NormalStrengths { mean, deviation })) => {
            number("normal.mean", *mean, *mean > 0.0, "more than zero");
            number("normal.deviation", *deviation, *deviation >= 0.0, "zero or more");
        }
        Some(NeckStrengths::File(_)) | None => {}
    }
}
