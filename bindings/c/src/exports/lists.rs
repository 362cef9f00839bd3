//! Steps of a list of pairs.

use super::VeridemLaw;
use crate::error::{border, wrong};
use crate::list::{List, Neighbours};
use crate::pointers::{held, held_mut, lent, lent_mut};
use crate::spheres::{RawSpheres, Totals, spheres};
use std::ffi::c_int;

/// A list as the caller holds it.
struct VeridemList(Box<dyn List>);

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_new(law: *const VeridemLaw, list: *mut *mut VeridemList) -> c_int {
    border(|| {
        // SAFETY: a law, and a place for the result.
        let (law, out) = unsafe { (held(law, "law")?, held_mut(list, "result")?) };
        *out = Box::into_raw(Box::new(VeridemList(law.0.list())));
        Ok(())
    })
}

/// # Safety
///
/// Null, or a list that was not freed.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_free(list: *mut VeridemList) {
    if !list.is_null() {
        // SAFETY: it was made by `Box::into_raw`, and is freed once.
        drop(unsafe { Box::from_raw(list) });
    }
}

/// Rows of neighbours as LAMMPS keeps them: places of spheres, and by place the number of neighbours and where they are.
struct Rows<'a> {
    spheres: &'a [c_int],
    counts: &'a [c_int],
    rows: &'a [*const c_int],
    mask: c_int,
}

impl Neighbours for Rows<'_> {
    fn each(&self, show: &mut dyn FnMut(usize, &[c_int])) {
        for &p in self.spheres {
            let p = p as usize;
            // SAFETY: the caller promises that every row has as many neighbours as its count says.
            show(p, unsafe { lent(self.rows[p], self.counts[p] as usize) });
        }
    }
    fn mask(&self) -> c_int {
        self.mask
    }
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_build(
    list: *mut VeridemList,
    count: usize,
    owned: usize,
    id: *const c_int,
    row_count: usize,
    row_sphere: *const c_int,
    neighbour_count: *const c_int,
    neighbours: *const *const c_int,
    mask: c_int,
) -> c_int {
    border(|| {
        // SAFETY: a list, and the arrays of the neighbours of owned spheres.
        let (list, id, rows) = unsafe {
            let (counts, rows) = (lent(neighbour_count, owned), lent(neighbours, owned));
            let rows = Rows { spheres: lent(row_sphere, row_count), counts, rows, mask };
            (held_mut(list, "list")?, lent(id, count), rows)
        };
        if id.len() != count || owned > count || (row_count > 0 && rows.counts.is_empty()) {
            return wrong("an array of the neighbours is a null pointer, or there are more owned spheres than spheres");
        }
        if rows.spheres.iter().any(|&p| p < 0 || p as usize >= owned) {
            return wrong("a row of neighbours is not that of an owned sphere");
        }
        list.0.build((owned, id), &rows)
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_pairs(
    list: *mut VeridemList,
    count: *mut usize,
    i: *mut *const u32,
    j: *mut *const u32,
    history: *mut *mut f64,
) -> c_int {
    border(|| {
        // SAFETY: a list, and places for the results.
        let (list, count, i, j, history) = unsafe {
            let list = held_mut(list, "list")?;
            (
                list,
                held_mut(count, "result")?,
                held_mut(i, "result")?,
                held_mut(j, "result")?,
                held_mut(history, "result")?,
            )
        };
        let pairs = list.0.pairs();
        (*count, *i, *j) = (pairs[0].len(), pairs[0].as_ptr(), pairs[1].as_ptr());
        *history = list.0.history().as_mut_ptr();
        Ok(())
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_contacts(list: *mut VeridemList, raw: *mut RawSpheres, contacts: *mut f64) -> c_int {
    border(|| {
        // SAFETY: a list, spheres, and one number for each owned sphere.
        unsafe {
            let spheres = spheres(raw)?;
            let contacts = lent_mut(contacts, spheres.owned);
            if contacts.len() != spheres.owned {
                return wrong("the contacts are a null pointer");
            }
            held_mut(list, "list")?.0.count_contacts(&spheres, contacts)
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_forget(
    list: *mut VeridemList,
    raw: *mut RawSpheres,
    losses: *mut f64,
    loss_count: usize,
) -> c_int {
    border(|| {
        // SAFETY: a list, spheres, and sums of this length or null.
        unsafe { held_mut(list, "list")?.0.forget(&spheres(raw)?, lent_mut(losses, loss_count)) }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_overloaded(
    list: *mut VeridemList,
    raw: *mut RawSpheres,
    count: *mut usize,
    pairs: *mut *const u32,
) -> c_int {
    border(|| {
        // SAFETY: a list, spheres, and places for the results.
        unsafe {
            let (count, pairs) = (held_mut(count, "result")?, held_mut(pairs, "result")?);
            let found = held_mut(list, "list")?.0.overloaded(&spheres(raw)?)?;
            (*count, *pairs) = (found.len(), found.as_ptr());
            Ok(())
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_break(
    list: *mut VeridemList,
    raw: *mut RawSpheres,
    count: usize,
    pairs: *const u32,
    lost: *mut f64,
) -> c_int {
    border(|| {
        // SAFETY: a list, spheres, places of pairs, and a place for the result.
        unsafe {
            *held_mut(lost, "result")? += held_mut(list, "list")?.0.break_necks(&spheres(raw)?, lent(pairs, count))?;
            Ok(())
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_list_step(
    list: *mut VeridemList,
    raw: *mut RawSpheres,
    dt: f64,
    advance: c_int,
    losses: *mut f64,
    loss_count: usize,
    stored: *mut f64,
    stored_count: usize,
    virial: *mut f64,
) -> c_int {
    border(|| {
        // SAFETY: a list, spheres, and sums of these lengths or null.
        unsafe {
            let (losses, stored) = (lent_mut(losses, loss_count), lent_mut(stored, stored_count));
            let mut totals = Totals { losses, stored, virial: lent_mut(virial, 6) };
            held_mut(list, "list")?.0.step(&mut spheres(raw)?, &mut totals, dt, advance != 0)
        }
    })
}
