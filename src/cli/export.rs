//! `veridem export`: writes the state of a case or of a run, or the spheres of a frame, for another program.

use super::run::Limits;
use super::{OutputMode, print};
use crate::error::Error;
use crate::geometry::Sphere;
use crate::initial::aggregate::import::{self, Options};
use crate::interrupt::Interrupt;
use crate::output::{RunFolder, bod, create_folder, mstm, ply, write_atomically};
use crate::papers::Papers;
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// For LAMMPS, the case file, of whose first stage the start is written, or a run folder, of which the latest checkpoint is; for the
    /// others a frame of a run (`.xyz`), or an aggregate that `veridem import` reads, in nm
    from: PathBuf,
    #[command(flatten)]
    target: Target,
    /// The file to write, which must not exist; for LAMMPS a folder
    #[arg(long, value_name = "PATH")]
    out: PathBuf,
}

/// The program that will read it.
#[derive(clap::Args)]
#[group(required = true, multiple = false)]
struct Target {
    /// For LAMMPS with the plugin of `bindings/lammps`: data file, history of the pairs, input script
    #[arg(long)]
    lammps: bool,
    /// For MSTM 4, optics of spheres: rows `x y z r`
    #[arg(long)]
    mstm: bool,
    /// For ZENO, hydrodynamics and capacitance of spheres: a `.bod` file
    #[arg(long)]
    bod: bool,
    /// For programs that read triangles: a mesh in the PLY format
    #[arg(long)]
    ply: bool,
}

impl Target {
    /// How spheres are written for it; LAMMPS gets more than spheres.
    fn form(&self) -> Option<fn(&[Sphere]) -> String> {
        match self {
            Self { mstm: true, .. } => Some(mstm),
            Self { bod: true, .. } => Some(bod),
            Self { ply: true, .. } => Some(ply),
            _ => None,
        }
    }
}

/// Writes the files.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let interrupt = Limits::default().interrupt()?;
    let Arguments { from, target, out } = arguments;
    if out.exists() {
        return Err(Error::Usage(format!("{}: exists already", out.display())));
    }
    let written = match target.form() {
        None => for_lammps(from, out, papers, &interrupt)?,
        Some(form) => {
            let options = Options { unit: Some(1.0), disconnected: true, ..Options::default() };
            write_atomically(out, form(&import::read(from, &options, &interrupt)?.spheres).as_bytes())?;
            vec![out.clone()]
        }
    };
    match manner.json {
        true => print(&format!("{:#}\n", serde_json::json!({ "written": written }))),
        false => print(&written.iter().map(|path| format!("{}\n", path.display())).collect::<String>()),
    }
}

/// Writes the folder for LAMMPS; returns its files.
fn for_lammps(from: &Path, out: &Path, papers: Papers, interrupt: &Interrupt) -> Result<Vec<PathBuf>, Error> {
    let folder = from.is_dir().then(|| RunFolder::open(from)).transpose()?;
    let case = folder.as_ref().map_or_else(|| from.to_path_buf(), RunFolder::case);
    let job = papers.read(&case)?;
    let files = job.study.for_lammps(&job, folder.as_ref(), interrupt)?;
    create_folder(out)?;
    for (name, text) in &files {
        write_atomically(&out.join(name), text.as_bytes())?;
    }
    Ok(files.iter().map(|(name, _)| out.join(name)).collect())
}
