//! Quantities of a case file: a number with a unit of the right dimension, or a multiple of a scale of the case.

use super::units::{Dimension, decimal, number_and_unit, shifted, unit};
use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::{Serialize, Serializer};
use std::fmt;
use std::marker::PhantomData;

/// The kind of a quantity: its name, dimension and an example.
pub trait Kind: Clone + fmt::Debug + PartialEq + 'static {
    /// With its article: `a length`.
    const NAME: &'static str;
    /// Its dimension.
    const DIMENSION: Dimension;
    /// An example of a valid value.
    const EXAMPLE: &'static str;
}

/// A reference length, time or other scale defined by the case, of which quantities may be multiples: `1.5 d_0`.
pub trait Scale: Clone + fmt::Debug + PartialEq + 'static {
    /// Its name in case files.
    const SYMBOL: &'static str;
}

macro_rules! kinds {
    ($($name:ident: $text:literal $dimension:tt $example:literal;)*) => {$(
        #[doc = concat!("Marks ", $text, ", such as `", $example, "`.")]
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name;
        impl Kind for $name {
            const NAME: &'static str = $text;
            const DIMENSION: Dimension = Dimension($dimension);
            const EXAMPLE: &'static str = $example;
        }
    )*
        /// The kinds of quantities: names and examples.
        pub const KINDS: &[(&str, &str)] = &[$(($text, $example)),*];
    };
}
kinds! {
    Length: "a length" [0, 1, 0, 0] "14 nm";
    Volume: "a volume" [0, 3, 0, 0] "0.03 nm^3";
    Time: "a time" [0, 0, 1, 0] "10 ns";
    Rate: "a frequency" [0, 0, -1, 0] "0.1 1/ns";
    Velocity: "a velocity" [0, 1, -1, 0] "10 m/s";
    Pressure: "a pressure" [1, -1, -2, 0] "73 GPa";
    SurfaceEnergy: "a surface energy" [1, 0, -2, 0] "1.5 N/m";
    Density: "a density" [1, -3, 0, 0] "2200 kg/m^3";
    Drag: "a damping coefficient" [1, 0, -1, 0] "1e-12 kg/s";
    Stiffness: "a stiffness" [1, 0, -2, 0] "1e6 N/m";
    Energy: "an energy" [1, 2, -2, 0] "1e-19 J";
    Force: "a force" [1, 1, -2, 0] "1 nN";
    Sharpness: "an inverse length" [0, -1, 0, 0] "0.18 1/nm";
    DampingPerArea: "a damping constant" [1, -2, -1, 0] "0.5e6 N s/m^3";
    Temperature: "a temperature" [0, 0, 0, 1] "300 K";
    Viscosity: "a viscosity" [1, -1, -1, 0] "1.85e-5 Pa s";
}

macro_rules! scales {
    ($($name:ident: $symbol:literal $text:literal;)*) => {$(
        #[doc = concat!("Marks multiples of ", $text, ".")]
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name;
        impl Scale for $name {
            const SYMBOL: &'static str = $symbol;
        }
    )*};
}
scales! {
    CriticalDiameter: "d_c" "the critical diameter of Eq. 18";
    ModeDiameter: "d_0" "the most frequent particle diameter";
    JunctionDiameter: "D" "the diameter of the junction";
    SphereRadius: "r" "the radius of the spheres";
    YoungModulus: "E" "Young's modulus";
    CriticalStep: "dt_c" "the critical time step of the smallest particle, Eq. 6";
    CriticalDamping: "c_c" "the critical damping of the smallest particle, Eq. 21";
    Step: "steps" "the time step";
}

/// A quantity with its unit, held in engine units.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity<K> {
    /// In engine units.
    pub value: f64,
    /// As the user wrote it.
    written: String,
    kind: PhantomData<K>,
}

impl<K: Kind> Quantity<K> {
    /// Parses `14 nm`; the error states the problem.
    ///
    /// # Errors
    ///
    /// If the text is no number with a unit, or its dimension is another.
    pub fn parse(text: &str) -> Result<Self, String> {
        let expected = format!("expected {} such as `{}`", K::NAME, K::EXAMPLE);
        let wrong = |what: &str| format!("found `{text}`{what}, {expected}");
        let (number, rest) = number_and_unit(text).ok_or_else(|| wrong(""))?;
        if rest.is_empty() {
            return Err(wrong(" without a unit"));
        }
        let (dimension, power) = unit(rest).ok_or_else(|| wrong(&format!(", `{rest}` is not a unit")))?;
        if dimension != K::DIMENSION {
            return Err(wrong(", which has the wrong dimension"));
        }
        let value = in_range(shifted(number, power), text)?;
        Ok(Self { value, written: text.trim().into(), kind: PhantomData })
    }
}

/// The largest magnitude of a number in a case, in engine units, and the inverse of the smallest: products of such numbers, as energies
/// are, stay finite.
const LARGEST: f64 = 1e40;

/// The number, if it is zero or of a magnitude that can be computed with.
///
/// # Errors
///
/// That the number, as it was `written`, is out of range.
pub(super) fn in_range(number: f64, written: &str) -> Result<f64, String> {
    // A number that is not zero may underflow in engine units.
    let digits = written.split(['e', 'E', ' ']).next().unwrap_or_default();
    let zero = number == 0.0 && !digits.contains(|digit| ('1'..='9').contains(&digit));
    if zero || (1.0 / LARGEST..=LARGEST).contains(&number.abs()) {
        return Ok(number);
    }
    let range = format!("a magnitude between {:e} and {LARGEST:e} in units of nm, ns and ag", 1.0 / LARGEST);
    Err(format!("found `{written}`, expected 0 or {range}"))
}

/// A quantity written in the source code, not by a user.
///
/// # Panics
///
/// If the text is not a quantity of that kind.
pub fn quantity<K: Kind>(text: &str) -> Quantity<K> {
    Quantity::parse(text).expect("a quantity of the right kind")
}

/// A quantity with its unit, or a multiple of the scale `S`.
#[derive(Clone, Debug, PartialEq)]
pub enum Scaled<K, S> {
    /// With a unit.
    Absolute(Quantity<K>),
    /// A multiple of the scale.
    Multiple(f64, PhantomData<S>),
}

impl<K: Kind, S: Scale> Scaled<K, S> {
    /// A multiple of the scale.
    pub const fn times(number: f64) -> Self {
        Self::Multiple(number, PhantomData)
    }
    /// In engine units, where `scale` is the scale in engine units.
    pub fn value(&self, scale: f64) -> f64 {
        match self {
            Self::Absolute(quantity) => quantity.value,
            Self::Multiple(number, _) => number * scale,
        }
    }
    /// The number as written, in engine units or as a multiple: enough to know its sign.
    pub fn number(&self) -> f64 {
        self.value(1.0)
    }
    /// Reads `14 nm` or `1.5 d_0`.
    ///
    /// # Errors
    ///
    /// If the text is no number with a unit, or its dimension is another.
    pub fn parse(text: &str) -> Result<Self, String> {
        if let Some((number, rest)) = number_and_unit(text)
            && rest == S::SYMBOL
        {
            return in_range(number.parse().expect("the number has been parsed before"), text).map(Self::times);
        }
        let or_multiple =
            |error: String| format!("{error} or `{} {}`", if S::SYMBOL == "steps" { "1000" } else { "1.5" }, S::SYMBOL);
        Quantity::parse(text).map(Self::Absolute).map_err(or_multiple)
    }
}

impl<K: Kind> fmt::Display for Quantity<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written)
    }
}
impl<K: Kind, S: Scale> fmt::Display for Scaled<K, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Absolute(quantity) => quantity.fmt(f),
            Self::Multiple(number, _) => write!(f, "{} {}", decimal(*number), S::SYMBOL),
        }
    }
}

/// Reads a scalar of the case file as the text that was written.
pub(super) struct Text<T>(pub(super) fn(&str) -> Result<T, String>);

impl<T> Visitor<'_> for Text<T> {
    type Value = T;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a quantity with its unit")
    }
    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.0)(text).map_err(E::custom)
    }
    fn visit_f64<E: Error>(self, number: f64) -> Result<T, E> {
        self.visit_str(&decimal(number))
    }
    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        self.visit_str(&number.to_string())
    }
    fn visit_i64<E: Error>(self, number: i64) -> Result<T, E> {
        self.visit_str(&number.to_string())
    }
    fn visit_unit<E: Error>(self) -> Result<T, E> {
        Err(E::invalid_type(Unexpected::Unit, &self))
    }
}

impl<'de, K: Kind> Deserialize<'de> for Quantity<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(Self::parse))
    }
}
impl<'de, K: Kind, S: Scale> Deserialize<'de> for Scaled<K, S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(Self::parse))
    }
}
impl<K: Kind> Serialize for Quantity<K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
impl<K: Kind, S: Scale> Serialize for Scaled<K, S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        serializer.collect_str(self)
    }
}
