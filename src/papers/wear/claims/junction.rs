//! Section 4: shearing of silica junctions, and its cost (Table 6).

mod critical;

use super::experiment::{Relaxed, relax, shear_junction};
use super::{SILICA_DENSITY, silica};
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot, snapshot};
use crate::initial::Sizes;
use crate::interrupt::Interrupt;
use crate::papers::wear::case;
use crate::papers::wear::fate::{Fate, Row, WINDOW};
use crate::papers::wear::stages;
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use rayon::prelude::*;
use std::time::Instant;

/// A junction sheared by 100 nm in 10 ns.
struct Sheared {
    diameter: f64,
    d_0: f64,
    seed: u64,
    rows: Vec<Row>,
    fate: Fate,
    pictures: Vec<(f64, String)>,
    steps: u64,
    spheres: usize,
    seconds: f64,
}

/// Sliding at which pictures are taken, nm.
const PICTURES: [f64; 4] = [1.0, 15.0, 40.0, 95.0];

/// Figs. 9, 10, A.10 and Table 6.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let extent = setting.extent;
    let note =
        extent.of("d_0 = 1.5 nm is omitted; one sample for d_0 = 3 nm and three for 6 nm", "Three samples of each d_0");
    let mut chapter = Evidence { note: note.into(), ..Evidence::default() };
    let samples: &[(f64, u64)] = extent.of(
        &[(3.0, 1), (6.0, 1), (6.0, 2), (6.0, 3)],
        &[(1.5, 1), (1.5, 2), (1.5, 3), (3.0, 1), (3.0, 2), (3.0, 3), (6.0, 1), (6.0, 2), (6.0, 3)],
    );
    let sheared: Vec<Vec<Sheared>> =
        samples.par_iter().map(|&(d_0, seed)| both(d_0, seed, setting.interrupt)).collect::<Result<_, Error>>()?;
    let sheared: Vec<Sheared> = sheared.into_iter().flatten().collect();
    for run in &sheared {
        let (figure, paper) = (figure(run.d_0), if run.diameter < 15.0 { Fate::Flattened } else { Fate::Rolls });
        let turns = run.rows.last().map_or(0.0, |row| row.turns);
        let lowest = run.rows.iter().map(|row| row.separation).fold(f64::INFINITY, f64::min);
        chapter.claims.push(Claim::new(
            figure,
            format!("junction of D = {} nm at d_0 = {} nm, seed {}", run.diameter, run.d_0, run.seed),
            format!("{paper:?}").to_lowercase(),
            format!("{:?}: {turns:.2} turns in 100 nm, smallest distance between the bodies {lowest:.1} nm", run.fate)
                .to_lowercase(),
            run.fate == paper,
        ));
    }
    loads(&sheared, setting, &mut chapter)?;
    chapter.claims.push(critical::claim(setting)?);
    cost(&sheared, &mut chapter);
    figures(&sheared, &mut chapter);
    Ok(chapter)
}

fn figure(d_0: f64) -> &'static str {
    if d_0 < 2.0 {
        "Fig. 9"
    } else if d_0 < 4.0 {
        "Fig. A.10"
    } else {
        "Fig. 10"
    }
}

/// A relaxed sample.
fn sample(d_0: f64, seed: u64, interrupt: &Interrupt) -> Result<Relaxed, Error> {
    let sizes = Sizes { d_0, d_s: 0.75 * d_0, d_l: 7.5 };
    relax(sizes, [60.0, 40.0, 40.0], &silica(), SILICA_DENSITY, seed, interrupt)
}

/// Both junctions, from one relaxed sample.
fn both(d_0: f64, seed: u64, interrupt: &Interrupt) -> Result<Vec<Sheared>, Error> {
    let relaxed = sample(d_0, seed, interrupt)?;
    let shear = |diameter| shear(&relaxed, d_0, seed, diameter, LOAD, interrupt);
    [10.0, 20.0].into_par_iter().map(shear).collect()
}

/// Normal load of the paper, MPa, and smaller ones.
const LOAD: f64 = 100.0;
const SMALLER: [f64; 2] = [50.0, 10.0];

/// The same junctions of d_0 = 3 nm under smaller loads.
fn loads(sheared: &[Sheared], setting: &Setting, chapter: &mut Evidence) -> Result<(), Error> {
    let (d_0, seed) = (3.0, 1);
    let relaxed = sample(d_0, seed, setting.interrupt)?;
    let under: Vec<(f64, &Sheared)> = SMALLER
        .into_iter()
        .flat_map(|load| sheared.iter().filter(|run| run.d_0 == d_0 && run.seed == seed).map(move |run| (load, run)))
        .collect();
    let shear = |&(load, run): &(f64, &Sheared)| shear(&relaxed, d_0, seed, run.diameter, load, setting.interrupt);
    let found: Vec<Sheared> = under.par_iter().map(shear).collect::<Result<_, Error>>()?;
    for ((load, full), run) in under.into_iter().zip(found) {
        let shown = |run: &Sheared| {
            let turns = run.rows.last().map_or(0.0, |row| row.turns);
            format!("{:?}, {turns:.2} turns", run.fate).to_lowercase()
        };
        chapter.claims.push(Claim::new(
            "Section 4",
            format!("junction of D = {} nm at d_0 = {d_0} nm under a normal load of {load} MPa: the fate is that under {LOAD} MPa", run.diameter),
            "similar results",
            format!("{}; under {LOAD} MPa {}", shown(&run), shown(full)),
            run.fate == full.fate,
        ));
    }
    Ok(())
}

fn shear(
    relaxed: &Relaxed,
    d_0: f64,
    seed: u64,
    diameter: f64,
    load: f64,
    interrupt: &Interrupt,
) -> Result<Sheared, Error> {
    let material = silica();
    let case =
        format!("{{diameter: {diameter} nm, shear_velocity: 10 m/s, normal_stress: {load} MPa, duration: 10 ns}}");
    let case: case::Junction = serde_yaml::from_str(&case).expect("the section is complete");
    let stage = stages::junction(&case, d_0, material.young_modulus);
    let (mut pictures, mut steps, mut spheres): (Vec<(f64, String)>, u64, usize) = (Vec::new(), 0, 0);
    let begin = Instant::now();
    let witness = shear_junction(&relaxed.system, &stage, &material, WINDOW, interrupt, |simulation, _, witness| {
        let (system, slid) = (simulation.system(), witness.rows[witness.rows.len() - 1].slid);
        (steps, spheres) = (system.step, system.particles.len());
        if PICTURES.get(pictures.len()).is_some_and(|&at| slid >= at - 0.5 * WINDOW) {
            let height = system.domain.sides[1];
            pictures.push((slid, snapshot(system, [-0.05 * height, 1.25 * height])));
        }
    })?;
    let (fate, seconds) = (witness.fate(), begin.elapsed().as_secs_f64());
    Ok(Sheared { diameter, d_0, seed, rows: witness.rows, fate, pictures, steps, spheres, seconds })
}

/// Table 6, of the junctions of 20 nm.
fn cost(sheared: &[Sheared], chapter: &mut Evidence) {
    for run in sheared.iter().filter(|run| run.diameter > 15.0 && run.seed == 1) {
        let paper = if run.d_0 < 2.0 {
            "6000, 20 fs, 4 min on 28 cores"
        } else if run.d_0 < 4.0 {
            "2600, 40 fs, 2 min on 28 cores"
        } else {
            "600, 80 fs, 25 s on 28 cores"
        };
        let slid = run.rows.last().map_or(f64::NAN, |row| row.slid);
        let dt = slid / 10.0 / run.steps as f64 * 1e6;
        chapter.claims.push(Claim::new(
            "Table 6",
            format!(
                "spheres, time step and computing time for 10 ns at d_0 = {} nm: no slower than the paper",
                run.d_0
            ),
            paper,
            format!("{}, {dt:.1} fs, {:.0} s on one core, with other cases running", run.spheres, run.seconds),
            run.seconds
                < 28.0
                    * if run.d_0 < 2.0 {
                        240.0
                    } else if run.d_0 < 4.0 {
                        120.0
                    } else {
                        25.0
                    },
        ));
    }
}

fn figures(sheared: &[Sheared], chapter: &mut Evidence) {
    type Measure = fn(&Row) -> f64;
    let measures: [(&str, &str, Measure); 4] = [
        ("junction-friction", "friction force [nN]", |row| 1e-3 * row.friction),
        ("junction-turns", "turns of the third body", |row| row.turns),
        ("junction-separation", "separation of the bodies [nm]", |row| row.separation),
        ("junction-size", "mass of the third body [ag]", |row| row.third_mass),
    ];
    for (name, label, measure) in measures {
        let first = sheared.iter().filter(|run| run.seed == 1);
        let curve = |run: &Sheared| {
            let points = run.rows.iter().map(|row| (row.slid, measure(row))).collect();
            Curve::new(format!("D {}, d_0 {} nm", run.diameter, run.d_0), Mark::Line, points)
        };
        let caption = format!("sheared junctions: {label} against sliding distance");
        let (x, y) = (Axis::linear("sliding distance [nm]"), Axis::linear(label));
        let plot = Plot { title: caption.clone(), x, y, curves: first.map(curve).collect() };
        chapter.figures.push(Figure { name: name.into(), caption, svg: plot.svg() });
    }
    for run in sheared.iter().filter(|run| run.seed == 1) {
        for (slid, svg) in &run.pictures {
            let name = format!("junction-D{}-d{}-{slid:.0}nm", run.diameter, run.d_0);
            let caption =
                format!("D = {} nm, d_0 = {} nm after {slid:.0} nm ({})", run.diameter, run.d_0, figure(run.d_0));
            chapter.figures.push(Figure { name, caption, svg: svg.clone() });
        }
    }
}
