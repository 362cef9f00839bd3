//! Section 3.1 of the titania paper, Fig. 9: stretching of a chain of 14 particles.

use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::output::between;
use crate::papers::parse;
use crate::papers::titania::Pull;
use crate::papers::titania::Titania;
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use rayon::prelude::*;
use std::path::Path;

/// The case, and the names of its variants with both waters.
const CASE: &str = include_str!("../../../../cases/titania/agglomerate.yaml");
const WATERS: [(&str, &str); 2] = [("experimental", "experimental"), ("tip3p", "TIP3P")];
/// The contact events.
const EVENTS: [&str; 3] = ["sliding", "rolling", "detachment"];

/// The pulling force of a chain, for both waters.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let pulls: Vec<Pull> = WATERS
        .into_par_iter()
        .map(|(word, _)| {
            let text = CASE.replace("surface_tension: experimental", &format!("surface_tension: {word}"));
            Pull::of(&parse::<Titania>(Path::new("agglomerate.yaml"), &text)?, setting.interrupt)
        })
        .collect::<Result<_, Error>>()?;
    let mut chapter = Evidence::default();
    for ((_, name), pull) in WATERS.iter().zip(&pulls) {
        let counts = EVENTS.map(|what| pull.events.iter().filter(|(_, event)| event.starts_with(what)).count());
        chapter.claims.push(Claim::new(
            "Fig. 9",
            format!("contacts of a stretched agglomerate slide, roll and detach, {name} water"),
            "all three occur",
            format!("{} sliding events, {} rolling events, {} detachments", counts[0], counts[1], counts[2]),
            counts.iter().all(|&count| count > 0),
        ));
        let forces: Vec<String> = pull.at_detachments().iter().map(|force| format!("{:.1}", force * 1e-3)).collect();
        chapter.claims.push(Claim::new(
            "Fig. 9",
            format!("pulling forces are a few nanonewtons (1 to 10 nN), {name} water"),
            "in the figure only",
            format!("at most {:.2} nN; at detachments {} nN", pull.largest * 1e-3, forces.join(", ")),
            (1e3..1e4).contains(&pull.largest),
        ));
        chapter.figures.push(figure(name, pull));
    }
    chapter.claims.push(Claim::new(
        "Fig. 9",
        "with the lower surface tension of TIP3P water the largest pulling force is smaller",
        "in the figure only",
        format!("at most {:.2} nN instead of {:.2} nN", pulls[1].largest * 1e-3, pulls[0].largest * 1e-3),
        pulls[1].largest < pulls[0].largest,
    ));
    Ok(chapter)
}

fn figure(name: &str, pull: &Pull) -> Figure {
    let force: Vec<_> = pull.curve.iter().map(|(drawn, force)| (*drawn, force * 1e-3)).collect();
    let mut curves = vec![Curve::new("force", Mark::Line, force.clone())];
    for what in EVENTS {
        let events = pull.events.iter().filter(|(_, event)| event.starts_with(what));
        let points = events.filter_map(|(drawn, _)| Some((*drawn, between(&force, *drawn)?))).collect();
        curves.push(Curve::new(what, Mark::Points, points));
    }
    let (x, y) = (Axis::linear("displacement of the spring [nm]"), Axis::linear("pulling force [nN]"));
    let plot = Plot { title: format!("{name} water"), x, y, curves };
    let caption = format!("Fig. 9: pulling force of an agglomerate of 14 particles, {name} surface tension of water");
    Figure { name: format!("fig-9-{}", name.to_lowercase()), caption, svg: plot.svg() }
}
