//! A number of 256 bits, for reference values of equations.

use crate::Real;
use astro_float::{BigFloat, Consts, Exponent, Radix, RoundingMode, Sign, WORD_BIT_SIZE, Word};
use num_traits::{One, Zero};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

const BITS: usize = 256;
const WORDS: usize = BITS / WORD_BIT_SIZE;
const NEAREST: RoundingMode = RoundingMode::ToEven;
/// Digits of the decimal form: those of a quadruple-precision number.
pub(crate) const DIGITS: usize = 34;

/// A number of 256 bits, every operation rounded to nearest. `astro_float` does the work; this is its `Copy` form.
#[derive(Clone, Copy, Debug)]
pub enum Reference {
    /// `0.mantissa * 2^exponent`, least significant word first.
    #[doc(hidden)]
    Finite { mantissa: [Word; WORDS], negative: bool, exponent: Exponent },
    /// Zero; its sign is not kept.
    Zero,
    /// Plus or minus infinity.
    #[doc(hidden)]
    Infinite { negative: bool },
    /// No number.
    Nan,
}

thread_local! {
    /// What `astro_float` remembers of pi, e and the logarithms of two and ten.
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory for a few constants"));
}
fn with_constants<T>(f: impl FnOnce(&mut Consts) -> T) -> T {
    CONSTANTS.with_borrow_mut(f)
}

impl Reference {
    /// The same number, exactly.
    pub fn exact(value: f64) -> Self {
        // `astro_float` takes a subnormal number for half its value
        let lift = if value.is_subnormal() { 64 } else { 0 };
        let mut number = BigFloat::from_f64(libm::ldexp(value, lift), BITS);
        if let Some(exponent) = number.exponent().filter(|_| lift > 0) {
            number.set_exponent(exponent - lift);
        }
        Self::pack(&number)
    }
    /// The number nearest to a decimal such as `-1.25e-9`, or nothing if `text` is none.
    pub fn parse(text: &str) -> Option<Self> {
        // `astro_float` ignores what follows a number
        text.parse::<f64>().ok()?;
        let number = with_constants(|c| BigFloat::parse(text, Radix::Dec, BITS, NEAREST, c));
        (!number.is_nan()).then(|| Self::pack(&number))
    }
    fn pack(number: &BigFloat) -> Self {
        match number.as_raw_parts() {
            Some(_) if number.is_zero() => Self::Zero,
            Some((words, _, sign, exponent, _)) => {
                let mut mantissa = [0; WORDS];
                mantissa[WORDS - words.len()..].copy_from_slice(words);
                Self::Finite { mantissa, negative: sign.is_negative(), exponent }
            }
            None if number.is_nan() => Self::Nan,
            None => Self::Infinite { negative: number.is_inf_neg() },
        }
    }
    fn unpack(self) -> BigFloat {
        match self {
            Self::Finite { mantissa, negative, exponent } => {
                BigFloat::from_words(&mantissa, if negative { Sign::Neg } else { Sign::Pos }, exponent)
            }
            Self::Zero => BigFloat::new(BITS),
            Self::Infinite { negative: false } => astro_float::INF_POS,
            Self::Infinite { negative: true } => astro_float::INF_NEG,
            Self::Nan => astro_float::NAN,
        }
    }
    /// The nearest `f64`, ties to even.
    pub fn to_f64(self) -> f64 {
        let (mantissa, negative, exponent) = match self {
            Self::Finite { mantissa, negative, exponent } => (mantissa, negative, exponent),
            Self::Zero => return 0.0,
            Self::Infinite { negative } => return if negative { f64::NEG_INFINITY } else { f64::INFINITY },
            Self::Nan => return f64::NAN,
        };
        let bits = |k: usize| mantissa[k / WORD_BIT_SIZE] >> (k % WORD_BIT_SIZE) & 1 == 1;
        // the last place of a double is 2^-1074 at the least
        let kept = (exponent + 1074).clamp(0, 53) as usize;
        let integer = (0..kept).fold(0u64, |sum, k| 2 * sum + u64::from(bits(BITS - 1 - k)));
        let half = bits(BITS - 1 - kept);
        let above_half = half && (0..BITS - 1 - kept).any(bits);
        let rounded = integer + u64::from(half && exponent >= -1074 && (above_half || integer % 2 == 1));
        let size = libm::ldexp(rounded as f64, exponent - kept as i32);
        if negative { -size } else { size }
    }
    /// Decimal with `DIGITS` significant digits, as `-1.234e-9`.
    pub fn to_decimal(self) -> String {
        if let Self::Zero = self {
            return "0.0".into();
        }
        let number = self.unpack();
        let Ok((sign, mut digits, exponent)) = with_constants(|c| number.convert_to_radix(Radix::Dec, NEAREST, c))
        else {
            return self.to_f64().to_string();
        };
        let mut exponent = exponent - 1;
        digits.resize(digits.len().max(DIGITS + 1), 0);
        let up = digits[DIGITS] >= 5;
        digits.truncate(DIGITS);
        if up {
            match digits.iter().rposition(|digit| *digit < 9) {
                Some(k) => {
                    digits[k] += 1;
                    digits[k + 1..].fill(0);
                }
                None => {
                    digits.fill(0);
                    digits[0] = 1;
                    exponent += 1;
                }
            }
        }
        let minus = if sign.is_negative() { "-" } else { "" };
        let tail: String = digits[1..].iter().map(|digit| char::from(b'0' + digit)).collect();
        let power = if exponent == 0 { String::new() } else { format!("e{exponent}") };
        format!("{minus}{}.{tail}{power}", digits[0])
    }
    fn apply(self, f: impl FnOnce(&BigFloat, &mut Consts) -> BigFloat) -> Self {
        let number = self.unpack();
        Self::pack(&with_constants(|c| f(&number, c)))
    }
    fn apply_two(self, other: Self, f: impl FnOnce(&BigFloat, &BigFloat) -> BigFloat) -> Self {
        Self::pack(&f(&self.unpack(), &other.unpack()))
    }
}

impl Real for Reference {
    type Mask = bool;
    fn lit(value: f64) -> Self {
        Self::exact(value)
    }
    fn pi() -> Self {
        Self::pack(&with_constants(|c| c.pi(BITS, NEAREST)))
    }
    fn sqrt(self) -> Self {
        self.apply(|x, _| x.sqrt(BITS, NEAREST))
    }
    fn exp(self) -> Self {
        self.apply(|x, c| x.exp(BITS, NEAREST, c))
    }
    fn ln(self) -> Self {
        self.apply(|x, c| x.ln(BITS, NEAREST, c))
    }
    fn sin(self) -> Self {
        self.apply(|x, c| x.sin(BITS, NEAREST, c))
    }
    fn cos(self) -> Self {
        self.apply(|x, c| x.cos(BITS, NEAREST, c))
    }
    fn acos(self) -> Self {
        self.apply(|x, c| x.acos(BITS, NEAREST, c))
    }
    fn tanh(self) -> Self {
        self.apply(|x, c| x.tanh(BITS, NEAREST, c))
    }
    fn floor(self) -> Self {
        self.apply(|x, _| x.floor())
    }
    fn entry(list: &[f64], place: Self) -> Self {
        Self::exact(f64::entry(list, place.to_f64()))
    }
    fn lt(self, other: Self) -> bool {
        self.unpack().cmp(&other.unpack()).is_some_and(|order| order < 0)
    }
    fn le(self, other: Self) -> bool {
        self.unpack().cmp(&other.unpack()).is_some_and(|order| order <= 0)
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl Zero for Reference {
    fn zero() -> Self {
        Self::Zero
    }
    fn is_zero(&self) -> bool {
        matches!(self, Self::Zero)
    }
}
impl One for Reference {
    fn one() -> Self {
        Self::exact(1.0)
    }
}
impl Add for Reference {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.apply_two(other, |a, b| a.add(b, BITS, NEAREST))
    }
}
impl Sub for Reference {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.apply_two(other, |a, b| a.sub(b, BITS, NEAREST))
    }
}
impl Mul for Reference {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.apply_two(other, |a, b| a.mul(b, BITS, NEAREST))
    }
}
impl Div for Reference {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.apply_two(other, |a, b| a.div(b, BITS, NEAREST))
    }
}
impl Neg for Reference {
    type Output = Self;
    fn neg(self) -> Self {
        match self {
            Self::Finite { mantissa, negative, exponent } => Self::Finite { mantissa, negative: !negative, exponent },
            Self::Infinite { negative } => Self::Infinite { negative: !negative },
            other => other,
        }
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    fn ulps(approximate: f64, exact: Reference) -> f64 {
        let nearest = exact.to_f64();
        (exact - Reference::exact(approximate)).to_f64().abs() / (nearest.abs().next_up() - nearest.abs())
    }

    proptest! {
        #[test]
        fn rounding_takes_the_nearest_double(x in any::<f64>(), y in any::<f64>()) {
            prop_assume!(y != 0.0); // the quotient is infinite with the sign of a zero, which is not kept
            let (a, b) = (Reference::exact(x), Reference::exact(y));
            for (exact, double) in [(a, x), (a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y), (a.sqrt(), x.sqrt())] {
                prop_assert!(exact.to_f64() == double || exact.to_f64().is_nan() && double.is_nan(), "{x} {y} {double}");
            }
        }

        #[test]
        fn transcendental_functions_of_doubles_are_right_to_one_ulp(x in -20.0..20.0f64) {
            let (a, square) = (Reference::exact(x), Reference::exact(x).squared());
            let errors = [
                ulps(Real::exp(x), a.exp()),
                ulps(Real::sin(x), a.sin()),
                ulps(Real::cos(x), a.cos()),
                ulps(Real::ln(x.abs()), a.abs().ln()),
            ];
            prop_assert!(errors.iter().all(|error| *error <= 1.0), "{errors:?}");
            prop_assert!(ulps(Real::acos(x / 20.0), Reference::exact(x / 20.0).acos()) <= 1.0);
            prop_assert!(ulps(Real::tanh(x), a.tanh()) <= 2.0);
            prop_assert!(ulps(x.abs(), square.sqrt()) == 0.0);
            prop_assert_eq!(a.floor().to_f64(), x.floor());
        }

        #[test]
        fn a_decimal_is_read_back_to_34_digits(x in any::<f64>()) {
            prop_assume!(x.is_finite());
            let third = Reference::exact(x) / Reference::exact(3.0);
            let read = Reference::parse(&third.to_decimal()).unwrap();
            let error = (read - third).abs() / third.abs();
            prop_assert!(third.is_zero() || error.to_f64() <= 5e-34);
            prop_assert_eq!(Reference::exact(x).to_decimal().parse(), Ok(x));
        }

        #[test]
        fn order_is_that_of_doubles(x in any::<f64>(), y in any::<f64>()) {
            let (a, b) = (Reference::exact(x), Reference::exact(y));
            prop_assert_eq!((a.lt(b), a.le(b), a.le(a)), (x < y, x <= y, x <= x));
        }
    }

    #[test]
    fn decimals_look_as_they_should() {
        let decimal = |text: &str| Reference::parse(text).unwrap().to_decimal();
        assert_eq!(decimal("-0.05"), "-5.000000000000000000000000000000000e-2");
        assert_eq!(decimal("9.9999999999999999999999999999999999999"), "1.000000000000000000000000000000000e1");
        assert_eq!(decimal("2"), "2.000000000000000000000000000000000");
        assert_eq!(decimal("1.2999999999999999999999999999999999999"), "1.300000000000000000000000000000000");
        // 35 digits, the last of which is five
        let tie = Reference::exact(0.5f64.powi(49)).to_decimal();
        assert_eq!(tie, "1.776356839400250464677810668945313e-15");
        assert_eq!(Reference::zero().to_decimal(), "0.0");
        assert!(Reference::parse("1.0 m").is_none() && Reference::parse("").is_none());
    }

    #[test]
    fn pi_to_34_digits() {
        assert_eq!(Reference::pi().to_decimal(), "3.141592653589793238462643383279503");
        assert_eq!(Reference::pi().to_f64(), f64::pi());
    }

    #[test]
    fn the_smallest_and_the_largest_doubles_are_kept() {
        for x in [f64::from_bits(1), f64::MIN_POSITIVE, f64::MAX, f64::from_bits(0x000f_ffff_ffff_ffff)] {
            assert_eq!(Reference::exact(x).to_f64(), x);
        }
        assert_eq!((Reference::exact(f64::MAX) * Reference::exact(2.0)).to_f64(), f64::INFINITY);
        assert_eq!((Reference::exact(f64::from_bits(1)) / Reference::exact(2.0)).to_f64(), 0.0);
        assert_eq!((Reference::exact(f64::from_bits(3)) / Reference::exact(2.0)).to_f64(), f64::from_bits(2));
        assert_eq!((-Reference::exact(f64::INFINITY)).to_f64(), f64::NEG_INFINITY);
        // just above the middle between two doubles: the last of 256 bits decides
        let middle = Reference::exact(1.0 + f64::EPSILON) + Reference::exact(0.5 * f64::EPSILON);
        let [up, down] = [0.5f64.powi(255), -0.5f64.powi(255)].map(|bit| (middle + Reference::exact(bit)).to_f64());
        assert_eq!([up, down], [1.0 + 2.0 * f64::EPSILON, 1.0 + f64::EPSILON]);
        let even = Reference::exact(1.0) + Reference::exact(0.5 * f64::EPSILON) + Reference::exact(0.5f64.powi(255));
        assert_eq!(even.to_f64(), 1.0 + f64::EPSILON);
        // of the smallest double: below a half, a half, just above it, three halves and their neighbours
        let smallest = Reference::exact(f64::from_bits(1));
        for (share, bits) in [
            (0.25, 0),
            (0.375, 0),
            (0.5, 0),
            (0.5f64.next_up(), 1),
            (0.75, 1),
            (1.25, 1),
            (1.5, 2),
            (2.5, 2),
            (2.75, 3),
        ] {
            assert_eq!((smallest * Reference::exact(share)).to_f64(), f64::from_bits(bits), "{share}");
        }
    }
}
