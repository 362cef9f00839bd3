//! `veridem golden`: checks or regenerates the golden vectors.

use super::{OutputMode, print};
use crate::error::{AtPath, Error};
use crate::golden::{
    INDEX, check, check_independent, check_trajectories, documented, index, measure, regenerate, samples,
};
use crate::papers::Papers;
use serde_json::json;
use std::path::PathBuf;

/// Number of random inputs per equation for the measurement of its rounding error.
const SAMPLED: usize = 200;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    action: Action,
    /// The repository, with the folders golden, spec and src
    #[arg(long, default_value = ".", global = true)]
    root: PathBuf,
}

#[derive(clap::Subcommand)]
enum Action {
    /// Compare every vector with 256-bit arithmetic, f64 with every vector, the papers' models with every trajectory, and the index with the sources
    Check,
    /// Regenerate the vectors and the index, and print the changes; independent values are kept
    Regenerate,
    /// Measure the rounding error of every equation and print it beside the stated bound
    Bounds,
}

/// Checks, regenerates or measures.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let root = &arguments.root;
    let equations = documented().map_err(Error::Verification)?;
    let (golden, index_file) = (root.join("golden"), root.join(INDEX));
    // The result for people, if it is more than a message, and for programs.
    let (text, result) = match arguments.action {
        Action::Check => {
            let mut wrong: Vec<String> =
                equations.iter().flat_map(|(e, document)| check(&golden, e, document)).collect();
            wrong.extend(check_independent(&golden, &equations));
            let trajectories = papers.trajectories();
            wrong.extend(check_trajectories(&golden, &trajectories));
            if std::fs::read_to_string(&index_file).at(&index_file)? != index(root, &equations).at(root)? {
                wrong.push(format!("{} is out of date", index_file.display()));
            }
            if !wrong.is_empty() {
                return Err(Error::Verification(wrong.join("\n")));
            }
            let (equations, trajectories) = (equations.len(), trajectories.len());
            manner.say(format!(
                "the golden vectors of {equations} equations and {trajectories} files of trajectories hold"
            ));
            (String::new(), json!({ "equations": equations, "trajectories": trajectories }))
        }
        Action::Regenerate => {
            let mut changes = vec![];
            for (equation, document) in &equations {
                changes.extend(regenerate(&golden, equation, document).at(&golden)?);
            }
            std::fs::write(&index_file, index(root, &equations).at(root)?).at(&index_file)?;
            manner.say(format!("{} equations regenerated, {} vectors changed", equations.len(), changes.len()));
            let text = changes.iter().map(|change| format!("{change}\n")).collect();
            (text, json!({ "equations": equations.len(), "changes": changes }))
        }
        Action::Bounds => {
            let mut text = format!("{:24} {:>10} {:>8}\n", "equation", "measured", "stated");
            let mut bounds = Vec::new();
            for (equation, document) in &equations {
                let measured = measure(equation, &samples(equation, document, SAMPLED)).ulps;
                let stated = document.rounding.map_or("-".into(), |bound| bound.to_string());
                text += &format!("{:24} {measured:>10.3} {stated:>8}\n", equation.id);
                bounds.push(json!({ "equation": equation.id, "measured": measured, "stated": document.rounding }));
            }
            (text, json!(bounds))
        }
    };
    print(&if manner.json { format!("{result:#}\n") } else { text })
}
