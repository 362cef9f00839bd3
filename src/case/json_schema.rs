//! JSON Schema of case files, draft 2020-12: from the declarations by which they are read.

use super::key::Key;
use super::quantity::{Kind, Scale};
use super::units::simple_units;
use serde_json::{Map, Value, json};

/// A number as a quantity begins with.
const NUMBER: &str = r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?";
/// One power of a unit, and what joins it to the next.
const FACTOR: &str = r"(1|[^\d\s/*·+-][^\s/*·]*)";
const JOINED: &str = r"(\s*[/*·]\s*|\s+)";

/// A quantity: a number with a unit of its dimension, as far as a pattern can tell.
pub(super) fn quantity<K: Kind>() -> Value {
    json!({ "type": "string", "pattern": format!("^\\s*{NUMBER}\\s*({})\\s*$", units::<K>()) })
}

/// A quantity, or a multiple of a scale.
pub(super) fn scaled<K: Kind, S: Scale>() -> Value {
    json!({ "type": "string", "pattern": format!("^\\s*{NUMBER}\\s*({}|{})\\s*$", units::<K>(), S::SYMBOL) })
}

/// The units of a kind: single symbols of its dimension, or any product that is none of another dimension by a single symbol.
fn units<K: Kind>() -> String {
    let simple = simple_units(K::DIMENSION);
    if simple.is_empty() {
        return format!("{FACTOR}({JOINED}{FACTOR})*");
    }
    format!("{}|{FACTOR}({JOINED}{FACTOR})+|[^\\d\\s/*·+-]+\\^\\d", simple.join("|"))
}

/// A section: an object with these keys, of which those without a default are required.
pub fn section(keys: &[Key]) -> Value {
    let required: Vec<&str> = keys.iter().filter(|key| key.default.is_none()).map(|key| key.key).collect();
    json!({ "type": "object", "properties": properties(keys), "required": required, "additionalProperties": false })
}

/// A choice: an object with exactly one of these keys.
pub fn choice(keys: &[Key]) -> Value {
    json!({
        "type": "object",
        "properties": properties(keys),
        "minProperties": 1,
        "maxProperties": 1,
        "additionalProperties": false,
    })
}

fn properties(keys: &[Key]) -> Map<String, Value> {
    let property = |key: &Key| {
        let mut schema = key.schema.clone();
        if let Some(fields) = schema.as_object_mut() {
            fields.insert("description".into(), key.about.clone().into());
            key.default.clone().map(|default| fields.insert("default".into(), default));
        }
        (key.key.to_string(), schema)
    };
    let mut properties = Map::new();
    for (name, schema) in keys.iter().map(property) {
        // Two sections of one name, as of two models, accept either.
        let either = properties.remove(&name).map(|other| json!({ "anyOf": [other, schema.clone()] }));
        properties.insert(name, either.unwrap_or(schema));
    }
    properties
}

/// The schema of a document with these keys.
pub fn document(keys: &[Key]) -> Value {
    let mut schema = section(keys);
    if let Some(fields) = schema.as_object_mut() {
        fields.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
        fields.insert("title".into(), "A case of veridem".into());
    }
    schema
}
