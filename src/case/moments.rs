//! The moments of a stage: an interval, or a list of times.

use super::InSteps;
use super::quantity::{Scaled, Text};
use super::section::Field;
use super::units::{decimal, number_and_unit};
use serde::de::value::StrDeserializer;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// The moments of a stage at which something happens.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum Moments {
    /// After each interval.
    Every(InSteps),
    /// At these times since the beginning of the stage.
    At(Vec<InSteps>),
}

impl Moments {
    /// The times and intervals that it is made of.
    pub fn times(&self) -> &[InSteps] {
        match self {
            Self::Every(interval) => std::slice::from_ref(interval),
            Self::At(times) => times,
        }
    }
}

impl Field for Moments {
    fn expects() -> String {
        format!("{}, or a list of such times as `[1, 10, 100 steps]`", InSteps::expects())
    }
    fn schema() -> serde_json::Value {
        let items = serde_json::json!({ "anyOf": [InSteps::schema(), { "type": "number" }] });
        serde_json::json!({ "anyOf": [InSteps::schema(), { "type": "array", "items": items, "minItems": 1 }] })
    }
}

impl<'de> Deserialize<'de> for Moments {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Either)
    }
}

struct Either;

impl<'de> Visitor<'de> for Either {
    type Value = Moments;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Moments::expects())
    }
    fn visit_str<E: Error>(self, text: &str) -> Result<Moments, E> {
        InSteps::deserialize(StrDeserializer::new(text)).map(Moments::Every)
    }
    fn visit_f64<E: Error>(self, number: f64) -> Result<Moments, E> {
        self.visit_str(&decimal(number))
    }
    fn visit_u64<E: Error>(self, number: u64) -> Result<Moments, E> {
        self.visit_str(&number.to_string())
    }
    fn visit_i64<E: Error>(self, number: i64) -> Result<Moments, E> {
        self.visit_str(&number.to_string())
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Moments, A::Error> {
        let mut written = Vec::new();
        while let Some(Scalar(text)) = list.next_element()? {
            written.push(text);
        }
        let wrong = |what: &str| A::Error::custom(format!("found {what}, expected {}", Moments::expects()));
        // A number without a unit has that of the next which has one.
        let (mut unit, mut times) = (String::new(), Vec::new());
        for text in written.iter().rev() {
            let text = match number_and_unit(text) {
                Some((number, "")) => format!("{number} {unit}"),
                Some((_, own)) => {
                    unit = own.into();
                    text.clone()
                }
                None => text.clone(),
            };
            let time = Scaled::parse(text.trim()).map_err(A::Error::custom)?;
            if time.number() < 0.0 {
                return Err(wrong(&format!("`{text}`")));
            }
            times.push(time);
        }
        if times.is_empty() {
            return Err(wrong("an empty list"));
        }
        times.reverse();
        Ok(Moments::At(times))
    }
}

/// A scalar of the case file as the text that was written.
struct Scalar(String);

impl<'de> Deserialize<'de> for Scalar {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(|text| Ok(Scalar(text.into()))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Moments, String> {
        serde_yaml::from_str(text).map_err(|error| error.to_string())
    }

    #[test]
    fn a_list_gives_its_unit_to_the_numbers_before_it() {
        let steps = |numbers: &[f64]| Moments::At(numbers.iter().map(|&number| Scaled::times(number)).collect());
        assert_eq!(read("[1, 10, 100 steps]"), Ok(steps(&[1.0, 10.0, 100.0])));
        assert_eq!(read("100 steps"), Ok(Moments::Every(Scaled::times(100.0))));
        let Ok(Moments::At(times)) = read("[0.5 ns, 2, 3 steps]") else { panic!("a list") };
        assert_eq!(times.iter().map(ToString::to_string).collect::<Vec<_>>(), ["0.5 ns", "2 steps", "3 steps"]);
        for (text, expected) in [
            ("[]", "an empty list"),
            ("[1, 2]", "without a unit"),
            ("[1 nm]", "wrong dimension"),
            ("[-1 steps]", "`-1 steps`"),
        ] {
            assert!(read(text).unwrap_err().contains(expected), "{:?}", read(text));
        }
    }
}
