//! Section 3.1: deposition and indentation of aggregates.

mod controls;

use crate::case::Limits;
use crate::case::quantity::{Scaled, quantity};
use crate::case::section::defaults;
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::interrupt::Interrupt;
use crate::observe::force_curve::ForceCurve;
use crate::observe::statistics::Mean;
use crate::papers::soot::Plan;
use crate::papers::soot::case::{Aggregate, Indentation, NeckSet, Soot, SootStage};
use crate::papers::soot::watch::{Deposit, height};
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use crate::run::{Driver, RunState, RunningStage, Sink, Step};
use crate::spec::soot::Along;
use crate::spec::soot::eq21_hamaker_plane::plane_force;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// Interval at which the force curve is recorded, ns: a fraction of the time constant of the cantilever.
const LOOK: f64 = 0.5;
/// Number of aggregates.
const AGGREGATES: u64 = 20;
/// Number of them that are indented with another attraction, and half as large.
const VARIED: u64 = 8;
/// The Hamaker constant of the paper, and three times as much.
const HAMAKER: [&str; 2] = ["1e-19 J", "3e-19 J"];
/// Number of curves in the figure.
const DRAWN: usize = 4;

/// The protocol of every aggregate. Everything else is as in the authors' published inputs.
#[derive(Clone, Copy)]
struct Protocol {
    aggregates: u64,
    spheres: u64,
    hamaker: &'static str,
    keep_necks: f64,
    indentation: &'static str,
}

/// The results of one aggregate.
struct Member {
    deposit: Deposit,
    kinetic: f64,
    lowered: f64,
    curve: ForceCurve,
}

/// Claims and force curves of Figs. 4 and 6.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let extent = setting.extent;
    let reduced = "aggregates of 60 spheres instead of 120, 90 % of the necks kept instead of 98 %, so that more are removed, \
                   indentations of 200 ns instead of 500 ns";
    let protocol = Protocol {
        aggregates: AGGREGATES,
        spheres: extent.of(60, 120),
        hamaker: HAMAKER[0],
        keep_necks: extent.of(0.9, 0.98),
        indentation: extent.of("200 ns", "500 ns"),
    };
    let members = members(&protocol, setting.interrupt)?;
    let varied = Protocol { aggregates: VARIED, ..protocol };
    let sticky = self::members(&Protocol { hamaker: HAMAKER[1], ..varied }, setting.interrupt)?;
    let small = self::members(&Protocol { spheres: protocol.spheres / 2, ..varied }, setting.interrupt)?;
    let mut claims = claims(&members);
    claims.extend(controls::claims(&members, &sticky, &small));
    Ok(Evidence { note: extent.of(reduced, "").into(), claims, figures: vec![figure(&members)] })
}

/// The aggregates of a protocol, which differ in their seed.
fn members(protocol: &Protocol, interrupt: &Interrupt) -> Result<Vec<Member>, Error> {
    let seeds: Vec<u64> = (1..=protocol.aggregates).collect();
    let member = |seed| member(&plan(protocol, seed), interrupt);
    seeds.into_par_iter().with_max_len(1).map(member).collect()
}

fn plan(protocol: &Protocol, seed: u64) -> Plan<Along> {
    let duration = |text: &str| Scaled::Absolute(quantity(text));
    Plan {
        seed,
        max_overlap: defaults::<Limits>().overlap,
        soot: Soot {
            necks: Some(NeckSet::S),
            cutoff: quantity("42 nm"),
            hamaker_constant: quantity(protocol.hamaker),
            ..defaults()
        },
        reading: Along,
        sample: Aggregate { spheres: protocol.spheres, neck_fraction: 1.0, ..defaults() },
        stages: vec![
            SootStage::Deposition(defaults()),
            SootStage::Indentation(Indentation {
                keep_necks: protocol.keep_necks,
                duration: duration(protocol.indentation),
                ..defaults()
            }),
        ],
        in_sequence: true,
    }
}

/// Deposits and indents one aggregate.
fn member(plan: &Plan<Along>, interrupt: &Interrupt) -> Result<Member, Error> {
    let mut observer = Observer::default();
    Driver::new(plan, interrupt).run(&mut observer)?;
    let Observer { first, lowered, deposit, curve } = observer;
    let (deposit, kinetic) = deposit.expect("a deposition comes first");
    Ok(Member { deposit, kinetic, lowered: first - lowered, curve: curve.expect("an indentation has a force curve") })
}

/// The observer of one aggregate.
#[derive(Default)]
struct Observer {
    /// Height of the centre of mass at the beginning and at the end of the deposition.
    first: f64,
    lowered: f64,
    /// The outcome of the deposition, and its initial kinetic energy.
    deposit: Option<(Deposit, f64)>,
    curve: Option<ForceCurve>,
}

impl Sink<Plan<Along>> for Observer {
    fn begin(&mut self, stage: &mut RunningStage<'_, Plan<Along>>, _: &RunState) -> Result<(), Error> {
        if stage.number == 0 {
            self.first = height(stage.simulation.system());
        }
        Ok(())
    }

    /// Ends the deposition when the aggregate is at rest.
    fn step(
        &mut self,
        stage: &mut RunningStage<'_, Plan<Along>>,
        _: &RunState,
        _: &Step,
    ) -> Result<ControlFlow<()>, Error> {
        let every = (LOOK / stage.simulation.settings().dt).round() as u64;
        let asked = stage.number == 0 && stage.simulation.system().step.is_multiple_of(every);
        if asked && stage.watch.deposit(&stage.simulation).rests {
            return Ok(ControlFlow::Break(()));
        }
        Ok(ControlFlow::Continue(()))
    }

    fn end(&mut self, stage: &mut RunningStage<'_, Plan<Along>>, _: &RunState) -> Result<(), Error> {
        if stage.number == 0 {
            self.lowered = height(stage.simulation.system());
            self.deposit = Some((stage.watch.deposit(&stage.simulation), stage.watch.kinetic()));
        } else {
            self.curve = stage.watch.curve().cloned();
        }
        Ok(())
    }
}

fn claims(members: &[Member]) -> Vec<Claim> {
    let mean = |of: &dyn Fn(&Member) -> f64| Mean::of(&members.iter().map(of).collect::<Vec<_>>());
    let rested = members.iter().filter(|member| member.deposit.rests).count();
    let anchored = members.iter().filter(|member| member.deposit.rests && member.deposit.spheres >= 2).count();
    let spheres = mean(&|member| member.deposit.spheres as f64);
    let dissipated = mean(&|member| member.deposit.dissipated / member.kinetic);
    let lowered = mean(&|member| member.lowered);
    let peaks = mean(&|member| member.curve.peaks().len() as f64);
    let highest = mean(&|member| 1e-3 * member.curve.highest());
    let parted: Vec<f64> = members.iter().filter_map(|member| member.curve.rupture()).collect();
    let rupture = Mean::of(&parted);
    let soot: Soot = defaults();
    let tip = plane_force(defaults::<Aggregate>().radius.value, soot.saturation.value, soot.tip_hamaker_constant.value);
    let within = highest.value > 0.0 && highest.value < 1e-3 * tip;
    vec![
        Claim::new(
            "Fig. 4",
            "aggregates come to rest on the substrate: less than 0.1 % of the initial kinetic energy remains within 500 ns",
            "adhesion by dissipation",
            format!("{rested} of {}; {dissipated:.2} times the initial kinetic energy dissipated", members.len()),
            rested == members.len() && dissipated.value > 0.0,
        ),
        Claim::new(
            "Section 3.1.1",
            "they topple until they adhere at several contacts",
            "all",
            format!("{anchored} of {} on at least two spheres, {spheres:.1} spheres on average", members.len()),
            anchored == members.len(),
        ),
        Claim::new(
            "Section 3.1.1",
            "they continue to move towards the substrate after one branch has adhered: the centre of mass sinks by more than the initial gap, 1.4 nm",
            "motion continues",
            format!("{lowered:.1} nm"),
            lowered.value - lowered.margin > 1.4,
        ),
        Claim::new(
            "Fig. 6a",
            "the force curve is saw-toothed: more than one peak on average",
            "several",
            format!("{peaks:.1}"),
            peaks.value > 1.0,
        ),
        Claim::new(
            "Fig. 6a",
            format!(
                "the highest peak is attractive, and below the pull-off force of a sphere from the tip, {:.2} nN",
                1e-3 * tip
            ),
            "a picture",
            format!("{highest:.2} nN"),
            within,
        ),
        Claim::new(
            "Fig. 6a",
            "in the end the tip, or a fragment on it, is severed from the substrate, at a displacement larger than a sphere",
            "severed",
            format!("{} of {}, at {rupture:.0} nm", parted.len(), members.len()),
            parted.len() == members.len() && rupture.value > 28.0,
        ),
    ]
}

fn figure(members: &[Member]) -> Figure {
    let curves = members.iter().take(DRAWN).enumerate().map(|(k, member)| {
        // A tip that hits a sphere which cannot yield is loaded a thousand times as much as it is ever pulled.
        let presses = |point: &&(f64, f64)| point.1 < -member.curve.highest();
        let points = member.curve.retraction().iter().skip_while(presses);
        let points = points.map(|&(displacement, reading)| (displacement, 1e-3 * reading));
        Curve::new(format!("aggregate {}", k + 1), Mark::Line, points.collect())
    });
    let title = "force on the tip during its retraction, filtered by the cantilever (Fig. 6a)".to_string();
    let (x, y) = (Axis::linear("tip displacement [nm]"), Axis::linear("pulling force [nN]"));
    let plot = Plot { title: title.clone(), x, y, curves: curves.collect() };
    Figure { name: "soot-force-curves".into(), caption: title, svg: plot.svg() }
}
