//! Formats that are rows of numbers.

use super::{ASKED, Format, Raw, Source};
use crate::error::{Error, notice};
use crate::initial::aggregate::components;

/// Rows of four numbers, the radius first or last of them; lines that begin with `#` are comments. MSTM appends the refractive index of a sphere, or two, as a complex number
/// that may be in brackets, and since version 4 it separates numbers by commas.
pub(super) fn rows(source: &Source, radius_first: bool) -> Result<Raw, Error> {
    let mut raw = Raw::default();
    for (k, line) in source.lines().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        let between = |c: char| c.is_whitespace() || ",()".contains(c);
        let words: Vec<&str> = line.split(between).filter(|word| !word.is_empty()).collect();
        let ([a, b, c, d], 4 | 6 | 8) = (words.first_chunk().copied().unwrap_or_default(), words.len()) else {
            let what = "4: a centre and a radius, or 6 or 8 with the refractive indices of MSTM";
            return Err(source.at(k, &format!("found {} columns, expected {what}", words.len())));
        };
        let (r, x) = if radius_first { (a, [b, c, d]) } else { (d, [a, b, c]) };
        raw.push(source, k, x, Some(r))?;
    }
    Ok(raw)
}

/// Whether the radius is the first of four columns or the last: the way in which the spheres hang together, if only one
/// does.
pub(super) fn detect(source: &Source) -> Result<Format, Error> {
    let read = |format| {
        let raw = rows(source, format == Format::Mstm);
        raw.and_then(|raw| Ok(components(&raw.spheres(source, 1.0, None)?, source.interrupt)? == 1))
    };
    match (read(Format::Mstm), read(Format::FracVal)) {
        (Ok(true), Ok(false) | Err(_)) | (Ok(false), Err(_)) => Ok(Format::Mstm),
        (Ok(false) | Err(_), Ok(true)) | (Err(_), Ok(false)) => Ok(Format::FracVal),
        // The columns that go well for longer are the ones that are meant.
        (Err(one), Err(other)) => Err(if line(&other) > line(&one) { other } else { one }),
        _ => Err(source.problem(
            None,
            "format",
            "is missing, expected `mstm` (r x y z), or `fracval` or `csv` (x y z r): the rows do not identify it",
        )),
    }
}

/// The line of an error.
fn line(error: &Error) -> Option<usize> {
    match error {
        Error::Input(problems) => problems.first().and_then(|problem| problem.line),
        _ => None,
    }
}

/// A number, a comment, rows `species x y z` and perhaps a radius. A comment that lists `Properties` names the columns. Without it
/// a fifth column is the radius if it is the last: several may be a velocity or a force. The first frame is read.
pub(super) fn xyz(source: &Source) -> Result<Raw, Error> {
    let mut lines = source.lines();
    let (_, first) = lines.next().unwrap_or_default();
    let number: usize =
        first.parse().map_err(|_| source.at(1, &format!("found `{first}`, expected the number of spheres")))?;
    let (_, comment) = lines.next().unwrap_or_default();
    let named = match property(comment, "Properties") {
        // Frames of veridem name their stage.
        Some(properties) => Some(layout(source, &properties, property(comment, "stage").is_some())?),
        None => None,
    };
    let mut raw = Raw::default();
    for _ in 0..number {
        let Some((k, line)) = lines.next().filter(|(_, line)| !line.is_empty()) else {
            let what = format!("found {} spheres, expected {number}, the number in the first line", raw.centres.len());
            // A blank line, or the end of the file.
            return Err(source.at((raw.centres.len() + 3).min(source.text.lines().count() + 1), &what));
        };
        let words: Vec<&str> = line.split_whitespace().collect();
        match named {
            Some(Layout { width, .. }) if words.len() != width => {
                let what = format!("found {} columns, expected {width}, as `Properties` lists", words.len());
                return Err(source.at(k, &what));
            }
            Some(Layout { pos, radius, diameter, body, v, w, .. }) => {
                raw.push(source, k, [words[pos], words[pos + 1], words[pos + 2]], radius.map(|column| words[column]))?;
                if diameter {
                    raw.radii.iter_mut().last().into_iter().for_each(|radius| *radius *= 0.5);
                }
                if let Some(column) = body {
                    raw.extras.push_body(source, k, words[column])?;
                }
                let three = |first: usize| [words[first], words[first + 1], words[first + 2]];
                raw.extras.push_motion(source, k, v.map(three), w.map(three))?;
            }
            None => {
                let Some(&[species, x, y, z]) = words.first_chunk() else {
                    return Err(source.at(k, &format!("found {} columns, expected at least 4", words.len())));
                };
                // An atomic number or the number of a type may stand for a species.
                if species.parse::<f64>().is_ok() && !species.parse::<u32>().is_ok_and(|number| number > 0) {
                    let what = format!(
                        "found `{species}`, expected a species in the first column: rows `x y z r` are of the format `fracval`, or `Properties` in line 2 names the columns"
                    );
                    return Err(source.at(k, &what));
                }
                raw.push(source, k, [x, y, z], (words.len() == 5).then(|| words[4]))?;
            }
        }
    }
    match lines.find(|(_, line)| !line.is_empty()) {
        Some((_, line)) if line.parse::<usize>().is_ok() => {
            notice(format!("{}: holds several frames, the first is read", source.file.display()));
            Ok(raw)
        }
        Some((k, _)) => Err(source.at(k, &format!("found more rows than the {number} spheres of the first line"))),
        None => Ok(raw),
    }
}

/// The value of a key in a comment `key=value other="a value" ...`.
fn property(comment: &str, key: &str) -> Option<String> {
    let mut rest = comment.trim_start();
    while !rest.is_empty() {
        let end = rest.find(|c: char| c == '=' || c.is_whitespace()).unwrap_or(rest.len());
        let (name, after) = rest.split_at(end);
        let Some(value) = after.trim_start().strip_prefix('=').map(str::trim_start) else {
            rest = after.trim_start();
            continue;
        };
        let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''));
        let (value, after) = match quote {
            Some(quote) => value[1..].split_once(quote).unwrap_or((&value[1..], "")),
            None => value.split_at(value.find(char::is_whitespace).unwrap_or(value.len())),
        };
        if name.eq_ignore_ascii_case(key) {
            return Some(value.into());
        }
        rest = after.trim_start();
    }
    None
}

/// The columns of extended XYZ.
#[derive(Clone, Copy)]
struct Layout {
    width: usize,
    pos: usize,
    /// Radius or diameter.
    radius: Option<usize>,
    diameter: bool,
    /// Number of a rigid body.
    body: Option<usize>,
    /// Velocity.
    v: Option<usize>,
    /// Angular velocity.
    w: Option<usize>,
}

/// The columns of veridem's own frames that are no part of a sample.
pub const OF_FRAMES: [&str; 10] = [
    "wall",
    "mass",
    "force",
    "coordination",
    "necks",
    "third_body",
    "stress",
    "torque",
    "acceleration",
    "angular_acceleration",
];

/// The columns that are described as `species:S:1:pos:R:3:radius:R:1`, in a frame of our own or in another file.
fn layout(source: &Source, properties: &str, own: bool) -> Result<Layout, Error> {
    let wrong = |what: &str| source.at(2, &format!("found `Properties={properties}`, expected {what}"));
    let (mut width, mut pos, mut radius, mut diameter, mut unread) = (0, None, None, None, Vec::new());
    let (mut body, mut v, mut w) = (None, None, None);
    let fields: Vec<&str> = properties.split(':').collect();
    if !fields.len().is_multiple_of(3) {
        return Err(wrong("name, type and number of columns for each property"));
    }
    for field in fields.chunks_exact(3) {
        let columns = field[2].parse().ok().filter(|columns| (1..=1000).contains(columns));
        let columns: usize = columns.ok_or_else(|| wrong(&format!("a number of columns for `{}`", field[0])))?;
        match (field[0].to_ascii_lowercase().as_str(), columns) {
            ("pos" | "position" | "positions", 3) => pos = Some(width),
            ("radius" | "radii", 1) => radius = Some(width),
            ("diameter", 1) => diameter = Some(width),
            ("body" | "molecule", 1) => body = Some(width),
            ("velo" | "velocity" | "velocities", 3) => v = Some(width),
            ("angular_velocity", 3) => w = Some(width),
            ("species" | "id" | "type", _) => {}
            (name, _) if own && OF_FRAMES.contains(&name) => {}
            _ => unread.push(field[0]),
        }
        width += columns;
    }
    let pos = pos.ok_or_else(|| wrong("`pos:R:3` among the properties"))?;
    if !unread.is_empty() {
        notice(format!("{}: the columns {} are not read", source.file.display(), unread.join(", ")));
    }
    let diameter_only = radius.is_none() && diameter.is_some();
    Ok(Layout { width, pos, radius: radius.or(diameter), diameter: diameter_only, body, v, w })
}

impl Raw {
    /// Appends a sphere; either all have a radius or none.
    pub(super) fn push(
        &mut self,
        source: &Source,
        line: usize,
        x: [&str; 3],
        radius: Option<&str>,
    ) -> Result<(), Error> {
        if self.centres.len().is_multiple_of(ASKED) {
            source.interrupt.check()?;
        }
        if !self.centres.is_empty() && radius.is_some() == self.radii.is_empty() {
            return Err(source.at(line, "expected a radius in every row or in none"));
        }
        self.radii.extend(radius.map(|word| source.radius(line, word)).transpose()?);
        let decimals = |word: &str| match word.split_once('.') {
            _ if word.contains(['e', 'E', 'd', 'D']) => usize::MAX,
            Some((_, decimals)) => decimals.len(),
            None => 0,
        };
        self.decimals = x.iter().map(|word| decimals(word)).fold(self.decimals, usize::max);
        let [x, y, z] = x.map(|word| source.number(line, word));
        self.centres.push([x?, y?, z?]);
        self.lines.push(line);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
