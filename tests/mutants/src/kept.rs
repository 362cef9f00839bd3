//! What is known of the mutants, kept between runs.

use crate::copy::Copy;
use crate::rewrite::Mutant;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::sync::Mutex;

/// Who notices a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Notice {
    /// A law of its own file.
    Own,
    /// Another law.
    Other,
    /// None.
    Nobody,
}

const WORDS: [(Notice, &str); 3] = [(Notice::Own, "own"), (Notice::Other, "other"), (Notice::Nobody, "nobody")];

/// Outcomes of mutants, one line each in a file that grows as they are found.
///
/// What is noticed stays so while the code of its file is the same; what is not is tried again when anything has changed.
pub(crate) struct Outcomes {
    known: BTreeMap<String, Notice>,
    /// Those that others than the present laws did not notice.
    survived: BTreeSet<String>,
    file: Mutex<File>,
    laws: String,
}

impl Outcomes {
    /// Those of the copy that are known already.
    pub(crate) fn of(copy: &Copy) -> Self {
        let path = copy.home.join("outcomes.txt");
        let (mut known, mut survived) = (BTreeMap::new(), BTreeSet::new());
        for line in std::fs::read_to_string(&path).unwrap_or_default().lines() {
            let [key, word, laws] = line.split(' ').collect::<Vec<_>>()[..] else { continue };
            let Some((notice, _)) = WORDS.iter().find(|(_, known)| *known == word) else { continue };
            if *notice != Notice::Nobody || laws == copy.laws {
                known.insert(key.into(), *notice);
            } else {
                survived.insert(key.into());
            }
        }
        let file = OpenOptions::new().create(true).append(true).open(&path).expect("a file");
        Self { known, survived, file: Mutex::new(file), laws: copy.laws.clone() }
    }

    pub(crate) fn get(&self, mutant: &Mutant) -> Option<Notice> {
        self.known.get(&mutant.key).copied()
    }

    /// Whether a mutant survived earlier laws: it is the first to be tried with others.
    pub(crate) fn survived(&self, mutant: &Mutant) -> bool {
        self.survived.contains(&mutant.key)
    }

    /// Writes an outcome down.
    pub(crate) fn add(&self, mutant: &Mutant, notice: Notice) {
        let word = WORDS.iter().find(|(known, _)| *known == notice).expect("a word").1;
        writeln!(self.file.lock().expect("no panic"), "{} {word} {}", mutant.key, self.laws).expect("a line");
    }
}

/// The lines of `tests/mutants/survivors.txt` that name a mutant: what follows a line of it is why nobody can notice.
pub(crate) fn explained(root: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(root.join("tests/mutants/survivors.txt")).unwrap_or_default();
    text.lines()
        .filter(|line| line.starts_with("spec/") || line.starts_with("src/"))
        .map(|line| line.trim().to_string())
        .collect()
}
