//! The report of a run: what it found, its spheres in three dimensions, graphs of its record, its pictures, its case and its provenance.

mod about;
mod curves;

use super::view::view;
use super::{Graph, Report, graph_names};
use crate::error::{AtPath, Error};
use crate::output::{Event, Finding, Manifest, ReadFrame, RunFolder, Series, with_suffix, write_atomically};
use about::{events_of_interest, files, parameters, verdict};

/// Creates figures and report of a run from its folder.
///
/// # Errors
///
/// If the record cannot be read, or figures and report cannot be written.
pub fn report(title: &str, graphs: &[Graph], folder: &RunFolder) -> Result<(), Error> {
    let (series, events, manifest) = (Series::read(folder)?, Event::all(folder)?, Manifest::read(folder)?);
    let findings = Finding::of_run(folder)?;
    let stages = series.stages();
    let frames = ReadFrame::all(folder, &stages)?;
    let mut page = Report::new(title);
    page.verdict(&verdict(folder, &manifest, &findings, &series, &events));
    let mut found = |page: &mut Report| {
        if !findings.is_empty() {
            page.heading("Results");
            results(page, &findings);
        }
    };
    let mut seen = |page: &mut Report| {
        if !frames.is_empty() {
            page.heading("Spheres");
            view(page, &frames);
        }
    };
    page.columns([&mut found, &mut seen, &mut |page| case(page, folder)]);
    let plots = curves::plots(graphs, &series, &events);
    if !plots.is_empty() {
        page.heading("Curves");
        let mut written = Ok(());
        page.grid(|page| {
            for plot in &plots {
                let svg = plot.svg();
                let path = with_suffix(folder.figures().join(&plot.title), "svg");
                written =
                    std::mem::replace(&mut written, Ok(())).and_then(|()| write_atomically(&path, svg.as_bytes()));
                page.figure(&svg, &format!("{} against {}", plot.y.label, plot.x.label));
            }
        });
        written?;
    }
    let pictures = pictures(folder, graphs, &stages)?;
    if !pictures.is_empty() {
        page.heading("Pictures");
        page.gallery(|page| pictures.iter().for_each(|(name, svg)| page.figure(svg, name)));
    }
    let notable = events_of_interest(&events);
    if !notable.is_empty() {
        page.heading("Events");
        page.on_request(&format!("{} events", notable.len()), |page| {
            page.table(&["stage", "time, ns", "event"], notable.iter().take(MOST_EVENTS).cloned());
            if notable.len() > MOST_EVENTS {
                page.note("All others are in events.jsonl.");
            }
        });
    }
    page.heading("Files");
    page.files(files(folder, frames.len())?.iter().map(|(name, what)| (&**name, &**what)));
    page.heading("How it was made");
    let Manifest { version, commit, compiler, target, threads, seed, .. } = &manifest;
    let threads = format!("{threads} thread{}", if *threads == 1 { "" } else { "s" });
    page.paragraph(&format!("veridem {version} (commit {commit}), {compiler}, {target}, {threads}, seed {seed}."));
    page.lines(manifest.command_lines.iter().map(String::as_str));
    write_atomically(&folder.report(), page.finish().as_bytes())
}

/// The findings, those of a stage or an event together.
fn results(page: &mut Report, findings: &[Finding]) {
    let parts = |finding: &Finding| -> (String, String) {
        let (of, name) = finding.name.split_once(": ").unwrap_or(("", &finding.name));
        (of.into(), name.into())
    };
    for group in findings.chunk_by(|a, b| parts(a).0 == parts(b).0) {
        let (of, _) = parts(&group[0]);
        if !of.is_empty() {
            page.subheading(&of);
        }
        let targets = group.iter().any(|finding| finding.target.is_some());
        let row = |finding: &Finding| {
            let target =
                finding.target.map_or(String::new(), |_| format!("{} {}", finding.target_text(), finding.unit));
            let cells = [parts(finding).1, finding.sentence(), target.trim_end().into()];
            cells.into_iter().take(if targets { 3 } else { 2 })
        };
        page.table(&["quantity", "value", "target"][..if targets { 3 } else { 2 }], group.iter().map(row));
    }
}

/// Most events of a page.
const MOST_EVENTS: usize = 200;

/// The case: what was asked for, and on request every value.
fn case(page: &mut Report, folder: &RunFolder) {
    let asked = parameters(&folder.case());
    if asked.is_empty() {
        return;
    }
    page.heading("Case");
    page.table(&["key", "value"], asked);
    let all = parameters(&folder.resolved());
    page.on_request("Every default and derived value", |page| page.table(&["key", "value"], all));
}

/// Snapshots taken during the run, in the order of time.
fn pictures(folder: &RunFolder, graphs: &[Graph], stages: &[&str]) -> Result<Vec<(String, String)>, Error> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder.figures()).at(&folder.figures())? {
        let path = entry.at(&folder.figures())?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().to_string();
        if graph_names(graphs).all(|graph| graph != name) {
            found.push((name, std::fs::read_to_string(&path).at(&path)?));
        }
    }
    found.sort_by_cached_key(|(name, _)| (moment(name, stages), name.clone()));
    Ok(found)
}

/// The place of a picture in time: its stage, and the part of the stage after which it was taken.
fn moment(name: &str, stages: &[&str]) -> Option<(usize, usize)> {
    stages.iter().enumerate().find_map(|(number, stage)| {
        let part = match name.strip_prefix(stage)?.strip_prefix(' ')? {
            "begin" => 0,
            "end" => usize::MAX,
            part => part.strip_prefix("after ")?.split(' ').next()?.parse().ok()?,
        };
        Some((number, part))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_follow_each_other_in_time() {
        let stages = ["relaxation", "pulling", "pulling 2"];
        let in_time = [
            "relaxation begin",
            "relaxation end",
            "pulling begin",
            "pulling after 2 of 12 parts",
            "pulling after 10 of 12 parts",
            "pulling end",
            "pulling 2 begin",
        ];
        assert!(in_time.is_sorted_by_key(|name| moment(name, &stages).expect("a picture of a stage")));
        assert_eq!(moment("mine", &stages), None);
    }
}
