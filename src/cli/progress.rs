//! Progress of a run, shown to the user.

use super::OutputMode;
use crate::run::{Message, RunProgress};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Interval between progress lines if there is no terminal.
const PAUSE: Duration = Duration::from_secs(5);

/// A bar on a terminal, a line every few seconds elsewhere.
pub(super) struct Progress {
    manner: OutputMode,
    bar: Option<ProgressBar>,
    stage: String,
    begun: (Instant, u64),
    written: Option<Instant>,
}

impl Progress {
    /// Nothing is shown before the first report.
    pub(super) fn new(manner: OutputMode) -> Self {
        let bar = (!manner.quiet && std::io::stderr().is_terminal()).then(|| {
            let style = if std::env::var_os("NO_COLOR").is_some() { "{bar:6}" } else { "{bar:6.cyan}" };
            let template = format!("{{prefix:14!}} {style} {{msg}}");
            ProgressBar::no_length()
                .with_style(ProgressStyle::with_template(&template).expect("the template is well formed"))
        });
        Self { manner, bar, stage: String::new(), begun: (Instant::now(), 0), written: None }
    }

    /// Shows a message of a run.
    pub(super) fn tell(&mut self, message: Message) {
        match (message, &self.bar) {
            (Message::Progress(state), _) => self.show(state),
            (Message::Note(text), Some(bar)) => bar.suspend(|| self.manner.say(text)),
            (Message::Note(text), None) => self.manner.say(text),
        }
    }

    fn show(&mut self, state: RunProgress) {
        if self.manner.quiet {
            return;
        }
        if state.stage != self.stage {
            self.stage = state.stage.into();
            self.begun = (Instant::now(), state.step);
        }
        let (since, first) = self.begun;
        let taken = (state.step - first) as f64;
        let pace = (taken > 0.0).then(|| since.elapsed().as_secs_f64() / taken);
        let text = state.summary(pace);
        if let Some(bar) = &self.bar {
            bar.set_prefix(self.stage.clone());
            bar.set_length(state.all);
            bar.set_position(state.before + state.step);
            bar.set_message(text);
        } else if taken > 0.0 && self.written.is_none_or(|at| at.elapsed() >= PAUSE) {
            self.written = Some(Instant::now());
            crate::error::message(&format!("{} {}/{}: {text}", state.stage, state.step, state.steps));
        }
    }

    /// Removes the bar.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
