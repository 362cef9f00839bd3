//! `veridem run`: a case from its file to its run folder.

use super::progress::Progress;
use super::{Manner, print};
use crate::case::{Amorphous, Case, Sample};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder, sha256_file, write_atomically};
use crate::run::{Control, Glance, Prepared};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Duration;

/// The arguments.
#[derive(clap::Args)]
pub struct Arguments {
    /// The case file
    case: PathBuf,
    /// Name of the run; that of the case file by default
    #[arg(long)]
    name: Option<String>,
    /// Folder that run folders are made in
    #[arg(long, value_name = "FOLDER", default_value = "run")]
    out: PathBuf,
    /// Replace a run folder of that name
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    limits: Limits,
}

/// When to stop a run before its end.
#[derive(clap::Args)]
pub struct Limits {
    /// Stop after this many seconds; the run can be resumed
    #[arg(long, value_name = "SECONDS")]
    max_time: Option<f64>,
    /// Stop after this many steps; the run can be resumed
    #[arg(long, value_name = "STEPS", hide = true)]
    stop_after_steps: Option<u64>,
}

impl Arguments {
    /// A run of this name, without limits.
    pub fn named(case: PathBuf, name: String, out: PathBuf) -> Self {
        Self { case, name: Some(name), out, force: false, limits: Limits { max_time: None, stop_after_steps: None } }
    }
}

impl Limits {
    /// The limits, and the signals, that stop this process.
    pub fn control(&self) -> Result<Control, Error> {
        let time = self.max_time.map(Duration::try_from_secs_f64).transpose();
        let time = time.map_err(|error| Error::Usage(format!("--max-time: {error}")))?;
        Control::new(time, self.stop_after_steps).map_err(|cause| Error::Io("signal handler".into(), cause))
    }
}

/// Runs the case.
pub fn run(arguments: &Arguments, manner: Manner) -> Result<(), Error> {
    let control = arguments.limits.control()?;
    let mut progress = Progress::new(manner);
    let ended = launch(arguments, &control, &mut |glance| progress.show(glance));
    progress.finish();
    let (folder, findings) = ended?;
    conclude(&folder, &findings, manner)
}

/// Makes the run folder, and goes from the beginning to the end; `show` is told how it goes.
pub fn launch(
    arguments: &Arguments,
    control: &Control,
    show: &mut dyn FnMut(Glance),
) -> Result<(RunFolder, Vec<Finding>), Error> {
    let (case, text) = Case::read(&arguments.case)?;
    let stem = || arguments.case.file_stem().unwrap_or_default().to_string_lossy().to_string();
    let root = arguments.out.join(arguments.name.clone().unwrap_or_else(stem));
    let mut inputs = BTreeMap::from([(arguments.case.display().to_string(), sha256_file(&arguments.case)?)]);
    let read = match &case.sample {
        Sample::Amorphous(Amorphous { load, .. }) => load.clone(),
        _ => None,
    };
    for file in read.into_iter().chain(case.soot_files()) {
        std::fs::metadata(&file).map_err(|cause| Error::NoInput(file.clone(), cause))?;
        inputs.insert(file.display().to_string(), sha256_file(&file)?);
    }
    // Whatever is wrong with the input is found before anything is written.
    let prepared = Prepared::new(&case)?;
    let folder = RunFolder::create(&root, arguments.force)?;
    write_atomically(&folder.case(), text.as_bytes())?;
    write_atomically(&folder.resolved(), case.resolved().as_bytes())?;
    let manifest = Manifest::begin(case.seed, inputs);
    let findings = prepared.start(&folder, manifest, control, show)?;
    Ok((folder, findings))
}

/// Tells what came out.
pub fn conclude(folder: &RunFolder, findings: &[Finding], manner: Manner) -> Result<(), Error> {
    manner.say(format!("finished: {}", folder.report().display()));
    if manner.json {
        let result = serde_json::json!({ "run": folder.root(), "results": findings });
        return print(&format!("{result:#}\n"));
    }
    print(&table(findings))
}

/// Findings as lines for people.
pub fn table(findings: &[Finding]) -> String {
    let width = findings.iter().map(|finding| finding.name.chars().count()).max().unwrap_or(0);
    let line = |Finding { name, value, unit, target }: &Finding| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let target = if target.is_empty() { String::new() } else { format!("  (target {target}{unit})") };
        format!("{name:width$}  {value}{unit}{target}\n")
    };
    findings.iter().map(line).collect()
}
