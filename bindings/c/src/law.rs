//! A contact law behind one interface, whatever its constants and springs are.

use crate::columns::Columns;
use crate::error::Done;
use crate::list::{List, Pairs};
use crate::plane::{self, Plane};
use crate::spheres::{Spheres, Totals};
use std::sync::Arc;
use veridem_spec::{Contact, Flat, Named, PairModel};

/// A contact law.
pub(crate) trait Law: Send + Sync {
    /// Names of the numbers that a pair remembers.
    fn history(&self) -> Vec<String>;
    /// Names of the energies that a pair loses.
    fn losses(&self) -> Vec<String>;
    /// Names of the energies that a pair stores.
    fn stored(&self) -> Vec<String>;
    /// Largest distance of centres at which two spheres act on each other.
    fn range(&self, r_i: f64, r_j: f64) -> f64;
    /// Largest stable time step of two equal spheres among others up to a radius.
    fn critical_time_step(&self, r: f64, m: f64, largest: f64) -> f64;
    /// Whether the law needs to know how many contacts share the inertia of a sphere.
    fn friction_stops(&self) -> bool;
    /// Whether necks may break.
    fn necks_break(&self) -> bool;
    /// Whether pairs may forget springs when they are listed anew.
    fn forgets(&self) -> bool;
    /// An empty list of pairs.
    fn list(&self) -> Box<dyn List>;
    /// The law over columns of pairs.
    fn evaluate(&self, columns: &mut Columns, dt: f64) -> Done;
    /// Distance of a centre from a plane up to which the plane acts; none for a law without surfaces.
    fn plane_range(&self, material: usize, r: f64) -> Option<f64>;
    /// The forces of a plane.
    fn plane(&self, plane: &mut Plane, spheres: &mut Spheres, totals: &mut Totals) -> Done;
}

/// Joined by a neck or not: the first number of the history of every pair.
const JOINED: &str = "joined";

/// Whether a neck breaks, given the pair, its springs and what they hold.
pub(crate) type Breaks<M> = Arc<
    dyn Fn(&M, &Contact<f64>, &<M as PairModel>::Memory<f64>, &<M as PairModel>::Stored<f64>) -> bool + Send + Sync,
>;

/// A model as a law.
pub(crate) struct Of<M: PairModel> {
    model: Arc<M>,
    breaks: Option<Breaks<M>>,
    forgets: bool,
}

impl<M: PairModel + Send + 'static> Of<M> {
    /// The model as a law.
    pub(crate) fn boxed(model: M) -> Box<dyn Law> {
        Self::breaking(model, None)
    }
    /// The same, which may forget springs when neighbours are listed anew.
    pub(crate) fn forgetting(model: M, forgets: bool) -> Box<dyn Law> {
        Box::new(Self { model: Arc::new(model), breaks: None, forgets })
    }
    /// The same with necks that break, if they do.
    pub(crate) fn breaking(model: M, breaks: Option<Breaks<M>>) -> Box<dyn Law> {
        Box::new(Self { model: Arc::new(model), breaks, forgets: false })
    }
}

impl<M: PairModel + Send + 'static> Law for Of<M> {
    fn history(&self) -> Vec<String> {
        std::iter::once(JOINED.to_string()).chain(M::Memory::<f64>::names()).collect()
    }
    fn losses(&self) -> Vec<String> {
        M::Losses::<f64>::names()
    }
    fn stored(&self) -> Vec<String> {
        M::Stored::<f64>::names()
    }
    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.model.range(r_i, r_j)
    }
    fn critical_time_step(&self, r: f64, m: f64, largest: f64) -> f64 {
        self.model.critical_time_step_among(r, m, largest)
    }
    fn friction_stops(&self) -> bool {
        M::FRICTION_STOPS
    }
    fn necks_break(&self) -> bool {
        self.breaks.is_some()
    }
    fn forgets(&self) -> bool {
        self.forgets
    }
    fn list(&self) -> Box<dyn List> {
        Box::new(Pairs::new(self.model.clone(), self.breaks.clone()))
    }
    fn evaluate(&self, columns: &mut Columns, dt: f64) -> Done {
        columns.evaluate(&*self.model, dt)
    }
    fn plane_range(&self, material: usize, r: f64) -> Option<f64> {
        (material < M::SURFACES).then(|| self.model.surface_range(material, r))
    }
    fn plane(&self, plane: &mut Plane, spheres: &mut Spheres, totals: &mut Totals) -> Done {
        plane::act(&*self.model, plane, spheres, totals)
    }
}

/// Constants of a pair, with its neck.
pub(crate) fn constants<M: PairModel>(model: &M, of: [f64; 4], joined: bool) -> M::Coefficients<f64> {
    let [r_i, r_j, m_i, m_j] = of;
    let constants = model.coefficients(r_i, r_j, m_i, m_j);
    if joined { model.joined(constants) } else { constants }
}

/// How many numbers the history of a pair has.
pub(crate) fn width<M: PairModel>() -> usize {
    1 + M::Memory::<f64>::LEN
}
