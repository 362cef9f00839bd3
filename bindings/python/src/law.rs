//! Contact laws over arrays of pairs.

use crate::arrays::{Numbers, place};
use crate::columns::{Argument, over_columns};
use crate::errors::{caught, exception, wrong};
use crate::laws::{AnyLaw, law_of};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;
use veridem_spec::numbers::Instructions;

/// The contact law of a paper, with its parameters. Units: nm, ns, ag; hence m/s, pN and zJ.
#[pyclass(frozen, module = "veridem")]
pub(crate) struct Law {
    pub(crate) law: Arc<dyn AnyLaw>,
    /// The paper.
    #[pyo3(get)]
    paper: &'static str,
}

#[pymethods]
impl Law {
    /// The law that a section `model` describes, in YAML. Of spheres with these radii (nm) attractions are tabulated, as in large simulations.
    #[new]
    #[pyo3(signature = (model, radii = None))]
    fn new(model: &str, radii: Option<Vec<f64>>) -> PyResult<Self> {
        caught(|| {
            if let Some(radius) = radii.iter().flatten().find(|&&radius| !(radius > 0.0 && radius.is_finite())) {
                return Err(wrong(format!("`radii`: found {radius}, expected numbers above 0")));
            }
            let (paper, law) = law_of(model, radii).map_err(exception)?;
            Ok(Self { law, paper })
        })
    }

    /// The springs of a contact, by name.
    #[getter]
    fn springs(&self) -> Vec<String> {
        self.law.names().springs
    }

    /// The causes by which a pair loses energy.
    #[getter]
    fn losses(&self) -> Vec<String> {
        self.law.names().losses
    }

    /// The causes by which a pair stores energy.
    #[getter]
    fn stored(&self) -> Vec<String> {
        self.law.names().stored
    }

    /// The largest distance of the centres, nm, at which spheres of these radii act on each other.
    fn range(&self, r_i: f64, r_j: f64) -> PyResult<f64> {
        caught(|| Ok(self.law.range(positive("r_i", r_i)?, positive("r_j", r_j)?)))
    }

    /// The largest stable time step, ns, of two equal spheres in contact.
    fn critical_time_step(&self, r: f64, m: f64) -> PyResult<f64> {
        caught(|| Ok(self.law.critical_time_step(positive("r", r)?, positive("m", m)?)))
    }

    /// Forces, torques, new springs, losses and stored energies of pairs: a tuple of arrays with these in the last axis.
    fn pairs<'py>(
        &self,
        py: Python<'py>,
        kinematics: [Bound<'py, PyAny>; 4],
        sizes: [Bound<'py, PyAny>; 4],
        springs: Option<Bound<'py, PyAny>>,
        joined: bool,
        dt: f64,
    ) -> PyResult<Bound<'py, PyTuple>> {
        caught(|| {
            let (law, dt) = (&*self.law, positive("dt", dt)?);
            let lengths = law.lengths();
            let sizes = || ["r_i", "r_j", "m_i", "m_j"].into_iter().zip(&sizes);
            let of_pair = sizes().map(|(name, value)| sized(value, name)).collect::<PyResult<Vec<_>>>()?;
            // A single number has no axis of its own.
            let axis: &[usize] = if lengths.constants == 1 { &[] } else { &[lengths.constants] };
            let constants = over_columns(py, of_pair, &[axis], |arguments, results| {
                law.constants(joined, arguments, results);
            })?;
            let constants = constants.into_python(py)?.remove(0);
            let vectors = ["x", "v", "omega_i", "omega_j"].into_iter().zip(&kinematics);
            let mut arguments = vectors.map(|(name, value)| finite(value, name, 3)).collect::<PyResult<Vec<_>>>()?;
            arguments.extend(sizes().take(2).map(|(name, value)| sized(value, name)).collect::<PyResult<Vec<_>>>()?);
            let numbers = Numbers::of(&constants, "constants", lengths.constants)?;
            arguments.push(Argument { name: "constants", size: lengths.constants, numbers });
            let springs = springs.unwrap_or_else(|| vec![0.0; lengths.springs].into_pyarray(py).into_any());
            arguments.push(finite(&springs, "springs", lengths.springs)?);
            let results: [&[usize]; 6] = [&[3], &[3], &[3], &[lengths.springs], &[lengths.losses], &[lengths.stored]];
            let instructions = Instructions::best();
            let computed = over_columns(py, arguments, &results, |arguments, results| {
                let (pair, stored) = results.split_at_mut(results.len() - lengths.stored);
                law.pairs(dt, instructions, arguments, pair);
                law.stored(instructions, arguments, stored);
            })?;
            if let Some((at, _)) = computed.first_not_finite() {
                let at = place(at, &computed.shape);
                return Err(wrong(format!("the law has no finite value for the pair {at}: do two centres coincide?")));
            }
            PyTuple::new(py, computed.into_python(py)?)
        })
    }

    fn __repr__(&self) -> String {
        format!("<contact law of {}>", self.paper)
    }
}

/// A number above zero.
fn positive(name: &str, value: f64) -> PyResult<f64> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(wrong(format!("`{name}` = {value}: expected a number above 0")))
}

/// An argument whose numbers are finite.
fn finite<'a, 'py>(value: &Bound<'py, PyAny>, name: &'a str, size: usize) -> PyResult<Argument<'a, 'py>> {
    let numbers = Numbers::of(value, name, size)?;
    match numbers.slice()?.iter().find(|number| !number.is_finite()) {
        Some(number) => Err(wrong(format!("`{name}`: found {number}, expected finite numbers"))),
        None => Ok(Argument { name, size, numbers }),
    }
}

/// A radius or mass.
fn sized<'a, 'py>(value: &Bound<'py, PyAny>, name: &'a str) -> PyResult<Argument<'a, 'py>> {
    let argument = finite(value, name, 1)?;
    match argument.numbers.slice()?.iter().find(|number| **number <= 0.0) {
        Some(number) => Err(wrong(format!("`{name}`: found {number}, expected numbers above 0"))),
        None => Ok(argument),
    }
}
