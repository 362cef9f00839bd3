//! What the pointers of a caller point to.

use crate::error::{Done, wrong};
use std::ffi::{CStr, c_char};
use veridem_spec::Vec3;

/// Columns of arguments and of results.
pub(crate) type Lent<'a> = (Vec<&'a [f64]>, Vec<&'a mut [f64]>);

/// What a pointer points to.
///
/// # Safety
///
/// The pointer is null, or what a function of this library returned and was not freed.
pub(crate) unsafe fn held<'a, T>(pointer: *const T, what: &str) -> Done<&'a T> {
    // SAFETY: the promise of the caller.
    unsafe { pointer.as_ref() }.map_or_else(|| wrong(format!("the {what} is a null pointer")), Ok)
}

/// The same to be changed.
///
/// # Safety
///
/// As for [`held`], and no other call uses it meanwhile.
pub(crate) unsafe fn held_mut<'a, T>(pointer: *mut T, what: &str) -> Done<&'a mut T> {
    // SAFETY: the promise of the caller.
    unsafe { pointer.as_mut() }.map_or_else(|| wrong(format!("the {what} is a null pointer")), Ok)
}

/// The text of a caller.
///
/// # Safety
///
/// The pointer is null, or points to a text that ends with zero.
pub(crate) unsafe fn text<'a>(pointer: *const c_char) -> Done<&'a str> {
    if pointer.is_null() {
        return wrong("a text is a null pointer");
    }
    // SAFETY: the promise of the caller.
    unsafe { CStr::from_ptr(pointer) }.to_str().or_else(|_| wrong("a text is not UTF-8"))
}

/// Vector of three numbers of the caller.
///
/// # Safety
///
/// The pointer is null, or points to three numbers.
pub(crate) unsafe fn vector(pointer: *const f64) -> Done<Vec3<f64>> {
    // SAFETY: the promise of the caller.
    unsafe { held(pointer.cast::<[f64; 3]>(), "vector") }.map(|&numbers| Vec3(numbers))
}

/// A slice that the caller lends; empty for a null pointer.
///
/// # Safety
///
/// The pointer is null, or points to `count` values that live and are not changed for as long as the result is used.
pub(crate) unsafe fn lent<'a, T>(pointer: *const T, count: usize) -> &'a [T] {
    // SAFETY: the promise of the caller.
    if pointer.is_null() || count == 0 { &[] } else { unsafe { std::slice::from_raw_parts(pointer, count) } }
}

/// The same to be written.
///
/// # Safety
///
/// As for [`lent`], and nothing else reads or writes the values meanwhile.
pub(crate) unsafe fn lent_mut<'a, T>(pointer: *mut T, count: usize) -> &'a mut [T] {
    // SAFETY: the promise of the caller.
    if pointer.is_null() || count == 0 { &mut [] } else { unsafe { std::slice::from_raw_parts_mut(pointer, count) } }
}

/// Columns of a caller.
///
/// # Safety
///
/// Pointers to columns of `length` numbers, the results used by nothing else during the call.
pub(crate) unsafe fn columns<'a>(
    length: usize,
    (arguments, argument_count): (*const *const f64, usize),
    (results, result_count): (*const *mut f64, usize),
) -> Done<Lent<'a>> {
    // SAFETY: the promise of the caller.
    let (from, to) = unsafe { (lent(arguments, argument_count), lent(results, result_count)) };
    if from.iter().any(|column| column.is_null()) || to.iter().any(|column| column.is_null()) {
        return wrong("a column is a null pointer");
    }
    // SAFETY: the promise of the caller.
    let arguments = from.iter().map(|&column| unsafe { lent(column, length) }).collect();
    // SAFETY: the promise of the caller.
    let results = to.iter().map(|&column| unsafe { lent_mut(column, length) }).collect();
    Ok((arguments, results))
}
