//! `veridem reproduce`: the claims of a paper beside the measured values.

use super::{OutputMode, print};
use crate::error::Error;
use crate::figures::Report;
use crate::interrupt::Interrupt;
use crate::output::{command_line, create_folder, with_suffix, write_atomically};
use crate::papers::{AnyPaper, Papers};
use crate::reproduce::{Chapter, Claim, Evidence, Extent, Line, Setting, Verdict, lines};
use clap::builder::{PossibleValue, PossibleValuesParser};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The paper
    #[arg(required_unless_present = "list")]
    paper: Option<String>,
    /// List the claims of a paper, or of all: the command that measures each with its recorded result, or why nothing does
    #[arg(long, conflicts_with_all = ["full", "only", "out"])]
    list: bool,
    /// Compute the paper's sizes: hours instead of ten minutes; chapters that consist of runs resume where they were
    /// stopped, others start again
    #[arg(long)]
    full: bool,
    /// Compute only one chapter
    #[arg(long, value_name = "CHAPTER")]
    only: Option<String>,
    /// Folder for table and figures; by default `run/reproduce-` and the name of the paper
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Adds the names of the papers and chapters to the command.
pub(super) fn known(command: clap::Command, papers: Papers) -> clap::Command {
    let paper = |paper: &&dyn AnyPaper| PossibleValue::new(paper.name()).help(paper.reference());
    let names: Vec<PossibleValue> = papers.0.iter().map(paper).collect();
    let mut chapters: Vec<PossibleValue> = Vec::new();
    for paper in papers.0 {
        for Chapter { name, about, .. } in paper.chapters() {
            if !chapters.iter().any(|known| known.get_name() == *name) {
                chapters.push(PossibleValue::new(*name).help(format!("{}: {about}", paper.name())));
            }
        }
    }
    command
        .mut_arg("paper", |argument| argument.value_parser(PossibleValuesParser::new(names)))
        .mut_arg("only", |argument| argument.value_parser(PossibleValuesParser::new(chapters)))
}

/// The requested chapters of a paper.
fn chosen(paper: &dyn AnyPaper, only: Option<&str>) -> Result<Vec<&'static Chapter>, Error> {
    let chapters = paper.chapters().iter().filter(|chapter| only.is_none_or(|only| chapter.name == only));
    let chapters: Vec<&Chapter> = chapters.collect();
    match only {
        Some(only) if chapters.is_empty() => {
            let known: Vec<&str> = paper.chapters().iter().map(|chapter| chapter.name).collect();
            Err(Error::Usage(format!("no chapter `{only}`, expected one of `{}`", known.join("`, `"))))
        }
        _ => Ok(chapters),
    }
}

/// Computes the claims and writes table, figures and report.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let found = arguments.paper.as_deref().map(|name| papers.find(name).expect("the command line knows the papers"));
    let (Some(paper), false) = (found, arguments.list) else { return list(found, papers, manner) };
    let chapters = chosen(paper, arguments.only.as_deref())?;
    let extent = if arguments.full { Extent::Full } else { Extent::Reduced };
    let folder = || Path::new("run").join(format!("reproduce-{}", paper.name()));
    let interrupt = Interrupt::new(None, None).map_err(|cause| Error::Io("signal handler".into(), cause))?;
    let read = |file: &Path, text: &str| papers.parse(file, text);
    let out = arguments.out.clone().unwrap_or_else(folder);
    let runs = out.join("runs").join(extent.of("reduced", "full"));
    let tell = |text: String| manner.say(text);
    let setting = Setting { extent, runs, read: &read, interrupt: &interrupt, tell: &tell };
    let mut claims = Vec::new();
    let mut page = Report::new(paper.title());
    // Side by side, so that the last computation of one chapter leaves no core idle.
    let begin = Instant::now();
    let compute = |Chapter { title, compute, .. }: &&Chapter| {
        manner.say(format!("{title} ..."));
        let mut chapter = compute(&setting)?;
        if setting.extent == Extent::Reduced && !chapter.note.is_empty() {
            chapter.note.insert_str(0, "Reduced: ");
        }
        manner.say(format!("{title}: {} claims after {:.0} s", chapter.claims.len(), begin.elapsed().as_secs_f64()));
        Ok((*title, chapter))
    };
    for (title, chapter) in chapters.par_iter().map(compute).collect::<Result<Vec<_>, Error>>()? {
        write_chapter(title, &chapter, &mut page, &out)?;
        claims.extend(chapter.claims);
    }
    page.made_by(&[command_line()]);
    let json = serde_json::to_string_pretty(&claims).expect("claims are plain data") + "\n";
    write(&out.join("claims.json"), &json)?;
    write(&out.join("claims.md"), &markdown(&claims))?;
    write(&out.join("report.html"), &page.finish())?;
    manner.say(format!("table, figures and report are in {}", out.display()));
    print(&if manner.json { json } else { markdown(&claims) })?;
    let failed = claims.iter().filter(|claim| claim.exact && claim.verdict == Verdict::Differs).count();
    if failed > 0 {
        return Err(Error::Verification(format!("{failed} claims that follow from the equations alone do not hold")));
    }
    Ok(())
}

/// Prints the list of claims.
fn list(paper: Option<&'static dyn AnyPaper>, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let papers = paper.map_or_else(|| papers.0.to_vec(), |paper| vec![paper]);
    if manner.json {
        let all: Vec<Line> = papers.iter().flat_map(|paper| lines(paper.name(), paper.listed())).collect();
        return print(&(serde_json::to_string_pretty(&all).expect("a list is plain data") + "\n"));
    }
    let page = |paper: &&dyn AnyPaper| {
        let head = format!("# {}\n\n| {} |\n|{}\n", paper.reference(), LIST.join(" | "), "---|".repeat(LIST.len()));
        head + &lines(paper.name(), paper.listed()).iter().map(listed).collect::<String>()
    };
    print(&papers.iter().map(page).collect::<Vec<_>>().join("\n"))
}

const LIST: [&str; 6] = ["id", "where", "claim", "paper", "command", "recorded result"];

fn listed(line: &Line) -> String {
    let commands: Vec<String> = line.commands.iter().map(|command| format!("`{command}`")).collect();
    let Line { id, place, claim, paper, result, .. } = line;
    format!("| {id} | {place} | {claim} | {paper} | {} | {result} |\n", commands.join(", "))
}

fn write_chapter(title: &str, chapter: &Evidence, page: &mut Report, out: &Path) -> Result<(), Error> {
    page.heading(title);
    if !chapter.note.is_empty() {
        page.paragraph(&format!("{}.", chapter.note));
    }
    page.table(&HEAD, chapter.claims.iter().map(cells));
    page.grid(|page| chapter.figures.iter().for_each(|figure| page.figure(&figure.svg, &figure.caption)));
    for figure in &chapter.figures {
        write(&with_suffix(out.join("figures").join(&figure.name), "svg"), &figure.svg)?;
    }
    Ok(())
}

const HEAD: [&str; 5] = ["where", "claim", "paper", "measured", "verdict"];

fn cells(claim: &Claim) -> [String; 5] {
    let verdict = match claim.verdict {
        Verdict::Holds => "holds",
        Verdict::Differs => "DIFFERS",
    };
    [claim.id.into(), claim.claim.clone(), claim.paper.clone(), claim.measured.clone(), verdict.into()]
}

fn markdown(claims: &[Claim]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head = line(&HEAD.map(String::from)) + "|---|---|---|---|---|\n";
    head + &claims.iter().map(|claim| line(&cells(claim))).collect::<String>()
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    if let Some(folder) = path.parent() {
        create_folder(folder)?;
    }
    write_atomically(path, text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_stands_in_the_report_as_it_was_written() {
        let (mut page, note) = (Report::new(""), "3 of 5 films, those that had finished");
        let chapter = Evidence { note: note.into(), ..Evidence::default() };
        write_chapter("", &chapter, &mut page, Path::new("nowhere")).expect("there are no figures to write");
        assert!(page.finish().contains(&format!("<p>{note}.</p>")));
    }
}
