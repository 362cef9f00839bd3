//! The contact laws of the papers, as one type.

use crate::simulation::Steps;
use std::path::Path;
use std::sync::Arc;
use veridem::case::springs::Transport;
use veridem::error::{Error, Problem};
use veridem::interrupt::Interrupt;
use veridem::papers::{CaseOf, Paper, parse, soot, titania, wear};
use veridem::simulation::{Settings, Simulation};
use veridem::system::System;
use veridem_spec::columns::{CoefficientsKernel, PairKernel, Results, StoredKernel, in_rows, one_by_one};
use veridem_spec::numbers::Instructions;
use veridem_spec::soot::{Along, Following, Lagging, Printed, Programmed};
use veridem_spec::titania::Tabulated;
use veridem_spec::wear::{Interaction, Published};
use veridem_spec::{Carried, Flat, Named, Necked, PairModel, Turns};

/// Numbers of a pair.
pub(crate) struct Lengths {
    pub constants: usize,
    pub springs: usize,
    pub losses: usize,
    pub stored: usize,
}

/// Names of those numbers.
pub(crate) struct Names {
    pub springs: Vec<String>,
    pub losses: Vec<String>,
    pub stored: Vec<String>,
}

/// Any contact law. Columns are in the order of the kernels of the specification.
pub(crate) trait AnyLaw: Send + Sync {
    fn lengths(&self) -> Lengths;
    fn names(&self) -> Names;
    fn range(&self, r_i: f64, r_j: f64) -> f64;
    fn critical_time_step(&self, r: f64, m: f64) -> f64;
    fn constants(&self, joined: bool, arguments: &[&[f64]], results: Results<'_, '_>);
    fn pairs(&self, dt: f64, instructions: Instructions, arguments: &[&[f64]], results: Results<'_, '_>);
    fn stored(&self, instructions: Instructions, arguments: &[&[f64]], results: Results<'_, '_>);
    /// Number of materials of surfaces.
    fn surfaces(&self) -> usize;
    fn simulation(&self, system: System, settings: Settings, interrupt: &Interrupt) -> Result<Box<dyn Steps>, Error>;
}

impl<M: PairModel + Clone + Send + 'static> AnyLaw for M {
    fn lengths(&self) -> Lengths {
        Lengths {
            constants: M::Coefficients::<f64>::LEN,
            springs: M::Memory::<f64>::LEN,
            losses: M::Losses::<f64>::LEN,
            stored: M::Stored::<f64>::LEN,
        }
    }
    fn names(&self) -> Names {
        Names {
            springs: M::Memory::<f64>::names(),
            losses: M::Losses::<f64>::names(),
            stored: M::Stored::<f64>::names(),
        }
    }
    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        PairModel::range(self, r_i, r_j)
    }
    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        PairModel::critical_time_step(self, r, m)
    }
    fn constants(&self, joined: bool, arguments: &[&[f64]], results: Results<'_, '_>) {
        one_by_one(CoefficientsKernel { model: self, joined }, arguments, results);
    }
    fn pairs(&self, dt: f64, instructions: Instructions, arguments: &[&[f64]], results: Results<'_, '_>) {
        in_rows(PairKernel { model: self, dt }, instructions, arguments, results);
    }
    fn stored(&self, instructions: Instructions, arguments: &[&[f64]], results: Results<'_, '_>) {
        in_rows(StoredKernel { model: self }, instructions, arguments, results);
    }
    fn surfaces(&self) -> usize {
        M::SURFACES
    }
    fn simulation(&self, system: System, settings: Settings, interrupt: &Interrupt) -> Result<Box<dyn Steps>, Error> {
        Ok(Box::new(Simulation::new_unless(self.clone(), system, settings, interrupt)?))
    }
}

/// The paper of a law, and the law of a section `model`.
type PaperLaw = (&'static str, fn(&str, Option<Vec<f64>>) -> Result<Arc<dyn AnyLaw>, Error>);

/// The paper and the law that a section `model` describes.
pub(crate) fn law_of(model: &str, radii: Option<Vec<f64>>) -> Result<(&'static str, Arc<dyn AnyLaw>), Error> {
    let papers: [PaperLaw; 3] =
        [(wear::Wear::NAME, of_wear), (soot::Soot::NAME, of_soot), (titania::Titania::NAME, of_titania)];
    let name = first_key(model);
    match papers.into_iter().find(|(paper, _)| Some(*paper) == name.as_deref()) {
        Some((paper, law)) => Ok((paper, law(model, radii)?)),
        None => {
            let names: Vec<String> = papers.iter().map(|(name, _)| format!("`{name}`")).collect();
            let found = name.map_or("nothing".into(), |name| format!("`{name}`"));
            Err(Error::of_key("model", format!("found {found}, expected one of {}", names.join(", "))))
        }
    }
}

/// The key of a section with one key.
fn first_key(section: &str) -> Option<String> {
    let section: serde_yaml::Mapping = serde_yaml::from_str(section).ok()?;
    section.keys().next()?.as_str().map(String::from)
}

fn of_wear(model: &str, _: Option<Vec<f64>>) -> Result<Arc<dyn AnyLaw>, Error> {
    use wear::case::Readings;
    let case = case_with::<wear::Wear>(
        model,
        "sample: {hcp: {diameter: 1 d_c, size: [5 d_0, 5 d_0, 3 d_0]}}\nexperiment: {patch: {compression: {}}}\n",
    )?;
    let material = wear::material(&case);
    let law = material.law(Interaction::Full);
    Ok(match (material.readings, material.springs) {
        (Readings::AsPublished, _) => Arc::new(Published(law)),
        (Readings::Own, Transport::Projected) => Arc::new(law),
        (Readings::Own, Transport::Carried) => Arc::new(Carried(law)),
    })
}

fn of_soot(model: &str, _: Option<Vec<f64>>) -> Result<Arc<dyn AnyLaw>, Error> {
    use soot::case::{Model, Torsion};
    let case = case_with::<soot::Soot>(model, "sample: {aggregate: {}}\nexperiment: {restructuring: {}}\n")?;
    let Model::Soot(soot) = &case.model;
    Ok(match (soot.torsion, soot.lags(), soot.springs) {
        (.., Transport::Carried) => Arc::new(soot.law(Following)),
        (Torsion::Spring, false, _) => Arc::new(soot.law(Along)),
        (Torsion::Spring, true, _) => Arc::new(soot.law(Lagging)),
        (_, false, _) => Arc::new(soot.law(Printed)),
        (_, true, _) => Arc::new(soot.law(Programmed)),
    })
}

fn of_titania(model: &str, radii: Option<Vec<f64>>) -> Result<Arc<dyn AnyLaw>, Error> {
    use titania::{Law, case::Model};
    let case = case_with::<titania::Titania>(model, "sample: {pair: {}}\nexperiment: {contact: {approach: {}}}\n")?;
    let Model::Titania(titania) = &case.model;
    let carried = titania.springs == Transport::Carried;
    let Some(mut radii) = radii else { return Ok(transported(titania.law(), carried)) };
    radii.sort_unstable_by(f64::total_cmp);
    radii.dedup();
    if radii.is_empty() {
        return Err(Error::Usage("`radii` is empty".into()));
    }
    Ok(match &titania.neck_springs {
        Some(_) => transported(<Necked<Tabulated> as Law>::new(titania, &radii), carried),
        None => transported(<Tabulated as Law>::new(titania, &radii), carried),
    })
}

/// The law with springs that may follow a pair which spins.
fn transported<M: Turns + Clone + Send + 'static>(law: M, carried: bool) -> Arc<dyn AnyLaw> {
    if carried { Arc::new(Carried(law)) } else { Arc::new(law) }
}

/// A case with this model, of which only the model is wanted: what is wrong with the rest does not count, as with a time step that is too long
/// for the model.
fn case_with<P: Paper>(model: &str, rest: &str) -> Result<CaseOf<P>, Error> {
    let model: String = model.lines().map(|line| format!("  {line}\n")).collect();
    let text = format!("model:\n{model}title: a law\n{rest}");
    let parsed = parse::<P>(Path::new("<model>"), &text);
    let Err(Error::Input(problems)) = parsed else { return parsed };
    let of_rest = |problem: &Problem| problem.key.starts_with("experiment") || problem.key.starts_with("sample");
    let problems: Vec<Problem> = problems.into_iter().filter(|problem| !of_rest(problem)).collect();
    if !problems.is_empty() {
        let of_model = |problem: Problem| Problem { line: problem.line.map(|line| line - 1), ..problem };
        return Err(Error::Input(problems.into_iter().map(of_model).collect()));
    }
    let mut case = serde_yaml::from_str(&text).map_err(|error| Error::of_key("model", error.to_string()))?;
    P::complete(&mut case);
    Ok(case)
}
