//! Section 2 of the titania paper: two particles; Section 5.3: a film.

pub mod agglomerate;
mod dragging;
mod film;
pub mod spectroscopy;

use super::{Chapter, Claim, Figure, near};
use crate::build::pair::pair;
use crate::case::Titania;
use crate::case::section::defaults;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::forces::Instructions;
use crate::simulation::{Integrator, Settings, Simulation};
use crate::spec::{Contact, Flat, PairModel, Vec3};
use crate::system::{Halt, System};

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
    dragging::dragging(&mut chapter)?;
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

/// Force that pulls two equal particles apart, nN, against the stretch from rest, nm.
fn pull(d: f64) -> Vec<(f64, f64)> {
    let (titania, none) = (paper(), Vec3::zero());
    let (law, (r, m)) = (titania.law(), titania.particle(d));
    let constants = law.coefficients(r, r, m, m);
    let force = |stretch: f64| {
        let contact = Contact::new(Vec3::new(d + stretch, 0.0, 0.0), none, none, none, r, r);
        -law.pair(&contact, &constants, Flat::from_fn(|_| 0.0), 1e-4).wrench.force.0[0] * 1e-3
    };
    (-100..2000).map(|k| f64::from(k) * 1e-3).map(|stretch| (stretch, force(stretch))).collect()
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
    let pulls = SIZES.map(pull);
    let largest = |pull: &Vec<(f64, f64)>| pull.iter().copied().fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
    let [small, large] = pulls.each_ref().map(largest);
    chapter.claims.push(Claim::new(
        "Fig. 8",
        "force that pulls two particles of 8 and of 16 nm apart: grows with the size",
        "in the picture only",
        format!("{:.2} nN at {:.2} nm from rest, {:.2} nN at {:.2} nm", small.1, small.0, large.1, large.0),
        large.1 > small.1,
    ));
    let curves = SIZES.into_iter().zip(pulls);
    let plot = Plot {
        title: "pull".into(),
        x: Axis::linear("stretch from rest [nm]"),
        y: Axis::linear("force [nN]"),
        curves: curves.map(|(d, pull)| Curve::new(format!("{d} nm"), Mark::Line, pull)).collect(),
    };
    let caption = "Fig. 8: the force that holds two equal particles, at rest relative to each other".into();
    chapter.figures.push(Figure { name: "pull".into(), caption, svg: plot.svg() });
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
