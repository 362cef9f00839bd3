//! `veridem sweep`: runs a case for several values of its keys, with one core and one run folder for each combination.

use super::{OutputMode, print};
use crate::case::units::decimal;
use crate::case::unmarked;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::{Finding, Manifest, RunFolder, create_folder, write_atomically};
use crate::papers::Papers;
use crate::run::sweep::{Point, carry_out, distinct};
use crate::run::{Message, Reader};
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Keys and their values: `seed=1,2,5`, `seed=1..8`, `output.series=1 ps,10 ps`, `limits.overlap=0.2..0.8:4`
    #[arg(required = true, value_name = "KEY=VALUES")]
    keys: Vec<String>,
    /// Folder for the run folders and summary.csv; by default `run/` and the name of the case file
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
}

/// A key and its values.
struct Axis {
    key: String,
    values: Vec<String>,
}

/// Duration of the trial from which the total time is estimated.
const TRIAL: Duration = Duration::from_secs(3);

/// Runs every combination that has not finished yet and writes the summary.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let read = |file: &Path, text: &str| papers.parse(file, text);
    let text = papers.read(&arguments.case)?.text;
    let axes = axes(&arguments.keys)?;
    let points = points(&arguments.case, &text, &axes, &read)?;
    let stem = arguments.case.file_stem().unwrap_or_default();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("run").join(stem));
    create_folder(&out)?;
    let interrupt = Interrupt::new(None, None).map_err(|cause| Error::Io("signal handler".into(), cause))?;
    let mut tried = None;
    if !manner.quiet {
        let (estimate, point) = estimate(&points, &out, &interrupt, &read)?;
        manner.say(estimate);
        tried = point.map(|point| &point.name);
    }
    let bar = if manner.quiet { ProgressBar::hidden() } else { ProgressBar::new(points.len() as u64) };
    let style = ProgressStyle::with_template("{bar:24} {pos}/{len} runs, {eta} left");
    bar.set_style(style.expect("the template is well formed"));
    let failures = Mutex::new(Vec::new());
    carry_out(&points, &out, &interrupt, &read, &|point, outcome| {
        let failed = outcome.is_err();
        let outcome = match outcome {
            // The trial may have finished the run.
            Ok(done) if done || tried == Some(&point.name) => "finished".into(),
            Ok(_) => "had finished before".into(),
            Err(error) => error.to_string(),
        };
        bar.suspend(|| manner.say(format!("{}: {outcome}", point.name)));
        bar.inc(1);
        if failed {
            failures.lock().expect("no worker panics").push(point.name.clone());
        }
    });
    bar.finish_and_clear();
    let rows = rows(&points, &out)?;
    let table = table(&axes, &rows);
    write_atomically(&out.join("summary.csv"), table.as_bytes())?;
    print(&if manner.json { json(&axes, &rows) } else { table })?;
    let failures = failures.into_inner().expect("no worker panics");
    match failures.len() {
        _ if interrupt.is_due() => Err(Error::Stopped(None)),
        0 => Ok(()),
        n => Err(Error::Verification(format!("{n} of {} runs did not finish", points.len()))),
    }
}

/// Runs the first new combination for a moment, on one core, and returns an estimate of the total time, and the name of the
/// combination. Nothing is lost: the run is resumed later.
fn estimate<'a>(
    points: &'a [Point],
    out: &Path,
    interrupt: &Interrupt,
    read: Reader,
) -> Result<(String, Option<&'a Point>), Error> {
    let workers = rayon::current_num_threads();
    let new: Vec<&Point> = points.iter().filter(|point| !out.join(&point.name).exists()).collect();
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
        let job = read(&point.write(out)?, &point.text)?;
        job.launch(&out.join(&point.name), false, &interrupt.within(TRIAL), &mut show)
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

/// The axes of the sweep, each key once.
fn axes(arguments: &[String]) -> Result<Vec<Axis>, Error> {
    let mut axes: Vec<Axis> = Vec::new();
    for argument in arguments {
        let axis = axis(argument)?;
        if axes.iter().any(|other| other.key == axis.key) {
            return Err(Error::Usage(format!("`{argument}`: the key `{}` is given twice", axis.key)));
        }
        axes.push(axis);
    }
    Ok(axes)
}

/// `seed=1..3` as the values 1, 2, 3; `x=0..1:5` as five values from 0 to 1; `d=1 nm,2 nm` as they stand.
fn axis(argument: &str) -> Result<Axis, Error> {
    let wrong = |what: &str| Error::Usage(format!("`{argument}`: {what}"));
    let (key, values) = argument.split_once('=').ok_or_else(|| wrong("expected KEY=VALUES"))?;
    let Some((first, rest)) = values.split_once("..") else {
        return Ok(Axis { key: key.into(), values: values.split(',').map(|value| value.trim().into()).collect() });
    };
    let (range, unit) = rest.split_once(' ').map_or((rest, String::new()), |(range, unit)| (range, format!(" {unit}")));
    let values: Vec<String> = match range.split_once(':') {
        None => {
            let whole = |text: &str| {
                text.parse::<i64>().map_err(|_| wrong("a range without `:COUNT` must have whole numbers as limits"))
            };
            (whole(first)?..=whole(range)?).map(|n| format!("{n}{unit}")).collect()
        }
        Some((last, count)) => {
            let number = |text: &str| text.parse::<f64>().map_err(|_| wrong("expected FIRST..LAST:COUNT"));
            let count = count.parse::<u32>().ok().filter(|count| *count >= 2);
            let (first, last) = (number(first)?, number(last)?);
            let count = count.ok_or_else(|| wrong("expected a count of at least 2"))?;
            let step = |k: u32| first + (last - first) * f64::from(k) / f64::from(count - 1);
            (0..count).map(|k| format!("{}{unit}", decimal(step(k)))).collect()
        }
    };
    if values.is_empty() {
        return Err(wrong("expected an increasing range"));
    }
    Ok(Axis { key: key.into(), values })
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

/// The outcome of a combination.
struct Row<'a> {
    point: &'a Point,
    folder: PathBuf,
    status: String,
    findings: Vec<Finding>,
}

fn rows<'a>(points: &'a [Point], out: &Path) -> Result<Vec<Row<'a>>, Error> {
    let row = |point: &'a Point| {
        let folder = out.join(&point.name);
        let begun = RunFolder::open(&folder).and_then(|run| Ok((Manifest::read(&run)?.status, run)));
        let (status, findings) = match begun {
            Ok((status, run)) => (format!("{status:?}").to_lowercase(), Finding::of_run(&run)?),
            Err(_) => ("not run".into(), Vec::new()),
        };
        Ok(Row { point, folder, status, findings })
    };
    points.iter().map(row).collect()
}

/// One row per combination: its values, its status, its findings.
fn table(axes: &[Axis], rows: &[Row]) -> String {
    let mut names: Vec<(&str, &str)> = Vec::new();
    for finding in rows.iter().flat_map(|row| &row.findings) {
        let name = (&*finding.name, &*finding.unit);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let headed = |(name, unit): &(&str, &str)| {
        if unit.is_empty() { name.to_string() } else { format!("{name} [{unit}]") }
    };
    let head = axes.iter().map(|axis| axis.key.clone()).chain(["status".into()]).chain(names.iter().map(headed));
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(head).expect("memory can always grow");
    for Row { point, status, findings, .. } in rows {
        let value = |(name, _): &(&str, &str)| {
            findings.iter().find(|f| f.name == *name).map_or(String::new(), |f| f.value.clone())
        };
        let cells = point.values.iter().cloned().chain([status.clone()]).chain(names.iter().map(value));
        table.write_record(cells).expect("memory can always grow");
    }
    let bytes = table.into_inner().expect("memory can always grow");
    String::from_utf8(bytes).expect("what was written is text")
}

/// The same for programs.
fn json(axes: &[Axis], rows: &[Row]) -> String {
    let object = |Row { point, folder, status, findings }: &Row| {
        let keys: serde_json::Map<String, serde_json::Value> =
            axes.iter().zip(&point.values).map(|(axis, value)| (axis.key.clone(), value.clone().into())).collect();
        serde_json::json!({ "run": folder, "keys": keys, "status": status, "results": findings })
    };
    format!("{:#}\n", serde_json::Value::Array(rows.iter().map(object).collect()))
}
