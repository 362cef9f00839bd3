//! Golden trajectories: motions with a known solution, kept in `golden/trajectories`, each moved and compared by the paper that it belongs to.

use rayon::prelude::*;
use serde_json::Value;
use std::fmt::Display;
use std::path::Path;
use veridem_spec::Vec3;
use veridem_spec::numbers::Reference;

const SCHEMA: &str = "veridem golden trajectories 1";
/// A time in a file that asks for more steps is wrong: it is not waited for.
const MOST_STEPS: f64 = 1e7;
/// Most complaints of a run that are told: a motion that is off once stays off.
const TOLD: usize = 4;

/// A file of trajectories, and what it is compared with.
pub struct Trajectory {
    /// Its name in `golden/trajectories`.
    pub file: &'static str,
    /// Moves the system of one run and compares it with the samples; the error is what the run lacks, or why the system cannot be moved.
    pub check: fn(&Run, &mut Complaints) -> Result<(), String>,
}

/// Checks every file of trajectories; each belongs to one of these, and each of these to a file.
pub fn check_trajectories(golden: &Path, trajectories: &[&Trajectory]) -> Vec<String> {
    let folder = golden.join("trajectories");
    let mut wrong =
        claims(&folder, trajectories).unwrap_or_else(|error| vec![format!("{}: {error}", folder.display())]);
    let compared = trajectories.par_iter().map(|trajectory| {
        let path = folder.join(trajectory.file);
        let complaints = read(&path).map_or_else(|error| vec![error], |runs| check_runs(&runs, trajectory));
        complaints.into_iter().map(|complaint| format!("{}: {complaint}", path.display())).collect::<Vec<_>>()
    });
    wrong.extend(compared.collect::<Vec<_>>().into_iter().flatten());
    wrong
}

/// What is in the folder and compared by none of the trajectories, or by several.
fn claims(folder: &Path, trajectories: &[&Trajectory]) -> std::io::Result<Vec<String>> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name())).collect::<std::io::Result<_>>()?;
    names.sort();
    let complaint = |name| {
        let path = folder.join(&name);
        match trajectories.iter().filter(|trajectory| *trajectory.file == name).count() {
            0 => Some(format!("{}: no paper compares it", path.display())),
            1 => None,
            papers => Some(format!("{}: compared by {papers} entries, expected one", path.display())),
        }
    };
    Ok(names.into_iter().filter_map(complaint).collect())
}

fn read(path: &Path) -> Result<Vec<Value>, String> {
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
    let file: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    if file["schema"] != SCHEMA {
        return Err(format!("found the schema {}, expected \"{SCHEMA}\"", file["schema"]));
    }
    match file["runs"].as_array() {
        Some(runs) if !runs.is_empty() => Ok(runs.clone()),
        _ => Err("expected a list of `runs`".into()),
    }
}

fn check_runs(runs: &[Value], trajectory: &Trajectory) -> Vec<String> {
    let of_run = |(number, value): (usize, &Value)| {
        let name = value["name"].as_str().map_or_else(|| format!("run {number}"), |name| format!("run `{name}`"));
        let mut complaints = Complaints::default();
        if let Err(error) = (trajectory.check)(&Run(value), &mut complaints) {
            complaints.0.push(error);
        }
        let more = complaints.0.len().saturating_sub(TOLD);
        complaints.0.truncate(TOLD);
        complaints.0.extend((more > 0).then(|| format!("{more} more complaints")));
        complaints.0.into_iter().map(|complaint| format!("{name}, {complaint}")).collect::<Vec<_>>()
    };
    runs.par_iter().enumerate().map(of_run).collect::<Vec<_>>().concat()
}

/// The quantities of a run that do not agree.
#[derive(Default)]
pub struct Complaints(Vec<String>);

impl Complaints {
    /// Compares a computed number with that of the file. What is not a number agrees with nothing.
    pub fn near(&mut self, what: impl Display, found: f64, expected: f64, tolerance: f64) {
        let agrees = (found - expected).abs() <= tolerance;
        if !agrees {
            self.0.push(format!("{what}: found {found:?}, expected {expected:?} to {tolerance:e}"));
        }
    }

    /// Compares a computed vector with that of the file, by the length of their difference.
    pub fn near_vector(&mut self, what: impl Display, found: Vec3<f64>, expected: Vec3<f64>, tolerance: f64) {
        let agrees = (found - expected).norm() <= tolerance;
        if !agrees {
            self.0.push(format!("{what}: found {:?}, expected {:?} to {tolerance:e}", found.0, expected.0));
        }
    }
}

/// A run of a file: its parameters and samples. Errors name the key.
pub struct Run<'a>(&'a Value);

impl Run<'_> {
    /// A number, or a decimal or fraction as text.
    ///
    /// # Errors
    ///
    /// If it is missing or something else.
    pub fn exact(&self, key: &str) -> Result<Reference, String> {
        exact(&self.0[key]).ok_or_else(|| format!("`{key}`: found {}, expected a number", self.0[key]))
    }

    /// The `f64` that is nearest to [`exact`](Self::exact).
    ///
    /// # Errors
    ///
    /// If it is missing or something else.
    pub fn number(&self, key: &str) -> Result<f64, String> {
        self.exact(key).map(|number| number.to_f64())
    }

    /// A number; what a run does not have is nought.
    ///
    /// # Errors
    ///
    /// If it is something else.
    pub fn number_or_nought(&self, key: &str) -> Result<f64, String> {
        if self.0.get(key).is_some() { self.number(key) } else { Ok(0.0) }
    }

    /// `N` numbers.
    ///
    /// # Errors
    ///
    /// If they are missing or something else.
    pub fn numbers<const N: usize>(&self, key: &str) -> Result<[f64; N], String> {
        let numbers =
            row(&self.0[key]).ok_or_else(|| format!("`{key}`: found {}, expected {N} numbers", self.0[key]))?;
        Ok(numbers.map(|number| number.to_f64()))
    }

    /// A word.
    ///
    /// # Errors
    ///
    /// If it is missing or something else.
    pub fn word(&self, key: &str) -> Result<&str, String> {
        self.0[key].as_str().ok_or_else(|| format!("`{key}`: found {}, expected a word", self.0[key]))
    }

    /// True or false.
    ///
    /// # Errors
    ///
    /// If it is missing or something else.
    pub fn flag(&self, key: &str) -> Result<bool, String> {
        self.0[key].as_bool().ok_or_else(|| format!("`{key}`: found {}, expected true or false", self.0[key]))
    }

    /// The rows of its samples, at least two, of `N` numbers each.
    ///
    /// # Errors
    ///
    /// If they are missing or something else.
    pub fn exact_samples<const N: usize>(&self) -> Result<Vec<[Reference; N]>, String> {
        let rows = self.0["samples"].as_array().filter(|rows| rows.len() > 1);
        let numbers = |(number, value): (usize, &Value)| {
            row(value).ok_or_else(|| format!("sample {number}: found {value}, expected {N} numbers"))
        };
        rows.ok_or("`samples`: expected two or more")?.iter().enumerate().map(numbers).collect()
    }

    /// The `f64` that are nearest to [`exact_samples`](Self::exact_samples).
    ///
    /// # Errors
    ///
    /// If they are missing or something else.
    pub fn samples<const N: usize>(&self) -> Result<Vec<[f64; N]>, String> {
        let nearest = |row: [Reference; N]| row.map(|number| number.to_f64());
        Ok(self.exact_samples()?.into_iter().map(nearest).collect())
    }
}

fn exact(value: &Value) -> Option<Reference> {
    if let Some(number) = value.as_f64() {
        return Some(Reference::exact(number));
    }
    let text = value.as_str()?;
    match text.split_once('/') {
        Some((numerator, denominator)) => Some(Reference::parse(numerator)? / Reference::parse(denominator)?),
        None => Reference::parse(text),
    }
}

fn row<const N: usize>(value: &Value) -> Option<[Reference; N]> {
    value.as_array()?.iter().map(exact).collect::<Option<Vec<_>>>()?.try_into().ok()
}

/// A whole number of steps.
///
/// # Errors
///
/// If there are fewer than none or far too many, as where a time in a file is wrong.
pub fn steps(count: f64) -> Result<u64, String> {
    let allowed = (0.0..=MOST_STEPS).contains(&count);
    if allowed {
        Ok(count as u64)
    } else {
        Err(format!("found times {count} steps apart, expected 0 to {MOST_STEPS:e}"))
    }
}
