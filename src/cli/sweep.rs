//! `veridem sweep`: one case for many values of its keys, one process and one run folder for each combination.

use super::inspect::findings;
use super::run::{Arguments as Run, launch};
use super::{Manner, print};
use crate::case::Case;
use crate::case::units::decimal;
use crate::error::{AtPath, Error};
use crate::output::{Manifest, RunFolder, Status, write_atomically};
use crate::run::{Control, Glance};
use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use serde_yaml::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
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

/// One combination.
struct Point {
    name: String,
    values: Vec<String>,
    text: String,
}

/// How long the first run is tried to estimate how long all will take.
const TRIAL: Duration = Duration::from_secs(3);

/// Runs every combination that has not been run yet and writes the summary.
pub fn run(arguments: &Arguments, manner: Manner, threads: Option<u16>) -> Result<(), Error> {
    let (_, text) = Case::read(&arguments.case)?;
    let axes = arguments.keys.iter().map(|argument| axis(argument)).collect::<Result<Vec<_>, _>>()?;
    let points = points(&arguments.case, &text, &axes)?;
    let stem = arguments.case.file_stem().unwrap_or_default();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("run").join(stem));
    std::fs::create_dir_all(&out).at(&out)?;
    let workers = threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);
    if !manner.quiet {
        manner.say(estimate(&points, &out, workers)?);
    }
    let bar = if manner.quiet { ProgressBar::hidden() } else { ProgressBar::new(points.len() as u64) };
    let style = ProgressStyle::with_template("{bar:24} {pos}/{len} runs, {eta} left");
    bar.set_style(style.expect("the template is well formed"));
    let (next, failures) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..workers.min(points.len()) {
            scope.spawn(|| {
                while let Some(point) = points.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let outcome = execute(point, &out);
                    let failed = outcome.is_err();
                    let outcome = outcome.unwrap_or_else(|error| error.to_string());
                    bar.suspend(|| manner.say(format!("{}: {outcome}", point.name)));
                    bar.inc(1);
                    if failed {
                        failures.lock().expect("no worker panics").push(point.name.clone());
                    }
                }
            });
        }
    });
    bar.finish_and_clear();
    let summary = summary(&axes, &points, &out)?;
    write_atomically(&out.join("summary.csv"), summary.as_bytes())?;
    print(&summary)?;
    let failures = failures.into_inner().expect("no worker panics");
    match failures.len() {
        0 => Ok(()),
        n => Err(Error::Verification(format!("{n} of {} runs did not finish", points.len()))),
    }
}

/// Runs the first combination that has not been begun for a moment, on one core, and says how long all will take. Nothing of it is lost:
/// it is gone on with later.
fn estimate(points: &[Point], out: &Path, workers: usize) -> Result<String, Error> {
    let new: Vec<&Point> = points.iter().filter(|point| !out.join(&point.name).exists()).collect();
    let Some(point) = new.first() else { return Ok(format!("{} runs, all begun before", points.len())) };
    let run = Run::named(write_case(point, out)?, point.name.clone(), out.into());
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
    let ended = one.install(|| launch(&run, &Control::lasting(TRIAL), &mut show));
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

fn write_case(point: &Point, out: &Path) -> Result<PathBuf, Error> {
    let case = out.join(format!("{}.yaml", point.name));
    write_atomically(&case, point.text.as_bytes())?;
    Ok(case)
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
    let base: Value = serde_yaml::from_str(text).expect("the case has been read before");
    let count = axes.iter().map(|axis| axis.values.len()).product();
    (0..count)
        .map(|mut number| {
            let (mut case, mut values, mut parts) = (base.clone(), Vec::new(), Vec::new());
            for Axis { key, values: choices } in axes.iter().rev() {
                let value = &choices[number % choices.len()];
                number /= choices.len();
                set(&mut case, key, value)?;
                values.insert(0, value.clone());
                let short = key.rsplit('.').next().unwrap_or(key);
                parts.insert(0, format!("{short}={}", value.replace([' ', '/'], "")));
            }
            let text = serde_yaml::to_string(&case).expect("a case is plain data");
            let place = file.with_file_name(format!(
                "{} with {}",
                file.file_name().unwrap_or_default().display(),
                parts.join(" ")
            ));
            Case::parse(&place, &text)?;
            Ok(Point { name: parts.join(","), values, text })
        })
        .collect()
}

/// Writes a value behind a key such as `sample.hcp.size[1]`; sections on the way are made.
fn set(case: &mut Value, key: &str, value: &str) -> Result<(), Error> {
    let mut place = case;
    for part in key.split(['.', '[']) {
        place = match part.strip_suffix(']').map(str::parse::<usize>) {
            Some(Ok(number)) => place.get_mut(number),
            _ => place
                .as_mapping_mut()
                .map(|section| section.entry(part.into()).or_insert(Value::Mapping(Default::default()))),
        }
        .ok_or_else(|| Error::Usage(format!("`{key}`: there is no such key")))?;
    }
    *place = serde_yaml::from_str(value).map_err(|error| Error::Usage(format!("`{key}={value}`: {error}")))?;
    Ok(())
}

/// Runs one combination in a process of its own, or goes on with it, unless it has finished.
fn execute(point: &Point, out: &Path) -> Result<String, Error> {
    let root = out.join(&point.name);
    let status = RunFolder::open(&root).and_then(|folder| Ok((Manifest::read(&folder)?, folder)));
    let program = std::env::current_exe().at(Path::new("veridem"))?;
    let mut command = Command::new(program);
    command.args(["--quiet", "--threads", "1"]).stdout(Stdio::null()).stderr(Stdio::piped());
    if let Ok((manifest, folder)) = &status {
        if std::fs::read_to_string(folder.case()).at(&folder.case())? != point.text {
            return Err(Error::Usage("its run folder holds another case".into()));
        }
        if manifest.status == Status::Finished {
            return Ok("had finished before".into());
        }
    }
    match status {
        Ok((_, folder)) if !folder.checkpoints().is_empty()? => command.arg("resume").arg(&root),
        // One that was killed before its first checkpoint begins again.
        begun => {
            let case = write_case(point, out)?;
            let replace = begun.is_ok().then_some("--force");
            command.arg("run").arg(case).arg("--out").arg(out).arg("--name").arg(&point.name).args(replace)
        }
    };
    let output = command.output().at(&root)?;
    if output.status.success() {
        return Ok("finished".into());
    }
    Err(Error::Verification(String::from_utf8_lossy(&output.stderr).trim().to_string()))
}

/// One row a combination: its values, its status, its findings.
fn summary(axes: &[Axis], points: &[Point], out: &Path) -> Result<String, Error> {
    let mut names: Vec<(String, String)> = Vec::new();
    let mut rows = Vec::new();
    for point in points {
        let folder = RunFolder::open(&out.join(&point.name));
        let (status, found) = match folder {
            Ok(folder) => (format!("{:?}", Manifest::read(&folder)?.status).to_lowercase(), findings(&folder)?),
            Err(_) => ("failed".into(), Vec::new()),
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
