//! Parameters in words: a key and its values, one after the other, as in an input script.

use crate::error::{Done, wrong};
use veridem_spec::document::Domain;

/// The values that a key takes.
pub(crate) enum Values {
    /// So many numbers, each within a domain such as `> 0`.
    Numbers(usize, &'static str),
    /// One of these words.
    OneOf(&'static [&'static str]),
}

/// A key and what it takes.
pub(crate) type Key = (&'static str, Values);

/// Keys with their values.
pub(crate) struct Words<'a> {
    law: &'static str,
    known: &'static [Key],
    given: Vec<(&'static str, Vec<&'a str>)>,
}

impl<'a> Words<'a> {
    /// Reads keys and values.
    pub(crate) fn parse(law: &'static str, known: &'static [Key], words: &[&'a str]) -> Done<Self> {
        let mut given: Vec<(&str, Vec<&str>)> = Vec::new();
        let mut rest = words;
        while let [key, after @ ..] = rest {
            let Some((name, values)) = known.iter().find(|(name, _)| name == key) else {
                let names: Vec<&str> = known.iter().map(|&(name, _)| name).collect();
                return wrong(format!("{law}: found `{key}`, expected one of `{}`", names.join("`, `")));
            };
            let count = match values {
                Values::Numbers(count, _) => *count,
                Values::OneOf(_) => 1,
            };
            if after.len() < count {
                return wrong(format!("{law}: `{key}`: found {} values, expected {count}", after.len()));
            }
            if given.iter().any(|(before, _)| before == name) {
                return wrong(format!("{law}: `{key}` is given twice"));
            }
            given.push((name, after[..count].to_vec()));
            rest = &after[count..];
        }
        Ok(Self { law, known, given })
    }

    fn of(&self, key: &str) -> Option<&[&'a str]> {
        debug_assert!(self.known.iter().any(|(name, _)| *name == key), "`{key}` is not listed");
        self.given.iter().find(|(name, _)| *name == key).map(|(_, values)| &values[..])
    }

    fn takes(&self, key: &str) -> &Values {
        let found = self.known.iter().find(|(name, _)| *name == key);
        &found.expect("the key is listed").1
    }

    /// The numbers of a key, if it is given.
    pub(crate) fn numbers<const N: usize>(&self, key: &str) -> Done<Option<[f64; N]>> {
        let (Some(words), Values::Numbers(_, domain)) = (self.of(key), self.takes(key)) else { return Ok(None) };
        let allowed = Domain::parse(domain).expect("the domains of the keys are understood");
        let mut numbers = [0.0; N];
        for (number, word) in numbers.iter_mut().zip(words) {
            *number = match word.parse() {
                Ok(value) if f64::is_finite(value) && allowed.contains(&[value]) => value,
                _ => return wrong(format!("{}: `{key}`: found `{word}`, expected a number, {domain}", self.law)),
            };
        }
        Ok(Some(numbers))
    }

    /// The number of a key, or a default.
    pub(crate) fn number(&self, key: &str, default: f64) -> Done<f64> {
        Ok(self.numbers::<1>(key)?.map_or(default, |[number]| number))
    }

    /// The number of a key that must be given.
    pub(crate) fn required(&self, key: &str) -> Done<f64> {
        match self.numbers::<1>(key)? {
            Some([number]) => Ok(number),
            None => wrong(format!("{}: `{key}` is missing", self.law)),
        }
    }

    /// The place of the word of a key among those that it may be; the first if it is not given.
    pub(crate) fn choice(&self, key: &str) -> Done<usize> {
        let (Some(&[word]), Values::OneOf(words)) = (self.of(key), self.takes(key)) else { return Ok(0) };
        match words.iter().position(|known| *known == word) {
            Some(place) => Ok(place),
            None => wrong(format!("{}: `{key}`: found `{word}`, expected one of `{}`", self.law, words.join("`, `"))),
        }
    }
}
