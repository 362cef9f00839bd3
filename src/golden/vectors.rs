//! Files of golden vectors: reading, generating, checking.

use super::rounding::error;
use super::sample::{Sample, exact, samples};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};
use veridem_spec::Real;
use veridem_spec::document::{Document, Quantity};
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Reference;

const SCHEMA: &str = "veridem golden vectors 1";
const PROVENANCE: &str = "`out` computed with 256-bit numbers from `in` taken exactly, rounded to 34 digits; \
                          a vector with a `source` was computed independently of this code";
/// Random vectors per equation.
const SAMPLED: usize = 8;
/// The independent values come with 35 digits, of which a rounding or two may be wrong.
const INDEPENDENT_TOLERANCE: f64 = 1e-33;

/// The vectors of one equation.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// Name and version of the format.
    pub schema: String,
    /// The equation's name in the list.
    pub equation: String,
    /// How the values came about.
    pub provenance: String,
    /// The vectors.
    pub vectors: Vec<Vector>,
}

/// One input and its output.
#[derive(Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vector {
    /// Why this input: `sampled`, `equal`, `edge`, `zero`, `small`, `near`, or `independent`.
    pub flag: String,
    /// Who computed an independent output.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Every argument by name: a number, or an array for a vector.
    #[serde(rename = "in")]
    pub inputs: Map<String, Value>,
    /// Results by name, as decimals of 34 digits; an independent source may lack some.
    pub out: Map<String, Value>,
}

impl Vector {
    /// The arguments, laid end to end.
    ///
    /// # Errors
    ///
    /// If an argument is missing or not a number.
    pub fn numbers(&self, document: &Document) -> Result<Vec<f64>, String> {
        flatten(&document.arguments, &self.inputs, |value| value.as_f64())
    }
    /// The results, laid end to end; none where an independent source has no value.
    fn outputs(&self, document: &Document) -> Result<Vec<Option<Reference>>, String> {
        let decimal = |value: &Value| value.as_str().and_then(Reference::parse);
        let mut out = vec![];
        for quantity in &document.results {
            match self.out.contains_key(&quantity.name) || self.source.is_none() {
                true => out.extend(flatten(std::slice::from_ref(quantity), &self.out, decimal)?.into_iter().map(Some)),
                false => out.extend(std::iter::repeat_n(None, quantity.size)),
            }
        }
        match self.out.keys().find(|name| document.results.iter().all(|q| q.name != **name)) {
            Some(name) => Err(format!("there is no result `{name}`")),
            None => Ok(out),
        }
    }
    fn mint(document: &Document, Sample { flag, numbers, exact }: &Sample) -> Self {
        Self {
            flag: (*flag).into(),
            source: None,
            inputs: unlay(&document.arguments, numbers, |x| Value::from(*x)),
            out: unlay(&document.results, exact, |y| Value::from(y.to_decimal())),
        }
    }
}

fn flatten<T>(
    quantities: &[Quantity],
    named: &Map<String, Value>,
    read: impl Fn(&Value) -> Option<T>,
) -> Result<Vec<T>, String> {
    let mut out = vec![];
    for quantity in quantities {
        let value = named.get(&quantity.name).ok_or_else(|| format!("`{}` is missing", quantity.name))?;
        let parts = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
        let parts: Option<Vec<T>> = parts.iter().map(&read).collect();
        let parts = parts.filter(|parts| parts.len() == quantity.size);
        out.extend(parts.ok_or_else(|| format!("`{}` is not {} numbers", quantity.name, quantity.size))?);
    }
    Ok(out)
}

fn unlay<T>(quantities: &[Quantity], numbers: &[T], write: impl Fn(&T) -> Value) -> Map<String, Value> {
    let mut rest = numbers;
    let mut take = |quantity: &Quantity| {
        let (parts, after) = rest.split_at(quantity.size);
        rest = after;
        let value = if let [one] = parts { write(one) } else { parts.iter().map(&write).collect() };
        (quantity.name.clone(), value)
    };
    quantities.iter().map(&mut take).collect()
}

/// Where the vectors of an equation are, below the folder `golden`.
pub fn file_of(golden: &Path, equation: &Equation) -> PathBuf {
    let (paper, name) = equation.id.split_once('-').unwrap_or(("", equation.id));
    golden.join(paper).join(format!("{name}.json"))
}

/// Reads the vectors of an equation.
///
/// # Errors
///
/// If the file is missing or cannot be parsed.
pub fn read(golden: &Path, equation: &Equation) -> Result<File, String> {
    let path = file_of(golden, equation);
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
}

/// Checks the vectors of an equation.
pub fn check(golden: &Path, equation: &Equation, document: &Document) -> Vec<String> {
    let file = match read(golden, equation) {
        Ok(file) => file,
        Err(error) => return vec![error],
    };
    let mut wrong = vec![];
    if file.schema != SCHEMA || file.equation != equation.id || file.provenance != PROVENANCE {
        wrong.push(format!("{}: the header is not that of `{SCHEMA}`", equation.id));
    }
    if file.vectors.iter().filter(|vector| vector.source.is_none()).count() < SAMPLED {
        wrong.push(format!("{}: fewer than {SAMPLED} minted vectors", equation.id));
    }
    let failures = file.vectors.iter().enumerate().filter_map(|(k, vector)| {
        let failure = check_vector(equation, document, vector).err()?;
        Some(format!("{} vector {k}: {failure}", equation.id))
    });
    wrong.extend(failures);
    wrong
}

fn check_vector(equation: &Equation, document: &Document, vector: &Vector) -> Result<(), String> {
    let numbers = vector.numbers(document)?;
    if let Some(name) = vector.inputs.keys().find(|name| document.arguments.iter().all(|q| q.name != **name)) {
        return Err(format!("there is no argument `{name}`"));
    }
    let exact = exact(equation, &numbers);
    for (k, (golden, now)) in vector.outputs(document)?.into_iter().zip(&exact).enumerate() {
        let Some(golden) = golden else { continue };
        let agrees = match vector.source {
            None => golden.to_decimal() == now.to_decimal(),
            Some(_) => (golden - *now).abs().le(now.abs() * Reference::exact(INDEPENDENT_TOLERANCE)),
        };
        if !agrees {
            return Err(format!("output {k}: golden {}, now {}", golden.to_decimal(), now.to_decimal()));
        }
    }
    let out = (equation.eval.f64)(&numbers);
    let largest = error(equation, &numbers, &out, &exact, f64::EPSILON).into_iter().fold(0.0, f64::max);
    match document.rounding {
        Some(bound) if largest <= bound => Ok(()),
        bound => Err(format!("f64 is {largest} ULP off, the stated bound is {bound:?}")),
    }
}

/// Regenerates the vectors of an equation and writes them; independent ones are kept. Returns the changes.
///
/// # Errors
///
/// If the file cannot be read or written.
pub fn regenerate(golden: &Path, equation: &Equation, document: &Document) -> std::io::Result<Vec<String>> {
    let old = read(golden, equation).map(|file| file.vectors).unwrap_or_default();
    let minted = samples(equation, document, SAMPLED);
    let mut vectors: Vec<Vector> = minted.iter().map(|sample| Vector::mint(document, sample)).collect();
    let (independent, before): (Vec<Vector>, Vec<Vector>) = old.into_iter().partition(|vector| vector.source.is_some());
    let mut changes = vec![];
    for vector in &vectors {
        match before.iter().find(|old| old.inputs == vector.inputs) {
            None => changes.push(format!("{}: new input {}", equation.id, compact(&vector.inputs))),
            Some(old) if old.out != vector.out => changes.push(difference(equation, document, old, vector)),
            Some(_) => {}
        }
    }
    for old in before.iter().filter(|old| vectors.iter().all(|vector| vector.inputs != old.inputs)) {
        changes.push(format!("{}: input no longer sampled {}", equation.id, compact(&old.inputs)));
    }
    vectors.extend(independent);
    let path = file_of(golden, equation);
    std::fs::create_dir_all(path.parent().unwrap_or(golden))?;
    std::fs::write(&path, render(equation, &vectors))?;
    Ok(changes)
}

fn difference(equation: &Equation, document: &Document, old: &Vector, new: &Vector) -> String {
    let relative = match (old.outputs(document), new.outputs(document)) {
        (Ok(old), Ok(new)) => old
            .into_iter()
            .zip(new)
            .filter_map(|(old, new)| old.zip(new))
            .map(|(old, new)| ((new - old) / old).abs().to_f64())
            .fold(0.0, f64::max),
        _ => f64::NAN,
    };
    format!("{}: {} changed by {relative:.1e} (relative)", equation.id, compact(&new.inputs))
}

fn compact<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).expect("names and numbers can always be written")
}

/// One vector per line.
fn render(equation: &Equation, vectors: &[Vector]) -> String {
    let lines: Vec<String> = vectors.iter().map(|vector| format!("    {}", compact(vector))).collect();
    format!(
        "{{\n  \"schema\": {},\n  \"equation\": {},\n  \"provenance\": {},\n  \"vectors\": [\n{}\n  ]\n}}\n",
        compact(&SCHEMA),
        compact(&equation.id),
        compact(&PROVENANCE),
        lines.join(",\n")
    )
}
