//! The Python package `veridem`: what the library offers, over numpy arrays.
//!
//! Nothing is computed here: arrays are taken apart into columns for the loops of the specification, and errors become exceptions.

mod aggregates;
mod arrays;
mod cases;
mod columns;
mod documentation;
mod equation;
mod errors;
mod law;
mod laws;
mod runs;
mod simulation;
mod system;
mod work;

use pyo3::prelude::*;

#[global_allocator]
static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;

/// The compiled part of the package.
#[pymodule]
fn _veridem(module: &Bound<'_, PyModule>) -> PyResult<()> {
    errors::keep_quiet();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<equation::Equation>()?;
    module.add_class::<equation::Quantity>()?;
    module.add_class::<law::Law>()?;
    module.add_class::<simulation::PySimulation>()?;
    module.add_function(wrap_pyfunction!(equation::all_equations, module)?)?;
    module.add_function(wrap_pyfunction!(equation::id_of, module)?)?;
    module.add_function(wrap_pyfunction!(cases::yaml_of, module)?)?;
    module.add_function(wrap_pyfunction!(cases::check, module)?)?;
    module.add_function(wrap_pyfunction!(cases::run, module)?)?;
    module.add_function(wrap_pyfunction!(cases::resume, module)?)?;
    module.add_function(wrap_pyfunction!(cases::sweep, module)?)?;
    module.add_function(wrap_pyfunction!(runs::summary, module)?)?;
    module.add_function(wrap_pyfunction!(runs::files, module)?)?;
    module.add_function(wrap_pyfunction!(runs::stages, module)?)?;
    module.add_function(wrap_pyfunction!(runs::table, module)?)?;
    module.add_function(wrap_pyfunction!(runs::events, module)?)?;
    module.add_function(wrap_pyfunction!(runs::results, module)?)?;
    module.add_function(wrap_pyfunction!(runs::frame_files, module)?)?;
    module.add_function(wrap_pyfunction!(runs::frame, module)?)?;
    module.add_function(wrap_pyfunction!(arrays::numbers, module)?)?;
    module.add_function(wrap_pyfunction!(aggregates::grow, module)?)?;
    module.add_function(wrap_pyfunction!(aggregates::import, module)?)?;
    module.add_function(wrap_pyfunction!(aggregates::shape, module)?)?;
    module.add_function(wrap_pyfunction!(aggregates::neck_pairs, module)?)?;
    module.add_function(wrap_pyfunction!(aggregates::write, module)?)
}
