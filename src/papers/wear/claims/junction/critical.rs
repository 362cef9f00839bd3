//! The diameter above which junctions roll, by their fates in steps of the diameter and for several samples.

use super::{LOAD, sample, shear};
use crate::error::Error;
use crate::observe::statistics::Mean;
use crate::papers::wear::fate::Fate;
use crate::reproduce::{Claim, Setting};
use rayon::prelude::*;

/// Diameter of the spheres, nm: the coarsest of the paper, which takes seconds.
const D_0: f64 = 6.0;
/// The smallest diameter of a junction, the step, and their number: the largest junctions are three quarters of the box wide.
const STEPS: (f64, f64, usize) = (10.0, 4.0, 6);

/// The diameter that half of the junctions exceed which roll, of one sample: every junction that does not roll adds a step to the smallest
/// diameter (Spearman and Kärber).
fn threshold(rolls: &[bool]) -> f64 {
    let (least, step, _) = STEPS;
    least + step * (rolls.iter().filter(|rolls| !**rolls).count() as f64 - 0.5)
}

/// The claim, from samples with different seeds.
///
/// # Errors
///
/// If a run halts or is interrupted.
pub(super) fn claim(setting: &Setting) -> Result<Claim, Error> {
    let (least, step, number) = STEPS;
    let seeds: Vec<u64> = (1..=setting.extent.of(3, 12)).collect();
    let diameters: Vec<f64> = (0..number).map(|k| least + step * k as f64).collect();
    let fates = |seed: &u64| {
        let relaxed = sample(D_0, *seed, setting.interrupt)?;
        let fate = |diameter: &f64| Ok(shear(&relaxed, D_0, *seed, *diameter, LOAD, setting.interrupt)?.fate);
        diameters.par_iter().map(fate).collect::<Result<Vec<Fate>, Error>>()
    };
    let found: Vec<Vec<bool>> = seeds
        .par_iter()
        .map(|seed| Ok(fates(seed)?.into_iter().map(|fate| fate == Fate::Rolls).collect()))
        .collect::<Result<_, Error>>()?;
    let critical = Mean::of(&found.iter().map(|rolls| threshold(rolls)).collect::<Vec<_>>());
    let share = |k: usize| found.iter().filter(|rolls| rolls[k]).count();
    let listed: Vec<String> = diameters.iter().enumerate().map(|(k, d)| format!("{} at {d} nm", share(k))).collect();
    let (low, high) = (critical.value - critical.margin, critical.value + critical.margin);
    Ok(Claim::new(
        "Section 4",
        format!("critical diameter at d_0 = {D_0} nm: the whole confidence interval lies between 10 and 20 nm"),
        "10 nm < d* < 20 nm; 18 nm by Eq. 22",
        format!("{critical:.1} nm; of {} samples roll {}", seeds.len(), listed.join(", ")),
        low > 10.0 && high < 20.0,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_threshold_lies_half_a_step_below_the_first_that_rolls() {
        assert_eq!(threshold(&[false, false, true, true, true, true]), 16.0);
        assert_eq!(threshold(&[true; 6]), 8.0);
        assert_eq!(threshold(&[false; 6]), 32.0);
    }
}
