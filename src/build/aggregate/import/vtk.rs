//! The legacy VTK of soot-dem: points in units of the monomer radius, and its files of necks.

use super::{Raw, Source, text_of};
use crate::build::aggregate::necks::Neck;
use crate::error::Error;
use std::path::Path;

/// The points of a `DATASET POLYDATA` in ASCII; what follows them is not read.
pub fn read(source: &Source) -> Result<Raw, Error> {
    if let Some((line, _)) = source.words().find(|&(line, word)| line <= 4 && word == "BINARY") {
        return Err(source.at(line, "found `BINARY`, expected `ASCII`"));
    }
    let mut words = section(source, "POINTS")?;
    let number = count(source, &mut words, "the number of points")?;
    next(source, &mut words, "the type of the coordinates")?;
    let mut raw = Raw { in_radii: true, ..Raw::default() };
    for k in 0..number {
        let mut coordinate =
            || next(source, &mut words, &format!("coordinates of {number} points, of which {k} are there"));
        let (x, y, z) = (coordinate()?, coordinate()?, coordinate()?);
        raw.push(source, x.0, [x.1, y.1, z.1], None)?;
    }
    Ok(raw)
}

/// The necks of an aggregate of `number` spheres: a field `connections`, which lists the places `i * number + j` of a matrix,
/// each neck from both ends.
pub fn read_necks(file: &Path, number: usize) -> Result<Vec<Neck>, Error> {
    let text = text_of(file)?;
    let source = Source { file, text: &text };
    let mut words = section(&source, "connections")?;
    let columns = count(&source, &mut words, "the number of columns")?;
    let rows = count(&source, &mut words, "the number of rows")?;
    next(&source, &mut words, "the type of the connections")?;
    let mut necks = Vec::new();
    for _ in 0..columns * rows {
        let (line, word) = next(&source, &mut words, &format!("{} connections", columns * rows))?;
        let place =
            word.parse::<usize>().ok().filter(|&place| place < number * number && place / number != place % number);
        let Some(place) = place else {
            let what = format!("found `{word}`, expected i * {number} + j with i and j below {number} and unequal");
            return Err(source.at(line, &what));
        };
        let (i, j) = (place / number, place % number);
        necks.push((i.min(j), i.max(j)));
    }
    necks.sort_unstable();
    necks.dedup();
    Ok(necks)
}

type Words<'a> = Box<dyn Iterator<Item = (usize, &'a str)> + 'a>;

/// The words after a keyword.
fn section<'a>(source: &Source<'a>, keyword: &'a str) -> Result<Words<'a>, Error> {
    let mut words = source.words().skip_while(move |&(_, word)| word != keyword);
    match words.next() {
        Some(_) => Ok(Box::new(words)),
        None => Err(Error::input(source.file, format!("found no `{keyword}`"))),
    }
}

fn next<'a>(source: &Source, words: &mut Words<'a>, expected: &str) -> Result<(usize, &'a str), Error> {
    words
        .next()
        .ok_or_else(|| source.at(source.text.lines().count(), &format!("the file ends here, expected {expected}")))
}

fn count(source: &Source, words: &mut Words, expected: &str) -> Result<usize, Error> {
    let (line, word) = next(source, words, expected)?;
    word.parse().map_err(|_| source.at(line, &format!("found `{word}`, expected {expected}")))
}
