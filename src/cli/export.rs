//! `veridem export`: writes the state of a case or of a run for another program.

use super::run::Limits;
use super::{OutputMode, print};
use crate::error::Error;
use crate::output::{RunFolder, create_folder, write_atomically};
use crate::papers::Papers;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file, of whose first stage the start is written; or a run folder, of which the latest checkpoint is
    from: PathBuf,
    /// For LAMMPS with the plugin of `bindings/lammps`: data file, history of the pairs, input script
    #[arg(long, required = true)]
    lammps: bool,
    /// Folder of the files, which must not exist
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
}

/// Writes the files.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let interrupt = Limits::default().interrupt()?;
    let folder = arguments.from.is_dir().then(|| RunFolder::open(&arguments.from)).transpose()?;
    let case = folder.as_ref().map_or_else(|| arguments.from.clone(), RunFolder::case);
    if arguments.out.exists() {
        return Err(Error::Usage(format!("{}: exists already", arguments.out.display())));
    }
    let job = papers.read(&case)?;
    let files = job.study.for_lammps(&job, folder.as_ref(), &interrupt)?;
    create_folder(&arguments.out)?;
    for (name, text) in &files {
        write_atomically(&arguments.out.join(name), text.as_bytes())?;
    }
    let written: Vec<PathBuf> = files.iter().map(|(name, _)| arguments.out.join(name)).collect();
    match manner.json {
        true => print(&format!("{:#}\n", serde_json::json!({ "written": written }))),
        false => print(&written.iter().map(|path| format!("{}\n", path.display())).collect::<String>()),
    }
}
