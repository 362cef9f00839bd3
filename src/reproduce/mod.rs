//! The papers' claims, tested: `veridem reproduce`.

mod listed;
mod record;
mod setting;

pub use listed::{Line, Listed, lines};
pub use record::{Row, claims_of, recorded, rows};
pub use setting::Setting;

use crate::error::Error;
use crate::figures::{Axis, Curve, Plot};

/// The extent of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Smaller samples and fewer of them: about ten minutes on two cores.
    Reduced,
    /// The paper's sizes.
    Full,
}

impl Extent {
    /// The value for this extent.
    pub fn of<T>(self, reduced: T, full: T) -> T {
        if self == Self::Full { full } else { reduced }
    }
}

/// A claim of a paper beside the measured value.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Claim {
    /// Its name.
    pub id: &'static str,
    /// The claim.
    pub claim: String,
    /// The paper's value.
    pub paper: String,
    /// The measured value.
    pub measured: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Whether it follows from the equations alone, so that the program is wrong if it does not hold.
    #[serde(skip)]
    pub exact: bool,
}

/// Whether a claim agrees with the measured value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The values agree within the stated tolerance.
    Holds,
    /// They differ; the reasons, as far as known, are in the findings.
    Differs,
}

impl Claim {
    /// A claim, with whether it `holds`.
    pub fn new(
        id: &'static str,
        claim: impl Into<String>,
        paper: impl Into<String>,
        measured: impl Into<String>,
        holds: bool,
    ) -> Self {
        let verdict = if holds { Verdict::Holds } else { Verdict::Differs };
        Self { id, claim: claim.into(), paper: paper.into(), measured: measured.into(), verdict, exact: false }
    }

    /// The same, following from the equations alone.
    pub fn exact(self) -> Self {
        Self { exact: true, ..self }
    }

    /// A claim that the measured value agrees with the value of the `paper`, in its `unit`, to within one unit of its last digit, since printed values are
    /// rounded or truncated.
    ///
    /// # Panics
    ///
    /// If the figure of the `paper` is not a number.
    pub fn number(
        id: &'static str,
        claim: impl Into<String>,
        paper: &str,
        value: f64,
        unit: &str,
        places: f64,
    ) -> Self {
        let figure: f64 = paper.parse().expect("the paper's value is a number");
        let text = |number: &str| format!("{number} {unit}").trim_end().to_string();
        let holds = (value - figure).abs() < libm::exp10(-places);
        Self::new(id, claim, text(paper), text(&format!("{value:.5}")), holds)
    }
}

/// A figure.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its file name, without extension.
    pub name: String,
    /// Its caption.
    pub caption: String,
    /// The figure as SVG.
    pub svg: String,
}

impl Figure {
    /// Curves with linear axes, with the file name as name.
    pub fn linear(name: &str, caption: impl Into<String>, [x, y]: [&str; 2], curves: Vec<Curve>) -> Self {
        let svg = Plot { title: name.into(), x: Axis::linear(x), y: Axis::linear(y), curves }.svg();
        Self { name: name.into(), caption: caption.into(), svg }
    }
}

/// A chapter of the claims of a paper, about one kind of system.
pub struct Chapter {
    /// Its name, a word of the command line.
    pub name: &'static str,
    /// Its subject, with the section of the paper.
    pub about: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Computes it.
    pub compute: fn(&Setting) -> Result<Evidence, Error>,
}

/// The evidence of a chapter: claims with measured values, and figures.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    /// Reductions compared with the paper, if any.
    pub note: String,
    /// The claims.
    pub claims: Vec<Claim>,
    /// The figures.
    pub figures: Vec<Figure>,
}

/// `|a / b - 1| <= tolerance`; false for a NaN.
pub fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a / b - 1.0).abs() <= tolerance
}

/// The slope of the straight line through the logarithms of the points.
pub fn log_slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (libm::log(x), libm::log(y))).collect();
    let (mx, my) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (top, bottom) =
        logs.iter().fold((0.0, 0.0), |(t, b), (x, y)| (t + (x - mx) * (y - my), b + (x - mx) * (x - mx)));
    top / bottom
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_near_a_nan() {
        assert!(!near(f64::NAN, 1.0, 1.0) && !near(1.0, f64::NAN, 1.0));
    }

    #[test]
    fn the_slope_of_a_power_law_is_its_exponent() {
        let points: Vec<(f64, f64)> = (1..6).map(|k| (f64::from(k), 3.0 / f64::from(k).sqrt())).collect();
        assert!((log_slope(&points) + 0.5).abs() < 1e-14);
    }

    #[test]
    fn a_figure_is_met_within_its_last_place() {
        let verdict = |value| Claim::number("", "", "4.48", value, "nm", 2.0).verdict;
        assert_eq!((verdict(4.4701), verdict(4.4899)), (Verdict::Holds, Verdict::Holds));
        assert_eq!((verdict(4.4699), verdict(f64::NAN)), (Verdict::Differs, Verdict::Differs));
    }
}
