//! `veridem sweep`: runs a case for several values of its keys, with a run folder for each combination.

mod axis;
mod report;
mod summary;

use super::run::Limits;
use super::{OutputMode, print};
use crate::case::unmarked;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::{Finding, Lock, create_folder};
use crate::papers::Papers;
use crate::run::Job;
use crate::run::sweep::{Point, carry_out, distinct};
use crate::run::{Message, Reader};
use axis::{Axis, axes};
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};
use summary::{Summary, row};

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
/// Shortest interval between two versions of the summary.
const PAUSE: Duration = Duration::from_secs(1);

/// Runs every combination that has not finished yet and writes the summary.
pub(super) fn run(arguments: &Arguments, papers: Papers, excess: bool, manner: OutputMode) -> Result<(), Error> {
    let read = |file: &Path, text: &str| Ok(Job { excess, ..papers.parse(file, text)? });
    let Job { text, title, .. } = papers.read(&arguments.case)?;
    let axes = axes(&arguments.keys)?;
    let points = points(&arguments.case, &text, &axes, &read)?;
    let stem = arguments.case.file_stem().unwrap_or_default();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("run").join(stem));
    let interrupt = arguments.limits.interrupt()?;
    create_folder(&out)?;
    let _lock = Lock::take(&out)?;
    let mut summary = Summary::open(&out)?;
    for point in &points {
        let before = summary.row(&point.name).cloned();
        let (mut row, _) = row(&axes, point, &out, String::new())?;
        row.reason = before.filter(|before| before.status == row.status).map_or(String::new(), |before| before.reason);
        summary.put(row);
    }
    summary.write()?;
    let mut tried = None;
    if !manner.quiet {
        let (estimate, point) = estimate(&points, &out, arguments.force, &interrupt, &read)?;
        manner.say(estimate);
        tried = point.map(|point| &point.name);
    }
    let bar = if manner.quiet { ProgressBar::hidden() } else { ProgressBar::new(points.len() as u64) };
    let style = ProgressStyle::with_template("{bar:24} {pos}/{len} runs, {eta} left");
    bar.set_style(style.expect("the template is well formed"));
    let anew = |point: &Point| arguments.force && tried != Some(&point.name);
    let state = Mutex::new((summary, Instant::now(), Vec::new()));
    let note = |point: &Point, text: String| bar.suspend(|| manner.say(format!("{}: {text}", point.name)));
    carry_out(&points, &out, &interrupt, &read, &anew, &note, &|point, outcome| {
        let (told, reason) = match &outcome {
            // The trial may have finished the run.
            Ok(done) if *done || tried == Some(&point.name) => ("finished".into(), String::new()),
            Ok(_) => ("had finished before".into(), String::new()),
            Err(error) => (error.to_string(), error.to_string().replace('\n', "; ")),
        };
        bar.suspend(|| manner.say(format!("{}: {told}", point.name)));
        bar.inc(1);
        let (summary, written, failures) = &mut *state.lock().expect("no worker panics");
        failures.extend(outcome.err().map(|error| (point.name.clone(), error)));
        if let Ok((row, _)) = row(&axes, point, &out, reason) {
            summary.put(row);
        }
        // What cannot be written now is tried again at the end.
        if written.elapsed() >= PAUSE && summary.write().is_ok() {
            *written = Instant::now();
        }
    });
    bar.finish_and_clear();
    let (summary, _, mut failures) = state.into_inner().expect("no worker panics");
    summary.write()?;
    report::report(&title, &axes, &points, &out, &summary)?;
    manner.say(format!("report: {}", out.join("report.html").display()));
    print(&if manner.json { json(&axes, &points, &out, &summary, &failures)? } else { summary.table() })?;
    if interrupt.is_due() || failures.iter().any(|(_, error)| matches!(error, Error::Stopped(_))) {
        return Err(Error::Stopped(None));
    }
    let count = failures.len();
    failures.sort_by_key(|(name, _)| points.iter().position(|point| point.name == *name));
    match failures.into_iter().next() {
        None => Ok(()),
        Some((name, first)) => {
            let what = format!("{count} of {} runs did not finish", points.len());
            Err(Error::Runs(what, name, first.into()))
        }
    }
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

/// All combinations, each with its case; errors in any of them are found before the first is run.
fn points(file: &Path, text: &str, axes: &[Axis], read: Reader) -> Result<Vec<Point>, Error> {
    let base = serde_yaml::from_str(unmarked(text)).expect("the case has been read before");
    let count = axes.iter().map(|axis| axis.values.len()).product();
    let points: Vec<Point> = (0..count)
        .map(|mut number| {
            let mut values: Vec<(&str, &str)> = Vec::new();
            for Axis { key, values: choices } in axes.iter().rev() {
                values.push((key, &choices[number % choices.len()]));
                number /= choices.len();
            }
            values.reverse();
            Point::new(file, &base, &values, read)
        })
        .collect::<Result<_, Error>>()?;
    distinct(&points)?;
    Ok(points)
}

/// The runs of this sweep for programs, each with its results, or with the error that ended it.
fn json(
    axes: &[Axis],
    points: &[Point],
    out: &Path,
    summary: &Summary,
    failures: &[(String, Error)],
) -> Result<String, Error> {
    let object = |point: &Point| {
        let reason = summary.row(&point.name).map_or(String::new(), |row| row.reason.clone());
        let (row, findings) = row(axes, point, out, reason)?;
        let keys: serde_json::Map<String, serde_json::Value> =
            axes.iter().zip(&point.values).map(|(axis, value)| (axis.key.clone(), value.clone().into())).collect();
        let error = failures.iter().find(|(name, _)| *name == point.name).map(|(_, error)| error.to_json());
        Ok(serde_json::json!({
            "run": out.join(&point.name), "keys": keys, "status": row.status, "reason": row.reason, "error": error, "results": Finding::results(&findings)
        }))
    };
    let runs: Vec<serde_json::Value> = points.iter().map(object).collect::<Result<_, Error>>()?;
    Ok(format!("{:#}\n", serde_json::Value::Array(runs)))
}
