//! From the numbers of a file to spheres in nm.

use super::{Options, Raw, Source};
use crate::error::Error;
use crate::geometry::Sphere;
use crate::spec::Vec3;
use std::collections::BTreeMap;

/// Coordinates are at most this many radii: farther out single precision does not tell which spheres touch.
const FAR: f64 = 1e6;

/// The unit of length of a file, nm, and the spheres in nm.
pub(super) fn scaled(source: &Source, raw: &Raw, options: &Options) -> Result<(f64, Vec<Sphere>), Error> {
    let (unit, own) = units(source, raw, options)?;
    let spheres = raw.spheres(source, unit, own)?;
    source.interrupt.check()?;
    match coinciding(&spheres) {
        Some([k, other]) => {
            Err(source.at(raw.lines[k], &format!("found the centre of the sphere in line {} again", raw.lines[other])))
        }
        None => Ok((unit, spheres)),
    }
}

/// The unit of length of a file, nm, and the radius of its spheres if it has none.
pub(super) fn units(source: &Source, raw: &Raw, options: &Options) -> Result<(f64, Option<f64>), Error> {
    let missing = |key: &str, what: &str| Err(source.problem(None, key, what));
    for (key, value) in [("unit", options.unit), ("radius", options.radius)] {
        if value.is_some_and(|value| !(value > 0.0 && value.is_finite())) {
            return missing(key, "expected a length above 0");
        }
    }
    if raw.centres.is_empty() {
        return Err(Error::input(source.file, "found no spheres"));
    }
    let known = !raw.radii.is_empty();
    let equal = raw.radii.windows(2).all(|pair| pair[0] == pair[1]);
    let unit = match (options.unit, options.radius) {
        (Some(_), Some(_)) if known || raw.in_radii => {
            return missing(
                "radius",
                "found `unit` and `radius`, expected only one of them: the file defines their ratio",
            );
        }
        (Some(unit), _) => unit,
        (None, Some(radius)) if known && equal => radius / raw.radii[0],
        (None, Some(radius)) if raw.in_radii && !known => radius,
        (None, Some(_)) if known => {
            return missing("unit", "is missing, expected the unit of length of the file: its radii differ");
        }
        _ if raw.in_radii => {
            return missing(
                "radius",
                "is missing, expected the radius of the spheres, which is the unit of length of the file",
            );
        }
        _ => return missing("unit", "is missing, expected the unit of length of the file, such as `1 nm`"),
    };
    let own = match (known, raw.in_radii, options.radius) {
        (true, ..) => None,
        (false, true, _) => Some(unit),
        (false, false, Some(radius)) => Some(radius),
        _ => {
            return missing(
                "radius",
                "is missing, expected the radius of the spheres: an XYZ file gives it in a fifth and last column, or in a column named by `Properties`, a CSV file in a fourth, or in a column `r`",
            );
        }
    };
    Ok((unit, own))
}

/// Two spheres with the same centre, the later first.
fn coinciding(spheres: &[Sphere]) -> Option<[usize; 2]> {
    let mut order: Vec<usize> = (0..spheres.len()).collect();
    // Zero has two signs.
    let place = |k: usize| spheres[k].centre.0.map(|x| x + 0.0);
    let compare = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| a[k].total_cmp(&b[k])).find(|order| order.is_ne());
    order.sort_by(|&a, &b| compare(place(a), place(b)).unwrap_or(a.cmp(&b)));
    order.windows(2).find(|pair| place(pair[0]) == place(pair[1])).map(|pair| [pair[1], pair[0]])
}

/// Centres of similar spheres in a cube of the size of a radius beyond which a file is refused: they cannot be an aggregate, and the
/// number of their pairs would grow with the square of theirs.
const CROWD: usize = 27;

/// A sphere among too many others.
fn crowded(spheres: &[Sphere]) -> Option<usize> {
    let mut cells = BTreeMap::new();
    spheres.iter().position(|sphere| {
        let octave = f64::from(libm::ilogb(sphere.radius));
        let side = libm::exp2(octave);
        let cell = sphere.centre.0.map(|x| (x / side).floor() as i64);
        let count: &mut usize = cells.entry((octave as i64, cell)).or_default();
        *count += 1;
        *count > CROWD
    })
}

impl Raw {
    /// The spheres in another unit, and of a radius in that unit where the file has none.
    pub(super) fn spheres(&self, source: &Source, unit: f64, own: Option<f64>) -> Result<Vec<Sphere>, Error> {
        let sphere = |k: usize| {
            let centre = Vec3(self.centres[k].map(|x| x * unit));
            let radius = own.unwrap_or_else(|| self.radii[k] * unit);
            match centre.0.iter().find(|x| x.abs() > FAR * radius) {
                Some(x) => {
                    let what = format!("found a coordinate of {:e} radii, expected at most {FAR:e}", x / radius);
                    Err(source.at(self.lines[k], &what))
                }
                None => Ok(Sphere { centre, radius }),
            }
        };
        let spheres: Vec<Sphere> = (0..self.centres.len()).map(sphere).collect::<Result<_, _>>()?;
        match crowded(&spheres) {
            Some(k) => {
                let what = format!(
                    "found the centres of {CROWD} other spheres within a radius of {:e} nm, expected an aggregate: unit and radius do not fit",
                    spheres[k].radius
                );
                Err(source.at(self.lines[k], &what))
            }
            None => Ok(spheres),
        }
    }
}
