//! Section 2 of the titania paper: two particles; Section 5.3: a film.

pub mod agglomerate;
mod film;
pub mod spectroscopy;

use super::{Chapter, Claim, Figure, near};
use crate::build::pair::{drag, pair};
use crate::case::Titania;
use crate::case::section::defaults;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::forces::Instructions;
use crate::simulation::{Integrator, Settings, Simulation};
use crate::spec::titania;
use crate::spec::{Contact, Flat, PairModel, Vec3};
use crate::system::{Halt, System};
use rayon::prelude::*;

/// Nominal diameters of the two sizes of Figs. 3 and 6, nm.
const SIZES: [f64; 2] = [8.0, 16.0];
/// Nominal diameter of the sphere that stands for the slab, nm.
const SLAB: f64 = 1000.0;

/// Rest, stiffness, approach, stick and slip, friction, the structure of a film.
pub fn chapter() -> Result<Chapter, Halt> {
    let mut chapter = Chapter::default();
    constants(&mut chapter);
    repulsion(&mut chapter);
    approach(&mut chapter)?;
    sliding(&mut chapter)?;
    film::structure(&mut chapter);
    Ok(chapter)
}

fn paper() -> Titania {
    defaults()
}

/// Stiffness of two equal particles, GPa.
fn stiffness(d: f64) -> f64 {
    let titania = paper();
    let (r, m) = titania.particle(d);
    titania.law().parameters(r, r, m, m).k_n * 1e-3
}

/// Force that pulls two equal particles apart, nN, and the stretch from rest at which it is reached, nm.
fn pull_off(d: f64) -> (f64, f64) {
    let (titania, none) = (paper(), Vec3::zero());
    let (law, (r, m)) = (titania.law(), titania.particle(d));
    let constants = law.coefficients(r, r, m, m);
    let stretches = (0..2000).map(|k| f64::from(k) * 1e-3);
    let force = |stretch: f64| {
        let contact = Contact::new(Vec3::new(d + stretch, 0.0, 0.0), none, none, none, r, r);
        -law.pair(&contact, &constants, Flat::from_fn(|_| 0.0), 1e-4).wrench.force.0[0] * 1e-3
    };
    stretches
        .map(|stretch| (force(stretch), stretch))
        .fold((0.0, 0.0), |most, one| if one.0 > most.0 { one } else { most })
}

fn constants(chapter: &mut Chapter) {
    let sizes: Vec<u32> = (4..=23).collect();
    let table: Vec<f64> = sizes.iter().map(|&d| stiffness(f64::from(d))).collect();
    let (least, most) = table.iter().fold((f64::INFINITY, 0.0f64), |(a, b), &k| (a.min(k), b.max(k)));
    let listed: Vec<String> =
        [3.0, 4.0, 8.0, 12.0, 16.0, 20.0, 23.0].map(|d| format!("{d} nm: {:.1}", stiffness(d))).into();
    chapter.claims.push(Claim::new(
        "Section 2.3",
        "contact stiffness of equal particles of 4 to 23 nm",
        "20 to 45 GPa",
        format!("{least:.1} to {most:.1} GPa ({})", listed.join(", ")),
        least >= 20.0 && most <= 45.0,
    ));
    for (d, figure) in SIZES.into_iter().zip([24.5, 33.7]) {
        let k_n = stiffness(d);
        let claim = format!("contact stiffness of particles with a nominal radius of {} nm, within a tenth", 0.5 * d);
        chapter.claims.push(Claim::new(
            "Fig. 6",
            claim,
            format!("{figure} GPa"),
            format!("{k_n:.1} GPa"),
            near(k_n, figure, 0.1),
        ));
    }
    let [small, large] = SIZES.map(pull_off);
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "force that pulls two particles of 8 and of 16 nm apart: grows with the size",
        "in the picture only",
        format!("{:.2} nN at {:.2} nm from rest, {:.2} nN at {:.2} nm", small.0, small.1, large.0, large.1),
        large.0 > small.0,
    ));
}

/// Fig. 4: what is left of the force on a particle pressed on the slab when the attraction is taken away.
fn repulsion(chapter: &mut Chapter) {
    let (titania, none) = (paper(), Vec3::zero());
    let (law, [(r, m), (big, heavy)]) = (titania.law(), [SIZES[0], SLAB].map(|d| titania.particle(d)));
    let constants = law.coefficients(r, big, m, heavy);
    let force = |overlap: f64| {
        let contact = Contact::new(Vec3::new(r + big - overlap, 0.0, 0.0), none, none, none, r, big);
        let whole = law.pair(&contact, &constants, Flat::from_fn(|_| 0.0), 1e-4).wrench.force.0[0];
        (whole - law.attraction(r, big).force(contact.distance)) * 1e-3
    };
    let ends = [0.1, 0.4];
    let [least, most] = ends.map(force);
    let order = (most / least).ln() / (ends[1] / ends[0]).ln();
    chapter.claims.push(Claim::new(
        "Fig. 4",
        "order in the overlap of the repulsion of a particle with a radius of 4 nm from a slab, here a sphere of 1 µm",
        "3/2",
        format!("{order:.4}, from {least:.2} nN at {} nm to {most:.2} nN at {} nm", ends[0], ends[1]),
        near(order, 1.5, 1e-3),
    ));
}

fn settings(dt: f64) -> Settings {
    let (integrator, instructions) = (Integrator::HalfStep, Instructions::best());
    Settings { dt, integrator, damping: 0.0, skin: 1.0, max_overlap: 0.8, relax_box: None, far_every: 1, instructions }
}

fn apart(system: &System) -> f64 {
    (system.particles.x[0] - system.particles.x[1]).norm()
}

/// Fig. 3.
fn approach(chapter: &mut Chapter) -> Result<(), Halt> {
    let mut curves = Vec::new();
    for (factor, who) in [(1.0, "paper"), (10.0, "authors' program")] {
        for d in SIZES {
            let mut titania = paper();
            titania.damping_constant.value *= factor;
            let mut simulation = Simulation::new(titania.law(), pair(&titania, [d; 2], 0, 0.5), settings(1e-4))?;
            let (mut least, mut settled, mut points) = (f64::INFINITY, 0.0, vec![(0.0, 0.5)]);
            for _ in 0..50_000 {
                simulation.step()?;
                let (distance, time) = (apart(simulation.system()), simulation.system().time);
                least = least.min(distance);
                if (distance - d).abs() > 5e-3 {
                    settled = time;
                }
                if simulation.system().step.is_multiple_of(20) && time < 0.6 {
                    points.push((time * 1e3, distance - d));
                }
            }
            let end = apart(simulation.system());
            chapter.claims.push(Claim::new(
                "Fig. 3",
                format!("two particles of {d} nm released 0.5 nm from rest swing about it and settle; damping constant of the {who}"),
                "quickly, by a damped oscillation; times in the picture only",
                format!(
                    "least distance {:.3} nm below rest, within 5 pm of it after {settled:.2} ns, at last {:.1e} nm off",
                    d - least,
                    (end - d).abs()
                ),
                least < d && (end - d).abs() < 1e-3,
            ));
            curves.push(Curve::new(format!("{d} nm, {who}"), Mark::Line, points));
        }
    }
    let plot = Plot {
        title: "approach".into(),
        x: Axis::linear("time [ps]"),
        y: Axis::linear("distance from rest [nm]"),
        curves,
    };
    let caption = "Fig. 3: two particles released 0.5 nm from rest".into();
    chapter.figures.push(Figure { name: "approach".into(), caption, svg: plot.svg() });
    Ok(())
}

/// Stick and slip of a particle of 8 nm over the slab.
struct Slid {
    load: f64,
    velocity: f64,
    /// Mean distance between two slips, nm.
    period: f64,
    /// Mean force at a slip, pN.
    peak: f64,
    /// Mean of shear strength times contact area there, pN.
    strength: f64,
}

fn slide(load: f64, velocity: f64) -> Result<Slid, Halt> {
    let titania = paper();
    let law: titania::Titania = titania.law();
    let mut system = pair(&titania, [SIZES[0], SLAB], 1, 0.0);
    drag(&mut system, 0.0, load, false);
    let mut simulation = Simulation::new(law, system, settings(5e-4))?;
    for _ in 0..6000 {
        simulation.step()?;
    }
    let mut system = simulation.into_system();
    drag(&mut system, velocity, load, false);
    let mut simulation = Simulation::new(law, system, settings(5e-4))?;
    let mut slips: Vec<[f64; 3]> = Vec::new();
    while simulation.system().walls[1].travel.0[0] < 1.7 {
        let slipping = simulation.pairs().find(|pair| pair.outcome.losses.sliding > 0.0);
        let slip = slipping.map(|pair| {
            let travel = simulation.system().walls[1].travel.0[0];
            [travel, pair.outcome.wrench.force.0[0].abs(), law.tau_s * titania::Titania::area(&pair.contact)]
        });
        slips.extend(slip);
        simulation.step()?;
    }
    let n = slips.len() as f64;
    let mean = |k: usize| slips.iter().map(|slip| slip[k]).sum::<f64>() / n;
    let period = (slips.last().map_or(f64::NAN, |s| s[0]) - slips.first().map_or(f64::NAN, |s| s[0])) / (n - 1.0);
    Ok(Slid { load, velocity, period, peak: mean(1), strength: mean(2) })
}

fn sliding(chapter: &mut Chapter) -> Result<(), Halt> {
    let runs = [(500.0, 1.0), (1000.0, 1.0), (2000.0, 1.0), (4000.0, 1.0), (8000.0, 1.0), (2000.0, 0.25)];
    let runs: Vec<Slid> =
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
    Ok(())
}
