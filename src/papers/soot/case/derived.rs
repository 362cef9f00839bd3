//! The derived values of a case of the soot paper.

use super::{Case, key, parts, path};
use crate::case::units::{in_unit, rounded};
use crate::initial::aggregate::import::{FileSizes, Import, shift_of_import};
use crate::papers::soot::place::shift;
use crate::spec::mechanics::primary_particle::solid_inertia;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::eq24_fractal::gyration_radius;
use crate::spec::soot::{Along, Programmed};

/// The keys of growth, which an imported aggregate does not use.
pub fn unused(case: &Case) -> &'static [&'static str] {
    const OF_GROWTH: &[&str] = &[
        "sample.aggregate.spheres",
        "sample.aggregate.radius",
        "sample.aggregate.fractal_dimension",
        "sample.aggregate.prefactor",
        "sample.aggregate.deviation",
        "sample.aggregate.growth",
    ];
    if parts(case).is_some_and(|(_, sample, _)| sample.import.is_some()) { OF_GROWTH } else { &[] }
}

/// The derived values of a case, with units. A file that cannot be read is reported when it is needed; of a deposited aggregate little is known before.
pub fn derived(case: &Case) -> Vec<(String, String)> {
    let Some((soot, sample, stages)) = parts(case) else { return of_path(case) };
    let mut rows = Vec::new();
    let spheres = sample.import.as_ref().and_then(Import::spheres);
    let imported = spheres.as_deref().map(FileSizes::of);
    if let Some(FileSizes { number, least, median, largest }) = imported {
        let radii = if least == largest {
            in_unit(median, "nm")
        } else {
            format!("{} to {}, median {}", in_unit(least, "nm"), in_unit(largest, "nm"), in_unit(median, "nm"))
        };
        rows.extend([("number of spheres".into(), number.to_string()), ("radii of the spheres".into(), radii)]);
    }
    rows.extend(spheres.map(|spheres| shift_of_import(shift(spheres, sample.on_substrate))));
    let sizes = imported.map(|FileSizes { least, median, largest, .. }| ([least, largest], median));
    if let Some((radii, r)) = sizes.or_else(|| Some((sample.radii()?, sample.radius.value))) {
        let limit = soot.step_limit(radii);
        let mass = sphere_mass(soot.density.value, r);
        rows.extend([
            ("mass of a sphere".into(), in_unit(mass, "kg")),
            ("moment of inertia of a sphere".into(), in_unit(solid_inertia(mass, r), "kg m^2")),
            ("largest stable time step".into(), in_unit(limit, "fs")),
        ]);
        // The mean of drawn radii differs from `radius`, and the law fixes nothing for fewer than three spheres.
        if sample.radii() == Some([r, r]) && sample.spheres >= 3 {
            let gyration = gyration_radius(sample.prefactor, sample.spheres as f64, r, sample.fractal_dimension);
            rows.push(("radius of gyration R_g".into(), in_unit(gyration, "nm")));
        }
        if soot.lags() {
            let lag = in_unit(soot.law(Programmed).contact.lag_limit(), "fs");
            rows.push(("time step above which contacts gain energy until they slip".into(), lag));
        } else {
            rows.push((
                "largest stable time step of a sphere with six necks, approximately".into(),
                in_unit(SIX_NECKS * limit, "fs"),
            ));
        }
        rows.extend(stages.iter().enumerate().map(|(number, stage)| {
            let dt = stage.dt().value;
            let text = format!("{} = {} of the largest stable time step", in_unit(dt, "fs"), rounded(dt / limit));
            (format!("{}.dt", key(case, number, stage)), text)
        }));
        let at_the_cutoff =
            |stage| soot.law_of(Along, stage).attraction.force(soot.cutoff.value, soot.cutoff.value - 2.0 * r, r, r);
        let left = stages.iter().map(at_the_cutoff).fold(0.0, f64::max);
        rows.push(("attraction at the cutoff".into(), in_unit(left, "N")));
    }
    rows
}

fn of_path(case: &Case) -> Vec<(String, String)> {
    let Some((soot, pair, path)) = path(case) else { return Vec::new() };
    let limit = soot.step_limit(pair.radii());
    let share = rounded(path.dt.value / limit);
    let text = format!("{} = {share} of the largest stable time step", in_unit(path.dt.value, "fs"));
    vec![("largest stable time step".into(), in_unit(limit, "fs")), ("experiment.path.dt".into(), text)]
}

/// Ratio of the largest stable time steps of a sphere with six necks and a sphere with one.
const SIX_NECKS: f64 = 0.52;
