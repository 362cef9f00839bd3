//! `veridem import`: describes an aggregate from another program, and writes its spheres as extended XYZ.

use super::{OutputMode, print};
use crate::case::quantity::{Length, Quantity};
use crate::error::{Error, notice};
use crate::initial::aggregate::import::{Imported, Options, extended_xyz, read, read_necks};
use crate::initial::aggregate::necks::{NECK_DISTANCE, missing_necks, necks};
use crate::output::write_atomically;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// FLAGE XML, MSTM, FracVAL, PyFracVAL, VTK, LAMMPS data or XYZ; identified by its content
    file: PathBuf,
    /// Unit of length of the file, such as `1 nm`, if the format does not define one
    #[arg(long, value_name = "LENGTH")]
    unit: Option<String>,
    /// Radius of all spheres, such as `14 nm`, if the file gives none
    #[arg(long, value_name = "LENGTH")]
    radius: Option<String>,
    /// Format, if the content does not identify it: flage, mstm, fracval, pyfracval, vtk, lammps or xyz
    #[arg(long)]
    format: Option<String>,
    /// File of necks written by soot-dem beside the spheres
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
pub(super) fn run(arguments: &Arguments, manner: OutputMode) -> Result<(), Error> {
    let length = |text: &Option<String>| {
        let parse = |text: &String| Quantity::<Length>::parse(text).map(|length| length.value).map_err(Error::Usage);
        text.as_ref().map(parse).transpose()
    };
    let (unit, radius) = (length(&arguments.unit)?, length(&arguments.radius)?);
    let word = |text: &String| serde_yaml::from_str(text).map_err(|error| Error::Usage(format!("--format: {error}")));
    let format = arguments.format.as_ref().map(word).transpose()?;
    let options = Options { format, unit, radius, disconnected: arguments.disconnected };
    let imported = read(&arguments.file, &options)?;
    let (necks, which) = match &arguments.necks {
        Some(file) => (read_necks(file, &imported.spheres)?.len(), String::new()),
        None => {
            let found = necks(&imported.spheres, NECK_DISTANCE, true);
            (found.len(), format!(" across gaps below {NECK_DISTANCE} nm, `neck_distance`"))
        }
    };
    if let Some(path) = &arguments.out {
        write_atomically(path, extended_xyz(&imported.spheres).as_bytes())?;
        manner.say(format!("written: {}", path.display()));
    }
    if let Some(remark) = missing_necks(&imported.spheres, necks, NECK_DISTANCE, imported.decimals) {
        notice(format!("{}: {remark}", arguments.file.display()));
    }
    let Imported { format, report, .. } = imported;
    if manner.json {
        return print(&format!("{:#}\n", serde_json::json!({ "format": format, "necks": necks, "report": report })));
    }
    print(&format!("{format:?}\n{report}\nnecks            {necks}{which}\n"))
}
