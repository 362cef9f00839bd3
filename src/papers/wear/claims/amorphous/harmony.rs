//! Section 3.3, Fig. A.9: the same large spheres in every discretisation.

use super::super::experiment::{Pull, relax, strength};
use super::super::{PATCH_DENSITY, patch_material};
use super::d_c;
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::initial::Sizes;
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use rayon::prelude::*;

/// The finest diameters of the eight lengths, in critical diameters; each is of a hundredth of its length.
const FINEST: [f64; 8] = [0.6, 1.2, 2.4, 4.8, 9.6, 19.2, 38.4, 76.8];
/// The largest diameter of a sample relative to its coarsest.
const LARGEST: f64 = 1.25;

/// Tensile strengths of one length: coarse, fine with largest spheres in proportion, fine with the largest spheres of the coarse sample.
struct Length {
    /// In critical diameters.
    length: f64,
    strengths: [f64; 3],
}

impl Length {
    /// Changes of the strength from coarse to fine, with largest spheres in proportion and with constant ones.
    fn changes(&self) -> [f64; 2] {
        let [coarse, varying, constant] = self.strengths;
        [varying / coarse - 1.0, constant / coarse - 1.0]
    }
}

/// The strengths of eight lengths, each in two discretisations.
///
/// # Errors
///
/// If a sample does not relax, or a run halts or is interrupted.
pub(super) fn harmony(setting: &Setting, chapter: &mut Evidence) -> Result<(), Error> {
    // Numbers of the most frequent spheres along a side.
    let (coarse, fine) = setting.extent.of((12.0, 24.0), (25.0, 100.0));
    let material = patch_material(0.15, 0.5);
    let tensile = |&(length, n, d_l): &(f64, f64, f64)| {
        let d_0 = length / n;
        let sizes = Sizes { d_0, d_s: 0.75 * d_0, d_l };
        let sample =
            relax(sizes, [length, length, 3.0 * d_0.max(d_l)], &material, PATCH_DENSITY, 1, setting.interrupt)?.system;
        Ok(strength(&sample, d_0, &material, Pull::Tension, 0.5, setting.interrupt)?.peak)
    };
    let lengths = FINEST.map(|finest| fine * finest);
    let samples: Vec<(f64, f64, f64)> = lengths
        .iter()
        .map(|length| length * d_c())
        .flat_map(|length| {
            let [largest, proportional] = [coarse, fine].map(|n| LARGEST * length / n);
            [(length, coarse, largest), (length, fine, proportional), (length, fine, largest)]
        })
        .collect();
    let found: Vec<f64> = samples.par_iter().map(tensile).collect::<Result<_, Error>>()?;
    let found: Vec<Length> = lengths
        .into_iter()
        .zip(found.chunks(3))
        .map(|(length, strengths)| Length { length, strengths: [strengths[0], strengths[1], strengths[2]] })
        .collect();
    let halved = |length: &&Length| length.changes()[1].abs() < 0.5 * length.changes()[0].abs();
    let count = found.iter().filter(halved).count();
    let shown = |Length { length, .. }: &Length, [varying, constant]: [f64; 2]| {
        format!("{length:.0} d_c: {:+.0} instead of {:+.0} %", 100.0 * constant, 100.0 * varying)
    };
    let listed: Vec<String> = found.iter().map(|length| shown(length, length.changes())).collect();
    chapter.claims.push(Claim::new(
        "Fig. A.9",
        format!("tensile strength of eight lengths L, d_0 from L/{coarse} to L/{fine}: the change at constant d_l is less than half the change at d_l = 1.25 d_0"),
        "roughly equal, for all",
        format!("{count} of {}; {}", found.len(), listed.join(", ")),
        count == found.len(),
    ));
    let curve = |label: &str, k: usize| {
        let points = found.iter().map(|length| (length.length, length.strengths[k])).collect();
        Curve::new(label, Mark::Dots, points)
    };
    let curves = vec![
        curve("coarse", 0),
        curve("fine, largest spheres in proportion", 1),
        curve("fine, largest spheres of the coarse sample", 2),
    ];
    let caption = "tensile strength / E of samples in two discretisations against their length (Fig. A.9)".to_string();
    let (x, y) = (Axis::log("L / d_c"), Axis::log("tensile strength / E"));
    let plot = Plot { title: caption.clone(), x, y, curves };
    chapter.figures.push(Figure { name: "amorphous-lengths".into(), caption, svg: plot.svg() });
    Ok(())
}
