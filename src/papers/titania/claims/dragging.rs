//! Figs. 5, 6 and 8 of the titania paper: a particle of 8 nm or 16 nm dragged over a slab, sliding or rolling.

mod fitted;

use super::{SIZES, SLAB, paper, plan};
use crate::case::quantity::{Scaled, quantity};
use crate::error::Error;
use crate::figures::{Curve, Mark};
use crate::interrupt::Interrupt;
use crate::papers::titania::case::Dragging;
use crate::papers::titania::rolling_resistance;
use crate::papers::titania::stage::Stage;
use crate::papers::titania::study::Plan;
use crate::reproduce::{Claim, Evidence, Figure, near};
use crate::run::{self, Driver, RunState, Sink, Step};
use crate::simulation::Simulation;
use crate::spec::titania::Titania;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// Number of steps for which a particle is pressed onto the slab before it is dragged.
const SETTLING: f64 = 6000.0;
const DT: f64 = 5e-4;
/// Sliding and rolling distances, nm.
const SLID: f64 = 1.7;
const ROLLED: f64 = 1.0;
/// A distance larger than both.
const FARTHEST: &str = "2 nm";

/// Presses a particle onto the slab and drags it; `see` observes the states while it is dragged, the initial one included, and ends the run.
fn drag(
    d: f64,
    load: f64,
    velocity: f64,
    rolls: bool,
    interrupt: &Interrupt,
    see: impl FnMut(&Simulation<Titania>) -> ControlFlow<()>,
) -> Result<(), Error> {
    let test = Dragging {
        slab: quantity(&format!("{SLAB} nm")),
        load: quantity(&format!("{load} pN")),
        settling: Scaled::times(SETTLING),
        velocity: quantity(&format!("{velocity} m/s")),
        distance: quantity(FARTHEST),
    };
    let plan = plan(&paper(), DT, Stage::dragging(&test, d, rolls, DT).into());
    Driver::new(&plan, interrupt).run(&mut Dragged(see)).map(drop)
}

/// Shows a closure the second stage.
struct Dragged<F>(F);

impl<F: FnMut(&Simulation<Titania>) -> ControlFlow<()>> Sink<Plan> for Dragged<F> {
    fn begin(&mut self, stage: &mut run::RunningStage<'_, Plan>, _: &RunState) -> Result<(), Error> {
        if stage.number == 1 {
            let _ = (self.0)(&stage.simulation);
        }
        Ok(())
    }
    fn step(
        &mut self,
        stage: &mut run::RunningStage<'_, Plan>,
        _: &RunState,
        _: &Step,
    ) -> Result<ControlFlow<()>, Error> {
        Ok(if stage.number == 1 { (self.0)(&stage.simulation) } else { ControlFlow::Continue(()) })
    }
}

/// The repulsion that balances load and attraction, pN.
fn repulsion(load: f64, simulation: &Simulation<Titania>) -> f64 {
    let pair = simulation.pairs().next().expect("the particle touches the slab");
    load - simulation.model().attraction(pair.contact.r_i, pair.contact.r_j).force(pair.contact.distance)
}

fn travel(simulation: &Simulation<Titania>) -> f64 {
    simulation.system().walls[1].travel.0[0]
}

/// Stick-slip motion of a sliding particle.
struct Slid {
    load: f64,
    velocity: f64,
    /// Mean distance between two slips, nm.
    period: f64,
    /// Mean force at a slip, pN.
    peak: f64,
    /// Mean of shear strength times contact area at a slip, pN.
    strength: f64,
    /// Mean repulsion at a slip, pN.
    repulsion: f64,
    /// Force against displacement, pN and nm.
    curve: Vec<(f64, f64)>,
}

fn slide(d: f64, load: f64, velocity: f64, interrupt: &Interrupt) -> Result<Slid, Error> {
    let (mut slips, mut curve): (Vec<[f64; 4]>, _) = (Vec::new(), Vec::new());
    drag(d, load, velocity, false, interrupt, |simulation| {
        let (way, tau_s) = (travel(simulation), simulation.model().tau_s);
        if way >= SLID {
            return ControlFlow::Break(());
        }
        for pair in simulation.pairs() {
            let force = pair.outcome.wrench.force.0[0].abs();
            curve.push((way, force));
            if pair.outcome.losses.sliding > 0.0 {
                slips.push([way, force, tau_s * Titania::area(&pair.contact), repulsion(load, simulation)]);
            }
        }
        ControlFlow::Continue(())
    })?;
    let n = slips.len() as f64;
    let mean = |k: usize| slips.iter().map(|slip| slip[k]).sum::<f64>() / n;
    let period = (slips.last().map_or(f64::NAN, |s| s[0]) - slips.first().map_or(f64::NAN, |s| s[0])) / (n - 1.0);
    Ok(Slid { load, velocity, period, peak: mean(1), strength: mean(2), repulsion: mean(3), curve })
}

/// A particle that rolls without sliding.
struct Rolled {
    load: f64,
    velocity: f64,
    /// Smallest, mean and largest rolling resistance, as a force at the centre, pN.
    range: [f64; 3],
    /// Mean repulsion, pN.
    repulsion: f64,
    /// Rolling resistance against displacement, pN and nm.
    curve: Vec<(f64, f64)>,
}

fn roll(d: f64, load: f64, velocity: f64, interrupt: &Interrupt) -> Result<Rolled, Error> {
    let (mut curve, mut repelled) = (Vec::new(), 0.0);
    drag(d, load, velocity, true, interrupt, |simulation| {
        let way = travel(simulation);
        // Nothing has been measured before the first step.
        if simulation.system().step > 0 {
            curve.push((way, rolling_resistance(simulation)));
            repelled += repulsion(load, simulation);
        }
        if way < ROLLED { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    let forces = || curve.iter().map(|point| point.1);
    let mean = forces().sum::<f64>() / curve.len() as f64;
    let range = [forces().fold(f64::INFINITY, f64::min), mean, forces().fold(0.0, f64::max)];
    let repulsion = repelled / curve.len() as f64;
    Ok(Rolled { load, velocity, range, repulsion, curve })
}

/// Loads, pN, and velocities, m/s; the last repeats the third at a lower velocity.
const RUNS: [(f64, f64); 6] =
    [(500.0, 1.0), (1000.0, 1.0), (2000.0, 1.0), (4000.0, 1.0), (8000.0, 1.0), (2000.0, 0.25)];
/// The first of them have the same velocity.
const LOADS: usize = 5;
const TYPICAL: usize = 2;

/// One result for each load (pN) and velocity (m/s).
fn runs<T: Send>(of: &[(f64, f64)], run: impl Fn(f64, f64) -> Result<T, Error> + Sync) -> Result<Vec<T>, Error> {
    of.par_iter().map(|&(load, velocity)| run(load, velocity)).collect()
}

/// The results of a dragged particle.
pub(super) fn dragging(chapter: &mut Evidence, interrupt: &Interrupt) -> Result<(), Error> {
    let slid = runs(&RUNS, |load, velocity| slide(SIZES[0], load, velocity, interrupt))?;
    let rolled = runs(&RUNS, |load, velocity| roll(SIZES[0], load, velocity, interrupt))?;
    let slid_large = runs(&RUNS[..LOADS], |load, velocity| slide(SIZES[1], load, velocity, interrupt))?;
    let rolled_large = runs(&RUNS[..LOADS], |load, velocity| roll(SIZES[1], load, velocity, interrupt))?;
    sliding(chapter, &slid);
    rolling(chapter, &rolled, &slid[TYPICAL]);
    let peaks = |slid: &[Slid]| slid[..LOADS].iter().map(|run| (run.repulsion, run.peak)).collect::<Vec<_>>();
    let resistances =
        |rolled: &[Rolled]| rolled[..LOADS].iter().map(|run| (run.repulsion, run.range[1])).collect::<Vec<_>>();
    chapter.claims.extend(fitted::claims(
        [&slid, &slid_large].map(|slid| peaks(slid)),
        [&rolled, &rolled_large].map(|rolled| resistances(rolled)),
    ));
    figures(chapter, &slid, &rolled);
    Ok(())
}

/// Force relative to load at each load, and whether it decreases to less than half.
fn over_load(points: impl Iterator<Item = (f64, f64)> + Clone) -> (String, bool) {
    let ratios: Vec<f64> = points.clone().map(|(load, force)| force / load).collect();
    let listed = points.map(|(load, force)| format!("{:.2} at {} nN", force / load, load * 1e-3));
    let falls = ratios.windows(2).all(|pair| pair[1] < pair[0]) && ratios[0] > 2.0 * ratios[ratios.len() - 1];
    (listed.collect::<Vec<_>>().join(", "), falls)
}

/// Stick-slip motion, and the upper half of Fig. 6.
fn sliding(chapter: &mut Evidence, runs: &[Slid]) {
    let (loads, slow) = runs.split_at(LOADS);
    let all = |of: fn(&Slid) -> String| runs.iter().map(of).collect::<Vec<_>>().join(", ");
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "the stick-slip period is that of the law for every load (0.5 to 8 nN) and velocity (0.25 and 1 m/s)",
        "about 0.5 nm",
        all(|run| format!("{:.4}", run.period)) + " nm",
        runs.iter().all(|run| near(run.period, 0.5, 0.01)),
    ));
    let (fast, slow) = (&loads[TYPICAL], &slow[0]);
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "peak friction is independent of the velocity",
        "negligible influence",
        format!("{:.1} pN at {} m/s, {:.1} pN at {} m/s", fast.peak, fast.velocity, slow.peak, slow.velocity),
        near(fast.peak, slow.peak, 0.01),
    ));
    chapter.claims.push(Claim::new(
        "Eq. 10",
        "peak friction is shear strength times contact area, on a slab represented by a sphere of 1 µm",
        "0.65 GPa",
        loads.iter().map(|run| format!("{:.4}", 0.65 * run.peak / run.strength)).collect::<Vec<_>>().join(", ")
            + " GPa",
        loads.iter().all(|run| near(run.peak, run.strength, 0.01)),
    ));
    let (ratios, falls) = over_load(loads.iter().map(|run| (run.load, run.peak)));
    chapter.claims.push(Claim::new(
        "Fig. 6",
        "the ratio of peak friction to load decreases with the load: Amontons' law does not hold",
        "falls",
        ratios,
        falls,
    ));
}

/// Rolling resistance, and the lower half of Fig. 6.
fn rolling(chapter: &mut Evidence, runs: &[Rolled], slid: &Slid) {
    let (loads, slow) = runs.split_at(LOADS);
    let (typical, slow) = (&loads[TYPICAL], &slow[0]);
    let listed = runs.iter().map(|Rolled { load, velocity, range: [least, _, most], .. }| {
        format!("{least:.1} to {most:.1} pN under {} nN at {velocity} m/s", load * 1e-3)
    });
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "the rolling resistance, as a force at the centre, is constant over 1 nm and the same at both velocities",
        "a pure slider (Eq. 13)",
        listed.collect::<Vec<_>>().join(", "),
        runs.iter().all(|Rolled { range: [least, mean, most], .. }| most - least < 0.01 * mean)
            && near(slow.range[1], typical.range[1], 0.01),
    ));
    let (ratios, falls) = over_load(loads.iter().map(|run| (run.load, run.range[1])));
    chapter.claims.push(Claim::new(
        "Fig. 6",
        "the ratio of rolling resistance to load decreases with the load",
        "falls",
        ratios,
        falls,
    ));
    let higher = slid.peak / typical.range[1];
    chapter.claims.push(Claim::new(
        "Section 2.4",
        "peak sliding friction is significantly larger than rolling resistance, under 2 nN",
        "0.65 GPa to 0.25 GPa: 2.6",
        format!("{:.1} pN to {:.1} pN: {higher:.2}", slid.peak, typical.range[1]),
        near(higher, 2.6, 0.05),
    ));
}

fn figures(chapter: &mut Evidence, slid: &[Slid], rolled: &[Rolled]) {
    let mut draw = |name: &str, caption: &str, x: &str, y: &str, curves: Vec<Curve>| {
        chapter.figures.push(Figure::linear(name, caption, [x, y], curves));
    };
    let against_load = |label: &str, points: Vec<(f64, f64)>| {
        Curve::new(label, Mark::Dots, points.into_iter().map(|(load, force)| (load * 1e-3, force * 1e-3)).collect())
    };
    draw(
        "friction",
        "Fig. 6: peak friction and rolling resistance of a particle of 8 nm on a slab against the load",
        "load [nN]",
        "force [nN]",
        vec![
            against_load("sliding", slid[..LOADS].iter().map(|run| (run.load, run.peak)).collect()),
            against_load("rolling", rolled[..LOADS].iter().map(|run| (run.load, run.range[1])).collect()),
        ],
    );
    let against_way = |label: &str, curve: &[(f64, f64)]| {
        let points = curve.iter().step_by(5).map(|&(way, force)| (way, force * 1e-3));
        Curve::new(label, Mark::Line, points.collect())
    };
    draw(
        "dragging",
        "Fig. 8: sliding and rolling of a particle of 8 nm over a slab under 2 nN",
        "displacement [nm]",
        "force [nN]",
        vec![against_way("sliding", &slid[TYPICAL].curve), against_way("rolling", &rolled[TYPICAL].curve)],
    );
}
