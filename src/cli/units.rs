//! `veridem units`: the units of quantities in case files and on the command line.

use super::{OutputMode, print};
use crate::case::quantity::KINDS;
use crate::case::units::symbols;
use crate::error::Error;
use serde_json::json;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {}

/// Lists symbols, prefixes and kinds of quantities.
pub(super) fn run(_: &Arguments, manner: OutputMode) -> Result<(), Error> {
    let (symbols, prefixes) = symbols();
    if manner.json {
        let kinds: serde_json::Map<String, serde_json::Value> =
            KINDS.iter().map(|(kind, example)| (kind.to_string(), json!(example))).collect();
        let prefixes: serde_json::Map<String, serde_json::Value> =
            prefixes.iter().map(|(prefix, power)| (prefix.to_string(), json!(power))).collect();
        return print(&format!("{:#}\n", json!({ "symbols": symbols, "prefixes": prefixes, "quantities": kinds })));
    }
    let prefixes: Vec<String> = prefixes.iter().map(|(prefix, power)| format!("{prefix} 1e{power}")).collect();
    let mut text = format!(
        "A quantity is a number with a unit, such as `14 nm`. A unit is a product of powers of symbols: `kg m^2/s`; a slash divides by the one factor after it.\n\n\
         symbols   {}\nprefixes  {}\n\nquantities of case files\n",
        symbols.join(", "),
        prefixes.join(", ")
    );
    for (kind, example) in KINDS {
        text.push_str(&format!("  {kind:24}  {example}\n"));
    }
    print(&text)
}
