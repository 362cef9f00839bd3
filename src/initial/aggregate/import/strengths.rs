//! The strengths of the necks of an aggregate, from a file.

use super::{ASKED, Source, csv, text_of};
use crate::error::{Error, read_file};
use crate::initial::aggregate::necks::Neck;
use crate::interrupt::Interrupt;
use std::collections::BTreeMap;
use std::path::Path;

/// The strengths of necks: rows `i,j,strength` of two spheres, counted from 0, perhaps below a header.
///
/// # Errors
///
/// If the file cannot be read, the first line that is no such row or repeats a neck, or an interruption.
pub fn read_strengths(file: &Path, spheres: usize, interrupt: &Interrupt) -> Result<BTreeMap<Neck, f64>, Error> {
    parse_strengths(file, &read_file(file)?, spheres, interrupt)
}

fn parse_strengths(
    file: &Path,
    bytes: &[u8],
    spheres: usize,
    interrupt: &Interrupt,
) -> Result<BTreeMap<Neck, f64>, Error> {
    let text = text_of(file, bytes)?;
    let source = Source { file, text: &text, interrupt };
    let mut found = BTreeMap::new();
    for (number, row) in csv::rows(&source).enumerate() {
        if number.is_multiple_of(ASKED) {
            interrupt.check()?;
        }
        let (line, row) = row?;
        if number == 0 && row.get(0).is_some_and(|word| word.starts_with(|c: char| c.is_ascii_alphabetic())) {
            continue;
        }
        let sphere = |word: &str| word.parse::<usize>().ok().filter(|&sphere| sphere < spheres);
        let words: Vec<&str> = row.iter().collect();
        let &[i, j, strength] = &words[..] else {
            let what = format!("found {} columns, expected three, `i,j,strength`", words.len());
            return Err(source.at(line, &what));
        };
        let (Some(a), Some(b)) = (sphere(i), sphere(j)) else {
            let most = spheres.saturating_sub(1);
            let what = format!("found `{i},{j}`, expected two spheres from 0 to {most}");
            return Err(source.at(line, &what));
        };
        let factor = source.number(line, strength)?;
        if factor <= 0.0 {
            return Err(source.at(line, &format!("found the strength `{strength}`, expected more than zero")));
        }
        if a == b || found.insert((a.min(b), a.max(b)), factor).is_some() {
            let what = if a == b { "found a neck of a sphere and itself" } else { "found a neck for the second time" };
            return Err(source.at(line, &format!("{what}, `{i},{j}`")));
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<BTreeMap<Neck, f64>, String> {
        let found = parse_strengths(Path::new("s.csv"), text.as_bytes(), 4, &Interrupt::default());
        found.map_err(|error| error.to_string())
    }

    #[test]
    fn a_row_holds_two_spheres_in_any_order_and_the_strength_of_their_neck() {
        let expected = BTreeMap::from([((0, 1), 1.5), ((1, 3), 0.25)]);
        assert_eq!(parse("# strengths\ni,j,strength\n1,0,1.5\n1, 3, 0.25\n").unwrap(), expected);
        assert_eq!(parse("0,1,1.5\n3,1,2.5e-1").unwrap(), expected);
    }

    #[test]
    fn what_is_no_strength_of_a_neck_is_reported_with_its_line() {
        for (text, what) in [
            ("0,1,1\n1,2\n", "s.csv:2: found 2 columns, expected three, `i,j,strength`"),
            ("0,1,1\n1,4,1\n", "s.csv:2: found `1,4`, expected two spheres from 0 to 3"),
            ("0,1,-2\n", "s.csv:1: found the strength `-2`, expected more than zero"),
            ("0,1,NaN\n", "s.csv:1: found `NaN`, expected a number"),
            ("0,1,0\n", "s.csv:1: found the strength `0`, expected more than zero"),
            ("0,1,1\na,b,c\n", "s.csv:2: found `a,b`, expected two spheres from 0 to 3"),
            ("0,j,1\n", "s.csv:1: found `0,j`, expected two spheres from 0 to 3"),
            ("2,2,1\n", "s.csv:1: found a neck of a sphere and itself, `2,2`"),
            ("0,1,1\n1,0,1\n", "s.csv:2: found a neck for the second time, `1,0`"),
        ] {
            assert_eq!(parse(text).unwrap_err(), what);
        }
        let interrupt = Interrupt::default();
        interrupt.request();
        let stopped = parse_strengths(Path::new("s.csv"), b"0,1,1\n", 4, &interrupt);
        assert!(matches!(stopped, Err(Error::Interrupted)));
    }
}
