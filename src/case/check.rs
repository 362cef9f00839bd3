//! Checks of a case beyond its grammar.

use super::Moments;
use super::schema::{Limits, Output};
use super::units::decimal;
use std::fmt::Display;

/// Keys and error messages, in the order of the file.
pub type Found = Vec<(String, String)>;

/// Adds an error message about the value of a key unless the condition `holds`.
pub fn expect(found: &mut Found, holds: bool, key: &str, value: impl Display, expected: &str) {
    if !holds {
        found.push((key.into(), format!("found `{value}`, expected {expected}")));
    }
}

/// Checks the general sections of a case.
pub(super) fn general(output: &Output, limits: &Limits, found: &mut Found) {
    let mut intervals = vec![("series", &output.series), ("checkpoints", &output.checkpoints)];
    if let Moments::Every(interval) = &output.frames {
        intervals.insert(1, ("frames", interval));
    }
    for (key, interval) in intervals {
        expect(found, interval.number() > 0.0, &format!("output.{key}"), interval, "more than zero");
    }
    let twice = |k: usize| output.format[..k].contains(&output.format[k]);
    let once = !output.format.is_empty() && !(0..output.format.len()).any(twice);
    expect(found, once, "output.format", output.format.len(), "a list of at least one format, each once");
    let overlap = limits.overlap;
    let whole = "more than 0 and at most 1, where the centres coincide";
    expect(found, overlap > 0.0 && overlap <= 1.0, "limits.overlap", decimal(overlap), whole);
}

/// Formats alternatives: `a`, `b` or `c`.
pub fn either(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [only] => format!("`{only}`"),
        [first @ .., last] => format!("`{}` or `{last}`", first.join("`, `")),
    }
}
