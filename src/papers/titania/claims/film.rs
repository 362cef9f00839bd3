//! Section 5.3 of the titania paper: the film before anything is done to it.

use crate::error::Error;
use crate::figures::{Curve, Mark};
use crate::initial::film::{Film, FilmPlan};
use crate::interrupt::Interrupt;
use crate::observe::film::Structure;
use crate::reproduce::{Claim, Evidence, Figure, near};
use crate::spec::mechanics::discretised_lognormal::lognormal;

/// The box of the paper, nm, and the particles in it.
const BOX: [f64; 3] = [1581.4, 1581.4, 3358.0];
const PARTICLES: usize = 200_000;
/// Side of the column that is built: as many particles over each nm^2 as in the paper.
const SIDE: f64 = 790.7;
/// Gap of spheres that touch to rounding, nm.
const TOUCH: f64 = 1e-6;
/// A velocity at which diffusion no longer matters, nm/ns.
const STRAIGHT: f64 = 1e4;

/// Sizes, density, and what the density depends on.
pub fn structure(chapter: &mut Evidence, interrupt: &Interrupt) -> Result<(), Error> {
    let plan = FilmPlan::paper(PARTICLES / 4, [SIDE; 2]);
    let (drifting, straight) =
        (build(&plan, interrupt)?, build(&FilmPlan { drift: STRAIGHT, ..plan.clone() }, interrupt)?);
    let d = &plan.diameters;
    let (mean, sauter, _) = lognormal(d.median, d.deviation, f64::from(d.smallest), f64::from(d.largest));
    let found = drifting.0.spheres.iter().map(|s| s.diameter).sum::<f64>() / drifting.0.spheres.len() as f64;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "mean diameter of the particles of a film, within a hundredth",
        format!("{mean:.3} nm, that of the stated distribution"),
        format!("{found:.3} nm"),
        near(found, mean, 0.01),
    ));
    let of_box = BOX[0] / 140.0;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "Sauter diameter, of which the box has 140, within a hundredth",
        format!("{of_box:.2} nm"),
        format!("{sauter:.2} nm, that of the stated distribution"),
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
        "median number of particles of an aggregate, within a tenth",
        "36",
        format!("{median}"),
        near(median, plan.numbers.median, 0.1),
    ));
    density(chapter, &drifting.1, &straight.1);
    let curve = |name: &str, s: &Structure| {
        let layer = s.thickness / s.profile.len() as f64;
        let points = s.profile.iter().enumerate().map(|(k, solid)| ((k as f64 + 0.5) * layer * 1e-3, 100.0 * solid));
        Curve::new(name, Mark::Line, points.collect())
    };
    let caption = "Section 5.3: density of a film of as many particles over its area as the paper's";
    let curves = vec![curve("0.1 m/s", &drifting.1), curve("straight down", &straight.1)];
    chapter.figures.push(Figure::linear("film", caption, ["height [µm]", "solid [%]"], curves));
    Ok(())
}

fn build(plan: &FilmPlan, interrupt: &Interrupt) -> Result<(Film, Structure), Error> {
    let film = plan.build(1, interrupt).map_err(|failure| failure.of("sample.film"))?;
    let structure = Structure::of(&film, TOUCH, 1);
    Ok((film, structure))
}

fn density(chapter: &mut Evidence, drifting: &Structure, straight: &Structure) {
    let percent = |s: &Structure| 100.0 * s.porosity;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "porosity of the bulk of a film that came down at 0.1 m/s, within half a percent",
        "98 %",
        format!("{:.2} %; {:.2} % if its aggregates fell straight down", percent(drifting), percent(straight)),
        (percent(drifting) - 98.0).abs() < 0.5,
    ));
    let [small, median, large] = drifting.pores;
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "an aggregate touches less than two others on average: each but those on the floor came to rest on one",
        "contacts and pores are not stated",
        format!(
            "{:.2}; {:.2} contacts of a sphere within its aggregate; pores of {small:.0}, {median:.0} and {large:.0} nm (10, 50 and 90 % of the volume)",
            drifting.contacts_between, drifting.contacts_within
        ),
        drifting.contacts_between < 2.0,
    ));
    let [_, _, paper] = BOX.map(|side| side * 1e-3);
    let [drifting, straight] = [drifting, straight].map(|s| s.thickness * 1e-3);
    chapter.claims.push(Claim::new(
        "Section 5.3",
        "thickness of a film of 200,000 particles on 1.58 µm x 1.58 µm, within a tenth",
        format!("{paper:.2} µm, the height of the box"),
        format!("{drifting:.2} µm; {straight:.2} µm if its aggregates fell straight down"),
        near(drifting, paper, 0.1),
    ));
}
