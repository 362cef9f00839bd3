//! Branch and bound: a claim about a box holds if it holds for the parts of some division of it.

use veridem_spec::numbers::Interval;

/// A box: an interval for every number.
pub type Ranges = Vec<Interval>;

/// What became of a claim.
#[derive(Clone, Debug)]
pub struct Proof {
    /// Parts of the box for which the claim was shown.
    pub parts: usize,
    /// A part for which it was not, and why; none if the claim is proved.
    pub stopped: Option<(Ranges, String)>,
}

impl Proof {
    /// Whether the claim holds over the whole box.
    pub fn holds(&self) -> bool {
        self.stopped.is_none()
    }
}

/// A part of a box, and whether the claim was shown for it.
type Checked = (Result<(), String>, Ranges);

/// Proves a claim by halving boxes until it can be checked for each; gives up after `budget` checks.
pub(super) fn prove(whole: Ranges, budget: usize, check: impl Fn(&[Interval]) -> Result<(), String>) -> Proof {
    let mut open = vec![(check(&whole), whole)];
    let (mut parts, mut checks) = (0, 1);
    while let Some((verdict, part)) = open.pop() {
        let Err(why) = verdict else {
            parts += 1;
            continue;
        };
        // The side whose halves are both settled, or else one of them, or else the widest.
        let mut best: Option<(usize, [Checked; 2])> = None;
        for side in sides(&part) {
            if checks + 2 > budget {
                break;
            }
            checks += 2;
            let halves = halves(&part, side).map(|half| (check(&half), half));
            let settled = halves.iter().filter(|half| half.0.is_ok()).count();
            if best.as_ref().is_none_or(|best| settled > best.0) {
                best = Some((settled, halves));
            }
            // numbers of one sign first: most claims ask for nothing else
            if settled == 2 || width(part[side]) == f64::INFINITY {
                break;
            }
        }
        match best {
            Some((_, halves)) => open.extend(halves),
            None => return Proof { parts, stopped: Some((part, why)) },
        }
    }
    Proof { parts, stopped: None }
}

/// Divides a box evenly into at least `count` parts where it can, always along the widest side.
pub(super) fn divide(whole: Ranges, count: usize) -> Vec<Ranges> {
    let mut parts = vec![whole];
    while parts.len() < count {
        let Some(side) = sides(&parts[0]).first().copied() else { break };
        parts = parts.iter().flat_map(|part| halves(part, side)).collect();
    }
    parts
}

/// Most sides that are tried before the widest is taken.
const TRIED: usize = 6;
/// Relative width below which a side is not halved any more.
const NARROW: f64 = 1e-12;

/// The sides that may be halved: those that contain zero inside, then the widest in relative terms.
fn sides(part: &[Interval]) -> Vec<usize> {
    let mut sides: Vec<usize> = (0..part.len()).filter(|side| width(part[*side]) > NARROW).collect();
    sides.sort_by(|a, b| width(part[*b]).total_cmp(&width(part[*a])));
    sides.truncate(TRIED);
    sides
}

/// Relative width: infinite for numbers of both signs, above one for those that go down to zero.
fn width(x: Interval) -> f64 {
    if x.lo < 0.0 && x.hi > 0.0 { f64::INFINITY } else { ratio(x).ln() }
}
/// The largest over the smallest size.
fn ratio(x: Interval) -> f64 {
    let (a, b) = (x.lo.abs(), x.hi.abs());
    let (small, large) = (a.min(b), a.max(b));
    if large == 0.0 { 1.0 } else { large / small.max(1e-3 * large) }
}

/// Halves of a box along a side: at zero, or between the bounds on a logarithmic scale.
fn halves(part: &[Interval], side: usize) -> [Ranges; 2] {
    let Interval { lo, hi } = part[side];
    let at = if lo < 0.0 && hi > 0.0 {
        0.0
    } else if lo * hi > 0.0 && ratio(part[side]) > 4.0 {
        (lo.abs().sqrt() * hi.abs().sqrt()).copysign(lo)
    } else {
        lo + 0.5 * (hi - lo)
    };
    let with = |range| {
        let mut half = part.to_vec();
        half[side] = range;
        half
    };
    [with(Interval::new(lo, at)), with(Interval::new(at, hi))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_is_proved_part_by_part_and_a_false_one_is_not() {
        let whole = vec![Interval::new(-1.0, 8.0), Interval::new(1.0, 3.0)];
        let narrow = |part: &[Interval]| if part[0].hi - part[0].lo < 0.5 { Ok(()) } else { Err("wide".into()) };
        let proof = prove(whole.clone(), 1000, narrow);
        assert!(proof.holds() && proof.parts >= 18, "{proof:?}");
        let root = |part: &[Interval]| if part[0].contains(2.0) { Err("a root".into()) } else { Ok(()) };
        let proof = prove(whole, 1000, root);
        let (at, why) = proof.stopped.expect("it is false");
        assert!(at[0].contains(2.0) && why == "a root");
    }
}
