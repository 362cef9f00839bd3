//! Reads a case file and locates its errors.

use super::Case;
use super::check::{self, Found};
use super::quantity::in_range;
use super::section::Part;
use super::units::{number_and_unit, shifted};
use crate::error::{Error, Problem, read_file};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, Visitor};
use std::fmt;
use std::path::{Path, PathBuf};

/// The text of a case file.
///
/// # Errors
///
/// If the file cannot be read, or is not UTF-8.
pub fn read_text(file: &Path) -> Result<String, Error> {
    String::from_utf8(read_file(file)?).map_err(|_| Error::input(file, "is not a text in UTF-8"))
}

/// Parses a case file whose sections are known, completes it and checks it; `problems` finds errors beyond its grammar.
///
/// # Errors
///
/// Everything that is wrong with the case, by line and key.
pub fn parse<M: Part, S: Part, E: Part>(
    file: &Path,
    text: &str,
    complete: impl Fn(&mut Case<M, S, E>),
    problems: impl Fn(&Case<M, S, E>, &mut Found),
) -> Result<Case<M, S, E>, Error> {
    let mut case: Case<M, S, E> =
        serde_yaml::from_str(document(file, text)?).map_err(|error| Error::Input(vec![problem(file, &error)]))?;
    complete(&mut case);
    let mut found = Found::new();
    problems(&case, &mut found);
    check::general(&case.output, &case.limits, &mut found);
    if found.is_empty() { Ok(case) } else { Err(wrong(found, file, text)) }
}

/// The error of a case file with these problems.
pub(super) fn wrong(found: Found, file: &Path, text: &str) -> Error {
    let problem = |(key, what): (String, String)| Problem { file: PathBuf::new(), line: None, key, what };
    located(Error::Input(found.into_iter().map(problem).collect()), file, text)
}

/// The messages about keys, with the lines of their values.
pub fn problems(found: Found, file: &Path, text: &str) -> Vec<Problem> {
    match wrong(found, file, text) {
        Error::Input(problems) => problems,
        _ => unreachable!("wrong input is told by problems"),
    }
}

/// The text without the byte order mark that some editors put before it.
pub fn unmarked(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Deepest nesting of brackets: the time of the YAML reader grows with the product of length and depth.
const DEPTH: usize = 1000;

/// The text without its byte order mark, for the YAML reader.
///
/// # Errors
///
/// If its brackets are nested too deeply, or a number is so small that the reader would take it for zero.
pub fn document<'a>(file: &Path, text: &'a str) -> Result<&'a str, Error> {
    let text = unmarked(text);
    let (mut depth, mut quoted) = (0_usize, false);
    for (line, number) in text.lines().zip(1..) {
        if let Some((key, what)) = vanishing(line) {
            return Err(Error::Input(vec![Problem { file: file.into(), line: Some(number), key, what }]));
        }
        let mut remark = false;
        for character in line.chars() {
            match character {
                '[' | '{' => depth += 1,
                // What may belong to a text or a comment closes nothing: the depth is never underestimated.
                ']' | '}' if !quoted && !remark => depth = depth.saturating_sub(1),
                '"' | '\'' => quoted = true,
                '#' => remark = true,
                _ => {}
            }
            if depth > DEPTH {
                let what = format!("found brackets within {DEPTH} others, expected fewer");
                return Err(Error::Input(vec![Problem {
                    file: file.into(),
                    line: Some(number),
                    key: String::new(),
                    what,
                }]));
            }
        }
    }
    Ok(text)
}

/// The key and the error of a number without a unit, in a line of a case, that is not zero but below the range of `f64`.
fn vanishing(line: &str) -> Option<(String, String)> {
    let mut key = "";
    for part in line.split('#').next()?.split(|c| ",:[]{}".contains(c)).map(str::trim) {
        match number_and_unit(part) {
            Some((number, "")) if shifted(number, 0) == 0.0 => {
                if let Err(what) = in_range(0.0, number) {
                    return Some((key.into(), what));
                }
            }
            Some(_) => {}
            None => key = part,
        }
    }
    None
}

/// Most problems that are reported of a file: each is found again in its text.
const REPORTED: usize = 20;

/// Adds file and line to the problems of keys.
pub fn located(error: Error, file: &Path, text: &str) -> Error {
    let Error::Input(mut problems) = error else { return error };
    if let Some(more) = problems.len().checked_sub(REPORTED).filter(|&more| more > 0) {
        problems.truncate(REPORTED);
        let what = format!("has {more} more problems");
        problems.push(Problem { file: file.into(), line: None, key: String::new(), what });
    }
    for problem in problems.iter_mut().filter(|problem| problem.file.as_os_str().is_empty()) {
        (problem.file, problem.line) = (file.into(), line_of(text, &problem.key));
    }
    Error::Input(problems)
}

/// Converts an error of the YAML reader, whose text is `path: message at line 3 column 5`.
pub(super) fn problem(file: &Path, error: &serde_yaml::Error) -> Problem {
    let message = error.to_string();
    let location = error.location();
    let place =
        location.as_ref().map(|at| format!(" at line {} column {}", at.line(), at.column())).unwrap_or_default();
    let message = message.replacen(&place, "", 1);
    let is_path = |c: char| c.is_ascii_alphanumeric() || "_.[]".contains(c);
    let (key, what) = match message.split_once(": ") {
        Some((key, what)) if key.chars().all(is_path) && !what.is_empty() => (key, what),
        _ => ("", &*message),
    };
    let mut what = what.to_string();
    for (theirs, ours) in [
        ("invalid type: ", "found "),
        ("invalid value: ", "found "),
        ("invalid length ", "found a list of length "),
        ("found floating point ", "found "),
        ("found integer ", "found "),
        ("found sequence", "found a list"),
        ("found map", "found a section"),
        ("found unit value", "found nothing"),
        ("expected f64", "expected a number"),
        ("expected u64", "expected a whole number"),
        ("expected an array of length 2", "expected two values"),
        ("expected sequence of 2 elements", "expected two values"),
        ("expected an array of length 3", "expected three values"),
    ] {
        what = what.replace(theirs, ours);
    }
    Problem { file: file.into(), line: location.map(|at| at.line()), key: key.into(), what }
}

/// The line of the value of `key`, such as `sample.hcp.size[1]`: parses the text again and fails exactly there.
fn line_of(text: &str, key: &str) -> Option<usize> {
    let path: Vec<&str> = key.split(['.', '[']).map(|part| part.trim_end_matches(']')).collect();
    let stopped = Find(&path).deserialize(serde_yaml::Deserializer::from_str(unmarked(text))).err()?;
    stopped.location().map(|at| at.line())
}

/// Fails at the end of the path.
struct Find<'a>(&'a [&'a str]);

impl<'de> DeserializeSeed<'de> for Find<'_> {
    type Value = ();
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Find<'_> {
    type Value = ();
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the end of the path")
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let Some((first, rest)) = self.0.split_first() else {
            return Err(serde::de::Error::custom("found"));
        };
        while let Some(key) = map.next_key::<String>()? {
            if key == *first {
                map.next_value_seed(Find(rest))?;
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(())
    }
    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Some(place) = self.0.first().and_then(|first| first.parse::<usize>().ok()) else {
            return Err(serde::de::Error::custom("found"));
        };
        for _ in 0..place {
            list.next_element::<IgnoredAny>()?;
        }
        list.next_element_seed(Find(&self.0[1..]))?;
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(())
    }
}
