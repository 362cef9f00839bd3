//! The spheres of a caller, and the sums over a step: structures of the header.

use crate::error::{Done, wrong};
use crate::pointers::{lent, lent_mut};
use std::ffi::c_int;

/// The version of the structures and functions of the header.
pub(crate) const ABI: u32 = 2;

/// `veridem_spheres`.
#[repr(C)]
pub(crate) struct RawSpheres {
    abi: u32,
    bytes: u32,
    count: usize,
    owned: usize,
    x: *const f64,
    v: *const f64,
    omega: *const f64,
    radius: *const f64,
    mass: *const f64,
    id: *const i32,
    force: *mut f64,
    torque: *mut f64,
    moment: *const f64,
    contacts: *const f64,
}

/// The spheres: first those that the caller owns, then ghosts.
pub(crate) struct Spheres<'a> {
    pub owned: usize,
    pub x: &'a [[f64; 3]],
    pub v: &'a [[f64; 3]],
    pub omega: &'a [[f64; 3]],
    pub radius: &'a [f64],
    pub mass: &'a [f64],
    pub id: &'a [c_int],
    pub force: &'a mut [[f64; 3]],
    pub torque: &'a mut [[f64; 3]],
    /// Least moment of inertia of the body of each sphere, zero for one without, 1e300 or more for one that cannot turn; empty if the caller
    /// gives none.
    pub moment: &'a [f64],
    /// Number of contacts that share it.
    pub contacts: &'a [f64],
}

/// The spheres that a caller describes.
///
/// # Safety
///
/// As the header says: a null pointer, or a structure whose arrays hold `count` spheres and are not used otherwise during the call.
pub(crate) unsafe fn spheres<'a>(raw: *mut RawSpheres) -> Done<Spheres<'a>> {
    // SAFETY: null, or a structure of at least two numbers of 32 bits.
    let Some(head) = (unsafe { raw.cast::<[u32; 2]>().as_ref() }) else {
        return wrong("the spheres are a null pointer");
    };
    let expected = [ABI, size_of::<RawSpheres>() as u32];
    if *head != expected {
        let [abi, bytes] = *head;
        let [our_abi, our_bytes] = expected;
        return wrong(format!(
            "the spheres are those of ABI {abi} with {bytes} bytes, expected ABI {our_abi} with {our_bytes} bytes"
        ));
    }
    // SAFETY: the structure is the one of this version.
    let raw = unsafe { &*raw };
    let count = raw.count;
    if raw.owned > count {
        return wrong(format!("found {} owned spheres of {count}", raw.owned));
    }
    let needed = [raw.x, raw.v, raw.omega, raw.radius, raw.mass].iter().any(|array| array.is_null());
    if count > 0 && (needed || raw.id.is_null() || raw.force.is_null() || raw.torque.is_null()) {
        return wrong("an array of the spheres is a null pointer");
    }
    if raw.moment.is_null() != raw.contacts.is_null() {
        return wrong("`moment` and `contacts` are given together or not at all");
    }
    // SAFETY: the arrays hold `count` spheres, and nothing else uses them during the call.
    unsafe {
        Ok(Spheres {
            owned: raw.owned,
            x: lent(raw.x.cast(), count),
            v: lent(raw.v.cast(), count),
            omega: lent(raw.omega.cast(), count),
            radius: lent(raw.radius, count),
            mass: lent(raw.mass, count),
            id: lent(raw.id, count),
            force: lent_mut(raw.force.cast(), count),
            torque: lent_mut(raw.torque.cast(), count),
            moment: lent(raw.moment, count),
            contacts: lent(raw.contacts, count),
        })
    }
}

/// Sums over the pairs of a step; each is left out if it is empty.
pub(crate) struct Totals<'a> {
    /// Energies lost, by cause.
    pub losses: &'a mut [f64],
    /// Energies stored, by cause.
    pub stored: &'a mut [f64],
    /// Branch vector times force: xx, yy, zz, xy, xz, yz.
    pub virial: &'a mut [f64],
}
