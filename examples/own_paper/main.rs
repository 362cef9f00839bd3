//! A paper of one's own beside the library's: a contact law, the sections of its case files, two stages, an observer, a graph, and a claim.
//!
//! In the law of Cundall and Strack (1979) overlapping spheres repel each other by a linear spring and a dashpot. After a head-on collision two spheres separate
//! with a constant fraction of their relative velocity, the coefficient of restitution. The program has the complete command line:
//!
//! ```sh
//! cargo run --example own_paper -- check examples/own_paper/case.yaml
//! cargo run --example own_paper -- run examples/own_paper/case.yaml
//! cargo run --example own_paper -- reproduce linear
//! ```

mod case;
mod law;
mod study;

use case::{Experiment, Model, Sample};
use law::restitution;
use std::path::Path;
use std::process::ExitCode;
use study::{GAP, Plan};
use veridem::case::check::{Found, expect};
use veridem::case::units::{decimal, in_unit, rounded};
use veridem::error::Error;
use veridem::figures::{Curve, Graph, Mark};
use veridem::output::Column;
use veridem::output::columns::TIME;
use veridem::papers::{CaseOf, Paper, Papers, parse};
use veridem::reproduce::{Chapter, Claim, Evidence, Figure, Setting, near};
use veridem::run::{Driver, Runnable};

/// The program: its papers, and the library's command line.
pub(crate) fn main() -> ExitCode {
    veridem::cli::main(Papers(&[&LinearContacts]))
}

/// The paper.
pub(crate) struct LinearContacts;

impl Paper for LinearContacts {
    const NAME: &'static str = "linear";
    const REFERENCE: &'static str = "Cundall & Strack 1979";
    const TITLE: &'static str = "Linear springs and dashpots: claims and results";
    const QUANTITIES: &'static [(&'static str, &'static [Column])] = &[("Columns and results", study::ALL)];
    const GRAPHS: &'static [Graph] =
        &[Graph { name: "gap", stages: &["approach", "rebound"], x: TIME, y: GAP, marks: &["deepest"] }];
    const CHAPTERS: &'static [Chapter] =
        &[Chapter { name: "collisions", about: "two spheres", title: "Collisions", compute: collisions }];

    type Model = Model;
    type Sample = Sample;
    type Experiment = Experiment;

    fn check(case: &CaseOf<Self>, found: &mut Found) {
        let (Model::Linear(material), Sample::Pair(pair)) = (&case.model, &case.sample);
        let Experiment::Collision(collision) = &case.experiment;
        for (key, value, text) in [
            ("model.linear.stiffness", material.stiffness.value, material.stiffness.to_string()),
            ("model.linear.density", material.density.value, material.density.to_string()),
            ("sample.pair.radius", pair.radius.value, pair.radius.to_string()),
            ("experiment.collision.velocity", collision.velocity.value, collision.velocity.to_string()),
            ("experiment.collision.dt", collision.dt.number(), collision.dt.to_string()),
        ] {
            expect(found, value > 0.0, key, text, "more than zero");
        }
        let ratio = material.damping_ratio;
        expect(found, (0.0..1.0).contains(&ratio), "model.linear.damping_ratio", decimal(ratio), "0 or more, below 1");
    }
    fn derived(case: &CaseOf<Self>) -> Vec<(String, String)> {
        let plan = Plan::of(case);
        vec![
            ("mass".into(), in_unit(plan.mass, "ag")),
            ("dt".into(), in_unit(plan.dt, "ps")),
            ("restitution".into(), rounded(restitution(plan.law.damping_ratio))),
        ]
    }
    fn study(case: CaseOf<Self>) -> Box<dyn Runnable> {
        Box::new(Plan::of(&case))
    }
}

/// A collision at each of several damping ratios.
fn collisions(setting: &Setting) -> Result<Evidence, Error> {
    let (mut evidence, mut curve) = (Evidence::default(), Vec::new());
    for ratio in [0.05, 0.2, 0.5] {
        let text = include_str!("case.yaml").replace("damping_ratio: 0.2", &format!("damping_ratio: {ratio}"));
        let mut plan = Plan::of(&parse::<LinearContacts>(Path::new("case.yaml"), &text)?);
        plan.dt = 1e-4;
        let (measured, expected) =
            (plan.bounce(&Driver::new(&plan, setting.interrupt).run(&mut ())?.system), restitution(ratio));
        let [paper, ours] = [expected, measured].map(|bounce| format!("{bounce:.4}"));
        let claim = format!("coefficient of restitution at a damping ratio of {ratio}");
        evidence.claims.push(Claim::new("restitution", claim, paper, ours, near(measured, expected, 0.01)).exact());
        curve.push((ratio, measured));
    }
    let (axes, curves) = (["damping ratio", "restitution"], vec![Curve::new("", Mark::Points, curve)]);
    evidence.figures.push(Figure::linear("restitution", "Coefficient of restitution of a collision", axes, curves));
    Ok(evidence)
}
