//! Sweeps: many runs in parallel, each in its own folder.

mod axis;
#[cfg(feature = "cli")]
mod report;
mod summary;
mod whole;

pub use axis::Axis;
pub use whole::Sweep;

use super::paths::absolute;
use super::{Message, Reader};
use crate::case::document;
use crate::error::Error;
use crate::interrupt::Interrupt;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use serde_yaml::{Mapping, Value};
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Longest part of the name of a folder that shows its values, in bytes.
const LONGEST: usize = 160;

/// A run of a sweep.
#[derive(Clone, Debug)]
pub struct Point {
    /// The name of its folder.
    pub name: String,
    /// The values of the varied keys.
    pub values: Vec<String>,
    /// The file that its messages name: it stands nowhere but in them.
    pub file: PathBuf,
    /// Its case.
    pub text: String,
    /// The files that it writes beside its folder.
    pub saves: Vec<PathBuf>,
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
            set(&mut case, key, value, read)?;
        }
        let text = serde_yaml::to_string(&case).expect("a case is plain data");
        let whole: Vec<String> = values.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let place = format!("{} with {}", file.file_name().unwrap_or_default().display(), whole.join(" "));
        // Beside the file, from which the paths in it are relative.
        let place = file.with_file_name(place.replace(std::path::is_separator, "_"));
        let job = read(&place, &text).map_err(without_lines)?;
        let saves = job.saves.iter().map(|(_, file)| absolute(&file.place)).collect();
        let name = name(values);
        let values = values.iter().map(|(_, value)| value.to_string()).collect();
        Ok(Self { name, values, file: place, text, saves, resolved: job.resolved })
    }
}

/// The name of the folder of a run: one path component, short enough for any file system, without characters that a shell or another
/// system takes for something else. A name that does not show its values in full ends with a part of their hash.
fn name(values: &[(&str, &str)]) -> String {
    let plain = |c: char| c.is_alphanumeric() || ".+-_".contains(c);
    let word = |text: &str| text.chars().map(|c| if plain(c) { c } else { '_' }).collect::<String>();
    let short = |key: &str| word(key.rsplit('.').next().unwrap_or_default());
    let part = |&(key, value): &(&str, &str)| format!("{}={}", short(key), word(&value.replace(' ', "")));
    let mut name = values.iter().map(part).collect::<Vec<_>>().join(",");
    if name.len() > LONGEST || values.iter().any(|(_, value)| !value.chars().all(|c| plain(c) || c == ' ')) {
        let whole: String = values.iter().map(|(key, value)| format!("{key}={value}\n")).collect();
        while name.len() > LONGEST {
            name.pop();
        }
        name.push('-');
        name.extend(Sha256::digest(whole).iter().take(4).map(|byte| format!("{byte:02x}")));
    }
    name
}

/// Checks that no two runs are the same, share a folder, or save to the same file.
///
/// # Errors
///
/// The first two runs that coincide.
fn distinct(points: &[Point]) -> Result<(), Error> {
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
    let mut saved = HashMap::new();
    for (point, file) in points.iter().flat_map(|point| point.saves.iter().map(move |file| (point, file))) {
        if let Some(other) = saved.insert(file, point) {
            let (one, other) = (other.values.join(", "), point.values.join(", "));
            return Err(Error::Usage(format!("`{one}` and `{other}` save to the same file, {}", file.display())));
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

/// Sets the value of a key such as `sample.hcp.size[1]`, creating its sections as needed; a list that is not there is first filled with
/// its default.
///
/// # Errors
///
/// If the key is unknown, or cannot hold a value.
pub fn set(case: &mut Value, key: &str, given: &str, read: Reader) -> Result<(), Error> {
    let wrong = |what: &str| Error::Usage(format!("`{key}={given}`: {what}"));
    let text = document(Path::new(""), given).map_err(|error| wrong(&error.to_string()))?;
    let value = serde_yaml::from_str(text).map_err(|error| wrong(&error.to_string()))?;
    let path = path(key).ok_or_else(|| wrong("expected a key such as `sample.hcp.size[1]`"))?;
    if lacks_list(case, &path) {
        // With nothing in its place an unknown key is refused by the reader, and another has its default.
        let list = path.iter().position(|part| matches!(part, Part::Item(_))).unwrap_or(path.len());
        let resolved = |case: &Value| -> Result<Value, Error> {
            let text = serde_yaml::to_string(case).expect("a case is plain data");
            let job = read(Path::new(&format!("{key}={given}")), &text).map_err(without_lines)?;
            Ok(serde_yaml::from_str(&job.resolved).expect("a resolved case is plain data"))
        };
        if let Some(default) = find(&resolved(case)?, &path[..list]) {
            *enter(case, &path[..list]).map_err(|what| wrong(&what))? = default.clone();
        } else {
            enter(case, &path[..list]).map_err(|what| wrong(&what))?;
            resolved(case)?;
        }
    }
    *enter(case, &path).map_err(|what| wrong(&what))? = value;
    Ok(())
}

/// A part of the path of a key.
enum Part<'a> {
    Key(&'a str),
    Item(usize),
}

/// The parts of a key such as `sample.hcp.size[1]`.
fn path(key: &str) -> Option<Vec<Part<'_>>> {
    let mut parts = Vec::new();
    for section in key.split('.') {
        let mut words = section.split('[');
        parts.push(words.next().filter(|word| !word.is_empty()).map(Part::Key)?);
        for item in words {
            parts.push(Part::Item(item.strip_suffix(']')?.trim().parse().ok()?));
        }
    }
    Some(parts)
}

/// The value at a path.
fn find<'a>(case: &'a Value, path: &[Part]) -> Option<&'a Value> {
    path.iter().try_fold(case, |place, part| match *part {
        Part::Key(word) => place.get(word),
        Part::Item(number) => place.get(number),
    })
}

/// Whether the path leads into a list that is not written in the case.
fn lacks_list(case: &Value, path: &[Part]) -> bool {
    let list = path.iter().position(|part| matches!(part, Part::Item(_)));
    list.is_some_and(|list| find(case, &path[..list]).is_none_or(Value::is_null))
}

/// The place at the end of a path, with the sections that lead to it.
fn enter<'a>(case: &'a mut Value, path: &[Part]) -> Result<&'a mut Value, String> {
    let mut place = case;
    let mut name = String::from("the case");
    for part in path {
        place = match *part {
            Part::Item(number) => {
                let length = place.as_sequence().map(Vec::len).ok_or_else(|| format!("`{name}` is not a list"))?;
                let what = || format!("`{name}` has {length} values, counted from 0: there is no `[{number}]`");
                place.get_mut(number).ok_or_else(what)?
            }
            Part::Key(word) => {
                // A section without content is written as nothing.
                if place.is_null() {
                    *place = Value::Mapping(Mapping::new());
                }
                let section = place.as_mapping_mut().ok_or_else(|| format!("`{name}` is not a section"))?;
                name = word.into();
                section.entry(word.into()).or_insert(Value::Null)
            }
        };
    }
    Ok(place)
}

/// Starts or resumes all runs that have not finished, the longest first, each on its share of the threads: one, where there are as many runs
/// as threads. Those of `anew` replace what is in their folder. `note` receives remarks about their folders, `ended` whether there was anything
/// left to do. After an interruption no further run is started.
pub fn carry_out(
    points: &[Point],
    out: &Path,
    interrupt: &Interrupt,
    read: Reader,
    anew: &(dyn Fn(&Point) -> bool + Sync),
    note: &(dyn Fn(&Point, String) + Sync),
    ended: &(dyn Fn(&Point, Result<bool, Error>) + Sync),
) {
    let next = AtomicUsize::new(0);
    let shares = shares(rayon::current_num_threads(), points.len());
    let order = longest_first(points, shares.len(), read, interrupt);
    let work = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        while !interrupt.is_due()
            && let Some(point) = order.get(next.fetch_add(1, Ordering::Relaxed))
        {
            let run = || {
                let (root, job) = (out.join(&point.name), read(&point.file, &point.text)?);
                let mut tell = |message: Message| {
                    if let Message::Note(text) = message {
                        note(point, text);
                    }
                };
                if anew(point) {
                    return job.launch(&root, true, interrupt, &mut tell).map(|_| true);
                }
                job.complete(&root, interrupt, read, &mut tell)
            };
            ended(point, pool.install(run));
        }
    };
    std::thread::scope(|scope| {
        for threads in shares {
            scope.spawn(move || work(threads));
        }
    });
}

/// The threads of each of the runs that are under way at a time.
fn shares(threads: usize, runs: usize) -> Vec<usize> {
    let together = threads.min(runs);
    (0..together).map(|k| (threads + k) / together).rev().collect()
}

/// The runs, the longest first, so that no core waits long for the last one; in the given order if they are equally long or all under way at once.
fn longest_first<'a>(points: &'a [Point], together: usize, read: Reader, interrupt: &Interrupt) -> Vec<&'a Point> {
    let mut order: Vec<&Point> = points.iter().collect();
    if together < points.len() {
        let work = |point: &&Point| read(&point.file, &point.text).map_or(0.0, |job| job.study.work(&job, interrupt));
        let work: Vec<f64> = order.par_iter().map(work).collect();
        let mut places: Vec<usize> = (0..points.len()).collect();
        places.sort_by(|&a, &b| work[b].total_cmp(&work[a]));
        order = places.into_iter().map(|place| &points[place]).collect();
    }
    order
}

#[cfg(test)]
mod tests {
    use super::shares;

    #[test]
    fn every_thread_has_a_run_and_every_run_a_thread() {
        assert_eq!(shares(2, 400), [1, 1]);
        assert_eq!(shares(8, 3), [3, 3, 2]);
        assert_eq!(shares(2, 1), [2]);
        assert_eq!(shares(4, 0), [0; 0]);
    }
}
