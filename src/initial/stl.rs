//! Triangulated surfaces from STL files.

use crate::error::{Error, Problem};
use crate::spec::Vec3;
use crate::system::Mesh;
use std::borrow::Cow;
use std::io::Cursor;
use std::path::Path;

/// Reads an STL file, ASCII or binary, whose unit of length is `unit`, nm.
///
/// # Errors
///
/// If the file cannot be read, or its triangles form no surface.
pub fn read_stl(path: &Path, unit: f64) -> Result<Mesh, Error> {
    let bytes = std::fs::read(path).map_err(|cause| Error::NoInput(path.into(), cause))?;
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&bytes);
    // The header of a binary file may begin with this word, too.
    let stl = if bytes.starts_with(b"solid") && !is_binary(bytes) {
        Cow::Owned(as_one_solid(path, &String::from_utf8_lossy(bytes))?.into_bytes())
    } else {
        Cow::Borrowed(bytes)
    };
    let broken = |cause: std::io::Error| Error::input(path, format!("is no STL file: {cause}"));
    let mut stl = Cursor::new(stl);
    let reader = stl_io::create_stl_reader(&mut stl).map_err(broken)?;
    let triangles = reader
        .map(|triangle| Ok(triangle?.vertices.map(|corner| Vec3(corner.0.map(|x| f64::from(x) * unit)))))
        .collect::<std::io::Result<Vec<_>>>()
        .map_err(broken)?;
    Mesh::new(&triangles).map_err(|flaw| Error::input(path, flaw.to_string()))
}

/// Whether a file is at least as long as a header, the number of its triangles and 50 bytes for each: four letters would be a number of millions.
fn is_binary(bytes: &[u8]) -> bool {
    let number = bytes[80.min(bytes.len())..].first_chunk().map(|number| u32::from_le_bytes(*number));
    number.is_some_and(|number| bytes.len() as u64 >= 84 + 50 * u64::from(number))
}

/// An ASCII file with the facets of all its solids in one: the reader stops where the first ends.
fn as_one_solid(path: &Path, text: &str) -> Result<String, Error> {
    let (mut one, mut inside) = (String::from("solid \n"), false);
    for (k, line) in text.lines().enumerate() {
        match (line.split_whitespace().next(), inside) {
            (Some("solid"), false) => inside = true,
            (Some("endsolid"), true) => inside = false,
            (Some(_), true) => one.extend([line, "\n"]),
            (Some("facet"), false) => {
                let what = "found `facet`, expected a `solid` before it".into();
                return Err(Error::Input(vec![Problem { file: path.into(), line: Some(k + 1), key: "".into(), what }]));
            }
            _ => {}
        }
    }
    Ok(if inside { one } else { one + "endsolid\n" })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron of the given size, apex at the origin.
    fn tetrahedron(r: f64) -> Mesh {
        let [left, right, front] =
            [[-6.0, -3.0, 5.0], [6.0, -3.0, 5.0], [0.0, 6.0, 5.0]].map(|corner| Vec3(corner) * r);
        let apex = Vec3::zero();
        let triangles = [[apex, right, left], [apex, front, right], [apex, left, front], [left, right, front]];
        Mesh::new(&triangles).expect("four triangles that meet at six edges")
    }

    fn write(folder: &tempfile::TempDir, name: &str, bytes: &[u8]) -> std::path::PathBuf {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).expect("a writable folder");
        path
    }

    /// The tip for a radius of 1 in the binary and in the ASCII format.
    fn stl() -> [Vec<u8>; 2] {
        let tip = tetrahedron(1.0);
        let normal = stl_io::Normal::new([0.0; 3]);
        let corners = |t: usize| tip.triangle(t).map(|corner| stl_io::Vertex::new(corner.0.map(|x| x as f32)));
        let triangles: Vec<_> = (0..4).map(|t| stl_io::Triangle { normal, vertices: corners(t) }).collect();
        let mut binary = Vec::new();
        stl_io::write_stl(&mut binary, triangles.iter()).expect("room in memory");
        let mut ascii = String::from("solid tip\n");
        for triangle in &triangles {
            ascii.push_str("facet normal 0 0 0\nouter loop\n");
            triangle
                .vertices
                .iter()
                .for_each(|v| ascii.push_str(&format!("vertex {} {} {}\n", v.0[0], v.0[1], v.0[2])));
            ascii.push_str("endloop\nendfacet\n");
        }
        ascii.push_str("endsolid tip\n");
        [binary, ascii.into_bytes()]
    }

    #[test]
    fn both_formats_give_the_surface_in_the_stated_unit() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for (name, bytes) in ["binary.stl", "ascii.stl"].into_iter().zip(stl()) {
            assert_eq!(read_stl(&write(&folder, name, &bytes), 14.0).expect("a surface"), tetrahedron(14.0), "{name}");
        }
    }

    #[test]
    fn every_solid_of_a_file_is_read() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let [binary, ascii] = stl();
        let text = String::from_utf8(ascii).expect("ASCII");
        // The last two facets in a solid of their own, with a mark and a name in Latin-1 before it.
        let place = text.match_indices("facet normal").nth(2).expect("four facets").0;
        let parts = [
            &b"\xef\xbb\xbf"[..],
            &text.as_bytes()[..place],
            b"endsolid\n\nsolid \xe9t\xe9\n",
            &text.as_bytes()[place..],
        ];
        let mesh = read_stl(&write(&folder, "two.stl", &parts.concat()), 14.0).expect("a surface");
        assert_eq!(mesh, tetrahedron(14.0));
        let named = [&b"solid "[..], &binary[6..], b"\n\n"].concat();
        assert_eq!(read_stl(&write(&folder, "named.stl", &named), 14.0).expect("a surface"), mesh);
        let remarked = text.clone() + "# by hand\n";
        assert_eq!(read_stl(&write(&folder, "remarked.stl", remarked.as_bytes()), 14.0).expect("a surface"), mesh);
        let trouble = read_stl(&write(&folder, "more.stl", (text + "facet\n").as_bytes()), 1.0).expect_err("no solid");
        assert!(trouble.to_string().ends_with("more.stl:31: found `facet`, expected a `solid` before it"));
    }

    #[test]
    fn what_is_wrong_with_a_file_is_said() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let complaint = |name: &str, bytes: &[u8]| {
            let error = read_stl(&write(&folder, name, bytes), 1.0).expect_err("a broken file").to_string();
            error.rsplit_once(&format!("{name}: ")).expect("it names the file").1.to_string()
        };
        let [binary, ascii] = stl();
        assert!(complaint("short.stl", &binary[..binary.len() - 1]).starts_with("is no STL file: "));
        assert!(complaint("words.stl", b"solid tip\nfacet abnormal").starts_with("is no STL file: "));
        assert_eq!(complaint("empty.stl", b"solid tip\nendsolid tip\n"), "has no triangle");
        let text = String::from_utf8(ascii).expect("ASCII");
        let flat = text.replace("vertex 6 -3 5", "vertex -6 -3 5");
        assert_eq!(complaint("flat.stl", flat.as_bytes()), "triangle 1 has no area");
        let missing = read_stl(&folder.path().join("missing.stl"), 1.0).expect_err("no file").to_string();
        assert!(missing.contains("missing.stl: cannot be read: "), "{missing}");
    }
}
