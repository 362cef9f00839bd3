//! `veridem import`: describes an aggregate from another program, and writes its spheres as extended XYZ.

use super::run::{Limits, table};
use super::{OutputMode, print};
use crate::case::quantity::{Length, Quantity};
use crate::error::{Error, notice};
use crate::geometry::centred;
use crate::initial::aggregate::import::{Options, extended_xyz, read, read_necks};
use crate::initial::aggregate::necks::{NECK_DISTANCE, NeckLength, missing_necks, necks};
use crate::observe::aggregate::AggregateShape;
use crate::output::{Finding, write_atomically};
use crate::papers::{AtStart, Papers};
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// CSV, FLAGE XML, MSTM, FracVAL, PyFracVAL, VTK, LAMMPS data or dump, or XYZ; identified by its content, CSV without a header by its name
    file: PathBuf,
    /// Unit of length of the file, such as `1 nm`, if the format does not define one
    #[arg(long, value_name = "LENGTH")]
    unit: Option<String>,
    /// Radius of all spheres, such as `14 nm`, if the file gives none
    #[arg(long, value_name = "LENGTH")]
    radius: Option<String>,
    /// Format, if the content does not identify it: flage, mstm, fracval, pyfracval, vtk, lammps, lammps-dump, xyz or csv
    #[arg(long)]
    format: Option<String>,
    /// Largest gap or overlap of a neck, such as `0.1 nm`; the key `neck_distance` of a case
    #[arg(long, value_name = "LENGTH")]
    neck_distance: Option<String>,
    /// Length of necks at rest, touching or as-given; the key `neck_length` of a case
    #[arg(long, value_name = "WORD")]
    neck_length: Option<String>,
    /// File of necks: rows `i,j` of two spheres counted from 0, or what soot-dem writes beside the spheres
    #[arg(long, value_name = "FILE")]
    necks: Option<PathBuf>,
    /// Accept spheres that do not form one connected aggregate
    #[arg(long)]
    disconnected: bool,
    /// Write the spheres to this file as extended XYZ, in nm
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Reads, describes and writes the aggregate.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let length = |text: &Option<String>| {
        let parse = |text: &String| Quantity::<Length>::parse(text).map(|length| length.value).map_err(Error::Usage);
        text.as_ref().map(parse).transpose()
    };
    let (unit, radius) = (length(&arguments.unit)?, length(&arguments.radius)?);
    let neck_distance = length(&arguments.neck_distance)?.unwrap_or(NECK_DISTANCE);
    if neck_distance <= 0.0 {
        return Err(Error::Usage("--neck-distance: expected a length above 0".into()));
    }
    let format = word("--format", &arguments.format)?;
    let neck_length = word("--neck-length", &arguments.neck_length)?.unwrap_or(NeckLength::Touching);
    let options = Options { format, unit, radius, disconnected: arguments.disconnected };
    let interrupt = Limits::default().interrupt()?;
    let imported = read(&arguments.file, &options, &interrupt)?;
    // As a run has them: the place decides about the last digits of gaps.
    let spheres = centred(imported.spheres.clone());
    let (necks, which) = match &arguments.necks {
        Some(file) => (read_necks(file, &spheres, &interrupt)?, String::new()),
        None => {
            let found = necks(&spheres, neck_distance, neck_length, true, &interrupt)?;
            let across = if neck_length == NeckLength::AsGiven { "any overlap and gaps" } else { "gaps and overlaps" };
            (found, format!(" across {across} below {neck_distance} nm, `neck_distance`"))
        }
    };
    let starts = papers.0.iter().map(|paper| paper.imported(&spheres, &necks, neck_length, &interrupt));
    let starts: Vec<AtStart> = starts.filter_map(Result::transpose).collect::<Result<_, _>>()?;
    let missing = missing_necks(&spheres, necks.len(), neck_distance, neck_length, imported.decimals, &interrupt)?;
    let (format, report) = (imported.format, imported.report(&interrupt)?);
    if let Some(path) = &arguments.out {
        write_atomically(path, extended_xyz(&imported.spheres, &imported.extras).as_bytes())?;
        manner.say(format!("written: {}", path.display()));
    }
    if let Some(remark) = missing {
        notice(format!("{}: {remark}", arguments.file.display()));
    }
    for AtStart { paper, refusal, .. } in &starts {
        if let Some(refusal) = refusal {
            notice(format!("{}: refused by a run with the defaults of `{paper}`: {refusal}", arguments.file.display()));
        }
    }
    let shape = AggregateShape::of(&spheres, &interrupt)?.findings();
    if manner.json {
        let described = serde_json::json!({ "format": format, "necks": necks.len(), "report": report, "shape": Finding::results(&shape), "at_start": starts });
        return print(&format!("{described:#}\n"));
    }
    let start = |AtStart { paper, necks, springs, .. }: &AtStart| {
        format!(
            "springs          {springs:.3e} zJ at the start of a run with the defaults of `{paper}`, which keep {necks} necks\n"
        )
    };
    let starts: String = starts.iter().map(start).collect();
    print(&format!("{format:?}\n{report}\nnecks            {}{which}\n{starts}\n{}", necks.len(), table(&shape)))
}

/// A word that an option may have.
fn word<W: serde::de::DeserializeOwned>(option: &str, text: &Option<String>) -> Result<Option<W>, Error> {
    let word = |text: &String| serde_yaml::from_str(text).map_err(|error| Error::Usage(format!("{option}: {error}")));
    text.as_ref().map(word).transpose()
}
