//! Equations as objects that are called.

use crate::arrays::{Numbers, place};
use crate::columns::{Argument, over_columns};
use crate::documentation;
use crate::errors::{caught, wrong};
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyString, PyTuple};
use std::sync::OnceLock;
use veridem::equations::{Entry, Registry, outside, with_unit};
use veridem_spec::document;
use veridem_spec::numbers::Instructions;

/// An equation of a paper, a function over numbers and arrays.
#[pyclass(frozen, module = "veridem")]
pub(crate) struct Equation {
    pub(crate) entry: &'static Entry,
    /// The class of several results, once there are any.
    results: PyOnceLock<Py<PyAny>>,
}

/// All equations, looked up by name.
fn registry() -> &'static Registry {
    static REGISTRY: OnceLock<Registry> = OnceLock::new();
    REGISTRY.get_or_init(Registry::new)
}

/// Every equation, in the order of the papers.
#[pyfunction]
pub(crate) fn all_equations() -> PyResult<Vec<Equation>> {
    caught(|| Ok(registry().0.iter().map(Equation::of).collect()))
}

/// The id of the equation that is meant; case, leading zeros and separators do not matter.
#[pyfunction]
pub(crate) fn id_of(id: &str) -> PyResult<&'static str> {
    caught(|| registry().find(id).map(|entry| entry.equation.id).map_err(PyKeyError::new_err))
}

impl Equation {
    fn of(entry: &'static Entry) -> Self {
        Self { entry, results: PyOnceLock::new() }
    }

    /// The arguments of a call, in the order of the table.
    fn bound<'py>(
        &self,
        positional: &Bound<'py, PyTuple>,
        keywords: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let table = &self.entry.document.arguments;
        if positional.len() > table.len() {
            let (id, most, given) = (self.entry.equation.id, table.len(), positional.len());
            return Err(PyTypeError::new_err(format!("{id} has {most} arguments, found {given}")));
        }
        let mut given: Vec<(String, Bound<'py, PyAny>)> =
            table.iter().zip(positional).map(|(quantity, value)| (quantity.name.clone(), value)).collect();
        for (name, value) in keywords.into_iter().flatten() {
            given.push((name.extract()?, value));
        }
        self.entry.in_order(given).map_err(PyTypeError::new_err)
    }

    /// Refuses a value outside the domain of its quantity.
    fn admit(&self, argument: &Argument<'_, '_>, quantity: &document::Quantity) -> PyResult<()> {
        let numbers = argument.numbers.slice()?;
        if quantity.size == 1 && quantity.domain.contains(numbers) {
            return Ok(());
        }
        match numbers.chunks_exact(quantity.size).position(|value| !quantity.domain.contains(value)) {
            None => Ok(()),
            Some(at) => {
                let shape = argument.numbers.shape(quantity.size);
                let name = format!("{}{}", quantity.name, place(at, shape));
                Err(wrong(outside(quantity, &name, &numbers[at * quantity.size..][..quantity.size])))
            }
        }
    }
}

/// The axes of the components of a number, a vector or a tensor.
fn axes(size: usize) -> &'static [usize] {
    match size {
        1 => &[],
        9 => &[3, 3],
        _ => &[3],
    }
}

#[pymethods]
impl Equation {
    #[pyo3(signature = (*positional, check = true, **keywords))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        positional: &Bound<'py, PyTuple>,
        check: bool,
        keywords: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        caught(|| {
            let Entry { equation, document } = self.entry;
            let mut arguments = Vec::with_capacity(document.arguments.len());
            for (quantity, value) in document.arguments.iter().zip(self.bound(positional, keywords)?) {
                let (name, size) = (quantity.name.as_str(), quantity.size);
                let numbers = match value.cast::<PyString>() {
                    Ok(text) => Numbers::One(with_unit(quantity, &text.to_cow()?).map_err(wrong)?),
                    Err(_) => Numbers::of(&value, name, size)?,
                };
                let argument = Argument { name, size, numbers };
                if check {
                    self.admit(&argument, quantity)?;
                }
                arguments.push(argument);
            }
            let axes: Vec<&[usize]> = document.results.iter().map(|quantity| axes(quantity.size)).collect();
            let instructions = Instructions::best();
            let computed = over_columns(py, arguments, &axes, |arguments, results| {
                (equation.many.rows)(instructions, arguments, results);
            })?;
            if check && let Some((at, found)) = computed.first_not_finite() {
                let at = place(at, &computed.shape);
                let which = if at.is_empty() { "these arguments".into() } else { format!("the arguments at {at}") };
                return Err(wrong(self.entry.not_finite(&which, &found)));
            }
            let mut results = computed.into_python(py)?;
            if let [_] = results[..] {
                return Ok(results.remove(0));
            }
            let class = self.results.get_or_try_init(py, || {
                let names: Vec<&str> = document.results.iter().map(|quantity| quantity.name.as_str()).collect();
                let class = py.import("collections")?.call_method1("namedtuple", (equation.function, names))?;
                class.setattr("__module__", "veridem")?;
                PyResult::Ok(class.unbind())
            })?;
            class.bind(py).call1(PyTuple::new(py, results)?)
        })
    }

    fn __repr__(&self) -> String {
        let (id, function) = (self.entry.equation.id, self.entry.equation.function);
        format!("<equation {id}: {function}({})>", documentation::parameters(self.entry).join(", "))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (&'static str,))> {
        Ok((py.import("veridem")?.getattr("eq")?, (self.entry.equation.id,)))
    }

    /// The name of the function.
    #[getter]
    fn function(&self) -> &'static str {
        self.entry.equation.function
    }

    /// The documentation of the function: its table, its formula as printed and how that was read.
    #[getter]
    fn documentation(&self) -> String {
        documentation::of(self.entry)
    }

    /// The names of the arguments of a call.
    #[getter]
    fn parameters(&self) -> Vec<String> {
        documentation::parameters(self.entry)
    }

    /// Its name in the list, such as `wear-3`.
    #[getter]
    fn id(&self) -> &'static str {
        self.entry.equation.id
    }

    /// The paper, the part of the id before the first hyphen.
    #[getter]
    fn paper(&self) -> &'static str {
        self.entry.equation.id.split('-').next().unwrap_or_default()
    }

    /// The equation numbers of the paper that it carries.
    #[getter]
    fn numbers(&self) -> Vec<&'static str> {
        self.entry.equation.covers.to_vec()
    }

    /// Number, section, and what it is.
    #[getter]
    fn title(&self) -> String {
        documentation::plain(&self.entry.document.title)
    }

    /// The formula as printed, in TeX.
    #[getter]
    fn formula(&self) -> &'static str {
        &self.entry.document.formula
    }

    /// How the formula was read: errata, ambiguities and signs.
    #[getter]
    fn reading(&self) -> &'static str {
        &self.entry.document.reading
    }

    /// The arguments, in order.
    #[getter]
    fn arguments(&self) -> Vec<Quantity> {
        self.entry.document.arguments.iter().map(Quantity).collect()
    }

    /// The results, in order.
    #[getter]
    fn results(&self) -> Vec<Quantity> {
        self.entry.document.results.iter().map(Quantity).collect()
    }

    /// The names of the tests that verify it.
    #[getter]
    fn laws(&self) -> Vec<&'static str> {
        self.entry.document.laws.iter().map(String::as_str).collect()
    }

    /// The largest rounding error, in units of the last place.
    #[getter]
    fn rounding(&self) -> Option<f64> {
        self.entry.document.rounding
    }

    /// The source file.
    #[getter]
    fn source(&self) -> String {
        format!("spec/{}", self.entry.equation.file)
    }
}

/// An argument or result of an equation: a row of its table.
#[pyclass(frozen, module = "veridem")]
pub(crate) struct Quantity(&'static document::Quantity);

#[pymethods]
impl Quantity {
    /// The name of the argument or result.
    #[getter]
    fn name(&self) -> &'static str {
        &self.0.name
    }

    /// The symbol in the paper, in TeX.
    #[getter]
    fn symbol(&self) -> &'static str {
        &self.0.symbol
    }

    /// The unit.
    #[getter]
    fn unit(&self) -> &'static str {
        &self.0.unit
    }

    /// 1 for a number, 3 for a vector, 9 for a tensor.
    #[getter]
    fn size(&self) -> usize {
        self.0.size
    }

    /// The values that it may have, in words.
    #[getter]
    fn domain(&self) -> String {
        self.0.domain.to_string()
    }

    /// What it is.
    #[getter]
    fn meaning(&self) -> &'static str {
        &self.0.meaning
    }

    fn __repr__(&self) -> String {
        let document::Quantity { name, unit, domain, meaning, .. } = self.0;
        format!("<{name} in {unit}, {domain}: {meaning}>")
    }
}
