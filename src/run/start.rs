//! From a case to the run of its paper.

use super::{Control, Glance, Run, Study, soot, titania, wear};
use crate::case::{Case, Model};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder};
use crate::system::System;

/// A case ready to be run: its particles are there, and nothing has been written.
pub struct Prepared<'a> {
    case: &'a Case,
    initial: System,
}

impl<'a> Prepared<'a> {
    /// Finds out whatever is wrong with the input.
    pub fn new(case: &'a Case) -> Result<Self, Error> {
        let initial = match &case.model {
            Model::Wear(_) => wear::Plan::of(case).initial()?,
            Model::Soot(_) => soot::Plan::of(case).initial()?,
            Model::Titania(_) => match titania::Film::of(case) {
                Some(film) => film.initial()?,
                None => titania::Plan::of(case).initial()?,
            },
        };
        Ok(Self { case, initial })
    }

    /// Runs it from beginning to end; `show` is told how it is doing.
    pub fn start(
        self,
        folder: &RunFolder,
        manifest: Manifest,
        control: &Control,
        show: &mut dyn FnMut(Glance),
    ) -> Result<Vec<Finding>, Error> {
        let Self { case, initial } = self;
        match &case.model {
            Model::Wear(_) => Run::new(case, wear::Plan::of(case), folder, manifest, control, show).start(initial),
            Model::Soot(_) => Run::new(case, soot::Plan::of(case), folder, manifest, control, show).start(initial),
            Model::Titania(_) => match titania::Film::of(case) {
                Some(film) => Run::new(case, film, folder, manifest, control, show).start(initial),
                None => Run::new(case, titania::Plan::of(case), folder, manifest, control, show).start(initial),
            },
        }
    }
}

/// Goes on with a run from its latest checkpoint.
pub fn resume(
    case: &Case,
    folder: &RunFolder,
    manifest: Manifest,
    control: &Control,
    show: &mut dyn FnMut(Glance),
) -> Result<Vec<Finding>, Error> {
    match &case.model {
        Model::Wear(_) => Run::new(case, wear::Plan::of(case), folder, manifest, control, show).resume(),
        Model::Soot(_) => Run::new(case, soot::Plan::of(case), folder, manifest, control, show).resume(),
        Model::Titania(_) => match titania::Film::of(case) {
            Some(film) => Run::new(case, film, folder, manifest, control, show).resume(),
            None => Run::new(case, titania::Plan::of(case), folder, manifest, control, show).resume(),
        },
    }
}
