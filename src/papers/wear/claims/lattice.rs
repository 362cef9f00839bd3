//! Section 3.1: hexagonal close-packed lattices.

use super::experiment::{Pull, Strength, elasticity, strength};
use super::{PATCH_DENSITY, patch_material};
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::initial::hcp;
use crate::initial::lattice::hcp_cells;
use crate::observe::patch::Elasticity;
use crate::reproduce::{Claim, Evidence, Extent, Figure, Setting, log_slope, near};
use crate::spec::wear::eq18_critical_diameter::critical_diameter;
use crate::spec::wear::eq20_matched_strength::matched_strength;
use crate::system::System;
use rayon::prelude::*;

/// Poisson's ratios in the elastic tests.
const RATIOS: [f64; 6] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.25];
/// Number of steps for which the samples are relaxed under the load: the slowest wave has then decayed by more than six orders of magnitude.
const STEPS: u64 = 20_000;

fn d_c() -> f64 {
    critical_diameter(1.5, 1.0, 0.2)
}

/// A patch of the given diameter in critical diameters.
fn patch(size: f64, extent: Extent) -> System {
    let d = size * d_c();
    let side = extent.of(12.0, 25.0) * d;
    hcp(d, hcp_cells(d, [side, side, 3.0 * d]), PATCH_DENSITY)
}

/// One strength test: Poisson's ratio, scaling, diameter in critical diameters, direction, result.
type Test = (f64, f64, f64, Pull, Strength);

/// The elastic constants and strengths of Figs. 5, 6, A.4, A.5.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let extent = setting.extent;
    let note = extent.of("lattices of 12 d_0 instead of 25 d_0, five of the eight diameters", "").to_string();
    let mut chapter = Evidence { note, ..Evidence::default() };
    elastic(setting, &mut chapter)?;
    strengths(setting, &mut chapter)?;
    Ok(chapter)
}

fn elastic(setting: &Setting, chapter: &mut Evidence) -> Result<(), Error> {
    let mut cases: Vec<(f64, f64)> = RATIOS.iter().map(|&nu| (nu, 1.2)).collect();
    cases.extend([(0.25, 0.6), (0.25, 19.2)]);
    let measure = |&(nu, size): &(f64, f64)| {
        let measured =
            elasticity(&patch(size, setting.extent), size * d_c(), &patch_material(nu, 0.5), STEPS, setting.interrupt)?;
        Ok(measured.map(|e| (nu, e)))
    };
    let measured: Vec<Option<(f64, Elasticity)>> = cases.par_iter().map(measure).collect::<Result<_, Error>>()?;
    let measured: Vec<(f64, Elasticity)> = measured.into_iter().flatten().collect();
    let curve = &measured[..RATIOS.len().min(measured.len())];
    let (_, zero) = curve[0];
    let (_, last) = curve[curve.len() - 1];
    let stiffest = curve.iter().map(|(_, e)| (e.young_modulus - 1.0).abs()).fold(0.0, f64::max);
    let widest =
        curve.iter().filter(|(nu, _)| *nu > 0.0).map(|(nu, e)| (e.poisson_ratio / nu - 1.0).abs()).fold(0.0, f64::max);
    let percent = |x: f64| format!("{:+.1} %", 100.0 * x);
    chapter.claims.extend([
        Claim::new(
            "Fig. A.4, A.5",
            "lattice at nu = 0: E and nu equal their targets up to second order in the load of 0.01",
            "E 1, nu 0",
            format!("E {:.5}, nu {:.5}", zero.young_modulus, zero.poisson_ratio),
            near(zero.young_modulus, 1.0, 2e-3) && zero.poisson_ratio.abs() < 2e-3,
        ),
        Claim::new(
            "Fig. A.4, A.5",
            "largest deviation of E and nu from their targets, up to nu = 1/4",
            "12 %",
            format!("E {:.1} %, nu {:.1} %", 100.0 * stiffest, 100.0 * widest),
            stiffest <= 0.125 && widest <= 0.125,
        ),
        Claim::new(
            "infinite lattice",
            "E and nu at nu = 1/4 and a load of 0.01, within 1.5 percentage points of the exact result for an infinite lattice",
            "E -5.5 %, nu +11.3 %",
            format!("E {}, nu {}", percent(last.young_modulus - 1.0), percent(last.poisson_ratio / 0.25 - 1.0)),
            (last.young_modulus - 0.945).abs() < 0.015 && (last.poisson_ratio / 0.25 - 1.113).abs() < 0.015,
        ),
    ]);
    let sizes: Vec<f64> = measured.iter().filter(|(nu, _)| *nu == 0.25).map(|(_, e)| e.young_modulus).collect();
    let (low, high) = sizes.iter().fold((f64::INFINITY, 0.0f64), |(low, high), &e| (low.min(e), high.max(e)));
    chapter.claims.push(Claim::new(
        "Section 3.1",
        "E is independent of the particle size (d_0 from 0.6 to 19.2 d_c, nu = 1/4, within 0.1 %)",
        "none",
        format!("E from {low:.5} to {high:.5}"),
        sizes.len() == 3 && high / low < 1.001,
    ));
    let points = |f: &dyn Fn(&Elasticity) -> f64| curve.iter().map(|(nu, e)| (*nu, f(e))).collect::<Vec<_>>();
    let target =
        |f: &dyn Fn(f64) -> f64| Curve::new("target", Mark::Guide, RATIOS.iter().map(|&nu| (nu, f(nu))).collect());
    for (name, label, curves) in [
        (
            "lattice-young",
            "E",
            vec![Curve::new("measured", Mark::Dots, points(&|e| e.young_modulus)), target(&|_| 1.0)],
        ),
        (
            "lattice-poisson",
            "nu",
            vec![Curve::new("measured", Mark::Dots, points(&|e| e.poisson_ratio)), target(&|nu| nu)],
        ),
    ] {
        let caption = format!("{label} of the lattice against the target nu (Figs. A.4, A.5)");
        let plot = Plot { title: caption.clone(), x: Axis::linear("target nu"), y: Axis::linear(label), curves };
        chapter.figures.push(Figure { name: name.into(), caption, svg: plot.svg() });
    }
    Ok(())
}

fn strengths(setting: &Setting, chapter: &mut Evidence) -> Result<(), Error> {
    let ratios: &[f64] = setting.extent.of(&[0.0, 0.15, 0.25], &RATIOS);
    let sizes: &[f64] = setting.extent.of(&[0.6, 1.2, 4.8, 19.2, 76.8], &[0.6, 1.2, 2.4, 4.8, 9.6, 19.2, 38.4, 76.8]);
    let mut cases = Vec::new();
    for pull in [Pull::Tension, Pull::Shear] {
        for s in [0.0, 0.5] {
            for &nu in ratios {
                cases.extend(sizes.iter().map(|&size| (nu, s, size, pull)));
            }
        }
    }
    let test = |&(nu, s, size, pull): &(f64, f64, f64, Pull)| {
        let result =
            strength(&patch(size, setting.extent), size * d_c(), &patch_material(nu, s), pull, 0.5, setting.interrupt)?;
        Ok((nu, s, size, pull, result))
    };
    let tests: Vec<Test> = cases.par_iter().map(test).collect::<Result<_, Error>>()?;
    let target = |pull, s, size: f64| {
        let r = 0.5 * size * d_c();
        matched_strength(if pull == Pull::Tension { 0.2 } else { 0.1 }, r, r, d_c(), s)
    };
    for (pull, name, figure) in [(Pull::Tension, "tensile", "Fig. 5"), (Pull::Shear, "shear", "Fig. 6")] {
        let peaks = |nu: f64, s: f64| -> Vec<(f64, f64)> {
            let chosen = tests.iter().filter(|t| t.0 == nu && t.1 == s && t.3 == pull);
            chosen.map(|t| (t.2, t.4.peak)).collect()
        };
        let ratio = |nu: f64, s: f64| -> Vec<f64> {
            peaks(nu, s).iter().map(|&(size, peak)| peak / target(pull, s, size)).collect()
        };
        let (least, most) = range([ratio(0.0, 0.0), ratio(0.0, 0.5)].concat());
        chapter.claims.push(Claim::new(
            figure,
            format!("{name} strength of the lattice equals the target at nu = 0, within 10 %"),
            "1",
            format!("{least:.2} to {most:.2} of the target"),
            least > 0.9 && most < 1.1,
        ));
        for (s, slope) in [(0.0, 0.0), (0.5, -0.5)] {
            let found: Vec<f64> = ratios
                .iter()
                .map(|&nu| log_slope(&peaks(nu, s).into_iter().filter(|p| p.0 > 1.0).collect::<Vec<_>>()))
                .collect();
            let (low, high) = range(found);
            chapter.claims.push(Claim::new(
                figure,
                format!("slope of log {name} strength against log d_0 above d_c at s = {s}, within 0.1"),
                format!("{slope}"),
                format!("{low:.2} to {high:.2}"),
                (low - slope).abs() < 0.1 && (high - slope).abs() < 0.1,
            ));
        }
        // Below the critical diameter the paper finds the shear strength below its target: the next claim.
        let first = usize::from(pull == Pull::Shear);
        let scaled = ratios.iter().filter(|nu| **nu > 0.0).flat_map(|&nu| [ratio(nu, 0.0), ratio(nu, 0.5)]);
        let (low, high) = range(scaled.flat_map(|over| over[first..].to_vec()).collect());
        chapter.claims.push(Claim::new(
            figure,
            format!(
                "{name} strength of the lattice exceeds the target for nu > 0, for d_0 of {} d_c and more",
                sizes[first]
            ),
            "above",
            format!("{low:.2} to {high:.2} of the target"),
            low > 1.0,
        ));
        if pull == Pull::Shear {
            let small = ratios.iter().filter(|nu| **nu > 0.0).map(|&nu| ratio(nu, 0.0)[0]);
            let (low, high) = range(small.collect());
            chapter.claims.push(Claim::new(
                figure,
                "shear strength below the target for d_0 < d_c (0.6 d_c, nu > 0)",
                "below",
                format!("{low:.2} to {high:.2} of the target"),
                high < 1.0,
            ));
        }
        let mut curves = Vec::new();
        for s in [0.0, 0.5] {
            for &nu in ratios {
                curves.push(Curve::new(format!("nu {nu}, s {s}"), Mark::Dots, peaks(nu, s)));
            }
            curves.push(Curve::new("", Mark::Guide, sizes.iter().map(|&size| (size, target(pull, s, size))).collect()));
        }
        let caption = format!("{name} strength of the lattice against d_0 / d_c ({figure}); grey: target");
        let plot = Plot { title: caption.clone(), x: Axis::log("d_0 / d_c"), y: Axis::log("strength / E"), curves };
        chapter.figures.push(Figure { name: format!("lattice-{name}"), caption, svg: plot.svg() });
        let shown = tests.iter().filter(|t| t.1 == 0.5 && t.3 == pull && (t.2 == 1.2 || t.2 == 19.2));
        let curves =
            shown.map(|t| Curve::new(format!("nu {}, {} d_c", t.0, t.2), Mark::Line, t.4.curve.clone())).collect();
        let caption = format!("stress against strain in {name} tests of the lattice, s = 0.5");
        let plot = Plot { title: caption.clone(), x: Axis::linear("strain"), y: Axis::linear("stress / E"), curves };
        chapter.figures.push(Figure { name: format!("lattice-{name}-curves"), caption, svg: plot.svg() });
    }
    Ok(())
}

/// The smallest and the largest.
pub(super) fn range(values: Vec<f64>) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)))
}
