//! Declaration of a section of a case file, in one place: its keys, their types, defaults and meaning.
//!
//! From one declaration come the Rust structure, the reader that knows its keys, and the listing of `veridem schema`.

use super::json_schema;
pub use super::key::Key;
use super::quantity::{Kind, Quantity, Scale, Scaled, in_range};
use super::units::{decimal, number_and_unit, shifted};
use serde::de::{Deserialize, DeserializeOwned, DeserializeSeed, Deserializer, Error, MapAccess, Unexpected, Visitor};
use serde_json::json;
use std::fmt;
use std::path::PathBuf;

/// A type that the value of a key may have.
pub trait Field: serde::Serialize + DeserializeOwned {
    /// The values that it accepts.
    fn expects() -> String;
    /// Reads the value of a key; every number in it is finite.
    ///
    /// # Errors
    ///
    /// If the value is none that is accepted.
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::deserialize(deserializer)
    }
    /// The names of the keys below it.
    fn names() -> Vec<&'static str> {
        Vec::new()
    }
    /// The keys below it.
    fn keys() -> Vec<Key> {
        Vec::new()
    }
    /// The JSON Schema of its values.
    fn schema() -> serde_json::Value;
}

macro_rules! plain_fields {
    ($($type:ty: $schema:literal $expects:literal),*) => {$(
        impl Field for $type {
            fn expects() -> String {
                $expects.into()
            }
            fn schema() -> serde_json::Value {
                json!({ "type": $schema })
            }
        }
    )*};
}
/// A section that is read elsewhere.
impl Field for () {
    fn expects() -> String {
        "a section".into()
    }
    fn schema() -> serde_json::Value {
        json!({ "type": "object" })
    }
}

plain_fields!(bool: "boolean" "`true` or `false`", u64: "integer" "a whole number", String: "string" "a text", PathBuf: "string" "a path, from the folder of the case unless it is absolute");

impl Field for f64 {
    fn expects() -> String {
        "a number".into()
    }
    fn schema() -> serde_json::Value {
        json!({ "type": "number" })
    }
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PlainNumber)
    }
}

/// Reads a plain number, which is finite.
struct PlainNumber;

impl Visitor<'_> for PlainNumber {
    type Value = f64;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }
    fn visit_f64<E: Error>(self, number: f64) -> Result<f64, E> {
        in_range(number, &decimal(number)).map_err(E::custom)
    }
    fn visit_u64<E: Error>(self, number: u64) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }
    fn visit_i64<E: Error>(self, number: i64) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }
    /// The reader takes a number beyond the range of `f64` for a text.
    fn visit_str<E: Error>(self, text: &str) -> Result<f64, E> {
        match number_and_unit(text) {
            Some((number, "")) if shifted(number, 0).is_infinite() => in_range(f64::INFINITY, text).map_err(E::custom),
            _ => Err(E::invalid_type(Unexpected::Str(text), &self)),
        }
    }
}

/// A value read by [`Field::read`], for the lists and options that hold it, and as the seed of a key.
pub struct Read<T>(pub T);

impl<'de, T: Field> Deserialize<'de> for Read<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        T::read(deserializer).map(Self)
    }
}

impl<K: Kind> Field for Quantity<K> {
    fn expects() -> String {
        format!("{} such as `{}`", K::NAME, K::EXAMPLE)
    }
    fn schema() -> serde_json::Value {
        json_schema::quantity::<K>()
    }
}
impl<K: Kind, S: Scale> Field for Scaled<K, S> {
    fn expects() -> String {
        format!("{} such as `{}` or `1.5 {}`", K::NAME, K::EXAMPLE, S::SYMBOL)
    }
    fn schema() -> serde_json::Value {
        json_schema::scaled::<K, S>()
    }
}
impl<T: Field> Field for Option<T> {
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Option::<Read<T>>::deserialize(deserializer)?.map(|value| value.0))
    }
    fn expects() -> String {
        T::expects()
    }
    fn keys() -> Vec<Key> {
        T::keys()
    }
    fn schema() -> serde_json::Value {
        json!({ "anyOf": [T::schema(), { "type": "null" }] })
    }
}
impl<T: Field> Field for Vec<T> {
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Vec::<Read<T>>::deserialize(deserializer)?.into_iter().map(|value| value.0).collect())
    }
    fn expects() -> String {
        format!("a list of: {}", T::expects())
    }
    fn keys() -> Vec<Key> {
        T::keys()
    }
    fn schema() -> serde_json::Value {
        json!({ "type": "array", "items": T::schema() })
    }
}
impl<T: Field> Field for [T; 2]
where
    Self: DeserializeOwned,
{
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(<[Read<T>; 2]>::deserialize(deserializer)?.map(|value| value.0))
    }
    fn expects() -> String {
        format!("two of: {}", T::expects())
    }
    fn schema() -> serde_json::Value {
        json!({ "type": "array", "items": T::schema(), "minItems": 2, "maxItems": 2 })
    }
}
impl<T: Field> Field for [T; 3]
where
    Self: DeserializeOwned,
{
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(<[Read<T>; 3]>::deserialize(deserializer)?.map(|value| value.0))
    }
    fn expects() -> String {
        format!("three of: {}", T::expects())
    }
    fn schema() -> serde_json::Value {
        json!({ "type": "array", "items": T::schema(), "minItems": 3, "maxItems": 3 })
    }
}

/// The bounds on a type parameter of a section.
pub trait Part: Field + Clone + fmt::Debug + PartialEq {}
impl<T: Field + Clone + fmt::Debug + PartialEq> Part for T {}

/// Reads the name of a key, which must be known and not repeated, so that a wrong key is reported on its own line.
pub struct KeyName<'a> {
    /// The keys of the section.
    pub known: &'a [&'static str],
    /// The keys already read.
    pub seen: &'a [&'static str],
}

impl<'de> DeserializeSeed<'de> for KeyName<'_> {
    type Value = &'static str;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<&'static str, D::Error> {
        deserializer.deserialize_str(self)
    }
}
impl Visitor<'_> for KeyName<'_> {
    type Value = &'static str;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a key")
    }
    fn visit_str<E: Error>(self, name: &str) -> Result<&'static str, E> {
        if self.seen.contains(&name) {
            return Err(E::custom(format!("key `{name}` is written twice")));
        }
        self.known.iter().find(|known| **known == name).copied().ok_or_else(|| E::custom(unknown_key(name, self.known)))
    }
}

/// The message for a key that is not one of `known`.
pub fn unknown_key(name: &str, known: &[&str]) -> String {
    match nearest(name, known) {
        Some(key) => format!("unknown key `{name}`, did you mean `{key}`?"),
        None => format!("unknown key `{name}`, expected one of `{}`", known.join("`, `")),
    }
}

/// The message for a word that is not one of `known`.
pub fn unknown_word(word: &str, known: &[&str]) -> String {
    let meant = nearest(word, known).map(|word| format!("; did you mean `{word}`?")).unwrap_or_default();
    format!("found `{word}`, expected one of `{}`{meant}", known.join("`, `"))
}

/// The word that was probably meant: at most every third letter differs.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let distance = |key: &str| strsim::damerau_levenshtein(name, key);
    known.iter().copied().min_by_key(|key| distance(key)).filter(|key| 3 * distance(key) <= name.len().max(3))
}

/// A section with every key at its default.
pub fn defaults<T: for<'de> Deserialize<'de>>() -> T {
    let nothing =
        serde::de::value::MapDeserializer::<_, serde::de::value::Error>::new(std::iter::empty::<(String, String)>());
    T::deserialize(nothing).expect("every key of an optional section has a default")
}

/// A default as `veridem schema` lists it.
pub fn plain(default: &impl serde::Serialize) -> serde_json::Value {
    serde_json::to_value(default).expect("a default is plain data")
}

/// The error for a missing required key.
pub fn missing<E: Error>(key: &str, expected: &str) -> E {
    E::custom(format!("missing key `{key}`, expected {expected}"))
}

/// Reads the single key of a choice.
///
/// # Errors
///
/// If there is no key, an unknown one, or more than one.
pub fn only_key<'de, A: MapAccess<'de>>(map: &mut A, known: &[&'static str]) -> Result<&'static str, A::Error> {
    map.next_key_seed(KeyName { known, seen: &[] })?.ok_or_else(|| A::Error::custom(one_of(known)))
}

/// The message for a choice that was not made, or made twice.
pub fn one_of(known: &[&str]) -> String {
    format!("expected {}", one_of_these(known))
}

/// The keys that a choice accepts.
pub fn one_of_these(known: &[&str]) -> String {
    format!("exactly one of the keys `{}`", known.join("`, `"))
}

/// Declares a section: `key: Type,` is required, `key: Type = default,` is optional. A section may have type parameters.
#[macro_export]
macro_rules! section {
    ($(#[doc = $about:literal])* pub struct $name:ident $(<$($open:ident),+>)? {
        $($(#[doc = $doc:literal])* $key:ident: $type:ty $(= $default:expr)?,)*
    }) => {
        $(#[doc = $about])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        pub struct $name $(<$($open),+>)? { $($(#[doc = $doc])* pub $key: $type,)* }

        impl $(<$($open),+>)? $name $(<$($open),+>)? {
            /// The names of its keys.
            pub const KEYS: &'static [&'static str] = &[$(stringify!($key)),*];
        }

        impl<'de $($(, $open: $crate::case::section::Part)+)?> serde::Deserialize<'de> for $name $(<$($open),+>)? {
            fn deserialize<Z: serde::Deserializer<'de>>(deserializer: Z) -> Result<Self, Z::Error> {
                struct Section<T>(std::marker::PhantomData<T>);
                impl<'de $($(, $open: $crate::case::section::Part)+)?> serde::de::Visitor<'de> for Section<$name $(<$($open),+>)?> {
                    type Value = $name $(<$($open),+>)?;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        write!(f, "a section with the keys `{}`", [$(stringify!($key)),*].join("`, `"))
                    }
                    fn visit_map<Z: serde::de::MapAccess<'de>>(self, mut map: Z) -> Result<Self::Value, Z::Error> {
                        $(let mut $key: Option<$type> = None;)*
                        let (known, mut seen) = (&[$(stringify!($key)),*], Vec::new());
                        while let Some(key) = map.next_key_seed($crate::case::section::KeyName { known, seen: &seen })? {
                            match key {
                                $(stringify!($key) => $key = Some(map.next_value::<$crate::case::section::Read<$type>>()?.0),)*
                                _ => unreachable!("KeyName returns a known key"),
                            }
                            seen.push(key);
                        }
                        $(let $key = match $key $(.or_else(|| Some($default)))? {
                            Some(value) => value,
                            None => return Err($crate::case::section::missing(
                                stringify!($key), &<$type as $crate::case::section::Field>::expects()
                            )),
                        };)*
                        Ok($name { $($key),* })
                    }
                }
                deserializer.deserialize_map(Section(std::marker::PhantomData))
            }
        }

        impl $(<$($open: $crate::case::section::Part),+>)? $crate::case::section::Field for $name $(<$($open),+>)? {
            fn expects() -> String {
                "a section".into()
            }
            fn names() -> Vec<&'static str> {
                vec![$(stringify!($key)),*]
            }
            fn keys() -> Vec<$crate::case::section::Key> {
                vec![$($crate::case::section::Key {
                    key: stringify!($key),
                    about: concat!($($doc,)*).trim().into(),
                    expects: <$type as $crate::case::section::Field>::expects(),
                    default: $crate::case::section::section!(@default $type $(, $default)?),
                    keys: <$type as $crate::case::section::Field>::keys(),
                    schema: <$type as $crate::case::section::Field>::schema(),
                }),*]
            }
            fn schema() -> serde_json::Value {
                $crate::case::json_schema::section(&<Self as $crate::case::section::Field>::keys())
            }
        }
    };
    (@default $type:ty) => { None };
    (@default $type:ty, $default:expr) => {{
        let default: $type = $default;
        Some($crate::case::section::plain(&default))
    }};
}

/// Declares a choice: a mapping with exactly one of several keys.
#[macro_export]
macro_rules! choice {
    ($(#[doc = $about:literal])* pub enum $name:ident {
        $($(#[doc = $doc:literal])* $variant:ident = $key:literal: $type:ty,)*
    }) => {
        $(#[doc = $about])*
        #[derive(Clone, Debug, PartialEq)]
        #[allow(clippy::large_enum_variant, reason = "a case is one value")]
        pub enum $name { $($(#[doc = $doc])* $variant($type),)* }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self {
                    $(Self::$variant(section) => serializer.collect_map([($key, section)]),)*
                }
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Choice;
                impl<'de> serde::de::Visitor<'de> for Choice {
                    type Value = $name;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str(&$crate::case::section::one_of_these(&[$($key),*]))
                    }
                    fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<$name, A::Error> {
                        const KEYS: &[&str] = &[$($key),*];
                        let chosen = match $crate::case::section::only_key(&mut map, KEYS)? {
                            $($key => $name::$variant(map.next_value::<$crate::case::section::Read<$type>>()?.0),)*
                            _ => unreachable!("KeyName returns a known key"),
                        };
                        match map.next_key_seed($crate::case::section::KeyName { known: KEYS, seen: &[] })? {
                            None => Ok(chosen),
                            Some(_) => Err(serde::de::Error::custom($crate::case::section::one_of(KEYS))),
                        }
                    }
                }
                deserializer.deserialize_map(Choice)
            }
        }

        impl $crate::case::section::Field for $name {
            fn expects() -> String {
                $crate::case::section::one_of_these(&[$($key),*])
            }
            fn names() -> Vec<&'static str> {
                vec![$($key),*]
            }
            fn keys() -> Vec<$crate::case::section::Key> {
                vec![$($crate::case::section::Key {
                    key: $key,
                    about: concat!($($doc,)*).trim().into(),
                    expects: <$type as $crate::case::section::Field>::expects(),
                    default: None,
                    keys: <$type as $crate::case::section::Field>::keys(),
                    schema: <$type as $crate::case::section::Field>::schema(),
                }),*]
            }
            fn schema() -> serde_json::Value {
                $crate::case::json_schema::choice(&<Self as $crate::case::section::Field>::keys())
            }
        }
    };
}

/// Declares a choice between words.
#[macro_export]
macro_rules! words {
    ($(#[doc = $about:literal])* pub enum $name:ident { $($(#[doc = $doc:literal])* $variant:ident = $word:literal,)* }) => {
        $(#[doc = $about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
        pub enum $name { $($(#[doc = $doc])* #[serde(rename = $word)] $variant,)* }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Word;
                impl serde::de::Visitor<'_> for Word {
                    type Value = $name;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str(&<$name as $crate::case::section::Field>::expects())
                    }
                    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<$name, E> {
                        match word {
                            $($word => Ok($name::$variant),)*
                            _ => Err(E::custom($crate::case::section::unknown_word(word, &[$($word),*]))),
                        }
                    }
                }
                deserializer.deserialize_str(Word)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(match self { $(Self::$variant => $word,)* })
            }
        }

        impl $crate::case::section::Field for $name {
            fn expects() -> String {
                format!("one of `{}`", [$($word),*].join("`, `"))
            }
            fn schema() -> serde_json::Value {
                serde_json::json!({ "enum": [$($word),*] })
            }
        }
    };
}
pub use crate::{choice, section, words};
