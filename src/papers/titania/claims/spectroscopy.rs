//! Section 3.2 of the titania paper, Figs. 10 and 11: films under the tip of an atomic force microscope.

use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::output::between;
use crate::papers::titania::Spectrum;
use crate::reproduce::{Claim, Evidence, Extent, Figure, Setting};
use crate::run::sweep::Point;
use std::path::Path;

/// The case files: a scaled-down film, and the film of the paper.
const CASES: [(&str, &str); 2] = [
    ("film.yaml", include_str!("../../../../cases/titania/film.yaml")),
    ("film-full.yaml", include_str!("../../../../cases/titania/film-full.yaml")),
];
/// Number of curves in Fig. 10; as many films with different seeds are computed.
const CURVES: u64 = 5;
/// Range of displacement before the last peak of the pulling force that Fig. 11 shows, nm.
const BEFORE: f64 = 40.0;

/// Five force curves; if stopped, those that have finished.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let (file, text) = setting.extent.of(CASES[0], CASES[1]);
    let base = serde_yaml::from_str(text).expect("the case is well formed");
    let point = |seed: u64| {
        Point::new(Path::new(file), &base, &[("seed", &seed.to_string()), ("output.frames", "1 s")], setting.read)
    };
    let runs = setting.run_all(&(1..=CURVES).map(point).collect::<Result<Vec<_>, Error>>()?)?;
    let spectra = runs.folders.iter().flatten().map(Spectrum::read).collect::<Result<Vec<_>, Error>>()?;
    if runs.stopped && spectra.is_empty() {
        return Err(Error::Stopped(None));
    }
    let note = match setting.extent {
        Extent::Reduced => "films of 5,000 particles on 0.5 µm x 0.5 µm instead of 200,000 on 1.58 µm x 1.58 µm, under a tip whose side is \
                            0.25 µm instead of 0.8 µm, with a setpoint in proportion to its area"
            .into(),
        Extent::Full if spectra.len() < CURVES as usize => format!("{} of {CURVES} films have finished", spectra.len()),
        Extent::Full => String::new(),
    };
    let mut chapter = Evidence { note, ..Evidence::default() };
    claims(&mut chapter, &spectra);
    figures(&mut chapter, &spectra);
    Ok(chapter)
}

fn claims(chapter: &mut Evidence, spectra: &[Spectrum]) {
    let list = |numbers: &[f64], digits: usize| {
        numbers.iter().map(|number| format!("{number:.digits$}")).collect::<Vec<_>>().join(", ")
    };
    let last: Vec<f64> = spectra.iter().filter_map(|s| Some(s.last? * 1e-3)).collect();
    chapter.claims.push(Claim::new(
        "Fig. 10",
        "last peak of the pulling force before the tip is free, for each curve",
        "1 to 3 nN",
        format!("{} nN", list(&last, 2)),
        last.len() == spectra.len() && last.iter().all(|peak| (1.0..=3.0).contains(peak)),
    ));
    let largest: Vec<f64> = spectra.iter().map(|s| s.largest * 1e-3).collect();
    let most = largest.iter().copied().fold(0.0, f64::max);
    chapter.claims.push(Claim::new(
        "Fig. 10",
        "largest pulling force on the tip",
        "at most 20 nN, 10 nN in the experiment",
        format!("{} nN", list(&largest, 1)),
        most <= 20.0,
    ));
    let ways: Vec<f64> = spectra.iter().filter_map(|s| Some(s.rupture? * 1e-3)).collect();
    chapter.claims.push(Claim::new(
        "Fig. 10",
        "displacement of the tip until the film ruptures, within a factor of two",
        "about 1 to 2 µm",
        format!("{} µm", list(&ways, 2)),
        ways.len() == spectra.len() && ways.iter().all(|way| (0.5..=4.0).contains(way)),
    ));
    let events = || spectra.iter().flat_map(|s| &s.events);
    let all = ["sliding", "rolling", "detachment"].map(|what| events().filter(|e| e.1.starts_with(what)).count());
    chapter.claims.push(Claim::new(
        "Fig. 11",
        "contacts slide, roll and detach during the retraction of the tip",
        "all three occur",
        format!("{} sliding events, {} rolling events, {} detachments", all[0], all[1], all[2]),
        all.iter().all(|&count| count > 0),
    ));
}

fn figures(chapter: &mut Evidence, spectra: &[Spectrum]) {
    let nano = |curve: &[(f64, f64)]| curve.iter().map(|(z, f)| (*z, f * 1e-3)).collect::<Vec<_>>();
    for (number, spectrum) in (1..).zip(spectra) {
        let curve = |label: &str, points: &[(f64, f64)]| Curve::new(label, Mark::Line, nano(points));
        let plot = Plot {
            title: format!("film {number}"),
            x: Axis::linear("tip displacement [nm]"),
            y: Axis::linear("force on the tip [nN]"),
            curves: vec![curve("approach", &spectrum.approach), curve("retraction", &spectrum.retraction)],
        };
        let caption = format!("Fig. 10: force on the tip during approach to and retraction from film {number}");
        chapter.figures.push(Figure { name: format!("fig-10-film-{number}"), caption, svg: plot.svg() });
    }
    let Some(spectrum) = spectra.iter().find(|s| s.last.is_some()) else { return };
    let (peak, pull) = (spectrum.peak(), nano(&spectrum.retraction));
    let shown = |z: f64| (peak - BEFORE..=peak + BEFORE / 4.0).contains(&z);
    let mut curves = vec![Curve::new("force", Mark::Line, pull.iter().copied().filter(|p| shown(p.0)).collect())];
    for what in ["sliding", "rolling", "detachment"] {
        let events = spectrum.events.iter().filter(|(z, event)| shown(*z) && event.starts_with(what));
        curves.push(Curve::new(
            what,
            Mark::Points,
            events.filter_map(|(z, _)| Some((*z, between(&pull, *z)?))).collect(),
        ));
    }
    let (x, y) = (Axis::linear("tip displacement [nm]"), Axis::linear("force on the tip [nN]"));
    let plot = Plot { title: "before the last peak".into(), x, y, curves };
    let caption = "Fig. 11: contact events before the last peak of the pulling force; the paper's data are known from the figure only";
    chapter.figures.push(Figure { name: "fig-11".into(), caption: caption.into(), svg: plot.svg() });
}
