//! The Python package `veridem`: what the library offers, over numpy arrays.
//!
//! Nothing is computed here: arrays are taken apart into columns for the loops of the specification, and errors become exceptions.

mod arrays;
mod columns;
mod documentation;
mod equation;
mod errors;

use pyo3::prelude::*;

/// The compiled part of the package.
#[pymodule]
fn _veridem(module: &Bound<'_, PyModule>) -> PyResult<()> {
    errors::keep_quiet();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<equation::Equation>()?;
    module.add_class::<equation::Quantity>()?;
    module.add_function(wrap_pyfunction!(equation::all_equations, module)?)?;
    module.add_function(wrap_pyfunction!(equation::id_of, module)?)
}
