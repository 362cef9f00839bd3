//! Claims with what became of them, in words.

use super::bisection::Proof;
use super::boxes::{Scale, whole};
use super::claims::{Claim, attempt, claims, described};
use crate::equations::Entry;
use rayon::prelude::*;
use veridem_spec::document::Quantity;

/// Checks that are spent on a claim before it is given up.
const BUDGET: usize = 3000;
/// Bounds of the rounding error that are tried where the stated one is not proved, in units of the last place.
const LOOSER: [f64; 9] = [0.5, 1.0, 1.5, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0];

/// What became of a claim.
pub struct Verdict {
    /// The claim.
    pub claim: Claim,
    /// Its proof, or where it stops.
    pub proof: Proof,
    /// A looser bound of the rounding error that is proved where the stated one is not.
    pub looser: Option<f64>,
}

/// How far a claim is established.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It holds for every double in the box.
    Proved,
    /// It holds for the golden vectors and for random samples.
    Sampled,
}

impl Status {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Sampled => "sampled",
        }
    }
}

/// All claims of an equation over a box.
pub fn verdicts(entry: &Entry, scale: Scale) -> Vec<Verdict> {
    let (equation, document) = (&entry.equation, &entry.document);
    let check = |claim: &Claim, budget| attempt(equation, document, claim, scale, budget);
    let verdict = |claim: Claim| {
        let proof = check(&claim, BUDGET);
        if proof.holds() {
            return Verdict { claim, proof, looser: None };
        }
        // what no sample contradicts may be wrong at the bounds of the box
        if let Claim::Sign(result, sign) = claim {
            let weak = Claim::Sign(result, sign.weak());
            let of_weak = if weak == claim { proof.clone() } else { check(&weak, BUDGET) };
            let (claim, proof) = if of_weak.holds() { (weak, of_weak) } else { (claim, proof) };
            return Verdict { claim, proof, looser: None };
        }
        let looser = match claim {
            Claim::Rounding(stated) => {
                let mut bounds = LOOSER.into_iter().filter(|ulps| *ulps > stated);
                bounds.find(|ulps| check(&Claim::Rounding(*ulps), BUDGET / 4).holds())
            }
            _ => None,
        };
        Verdict { claim, proof, looser }
    };
    claims(equation, document).into_par_iter().map(verdict).collect()
}

/// The ranges of the arguments.
pub fn box_text(entry: &Entry, scale: Scale) -> String {
    described(&entry.document, &whole(&entry.document, scale))
}

impl Verdict {
    /// How far the claim is established.
    pub fn status(&self) -> Status {
        if self.proof.holds() { Status::Proved } else { Status::Sampled }
    }
    /// The claim as a sentence.
    pub fn sentence(&self, entry: &Entry) -> String {
        let (ins, outs) = (&entry.document.arguments, &entry.document.results);
        match self.claim {
            Claim::Finite => "every result is finite, no denominator is zero".into(),
            Claim::Sign(result, sign) => format!("{} {}", name(outs, result), sign.text()),
            Claim::Monotonic { result, argument, rises } => {
                format!("{} {} with {}", name(outs, result), if rises { "rises" } else { "falls" }, name(ins, argument))
            }
            Claim::Rounding(ulps) => format!("rounding: at most {ulps} ULP"),
        }
    }
    /// Over how many parts it is proved, or where the proof stops.
    pub fn extent(&self, entry: &Entry) -> String {
        let looser = self.looser.map(|ulps| format!("; at most {ulps} ULP is proved")).unwrap_or_default();
        match &self.proof.stopped {
            None if self.proof.parts == 1 => "over the box as a whole".into(),
            None => format!("over {} parts of the box", self.proof.parts),
            Some((part, why)) => format!("the proof stops: {why} at {}{looser}", described(&entry.document, part)),
        }
    }
}

/// The name of the number that stands at this place.
pub(super) fn name(quantities: &[Quantity], at: usize) -> String {
    let mut rest = at;
    for quantity in quantities {
        if rest < quantity.size {
            return if quantity.size == 1 { quantity.name.clone() } else { format!("{}[{rest}]", quantity.name) };
        }
        rest -= quantity.size;
    }
    unreachable!("a number of the equation")
}
