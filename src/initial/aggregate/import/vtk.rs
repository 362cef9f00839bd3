//! The legacy VTK of soot-dem: points in units of the monomer radius, and its files of necks.

use super::{ASKED, Raw, Source};
use crate::error::Error;
use crate::geometry::Sphere;
use crate::initial::aggregate::necks::Neck;

/// The points of a `DATASET POLYDATA` in ASCII; what follows them is not read.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
    if let Some((line, _)) = source.words().find(|&(line, word)| line <= 4 && word == "BINARY") {
        return Err(source.at(line, "found `BINARY`, expected `ASCII`"));
    }
    let mut words = section(source, "POINTS")?;
    let number = count(source, &mut words, "the number of points")?;
    next(source, &mut words, "the type of the coordinates")?;
    let mut raw = Raw { in_radii: true, ..Raw::default() };
    for k in 0..number {
        let mut coordinate =
            || next(source, &mut words, &format!("coordinates of {number} points, {k} of which are present"));
        let (x, y, z) = (coordinate()?, coordinate()?, coordinate()?);
        raw.push(source, x.0, [x.1, y.1, z.1], None)?;
    }
    Ok(raw)
}

/// The necks of an aggregate of `n` spheres: a field `connections`, which lists the places `i * n + j` of a matrix,
/// each neck from both ends. `allowed` says why two spheres cannot be joined.
pub(super) fn necks(
    source: &Source,
    spheres: &[Sphere],
    allowed: impl Fn(usize, usize) -> Result<(), String>,
) -> Result<Vec<Neck>, Error> {
    let mut words = section(source, "connections")?;
    let columns = count(source, &mut words, "the number of columns")?;
    let rows = count(source, &mut words, "the number of rows")?;
    let (line, _) = next(source, &mut words, "the type of the connections")?;
    let Some(size) = columns.checked_mul(rows) else {
        return Err(source.at(line, &format!("found {columns} times {rows} connections, expected fewer")));
    };
    let number = spheres.len();
    let mut ends = Vec::new();
    for row in 0..size {
        if row.is_multiple_of(ASKED) {
            source.interrupt.check()?;
        }
        let (line, word) = next(source, &mut words, &format!("{size} connections"))?;
        let place =
            word.parse::<usize>().ok().filter(|&place| place < number * number && place / number != place % number);
        let Some(place) = place else {
            let what = format!("found `{word}`, expected i * {number} + j with i and j below {number} and unequal");
            return Err(source.at(line, &what));
        };
        ends.push((place / number, place % number, line));
    }
    ends.sort_unstable();
    // Necks of another aggregate mostly lie between spheres that are far apart, or are seen from one end.
    for &(i, j, line) in &ends {
        let seen_from_both = || match ends.binary_search_by_key(&(j, i), |&(i, j, _)| (i, j)) {
            Ok(_) => Ok(()),
            Err(_) => Err(format!("but not {}, expected each neck from both ends", j * number + i)),
        };
        let place = i * number + j;
        allowed(i, j)
            .and_then(|()| seen_from_both())
            .map_err(|what| source.at(line, &format!("found {place}, a neck of the spheres {i} and {j}, {what}")))?;
    }
    ends.retain(|&(i, j, _)| i < j);
    ends.dedup_by_key(|&mut (i, j, _)| (i, j));
    Ok(ends.into_iter().map(|(i, j, _)| (i, j)).collect())
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
