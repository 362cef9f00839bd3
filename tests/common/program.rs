//! The program.

use std::path::Path;
use std::process::{Command, Output};

/// Runs it in a folder.
pub(crate) fn veridem(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_veridem")).current_dir(folder).args(arguments).output().expect("the program")
}
