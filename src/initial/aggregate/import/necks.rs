//! The necks of an imported aggregate, from a file beside its spheres.

use super::{Source, csv, text_of, vtk};
use crate::error::{Error, read_file};
use crate::geometry::Sphere;
use crate::initial::aggregate::necks::Neck;
use crate::interrupt::Interrupt;
use crate::spec::soot::eq26_coordination::are_neighbours;
use std::path::Path;

/// Largest gap of a neck, as a fraction of the mean diameter: soot-dem joins spheres up to 1 nm apart, a tenth for small ones.
const NECK: f64 = 0.1;

/// The necks of an aggregate, as [`parse_necks`] finds them in a file.
///
/// # Errors
///
/// If the file cannot be read, a neck joins no two spheres, or an interruption.
pub fn read_necks(file: &Path, spheres: &[Sphere], interrupt: &Interrupt) -> Result<Vec<Neck>, Error> {
    parse_necks(file, &read_file(file)?, spheres, interrupt)
}

/// The necks of an aggregate: the VTK of soot-dem, or rows `i,j` of two spheres, counted from 0.
///
/// # Errors
///
/// The first line that cannot be read, a neck that joins no two spheres, or an interruption.
pub fn parse_necks(file: &Path, bytes: &[u8], spheres: &[Sphere], interrupt: &Interrupt) -> Result<Vec<Neck>, Error> {
    let text = text_of(file, bytes)?;
    let source = Source { file, text: &text, interrupt };
    let near = |i: usize, j: usize| {
        let (a, b) = (&spheres[i], &spheres[j]);
        if are_neighbours(a.centre, b.centre, a.radius, b.radius, NECK) > 0.0 {
            return Ok(());
        }
        Err(format!("whose gap is {:.3} nm, expected at most {NECK} of their mean diameter", a.gap(b)))
    };
    let is_vtk = text.trim_start().starts_with("# vtk") || text.contains("connections");
    if is_vtk { vtk::necks(&source, spheres, near) } else { csv::necks(&source, spheres, near) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;

    #[test]
    fn a_neck_bridges_less_than_a_tenth_of_the_mean_diameter() {
        let found = |gap: f64| {
            let spheres =
                [(0.0, 2.0), (3.0 + gap, 1.0)].map(|(x, radius)| Sphere { centre: Vec3([x, 0.0, 0.0]), radius });
            parse_necks(Path::new("n"), b"0,1\n", &spheres, &Interrupt::default()).map_err(|error| error.to_string())
        };
        for gap in [0.29, 0.0, -1.0] {
            assert_eq!(found(gap), Ok(vec![(0, 1)]), "{gap}");
        }
        let trouble = "n:1: found a neck of the spheres 0 and 1, whose gap is 0.310 nm, expected at most 0.1 of their mean diameter";
        assert_eq!(found(0.31), Err(trouble.into()));
    }
}
