//! Sections 3.2 and 3.3: amorphous samples.

mod harmony;

use super::experiment::{Pull, Relaxed, elasticity, relax, strength};
use super::lattice::range;
use super::{PATCH_DENSITY, patch_material};
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::initial::Sizes;
use crate::observe::patch::Elasticity;
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use crate::spec::wear::Material;
use crate::spec::wear::eq18_critical_diameter::critical_diameter;
use crate::spec::wear::eq20_matched_strength::matched_strength;
use rayon::prelude::*;

/// The results of one sample; sizes in critical diameters, no elastic constants if it failed under the compression of 0.01.
struct Shown {
    size: f64,
    s: f64,
    /// Results under the law of the paper, and under the law of the authors' program, which resets stretched springs.
    forgetful: bool,
    relaxed: Relaxed,
    elastic: Option<Elasticity>,
    tensile: f64,
    shear: f64,
}

fn d_c() -> f64 {
    critical_diameter(1.5, 1.0, 0.2)
}

/// The target of Eq. 20 for the most frequent pair.
fn target(strength: f64, size: f64, s: f64) -> f64 {
    let r = 0.5 * size * d_c();
    matched_strength(strength, r, r, d_c(), s)
}

/// Volume fraction, elastic constants and strengths of Figs. 7, 8, A.6 to A.9.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let extent = setting.extent;
    let note = extent.of("samples of 20 d_0 instead of 100 d_0, five of the eight diameters", "").to_string();
    let mut chapter = Evidence { note, ..Evidence::default() };
    let sizes: &[f64] = extent.of(&[0.6, 1.2, 4.8, 19.2, 38.4], &[0.6, 1.2, 2.4, 4.8, 9.6, 19.2, 38.4, 76.8]);
    let cases: Vec<(f64, f64)> = [0.0, 0.5]
        .into_iter()
        .flat_map(|s| sizes.iter().map(move |&size| (size, s)))
        .filter(|&(size, s)| size > 1.0 || s == 0.0)
        .collect();
    let shown: Vec<[Shown; 2]> =
        cases.par_iter().map(|&(size, s)| show(size, s, setting)).collect::<Result<_, Error>>()?;
    let shown: Vec<Shown> = shown.into_iter().flatten().collect();
    claims(&shown, &mut chapter);
    figures(&shown, &mut chapter);
    harmony::harmony(setting, &mut chapter)?;
    Ok(chapter)
}

/// One sample, tested with and without the reset of springs, which does not matter during the relaxation.
fn show(size: f64, s: f64, setting: &Setting) -> Result<[Shown; 2], Error> {
    let (d, side, steps) = (size * d_c(), setting.extent.of(20.0, 100.0), setting.extent.of(20_000, 200_000));
    let material = patch_material(0.15, s);
    let relaxed =
        relax(Sizes::around(d), [side * d, side * d, 3.0 * d], &material, PATCH_DENSITY, 1, setting.interrupt)?;
    let test = |forgetful| {
        let material = Material { forget_stretched_springs: forgetful, ..material };
        let elastic = elasticity(&relaxed.system, d, &material, steps, setting.interrupt)?;
        let tensile = strength(&relaxed.system, d, &material, Pull::Tension, 0.5, setting.interrupt)?.peak;
        let shear = strength(&relaxed.system, d, &material, Pull::Shear, 0.5, setting.interrupt)?.peak;
        Ok::<_, Error>(Shown { size, s, forgetful, relaxed: relaxed.clone(), elastic, tensile, shear })
    };
    Ok([test(false)?, test(true)?])
}

/// The two readings, in words.
fn reading(forgetful: bool) -> &'static str {
    if forgetful { "stretched springs reset, as in the authors' program" } else { "springs kept" }
}

fn claims(shown: &[Shown], chapter: &mut Evidence) {
    let of = |s: f64| shown.iter().filter(move |x| x.s == s && !x.forgetful);
    let beyond = |s: f64| of(s).filter(|x| x.size > 1.0);
    let fractions = |s: f64| beyond(s).map(|x| x.relaxed.volume_fraction).collect::<Vec<_>>();
    let (low, high) = range(fractions(0.0));
    chapter.claims.push(Claim::new(
        "Fig. 7",
        "relaxed volume fraction at s = 0 is independent of d_0 above d_c (within 0.01)",
        "constant",
        format!("{low:.3} to {high:.3}"),
        high - low < 0.01,
    ));
    let falling = fractions(0.5);
    chapter.claims.push(Claim::new(
        "Fig. 7",
        "relaxed volume fraction at s = 1/2 decreases with d_0",
        "falling",
        falling.iter().map(|f| format!("{f:.3}")).collect::<Vec<_>>().join(", "),
        falling.windows(2).all(|pair| pair[1] < pair[0]),
    ));
    let (least, most) = range(shown.iter().map(|x| x.relaxed.steps as f64).collect());
    let worst = range(shown.iter().map(|x| x.relaxed.residual).collect()).1;
    chapter.claims.push(Claim::new(
        "Section 3.2",
        "all stresses below 1e-14 E after about 20 000 steps (within a factor of two)",
        "20 000",
        format!("{least} to {most}, residual {worst:.1e} E"),
        worst < 1e-14 && least > 10_000.0 && most < 40_000.0,
    ));
    for forgetful in [false, true] {
        let read = shown.iter().filter(|x| x.forgetful == forgetful);
        let (low, high) = range(read.filter_map(|x| Some(x.elastic?.poisson_ratio)).collect());
        chapter.claims.push(Claim::new(
            "Fig. A.6",
            format!("Poisson's ratio, target 0.15, within 0.02 of the paper's; {}", reading(forgetful)),
            "0.20",
            format!("{low:.3} to {high:.3}"),
            low > 0.18 && high < 0.22,
        ));
    }
    let moduli: Vec<f64> = of(0.5).filter_map(|x| Some(x.elastic?.young_modulus)).collect();
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "Young's modulus at s = 1/2 decreases with d_0, as the volume fraction does",
        "falling",
        moduli.iter().map(|e| format!("{e:.3}")).collect::<Vec<_>>().join(", "),
        moduli.windows(2).all(|pair| pair[1] < pair[0]),
    ));
    let weak: Vec<&Shown> = of(0.5).filter(|x| x.size > 20.0).collect();
    let within: Vec<&Shown> = of(0.0).chain(of(0.5).filter(|x| x.size < 20.0)).collect();
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "a sample fails under a compression of 0.01 if and only if s = 1/2 and d_0 > 20 d_c",
        "fails",
        format!(
            "{} of {} above, {} of {} others",
            weak.iter().filter(|x| x.elastic.is_none()).count(),
            weak.len(),
            within.iter().filter(|x| x.elastic.is_none()).count(),
            within.len()
        ),
        weak.iter().all(|x| x.elastic.is_none()) && within.iter().all(|x| x.elastic.is_some()),
    ));
    for (figure, name, paper, full, peak) in [
        ("Fig. A.7", "tensile", 0.50, 0.2, (|x| x.tensile) as fn(&Shown) -> f64),
        ("Fig. A.8", "shear", 0.56, 0.1, |x| x.shear),
    ] {
        for (forgetful, s) in [(false, 0.0), (true, 0.0), (false, 0.5), (true, 0.5)] {
            let read = shown.iter().filter(|x| x.s == s && x.forgetful == forgetful);
            let (low, high) = range(read.map(|x| peak(x) / target(full, x.size, s)).collect());
            chapter.claims.push(Claim::new(
                figure,
                format!("{name} strength at s = {s} relative to its target, within 0.05; {}", reading(forgetful)),
                format!("{paper:.2}"),
                format!("{low:.2} to {high:.2}"),
                low > paper - 0.05 && high < paper + 0.05,
            ));
        }
    }
}

fn figures(shown: &[Shown], chapter: &mut Evidence) {
    type Measure = fn(&Shown) -> Option<f64>;
    let measures: [(&str, &str, bool, Measure); 5] = [
        ("amorphous-fraction", "volume fraction (Fig. 7)", false, |x| Some(x.relaxed.volume_fraction)),
        ("amorphous-young", "E (Fig. 8)", false, |x| Some(x.elastic?.young_modulus)),
        ("amorphous-poisson", "nu (Fig. A.6)", false, |x| Some(x.elastic?.poisson_ratio)),
        ("amorphous-tensile", "tensile strength / E (Fig. A.7)", true, |x| Some(x.tensile)),
        ("amorphous-shear", "shear strength / E (Fig. A.8)", true, |x| Some(x.shear)),
    ];
    for (name, label, log, measure) in measures {
        let kept = |s: f64| shown.iter().filter(move |x| x.s == s && !x.forgetful);
        let points = |s: f64| kept(s).filter_map(|x| Some((x.size, measure(x)?))).collect();
        let curves = [0.0, 0.5].map(|s| Curve::new(format!("s = {s}"), Mark::Dots, points(s))).into();
        let caption = format!("amorphous samples: {label} against d_0 / d_c");
        let y = Axis { log, ..Axis::linear(label) };
        let plot = Plot { title: caption.clone(), x: Axis::log("d_0 / d_c"), y, curves };
        chapter.figures.push(Figure { name: name.into(), caption, svg: plot.svg() });
    }
}
