//! Section 5.3 of the titania paper: the structure of the film as deposited.

use super::aggregates::laws;
use crate::error::Error;
use crate::figures::{Curve, Mark};
use crate::initial::film::{DepositedFilm, FilmPlan};
use crate::interrupt::Interrupt;
use crate::observe::film::Structure;
use crate::reproduce::{Claim, Evidence, Figure, near};
use crate::spec::mechanics::discretised_lognormal::lognormal;

/// The box of the paper, nm, and the number of particles in it.
const BOX: [f64; 3] = [1581.4, 1581.4, 3358.0];
const PARTICLES: usize = 200_000;
/// Side length of the column: with the same number of particles per area as in the paper.
const SIDE: f64 = 790.7;
/// Gap of spheres that touch up to rounding, nm.
const TOUCH: f64 = 1e-6;
/// A velocity at which diffusion is negligible, nm/ns.
const STRAIGHT: f64 = 1e4;

/// Sizes and density, and the dependence of the density on diffusion.
pub(super) fn structure(chapter: &mut Evidence, interrupt: &Interrupt) -> Result<(), Error> {
    let plan = FilmPlan::paper(PARTICLES / 4, [SIDE; 2]);
    let (drifting, straight) =
        (build(&plan, interrupt)?, build(&FilmPlan { drift: STRAIGHT, ..plan.clone() }, interrupt)?);
    let d = &plan.diameters;
    let (mean, sauter, _) = lognormal(d.median, d.deviation, f64::from(d.smallest), f64::from(d.largest));
    let found = drifting.0.spheres.iter().map(|s| s.diameter).sum::<f64>() / drifting.0.spheres.len() as f64;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "mean diameter of the particles of a film, within 1 %",
        format!("{mean:.3} nm, by the stated distribution"),
        format!("{found:.3} nm"),
        near(found, mean, 0.01),
    ));
    let of_box = BOX[0] / 140.0;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "Sauter diameter, of which the side of the box is 140, within 1 %",
        format!("{of_box:.2} nm"),
        format!("{sauter:.2} nm, by the stated distribution"),
        near(sauter, of_box, 0.01),
    ));
    let mut numbers = vec![0u32; drifting.0.aggregates()];
    for s in &drifting.0.spheres {
        numbers[s.aggregate as usize] += 1;
    }
    numbers.sort_unstable();
    let median = f64::from(numbers[numbers.len() / 2]);
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "median number of particles per aggregate, within 10 %",
        "36",
        format!("{median}"),
        near(median, plan.numbers.median, 0.1),
    ));
    chapter.claims.extend(laws(&drifting.0, interrupt)?);
    number_density(chapter, drifting.0.spheres.len() as f64 / (SIDE * SIDE * drifting.1.thickness) * 1e9);
    density(chapter, &drifting.1, &straight.1);
    let curve = |name: &str, s: &Structure| {
        let layer = s.thickness / s.profile.len() as f64;
        let points = s.profile.iter().enumerate().map(|(k, solid)| ((k as f64 + 0.5) * layer * 1e-3, 100.0 * solid));
        Curve::new(name, Mark::Line, points.collect())
    };
    let caption = "Section 5.3: density profile of a film with the paper's number of particles per area";
    let curves = vec![curve("0.1 m/s", &drifting.1), curve("straight down", &straight.1)];
    chapter.figures.push(Figure::linear("film", caption, ["height [µm]", "solid fraction [%]"], curves));
    Ok(())
}

fn build(plan: &FilmPlan, interrupt: &Interrupt) -> Result<(DepositedFilm, Structure), Error> {
    let film = plan.build(1, interrupt).map_err(|failure| failure.of("sample.film"))?;
    let structure = Structure::of(&film, TOUCH, 1);
    Ok((film, structure))
}

/// Section 1, of a film as deposited, 1/µm^3.
fn number_density(chapter: &mut Evidence, found: f64) {
    let stated = PARTICLES as f64 / BOX.iter().product::<f64>() * 1e9;
    chapter.claims.push(Claim::new(
        "Section 1",
        "number of particles per volume, of a film deposited at 0.1 m/s and of the paper's box",
        "of the order of 1e4 to 1e5 per µm^3: 3e3 to 3e5",
        format!("{found:.2e} and {stated:.2e} per µm^3"),
        [found, stated].iter().all(|density| (3e3..3e5).contains(density)),
    ));
}

fn density(chapter: &mut Evidence, drifting: &Structure, straight: &Structure) {
    let percent = |s: &Structure| 100.0 * s.porosity;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "porosity of the bulk of a film deposited at 0.1 m/s, within 0.5 percentage points",
        "98 %",
        format!("{:.2} %; {:.2} % if the aggregates fall straight down", percent(drifting), percent(straight)),
        (percent(drifting) - 98.0).abs() < 0.5,
    ));
    let [small, median, large] = drifting.pores;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "an aggregate touches fewer than two others on average: each came to rest on one other, or on the floor",
        "contacts and pores are not stated",
        format!(
            "{:.2}; mean coordination number within an aggregate {:.2}; pore diameters {small:.0}, {median:.0} and {large:.0} nm (10th, 50th and 90th percentile by volume)",
            drifting.contacts_between, drifting.contacts_within
        ),
        drifting.contacts_between < 2.0,
    ));
    let [_, _, paper] = BOX.map(|side| side * 1e-3);
    let [drifting, straight] = [drifting, straight].map(|s| s.thickness * 1e-3);
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "thickness of a film of 200,000 particles on 1.58 µm x 1.58 µm, within 10 %",
        format!("{paper:.2} µm, the height of the box"),
        format!("{drifting:.2} µm; {straight:.2} µm if the aggregates fall straight down"),
        near(drifting, paper, 0.1),
    ));
}
