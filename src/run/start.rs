//! From a case to the run of its paper.

use super::{Control, Glance, Run, Study, soot, titania, wear};
use crate::case::{Case, Model};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder};
use crate::spec::Necked;
use crate::spec::titania::Tabulated;
use crate::system::System;

/// Does the same with the plan of any paper.
macro_rules! with_plan {
    ($case:expr, $plan:ident => $done:expr) => {
        match &$case.model {
            Model::Wear(_) => {
                let $plan = wear::Plan::of($case);
                $done
            }
            Model::Soot(_) => {
                let $plan = soot::Plan::of($case);
                $done
            }
            Model::Titania(model) if $case.is_about_a_film() && model.neck_springs.is_some() => {
                let $plan = titania::Film::<Necked<Tabulated>>::of($case);
                $done
            }
            Model::Titania(_) if $case.is_about_a_film() => {
                let $plan = titania::Film::<Tabulated>::of($case);
                $done
            }
            Model::Titania(_) => {
                let $plan = titania::Plan::of($case);
                $done
            }
        }
    };
}

/// A case ready to be run: its particles are there, and nothing has been written.
pub struct Prepared<'a> {
    case: &'a Case,
    initial: System,
}

impl<'a> Prepared<'a> {
    /// Finds out whatever is wrong with the input.
    pub fn new(case: &'a Case) -> Result<Self, Error> {
        let initial = with_plan!(case, plan => plan.initial()?);
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
        with_plan!(case, plan => Run::new(case, plan, folder, manifest, control, show).start(initial))
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
    with_plan!(case, plan => Run::new(case, plan, folder, manifest, control, show).resume())
}
