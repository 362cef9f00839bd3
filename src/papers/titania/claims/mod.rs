//! Section 2 of the titania paper: two particles; Section 5.3: a film.

pub mod agglomerate;
mod aggregates;
mod approach;
mod dragging;
mod exact;
mod film;
mod listed;
pub mod spectroscopy;

pub use listed::LISTED;

use super::Plan;
use super::case::Titania;
use super::stage::Stage;
use crate::case::Limits;
use crate::case::section::defaults;
use crate::error::Error;
use crate::figures::{Curve, Mark};
use crate::reproduce::{Chapter, Claim, Evidence, Figure, Setting, near};
use crate::spec::{Contact, Flat, PairModel, Vec3};
use std::marker::PhantomData;

/// The chapters.
pub const CHAPTERS: &[Chapter] = &[
    Chapter {
        name: "exact",
        about: "consequences of the equations",
        title: "Consequences of the equations",
        compute: |_| Ok(exact::chapter()),
    },
    Chapter {
        name: "contact",
        about: "two water-covered particles, Section 2",
        title: "Two particles",
        compute: |setting| chapter(setting),
    },
    Chapter {
        name: "agglomerate",
        about: "a stretched agglomerate, Section 3.1",
        title: "A stretched agglomerate",
        compute: |setting| agglomerate::chapter(setting),
    },
    Chapter {
        name: "spectroscopy",
        about: "films under a tip, Section 3.2",
        title: "Films under a tip",
        compute: |setting| spectroscopy::chapter(setting),
    },
];

/// Nominal diameters of the two sizes of Figs. 3 and 6, nm.
const SIZES: [f64; 2] = [8.0, 16.0];
/// Nominal diameter of the sphere that represents the slab, nm.
const SLAB: f64 = 1000.0;

/// Equilibrium, stiffness, approach, stick-slip motion, friction, the structure of a film.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let mut chapter = Evidence::default();
    constants(&mut chapter);
    repulsion(&mut chapter);
    approach::approach(&mut chapter, setting.interrupt)?;
    dragging::dragging(&mut chapter, setting.interrupt)?;
    film::structure(&mut chapter, setting.interrupt)?;
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

/// Force required to separate two equal particles, nN, against the distance beyond equilibrium, nm.
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

fn constants(chapter: &mut Evidence) {
    let table: Vec<(f64, f64)> = (3..=23).map(f64::from).map(|d| (d, stiffness(d))).collect();
    let stated = table.iter().filter(|size| size.0 >= 4.0);
    let (least, most) = stated.fold((f64::INFINITY, 0.0f64), |(a, b), &(_, k)| (a.min(k), b.max(k)));
    let listed: Vec<String> = table.iter().map(|(d, k)| format!("{d} nm: {k:.2}")).collect();
    chapter.claims.push(Claim::new(
        "Section 2.3",
        "contact stiffness of equal particles of 4 to 23 nm",
        "20 to 45 GPa",
        format!("{least:.1} to {most:.1} GPa ({})", listed.join(", ")),
        least >= 20.0 && most <= 45.0,
    ));
    let caption = "Section 2.3: contact stiffness of two equal particles";
    let axes = ["nominal diameter [nm]", "contact stiffness [GPa]"];
    chapter.figures.push(Figure::linear("stiffness", caption, axes, vec![Curve::new("", Mark::Dots, table)]));
    for (d, figure) in SIZES.into_iter().zip([24.5, 33.7]) {
        let k_n = stiffness(d);
        let claim = format!("contact stiffness of particles with a nominal radius of {} nm, within 10 %", 0.5 * d);
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
        "pull-off force of two particles of 8 nm and of 16 nm: increases with the size",
        "in the figure only",
        format!("{:.2} nN at {:.2} nm beyond equilibrium, {:.2} nN at {:.2} nm", small.1, small.0, large.1, large.0),
        large.1 > small.1,
    ));
    let curves = SIZES.into_iter().zip(pulls);
    let curves = curves.map(|(d, pull)| Curve::new(format!("{d} nm"), Mark::Line, pull)).collect();
    let caption = "Fig. 8: quasi-static force between two equal particles";
    chapter.figures.push(Figure::linear("pull", caption, ["distance beyond equilibrium [nm]", "force [nN]"], curves));
}

/// Fig. 4: the force on a particle on the slab without the attraction.
fn repulsion(chapter: &mut Evidence) {
    let (titania, none) = (paper(), Vec3::zero());
    let (law, [(r, m), (big, heavy)]) = (titania.law(), [SIZES[0], SLAB].map(|d| titania.particle(d)));
    let constants = law.coefficients(r, big, m, heavy);
    let force = |overlap: f64| {
        let contact = Contact::new(Vec3::new(r + big - overlap, 0.0, 0.0), none, none, none, r, big);
        let whole = law.pair(&contact, &constants, Flat::from_fn(|_| 0.0), 1e-4).wrench.force.0[0];
        (whole - law.attraction(r, big).force(contact.distance)) * 1e-3
    };
    let rest = r + big - law.equilibrium(r, big);
    let curve: Vec<(f64, f64)> = (-150..=300).map(|k| f64::from(k) * 1e-3).map(|z| (-z, force(rest + z))).collect();
    // The forces to which the paper fits its law.
    let fitted = 5.0;
    let pressed = curve.iter().find(|point| point.1 > fitted).map_or(f64::INFINITY, |point| -point.0);
    let order = (force(4.0 * rest) / force(rest)).log(4.0);
    chapter.claims.push(Claim::new(
        "Fig. 4",
        "range around equilibrium in which the repulsion of a particle with a radius of 4 nm from a slab, here a sphere of 1 µm, is below 5 nN: 2 to 5 Å",
        "a few Å",
        format!(
            "{:.1} Å, from {:.1} Å above to {:.1} Å below equilibrium, where it is {:.2} nN; a power of {order:.2} of the overlap",
            10.0 * (rest + pressed),
            10.0 * rest,
            10.0 * pressed,
            force(rest)
        ),
        (0.2..0.5).contains(&(rest + pressed)),
    ));
    let caption = "Fig. 4: repulsion of a particle with a radius of 4 nm from a slab";
    let (axes, curves) =
        (["distance from equilibrium [nm]", "repulsion [nN]"], vec![Curve::new("", Mark::Line, curve)]);
    chapter.figures.push(Figure::linear("repulsion", caption, axes, curves));
}

/// Stages of two particles, without a case.
fn plan(titania: &Titania, dt: f64, stages: Vec<Stage>) -> Plan {
    Plan { titania: titania.clone(), dt, overlap: defaults::<Limits>().overlap, chain: None, stages, law: PhantomData }
}
