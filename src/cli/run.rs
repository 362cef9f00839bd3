//! `veridem run`: runs a case into a run folder.

use super::progress::Progress;
use super::{OutputMode, print};
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::{Finding, RunFolder};
use crate::papers::Papers;
use crate::run::Job;
use std::ffi::{OsStr, OsString};
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Name of the run, a single file name; by default the name of the case file
    #[arg(long)]
    name: Option<OsString>,
    /// Folder in which run folders are created
    #[arg(long, value_name = "FOLDER", default_value = "run")]
    out: PathBuf,
    /// Replace an existing run folder of that name
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    limits: Limits,
}

/// Limits at which a run is stopped before its end.
#[derive(clap::Args, Default)]
pub(super) struct Limits {
    /// Stop after this many seconds; the run can be resumed
    #[arg(long, value_name = "SECONDS")]
    max_time: Option<f64>,
    /// Stop after this many steps; the run can be resumed
    #[arg(long, value_name = "STEPS", hide = true)]
    stop_after_steps: Option<u64>,
}

impl Limits {
    /// The limits and the signals that stop this process.
    pub(super) fn interrupt(&self) -> Result<Interrupt, Error> {
        let time = self.max_time.map(Duration::try_from_secs_f64).transpose();
        let time = time.map_err(|error| Error::Usage(format!("--max-time: {error}")))?;
        Interrupt::new(time, self.stop_after_steps).map_err(|cause| Error::Io("signal handler".into(), cause))
    }
}

/// Runs the case.
pub(super) fn run(arguments: &Arguments, papers: Papers, excess: bool, manner: OutputMode) -> Result<(), Error> {
    let interrupt = arguments.limits.interrupt()?;
    let name = arguments.name.as_deref().or(arguments.case.file_stem()).unwrap_or_default();
    if !is_a_name(name) {
        return Err(Error::Usage(format!("--name: found `{}`, expected a single file name", name.display())));
    }
    let root = arguments.out.join(name);
    let job = Job { excess, ..papers.read(&arguments.case)? };
    // A signal ends the reading early, and without derived values.
    Interrupt::of_process().check()?;
    let mut progress = Progress::new(manner);
    let ended = job.launch(&root, arguments.force, &interrupt, &mut |message| progress.tell(message));
    progress.finish();
    let (folder, findings) = ended?;
    conclude(&folder, &findings, manner)
}

/// Whether a folder of this name lies in the folder that it is joined to, on any operating system.
fn is_a_name(name: &OsStr) -> bool {
    let mut parts = Path::new(name).components();
    matches!((parts.next(), parts.next()), (Some(Component::Normal(part)), None) if part == name)
        && !name.to_string_lossy().contains(['/', '\\', ':', '\0'])
}

/// Reports the findings.
pub(super) fn conclude(folder: &RunFolder, findings: &[Finding], manner: OutputMode) -> Result<(), Error> {
    manner.say(format!("finished: {}", folder.report().display()));
    if manner.json {
        let result = serde_json::json!({ "run": folder.root(), "results": Finding::results(findings) });
        return print(&format!("{result:#}\n"));
    }
    print(&table(findings))
}

/// Findings as lines for people.
pub(super) fn table(findings: &[Finding]) -> String {
    let width = findings.iter().map(|finding| finding.name.chars().count()).max().unwrap_or(0);
    let line = |finding: &Finding| {
        let unit = if finding.unit.is_empty() { String::new() } else { format!(" {}", finding.unit) };
        let target = finding.target.map_or(String::new(), |_| format!("  (target {}{unit})", finding.target_text()));
        format!("{:width$}  {}{target}\n", finding.name, finding.sentence())
    };
    findings.iter().map(line).collect()
}
