//! The functions of `veridem.h`, where they are documented: thin translations between pointers and the kernels.

mod columns;
mod error;
mod law;
mod laws;
mod list;
mod motion;
mod plane;
mod spheres;
mod words;

use columns::Columns;
use error::{Done, border, wrong};
use law::Law;
use list::{List, Neighbours};
use plane::Plane;
use spheres::{ABI, RawSpheres, Totals, lent, lent_mut, spheres};
use std::ffi::{CStr, c_char, c_int};
use std::sync::OnceLock;
use veridem_spec::Vec3;
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Instructions;

/// A law as the caller holds it.
struct VeridemLaw(Box<dyn Law>);

/// A list as the caller holds it.
struct VeridemList(Box<dyn List>);

/// What a pointer points to.
///
/// # Safety
///
/// The pointer is null, or what a function of this library returned and was not freed.
unsafe fn held<'a, T>(pointer: *const T, what: &str) -> Done<&'a T> {
    // SAFETY: the promise of the caller.
    unsafe { pointer.as_ref() }.map_or_else(|| wrong(format!("the {what} is a null pointer")), Ok)
}

/// The same to be changed.
///
/// # Safety
///
/// As for [`held`], and no other call uses it meanwhile.
unsafe fn held_mut<'a, T>(pointer: *mut T, what: &str) -> Done<&'a mut T> {
    // SAFETY: the promise of the caller.
    unsafe { pointer.as_mut() }.map_or_else(|| wrong(format!("the {what} is a null pointer")), Ok)
}

/// The text of a caller.
///
/// # Safety
///
/// The pointer is null, or points to a text that ends with zero.
unsafe fn text<'a>(pointer: *const c_char) -> Done<&'a str> {
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
unsafe fn vector(pointer: *const f64) -> Done<Vec3<f64>> {
    // SAFETY: the promise of the caller.
    unsafe { held(pointer.cast::<[f64; 3]>(), "vector") }.map(|&numbers| Vec3(numbers))
}

#[unsafe(no_mangle)]
extern "C" fn veridem_abi() -> u32 {
    ABI
}

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

/// Columns of a caller.
///
/// # Safety
///
/// Pointers to columns of `length` numbers, the results used by nothing else during the call.
unsafe fn columns<'a>(
    length: usize,
    (arguments, argument_count): (*const *const f64, usize),
    (results, result_count): (*const *mut f64, usize),
) -> Done<(Vec<&'a [f64]>, Vec<&'a mut [f64]>)> {
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

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_plane_step(
    law: *const VeridemLaw,
    raw: *mut RawSpheres,
    material: usize,
    point: *const f64,
    normal: *const f64,
    velocity: *const f64,
    history: *mut f64,
    dt: f64,
    advance: c_int,
    force: *mut f64,
    losses: *mut f64,
    loss_count: usize,
    stored: *mut f64,
    stored_count: usize,
) -> c_int {
    border(|| {
        // SAFETY: a law, spheres, vectors, the history of all owned spheres, and sums of these lengths or null.
        unsafe {
            let (law, mut spheres) = (held(law, "law")?, spheres(raw)?);
            if law.0.plane_range(material, 1.0).is_none() {
                return wrong("this law has no such surface");
            }
            let width = law.0.history().len() - 1;
            let mut plane = Plane {
                material,
                point: vector(point)?,
                normal: vector(normal)?,
                velocity: vector(velocity)?,
                history: lent_mut(history, width * spheres.owned),
                force: vector(force)?,
                dt,
                advance: advance != 0,
            };
            let (losses, stored) = (lent_mut(losses, loss_count), lent_mut(stored, stored_count));
            law.0.plane(&mut plane, &mut spheres, &mut Totals { losses, stored, virial: &mut [] })?;
            *held_mut(force.cast::<[f64; 3]>(), "force")? = plane.force.0;
            Ok(())
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_advance(
    count: usize,
    x: *mut f64,
    v: *mut f64,
    omega: *mut f64,
    radius: *const f64,
    mass: *const f64,
    force: *const f64,
    torque: *const f64,
    moves: *const c_int,
    damping: f64,
    dt: f64,
    drag: *mut f64,
) -> c_int {
    border(|| {
        if [x.cast_const(), v, omega, radius, mass, force, torque].iter().any(|array| array.is_null())
            || moves.is_null()
        {
            return wrong("an array of the motion is a null pointer");
        }
        // SAFETY: arrays of `count` spheres that do not overlap, and a place for the result.
        unsafe {
            let spheres = motion::Moving {
                x: lent_mut(x.cast(), count),
                v: lent_mut(v.cast(), count),
                omega: lent_mut(omega.cast(), count),
                radius: lent(radius, count),
                mass: lent(mass, count),
                force: lent(force.cast(), count),
                torque: lent(torque.cast(), count),
                moves: lent(moves, count),
            };
            *held_mut(drag, "result")? += motion::advance(spheres, damping, dt);
            Ok(())
        }
    })
}

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
