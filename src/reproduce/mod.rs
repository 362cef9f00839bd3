//! The papers' claims, tested: `veridem reproduce`.

mod setting;

pub use setting::Setting;

use crate::error::Error;
use crate::figures::{Axis, Curve, Plot};

/// How much is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Smaller samples and fewer of them: about ten minutes on two cores.
    Reduced,
    /// The paper's sizes.
    Full,
}

impl Extent {
    /// The one for each extent.
    pub fn of<T>(self, reduced: T, full: T) -> T {
        if self == Self::Full { full } else { reduced }
    }
}

/// A claim of a paper beside what came out.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Claim {
    /// Its name.
    pub id: &'static str,
    /// What is claimed.
    pub claim: String,
    /// The paper's figure.
    pub paper: String,
    /// Ours.
    pub measured: String,
    /// Whether they agree.
    pub verdict: Verdict,
    /// Whether it follows from the equations alone: the program is wrong if it does not hold.
    #[serde(skip)]
    pub exact: bool,
}

/// Whether a claim agrees with what came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Within the tolerance that the claim names.
    Holds,
    /// Not; the findings say what is known about it.
    Differs,
}

impl Claim {
    /// A claim and whether it `holds`.
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

    /// A claim that the figure of the `paper`, in its `unit`, is met to within one of its last place: printed figures are rounded or
    /// cut off.
    pub fn number(
        id: &'static str,
        claim: impl Into<String>,
        paper: &str,
        value: f64,
        unit: &str,
        places: f64,
    ) -> Self {
        let figure: f64 = paper.parse().expect("the paper's figure is a number");
        let text = |number: &str| format!("{number} {unit}").trim_end().to_string();
        let holds = (value - figure).abs() < libm::exp10(-places);
        Self::new(id, claim, text(paper), text(&format!("{value:.5}")), holds)
    }
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its file name, without ending.
    pub name: String,
    /// What it shows.
    pub caption: String,
    /// The picture.
    pub svg: String,
}

impl Figure {
    /// Curves between linear axes, under the name of the file.
    pub fn linear(name: &str, caption: impl Into<String>, [x, y]: [&str; 2], curves: Vec<Curve>) -> Self {
        let svg = Plot { title: name.into(), x: Axis::linear(x), y: Axis::linear(y), curves }.svg();
        Self { name: name.into(), caption: caption.into(), svg }
    }
}

/// A chapter of the claims of a paper: those about one kind of system.
pub struct Chapter {
    /// Its name, a word of the command line.
    pub name: &'static str,
    /// What it is about, with the section of the paper.
    pub about: &'static str,
    /// Its headline.
    pub title: &'static str,
    /// Computes it.
    pub compute: fn(&Setting) -> Result<Evidence, Error>,
}

/// The evidence of a chapter: claims beside what was measured, and figures.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    /// What was left out against the paper, if anything.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_near_a_nan() {
        assert!(!near(f64::NAN, 1.0, 1.0) && !near(1.0, f64::NAN, 1.0));
    }

    #[test]
    fn a_figure_is_met_within_its_last_place() {
        let verdict = |value| Claim::number("", "", "4.48", value, "nm", 2.0).verdict;
        assert_eq!((verdict(4.4701), verdict(4.4899)), (Verdict::Holds, Verdict::Holds));
        assert_eq!((verdict(4.4699), verdict(f64::NAN)), (Verdict::Differs, Verdict::Differs));
    }
}
