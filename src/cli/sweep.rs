//! `veridem sweep`: one case for many values of its keys, one core and one run folder for each combination.

use super::{Manner, print};
use crate::case::units::decimal;
use crate::case::{Case, unmarked};
use crate::error::{AtPath, Error};
use crate::output::{Finding, Manifest, RunFolder, write_atomically};
use crate::run::sweep::{Point, carry_out};
use crate::run::{Control, Glance, launch};
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// The arguments.
#[derive(clap::Args)]
pub struct Arguments {
    /// The case file
    case: PathBuf,
    /// What is varied: `seed=1,2,5`, `seed=1..8`, `sample.hcp.diameter=0.6 d_c,1.2 d_c`, `model.wear.poisson_ratio=0..0.25:6`
    #[arg(required = true, value_name = "KEY=VALUES")]
    keys: Vec<String>,
    /// Folder that the run folders and summary.csv are made in; by default `run/` and the name of the case file
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
}

/// A key and the values it takes.
struct Axis {
    key: String,
    values: Vec<String>,
}

/// How long the first run is tried to estimate how long all will take.
const TRIAL: Duration = Duration::from_secs(3);

/// Runs every combination that has not been run yet and writes the summary.
pub fn run(arguments: &Arguments, manner: Manner) -> Result<(), Error> {
    let (_, text) = Case::read(&arguments.case)?;
    let axes = arguments.keys.iter().map(|argument| axis(argument)).collect::<Result<Vec<_>, _>>()?;
    let points = points(&arguments.case, &text, &axes)?;
    let stem = arguments.case.file_stem().unwrap_or_default();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("run").join(stem));
    std::fs::create_dir_all(&out).at(&out)?;
    if !manner.quiet {
        manner.say(estimate(&points, &out)?);
    }
    let bar = if manner.quiet { ProgressBar::hidden() } else { ProgressBar::new(points.len() as u64) };
    let style = ProgressStyle::with_template("{bar:24} {pos}/{len} runs, {eta} left");
    bar.set_style(style.expect("the template is well formed"));
    let failures = Mutex::new(Vec::new());
    let control = Control::new(None, None).map_err(|cause| Error::Io("signal handler".into(), cause))?;
    carry_out(&points, &out, &control, &|point, outcome| {
        let failed = outcome.is_err();
        let outcome = match outcome {
            Ok(true) => "finished".into(),
            Ok(false) => "had finished before".into(),
            Err(error) => error.to_string(),
        };
        bar.suspend(|| manner.say(format!("{}: {outcome}", point.name)));
        bar.inc(1);
        if failed {
            failures.lock().expect("no worker panics").push(point.name.clone());
        }
    });
    bar.finish_and_clear();
    let summary = summary(&axes, &points, &out)?;
    write_atomically(&out.join("summary.csv"), summary.as_bytes())?;
    print(&summary)?;
    let failures = failures.into_inner().expect("no worker panics");
    match failures.len() {
        _ if control.stops(0) => Err(Error::Stopped(None)),
        0 => Ok(()),
        n => Err(Error::Verification(format!("{n} of {} runs did not finish", points.len()))),
    }
}

/// Runs the first combination that has not been begun for a moment, on one core, and says how long all will take. Nothing of it is lost:
/// it is gone on with later.
fn estimate(points: &[Point], out: &Path) -> Result<String, Error> {
    let workers = rayon::current_num_threads();
    let new: Vec<&Point> = points.iter().filter(|point| !out.join(&point.name).exists()).collect();
    let Some(point) = new.first() else { return Ok(format!("{} runs, all begun before", points.len())) };
    let (mut stage, mut since, mut pace) = (String::new(), Instant::now(), None);
    let mut show = |glance: Glance| {
        if stage != glance.stage {
            (stage, since, pace) = (glance.stage.into(), Instant::now(), None);
        } else if glance.step > 0 {
            pace = Some((since.elapsed().div_f64(glance.step as f64), glance.steps));
        }
    };
    let begun = Instant::now();
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let ended =
        one.install(|| launch(&point.write(out)?, &out.join(&point.name), false, &Control::lasting(TRIAL), &mut show));
    let (each, what) = match (ended, pace) {
        (Ok(_), _) => (begun.elapsed(), String::new()),
        (Err(Error::Stopped(_)), Some((step, steps))) => {
            (step.mul_f64(steps as f64), format!(" (`{stage}` alone, at most {steps} steps of {step:.1?})"))
        }
        (Err(error), _) => return Ok(format!("no estimate of the time: {error}")),
    };
    let all = each.mul_f64(new.len() as f64 / workers.min(new.len()) as f64);
    Ok(format!(
        "{} runs, {} of them new: about {} on {workers} cores{what}",
        points.len(),
        new.len(),
        HumanDuration(all)
    ))
}

/// `seed=1..3` as the values 1, 2, 3; `x=0..1:5` as five values from 0 to 1; `d=1 nm,2 nm` as they stand.
fn axis(argument: &str) -> Result<Axis, Error> {
    let wrong = |what: &str| Error::Usage(format!("`{argument}`: {what}"));
    let (key, values) = argument.split_once('=').ok_or_else(|| wrong("expected KEY=VALUES"))?;
    let Some((first, rest)) = values.split_once("..") else {
        return Ok(Axis { key: key.into(), values: values.split(',').map(|value| value.trim().into()).collect() });
    };
    let (range, unit) = rest.split_once(' ').map_or((rest, String::new()), |(range, unit)| (range, format!(" {unit}")));
    let values = match range.split_once(':') {
        None => {
            let whole =
                |text: &str| text.parse::<i64>().map_err(|_| wrong("a range without `:COUNT` goes over whole numbers"));
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
    Ok(Axis { key: key.into(), values })
}

/// All combinations, each with its case; what is wrong with any of them is found before the first is run.
fn points(file: &Path, text: &str, axes: &[Axis]) -> Result<Vec<Point>, Error> {
    let base = serde_yaml::from_str(unmarked(text)).expect("the case has been read before");
    let count = axes.iter().map(|axis| axis.values.len()).product();
    (0..count)
        .map(|mut number| {
            let mut values: Vec<(&str, &str)> = Vec::new();
            for Axis { key, values: choices } in axes.iter().rev() {
                values.push((key, &choices[number % choices.len()]));
                number /= choices.len();
            }
            values.reverse();
            Point::new(file, &base, &values)
        })
        .collect()
}

/// One row a combination: its values, its status, its findings.
fn summary(axes: &[Axis], points: &[Point], out: &Path) -> Result<String, Error> {
    let mut names: Vec<(String, String)> = Vec::new();
    let mut rows = Vec::new();
    for point in points {
        let folder = RunFolder::open(&out.join(&point.name));
        let (status, found) = match folder {
            Ok(folder) => (format!("{:?}", Manifest::read(&folder)?.status).to_lowercase(), Finding::of_run(&folder)?),
            Err(_) => ("not run".into(), Vec::new()),
        };
        for finding in &found {
            let name = (finding.name.clone(), finding.unit.clone());
            if !names.contains(&name) {
                names.push(name);
            }
        }
        rows.push((point, status, found));
    }
    let headed =
        |(name, unit): &(String, String)| if unit.is_empty() { name.clone() } else { format!("{name} [{unit}]") };
    let head = axes.iter().map(|axis| axis.key.clone()).chain(["status".into()]).chain(names.iter().map(headed));
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(head).expect("memory can always grow");
    for (point, status, found) in rows {
        let value = |(name, _): &(String, String)| {
            found.iter().find(|f| f.name == *name).map_or(String::new(), |f| f.value.clone())
        };
        let cells = point.values.iter().cloned().chain([status]).chain(names.iter().map(value));
        table.write_record(cells).expect("memory can always grow");
    }
    let bytes = table.into_inner().expect("memory can always grow");
    Ok(String::from_utf8(bytes).expect("what was written is text"))
}
