//! A key of a case file as it is listed.

/// A key of a case file, for the reader of `veridem schema`.
#[derive(Debug, serde::Serialize)]
pub struct Key {
    /// Its name.
    pub key: &'static str,
    /// Its meaning.
    pub about: String,
    /// The values that it accepts.
    pub expects: String,
    /// Its default value; none for a required key.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub default: Option<serde_json::Value>,
    /// The keys below it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub keys: Vec<Key>,
    /// The JSON Schema of its values.
    #[serde(skip)]
    pub schema: serde_json::Value,
}
