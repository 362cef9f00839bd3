//! The strength of each neck relative to that of the case.

use super::case::{NeckStrengths, NormalStrengths, WeibullStrengths};
use crate::error::Error;
use crate::initial::aggregate::import::read_strengths;
use crate::interrupt::Interrupt;
use crate::random::Stream;
use crate::spec::mechanics::weibull::weibull_quantile;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The ids of two spheres, the lower first.
type Joined = (u32, u32);

/// The strengths of necks relative to that of the case; none where all are alike.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Strengths(BTreeMap<Joined, f64>);

impl Strengths {
    /// The strengths of these necks of an aggregate. What is drawn depends on the seed and on the two spheres alone: neither other necks nor stages change it.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, or lacks a neck; an interruption.
    pub fn of(
        given: Option<&NeckStrengths>,
        seed: u64,
        necks: &[Joined],
        spheres: usize,
        interrupt: &Interrupt,
    ) -> Result<Self, Error> {
        let strength: Box<dyn Fn(Joined) -> Result<f64, Error>> = match given {
            None => return Ok(Self::default()),
            Some(NeckStrengths::File(file)) => {
                let read = read_strengths(file, spheres, interrupt)?;
                Box::new(move |(i, j)| {
                    let known = read.get(&(i as usize, j as usize)).copied();
                    known.ok_or_else(|| Error::input(file, format!("has no strength of the neck of {i} and {j}")))
                })
            }
            Some(drawn) => Box::new(move |neck| Ok(drawn_for(drawn, seed, neck))),
        };
        necks.iter().map(|&neck| Ok((neck, strength(neck)?))).collect::<Result<_, _>>().map(Self)
    }

    /// The strength of a neck, if it has one of its own.
    pub fn own(&self, neck: Joined) -> Option<f64> {
        self.0.get(&neck).copied()
    }

    /// The strengths of all necks.
    pub fn all(&self) -> &BTreeMap<Joined, f64> {
        &self.0
    }

    /// Whether they are strengths of all these necks, or all are alike if they shall be.
    pub fn belong_to(&self, necks: &[Joined], alike: bool) -> bool {
        let sound = self.0.values().all(|factor| *factor > 0.0 && factor.is_finite());
        sound && if alike { self.0.is_empty() } else { necks.iter().all(|neck| self.0.contains_key(neck)) }
    }
}

/// The strength that is drawn for a neck; what is not positive is drawn again.
pub(super) fn drawn_for(given: &NeckStrengths, seed: u64, (i, j): Joined) -> f64 {
    let mut stream = Stream::new(seed, &format!("neck {i} {j}"));
    loop {
        let drawn = match given {
            NeckStrengths::Weibull(WeibullStrengths { scale, shape }) => {
                weibull_quantile(1.0 - stream.uniform(), *scale, *shape)
            }
            NeckStrengths::Normal(NormalStrengths { mean, deviation }) => mean + deviation * stream.normal(),
            NeckStrengths::File(_) => unreachable!("a file is read"),
        };
        if drawn > 0.0 && drawn.is_finite() {
            return drawn;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest difference between the distribution of the strengths of 4000 necks and this one, over what one sample in a thousand exceeds.
    fn difference(given: &NeckStrengths, below: impl Fn(f64) -> f64) -> f64 {
        let necks: Vec<Joined> = (0..4000).map(|i| (i, i + 1)).collect();
        let strengths = Strengths::of(Some(given), 7, &necks, 4001, &Interrupt::default()).expect("nothing is read");
        let mut drawn: Vec<f64> = necks.iter().map(|&neck| strengths.own(neck).expect("a neck")).collect();
        drawn.sort_unstable_by(f64::total_cmp);
        let n = drawn.len() as f64;
        let steps = drawn.iter().enumerate().map(|(k, &x)| {
            let (k, p) = (k as f64, below(x));
            (p - k / n).abs().max((p - (k + 1.0) / n).abs())
        });
        steps.fold(0.0, f64::max) * n.sqrt() / 1.95
    }

    fn weibull(scale: f64, shape: f64) -> NeckStrengths {
        NeckStrengths::Weibull(WeibullStrengths { scale, shape })
    }

    fn normal(mean: f64, deviation: f64) -> NeckStrengths {
        NeckStrengths::Normal(NormalStrengths { mean, deviation })
    }

    #[test]
    fn drawn_strengths_have_the_distribution_of_weibull() {
        for (scale, shape) in [(1.0, 3.0), (2.5, 1.0), (0.7, 12.0)] {
            let below = |x: f64| -libm::expm1(-libm::pow(x / scale, shape));
            let found = difference(&weibull(scale, shape), below);
            assert!(found < 1.0, "{scale} {shape}: {found}");
            // Another modulus is noticed.
            assert!(difference(&weibull(scale, 1.2 * shape), below) > 1.0);
        }
    }

    #[test]
    fn drawn_strengths_have_the_normal_distribution_above_zero() {
        let normal_below = |z: f64| 0.5 * libm::erfc(-z / std::f64::consts::SQRT_2);
        for (mean, deviation) in [(1.0, 0.2), (1.0, 0.8)] {
            let left = normal_below(-mean / deviation);
            let below = |x: f64| (normal_below((x - mean) / deviation) - left) / (1.0 - left);
            let found = difference(&normal(mean, deviation), below);
            assert!(found < 1.0, "{mean} {deviation}: {found}");
            assert!(difference(&normal(mean, 1.2 * deviation), below) > 1.0);
        }
    }

    #[test]
    fn a_neck_has_the_same_strength_whatever_other_necks_there_are() {
        let of = |necks: &[Joined], seed| {
            Strengths::of(Some(&weibull(1.0, 3.0)), seed, necks, 9, &Interrupt::default()).expect("nothing is read")
        };
        let (all, one) = (of(&[(0, 1), (1, 2), (3, 8)], 1), of(&[(3, 8)], 1));
        assert_eq!(all.own((3, 8)), one.own((3, 8)));
        assert_ne!(all.own((0, 1)), all.own((1, 2)));
        assert_ne!(one.own((3, 8)), of(&[(3, 8)], 2).own((3, 8)));
        assert!(one.belong_to(&[(3, 8)], false) && !one.belong_to(&[(3, 8)], true) && !one.belong_to(&[(0, 1)], false));
        assert!(Strengths::default().belong_to(&[(0, 1)], true));
    }
}
