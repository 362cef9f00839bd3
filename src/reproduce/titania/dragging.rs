//! Figs. 5, 6 and 8 of the titania paper: a particle of 8 nm dragged over a slab, sliding or rolling.

use super::{SIZES, SLAB, paper, settings};
use crate::build::pair::{drag, pair};
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::reproduce::{Chapter, Claim, Figure, near};
use crate::run::rolling_resistance;
use crate::simulation::Simulation;
use crate::spec::titania::Titania;
use crate::system::Halt;
use rayon::prelude::*;

/// How long a particle is pressed on the slab before it is dragged, in steps.
const SETTLING: usize = 6000;
const DT: f64 = 5e-4;
/// How far it rolls, nm.
const ROLLED: f64 = 1.0;

/// A particle pressed on the slab, and about to be dragged.
fn pressed(load: f64, velocity: f64, rolls: bool) -> Result<Simulation<Titania>, Halt> {
    let titania = paper();
    let law: Titania = titania.law();
    let mut system = pair(&titania, [SIZES[0], SLAB], 1, 0.0);
    drag(&mut system, 0.0, load, false);
    let mut simulation = Simulation::new(law, system, settings(DT))?;
    for _ in 0..SETTLING {
        simulation.step()?;
    }
    let mut system = simulation.into_system();
    drag(&mut system, velocity, load, rolls);
    Simulation::new(law, system, settings(DT))
}

fn travel(simulation: &Simulation<Titania>) -> f64 {
    simulation.system().walls[1].travel.0[0]
}

/// Stick and slip of a particle that slides.
struct Slid {
    load: f64,
    velocity: f64,
    /// Mean distance between two slips, nm.
    period: f64,
    /// Mean force at a slip, pN.
    peak: f64,
    /// Mean of shear strength times contact area there, pN.
    strength: f64,
    /// Force against the way, pN and nm.
    curve: Vec<(f64, f64)>,
}

fn slide(load: f64, velocity: f64) -> Result<Slid, Halt> {
    let mut simulation = pressed(load, velocity, false)?;
    let tau_s = simulation.model().tau_s;
    let (mut slips, mut curve): (Vec<[f64; 3]>, _) = (Vec::new(), Vec::new());
    while travel(&simulation) < 1.7 {
        let way = travel(&simulation);
        for pair in simulation.pairs() {
            let force = pair.outcome.wrench.force.0[0].abs();
            curve.push((way, force));
            if pair.outcome.losses.sliding > 0.0 {
                slips.push([way, force, tau_s * Titania::area(&pair.contact)]);
            }
        }
        simulation.step()?;
    }
    let n = slips.len() as f64;
    let mean = |k: usize| slips.iter().map(|slip| slip[k]).sum::<f64>() / n;
    let period = (slips.last().map_or(f64::NAN, |s| s[0]) - slips.first().map_or(f64::NAN, |s| s[0])) / (n - 1.0);
    Ok(Slid { load, velocity, period, peak: mean(1), strength: mean(2), curve })
}

/// What becomes of a particle that is dragged.
pub fn dragging(chapter: &mut Chapter) -> Result<(), Halt> {
    let slid = sliding(chapter)?;
    rolling(chapter, &slid)
}

/// Stick and slip, and Fig. 6. Returns the run under 2 nN at 1 m/s.
fn sliding(chapter: &mut Chapter) -> Result<Slid, Halt> {
    let runs = [(500.0, 1.0), (1000.0, 1.0), (2000.0, 1.0), (4000.0, 1.0), (8000.0, 1.0), (2000.0, 0.25)];
    let mut runs: Vec<Slid> =
        runs.into_par_iter().map(|(load, velocity)| slide(load, velocity)).collect::<Result<_, _>>()?;
    let (loads, slow) = runs.split_at(5);
    let all = |of: fn(&Slid) -> String| runs.iter().map(of).collect::<Vec<_>>().join(", ");
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "stick and slip keeps the period of the law, whatever load (0.5 to 8 nN) and velocity (0.25 and 1 m/s)",
        "about 0.5 nm",
        all(|run| format!("{:.4}", run.period)) + " nm",
        runs.iter().all(|run| near(run.period, 0.5, 0.01)),
    ));
    let (fast, slow) = (&loads[2], &slow[0]);
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "peak friction does not depend on the velocity",
        "negligible influence",
        format!("{:.1} pN at {} m/s, {:.1} pN at {} m/s", fast.peak, fast.velocity, slow.peak, slow.velocity),
        near(fast.peak, slow.peak, 0.01),
    ));
    chapter.claims.push(Claim::new(
        "Eq. 10",
        "peak friction is shear strength times contact area, on a slab that is a sphere of 1 µm",
        "0.65 GPa",
        loads.iter().map(|run| format!("{:.4}", 0.65 * run.peak / run.strength)).collect::<Vec<_>>().join(", ")
            + " GPa",
        loads.iter().all(|run| near(run.peak, run.strength, 0.01)),
    ));
    let ratios: Vec<f64> = loads.iter().map(|run| run.peak / run.load).collect();
    chapter.claims.push(Claim::new(
        "Fig. 6",
        "peak friction over load falls with the load: no law of Amontons",
        "falls",
        loads
            .iter()
            .zip(&ratios)
            .map(|(run, ratio)| format!("{ratio:.2} at {} nN", run.load * 1e-3))
            .collect::<Vec<_>>()
            .join(", "),
        ratios.windows(2).all(|pair| pair[1] < pair[0]) && ratios[0] > 2.0 * ratios[4],
    ));
    let points = loads.iter().map(|run| (run.load * 1e-3, run.peak * 1e-3)).collect();
    let plot = Plot {
        title: "friction".into(),
        x: Axis::linear("load [nN]"),
        y: Axis::linear("peak friction [nN]"),
        curves: vec![Curve::new("", Mark::Dots, points)],
    };
    let caption = "Fig. 6: peak friction of a particle of 8 nm on a slab against the load".into();
    chapter.figures.push(Figure { name: "friction".into(), caption, svg: plot.svg() });
    Ok(runs.swap_remove(2))
}

/// A particle that rolls without sliding: what resists it, as a force at its centre, against the way, pN and nm.
fn roll(load: f64, velocity: f64) -> Result<Vec<(f64, f64)>, Halt> {
    let mut simulation = pressed(load, velocity, true)?;
    let mut curve = Vec::new();
    while travel(&simulation) < ROLLED {
        simulation.step()?;
        curve.push((travel(&simulation), rolling_resistance(&simulation)));
    }
    Ok(curve)
}

/// Least, mean and largest force of a curve, pN.
fn range(curve: &[(f64, f64)]) -> [f64; 3] {
    let forces = || curve.iter().map(|point| point.1);
    let mean = forces().sum::<f64>() / curve.len() as f64;
    [forces().fold(f64::INFINITY, f64::min), mean, forces().fold(0.0, f64::max)]
}

/// Fig. 8, beside what slides under 2 nN.
fn rolling(chapter: &mut Chapter, slid: &Slid) -> Result<(), Halt> {
    let runs = [(500.0, 1.0), (2000.0, 1.0), (8000.0, 1.0), (2000.0, 0.25)];
    let curves: Vec<_> = runs.into_par_iter().map(|(load, velocity)| roll(load, velocity)).collect::<Result<_, _>>()?;
    let ranges: Vec<[f64; 3]> = curves.iter().map(|curve| range(curve)).collect();
    let listed = runs.iter().zip(&ranges).map(|((load, velocity), [least, _, most])| {
        format!("{least:.1} to {most:.1} pN under {} nN at {velocity} m/s", load * 1e-3)
    });
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "the resistance to rolling, as a force at the centre, is the same all the way of 1 nm and at both velocities: a pure slider",
        "a slider without a spring (Eq. 13)",
        listed.collect::<Vec<_>>().join(", "),
        ranges.iter().all(|[least, mean, most]| most - least < 0.01 * mean) && near(ranges[3][1], ranges[1][1], 0.01),
    ));
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "peaks of sliding are significantly higher than the resistance to rolling, under 2 nN",
        "0.65 GPa to 0.25 GPa: 2.6",
        format!("{:.1} pN to {:.1} pN: {:.2}", slid.peak, ranges[1][1], slid.peak / ranges[1][1]),
        near(slid.peak / ranges[1][1], 2.6, 0.05),
    ));
    let thinned = |curve: &[(f64, f64)]| curve.iter().step_by(5).map(|&(way, force)| (way, force * 1e-3)).collect();
    let plot = Plot {
        title: "sliding and rolling".into(),
        x: Axis::linear("way [nm]"),
        y: Axis::linear("force [nN]"),
        curves: vec![
            Curve::new("sliding", Mark::Line, thinned(&slid.curve)),
            Curve::new("rolling", Mark::Line, thinned(&curves[1])),
        ],
    };
    let caption = "Fig. 8: a particle of 8 nm slides and rolls over a slab under 2 nN".into();
    chapter.figures.push(Figure { name: "dragging".into(), caption, svg: plot.svg() });
    Ok(())
}
