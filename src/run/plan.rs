//! The plan of a run: its steps, its output and its cost, before it is run.

use super::{Driver, Job, RunningStage, Study, columns};
use crate::case::units::{in_unit, of_waiting, significant};
use crate::case::{InSteps, Moments, Output};
use crate::error::{Error, Halt};
use crate::interrupt::Interrupt;
use crate::output::{encoded_size, row};
use crate::spec::{Named, PairModel};
use crate::system::System;
use serde_yaml::{Mapping, Value};
use std::time::{Duration, Instant};
use sysinfo::{MemoryRefreshKind, ProcessesToUpdate, RefreshKind};

/// Time for placing the spheres, after which a plan does without them.
const PLACING: Duration = Duration::from_secs(120);
/// Time for placing them, after which a job counts as longer than those whose spheres are placed sooner.
const MOMENT: Duration = Duration::from_millis(100);
/// Time during which steps are measured.
const MEASURING: Duration = Duration::from_millis(300);

/// Limits beyond which a run starts only on request: its steps, rows, frames and spheres.
const MANY_STEPS: u64 = 1_000_000_000_000;
const MANY_ROWS: u64 = 100_000_000;
const MANY_FRAMES: u64 = 1_000_000;
const MANY_SPHERES: f64 = 1e8;
/// Cores on which LAMMPS with the plugin is faster than the engine on one (docs/scale.md).
const LAMMPS_OVER_ENGINE: usize = 4;
/// Spheres of a core of LAMMPS from which on three quarters of its time are spent on its own spheres.
const SPHERES_PER_CORE: usize = 10_000;
/// Memory of a sphere with its neighbours, in bytes.
const BYTES: f64 = 1000.0;

/// A time as a number of steps.
fn in_steps(time: &InSteps, dt: f64) -> u64 {
    (time.value(dt) / dt).round() as u64
}

/// An interval as a number of steps.
fn every(interval: &InSteps, dt: f64) -> u64 {
    in_steps(interval, dt).max(1)
}

/// Output intervals of a stage, in steps: rows and checkpoints.
#[derive(Clone, Copy)]
pub(super) struct Intervals {
    pub(super) series: u64,
    pub(super) checkpoints: u64,
}

impl Intervals {
    /// The intervals with a time step, ns.
    pub(super) fn of(Output { series, checkpoints, .. }: &Output, dt: f64) -> Self {
        Self { series: every(series, dt), checkpoints: every(checkpoints, dt) }
    }
}

/// Whether a frame is due after this number of steps, each of `dt`, ns.
pub(super) fn frame_due(frames: &Moments, dt: f64, taken: u64) -> bool {
    match frames {
        Moments::Every(interval) => taken.is_multiple_of(every(interval, dt)),
        Moments::At(times) => times.iter().any(|time| in_steps(time, dt) == taken),
    }
}

/// Number of frames of a stage: at the start, when they are due, and at the end.
fn frames(moments: &Moments, dt: f64, steps: u64) -> u64 {
    match moments {
        Moments::Every(interval) => 1 + steps.div_ceil(every(interval, dt)),
        Moments::At(times) => {
            let mut due: Vec<u64> = times.iter().map(|time| in_steps(time, dt)).chain([0, steps]).collect();
            due.retain(|&step| step <= steps);
            due.sort_unstable();
            due.dedup();
            due.len() as u64
        }
    }
}

/// The plan of a stage.
pub(super) struct StagePlan {
    name: String,
    /// Time step, ns.
    dt: f64,
    /// Largest number of steps.
    steps: u64,
    intervals: Intervals,
    frames: u64,
}

impl StagePlan {
    /// Number of rows: at the start, at each interval, and at the end.
    fn rows(&self) -> u64 {
        1 + self.steps.div_ceil(self.intervals.series)
    }

    /// The plan for people and programs, with the intervals that differ from those asked for.
    fn describe(&self, output: &Output) -> Mapping {
        let Self { dt, steps, intervals, .. } = self;
        let mut entries = Mapping::new();
        let mut enter = |key: &str, value: Value| entries.insert(key.into(), value);
        enter("time step", in_unit(*dt, "fs").into());
        enter("largest number of steps", (*steps).into());
        enter("largest duration", in_unit(*steps as f64 * dt, "ns").into());
        enter("rows of series.csv", self.rows().into());
        enter("frames", self.frames.into());
        let mut asked = vec![("series", &output.series, intervals.series)];
        if let Moments::Every(interval) = &output.frames {
            asked.push(("frames", interval, every(interval, *dt)));
        }
        asked.push(("checkpoints", &output.checkpoints, intervals.checkpoints));
        for (name, asked, every) in asked {
            let (asked, used) = (asked.value(*dt), every as f64 * dt);
            if (used / asked - 1.0).abs() > 1e-9 {
                let text = format!("{} = {every} steps, rounded from {}", in_unit(used, "ns"), in_unit(asked, "ns"));
                enter(&format!("interval of {name}"), text.into());
            }
        }
        entries
    }
}

/// The stages of a study that begins with these spheres.
pub(super) fn stages<S: Study>(driver: &Driver<S>, study: &S, initial: &System, output: &Output) -> Vec<StagePlan> {
    let stage = |(number, name)| {
        let dt = driver.settings(number, initial).dt;
        let steps = study.steps(number, dt);
        let frames = frames(&output.frames, dt, steps);
        StagePlan { name, dt, steps, intervals: Intervals::of(output, dt), frames }
    };
    study.names().into_iter().enumerate().map(stage).collect()
}

/// Refuses a job with more spheres than is usual or than fit into the memory, unless it was requested.
pub(super) fn affordable<S: Study>(study: &S, job: &Job) -> Result<(), Error> {
    let (spheres, memory) = (study.expected_spheres(), available_memory());
    let needed = spheres * BYTES;
    if job.excess || spheres <= MANY_SPHERES && (needed <= memory || memory == 0.0) {
        return Ok(());
    }
    let what =
        format!("about {spheres:.2e} spheres, which need {} of memory; {} are available", size(needed), size(memory));
    Err(excess(job, &what))
}

/// Refuses a job with more steps, rows or frames than is usual, unless it was requested.
pub(super) fn moderate(stages: &[StagePlan], job: &Job) -> Result<(), Error> {
    for (number, most, of) in [
        (total(stages, |stage| stage.steps), MANY_STEPS, "steps"),
        (total(stages, StagePlan::rows), MANY_ROWS, "rows of series.csv"),
        (total(stages, |stage| stage.frames), MANY_FRAMES, "frames"),
    ] {
        if number > most && !job.excess {
            return Err(excess(job, &format!("{:.2e} {of}, more than {:.0e}", number as f64, most as f64)));
        }
    }
    Ok(())
}

fn total(stages: &[StagePlan], number: fn(&StagePlan) -> u64) -> u64 {
    stages.iter().map(number).fold(0, u64::saturating_add)
}

fn excess(job: &Job, what: &str) -> Error {
    Error::input(&job.file, format!("the case means {what}; with `--yes` it is accepted"))
}

/// Steps times spheres of a job.
pub(super) fn work<S: Study>(study: &S, job: &Job, interrupt: &Interrupt) -> f64 {
    let Ok(initial) = study.initial(&interrupt.within(MOMENT)) else {
        return MANY_STEPS as f64 * study.expected_spheres().max(1.0);
    };
    let stages = stages(&Driver::new(study, interrupt), study, &initial, &job.output);
    total(&stages, |stage| stage.steps) as f64 * initial.particles.len() as f64
}

/// The plan of a job: its initial state is made, and some of its first steps are taken.
pub(super) fn plan<S: Study>(study: &S, job: &Job, interrupt: &Interrupt) -> Result<Mapping, Error> {
    affordable(study, job)?;
    let mut plan = Mapping::new();
    let initial = match study.initial(&interrupt.within(PLACING)) {
        Err(Error::Interrupted) if !interrupt.is_due() => {
            let what = format!("not known: placing the spheres takes longer than {} s", PLACING.as_secs());
            plan.insert("spheres".into(), what.into());
            return Ok(plan);
        }
        initial => initial?,
    };
    let driver = Driver::new(study, interrupt).using(job.instructions);
    let stages = stages(&driver, study, &initial, &job.output);
    moderate(&stages, job)?;
    let mut stage = driver.set_up(0, initial)?;
    interrupt.check()?;
    let mut enter = |key: &str, value: Value| plan.insert(key.into(), value);
    enter("spheres", stage.simulation.system().particles.len().into());
    let described = stages.iter().map(|stage| (stage.name.clone().into(), stage.describe(&job.output).into()));
    enter("stages", described.collect::<Mapping>().into());
    let ledger = stage.simulation.ledger();
    enter("initial kinetic energy", in_unit(ledger.kinetic, "aJ").into());
    let causes = <S::Model as PairModel>::Stored::<f64>::names();
    for (cause, energy) in causes.into_iter().zip(&ledger.stored) {
        enter(&format!("initial energy stored by {cause}"), in_unit(*energy, "aJ").into());
    }
    interrupt.check()?;
    if let Some(stability) = stage.simulation.stability() {
        enter("stability", stability.to_string().into());
    }
    let (rows, frames) = (total(&stages, StagePlan::rows), total(&stages, |stage| stage.frames));
    enter("size of the run folder without figures", size(folder_size(&mut stage, &job.output, rows, frames)?).into());
    interrupt.check()?;
    let (taken, each) = measure(&driver, &mut stage)?;
    enter("memory", size(memory_of_process()).into());
    let threads = rayon::current_num_threads();
    let text = format!(
        "at most {}, from {taken} steps with {threads} thread{}",
        duration(each * total(&stages, |stage| stage.steps) as f64),
        if threads == 1 { "" } else { "s" },
    );
    enter("estimated time", text.into());
    if let Some(place) = beyond(stage.simulation.system().particles.len(), threads) {
        enter("beyond this machine", place.into());
    }
    Ok(plan)
}

/// Where a system is better computed, if it is larger than suits this number of threads.
fn beyond(spheres: usize, threads: usize) -> Option<String> {
    let cores = LAMMPS_OVER_ENGINE * threads;
    let words = format!("LAMMPS is faster on more than {cores} cores: `veridem export --lammps`, docs/scale.md");
    (spheres >= cores * SPHERES_PER_CORE).then_some(words)
}

/// Size of the output without figures, in bytes.
fn folder_size<S: Study>(
    stage: &mut RunningStage<'_, S>,
    output: &Output,
    rows: u64,
    frames: u64,
) -> Result<f64, Halt> {
    let header = columns(stage.study, stage.number).join(",").len();
    let row = row(&stage.measure()?.cells).len().max(header);
    let frame: usize = stage.frame(output).files(&output.format).iter().map(|(_, bytes)| bytes.len()).sum();
    let checkpoints = 2 * encoded_size(&stage.simulation.snapshot());
    Ok(rows as f64 * row as f64 + frames as f64 * frame as f64 + checkpoints as f64)
}

/// Takes steps for a moment: their number, and the time of each in seconds.
fn measure<'a, S: Study>(driver: &Driver<'a, S>, stage: &mut RunningStage<'a, S>) -> Result<(u64, f64), Error> {
    let (begun, last) = (Instant::now(), stage.last_step());
    let mut taken = 0;
    while taken < last && begun.elapsed() < MEASURING {
        driver.step(stage)?;
        taken += 1;
    }
    Ok((taken, begun.elapsed().as_secs_f64() / taken.max(1) as f64))
}

/// Memory that programs may still use, in bytes; zero if it is not known.
fn available_memory() -> f64 {
    let system =
        sysinfo::System::new_with_specifics(RefreshKind::nothing().with_memory(MemoryRefreshKind::everything()));
    let limit = system.cgroup_limits().map_or(u64::MAX, |limits| limits.free_memory);
    system.available_memory().min(limit) as f64
}

/// Memory of this process, in bytes; zero if it is not known.
fn memory_of_process() -> f64 {
    let (mut system, own) = (sysinfo::System::new(), sysinfo::get_current_pid());
    let Ok(own) = own else { return 0.0 };
    system.refresh_processes(ProcessesToUpdate::Some(&[own]), true);
    system.process(own).map_or(0.0, |process| process.memory() as f64)
}

/// A number of bytes with a decimal prefix.
fn size(bytes: f64) -> String {
    let prefix = ["B", "kB", "MB", "GB", "TB"].iter().enumerate().rev();
    let mut fitting = prefix.filter(|&(power, _)| bytes >= 1000f64.powi(power as i32));
    let (power, unit) = fitting.next().unwrap_or((0, &"B"));
    format!("{} {unit}", significant(bytes / 1000f64.powi(power as i32), 2))
}

/// A time in seconds, in a unit that suits it.
fn duration(seconds: f64) -> String {
    let (number, unit) = of_waiting(seconds);
    format!("{} {unit}", significant(number, 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_and_the_last_state_have_rows_of_their_own() {
        let intervals = Intervals { series: 100, checkpoints: 1 };
        let rows = |steps| StagePlan { name: String::new(), dt: 1.0, steps, intervals, frames: 0 }.rows();
        assert_eq!([1, 99, 100, 101, 200].map(rows), [2, 2, 2, 3, 3]);
        let moments = |text: &str| serde_yaml::from_str::<Moments>(text).expect("moments");
        assert_eq!([1, 99, 100, 101].map(|steps| frames(&moments("100 steps"), 0.5, steps)), [2, 2, 2, 3]);
        let listed = moments("[1, 10, 100 steps]");
        assert_eq!([1, 50, 100, 101].map(|steps| frames(&listed, 0.5, steps)), [2, 4, 4, 5]);
        assert_eq!((0..200).filter(|&step| frame_due(&listed, 0.5, step)).collect::<Vec<_>>(), [1, 10, 100]);
    }

    #[test]
    fn a_system_that_fills_four_times_the_cores_is_better_off_in_lammps() {
        assert_eq!(beyond(159_999, 4), None);
        assert!(beyond(160_000, 4).is_some_and(|words| words.contains("more than 16 cores")));
    }

    #[test]
    fn sizes_and_durations_have_units_that_suit_them() {
        assert_eq!([0.0, 950.0, 1500.0, 3.2e10].map(size), ["0 B", "950 B", "1.5 kB", "32 GB"]);
        assert_eq!([0.5, 90.0, 150.0, 1e4, 1e7].map(duration), ["0.50 s", "90 s", "2.5 min", "2.8 h", "120 days"]);
    }
}
