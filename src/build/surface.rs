//! Surfaces: the tip of the force microscope, and triangles from a file.

use crate::error::{AtPath, Error};
use crate::spec::Vec3;
use crate::system::mesh::Mesh;
use std::fs::File;
use std::io::{BufReader, ErrorKind};
use std::path::Path;

/// Section 3.1.2: the tetrahedral tip for spheres of radius `r`, apex at the origin.
pub fn tetrahedron(r: f64) -> Mesh {
    let apex = Vec3::zero();
    let [left, right, front] = [[-6.0, -3.0, 5.0], [6.0, -3.0, 5.0], [0.0, 6.0, 5.0]].map(|corner| Vec3(corner) * r);
    let triangles = [[apex, right, left], [apex, front, right], [apex, left, front], [left, right, front]];
    Mesh::new(&triangles).expect("four triangles that meet at six edges")
}

/// Reads an STL file, ASCII or binary, whose unit of length is `unit`, nm.
pub fn read_stl(path: &Path, unit: f64) -> Result<Mesh, Error> {
    let file = File::open(path).map_err(|cause| Error::NoInput(path.into(), cause))?;
    if file.metadata().at(path)?.is_dir() {
        return Err(Error::NoInput(path.into(), ErrorKind::IsADirectory.into()));
    }
    let mut file = BufReader::new(file);
    let broken = |cause: std::io::Error| Error::input(path, format!("is no STL file: {cause}"));
    let reader = stl_io::create_stl_reader(&mut file).map_err(broken)?;
    let triangles = reader
        .map(|triangle| Ok(triangle?.vertices.map(|corner| Vec3(corner.0.map(|x| f64::from(x) * unit)))))
        .collect::<std::io::Result<Vec<_>>>()
        .map_err(broken)?;
    Mesh::new(&triangles).map_err(|flaw| Error::input(path, flaw.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_is_a_closed_body_with_its_apex_below() {
        let tip = tetrahedron(14.0);
        assert!(tip.is_closed());
        assert_eq!(tip.bounds(), [Vec3([-84.0, -42.0, 0.0]), Vec3([84.0, 84.0, 70.0])]);
        let mut seen = Vec::new();
        tip.see(Vec3([0.0, 0.0, -3.0]), 14.0, 14.0, &mut seen);
        assert_eq!(seen.len(), 1);
        assert_eq!((seen[0].n, seen[0].distance), (Vec3([0.0, 0.0, -1.0]), 3.0));
        // A sphere inside it is told so.
        seen.clear();
        tip.see(Vec3([0.0, 0.0, 30.0]), 100.0, 14.0, &mut seen);
        assert_eq!(seen.len(), 1);
        assert!(seen[0].distance < 0.0);
    }
}
