//! Sweeps: many runs in parallel, each in its own folder.

use super::Reader;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::write_atomically;
use rayon::ThreadPoolBuilder;
use serde_yaml::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A run of a sweep.
#[derive(Clone, Debug)]
pub struct Point {
    /// The name of its folder.
    pub name: String,
    /// The values of the varied keys.
    pub values: Vec<String>,
    /// Its case.
    pub text: String,
    /// Its case with every default and derived value.
    pub resolved: String,
}

impl Point {
    /// The case of a file with other values for some keys, checked.
    ///
    /// # Errors
    ///
    /// If a key or value is wrong.
    pub fn new(file: &Path, base: &Value, values: &[(&str, &str)], read: Reader) -> Result<Self, Error> {
        let mut case = base.clone();
        for (key, value) in values {
            set(&mut case, key, value)?;
        }
        let short = |key: &str| key.rsplit('.').next().unwrap_or_default().to_string();
        let parts = values.iter().map(|(key, value)| format!("{}={}", short(key), value.replace([' ', '/'], "")));
        let parts: Vec<String> = parts.collect();
        let text = serde_yaml::to_string(&case).expect("a case is plain data");
        let whole: Vec<String> = values.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let place = format!("{} with {}", file.file_name().unwrap_or_default().display(), whole.join(" "));
        let resolved = read(&file.with_file_name(place), &text).map_err(without_lines)?.resolved;
        let values = values.iter().map(|(_, value)| value.to_string()).collect();
        Ok(Self { name: parts.join(","), values, text, resolved })
    }

    /// Writes its case beside its folder.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn write(&self, out: &Path) -> Result<PathBuf, Error> {
        let case = out.join(format!("{}.yaml", self.name));
        write_atomically(&case, self.text.as_bytes())?;
        Ok(case)
    }
}

/// Checks that no two runs are the same or share a folder.
///
/// # Errors
///
/// The first two runs that coincide.
pub fn distinct(points: &[Point]) -> Result<(), Error> {
    let same = ["are the same case", "have the same run folder"];
    for (k, what) in same.into_iter().enumerate() {
        let mut seen = HashMap::new();
        for point in points {
            if let Some(other) = seen.insert([&point.resolved, &point.name][k], point) {
                let told = |point: &Point| point.values.join(", ");
                return Err(Error::Usage(format!("`{}` and `{}` {what}", told(other), told(point))));
            }
        }
    }
    Ok(())
}

/// Removes line numbers, which refer to a text that the user has not seen.
fn without_lines(error: Error) -> Error {
    let Error::Input(mut problems) = error else { return error };
    problems.iter_mut().for_each(|problem| problem.line = None);
    Error::Input(problems)
}

/// Sets the value of a key such as `sample.hcp.size[1]`, creating its sections as needed.
///
/// # Errors
///
/// If the key is unknown, or cannot hold a value.
pub fn set(case: &mut Value, key: &str, value: &str) -> Result<(), Error> {
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

/// Starts or resumes all runs that have not finished, one on each core; `ended` receives whether there was anything left to do. After
/// an interruption no further run is started.
pub fn carry_out(
    points: &[Point],
    out: &Path,
    interrupt: &Interrupt,
    read: Reader,
    ended: &(dyn Fn(&Point, Result<bool, Error>) + Sync),
) {
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(points.len()) {
            scope.spawn(|| {
                let core = ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
                while !interrupt.is_due()
                    && let Some(point) = points.get(next.fetch_add(1, Ordering::Relaxed))
                {
                    let run = || read(&point.write(out)?, &point.text)?.complete(&out.join(&point.name), interrupt);
                    ended(point, core.install(run));
                }
            });
        }
    });
}
