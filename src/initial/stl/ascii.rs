//! ASCII files: words in any case, on any lines, in any number of solids; `end solid` and `endsolid` alike.

use super::{Corners, at};
use crate::error::Error;
use std::path::Path;

/// The triangles of all solids. Text between solids is not read.
pub(super) fn read(path: &Path, text: &str) -> Result<Vec<Corners>, Error> {
    let mut words = Words { path, lines: text.lines().enumerate(), line: 0, words: Vec::new() };
    let (mut triangles, mut solids, mut inside) = (Vec::new(), 0, false);
    while let Some(word) = words.next() {
        match (word.to_ascii_lowercase().as_str(), inside) {
            ("solid", false) => {
                (inside, solids) = (true, solids + 1);
                words.words.clear();
            }
            ("facet", true) => triangles.push(words.facet()?),
            ("endsolid", true) => {
                inside = false;
                words.words.clear();
            }
            ("facet", false) => return Err(words.wrong("`facet`", "a `solid` before it")),
            (_, false) if solids > 0 => words.words.clear(),
            (_, false) => {
                let expected = "an STL file, binary or with `solid` in its first line";
                return Err(words.wrong(&format!("`{}`", shown(word)), expected));
            }
            (_, true) => return Err(words.wrong(&format!("`{}`", shown(word)), "`facet` or `endsolid`")),
        }
    }
    Ok(triangles)
}

/// The words of a file with their lines. Lines that begin with `#` are comments.
struct Words<'a> {
    path: &'a Path,
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    /// The line of the last word, from 1.
    line: usize,
    /// What is left of it, the next word last.
    words: Vec<&'a str>,
}

impl<'a> Words<'a> {
    /// The next word; `end` and the word after it are one.
    fn next(&mut self) -> Option<&'a str> {
        let word = self.next_alone()?;
        if !word.eq_ignore_ascii_case("end") {
            return Some(word);
        }
        match self.words.last().map(|what| what.to_ascii_lowercase()).as_deref() {
            Some("solid") => self.words.pop().map(|_| "endsolid"),
            Some("facet") => self.words.pop().map(|_| "endfacet"),
            Some("loop") => self.words.pop().map(|_| "endloop"),
            _ => Some(word),
        }
    }

    fn next_alone(&mut self) -> Option<&'a str> {
        while self.words.is_empty() {
            let (number, line) = self.lines.next()?;
            self.line = number + 1;
            if !line.trim_start().starts_with('#') {
                self.words = line.split_whitespace().rev().collect();
            }
        }
        self.words.pop()
    }

    /// The rest of a facet.
    fn facet(&mut self) -> Result<Corners, Error> {
        let mut word = self.some("`outer loop`")?;
        if word.eq_ignore_ascii_case("normal") {
            // Its numbers may be `nan`; they are not used.
            for _ in 0..3 {
                self.some("the three numbers of a normal")?;
            }
            word = self.some("`outer loop`")?;
        }
        self.is(word, "outer")?;
        self.expect("loop")?;
        let mut corners = [[0.0; 3]; 3];
        for corner in &mut corners {
            self.expect("vertex")?;
            for coordinate in corner {
                let word = self.some("a coordinate")?;
                *coordinate =
                    word.parse().ok().filter(|x: &f32| x.is_finite()).ok_or_else(|| {
                        self.wrong(&format!("`{}`", shown(word)), "a finite number in single precision")
                    })?;
            }
        }
        self.expect("endloop")?;
        self.expect("endfacet")?;
        Ok(corners)
    }

    fn expect(&mut self, expected: &str) -> Result<(), Error> {
        let word = self.some(&format!("`{expected}`"))?;
        self.is(word, expected)
    }

    fn is(&self, word: &str, expected: &str) -> Result<(), Error> {
        if word.eq_ignore_ascii_case(expected) {
            return Ok(());
        }
        Err(self.wrong(&format!("`{}`", shown(word)), &format!("`{expected}`")))
    }

    fn some(&mut self, expected: &str) -> Result<&'a str, Error> {
        self.next().ok_or_else(|| at(self.path, self.line, format!("the file ends here, expected {expected}")))
    }

    fn wrong(&self, found: &str, expected: &str) -> Error {
        at(self.path, self.line, format!("found {found}, expected {expected}"))
    }
}

/// A word short enough to be shown.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}
