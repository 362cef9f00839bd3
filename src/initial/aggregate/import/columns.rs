//! Formats that are rows of numbers.

use super::{Format, Raw, Source};
use crate::error::Error;
use crate::initial::aggregate::components;

/// Rows of four numbers, the radius first or last; lines that begin with `#` are comments.
pub(super) fn rows(source: &Source, radius_first: bool) -> Result<Raw, Error> {
    let mut raw = Raw::default();
    for (k, line) in source.lines().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [a, b, c, d] = words[..] else {
            return Err(source.at(k, &format!("found {} columns, expected 4: a centre and a radius", words.len())));
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
        raw.and_then(|raw| Ok(components(&raw.spheres(source, 1.0, None)?) == 1))
    };
    match (read(Format::Mstm), read(Format::FracVal)) {
        (Ok(true), Ok(false) | Err(_)) | (Ok(false), Err(_)) => Ok(Format::Mstm),
        (Ok(false) | Err(_), Ok(true)) | (Err(_), Ok(false)) => Ok(Format::FracVal),
        (Err(trouble), Err(_)) => Err(trouble),
        _ => Err(source.problem(
            None,
            "format",
            "is missing, expected `mstm` (r x y z) or `fracval` (x y z r): the rows do not identify it",
        )),
    }
}

/// A number, a comment, rows `species x y z` and perhaps a radius. A comment that lists `Properties` tells the columns. Without it
/// a fifth column is the radius if it is the last: several may be a velocity or a force.
pub(super) fn xyz(source: &Source) -> Result<Raw, Error> {
    let mut lines = source.lines();
    let (_, first) = lines.next().unwrap_or_default();
    let number: usize =
        first.parse().map_err(|_| source.at(1, &format!("found `{first}`, expected the number of spheres")))?;
    let (_, comment) = lines.next().unwrap_or_default();
    let named =
        comment.split_once("Properties=").map(|(_, rest)| layout(rest.split_whitespace().next().unwrap_or_default()));
    let (pos, radius) = match named {
        Some((Some(pos), radius)) => (pos, radius),
        Some((None, _)) => return Err(source.at(2, "found `Properties` without `pos:R:3`")),
        None => (1, None),
    };
    let mut raw = Raw::default();
    for _ in 0..number {
        let Some((k, line)) = lines.next().filter(|(_, line)| !line.is_empty()) else {
            let what = format!("found {} spheres, expected {number}, the number in the first line", raw.centres.len());
            return Err(source.at(raw.centres.len() + 3, &what));
        };
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(&[x, y, z]) = words.get(pos..pos + 3) else {
            return Err(source.at(k, &format!("found {} columns, expected at least {}", words.len(), pos + 3)));
        };
        let radius = radius.or((named.is_none() && words.len() == 5).then_some(4));
        raw.push(source, k, [x, y, z], radius.and_then(|column| words.get(column).copied()))?;
    }
    match lines.find(|(_, line)| !line.is_empty()) {
        Some((k, _)) => Err(source.at(k, &format!("found more rows than the {number} spheres of the first line"))),
        None => Ok(raw),
    }
}

/// Where position and radius are in rows that are described as `species:S:1:pos:R:3:radius:R:1`.
fn layout(properties: &str) -> (Option<usize>, Option<usize>) {
    let (mut column, mut pos, mut radius) = (0, None, None);
    let fields: Vec<&str> = properties.split(':').collect();
    for field in fields.chunks_exact(3) {
        match field[0].to_ascii_lowercase().as_str() {
            "pos" => pos = Some(column),
            "radius" => radius = Some(column),
            _ => {}
        }
        column += field[2].parse::<usize>().unwrap_or(1);
    }
    (pos, radius)
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
        if !self.centres.is_empty() && radius.is_some() == self.radii.is_empty() {
            return Err(source.at(line, "expected a radius in every row or in none"));
        }
        self.radii.extend(radius.map(|word| source.radius(line, word)).transpose()?);
        let [x, y, z] = x.map(|word| source.number(line, word));
        self.centres.push([x?, y?, z?]);
        self.lines.push(line);
        Ok(())
    }
}
