//! `veridem check`: checks a case without running it.

use super::run::Limits;
use super::{OutputMode, print};
use crate::error::Error;
use crate::papers::Papers;
use crate::run::Job;
use serde_yaml::Mapping;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
}

/// Checks the case and prints it with its defaults and derived values, and the plan of its run.
pub(super) fn run(arguments: &Arguments, papers: Papers, excess: bool, manner: OutputMode) -> Result<(), Error> {
    let interrupt = Limits::default().interrupt()?;
    let job = Job { excess, ..papers.read(&arguments.case)? };
    interrupt.check()?;
    let plan = job.plan(&interrupt)?;
    let mut checked: Mapping = serde_yaml::from_str(&job.resolved).expect("a resolved case is a mapping");
    checked.insert("plan".into(), plan.into());
    for doubt in &job.doubts {
        manner.say(format!("warning: {doubt}"));
    }
    if !job.doubts.is_empty() {
        let doubts = job.doubts.iter().map(|doubt| doubt.to_string().into());
        checked.insert("warnings".into(), serde_yaml::Value::Sequence(doubts.collect()));
    }
    if manner.json {
        print(&format!("{:#}\n", serde_json::to_value(&checked).expect("a mapping with keys that are words")))
    } else {
        print(&serde_yaml::to_string(&checked).expect("a mapping is plain data"))
    }
}
