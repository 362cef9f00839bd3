//! The section of a case that imports spheres.

use super::{Format, Options, spheres};
use crate::case::quantity::{Length, Quantity};
use crate::case::section::section;
use crate::case::units::decimal;
use crate::geometry::Sphere;
use crate::spec::Vec3;
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

impl FileSizes {
    /// The sizes of spheres, of which there is one.
    pub fn of(spheres: &[Sphere]) -> Self {
        let mut radii: Vec<f64> = spheres.iter().map(|sphere| sphere.radius).collect();
        radii.sort_unstable_by(f64::total_cmp);
        Self { number: radii.len(), least: radii[0], median: radii[radii.len() / 2], largest: radii[radii.len() - 1] }
    }
}

/// The derived value that tells how to go back to the coordinates of a file: how far its spheres were moved into the box of the run, nm.
pub fn shift_of_import(Vec3([x, y, z]): Vec3<f64>) -> (String, String) {
    let [x, y, z] = [x, y, z].map(decimal);
    ("shift of the imported spheres into the box".into(), format!("{x} nm, {y} nm, {z} nm"))
}

impl Import {
    /// What the file does not say.
    pub fn options(&self) -> Options {
        let length = |quantity: &Option<Quantity<Length>>| quantity.as_ref().map(|length| length.value);
        let (unit, radius) = (length(&self.unit), length(&self.radius));
        Options { format: self.format, unit, radius, disconnected: self.disconnected }
    }

    /// The spheres in the file, at least one, if it can be read.
    pub fn spheres(&self) -> Option<Vec<Sphere>> {
        spheres(&self.file, &self.options()).ok().filter(|spheres| !spheres.is_empty())
    }

    /// Their sizes.
    pub fn sizes(&self) -> Option<FileSizes> {
        self.spheres().map(|spheres| FileSizes::of(&spheres))
    }

    /// The files that it reads.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        [Some(&mut self.file), self.necks.as_mut()].into_iter().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn radii(radii: &[f64]) -> [f64; 3] {
        let spheres: Vec<Sphere> = radii.iter().map(|&radius| Sphere { centre: Vec3([0.0; 3]), radius }).collect();
        let FileSizes { number, least, median, largest } = FileSizes::of(&spheres);
        assert_eq!(number, radii.len());
        [least, median, largest]
    }

    #[test]
    fn half_of_the_radii_are_below_the_median() {
        assert_eq!(radii(&[7.0, 1.0, 5.0, 3.0, 2.0]), [1.0, 3.0, 7.0]);
        assert_eq!(radii(&[4.0]), [4.0; 3]);
        // Of two in the middle the larger.
        assert_eq!(radii(&[8.0, 6.0, 2.0, 4.0, 1.0, 9.0]), [1.0, 6.0, 9.0]);
    }

    #[test]
    fn a_shift_is_told_axis_by_axis() {
        let (key, value) = shift_of_import(Vec3([1.0, -2.5, 3e-9]));
        assert_eq!(
            (key.as_str(), value.as_str()),
            ("shift of the imported spheres into the box", "1 nm, -2.5 nm, 3e-9 nm")
        );
    }

    #[test]
    fn a_section_passes_on_what_the_file_does_not_say() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aggregates");
        let length = |text: &str| Some(Quantity::parse(text).expect("a length"));
        let import = |name: &str, unit, radius| Import {
            file: folder.join(name),
            format: Some(Format::Xyz),
            necks: None,
            unit,
            radius,
            disconnected: true,
        };
        let both = import("plain.xyz", length("2 nm"), length("28 nm"));
        let Options { format, unit, radius, disconnected } = both.options();
        assert_eq!((format, unit, radius, disconnected), (Some(Format::Xyz), Some(2.0), Some(28.0), true));
        let sizes = FileSizes { number: 3, least: 28.0, median: 28.0, largest: 28.0 };
        assert_eq!(both.sizes(), Some(sizes));
        assert_eq!(import("plain.xyz", length("1 nm"), None).sizes(), None);
        assert_eq!(import("missing.xyz", None, None).spheres(), None);
        let (mut one, mut two) = (both.clone(), Import { necks: Some("n.csv".into()), ..both });
        assert_eq!([one.files_mut().count(), two.files_mut().count()], [1, 2]);
    }
}
