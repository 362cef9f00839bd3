//! Checks of a film and its test.

use crate::case::check::{Found, expect};
use crate::case::units::decimal;
use crate::initial::film::column::Column;
use crate::papers::titania::case::{Film, Spectroscopy};

/// Largest width of the column, in cells that hold the largest particles: ten thousand by ten thousand cells a layer.
const WIDEST: f64 = 1e4;
/// Largest number of layers of the tip, which has a third of the cube of it in spheres.
const LAYERS: f64 = 200.0;

/// Checks the film; diameters must be `thick`.
pub(super) fn sample(film: &Film, thick: &str, core_gap: f64, found: &mut Found) {
    let at = |key: &str| format!("sample.film.{key}");
    if film.import.is_some() {
        let (width, depth) = (&film.sides[0], &film.sides[1]);
        expect(found, width.value > 0.0, &at("sides[0]"), width, "more than zero");
        return expect(found, depth.value > 0.0, &at("sides[1]"), depth, "more than zero");
    }
    let most = "1 to 10000000";
    expect(found, (1..=10_000_000).contains(&film.particles), &at("particles"), film.particles, most);
    let diameters = &film.diameters;
    let (smallest, largest) = (&diameters.smallest, &diameters.largest);
    expect(found, smallest.value > core_gap, &at("diameters.smallest"), smallest, thick);
    for (key, value) in [("smallest", smallest), ("largest", largest)] {
        let whole = value.value == value.value.round() && value.value >= 1.0;
        expect(found, whole, &at(&format!("diameters.{key}")), value, "a whole number of nanometres");
    }
    let least = format!("at least the smallest diameter, {smallest}");
    expect(found, largest.value >= smallest.value, &at("diameters.largest"), largest, &least);
    let classes = "at most 31 nm more than the smallest diameter";
    expect(found, largest.value <= smallest.value + 31.0, &at("diameters.largest"), largest, classes);
    let least = Column::least_side(0.5 * largest.value);
    for (axis, side) in film.sides.iter().enumerate() {
        let wide = format!(
            "at least one and a half times the largest diameter, {} nm, and at most {WIDEST} times that",
            decimal(least)
        );
        let fits = (least..=WIDEST * least).contains(&side.value);
        expect(found, fits, &at(&format!("sides[{axis}]")), side, &wide);
    }
    let between = format!("between the smallest and the largest diameter, {smallest} and {largest}");
    let median = &diameters.median;
    let inside = (smallest.value..=largest.value).contains(&median.value);
    expect(found, inside, &at("diameters.median"), median, &between);
    let (deviation, above) = (diameters.deviation, "more than 1");
    expect(found, deviation > 1.0, &at("diameters.deviation"), decimal(deviation), above);
    let numbers = &film.aggregates;
    let median = numbers.median;
    let inside = median >= 1.0 && median <= numbers.largest as f64;
    expect(found, inside, &at("aggregates.median"), decimal(median), "at least 1 and at most the largest number");
    for (key, value, text) in [
        ("prefactor", film.prefactor, decimal(film.prefactor)),
        ("gas.temperature", film.gas.temperature.value, film.gas.temperature.to_string()),
        ("gas.viscosity", film.gas.viscosity.value, film.gas.viscosity.to_string()),
        ("gas.free_path", film.gas.free_path.value, film.gas.free_path.to_string()),
        ("drift", film.drift.value, film.drift.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    let deviation = numbers.deviation;
    let bounded = "more than 0 and at most 10, beyond which hardly any number is within the bounds";
    expect(found, deviation > 0.0 && deviation <= 10.0, &at("aggregates.deviation"), decimal(deviation), bounded);
    let (largest, most) = (numbers.largest, "1 to 1000000");
    expect(found, (1..=1_000_000).contains(&largest), &at("aggregates.largest"), largest, most);
    expect(found, film.cluster >= 1, &at("cluster"), film.cluster, "1 or more");
    let (d_f, range) = (film.dimension, "more than 1 and at most 3");
    expect(found, d_f > 1.0 && d_f <= 3.0, &at("dimension"), decimal(d_f), range);
}

/// Checks the test.
pub(super) fn test(film: &Film, test: &Spectroscopy, thick: &str, core_gap: f64, found: &mut Found) {
    let at = |key: &str| format!("experiment.spectroscopy.{key}");
    for (key, value, text) in [
        ("relaxation", test.relaxation.number(), test.relaxation.to_string()),
        ("speed", test.speed.value, test.speed.to_string()),
        ("setpoint", test.setpoint.value, test.setpoint.to_string()),
        ("reversal", test.reversal.value, test.reversal.to_string()),
        ("average", test.average.value, test.average.to_string()),
        ("depth", test.depth.value, test.depth.to_string()),
        ("retraction", test.retraction.value, test.retraction.to_string()),
        ("tip.clearance", test.tip.clearance.value, test.tip.clearance.to_string()),
    ] {
        expect(found, value > 0.0, &at(key), text, "more than zero");
    }
    let (average, dt) = (&test.average, &test.dt);
    let down = test.depth.value / test.speed.value;
    let window = format!("at least the time step, {dt}, and less than the time in which the tip reaches its depth");
    expect(found, (dt.value..down).contains(&average.value), &at("average"), average, &window);
    expect(found, test.drag.value >= 0.0, &at("drag"), &test.drag, "zero or more");
    let (radius, side) = (&test.tip.radius, &test.tip.side);
    expect(found, 2.0 * radius.value > core_gap, &at("tip.radius"), radius, &format!("half of a diameter {thick}"));
    let width = film.sides[0].value.min(film.sides[1].value);
    let narrow =
        format!("at least the diameter of its spheres and less than the width of the column, {} nm", decimal(width));
    let fits = side.value >= 2.0 * radius.value && side.value < width;
    expect(found, fits, &at("tip.side"), side, &narrow);
    let few = format!("at most {LAYERS} times the diameter of its spheres, {radius} in radius");
    expect(found, side.value <= 2.0 * LAYERS * radius.value, &at("tip.side"), side, &few);
}
