//! The keys of a sweep and their values.

use crate::case::units::{decimal, number_and_unit, shifted};
use crate::error::Error;

/// Largest number of runs of a sweep: far more than anyone waits for, and all cases fit into memory.
const MOST: usize = 100_000;
/// Significant digits of the values of a range, so that `0..0.3:4` has 0.1 and 0.2 in it.
const DIGITS: usize = 12;

/// A key and its values.
pub struct Axis {
    /// The key, with its sections.
    pub key: String,
    /// Its values, in YAML.
    pub values: Vec<String>,
}

/// The axes of the sweep, each key once.
pub(super) fn axes(arguments: &[String]) -> Result<Vec<Axis>, Error> {
    let mut axes: Vec<Axis> = Vec::new();
    let mut runs = Some(1_usize);
    for argument in arguments {
        let wrong = |what: &str| Error::Usage(format!("`{argument}`: {what}"));
        let (key, values) = argument.split_once('=').ok_or_else(|| wrong("expected KEY=VALUES"))?;
        let key = key.trim();
        if axes.iter().any(|other| other.key == key) {
            return Err(wrong(&format!("the key `{key}` is given twice")));
        }
        let mut all = Vec::new();
        for value in split(values).map_err(wrong)? {
            match Range::of(value) {
                Some(range) => all.extend(range.values().map_err(wrong)?),
                None if value.is_empty() => return Err(wrong("a value is empty")),
                None => all.push(value.into()),
            }
        }
        runs = runs.and_then(|runs| runs.checked_mul(all.len())).filter(|&runs| runs <= MOST);
        if runs.is_none() {
            return Err(Error::Usage(format!("these values make more than {MOST} runs")));
        }
        axes.push(Axis { key: key.into(), values: all });
    }
    Ok(axes)
}

/// Cuts at the commas that stand outside of brackets, braces and quotes.
fn split(values: &str) -> Result<Vec<&str>, &'static str> {
    let (mut parts, mut begin, mut open, mut quote) = (Vec::new(), 0, Vec::new(), None);
    // Brackets and quotes have a meaning only where a value can begin: `it's` is a word.
    let mut fresh = true;
    let mut characters = values.char_indices();
    while let Some((place, c)) = characters.next() {
        match (quote, c) {
            (Some('"'), '\\') => drop(characters.next()),
            (Some('\''), '\'') if characters.as_str().starts_with('\'') => drop(characters.next()),
            (Some(mark), _) if mark == c => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') if fresh => quote = Some(c),
            (None, '[') if fresh => open.push(']'),
            (None, '{') if fresh => open.push('}'),
            (None, _) if open.last() == Some(&c) => drop(open.pop()),
            (None, ']' | '}') if !open.is_empty() => return Err("the brackets do not match"),
            (None, ',') if open.is_empty() => {
                parts.push(values[begin..place].trim());
                begin = place + 1;
            }
            _ => {}
        }
        fresh = quote.is_none() && ("[{,".contains(c) || c == ':' && !open.is_empty() || fresh && c.is_whitespace());
    }
    if quote.is_some() {
        return Err("a quotation mark is not closed");
    }
    if !open.is_empty() {
        return Err("a bracket is not closed");
    }
    parts.push(values[begin..].trim());
    Ok(parts)
}

/// `FIRST..LAST`, with a count and a unit perhaps.
struct Range<'a> {
    first: &'a str,
    last: &'a str,
    count: Option<&'a str>,
    unit: &'a str,
}

impl<'a> Range<'a> {
    /// A value is a range only if numbers stand on both sides of the dots: paths and texts may hold dots, too.
    fn of(value: &'a str) -> Option<Self> {
        let (range, unit) = value.split_once(' ').unwrap_or((value, ""));
        let (first, rest) = range.split_once("..")?;
        let (last, count) = rest.split_once(':').map_or((rest, None), |(last, count)| (last, Some(count)));
        let number = |text| number_and_unit(text).is_some_and(|(_, rest)| rest.is_empty());
        (number(first) && number(last)).then_some(Self { first, last, count, unit: unit.trim() })
    }

    fn values(&self) -> Result<Vec<String>, &'static str> {
        let with_unit = |number: String| format!("{number} {}", self.unit).trim_end().to_string();
        let Some(count) = self.count else {
            let whole = |text: &str| {
                text.parse::<i64>().map_err(|_| "a range without `:COUNT` must have whole numbers as limits")
            };
            let (first, last) = (whole(self.first)?, whole(self.last)?);
            return match last.checked_sub(first) {
                Some(..0) => Err("expected an increasing range"),
                Some(steps) if steps < MOST as i64 => Ok((first..=last).map(|n| with_unit(n.to_string())).collect()),
                _ => Err("the range has too many values"),
            };
        };
        let count = count.parse().ok().filter(|count| (2..=MOST).contains(count));
        let count = count.ok_or("expected a count of 2 to 100000 after the colon")?;
        let number = |text: &str| {
            Some(shifted(text, 0)).filter(|number| number.is_finite()).ok_or("a limit is beyond the largest number")
        };
        let (first, last) = (number(self.first)?, number(self.last)?);
        let value = |k: usize| {
            let part = k as f64 / (count - 1) as f64;
            let exact = first * (1.0 - part) + last * part;
            format!("{exact:.*e}", DIGITS - 1).parse().expect("a number that was just written")
        };
        Ok((0..count).map(|k| with_unit(decimal(value(k)))).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(argument: &str) -> Vec<String> {
        let axes = axes(&[format!("key={argument}")]);
        axes.unwrap_or_else(|error| panic!("{argument}: {error}")).remove(0).values
    }

    #[test]
    fn a_comma_in_brackets_or_quotes_separates_no_values() {
        for (argument, expected) in [
            ("1,2", &["1", "2"][..]),
            ("[1, 2, 3],[4, 5, 6]", &["[1, 2, 3]", "[4, 5, 6]"]),
            ("{a: [1, 2], b: 'x]'},{a: [3], b: \"y\\\",\"}", &["{a: [1, 2], b: 'x]'}", "{a: [3], b: \"y\\\",\"}"]),
            ("'one, two',\"three, 'four\"", &["'one, two'", "\"three, 'four\""]),
            ("'it''s, so',it's,that's", &["'it''s, so'", "it's", "that's"]),
            ("a[0],b]", &["a[0]", "b]"]),
        ] {
            assert_eq!(values(argument), expected, "{argument}");
        }
        for argument in ["[1, 2", "'1,2", "{a: 1],2", "1,,2", "", "1,"] {
            assert!(axes(&[format!("key={argument}")]).is_err(), "{argument}");
        }
    }

    #[test]
    fn only_two_numbers_make_a_range() {
        for (argument, expected) in [
            ("1..3", &["1", "2", "3"][..]),
            ("-1..1,7", &["-1", "0", "1", "7"]),
            ("0..0.3:4", &["0", "0.1", "0.2", "0.3"]),
            ("1..3 nm", &["1 nm", "2 nm", "3 nm"]),
            ("2e-1..1:3 ps", &["0.2 ps", "0.6 ps", "1 ps"]),
            ("1..0:2", &["1", "0"]),
            ("../x.yaml", &["../x.yaml"]),
            ("{file: ../a.xyz}", &["{file: ../a.xyz}"]),
            ("'1..3'", &["'1..3'"]),
            ("1 nm..2 nm", &["1 nm..2 nm"]),
            ("a..b,1..b", &["a..b", "1..b"]),
        ] {
            assert_eq!(values(argument), expected, "{argument}");
        }
        for argument in ["3..1", "1..2.5", "1..2:1", "1..2:x", "0..9223372036854775807", "-9223372036854775808..1"] {
            assert!(axes(&[format!("key={argument}")]).is_err(), "{argument}");
        }
    }

    #[test]
    fn a_sweep_that_no_one_could_wait_for_is_refused() {
        let many = ["a=1..1000", "b=1..1000"].map(String::from);
        let refused = axes(&many).map(|_| ()).unwrap_err();
        assert_eq!(refused.to_string(), "these values make more than 100000 runs");
    }
}
