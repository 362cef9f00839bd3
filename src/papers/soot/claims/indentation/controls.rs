//! Section 3.1.2: what controls the height and the number of the peaks of a force curve.

use super::Member;
use crate::observe::statistics::Mean;
use crate::reproduce::Claim;

/// Number of peaks.
fn number(member: &Member) -> f64 {
    member.curve.peaks().len() as f64
}

/// Height of the highest peak, nN; zero without peaks.
fn height(member: &Member) -> f64 {
    1e-3 * member.curve.highest().max(0.0)
}

/// The claims, from aggregates as published, the first of them with three times the Hamaker constant, and as many of half their size.
pub(super) fn claims(published: &[Member], sticky: &[Member], small: &[Member]) -> Vec<Claim> {
    let change = |of: fn(&Member) -> f64, from: &[Member], to: &[Member]| {
        Mean::of(&from.iter().zip(to).map(|(from, to)| of(to) - of(from)).collect::<Vec<_>>())
    };
    let claim = |what: &str, controlled: Mean, other: Mean, [by, and]: [&str; 2]| {
        Claim::new(
            "Section 3.1.2",
            format!("{what}: the change of the one is above 0, that of the other not distinguishable from 0"),
            "controls",
            format!("{controlled:+.2}{by} and {other:+.2}{and}, of {} aggregates", sticky.len()),
            controlled.value - controlled.margin > 0.0 && other.covers(0.0),
        )
    };
    vec![
        claim(
            "the Hamaker constant, three times as large, controls the height of the highest peak, not the number of peaks",
            change(height, published, sticky),
            change(number, published, sticky),
            [" nN", " peaks"],
        ),
        claim(
            "the morphology, twice as many spheres, controls the number of peaks, not the height of the highest",
            change(number, small, published),
            change(height, small, published),
            [" peaks", " nN"],
        ),
    ]
}
