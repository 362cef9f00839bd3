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

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;
    use crate::interrupt::Interrupt;
    use std::path::Path;

    /// The radius and the first coordinate of the last sphere.
    fn last(text: &str, unit: Option<f64>, radius: Option<f64>) -> Result<(f64, f64), String> {
        let options = Options { format: None, unit, radius, disconnected: true };
        let found = parse(Path::new("a"), text, &options, &Interrupt::default()).map_err(|error| error.to_string())?;
        let last = found.spheres.last().expect("a sphere");
        Ok((last.radius, last.centre.0[0]))
    }

    /// Radii that are equal, that differ, none, and coordinates in radii with and without them.
    const EQUAL: &str = "2\n\nC 0 0 0 2\nC 4 0 0 2\n";
    const OTHERS: &str = "2\n\nC 0 0 0 2\nC 4 0 0 1\n";
    const NONE: &str = "2\n\nC 0 0 0\nC 4 0 0\n";
    const IN_RADII: &str =
        "<g><particle><position>0 0 0</position></particle><particle><position>4 0 0</position></particle></g>";
    const AND_SIZES: &str = "<g><particle><position>4 0 0</position><radius>2</radius></particle></g>";

    const BOTH_SIZES: &str = "<g><particle><position>0 0 0</position><radius>1</radius></particle>\
        <particle><position>4 0 0</position><radius>2</radius></particle></g>";

    #[test]
    fn unit_and_radius_scale_what_the_file_leaves_open() {
        for (text, unit, radius, expected) in [
            (EQUAL, Some(3.0), None, (6.0, 12.0)),
            (EQUAL, None, Some(3.0), (3.0, 6.0)),
            (OTHERS, Some(3.0), None, (3.0, 12.0)),
            (NONE, Some(3.0), Some(5.0), (5.0, 12.0)),
            (IN_RADII, None, Some(3.0), (3.0, 12.0)),
            (IN_RADII, Some(3.0), None, (3.0, 12.0)),
            (AND_SIZES, Some(3.0), None, (6.0, 12.0)),
            (AND_SIZES, None, Some(3.0), (3.0, 6.0)),
        ] {
            assert_eq!(last(text, unit, radius), Ok(expected), "{text} {unit:?} {radius:?}");
        }
    }

    #[test]
    fn what_is_missing_or_given_twice_is_named() {
        let (three, twice) = (Some(3.0), "a: radius: found `unit` and `radius`, expected only one of them");
        for (text, unit, radius, expected) in [
            (EQUAL, three, three, twice),
            (OTHERS, three, three, twice),
            (IN_RADII, three, three, twice),
            (OTHERS, None, three, "a: unit: is missing, expected the unit of length of the file: its radii differ"),
            (BOTH_SIZES, None, three, "a: unit: is missing, expected the unit of length of the file: its radii differ"),
            (EQUAL, None, None, "a: unit: is missing, expected the unit of length of the file, such as `1 nm`"),
            (NONE, None, three, "a: unit: is missing, expected the unit of length of the file, such as `1 nm`"),
            (NONE, three, None, "a: radius: is missing, expected the radius of the spheres: an XYZ file"),
            (IN_RADII, None, None, "a: radius: is missing, expected the radius of the spheres, which is the unit"),
            ("0\n\n", three, None, "a: found no spheres"),
            (EQUAL, Some(0.0), None, "a: unit: expected a length above 0"),
            (EQUAL, Some(f64::INFINITY), None, "a: unit: expected a length above 0"),
            (NONE, three, Some(-1.0), "a: radius: expected a length above 0"),
            (NONE, three, Some(f64::NAN), "a: radius: expected a length above 0"),
        ] {
            let trouble = last(text, unit, radius).unwrap_err();
            assert!(trouble.starts_with(expected), "{text} {unit:?} {radius:?}: {trouble}");
        }
    }

    #[test]
    fn coordinates_are_at_most_a_million_radii() {
        let far = |coordinate: &str| last(&format!("1\n\nC {coordinate} 0 0 4\n"), Some(0.5), None);
        assert_eq!([far("4e6"), far("-4e6")], [Ok((2.0, 2e6)), Ok((2.0, -2e6))]);
        let trouble = |found: &str| Err(format!("a:3: found a coordinate of {found} radii, expected at most 1e6"));
        assert_eq!([far("5e6"), far("-5e6")], [trouble("1.25e6"), trouble("-1.25e6")]);
    }

    #[test]
    fn a_centre_is_that_of_one_sphere() {
        let rows = |rows: &str| last(&format!("{}\n\n{rows}", rows.lines().count()), Some(1.0), None);
        let again =
            |k: usize, other: usize| Err(format!("a:{k}: found the centre of the sphere in line {other} again"));
        assert_eq!(rows("C 5 0 0 1\nC 1 2 3 1\nC 9 9 9 1\nC 1 2 3 4\n"), again(6, 4));
        assert_eq!(rows("C 0 -0.0 7 1\nC 0 0.0 7 1\nC 0 0 7 1\n"), again(4, 3));
        assert_eq!(rows("C 1 2 3 1\nC 1 2 3 4\n"), again(4, 3));
        assert!(rows("C 1e-20 0 0 1\nC 2e-20 0 0 1\n").is_ok());
        for other in ["1 2 4", "1 3 3", "2 2 3"] {
            assert_eq!(rows(&format!("C 1 2 3 1\nC {other} 4\n")).map(|(radius, _)| radius), Ok(4.0));
        }
    }

    #[test]
    fn twenty_seven_similar_spheres_share_a_cube_of_their_size_and_no_more() {
        // Radii from 2 to 4 share cubes of side 2; the first cube holds the spheres at 0 to 1.9, the next those from 2 on.
        let rows = |number: usize, more: &str| {
            let rows: String =
                (0..number).map(|k| format!("C {} 0 1 {}\n", k as f64 * 0.07, 2.0 + k as f64 * 0.07)).collect();
            last(&format!("{}\n\n{rows}{more}", number + more.lines().count()), Some(1.0), None)
        };
        assert_eq!(rows(27, "").map(|_| ()), Ok(()));
        let what = "found the centres of 27 other spheres within a radius of 3e0 nm, expected an aggregate: unit and radius do not fit";
        assert_eq!(rows(27, "C 1.95 1.5 0.5 3\n"), Err(format!("a:30: {what}")));
        // Beside, below, in another octave.
        for more in ["C 2 0 0 3\n", "C 1 -0.1 0 3\n", "C 1 0.1 0 1.9\n", "C 1 0.1 0 4\n"] {
            assert!(rows(27, more).is_ok(), "{more}");
        }
    }
}
