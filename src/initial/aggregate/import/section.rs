//! The section of a case that imports spheres.

use super::{Format, Options, radii};
use crate::case::quantity::{Length, Quantity};
use crate::case::section::section;
use std::path::PathBuf;

section! {
    /// Spheres from CSV, FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem (VTK), LAMMPS, or an XYZ file.
    pub struct Import {
        /// The file. CSV has rows `x,y,z,r`, or a header that names its columns: `x`, `y`, `z`; `r` or `d` for radius or diameter; `body` for the number of the rigid body to which a
        /// sphere belongs, 0 for a sphere by itself; `vx`, `vy`, `vz` for the velocity in m/s; `wx`, `wy`, `wz` for the angular velocity in m/s per unit of length of the file, which is
        /// 1/ns for `1 nm` and 1/s for `1 m`. Extended XYZ may have the same as `body`, `velo` and `angular_velocity`, LAMMPS as molecules and in a section `Velocities`.
        file: PathBuf,
        /// File format, if neither the content nor the ending `.csv` identifies it.
        format: Option<Format> = None,
        /// File of necks: rows `i,j` of two spheres, counted from 0 in the order of the file, or what soot-dem writes beside the spheres. It replaces the necks between all spheres that
        /// touch.
        necks: Option<PathBuf> = None,
        /// Unit of length, if the format does not define one.
        unit: Option<Quantity<Length>> = None,
        /// Radius of all spheres, if the file gives none.
        radius: Option<Quantity<Length>> = None,
        /// Whether spheres that do not form one connected aggregate are accepted.
        disconnected: bool = false,
    }
}

/// How many spheres a file has, and their radii, nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileSizes {
    /// Number of spheres, at least one.
    pub number: usize,
    /// Smallest radius.
    pub least: f64,
    /// Median radius.
    pub median: f64,
    /// Largest radius.
    pub largest: f64,
}

impl Import {
    /// What the file does not say.
    pub fn options(&self) -> Options {
        let length = |quantity: &Option<Quantity<Length>>| quantity.as_ref().map(|length| length.value);
        let (unit, radius) = (length(&self.unit), length(&self.radius));
        Options { format: self.format, unit, radius, disconnected: self.disconnected }
    }

    /// The sizes of the spheres in the file, if it can be read.
    pub fn sizes(&self) -> Option<FileSizes> {
        let mut radii = radii(&self.file, &self.options()).ok()?;
        radii.sort_unstable_by(f64::total_cmp);
        let (least, largest) = (*radii.first()?, *radii.last()?);
        Some(FileSizes { number: radii.len(), least, median: radii[radii.len() / 2], largest })
    }

    /// The files that it reads.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        [Some(&mut self.file), self.necks.as_mut()].into_iter().flatten()
    }
}
