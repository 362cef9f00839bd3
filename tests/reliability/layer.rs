//! The layer between the program and its files: see `layer.c`.

use crate::user::{folder, told, veridem};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The layer, compiled.
fn library() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("layer-{}.so", std::process::id()));
        let source = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reliability/layer.c");
        let built =
            Command::new("cc").args(["-O1", "-shared", "-fPIC", "-o"]).arg(&path).args([source, "-ldl"]).output();
        let built = built.expect("a C compiler links every Rust program here");
        assert!(built.status.success(), "{}", told(&built));
        path
    })
}

/// The program above the layer.
pub(crate) fn above(place: &Path, arguments: &[&str], settings: &[(&str, String)]) -> Output {
    let mut command = veridem(place, arguments);
    command.env("LD_PRELOAD", library()).env("LAYER_ROOT", place.canonicalize().unwrap());
    command.envs(settings.iter().map(|(name, value)| (name, value))).output().unwrap()
}

/// The journal of all file calls of a command, and its outcome.
pub(crate) fn journal(place: &Path, arguments: &[&str]) -> (Vec<String>, Output) {
    let elsewhere = folder();
    let path = elsewhere.path().join("journal");
    let output = above(place, arguments, &[("LAYER_JOURNAL", path.display().to_string())]);
    let text = std::fs::read_to_string(path).expect("the layer is loaded");
    (text.lines().map(String::from).collect(), output)
}
