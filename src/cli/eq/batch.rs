//! JSON lines in, JSON lines out: for other programs that compare their numbers with these.

use crate::equations::{Registry, Results};
use crate::error::{AtPath, Error};
use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};
use std::fmt;
use std::io::{BufRead, Read};
use std::path::Path;

/// Longest line, in bytes: a thousand times what any equation needs.
const LONGEST: u64 = 1 << 20;

/// Numbers of lines.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Lines {
    /// All that were read.
    pub read: usize,
    /// Those that were answered with an error.
    pub failed: usize,
}

/// Answers every line with one line, in order; `write` receives the answers.
pub(super) fn run(
    registry: &Registry,
    input: &mut impl BufRead,
    mut write: impl FnMut(&str) -> Result<(), Error>,
) -> Result<Lines, Error> {
    let source = Path::new("standard input");
    let (mut lines, mut line) = (Lines::default(), vec![]);
    while input.take(LONGEST).read_until(b'\n', &mut line).at(source)? > 0 {
        let too_long = line.len() as u64 == LONGEST && !line.ends_with(b"\n");
        let reply = if too_long {
            input.skip_until(b'\n').at(source)?;
            Err((Value::Null, format!("the line is longer than {LONGEST} bytes")))
        } else {
            let mark = if lines.read == 0 { "\u{feff}".as_bytes() } else { b"" };
            answer(registry, line.strip_prefix(mark).unwrap_or(&line))
        };
        lines.read += 1;
        lines.failed += usize::from(reply.is_err());
        write(&match reply {
            Ok((id, value)) => format!("{{\"id\": {id}, \"out\": {value}}}\n"),
            Err((id, error)) => format!("{{\"id\": {id}, \"error\": {}}}\n", Value::from(error)),
        })?;
        line.clear();
    }
    Ok(lines)
}

/// The id of a request, with the result or an error.
fn answer(registry: &Registry, line: &[u8]) -> Result<(Value, String), (Value, String)> {
    if line.trim_ascii().is_empty() {
        return Err((Value::Null, "the line is blank".into()));
    }
    match serde_json::from_slice(line) {
        Ok(Unique(Value::Object(request))) => {
            let id = request.get("id").cloned().unwrap_or(Value::Null);
            let result = evaluate(registry, &request);
            result.map(|value| (id.clone(), value)).map_err(|error| (id, error))
        }
        Ok(_) => Err((Value::Null, "expected an object {\"id\": ..., \"in\": {...}}".into())),
        Err(error) => Err((Value::Null, not_json(&error, line))),
    }
}

/// Why a line is not JSON; names numbers that are not finite, for which JSON has no words.
fn not_json(error: &serde_json::Error, line: &[u8]) -> String {
    let of_word = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
    let (before, after) = line.split_at(error.column().saturating_sub(1).min(line.len()));
    let begin = before.len() - before.iter().rev().take_while(|byte| of_word(byte)).count();
    let end = before.len() + after.iter().take_while(|byte| of_word(byte)).count();
    let word = String::from_utf8_lossy(&line[begin..end]);
    if word.parse::<f64>().is_ok_and(|number| !number.is_finite()) {
        return format!("not a line of JSON: `{word}` is not a finite number");
    }
    if error.is_data() { error.to_string() } else { format!("not a line of JSON: {error}") }
}

/// JSON in which no name stands twice in one object.
struct Unique(Value);

impl<'de> Deserialize<'de> for Unique {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AnyValue).map(Self)
    }
}

struct AnyValue;

impl<'de> Visitor<'de> for AnyValue {
    type Value = Value;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }
    fn visit_unit<E: de::Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }
    fn visit_bool<E: de::Error>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }
    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }
    fn visit_str<E: de::Error>(self, value: &str) -> Result<Value, E> {
        Ok(value.into())
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut values = Vec::new();
        while let Some(Unique(value)) = list.next_element()? {
            values.push(value);
        }
        Ok(values.into())
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut values = Map::new();
        while let Some((name, Unique(value))) = map.next_entry::<String, Unique>()? {
            if values.contains_key(&name) {
                return Err(de::Error::custom(format!("`{name}` is given twice")));
            }
            values.insert(name, value);
        }
        Ok(values.into())
    }
}

fn evaluate(registry: &Registry, request: &Map<String, Value>) -> Result<String, String> {
    let id = request.get("id").and_then(Value::as_str).ok_or("`id` is missing or no text")?;
    let entry = registry.find(id)?;
    let inputs = request.get("in").and_then(Value::as_object).ok_or("`in` is missing or no object")?;
    let mut given = vec![];
    for (name, value) in inputs {
        entry.argument(name)?;
        let numbers =
            flatten(value).ok_or_else(|| format!("`{name}` = {value} is neither a number nor an array of numbers"))?;
        given.push((name.clone(), numbers));
    }
    entry.evaluate(given).map(|results| value(&results))
}

/// A number, the three numbers of a vector, or the rows of a tensor, one after the other.
fn flatten(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Number(number) => number.as_f64().map(|x| vec![x]),
        Value::Array(parts) => parts.iter().map(flatten).collect::<Option<Vec<_>>>().map(|parts| parts.concat()),
        _ => None,
    }
}

/// The results as JSON with 17 significant digits: one alone as a number or array, several by name.
pub(super) fn value(results: &Results) -> String {
    let numbers = |values: &[f64]| -> String {
        let digits: Vec<String> = values.iter().map(|x| format!("{x:.16e}")).collect();
        let array = |digits: &[String]| format!("[{}]", digits.join(", "));
        match digits.len() {
            1 => digits[0].clone(),
            9 => array(&digits.chunks(3).map(array).collect::<Vec<_>>()),
            _ => array(&digits),
        }
    };
    match &results[..] {
        [(_, values)] => numbers(values),
        _ => {
            let named: Vec<String> =
                results.iter().map(|(q, values)| format!("\"{}\": {}", q.name, numbers(values))).collect();
            format!("{{{}}}", named.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answers(input: &str) -> Vec<Value> {
        written(input.as_bytes()).0.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
    fn written(mut input: &[u8]) -> (String, Lines) {
        let mut out = String::new();
        let keep = |line: &str| {
            out.push_str(line);
            Ok(())
        };
        let lines = run(&Registry::new(), &mut input, keep).unwrap();
        (out, lines)
    }
    fn error(input: &str) -> String {
        answers(input)[0]["error"].as_str().unwrap().to_string()
    }

    #[test]
    fn every_line_is_answered_in_order() {
        let out = answers(concat!(
            "{\"id\": \"wear-3\", \"in\": {\"k_n\": 1.0, \"delta_e\": 0.2, \"delta_f\": 0.5, \"delta_n\": -0.3}}\n",
            "\n",
            "{\"id\": \"wear-3\", \"in\": \n",
            "{\"id\": \"wear-03\", \"in\": {\"kN\": 2, \"deltaE\": 0.2, \"delta_F\": 0.5, \"deltan\": 0.1}}",
        ));
        assert_eq!(out.len(), 4);
        assert_eq!((&out[0]["id"], &out[0]["out"]), (&Value::from("wear-3"), &Value::from(-0.3)));
        assert_eq!((&out[1]["id"], &out[1]["error"]), (&Value::Null, &Value::from("the line is blank")));
        assert!(out[2]["error"].as_str().unwrap().starts_with("not a line of JSON: "));
        assert_eq!((&out[3]["id"], &out[3]["out"]), (&Value::from("wear-03"), &Value::from(0.2)));
    }

    #[test]
    fn whatever_the_lines_are_each_has_its_answer() {
        let good = "{\"id\": \"wear-3\", \"in\": {\"k_n\": 1, \"delta_e\": 1, \"delta_f\": 2, \"delta_n\": 0.5}}";
        let long = format!("{{\"id\": \"{}\"}}", "x".repeat(3 << 20));
        let nested = "[".repeat(100_000);
        let mark = format!("\u{feff}{good}\r");
        let lines: [&[u8]; 8] = [
            mark.as_bytes(),
            b"\r",
            &[0, 159, 146, 150],
            long.as_bytes(),
            nested.as_bytes(),
            b"null",
            b"",
            good.as_bytes(),
        ];
        let (out, counted) = written(&lines.join(&b'\n'));
        assert_eq!(counted, Lines { read: 8, failed: 6 });
        let answers: Vec<Value> = out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let evaluated: Vec<bool> = answers.iter().map(|answer| answer["out"] == 0.5).collect();
        assert_eq!(evaluated, [true, false, false, false, false, false, false, true]);
        assert_eq!(answers[3]["error"], "the line is longer than 1048576 bytes");
        assert_eq!(written(b"").1, Lines::default());
    }

    #[test]
    fn numbers_come_back_with_all_their_bits() {
        let input =
            r#"{"id": "wear-3", "in": {"k_n": 0.1, "delta_e": 1, "delta_f": 2, "delta_n": 0.7000000000000001}}"#;
        assert_eq!(written(input.as_bytes()).0, "{\"id\": \"wear-3\", \"out\": 7.0000000000000007e-2}\n");
        assert_eq!(answers(input)[0]["out"].as_f64(), Some(0.1 * 0.7000000000000001));
    }

    #[test]
    fn errors_name_the_cause() {
        assert_eq!(error("[1]"), "expected an object {\"id\": ..., \"in\": {...}}");
        assert_eq!(error("{\"in\": {}}"), "`id` is missing or no text");
        assert_eq!(error("{\"id\": \"wear-3\"}"), "`in` is missing or no object");
        let with = |last: &str| {
            error(&format!(r#"{{"id": "wear-3", "in": {{"k_n": 1, "delta_e": 1, "delta_f": 2, {last}}}}}"#))
        };
        assert_eq!(with(r#""delta_m": 0"#), "wear-3 has no argument `delta_m`, the nearest is `delta_n`");
        assert_eq!(with(r#""delta_n": [0, 1]"#), "`delta_n` is 2 numbers, expected one number");
        assert_eq!(with(r#""delta_n": "0""#), "`delta_n` = \"0\" is neither a number nor an array of numbers");
        assert_eq!(with(r#""kN": 2"#), "`k_n` is given twice");
        assert_eq!(with(r#""k_n": 2"#), "`k_n` is given twice at line 1 column 71");
        for word in ["NaN", "nan", "inf", "-inf", "Infinity", "-Infinity", "1e400", "-1e999"] {
            let expected = format!("not a line of JSON: `{word}` is not a finite number");
            assert_eq!(with(&format!("\"delta_n\": {word}")), expected);
            assert_eq!(with(&format!("\"delta_n\":{word} ")), expected);
        }
        assert_eq!(error(r#"{"id": "wear-3b"}"#), "there is no equation `wear-3b`, the nearest is `wear-3`");
        let missing = error(r#"{"id": "wear-3", "in": {"k_n": 1, "delta_e": 1, "delta_f": 2}}"#);
        assert!(missing.starts_with("`delta_n` is missing (separation of the surfaces"), "{missing}");
        let negative = error(r#"{"id": "wear-3", "in": {"k_n": 0, "delta_e": 1, "delta_f": 2, "delta_n": 0}}"#);
        assert_eq!(negative, "`k_n` = 0 is outside its domain: > 0");
    }
}
