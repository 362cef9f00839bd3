//! What a report says about a run in words: its end, its case, its events and its files.

use crate::case::units::significant;
use crate::error::Error;
use crate::output::columns::{RELATIVE_RESIDUAL, TIME};
use crate::output::{Event, Finding, Found, Manifest, RunFolder, Series};
use serde_yaml::Value;
use std::path::Path;

/// The outcome in a sentence: how the run ended, what it found, and how well the energies balance.
pub(super) fn verdict(
    folder: &RunFolder,
    manifest: &Manifest,
    findings: &[Finding],
    series: &Series,
    events: &[Event],
) -> String {
    let last = |column| series.curve("", TIME, column).last().map(|point| point.1);
    let stages = series.stages();
    let count = |number: usize, word: &str| format!("{number} {word}{}", if number == 1 { "" } else { "s" });
    let when = last(TIME).map_or(String::new(), |time| {
        format!(" after {} ns and {}", significant(time, 3), count(stages.len(), "stage"))
    });
    // The results are written when everything else is done, the status after the report.
    let ended = match folder.results().exists() {
        true => format!("Finished{when}"),
        false => {
            let reason =
                events.iter().rev().find(|event| ["halted", "failed"].iter().any(|word| event.event.starts_with(word)));
            let reason = reason.map_or(String::new(), |event| format!(", {}", event.event));
            format!("{}{when}{reason}", manifest.status_word(folder))
        }
    };
    let mut said = vec![ended];
    said.extend(headline(findings));
    said.extend(last(RELATIVE_RESIDUAL).map(|error| {
        format!("the energies balance to {} % of what was converted", significant(100.0 * error.abs(), 2))
    }));
    format!("{}.", said.join("; "))
}

/// The verdict of the run in words, or its first result that was measured, or counted.
fn headline(findings: &[Finding]) -> Option<String> {
    // What is said of one event among several is no verdict of the run.
    let of_the_run = |finding: &&Finding| !finding.name.contains(':');
    let first = |kind: fn(&Found) -> bool| findings.iter().filter(of_the_run).find(|finding| kind(&finding.found));
    let words = first(|found| matches!(found, Found::Words(_)));
    let measured = words.or_else(|| first(|found| matches!(found, Found::Number(..))));
    let counted = measured.or_else(|| first(|found| matches!(found, Found::Count(_))));
    // Of a sequence, the end of its last part.
    let finding = counted.or_else(|| findings.iter().rfind(|finding| matches!(finding.found, Found::Words(_))))?;
    Some(format!("{}: {}", finding.name, finding.sentence()))
}

/// The keys of a case and their values; none if it cannot be read.
pub(super) fn parameters(file: &Path) -> Vec<[String; 2]> {
    let mut rows = Vec::new();
    let text = std::fs::read_to_string(file).unwrap_or_default();
    if let Ok(case) = serde_yaml::from_str(&text) {
        flatten("", &case, &mut rows);
    }
    // The title heads the page.
    rows.retain(|[key, _]| key != "title");
    rows
}

/// The values in a section, by keys such as `sample.hcp.size`.
fn flatten(key: &str, value: &Value, rows: &mut Vec<[String; 2]>) {
    match value {
        Value::Mapping(section) if !section.is_empty() => {
            for (word, value) in section {
                let word = plain(word);
                flatten(&if key.is_empty() { word } else { format!("{key}.{word}") }, value, rows);
            }
        }
        Value::Sequence(list) if list.iter().any(|item| item.is_mapping() || item.is_sequence()) => {
            list.iter().enumerate().for_each(|(k, item)| flatten(&format!("{key}[{k}]"), item, rows));
        }
        _ => rows.push([key.into(), plain(value)]),
    }
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Sequence(list) if list.is_empty() => "none".into(),
        Value::Sequence(list) => list.iter().map(plain).collect::<Vec<_>>().join(", "),
        // A section without content asks for its defaults.
        Value::Mapping(_) | Value::Null => "as by default".into(),
        other => serde_yaml::to_string(other).unwrap_or_default().trim_end().into(),
    }
}

/// Stage, time and text of the events that are not the course of every run.
pub(super) fn events_of_interest(events: &[Event]) -> Vec<[String; 3]> {
    let usual = ["begin", "end", "checkpoint"];
    let of_interest = events.iter().filter(|event| !usual.contains(&&*event.event));
    of_interest.map(|event| [event.stage.clone(), significant(event.time_ns, 6), event.event.clone()]).collect()
}

/// The files of a run beside its report, each with what it holds.
pub(super) fn files(folder: &RunFolder, frames: usize) -> Result<Vec<(String, String)>, Error> {
    let outputs = folder.outputs()?;
    let mut found = Vec::new();
    for path in outputs.iter().filter(|path| !path.starts_with(folder.frames())).chain([&folder.manifest()]) {
        let name = path.strip_prefix(folder.root()).unwrap_or(path).display().to_string();
        let what = match path {
            path if *path == folder.case() => "the case as it was given",
            path if *path == folder.resolved() => "the case with every default and derived value",
            path if *path == folder.results() => "the results with value, unit, digits and target",
            path if *path == folder.events() => "events with their times, one JSON object a line",
            path if *path == folder.manifest() => {
                "provenance: version, command line, seed, hashes of inputs and outputs"
            }
            _ => "the time series, units in the header",
        };
        found.push((name, what.to_string()));
    }
    if frames > 0 {
        found.push(("frames/".into(), format!("{frames} frames in the extended XYZ format, for OVITO and ASE")));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::Column;

    #[test]
    fn keys_are_those_of_the_command_line() {
        let case = "title: a\nseed: 3\nmodel: {x: {}}\nsample: {size: [1 nm, 2 nm], marks: []}\nexperiment: {sequence: [{a: {t: 1 ns}}, {b: {}}]}\n";
        let mut rows = Vec::new();
        flatten("", &serde_yaml::from_str(case).expect("a case"), &mut rows);
        let rows: Vec<String> = rows.iter().map(|[key, value]| format!("{key}={value}")).collect();
        assert_eq!(
            rows,
            [
                "title=a",
                "seed=3",
                "model.x=as by default",
                "sample.size=1 nm, 2 nm",
                "sample.marks=none",
                "experiment.sequence[0].a.t=1 ns",
                "experiment.sequence[1].b=as by default"
            ]
        );
    }

    #[test]
    fn the_headline_is_a_verdict_or_else_a_number() {
        let result = |name, unit| Column { name, unit, about: "" };
        let number = Finding::number(result("strength", "GPa"), 3980.0);
        assert_eq!(
            headline(&[number.clone(), Finding::words(result("fate", ""), "cut")]).as_deref(),
            Some("fate: cut")
        );
        let particles = Finding::words(result("particles", ""), "6 and 8").during("detachment 1");
        assert_eq!(headline(&[Finding::count(result("slips", ""), 3), particles]).as_deref(), Some("slips: 3"));
        assert_eq!(
            headline(&[Finding::reached(result("time", "ns"), None, "never"), number]).as_deref(),
            Some("strength: 3.980 GPa")
        );
        assert_eq!(headline(&[]), None);
    }
}
