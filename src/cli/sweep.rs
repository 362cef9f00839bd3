//! `veridem sweep`: runs a case for several values of its keys, with a run folder for each combination.

use super::run::Limits;
use super::{OutputMode, print};
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::papers::Papers;
use crate::run::Job;
use crate::run::sweep::{Point, Sweep};
use crate::run::{Message, Reader};
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Keys and their values, separated by commas outside of brackets and quotes: `seed=1,2,5`, `seed=1..8`, `output.series=1 ps,10 ps`,
    /// `limits.overlap=0.2..0.8:4` (four values), `sample.hcp.size=[5 d_c, 5 d_c, 3 d_c],[9 d_c, 9 d_c, 3 d_c]`, `sample.hcp.size[0]=5 d_c,9 d_c`
    #[arg(required = true, value_name = "KEY=VALUES")]
    keys: Vec<String>,
    /// Folder for the run folders and summary.csv, to which every sweep adds its rows; by default `run/` and the name of the case file
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Start every run anew, also those that have finished
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    limits: Limits,
}

/// Duration of the trial from which the total time is estimated.
const TRIAL: Duration = Duration::from_secs(3);

/// Runs every combination that has not finished yet and writes the summary.
pub(super) fn run(arguments: &Arguments, papers: Papers, excess: bool, manner: OutputMode) -> Result<(), Error> {
    let read = |file: &Path, text: &str| Ok(Job { excess, ..papers.parse(file, text)? });
    let stem = arguments.case.file_stem().unwrap_or_default();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("run").join(stem));
    let case = papers.read(&arguments.case)?;
    let interrupt = arguments.limits.interrupt()?;
    let sweep = Sweep::begin(&case, &arguments.keys, &out, &read)?;
    let points = sweep.points();
    let mut tried = None;
    if !manner.quiet {
        let (estimate, point) = estimate(points, &out, arguments.force, &interrupt, &read)?;
        manner.say(estimate);
        tried = point.map(|point| &point.name);
    }
    let bar = if manner.quiet { ProgressBar::hidden() } else { ProgressBar::new(points.len() as u64) };
    let style = ProgressStyle::with_template("{bar:24} {pos}/{len} runs, {eta} left");
    bar.set_style(style.expect("the template is well formed"));
    let anew = |point: &Point| arguments.force && tried != Some(&point.name);
    let note = |point: &Point, text: String| bar.suspend(|| manner.say(format!("{}: {text}", point.name)));
    let failures = sweep.carry_out(&interrupt, &read, &anew, &note, &|point, outcome| {
        let told = match outcome {
            // The trial may have finished the run.
            Ok(done) if *done || tried == Some(&point.name) => "finished".into(),
            Ok(_) => "had finished before".into(),
            Err(error) => error.to_string(),
        };
        bar.suspend(|| manner.say(format!("{}: {told}", point.name)));
        bar.inc(1);
    });
    bar.finish_and_clear();
    let failures = failures?;
    manner.say(format!("report: {}", out.join("report.html").display()));
    print(&if manner.json { sweep.json(&failures)? } else { sweep.table() })?;
    sweep.verdict(failures, &interrupt)
}

/// Runs the first new combination for a moment, on one core, and returns an estimate of the total time, and the name of the
/// combination. Nothing is lost: the run is resumed later.
fn estimate<'a>(
    points: &'a [Point],
    out: &Path,
    force: bool,
    interrupt: &Interrupt,
    read: Reader,
) -> Result<(String, Option<&'a Point>), Error> {
    let workers = rayon::current_num_threads();
    let new: Vec<&Point> = points.iter().filter(|point| force || !out.join(&point.name).exists()).collect();
    let Some(&point) = new.first() else { return Ok((format!("{} runs, all started before", points.len()), None)) };
    let (mut stage, mut since, mut pace) = (String::new(), Instant::now(), None);
    let mut show = |message: Message| {
        let Message::Progress(state) = message else { return };
        if stage != state.stage {
            (stage, since, pace) = (state.stage.into(), Instant::now(), None);
        } else if state.step > 0 {
            pace = Some((since.elapsed().div_f64(state.step as f64), state.steps));
        }
    };
    let begun = Instant::now();
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let ended = one.install(|| {
        let job = read(&point.file, &point.text)?;
        job.launch(&out.join(&point.name), force, &interrupt.within(TRIAL), &mut show)
    });
    let (each, what) = match (ended, pace) {
        (Ok(_), _) => (begun.elapsed(), String::new()),
        (Err(Error::Stopped(_)), Some((step, steps))) => {
            (step.mul_f64(steps as f64), format!(" (`{stage}` alone, at most {steps} steps of {step:.1?})"))
        }
        (Err(error), _) => return Ok((format!("no estimate of the time: {error}"), Some(point))),
    };
    let all = each.mul_f64(new.len() as f64 / workers.min(new.len()) as f64);
    let (count, time) = (points.len(), HumanDuration(all));
    Ok((format!("{count} runs, {} of them new: about {time} on {workers} cores{what}", new.len()), Some(point)))
}
