//! Aggregates from other programs: FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem, LAMMPS, XYZ.

mod columns;
mod flage;
mod lammps;
mod report;
mod vtk;

pub use report::Report;
pub use vtk::{parse_necks, read_necks};

use crate::case::section::words;
use crate::case::unmarked;
use crate::error::{Error, Problem, read_file};
use crate::geometry::Sphere;
use crate::initial::aggregate::components;
use crate::initial::foreign;
use crate::spec::Vec3;
use std::collections::BTreeMap;
use std::path::Path;

words! {
    /// Who wrote the file.
    pub enum Format {
        /// XML with `position` elements, in monomer radii.
        Flage = "flage",
        /// Rows `r x y z`, perhaps with a refractive index, as of MSTM up to version 3.
        Mstm = "mstm",
        /// Rows `x y z r`, perhaps with a refractive index, as of MSTM 4.
        FracVal = "fracval",
        /// Rows `x y z r` below a header of comments.
        PyFracVal = "pyfracval",
        /// Legacy VTK points of soot-dem, in monomer radii.
        Vtk = "vtk",
        /// A data file with a section `Atoms # sphere`.
        Lammps = "lammps",
        /// A number, a comment, rows `species x y z`, perhaps with a radius.
        Xyz = "xyz",
    }
}

/// What the file does not say.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// The format, if the content does not identify it.
    pub format: Option<Format>,
    /// The unit of length of the file, nm.
    pub unit: Option<f64>,
    /// The radius of all spheres, nm.
    pub radius: Option<f64>,
    /// Whether spheres that do not form one connected aggregate are accepted.
    pub disconnected: bool,
}

/// What was read.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Who wrote it.
    pub format: Format,
    /// The spheres, nm.
    pub spheres: Vec<Sphere>,
    /// What they look like.
    pub report: Report,
    /// Most decimals of a coordinate in the file; an exponent counts as many.
    pub decimals: usize,
}

/// Coordinates are at most this many radii: farther out single precision does not tell which spheres touch.
const FAR: f64 = 1e6;

/// The numbers of a file, in its own units.
#[derive(Debug, Default)]
struct Raw {
    centres: Vec<[f64; 3]>,
    /// Where each centre is in the file.
    lines: Vec<usize>,
    /// One for each sphere, or none at all.
    radii: Vec<f64>,
    /// Whether the unit of length is the radius of a sphere.
    in_radii: bool,
    /// Most decimals of a coordinate; an exponent counts as many.
    decimals: usize,
}

/// Reads an aggregate.
///
/// # Errors
///
/// If the file cannot be read, and all that [`parse`] finds.
pub fn read(file: &Path, options: &Options) -> Result<Imported, Error> {
    parse(file, &read_file(file)?, options)
}

/// The text of a file without the mark of its encoding. What is no UTF-8, as an accent in a comment may be, is replaced.
fn text_of(file: &Path, bytes: &[u8]) -> Result<String, Error> {
    if let Some(known) = foreign::recognised(bytes) {
        return Err(Error::input(file, format!("found {known}")));
    }
    let text = String::from_utf8_lossy(bytes);
    Ok(unmarked(&text).into())
}

/// Reads an aggregate from the content of a file.
///
/// # Errors
///
/// The first line that cannot be read, or spheres that overlap, coincide or are disconnected.
pub fn parse(file: &Path, content: impl AsRef<[u8]>, options: &Options) -> Result<Imported, Error> {
    let source = Source { file, text: &text_of(file, content.as_ref())? };
    let format = match options.format {
        Some(format) => format,
        None => detect(&source)?,
    };
    let raw = match format {
        Format::Flage => flage::read(&source)?,
        Format::Vtk => vtk::read(&source)?,
        Format::Lammps => lammps::read(&source)?,
        Format::Xyz => columns::xyz(&source)?,
        Format::Mstm => columns::rows(&source, true)?,
        Format::FracVal | Format::PyFracVal => columns::rows(&source, false)?,
    };
    let spheres = scaled(&source, &raw, options)?;
    let parts = components(&spheres);
    if parts > 1 && !options.disconnected {
        let what = format!("found {parts} parts that do not touch, expected one; `disconnected` accepts them");
        return Err(Error::input(file, what));
    }
    Ok(Imported { format, report: Report::of(&spheres, parts), spheres, decimals: raw.decimals })
}

/// The spheres as extended XYZ with all their digits, nm.
pub fn extended_xyz(spheres: &[Sphere]) -> String {
    let row = |Sphere { centre: Vec3([x, y, z]), radius }: &Sphere| format!("X {x} {y} {z} {radius}\n");
    let rows: String = spheres.iter().map(row).collect();
    format!("{}\nProperties=species:S:1:pos:R:3:radius:R:1\n{rows}", spheres.len())
}

/// Who wrote a file, by its content.
fn detect(source: &Source) -> Result<Format, Error> {
    let text = source.text.trim_start();
    if text.starts_with('<') {
        return Ok(Format::Flage);
    }
    if text.starts_with("# vtk DataFile") {
        return Ok(Format::Vtk);
    }
    let mut lines = source.lines().filter(|(_, line)| !line.is_empty());
    // The first line of LAMMPS data is a title, the second line of XYZ a comment: both may be any text.
    let counts_spheres = lines.clone().next().is_some_and(|(_, line)| line.parse::<usize>().is_ok());
    if lammps::section(source).is_some() && (!counts_spheres || lammps::announced(source).is_some()) {
        return Ok(Format::Lammps);
    }
    if lines
        .clone()
        .any(|(_, line)| line.starts_with('#') && line.contains("fracval") || line.starts_with("# generation_info"))
    {
        return Ok(Format::PyFracVal);
    }
    match lines.next() {
        None => Err(Error::input(source.file, "found nothing, expected the spheres of an aggregate")),
        Some((_, line)) if line.parse::<usize>().is_ok() => Ok(Format::Xyz),
        Some(_) => columns::detect(source),
    }
}

/// The spheres in nm.
fn scaled(source: &Source, raw: &Raw, options: &Options) -> Result<Vec<Sphere>, Error> {
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
                "is missing, expected the radius of the spheres: an XYZ file gives it in a fifth and last column, or in a column named by `Properties`",
            );
        }
    };
    let spheres = raw.spheres(source, unit, own)?;
    match coinciding(&spheres) {
        Some([k, other]) => {
            Err(source.at(raw.lines[k], &format!("found the centre of the sphere in line {} again", raw.lines[other])))
        }
        None => Ok(spheres),
    }
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
    fn spheres(&self, source: &Source, unit: f64, own: Option<f64>) -> Result<Vec<Sphere>, Error> {
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

/// A file and how to complain about it.
struct Source<'a> {
    file: &'a Path,
    text: &'a str,
}

impl<'a> Source<'a> {
    /// Lines without the space around them, numbered from 1.
    fn lines(&self) -> impl Iterator<Item = (usize, &'a str)> + Clone + use<'a> {
        self.text.lines().enumerate().map(|(k, line)| (k + 1, line.trim()))
    }

    /// Words with the number of their line.
    fn words(&self) -> impl Iterator<Item = (usize, &'a str)> + use<'a> {
        self.lines().flat_map(|(k, line)| line.split_whitespace().map(move |word| (k, word)))
    }

    fn problem(&self, line: Option<usize>, key: &str, what: &str) -> Error {
        Error::Input(vec![Problem { file: self.file.into(), line, key: key.into(), what: what.into() }])
    }

    fn at(&self, line: usize, what: &str) -> Error {
        self.problem(Some(line), "", what)
    }

    /// A finite number.
    fn number(&self, line: usize, word: &str) -> Result<f64, Error> {
        // Fortran may write exponents with a D.
        match word.replace(['d', 'D'], "e").parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) if word.contains(|c: char| c.is_ascii_digit()) => {
                Err(self.at(line, &format!("found `{word}`, expected a number of at most {:e}", f64::MAX)))
            }
            _ => Err(self.at(line, &format!("found `{word}`, expected a number"))),
        }
    }

    /// The radius of a sphere.
    fn radius(&self, line: usize, word: &str) -> Result<f64, Error> {
        let value = self.number(line, word)?;
        if value > 0.0 {
            Ok(value)
        } else {
            Err(self.at(line, &format!("found a radius of `{word}`, expected one above 0")))
        }
    }
}

#[cfg(test)]
mod tests;
