//! Equations.

use crate::error::{Done, border, wrong};
use crate::pointers::{columns, held_mut, text};
use std::ffi::{c_char, c_int};
use std::sync::OnceLock;
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Instructions;

/// The equation with this id.
fn equation(id: &str) -> Done<&'static Equation> {
    static ALL: OnceLock<Vec<Equation>> = OnceLock::new();
    let found = ALL.get_or_init(veridem_spec::equations).iter().find(|equation| equation.id == id);
    found.map_or_else(|| wrong(format!("there is no equation `{id}`; `veridem eq list` lists them")), Ok)
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_equation_shape(id: *const c_char, arguments: *mut usize, results: *mut usize) -> c_int {
    border(|| {
        // SAFETY: a text, and places for the results.
        let (id, arguments, results) =
            unsafe { (text(id)?, held_mut(arguments, "result")?, held_mut(results, "result")?) };
        let shape = (equation(id)?.shape)();
        (*arguments, *results) = (shape.arguments.iter().sum(), shape.results.iter().sum());
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_equation(
    id: *const c_char,
    length: usize,
    arguments: *const *const f64,
    argument_count: usize,
    results: *const *mut f64,
    result_count: usize,
) -> c_int {
    border(|| {
        // SAFETY: a text, and columns of this length.
        let (id, (arguments, mut results)) =
            unsafe { (text(id)?, columns(length, (arguments, argument_count), (results, result_count))?) };
        let equation = equation(id)?;
        let shape = (equation.shape)();
        let (needed, given): (usize, usize) = (shape.arguments.iter().sum(), shape.results.iter().sum());
        if (arguments.len(), results.len()) != (needed, given) {
            let found = format!("found {} columns of arguments and {} of results", arguments.len(), results.len());
            return wrong(format!("{id}: {found}, expected {needed} and {given}"));
        }
        (equation.many.rows)(Instructions::best(), &arguments, &mut results);
        Ok(())
    })
}
