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

#[cfg(test)]
mod tests {
    use super::super::{Options, parse, parse_necks};
    use crate::geometry::Sphere;
    use crate::initial::aggregate::necks::Neck;
    use crate::interrupt::Interrupt;
    use crate::spec::Vec3;
    use std::path::Path;

    const TITLE: &str = "# vtk DataFile Version 4.0\n";

    fn points(rest: &str) -> Result<Vec<[f64; 3]>, String> {
        let options = Options { radius: Some(1.0), disconnected: true, ..Options::default() };
        let found = parse(Path::new("a.vtk"), format!("{TITLE}{rest}"), &options, &Interrupt::default());
        Ok(found.map_err(|error| error.to_string())?.spheres.iter().map(|sphere| sphere.centre.0).collect())
    }

    /// The necks of three spheres in a row.
    fn necks(rest: &str) -> Result<Vec<Neck>, String> {
        let spheres = [0.0, 2.0, 4.0].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 1.0 });
        let found = parse_necks(Path::new("n.vtk"), rest.as_bytes(), &spheres, &Interrupt::default());
        found.map_err(|error| error.to_string())
    }

    #[test]
    fn points_are_words_on_any_lines_and_only_a_header_is_binary() {
        let expected = Ok(vec![[0.0, 0.0, 0.0], [2.0, 0.0, -1.0]]);
        assert_eq!(
            points("t\nASCII\nDATASET POLYDATA\nBINARY\nPOINTS 2 float\n0 0 0 2\n0 -1\nVERTICES 1 2\n"),
            expected
        );
        assert_eq!(points("t\nASCII\nPOINTS\n2\nfloat 0 0 0\n2 0 -1"), expected);
        for (rest, expected) in [
            ("t\n\nBINARY\nPOINTS 1 float\n0 0 0\n", "4: found `BINARY`, expected `ASCII`"),
            ("t\nASCII\nDATASET POLYDATA\n", " found no `POINTS`"),
            ("t\nASCII\nPOINTS\n", "4: the file ends here, expected the number of points"),
            ("t\nASCII\nPOINTS x float\n", "4: found `x`, expected the number of points"),
            ("t\nASCII\nPOINTS 2\n", "4: the file ends here, expected the type of the coordinates"),
            (
                "t\nASCII\nPOINTS 2 float\n0 0 0\n1 1\n",
                "6: the file ends here, expected coordinates of 2 points, 1 of which are present",
            ),
            ("t\nASCII\nPOINTS 1 float\n0 0\nno\n", "5: found `no`, expected a number"),
        ] {
            assert_eq!(points(rest), Err(format!("a.vtk:{expected}")), "{rest}");
        }
    }

    #[test]
    fn a_neck_is_a_place_in_a_matrix_and_its_mirror_image() {
        for (rest, expected) in [
            ("connections 2 2 int\n1 3\n5 7\n", vec![(0, 1), (1, 2)]),
            ("connections 1 4 int 7 5 3 1", vec![(0, 1), (1, 2)]),
            ("connections 6 1 int 1 3 3 1 1 3", vec![(0, 1)]),
            ("connections 0 0 int", vec![]),
            ("connections 2 1 int 1 3 5 7", vec![(0, 1)]),
        ] {
            assert_eq!(necks(rest), Ok(expected), "{rest}");
        }
    }

    #[test]
    fn what_is_no_neck_is_reported_with_its_line() {
        let place = |word: &str| format!("found `{word}`, expected i * 3 + j with i and j below 3 and unequal");
        for (rest, expected) in [
            ("# vtk\n", " found no `connections`".to_string()),
            ("connections", "1: the file ends here, expected the number of columns".into()),
            ("connections\nx 1 int", "2: found `x`, expected the number of columns".into()),
            ("connections 2\n\n", "2: the file ends here, expected the number of rows".into()),
            ("connections 2 -1 int", "1: found `-1`, expected the number of rows".into()),
            ("connections 2 1\n", "1: the file ends here, expected the type of the connections".into()),
            ("connections 2 2 int\n1 3\n5\n", "3: the file ends here, expected 4 connections".into()),
            ("connections 2 1 int\n1\n9\n", format!("3: {}", place("9"))),
            ("connections 2 1 int\n8 7\n", format!("2: {}", place("8"))),
            ("connections 2 1 int\n4 7\n", format!("2: {}", place("4"))),
            ("connections 2 1 int\n0 7\n", format!("2: {}", place("0"))),
            ("connections 2 1 int\n-1 7\n", format!("2: {}", place("-1"))),
            (
                "connections 4 1 int\n1 3\n7\n3\n",
                "3: found 7, a neck of the spheres 2 and 1, but not 5, expected each neck from both ends".into(),
            ),
            (
                "connections 4 1 int\n7\n6 5\n2\n",
                "4: found 2, a neck of the spheres 0 and 2, whose gap is 2.000 nm, expected at most 0.1 of their mean diameter".into(),
            ),
        ] {
            assert_eq!(necks(rest), Err(format!("n.vtk:{expected}")), "{rest}");
        }
    }
}
