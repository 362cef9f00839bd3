//! Checks of a case of the titania paper beyond its grammar.

mod film;

use super::case::{
    Agglomerate, Case, ChainTest, Dragging, Experiment, Film, Path, Stretching, Tension, Titania, TitaniaTest,
    TwoParticles, parts, step_limit, unlike_published,
};
use crate::case::check::{Found, expect};
use crate::case::quantity::{Quantity, Time};
use crate::case::units::{decimal, in_unit};
use crate::initial::aggregate::import::Import;
use crate::papers::path;
use crate::spec::mechanics::stable_step::stable_time_step;

/// Checks a case.
pub(super) fn problems(case: &Case, found: &mut Found) {
    let (titania, Some(test)) = parts(case) else {
        let sample = match case.experiment {
            Experiment::Stretching(_) | Experiment::Release(_) => "`agglomerate`",
            Experiment::Contact(_) | Experiment::Path(_) => "`pair`",
            Experiment::Spectroscopy(_) => "`film`",
        };
        return found.push(("sample".into(), format!("expected {sample} for this experiment")));
    };
    interactions(titania, found);
    necks(titania, &test, found);
    let core_gap = titania.core_gap.value;
    let thick =
        format!("more than the equilibrium distance of the bare surfaces (`core_gap`), {}", in_unit(core_gap, "nm"));
    match &test {
        TitaniaTest::Path(pair, Path { distance, legs, dt }) => {
            two(pair, &thick, core_gap, found);
            path::legs(legs, dt, found);
            if let Some(distance) = distance {
                expect(found, distance.value > 0.0, "experiment.path.distance", distance, "more than zero");
            }
        }
        TitaniaTest::Contact(pair, tests) => {
            two(pair, &thick, core_gap, found);
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
        TitaniaTest::Chain(sample, test) => {
            if let Some(Import { necks: Some(_), .. }) = &sample.import {
                let what = "expected no necks: rigid bodies hold the particles of an agglomerate together";
                found.push(("sample.agglomerate.import.necks".into(), what.into()));
            }
            if sample.import.is_none() {
                agglomerate(sample, test, &thick, core_gap, found);
            }
            match &**test {
                ChainTest::Stretching(test) => stretched(test, found),
                ChainTest::Release(test) => {
                    let at = |key: &str| format!("experiment.release.{key}");
                    expect(found, test.duration.number() > 0.0, &at("duration"), &test.duration, "more than zero");
                    expect(found, test.drag.value >= 0.0, &at("drag"), &test.drag, "zero or more");
                }
            }
        }
        TitaniaTest::Spectroscopy(film, test) => {
            film::sample(film, &thick, core_gap, found);
            film::test(film, test, &thick, core_gap, found);
        }
    }
    // Sizes in a file are checked when it is read.
    if let (None, Some(diameters), true) = (test.import(), test.diameters(), found.is_empty()) {
        match &test {
            TitaniaTest::Chain(_, of_chain) => chain(titania, diameters[0], of_chain, found),
            _ => step(titania, diameters, test.dt(), found),
        }
    }
}

/// Checks the time step and the springs of an agglomerate whose smallest nominal diameter is this, nm.
pub(super) fn chain(titania: &Titania, smallest: f64, test: &ChainTest, found: &mut Found) {
    if let ChainTest::Stretching(Stretching { stiffness, drawn, dt, .. }) = test {
        // The spring pulls, and holds, a few particles.
        let lightest = *drawn as f64 * titania.particle(smallest).1;
        let limit = stable_time_step(lightest, stiffness.value, 0.0);
        let soft = format!("a stiffness at which {drawn} of the smallest particles are stable with the time step {dt}");
        expect(found, dt.value < limit, "experiment.stretching.stiffness", stiffness, &soft);
    }
    step(titania, [smallest; 2], test.dt(), found);
}

/// Checks the time step for particles with diameters in this range, nm; it has a limit only if the particles attract each other.
pub(super) fn step(titania: &Titania, diameters: [f64; 2], (key, dt): (&str, &Quantity<Time>), found: &mut Found) {
    let core_gap = titania.core_gap.value;
    if diameters[0] <= core_gap {
        let what =
            format!("found `{}`, expected less than the smallest diameter, {} nm", titania.core_gap, diameters[0]);
        return found.push(("model.titania.core_gap".into(), what));
    }
    let (law, (r, _)) = (titania.law(), titania.particle(diameters[0]));
    let attraction = -law.attraction(r, r).force(law.equilibrium(r, r));
    if attraction.is_nan() || attraction <= 0.0 {
        let what = "expected capillary and solvation forces under which the smallest particles attract each other at equilibrium";
        return found.push(("model.titania".into(), what.into()));
    }
    let limit = step_limit(titania, diameters);
    let expected = format!("more than zero and less than the stability limit {}", in_unit(limit, "fs"));
    expect(found, dt.value > 0.0 && dt.value < limit, key, dt, &expected);
}

fn two(TwoParticles { diameters }: &TwoParticles, thick: &str, core_gap: f64, found: &mut Found) {
    for (place, d) in diameters.iter().enumerate() {
        expect(found, d.value > core_gap, &format!("sample.pair.diameters[{place}]"), d, thick);
    }
}

/// Checks a chain that is generated.
fn agglomerate(sample: &Agglomerate, test: &ChainTest, thick: &str, core_gap: f64, found: &mut Found) {
    let Agglomerate { particles, smallest, largest, .. } = sample;
    let at = |key: &str| format!("sample.agglomerate.{key}");
    let drawn = if let ChainTest::Stretching(test) = test { test.drawn } else { 0 };
    let fewest = drawn.saturating_mul(2).saturating_add(1).max(5);
    let most = format!("{fewest} to 100: {drawn} particles at each end are held and pulled");
    expect(found, (fewest..=100).contains(particles), &at("particles"), particles, &most);
    expect(found, smallest.value > core_gap, &at("smallest"), smallest, thick);
    let least = format!("at least the smallest diameter, {smallest}");
    expect(found, largest.value >= smallest.value, &at("largest"), largest, &least);
}

fn stretched(test: &Stretching, found: &mut Found) {
    let at = |key: &str| format!("experiment.stretching.{key}");
    for (key, value, text) in [
        ("relaxation", test.relaxation.number(), test.relaxation.to_string()),
        ("stiffness", test.stiffness.value, test.stiffness.to_string()),
        ("velocity", test.velocity.value, test.velocity.to_string()),
        ("distance", test.distance.value, test.distance.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    expect(found, (1..=u64::from(u32::MAX)).contains(&test.drawn), &at("drawn"), test.drawn, "1 or more");
    expect(found, test.drag.value >= 0.0, &at("drag"), &test.drag, "zero or more");
    expect(found, test.ramp.value >= 0.0, &at("ramp"), &test.ramp, "zero or more");
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

fn necks(titania: &Titania, test: &TitaniaTest, found: &mut Found) {
    let Titania { neck_springs, break_energy, .. } = titania;
    crate::case::springs::necks("model.titania", neck_springs, break_energy, found);
    if neck_springs.is_some() && !matches!(test, TitaniaTest::Spectroscopy(..)) {
        let what =
            "expected no necks: they join the particles of the aggregates of a film, and this sample has no aggregates";
        found.push(("model.titania.neck_springs".into(), what.into()));
    }
    if let (Some(energy), None) = (break_energy, neck_springs) {
        let beside = "`neck_springs` beside it, without which aggregates are rigid";
        expect(found, false, "model.titania.break_energy", energy, beside);
    }
    if let TitaniaTest::Spectroscopy(Film { import: Some(Import { necks: Some(_), .. }), .. }, _) = test
        && neck_springs.is_none()
    {
        let what = "expected `model.titania.neck_springs` beside it, without which bodies are rigid";
        found.push(("sample.film.import.necks".into(), what.into()));
    }
}

fn interactions(titania: &Titania, found: &mut Found) {
    let at = |key: &str| format!("model.titania.{key}");
    for (key, value) in unlike_published(titania) {
        let what = format!("found `{value}`, expected no such key beside `readings: as-published`, which decides it");
        found.push((at(key), what));
    }
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
