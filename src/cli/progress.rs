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
            let style = if std::env::var_os("NO_COLOR").is_some() { "{bar:24}" } else { "{bar:24.cyan}" };
            let template = format!("{{prefix:12}} {style} {{pos}}/{{len}} {{eta}} left, {{msg}}");
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
            if let Some(bar) = &self.bar {
                bar.reset();
            }
        }
        let (since, first) = self.begun;
        let taken = (state.step - first) as f64;
        let each = since.elapsed().as_secs_f64() / taken.max(1.0);
        let cost = 1e9 * each / state.particles as f64;
        let message =
            format!("{cost:.0} ns/particle-step, energy error {:.1e}, overlap {:.3}", state.residual, state.overlap);
        if let Some(bar) = &self.bar {
            bar.set_prefix(self.stage.clone());
            bar.set_length(state.steps);
            bar.set_position(state.step);
            bar.set_message(message);
        } else if taken > 0.0 && self.written.is_none_or(|at| at.elapsed() >= PAUSE) {
            self.written = Some(Instant::now());
            let left = each * state.steps.saturating_sub(state.step) as f64;
            crate::error::message(&format!(
                "{} {}/{}, at most {left:.0} s left, {message}",
                state.stage, state.step, state.steps
            ));
        }
    }

    /// Removes the bar.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
