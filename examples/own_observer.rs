//! An observer of your own for a case of a paper: the coated aggregate of Demidov, Gor & Khalizov (2024) restructures, and the number of its contacts
//! under tension is counted, which is not a column of `series.csv`.
//!
//!     cargo run --example own_observer

use std::error::Error;
use std::ops::ControlFlow;
use std::path::Path;
use veridem::interrupt::Interrupt;
use veridem::observe::links;
use veridem::papers::parse;
use veridem::papers::soot::{Plan, Soot};
use veridem::run::{Driver, Each, RunningStage, Step};
use veridem::spec::soot::Along;

const CASE: &str = "
title: A small coated aggregate
model: {soot: {}}
sample: {aggregate: {spheres: 40}}
experiment: {restructuring: {duration: 0.5 ns, dt: 5 fs}}
";

fn main() -> Result<(), Box<dyn Error>> {
    let case = parse::<Soot>(Path::new("own_observer.yaml"), CASE)?;
    let plan = Plan::of(&case, Along);
    println!("time [ns]  contacts  under tension");
    let mut observer = Each(|stage: &mut RunningStage<Plan<Along>>, _: &Step| {
        let system = stage.simulation.system();
        if system.step.is_multiple_of(10_000) {
            let contacts: Vec<_> = links(&stage.simulation).into_iter().filter(|link| link.gap < 0.0).collect();
            let tension = contacts.iter().filter(|link| link.force.dot(link.branch) > 0.0).count();
            println!("{:9.3} {:9} {tension:14}", system.time, contacts.len());
        }
        ControlFlow::Continue(())
    });
    let outcome = Driver::new(&plan, &Interrupt::default()).run(&mut observer)?;
    for finding in &outcome.findings {
        println!("{}: {}", finding.name, finding.sentence());
    }
    Ok(())
}
