//! Contact laws.

use super::VeridemLaw;
use crate::columns::Columns;
use crate::error::{Done, border, wrong};
use crate::laws;
use crate::pointers::{columns, held, held_mut, lent, lent_mut, text};
use std::ffi::{c_char, c_int};
use veridem_spec::necked::EXAMINED;

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_new(
    name: *const c_char,
    words: *const *const c_char,
    word_count: usize,
    radii: *const f64,
    radius_count: usize,
    law: *mut *mut VeridemLaw,
) -> c_int {
    border(|| {
        // SAFETY: texts, words and radii are those of the caller, who waits for this call.
        let (name, words, radii, out) = unsafe {
            let words: Done<Vec<&str>> = lent(words, word_count).iter().map(|&word| text(word)).collect();
            (text(name)?, words?, lent(radii, radius_count), held_mut(law, "result")?)
        };
        if radii.windows(2).any(|pair| pair[0] >= pair[1]) || radii.iter().any(|r| !(r.is_finite() && *r > 0.0)) {
            return wrong("radii: expected numbers above 0, each once, in ascending order");
        }
        *out = Box::into_raw(Box::new(VeridemLaw(laws::named(name, &words, radii)?)));
        Ok(())
    })
}

/// # Safety
///
/// Null, or a law that was not freed.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_free(law: *mut VeridemLaw) {
    if !law.is_null() {
        // SAFETY: it was made by `Box::into_raw`, and is freed once.
        drop(unsafe { Box::from_raw(law) });
    }
}

fn names(law: &VeridemLaw, what: c_int) -> Done<Vec<String>> {
    match what {
        0 => Ok(law.0.history()),
        1 => Ok(law.0.losses()),
        2 => Ok(law.0.stored()),
        _ => wrong(format!("found {what}, expected one of VERIDEM_HISTORY, VERIDEM_LOSSES and VERIDEM_STORED")),
    }
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_count(law: *const VeridemLaw, what: c_int, count: *mut usize) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(count, "result")? = names(held(law, "law")?, what)?.len();
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_name(
    law: *const VeridemLaw,
    what: c_int,
    place: usize,
    buffer: *mut c_char,
    bytes: usize,
) -> c_int {
    border(|| {
        // SAFETY: a law, and a buffer of this length.
        let (law, buffer) = unsafe { (held(law, "law")?, lent_mut(buffer.cast::<u8>(), bytes)) };
        let names = names(law, what)?;
        let Some(name) = names.get(place) else { return wrong(format!("found place {place} of {}", names.len())) };
        if buffer.len() <= name.len() {
            return wrong(format!("a buffer of {bytes} bytes is too short for `{name}`"));
        }
        buffer[..name.len()].copy_from_slice(name.as_bytes());
        buffer[name.len()] = 0;
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_range(law: *const VeridemLaw, r_i: f64, r_j: f64, range: *mut f64) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(range, "result")? = held(law, "law")?.0.range(r_i, r_j);
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_time_step(
    law: *const VeridemLaw,
    r: f64,
    m: f64,
    largest: f64,
    dt: *mut f64,
) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(dt, "result")? = held(law, "law")?.0.critical_time_step(r, m, largest);
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_shares_inertia(law: *const VeridemLaw, shares: *mut c_int) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(shares, "result")? = c_int::from(held(law, "law")?.0.friction_stops());
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_forgets(law: *const VeridemLaw, forgets: *mut c_int) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(forgets, "result")? = c_int::from(held(law, "law")?.0.forgets());
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_neck_checks(law: *const VeridemLaw, every: *mut u64) -> c_int {
    // SAFETY: a law, and a place for the result.
    border(|| unsafe {
        *held_mut(every, "result")? = if held(law, "law")?.0.necks_break() { EXAMINED } else { 0 };
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_law_pairs(
    law: *const VeridemLaw,
    length: usize,
    arguments: *const *const f64,
    argument_count: usize,
    results: *const *mut f64,
    result_count: usize,
    dt: f64,
) -> c_int {
    border(|| {
        // SAFETY: a law and columns of this length.
        let (law, (arguments, mut results)) =
            unsafe { (held(law, "law")?, columns(length, (arguments, argument_count), (results, result_count))?) };
        law.0.evaluate(&mut Columns { arguments: &arguments, results: &mut results }, dt)
    })
}
