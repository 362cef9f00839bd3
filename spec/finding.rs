//! What a reading finds in its paper: an error, an ambiguity, or a form that loses digits.

use crate::document::Document;

/// What is wrong with an equation as printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It contradicts the paper itself, or mechanics.
    Erratum,
    /// It allows several readings.
    Ambiguous,
    /// It is right, but its terms cancel in floating-point numbers.
    Cancellation,
}

impl Kind {
    /// The word with which its reading begins.
    pub fn label(self) -> &'static str {
        match self {
            Self::Erratum => "Erratum",
            Self::Ambiguous => "Ambiguous",
            Self::Cancellation => "Cancellation",
        }
    }
}

/// A finding: the paragraphs of a reading that begins with `Erratum:`, `Ambiguous:` or `Cancellation:`.
#[derive(Debug, PartialEq, Eq)]
pub struct Finding<'a> {
    /// What it is.
    pub kind: Kind,
    /// What is wrong, and what is right.
    pub text: String,
    /// The paragraph `Effect:`; what the printed form would do.
    pub effect: &'a str,
    /// The names in the paragraph `Proof:`; laws that fail for the printed form.
    pub proof: Vec<&'a str>,
}

impl<'a> Finding<'a> {
    /// The finding of a reading, if it has one.
    pub fn of(document: &'a Document) -> Option<Self> {
        Self::parse(&document.reading)
    }

    fn parse(reading: &'a str) -> Option<Self> {
        let (label, rest) = reading.split_once(": ")?;
        let kind =
            [Kind::Erratum, Kind::Ambiguous, Kind::Cancellation].into_iter().find(|kind| kind.label() == label)?;
        let mut finding = Self { kind, text: String::new(), effect: "", proof: vec![] };
        for paragraph in rest.split("\n\n") {
            if let Some(effect) = paragraph.strip_prefix("Effect: ") {
                finding.effect = effect;
            } else if let Some(proof) = paragraph.strip_prefix("Proof: ") {
                finding.proof = proof.split('`').skip(1).step_by(2).collect();
            } else {
                finding.text.push_str(paragraph);
                finding.text.push_str("\n\n");
            }
        }
        Some(finding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finding_is_read_by_paragraphs() {
        let reading = "Erratum: a sign.\nIt is minus.\n\nEffect: it grows.\n\nProof: `a`, `b`.\n\nMore.";
        let expected = Finding {
            kind: Kind::Erratum,
            text: "a sign.\nIt is minus.\n\nMore.\n\n".into(),
            effect: "it grows.",
            proof: vec!["a", "b"],
        };
        assert_eq!(Finding::parse(reading), Some(expected));
        assert_eq!(Finding::parse("As printed: a sign."), None);
    }
}
