//! `veridem schema`: every key of a case file, from the declarations by which it is read.

use super::{OutputMode, print};
use crate::case::json_schema::document;
use crate::case::section::Key;
use crate::error::Error;
use crate::papers::Papers;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// Print a JSON Schema (draft 2020-12), with which editors complete and check case files
    #[arg(long, conflicts_with = "results")]
    json_schema: bool,
    /// List the columns and results of runs instead, as Markdown
    #[arg(long)]
    results: bool,
}

/// Lists the keys.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    if arguments.results {
        return print(&papers.quantities());
    }
    let keys = papers.keys();
    if arguments.json_schema {
        return print(&format!("{:#}\n", document(&keys)));
    }
    if manner.json {
        let json = serde_json::to_string_pretty(&keys).expect("keys are plain data");
        return print(&format!("{json}\n"));
    }
    let mut text = String::new();
    list(&keys, 0, &mut text);
    print(&text)
}

fn list(keys: &[Key], depth: usize, text: &mut String) {
    for Key { key, about, expects, default, keys, .. } in keys {
        let indent = "  ".repeat(depth);
        let expects = if keys.is_empty() { format!(" Expects {expects}.") } else { String::new() };
        let written = match default {
            Some(default) if keys.is_empty() => format!(" {}", default.to_string().replace('"', "")),
            None if keys.is_empty() => " ...".into(),
            _ => String::new(),
        };
        let must = if default.is_none() && keys.is_empty() { " Required." } else { "" };
        text.push_str(&format!("{indent}# {about}{expects}{must}\n{indent}{key}:{written}\n"));
        list(keys, depth + 1, text);
    }
}
