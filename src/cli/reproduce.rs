//! `veridem reproduce`: a paper's claims beside what comes out.

use super::{Manner, print};
use crate::error::{AtPath, Error};
use crate::figures::Report;
use crate::output::write_atomically;
use crate::reproduce::{Chapter, Claim, Extent, Verdict, amorphous, contact, exact, junction, lattice};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The arguments.
#[derive(clap::Args)]
pub struct Arguments {
    /// The paper
    paper: Paper,
    /// Compute the paper's sizes: hours instead of ten minutes
    #[arg(long)]
    full: bool,
    /// Only the claims about one kind of system
    #[arg(long, value_name = "SYSTEM")]
    only: Option<System>,
    /// Where table and figures go; `run/reproduce-` with the paper's name by default
    #[arg(long)]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Paper {
    /// Pham-Ba & Molinari 2022
    Wear,
    /// Laube et al. 2018
    Titania,
}

impl Paper {
    /// Its name, what its page is called, and the systems that it makes claims about.
    fn about(self) -> (&'static str, &'static str, &'static [System]) {
        match self {
            Self::Wear => (
                "wear",
                "Adhesive wear with a coarse-grained discrete element model: claims and results",
                &[System::Exact, System::Lattice, System::Amorphous, System::Junction],
            ),
            Self::Titania => {
                ("titania", "A contact model for water-covered nanoparticles: claims and results", &[System::Contact])
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum System {
    /// What the equations alone give
    Exact,
    /// Hexagonal close-packed lattices, Section 3.1
    Lattice,
    /// Amorphous samples, Sections 3.2 and 3.3
    Amorphous,
    /// Sheared junctions, Section 4
    Junction,
    /// Two water-covered particles, Section 2 of the titania paper
    Contact,
}

/// Computes the claims and writes table, figures and report.
pub fn run(arguments: &Arguments, manner: Manner) -> Result<(), Error> {
    let (name, title_of_page, systems) = arguments.paper.about();
    let out = arguments.out.clone().unwrap_or_else(|| PathBuf::from(format!("run/reproduce-{name}")));
    let extent = if arguments.full { Extent::Full } else { Extent::Reduced };
    let mut claims: Vec<Claim> = Vec::new();
    let mut page = Report::new(title_of_page);
    for &system in systems {
        if arguments.only.is_some_and(|only| only != system) {
            continue;
        }
        let (title, begin) = (title(system), Instant::now());
        manner.say(format!("{title} ..."));
        let chapter = match system {
            System::Exact => Ok(exact::chapter()),
            System::Lattice => lattice::chapter(extent),
            System::Amorphous => amorphous::chapter(extent),
            System::Junction => junction::chapter(extent),
            System::Contact => contact::chapter(),
        }
        .map_err(|halt| Error::Halted(halt, None))?;
        manner.say(format!("{title}: {} claims in {:.0} s", chapter.claims.len(), begin.elapsed().as_secs_f64()));
        write_chapter(title, &chapter, &mut page, &out)?;
        claims.extend(chapter.claims);
    }
    let json = serde_json::to_string_pretty(&claims).expect("claims are plain data") + "\n";
    write(&out.join("claims.json"), &json)?;
    write(&out.join("claims.md"), &markdown(&claims))?;
    write(&out.join("report.html"), &page.finish())?;
    manner.say(format!("table, figures and report are in {}", out.display()));
    print(&if manner.json { json } else { markdown(&claims) })?;
    if !systems.contains(&System::Exact) {
        return Ok(());
    }
    let failed = exact::chapter()
        .claims
        .iter()
        .filter(|claim| claim.id != "Table 6" && claim.verdict == Verdict::Differs)
        .count();
    if failed > 0 {
        return Err(Error::Verification(format!("{failed} claims that follow from the equations alone do not hold")));
    }
    Ok(())
}

fn title(system: System) -> &'static str {
    match system {
        System::Exact => "Equations alone",
        System::Lattice => "Lattices",
        System::Amorphous => "Amorphous samples",
        System::Junction => "Junctions",
        System::Contact => "Two particles",
    }
}

fn write_chapter(title: &str, chapter: &Chapter, page: &mut Report, out: &Path) -> Result<(), Error> {
    page.heading(title);
    if !chapter.note.is_empty() {
        page.paragraph(&format!("Reduced: {}.", chapter.note));
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
