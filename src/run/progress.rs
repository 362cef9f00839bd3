//! Messages of a run to its user, and its progress in words.

use crate::case::units::{of_waiting, significant};

/// A message of a run to its user.
#[derive(Clone, Debug)]
pub enum Message<'a> {
    /// Its progress.
    Progress(RunProgress<'a>),
    /// A remark about its folder.
    Note(String),
}

/// Progress of a run.
#[derive(Clone, Copy, Debug)]
pub struct RunProgress<'a> {
    /// The stage.
    pub stage: &'a str,
    /// Number of steps taken in this stage.
    pub step: u64,
    /// Largest number of steps of the stage.
    pub steps: u64,
    /// Largest number of steps of the stages before it.
    pub before: u64,
    /// Largest number of steps of all stages.
    pub all: u64,
    /// Whether this stage or one after it may end before its largest number of steps.
    pub may_end_early: bool,
    /// Number of particles.
    pub particles: usize,
    /// Relative residual of the physical energy balance.
    pub residual: f64,
    /// Largest overlap, relative to the sum of the radii.
    pub overlap: f64,
}

impl RunProgress<'_> {
    /// The share of the run, the time left, and how well the energies balance, in at most 57 columns; a step takes `pace` seconds. Where a stage may end
    /// before its largest number of steps, the time is a bound.
    pub fn summary(&self, pace: Option<f64>) -> String {
        let done = self.before.saturating_add(self.step);
        let share = (100.0 * done as f64 / self.all.max(1) as f64).min(100.0).floor();
        let left = self.all.saturating_sub(done) as f64;
        let bound = if self.may_end_early { "at most " } else { "" };
        let left = pace.map_or(String::new(), |pace| format!(", {bound}{} left", duration(pace * left)));
        format!("{share} % of run{left}, {}", balance(self.residual))
    }
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
                    let text = state.summary(Some(seconds));
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
        assert_eq!(state.summary(Some(0.2)), "25 % of run, at most 2 min left, energy error 0.03 %");
        let fixed = RunProgress { may_end_early: false, ..state };
        assert_eq!(fixed.summary(Some(0.2)), "25 % of run, 2 min left, energy error 0.03 %");
        assert_eq!(state.summary(None), "25 % of run, energy error 0.03 %");
        assert_eq!([0.0, 90.0, 9000.0, 1e6].map(duration), ["0 s", "90 s", "2 h", "12 days"]);
    }
}
