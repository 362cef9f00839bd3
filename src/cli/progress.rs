//! Progress of a run, shown to the user.

use super::OutputMode;
use crate::case::units::{of_waiting, significant};
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
        let text = summary(&state, pace);
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

/// The share of the run, the time left, and how well the energies balance, in at most 57 columns; a step takes `pace` seconds. Where a stage may end
/// before its largest number of steps, the time is a bound.
fn summary(state: &RunProgress, pace: Option<f64>) -> String {
    let done = state.before.saturating_add(state.step);
    let share = (100.0 * done as f64 / state.all.max(1) as f64).min(100.0).floor();
    let left = state.all.saturating_sub(done) as f64;
    let bound = if state.may_end_early { "at most " } else { "" };
    let left = pace.map_or(String::new(), |pace| format!(", {bound}{} left", duration(pace * left)));
    format!("{share} % of run{left}, {}", balance(state.residual))
}

/// A time in seconds in at most 8 columns.
fn duration(seconds: f64) -> String {
    let (number, unit) = of_waiting(seconds);
    if number < 1000.0 { format!("{number:.0} {unit}") } else { "years".into() }
}

/// How well the energies balance, from the relative residual, in at most 20 columns.
fn balance(residual: f64) -> String {
    let percent = 100.0 * residual.abs();
    match percent {
        _ if percent < 1e-3 => "energy error 0.001 %".into(),
        _ if percent < 100.0 => format!("energy error {} %", significant(percent, 1)),
        _ => "energy NOT balanced".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_fits_80_columns() {
        for seconds in [1e-9, 1e-3, 1.0, 1e4, 1e9] {
            for residual in [0.0, -1e-9, 1.5e-5, 0.0123, 0.99, 7.0, f64::NAN] {
                for before in [0, 10, 900] {
                    let state = RunProgress {
                        stage: "",
                        step: 100,
                        steps: 100,
                        before,
                        all: 1000,
                        may_end_early: true,
                        particles: 1,
                        residual,
                        overlap: 0.0,
                    };
                    let text = summary(&state, Some(seconds));
                    assert!(14 + 1 + 6 + 1 + text.chars().count() < 80, "{text}");
                }
            }
        }
    }

    #[test]
    fn shares_are_of_the_run_and_times_are_bounds_where_a_stage_may_end_early() {
        let state = RunProgress {
            stage: "b",
            step: 50,
            steps: 100,
            before: 200,
            all: 1000,
            may_end_early: true,
            particles: 1,
            residual: 3e-4,
            overlap: 0.0,
        };
        assert_eq!(summary(&state, Some(0.2)), "25 % of run, at most 2 min left, energy error 0.03 %");
        let fixed = RunProgress { may_end_early: false, ..state };
        assert_eq!(summary(&fixed, Some(0.2)), "25 % of run, 2 min left, energy error 0.03 %");
        assert_eq!(summary(&state, None), "25 % of run, energy error 0.03 %");
        assert_eq!([0.0, 90.0, 9000.0, 1e6].map(duration), ["0 s", "90 s", "2 h", "12 days"]);
    }
}
