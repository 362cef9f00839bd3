//! JSON lines in, JSON lines out: for other programs that compare their numbers with these.

use super::call::{Registry, Results};
use serde_json::{Map, Value};
use std::io::{self, BufRead, Write};

/// Answers every line that is not empty, in order.
pub(super) fn run(registry: &Registry, input: &mut impl BufRead, out: &mut impl Write) -> io::Result<()> {
    let mut line = vec![];
    while input.read_until(b'\n', &mut line)? > 0 {
        if !line.trim_ascii().is_empty() {
            writeln!(out, "{}", answer(registry, &line))?;
            out.flush()?;
        }
        line.clear();
    }
    Ok(())
}

fn answer(registry: &Registry, line: &[u8]) -> String {
    let request: Result<Value, _> = serde_json::from_slice(line);
    let id = request.as_ref().ok().and_then(|request| request.get("id")).cloned().unwrap_or(Value::Null);
    let reply = match &request {
        Ok(Value::Object(request)) => evaluate(registry, request),
        Ok(_) => Err("expected an object {\"id\": ..., \"in\": {...}}".into()),
        Err(error) => Err(format!("not a line of JSON: {error}")),
    };
    match reply {
        Ok(value) => format!("{{\"id\": {id}, \"out\": {value}}}"),
        Err(error) => format!("{{\"id\": {id}, \"error\": {}}}", Value::from(error)),
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
        let mut out = vec![];
        run(&Registry::new(), &mut input.as_bytes(), &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
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
        assert_eq!(out.len(), 3);
        assert_eq!((&out[0]["id"], &out[0]["out"]), (&Value::from("wear-3"), &Value::from(-0.3)));
        assert!(out[1]["error"].as_str().unwrap().starts_with("not a line of JSON: "));
        assert_eq!((&out[2]["id"], &out[2]["out"]), (&Value::from("wear-03"), &Value::from(0.2)));
    }

    #[test]
    fn numbers_come_back_with_all_their_bits() {
        let input =
            r#"{"id": "wear-3", "in": {"k_n": 0.1, "delta_e": 1, "delta_f": 2, "delta_n": 0.7000000000000001}}"#;
        let mut out = vec![];
        run(&Registry::new(), &mut input.as_bytes(), &mut out).unwrap();
        assert_eq!(out, b"{\"id\": \"wear-3\", \"out\": 7.0000000000000007e-2}\n");
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
        assert!(with(r#""delta_n": NaN"#).starts_with("not a line of JSON: "));
        assert!(with(r#""delta_n": 1e999"#).starts_with("not a line of JSON: "));
        assert_eq!(error("\u{feff}")[..20], *"not a line of JSON: ");
        let missing = error(r#"{"id": "wear-3", "in": {"k_n": 1, "delta_e": 1, "delta_f": 2}}"#);
        assert!(missing.starts_with("`delta_n` is missing (separation of the surfaces"), "{missing}");
        let negative = error(r#"{"id": "wear-3", "in": {"k_n": 0, "delta_e": 1, "delta_f": 2, "delta_n": 0}}"#);
        assert_eq!(negative, "`k_n` = [0.0] is outside its domain: > 0");
    }
}
