//! The outline of a case file: the words below `model`, `sample` and `experiment`, which identify its paper.

use super::Case;
use super::check::{Found, either};
use super::read::{document, problem, wrong};
use super::section::{Field, KeyName, missing, one_of, one_of_these, only_key};
use crate::error::Error;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, Visitor};
use std::fmt;
use std::path::Path;

/// The words allowed below `model`, `sample` and `experiment`.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// Below `model`.
    pub model: Vec<&'static str>,
    /// Below `sample`.
    pub sample: Vec<&'static str>,
    /// Below `experiment`.
    pub experiment: Vec<&'static str>,
}

/// The words that were chosen.
#[derive(Clone, Copy, Debug)]
pub struct Outline {
    /// The contact model.
    pub model: &'static str,
    /// The sample.
    pub sample: &'static str,
    /// The experiment.
    pub experiment: &'static str,
}

impl Outline {
    /// Reads the outline of the text of a case file; `words` are those of all papers.
    ///
    /// # Errors
    ///
    /// Wrong YAML, an unknown or missing section, by line and key.
    pub fn read(file: &Path, text: &str, words: &Words) -> Result<Self, Error> {
        let read = Whole(words).deserialize(serde_yaml::Deserializer::from_str(document(file, text)?));
        read.map_err(|error| Error::Input(vec![problem(file, &error)]))
    }

    /// Whether sample and experiment are among the words of the model that was chosen.
    ///
    /// # Errors
    ///
    /// The first section that does not belong to the model.
    pub fn suits(&self, own: &Words, file: &Path, text: &str) -> Result<(), Error> {
        let mut found = Found::new();
        for (key, word, own) in [("sample", self.sample, &own.sample), ("experiment", self.experiment, &own.experiment)]
        {
            if !own.contains(&word) {
                found.push((key.into(), format!("expected {} with the model `{}`", either(own), self.model)));
            }
        }
        if found.is_empty() { Ok(()) } else { Err(wrong(found, file, text)) }
    }
}

/// Reads a case file without the content of the chosen sections.
struct Whole<'a>(&'a Words);

impl<'de> DeserializeSeed<'de> for Whole<'_> {
    type Value = Outline;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Outline, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Whole<'_> {
    type Value = Outline;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a section with the keys `{}`", Case::<(), (), ()>::KEYS.join("`, `"))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Outline, A::Error> {
        let Words { model: models, sample: samples, experiment: experiments } = self.0;
        let (mut model, mut sample, mut experiment, mut seen) = (None, None, None, Vec::new());
        while let Some(key) = map.next_key_seed(KeyName { known: Case::<(), (), ()>::KEYS, seen: &seen })? {
            match key {
                "model" => model = Some(map.next_value_seed(Word(models))?),
                "sample" => sample = Some(map.next_value_seed(Word(samples))?),
                "experiment" => experiment = Some(map.next_value_seed(Word(experiments))?),
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
            seen.push(key);
        }
        if !seen.contains(&"title") {
            return Err(missing("title", &String::expects()));
        }
        Ok(Outline {
            model: model.ok_or_else(|| missing("model", &one_of_these(models)))?,
            sample: sample.ok_or_else(|| missing("sample", &one_of_these(samples)))?,
            experiment: experiment.ok_or_else(|| missing("experiment", &one_of_these(experiments)))?,
        })
    }
}

/// Reads the only key of a section.
struct Word<'a>(&'a [&'static str]);

impl<'de> DeserializeSeed<'de> for Word<'_> {
    type Value = &'static str;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<&'static str, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Word<'_> {
    type Value = &'static str;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&one_of_these(self.0))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<&'static str, A::Error> {
        let word = only_key(&mut map, self.0)?;
        map.next_value::<IgnoredAny>()?;
        match map.next_key_seed(KeyName { known: self.0, seen: &[] })? {
            None => Ok(word),
            Some(_) => Err(serde::de::Error::custom(one_of(self.0))),
        }
    }
}
