//! `veridem movie`: draws the frames of a run into a file that plays by itself.

use super::{OutputMode, print};
use crate::error::Error;
use crate::output::RunFolder;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The run folder
    run: PathBuf,
    /// The file, an animated GIF; by default `movie.gif` in the run folder
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Draws and writes the film.
pub(super) fn run(arguments: &Arguments, manner: OutputMode) -> Result<(), Error> {
    let folder = RunFolder::open(&arguments.run)?;
    let file = arguments.out.clone().unwrap_or_else(|| folder.movie());
    let frames = crate::figures::movie(&folder, &file)?;
    match manner.json {
        true => print(&format!("{:#}\n", serde_json::json!({ "movie": file, "frames": frames }))),
        false => print(&format!("{}\n", file.display())),
    }
}
