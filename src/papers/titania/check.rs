//! Checks of a case of the titania paper beyond its grammar.

mod film;

use super::case::{
    Agglomerate, Case, Dragging, Experiment, Tension, Titania, TitaniaTest, TwoParticles, parts, step_limit,
};
use crate::case::check::{Found, expect};
use crate::case::units::{decimal, in_unit};
use crate::spec::mechanics::stable_step::stable_time_step;

/// Checks a case.
pub(super) fn problems(case: &Case, found: &mut Found) {
    let (titania, Some(test)) = parts(case) else {
        let sample = match case.experiment {
            Experiment::Stretching(_) => "`agglomerate`",
            Experiment::Contact(_) => "`pair`",
            Experiment::Spectroscopy(_) => "`film`",
        };
        return found.push(("sample".into(), format!("expected {sample} for this experiment")));
    };
    interactions(titania, found);
    necks(titania, matches!(test, TitaniaTest::Spectroscopy(..)), found);
    let core_gap = titania.core_gap.value;
    let thick =
        format!("more than the equilibrium distance of the bare surfaces (`core_gap`), {}", in_unit(core_gap, "nm"));
    match test {
        TitaniaTest::Contact(TwoParticles { diameters }, tests) => {
            for (place, d) in diameters.iter().enumerate() {
                let key = format!("sample.pair.diameters[{place}]");
                expect(found, d.value > core_gap, &key, d, &thick);
            }
            if tests.approach.is_none() && tests.slide.is_none() && tests.roll.is_none() {
                let what = "expected at least one of the keys `approach`, `slide`, `roll`";
                found.push(("experiment.contact".into(), what.into()));
            }
            if let Some(approach) = &tests.approach {
                let at = |key: &str| format!("experiment.contact.approach.{key}");
                expect(found, approach.duration.number() > 0.0, &at("duration"), &approach.duration, "more than zero");
                expect(found, approach.from.value >= 0.0, &at("from"), &approach.from, "zero or more");
            }
            for (name, dragging) in [("slide", &tests.slide), ("roll", &tests.roll)] {
                if let Some(dragging) = dragging {
                    dragged(dragging, &format!("experiment.contact.{name}"), &thick, core_gap, found);
                }
            }
        }
        TitaniaTest::Stretching(chain, stretching) => {
            let Agglomerate { particles, smallest, largest, .. } = chain;
            let at = |key: &str| format!("sample.agglomerate.{key}");
            let most = "5 to 100: two particles are held and two are pulled";
            expect(found, (5..=100).contains(particles), &at("particles"), particles, most);
            expect(found, smallest.value > core_gap, &at("smallest"), smallest, &thick);
            let least = format!("at least the smallest diameter, {smallest}");
            expect(found, largest.value >= smallest.value, &at("largest"), largest, &least);
            let at = |key: &str| format!("experiment.stretching.{key}");
            for (key, value, text) in [
                ("relaxation", stretching.relaxation.number(), stretching.relaxation.to_string()),
                ("stiffness", stretching.stiffness.value, stretching.stiffness.to_string()),
                ("velocity", stretching.velocity.value, stretching.velocity.to_string()),
                ("distance", stretching.distance.value, stretching.distance.to_string()),
            ] {
                expect(found, value > 0.0, &at(key), text, "more than zero");
            }
            expect(found, stretching.drag.value >= 0.0, &at("drag"), &stretching.drag, "zero or more");
            // The spring pulls, and holds, two particles.
            let (stiffness, lightest) = (&stretching.stiffness, 2.0 * titania.particle(smallest.value).1);
            let limit = stable_time_step(lightest, stiffness.value, 0.0);
            let soft = format!(
                "a stiffness at which two of the smallest particles are stable with the time step {}",
                stretching.dt
            );
            expect(found, stretching.dt.value < limit, &at("stiffness"), stiffness, &soft);
        }
        TitaniaTest::Spectroscopy(film, test) => {
            film::sample(film, &thick, core_gap, found);
            film::test(film, test, &thick, core_gap, found);
        }
    }
    if found.is_empty() {
        step(titania, &test, found);
    }
}

/// Checks the time step, which has a limit only if the particles attract each other.
fn step(titania: &Titania, test: &TitaniaTest, found: &mut Found) {
    let (law, (r, _)) = (titania.law(), titania.particle(test.smallest()));
    let attraction = -law.attraction(r, r).force(law.equilibrium(r, r));
    if attraction.is_nan() || attraction <= 0.0 {
        let what = "expected capillary and solvation forces under which the smallest particles attract each other at equilibrium";
        return found.push(("model.titania".into(), what.into()));
    }
    let limit = step_limit(titania, test);
    let (key, dt) = test.dt();
    let expected = format!("more than zero and less than the stability limit {}", in_unit(limit, "fs"));
    expect(found, dt.value > 0.0 && dt.value < limit, key, dt, &expected);
}

fn dragged(dragging: &Dragging, section: &str, thick: &str, core_gap: f64, found: &mut Found) {
    let at = |key: &str| format!("{section}.{key}");
    expect(found, dragging.slab.value > core_gap, &at("slab"), &dragging.slab, thick);
    for (key, value, text) in [
        ("settling", dragging.settling.number(), dragging.settling.to_string()),
        ("velocity", dragging.velocity.value, dragging.velocity.to_string()),
        ("distance", dragging.distance.value, dragging.distance.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
}

fn necks(titania: &Titania, of_film: bool, found: &mut Found) {
    let Titania { neck_springs, break_energy, .. } = titania;
    crate::case::springs::necks("model.titania", neck_springs, break_energy, found);
    if neck_springs.is_some() && !of_film {
        let what =
            "expected no necks: they join the particles of the aggregates of a film, and this sample has no aggregates";
        found.push(("model.titania.neck_springs".into(), what.into()));
    }
    if let (Some(energy), None) = (break_energy, neck_springs) {
        let beside = "`neck_springs` beside it, without which aggregates are rigid";
        expect(found, false, "model.titania.break_energy", energy, beside);
    }
}

fn interactions(titania: &Titania, found: &mut Found) {
    let at = |key: &str| format!("model.titania.{key}");
    let humidity = titania.humidity;
    let between = "more than 0 and less than 1";
    expect(found, humidity > 0.0 && humidity < 1.0, &at("humidity"), decimal(humidity), between);
    let angle = titania.contact_angle;
    expect(
        found,
        (0.0..1.5).contains(&angle),
        &at("contact_angle"),
        decimal(angle),
        "at least 0 and less than 1.5 radians",
    );
    for (key, value, text) in [
        ("density", titania.density.value, titania.density.to_string()),
        ("temperature", titania.temperature.value, titania.temperature.to_string()),
        ("core_gap", titania.core_gap.value, titania.core_gap.to_string()),
        ("solvation_period", titania.solvation_period.value, titania.solvation_period.to_string()),
        ("slip_period", titania.slip_period.value, titania.slip_period.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    if let Some(liquid) = &titania.liquid {
        for (key, value, text) in [
            ("surface_tension", liquid.surface_tension.value, liquid.surface_tension.to_string()),
            ("molecule", liquid.molecule.value, liquid.molecule.to_string()),
            ("layer", liquid.layer.value, liquid.layer.to_string()),
        ] {
            expect(found, value > 0.0, &at(&format!("liquid.{key}")), text, "more than zero");
        }
        let beside = "no surface tension of water beside `liquid`";
        expect(found, titania.surface_tension == Tension::Experimental, &at("surface_tension"), "tip3p", beside);
    }
    let (layer, core_gap) = (&titania.layer, &titania.core_gap);
    let overlap = format!(
        "more than half the equilibrium distance of the bare surfaces (`core_gap`), {}",
        in_unit(0.5 * core_gap.value, "nm")
    );
    expect(found, 2.0 * layer.value > core_gap.value, &at("layer"), layer, &overlap);
    for (key, value, text) in [
        ("damping_constant", titania.damping_constant.value, titania.damping_constant.to_string()),
        ("sliding_strength", titania.sliding_strength.value, titania.sliding_strength.to_string()),
        ("rolling_strength", titania.rolling_strength.value, titania.rolling_strength.to_string()),
    ] {
        expect(found, value >= 0.0, &at(key), text, "zero or more");
    }
}
