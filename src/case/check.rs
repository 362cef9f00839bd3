//! Checks of a case beyond its grammar.

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
    for (key, interval) in
        [("series", &output.series), ("frames", &output.frames), ("checkpoints", &output.checkpoints)]
    {
        expect(found, interval.number() > 0.0, &format!("output.{key}"), interval, "more than zero");
    }
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
