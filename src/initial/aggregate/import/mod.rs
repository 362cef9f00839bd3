//! Aggregates from other programs: FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem, LAMMPS, XYZ, CSV.

mod columns;
mod csv;
mod dump;
mod extras;
mod flage;
mod lammps;
mod necks;
mod report;
mod scale;
mod section;
mod strengths;
mod vtk;

pub use columns::OF_FRAMES;
pub use extras::Extras;
pub use necks::{parse_necks, read_necks};
pub use report::Report;
pub use section::{FileSizes, Import, shift_of_import};
pub use strengths::read_strengths;

use crate::case::section::words;
use crate::case::unmarked;
use crate::error::{Error, Problem, read_file};
use crate::geometry::Sphere;
use crate::initial::aggregate::components;
use crate::initial::foreign;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use scale::{scaled, units};
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
        /// A dump in text with the columns `id x y z`, and perhaps `radius` or `diameter`, `mol`, velocities.
        Dump = "lammps-dump",
        /// A number, a comment, rows `species x y z`, perhaps with a radius.
        Xyz = "xyz",
        /// Rows `x,y,z,r`, or comma-separated columns that a header names.
        Csv = "csv",
    }
}

/// Spheres that are read between two looks at the interrupt.
const ASKED: usize = 4096;

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
    /// Rigid bodies and velocities.
    pub extras: Extras,
    /// Number of parts that do not touch.
    pub components: usize,
    /// Most decimals of a coordinate in the file; an exponent counts as many.
    pub decimals: usize,
}

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
    extras: Extras,
}

/// Reads an aggregate.
///
/// # Errors
///
/// If the file cannot be read, and all that [`parse`] finds.
pub fn read(file: &Path, options: &Options, interrupt: &Interrupt) -> Result<Imported, Error> {
    parse(file, read_file(file)?, options, interrupt)
}

/// The spheres in a file, from which no more is wanted.
///
/// # Errors
///
/// If the file cannot be read, or is not that of spheres.
pub fn spheres(file: &Path, options: &Options) -> Result<Vec<Sphere>, Error> {
    let text = text_of(file, &read_file(file)?)?;
    let source = Source { file, text: &text, interrupt: &Interrupt::of_process() };
    let (_, raw) = raw(&source, options)?;
    let (unit, own) = units(&source, &raw, options)?;
    raw.spheres(&source, unit, own)
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
/// The first line that cannot be read, spheres that coincide or are disconnected, or an interruption.
pub fn parse(
    file: &Path,
    content: impl AsRef<[u8]>,
    options: &Options,
    interrupt: &Interrupt,
) -> Result<Imported, Error> {
    let source = Source { file, text: &text_of(file, content.as_ref())?, interrupt };
    let (format, raw) = raw(&source, options)?;
    let (unit, spheres) = scaled(&source, &raw, options)?;
    let components = components(&spheres, interrupt)?;
    if components > 1 && !options.disconnected {
        let what = format!("found {components} parts that do not touch, expected one; `disconnected` accepts them");
        return Err(Error::input(file, what));
    }
    Ok(Imported { format, spheres, extras: raw.extras.scaled(unit), components, decimals: raw.decimals })
}

impl Imported {
    /// What the spheres look like.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    pub fn report(&self, interrupt: &Interrupt) -> Result<Report, Error> {
        Report::of(&self.spheres, self.components, interrupt)
    }
}

/// The numbers of a file and who wrote it.
fn raw(source: &Source, options: &Options) -> Result<(Format, Raw), Error> {
    let format = match options.format {
        Some(format) => format,
        None => detect(source)?,
    };
    let raw = match format {
        Format::Flage => flage::read(source)?,
        Format::Vtk => vtk::read(source)?,
        Format::Lammps => lammps::read(source)?,
        Format::Dump => dump::read(source)?,
        Format::Xyz => columns::xyz(source)?,
        Format::Csv => csv::read(source)?,
        Format::Mstm => columns::rows(source, true)?,
        Format::FracVal | Format::PyFracVal => columns::rows(source, false)?,
    };
    Ok((format, raw))
}

/// The spheres as extended XYZ with all their digits, nm, m/s and 1/ns.
pub fn extended_xyz(spheres: &[Sphere], Extras { bodies, v, w }: &Extras) -> String {
    let mut text = format!("{}\nProperties=species:S:1:pos:R:3:radius:R:1", spheres.len());
    let lists = [("body:I:1", bodies.len()), ("velo:R:3", v.len()), ("angular_velocity:R:3", w.len())];
    lists.iter().filter(|(_, length)| *length > 0).for_each(|(name, _)| text += &format!(":{name}"));
    text.push('\n');
    for (k, Sphere { centre: Vec3([x, y, z]), radius }) in spheres.iter().enumerate() {
        text += &format!("X {x} {y} {z} {radius}");
        bodies.get(k).iter().for_each(|body| text += &format!(" {body}"));
        [v.get(k), w.get(k)].iter().flatten().flat_map(|vector| vector.0).for_each(|x| text += &format!(" {x}"));
        text.push('\n');
    }
    text
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
    if dump::is_dump(source) {
        return Ok(Format::Dump);
    }
    if csv::has_header(source) || source.file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv")) {
        return Ok(Format::Csv);
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

/// A file and how to complain about it.
struct Source<'a> {
    file: &'a Path,
    text: &'a str,
    interrupt: &'a Interrupt,
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
