//! `veridem reproduce`: a paper's claims beside what comes out.

use super::{Manner, print};
use crate::error::{AtPath, Error};
use crate::figures::Report;
use crate::output::write_atomically;
use crate::reproduce::{Chapter, Claim, Extent, Setting, Verdict, soot, titania, wear};
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The arguments.
#[derive(clap::Args)]
pub struct Arguments {
    /// The paper
    paper: Paper,
    /// Compute the paper's sizes: hours instead of ten minutes; `restructuring` and `spectroscopy` go on where they were stopped, other
    /// chapters begin again
    #[arg(long)]
    full: bool,
    /// Only one chapter
    #[arg(long, value_name = "CHAPTER")]
    only: Option<Name>,
    /// Where table and figures go; by default `run/reproduce-` and the paper
    #[arg(long)]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Paper {
    /// Pham-Ba & Molinari 2022
    Wear,
    /// Demidov, Gor & Khalizov 2024
    Soot,
    /// Laube et al. 2018
    Titania,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Name {
    /// What the equations alone give
    Exact,
    /// wear: hexagonal close-packed lattices, Section 3.1
    Lattice,
    /// wear: amorphous samples, Sections 3.2 and 3.3
    Amorphous,
    /// wear: sheared junctions, Section 4
    Junction,
    /// soot: aggregates deposited, and torn at by a tip, Section 3.1
    Indentation,
    /// soot: aggregates under a coating, Section 3.2
    Restructuring,
    /// titania: two water-covered particles, Section 2
    Contact,
    /// titania: a stretched agglomerate, Section 3.1
    Agglomerate,
    /// titania: films under a tip, Section 3.2
    Spectroscopy,
}

/// A chapter's name, its headline, and what computes it.
type Entry = (Name, &'static str, fn(&Setting) -> Result<Chapter, Error>);

impl Paper {
    fn title(self) -> &'static str {
        match self {
            Self::Wear => "Adhesive wear with a coarse-grained discrete element model: claims and results",
            Self::Soot => "Discrete element method model of soot aggregates: claims and results",
            Self::Titania => "A contact model for water-covered nanoparticles: claims and results",
        }
    }

    fn chapters(self) -> Vec<Entry> {
        match self {
            Self::Wear => vec![
                (Name::Exact, "Equations alone", |_| Ok(wear::exact::chapter())),
                (Name::Lattice, "Lattices", |set| Ok(wear::lattice::chapter(set.extent)?)),
                (Name::Amorphous, "Amorphous samples", |set| Ok(wear::amorphous::chapter(set.extent)?)),
                (Name::Junction, "Junctions", |set| Ok(wear::junction::chapter(set.extent)?)),
            ],
            Self::Soot => vec![
                (Name::Exact, "Equations alone", |_| Ok(soot::exact::chapter())),
                (Name::Indentation, "Deposition and indentation", |set| soot::indentation::chapter(set.extent)),
                (Name::Restructuring, "Restructuring", soot::restructuring::chapter),
            ],
            Self::Titania => vec![
                (Name::Contact, "Two particles", |_| Ok(titania::chapter()?)),
                (Name::Agglomerate, "A stretched agglomerate", |_| titania::agglomerate::chapter()),
                (Name::Spectroscopy, "Films under a tip", titania::spectroscopy::chapter),
            ],
        }
    }

    /// The chapters that are asked for.
    fn chosen(self, only: Option<Name>) -> Result<Vec<Entry>, Error> {
        let word = |name: Name| name.to_possible_value().expect("no chapter is hidden").get_name().to_string();
        let mut chapters = self.chapters();
        if let Some(only) = only {
            let known: Vec<String> = chapters.iter().map(|&(name, ..)| word(name)).collect();
            chapters.retain(|&(name, ..)| name == only);
            if chapters.is_empty() {
                let what = format!("no chapter `{}`, expected one of `{}`", word(only), known.join("`, `"));
                return Err(Error::Usage(what));
            }
        }
        Ok(chapters)
    }
}

/// Computes the claims and writes table, figures and report.
pub fn run(arguments: &Arguments, manner: Manner) -> Result<(), Error> {
    let paper = arguments.paper;
    let chapters = paper.chosen(arguments.only)?;
    let extent = if arguments.full { Extent::Full } else { Extent::Reduced };
    let folder = || {
        let word = paper.to_possible_value().expect("no paper is hidden");
        Path::new("run").join(format!("reproduce-{}", word.get_name()))
    };
    let out = arguments.out.clone().unwrap_or_else(folder);
    let runs = out.join("runs").join(extent.of("reduced", "full"));
    let setting = Setting { extent, runs, tell: &|text| manner.say(text) };
    let (mut claims, mut failed) = (Vec::new(), 0);
    let mut page = Report::new(paper.title());
    for (name, title, compute) in chapters {
        manner.say(format!("{title} ..."));
        let begin = Instant::now();
        let mut chapter = compute(&setting)?;
        if setting.extent == Extent::Reduced && !chapter.note.is_empty() {
            chapter.note.insert_str(0, "Reduced: ");
        }
        manner.say(format!("{title}: {} claims in {:.0} s", chapter.claims.len(), begin.elapsed().as_secs_f64()));
        write_chapter(title, &chapter, &mut page, &out)?;
        if name == Name::Exact {
            // Table 6 of the wear paper is about samples and choices, not about the equations.
            let fails = |claim: &&Claim| claim.id != "Table 6" && claim.verdict == Verdict::Differs;
            failed = chapter.claims.iter().filter(fails).count();
        }
        claims.extend(chapter.claims);
    }
    let json = serde_json::to_string_pretty(&claims).expect("claims are plain data") + "\n";
    write(&out.join("claims.json"), &json)?;
    write(&out.join("claims.md"), &markdown(&claims))?;
    write(&out.join("report.html"), &page.finish())?;
    manner.say(format!("table, figures and report are in {}", out.display()));
    print(&if manner.json { json } else { markdown(&claims) })?;
    if failed > 0 {
        return Err(Error::Verification(format!("{failed} claims that follow from the equations alone do not hold")));
    }
    Ok(())
}

fn write_chapter(title: &str, chapter: &Chapter, page: &mut Report, out: &Path) -> Result<(), Error> {
    page.heading(title);
    if !chapter.note.is_empty() {
        page.paragraph(&format!("{}.", chapter.note));
    }
    let rows: Vec<[String; 5]> = chapter.claims.iter().map(cells).collect();
    page.table(&HEAD, &rows);
    for figure in &chapter.figures {
        page.figure(&figure.svg, &figure.caption);
        write(&out.join("figures").join(&figure.name).with_extension("svg"), &figure.svg)?;
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
        std::fs::create_dir_all(folder).at(folder)?;
    }
    write_atomically(path, text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_stands_in_the_report_as_it_was_written() {
        let (mut page, note) = (Report::new(""), "3 of 5 films, those that had finished");
        let chapter = Chapter { note: note.into(), ..Chapter::default() };
        write_chapter("", &chapter, &mut page, Path::new("nowhere")).expect("there are no figures to write");
        assert!(page.finish().contains(&format!("<p>{note}.</p>")));
    }
}
