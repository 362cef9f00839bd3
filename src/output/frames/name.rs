//! The names of the files of frames.

use crate::output::series::slug;
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;

/// The name of a frame: its stage, and its number in the stage. Its files are `stage.000012.xyz`, and others with other endings.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FrameName {
    /// The stage, with hyphens instead of blanks.
    stage: String,
    number: u64,
}

/// The endings of the files of a frame.
const ENDINGS: [&str; 9] =
    ["xyz", "bonds", "obj", "vtp", "pairs.vtp", "surfaces.vtp", "vtkhdf", "pairs.vtkhdf", "surfaces.vtkhdf"];
/// The endings of the files that list the frames of a stage.
const COLLECTIONS: [&str; 3] = ["pvd", "pairs.pvd", "surfaces.pvd"];

impl FrameName {
    /// The name of the first frame of a stage.
    pub fn first(stage: &str) -> Self {
        Self { stage: slug(stage), number: 0 }
    }

    /// The name of the frame of a stage that follows another frame.
    pub fn after(last: Option<&Self>, stage: &str) -> Self {
        let first = Self::first(stage);
        match last {
            Some(last) if last.stage == first.stage => Self { number: last.number + 1, ..first },
            _ => first,
        }
    }

    /// The name of one of its files. The kind of the content stands before the number, so that the files of a kind are a series: `stage-pairs.000012.vtp`.
    pub fn file(&self, ending: &str) -> String {
        let (kind, ending) = kind_of(ending);
        format!("{}{kind}.{:06}.{ending}", self.stage, self.number)
    }

    /// The name of the file that lists the files with this ending of its stage.
    pub(super) fn collection(&self, ending: &str) -> String {
        format!("{}{}.pvd", self.stage, kind_of(ending).0)
    }

    /// The frame that a file of this name belongs to.
    pub fn of_file(name: &OsStr) -> Option<Self> {
        let mut parts = name.to_str()?.splitn(3, '.');
        let (stage, number, ending) = (parts.next()?, parts.next()?, parts.next()?);
        let number = number.parse().ok()?;
        let stage_of = |whole: &&str| {
            let (kind, short) = kind_of(whole);
            (short == ending).then(|| stage.strip_suffix(&kind)).flatten().filter(|stage| !stage.is_empty())
        };
        // The longest ending names the kind.
        let stage = ENDINGS.iter().rev().find_map(stage_of)?.to_string();
        let found = Self { stage, number };
        ENDINGS.iter().any(|ending| OsStr::new(&found.file(ending)) == name).then_some(found)
    }
}

/// The kind of the content of a file with its hyphen, empty for the spheres, and the ending of its name.
fn kind_of(ending: &str) -> (String, &str) {
    ending.split_once('.').map_or((String::new(), ending), |(kind, ending)| (format!("-{kind}"), ending))
}

/// Whether a run writes a file of this name into its folder of frames.
pub fn is_of_frames(name: &OsStr) -> bool {
    let collects = |ending: &&str| {
        let (kind, ending) = kind_of(ending);
        name.to_str().is_some_and(|name| {
            name.len() > kind.len() + ending.len() + 1 && name.ends_with(&format!("{kind}.{ending}"))
        })
    };
    FrameName::of_file(name).is_some() || COLLECTIONS.iter().any(collects)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_numbered_by_stage_and_their_files_are_known_by_their_names() {
        let first = FrameName::after(None, "restructuring 2");
        assert_eq!(first.file("xyz"), "restructuring-2.000000.xyz");
        let second = FrameName::after(Some(&first), "restructuring 2");
        assert_eq!(second.file("pairs.vtp"), "restructuring-2-pairs.000001.vtp");
        assert_eq!(FrameName::after(Some(&second), "indentation").file("bonds"), "indentation.000000.bonds");
        for ending in ENDINGS {
            assert_eq!(FrameName::of_file(OsStr::new(&second.file(ending))), Some(second.clone()), "{ending}");
        }
        for name in ["000012.xyz", "a.12.xyz", "a.000012.xyz.gz", "best.xyz", ".000001.xyz", "a.000001.png"] {
            assert!(!is_of_frames(OsStr::new(name)), "{name}");
        }
        assert!(is_of_frames(OsStr::new("shear.pvd")) && is_of_frames(OsStr::new("shear-pairs.pvd")));
        assert!(!is_of_frames(OsStr::new(".pvd")));
    }
}
