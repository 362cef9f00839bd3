//! Section 3.2: restructuring of coated aggregates.

use super::ensemble::{COARSE, Ensemble, Kind, LOOK, Protocol, ensembles, settled, terminal};
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::observe::statistics::Mean;
use crate::papers::soot::case::Torsion;
use crate::reproduce::{Claim, Evidence, Extent, Figure, Setting, near};

/// The reduced protocol.
const REDUCED: Protocol = Protocol { aggregates: 4, keys: COARSE };
/// The paper's ensembles, with necks of set P, which its runs most probably have.
const FULL: Protocol = Protocol { aggregates: 50, keys: &[] };

/// Coordination numbers and convexities of Fig. 8.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let protocol = setting.extent.of(REDUCED, FULL);
    let fractions: &[f64] = setting.extent.of(&[0.0, 0.5, 0.9, 1.0], &[0.0, 0.25, 0.5, 0.75, 0.9, 1.0]);
    let sprung = fractions.iter().map(|&neck_fraction| Kind { neck_fraction, torsion: Torsion::Spring });
    let others = [Torsion::AsPrinted, Torsion::AsPublished].map(|torsion| Kind { neck_fraction: 1.0, torsion });
    let found = ensembles(&protocol, &sprung.chain(others).collect::<Vec<_>>(), setting)?;
    let members = found[0].members;
    let note = match setting.extent {
        Extent::Reduced => {
            "4 aggregates for each of 4 neck fractions instead of 50 for each of 6, with necks of set S at 40 fs; the \
                            paper's runs most probably have those of set P at 5 fs"
                .into()
        }
        Extent::Full if members < 50 => {
            format!("{members} of 50 aggregates have finished; the same command resumes the others")
        }
        Extent::Full => String::new(),
    };
    Ok(Evidence { note, claims: claims(&found), figures: figures(&found) })
}

/// The name of an ensemble.
fn name(kind: Kind) -> String {
    let torsion = match kind.torsion {
        Torsion::Spring => "",
        Torsion::AsPrinted => ", torsion as printed",
        Torsion::AsPublished => ", as in the program",
    };
    format!("{:.0} % necks{torsion}", 100.0 * kind.neck_fraction)
}

fn claims(found: &[Ensemble]) -> Vec<Claim> {
    let sprung: Vec<&Ensemble> = found.iter().filter(|ensemble| ensemble.kind.torsion == Torsion::Spring).collect();
    let breaking: Vec<&Ensemble> =
        sprung.iter().copied().filter(|ensemble| ensemble.kind.neck_fraction < 1.0).collect();
    let listed = |ensembles: &[&Ensemble], of: &dyn Fn(&Ensemble) -> String| {
        ensembles.iter().map(|ensemble| of(ensemble)).collect::<Vec<_>>().join(", ")
    };
    let end = |ensemble: &Ensemble| terminal(&ensemble.coordination);
    let loose = end(sprung[0]);
    let highest = found.iter().map(|ensemble| end(ensemble).value).fold(0.0, f64::max);
    let [fresh, coated] = sprung[0].dimension;
    let times = |ensemble: &Ensemble| (settled(&ensemble.coordination), settled(&ensemble.convexity));
    let (local, global) = times(sprung[0]);
    let spread = |mean: Mean| mean.margin / mean.value;
    let spreads = |ensemble: &Ensemble| (spread(end(ensemble)), spread(terminal(&ensemble.convexity)));
    let mut claims = vec![
        Claim::new(
            "Section 3.2",
            "terminal coordination number without necks, within the confidence interval or 10 %",
            "4.48",
            format!("{loose}"),
            loose.covers(4.48) || near(loose.value, 4.48, 0.1),
        ),
        Claim::new(
            "Fig. 8b",
            "the terminal coordination number decreases with the fraction of necks; confidence intervals do not overlap",
            "falling",
            listed(&sprung, &|ensemble| format!("{}", end(ensemble))),
            sprung.windows(2).all(|pair| {
                let (less, more) = (end(pair[0]), end(pair[1]));
                more.value + more.margin < less.value - less.margin
            }),
        ),
        Claim::new(
            "Fig. 8b",
            "it stays below the coordination number of jammed frictionless spheres",
            "below 6",
            format!("at most {highest:.2}"),
            highest < 6.0,
        ),
        Claim::new(
            "Section 3.2",
            "without necks restructuring ends within tens of nanoseconds: 95 % of both increases after 10 to 50 ns",
            "tens of ns",
            format!("coordination {local} ns, convexity {global} ns"),
            local.max(global) >= 10.0 && local.max(global) < 50.0,
        ),
        Claim::new(
            "Section 2.1.6",
            "the fractal dimension increases under the coating (confidence intervals do not overlap), without necks to that of thickly coated soot, within the confidence interval or 5 %",
            "1.8, towards 2.2",
            format!("{fresh} to {coated}"),
            fresh.value + fresh.margin < coated.value - coated.margin
                && (coated.covers(2.2) || near(coated.value, 2.2, 0.05)),
        ),
        Claim::new(
            "Fig. 8a, c",
            "the coordination number settles before the convexity, unless all contacts are necks",
            "earlier",
            listed(&breaking, &|ensemble| {
                let (local, global) = times(ensemble);
                format!("{}: {local} and {global} ns", name(ensemble.kind))
            }),
            breaking.iter().all(|ensemble| times(ensemble).0 < times(ensemble).1),
        ),
        Claim::new(
            "Fig. 8b, d",
            "the convexity varies more between aggregates: confidence intervals relative to the means",
            "more",
            listed(&breaking, &|ensemble| {
                let (local, global) = spreads(ensemble);
                format!("{}: {:.0} and {:.0} %", name(ensemble.kind), 100.0 * local, 100.0 * global)
            }),
            breaking.iter().all(|ensemble| spreads(ensemble).0 < spreads(ensemble).1),
        ),
    ];
    for ensemble in found.iter().filter(|ensemble| ensemble.kind.neck_fraction == 1.0) {
        let Mean { value, margin } = ensemble.rise;
        let torsion = match ensemble.kind.torsion {
            Torsion::Spring => "torsion springs along the normal",
            Torsion::AsPrinted => "torsion springs rotated into the contact plane, as printed",
            Torsion::AsPublished => {
                "torsion springs as printed, and all springs lag by one step, as in the authors' program"
            }
        };
        claims.push(Claim::new(
            "Section 3.2",
            format!("the coordination number increases by less than 10 % if all contacts are necks (whole confidence interval); {torsion}"),
            "below 10 %",
            format!("{:.1} ± {:.1} % to {}", 100.0 * value, 100.0 * margin, end(ensemble)),
            value - margin > 0.0 && value + margin < 0.1,
        ));
    }
    claims
}

fn figures(found: &[Ensemble]) -> Vec<Figure> {
    type Measure = fn(&Ensemble) -> &[Mean];
    let measures: [(&str, &str, &str, &str, Measure); 2] = [
        ("coordination", "coordination number", "Fig. 8a", "Fig. 8b", |ensemble| &ensemble.coordination),
        ("convexity", "convexity", "Fig. 8c", "Fig. 8d", |ensemble| &ensemble.convexity),
    ];
    let draw = |name: String, caption: String, x: &str, y: &str, curves: Vec<Curve>| {
        let plot = Plot { title: caption.clone(), x: Axis::linear(x), y: Axis::linear(y), curves };
        let caption = format!("{caption}; shaded: 95 % confidence interval of the mean");
        Figure { name, caption, svg: plot.svg() }
    };
    let mut figures = Vec::new();
    for (file, label, course, ends, measure) in measures {
        let curves = found.iter().flat_map(|ensemble| {
            let points: Vec<_> = measure(ensemble)
                .iter()
                .enumerate()
                .map(|(look, mean)| (look as f64 * LOOK, mean.value, mean.margin))
                .collect();
            banded(name(ensemble.kind), Mark::Line, &points)
        });
        let caption = format!("{label} of restructuring aggregates ({course})");
        figures.push(draw(format!("soot-{file}"), caption, "time [ns]", label, curves.collect()));

        let of = |torsion, label: &str| {
            let points: Vec<_> = found
                .iter()
                .filter(|ensemble| ensemble.kind.torsion == torsion)
                .map(|ensemble| (ensemble.kind.neck_fraction, terminal(measure(ensemble))))
                .map(|(fraction, mean)| (fraction, mean.value, mean.margin))
                .collect();
            banded(label.into(), Mark::Dots, &points)
        };
        let curves = [
            (Torsion::Spring, "torsion springs along the normal"),
            (Torsion::AsPrinted, "as printed"),
            (Torsion::AsPublished, "as in the program"),
        ];
        let curves = curves.into_iter().flat_map(|(torsion, label)| of(torsion, label)).collect();
        let caption = format!("terminal {label} against the fraction of necks ({ends})");
        figures.push(draw(format!("soot-terminal-{file}"), caption, "neck fraction", label, curves));
    }
    figures
}

/// A curve of means with a band of their confidence intervals.
fn banded(label: String, mark: Mark, points: &[(f64, f64, f64)]) -> Vec<Curve> {
    vec![Curve::band(points), Curve::new(label, mark, points.iter().map(|&(x, y, _)| (x, y)).collect())]
}
