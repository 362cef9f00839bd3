//! `veridem book`: the equations as pages for a browser.

use super::{OutputMode, print};
use crate::book::files;
use crate::equations::Registry;
use crate::error::Error;
use crate::output::{create_folder, write_atomically};
use crate::papers::Papers;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The folder to write
    #[arg(long)]
    out: PathBuf,
    /// The repository that the pages describe
    #[arg(long, default_value = ".")]
    root: PathBuf,
}

/// Writes the pages and prints the path of the first.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let files = files(&arguments.root, &Registry::new(), papers)?;
    create_folder(&arguments.out)?;
    for (name, content) in &files {
        write_atomically(&arguments.out.join(name), content.as_bytes())?;
    }
    let first = arguments.out.join("index.html");
    match manner.json {
        true => print(&format!("{:#}\n", serde_json::json!({ "book": first }))),
        false => print(&format!("{}\n", first.display())),
    }
}
