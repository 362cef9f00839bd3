//! Triangulated surfaces from STL files.
//!
//! `stl_io` writes them in the tests. It cannot read the dialects of ASCII files in use, and reports neither line nor facet.

mod ascii;

use crate::error::{Error, Problem, notice, read_file};
use crate::initial::foreign;
use crate::spec::Vec3;
use crate::system::Mesh;
use std::path::Path;

/// The corners of a triangle in the unit of the file.
type Corners = [[f32; 3]; 3];

/// Length of the header of a binary file, with the number of triangles at its end.
const HEADER: usize = 84;

/// Length of a triangle in a binary file: normal, corners, attributes.
const FACET: usize = 50;

/// Reads an STL file, ASCII or binary, whose unit of length is `unit`, nm. Normals are not read: the order of the corners defines them. Triangles
/// without area are dropped with a notice.
///
/// # Errors
///
/// If the file cannot be read, and all that [`parse_stl`] finds.
pub fn read_stl(path: &Path, unit: f64) -> Result<Mesh, Error> {
    parse_stl(path, &read_file(path)?, unit)
}

/// The same from the content of a file.
///
/// # Errors
///
/// The first place that cannot be read, or triangles that form no surface.
pub fn parse_stl(path: &Path, bytes: &[u8], unit: f64) -> Result<Mesh, Error> {
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    if let Some(known) = foreign::recognised(bytes) {
        return Err(Error::input(path, format!("found {known}, expected an STL file, ASCII or binary")));
    }
    let corners =
        if is_binary(bytes) { binary(path, bytes)? } else { ascii::read(path, &String::from_utf8_lossy(bytes))? };
    let scaled = |corner: [f32; 3]| Vec3(corner.map(|x| f64::from(x) * unit));
    let triangles: Vec<_> = corners.iter().map(|corners| corners.map(scaled)).collect();
    let mesh = Mesh::new(&triangles).map_err(|flaw| Error::input(path, flaw.to_string()))?;
    match triangles.len() - mesh.triangles().len() {
        0 => {}
        1 => notice(format!("{}: dropped a triangle without area", path.display())),
        dropped => notice(format!("{}: dropped {dropped} triangles without area", path.display())),
    }
    Ok(mesh)
}

/// Whether a file is binary. Its header may begin with `solid`, too, but the number of triangles after it holds a zero byte below 16 million triangles.
fn is_binary(bytes: &[u8]) -> bool {
    bytes[..HEADER.min(bytes.len())].contains(&0)
}

fn binary(path: &Path, bytes: &[u8]) -> Result<Vec<Corners>, Error> {
    let wrong = |what: String| Error::input(path, what);
    let Some(number) = bytes.get(HEADER - 4..).and_then(|rest| rest.first_chunk()) else {
        return Err(wrong(format!("found {} bytes, expected a binary STL file of at least {HEADER}", bytes.len())));
    };
    let (number, facets) = (u32::from_le_bytes(*number) as usize, bytes[HEADER..].chunks_exact(FACET));
    if facets.len() != number {
        let what = format!(
            "found {number} triangles in the header of a binary STL file and {} bytes after it, which hold {}; expected {}",
            bytes.len() - HEADER,
            facets.len(),
            number * FACET
        );
        return Err(wrong(what));
    }
    if !facets.remainder().is_empty() {
        notice(format!("{}: {} bytes after the last triangle are not read", path.display(), facets.remainder().len()));
    }
    let coordinate = |facet: &[u8], k: usize| {
        f32::from_le_bytes(facet[12 + 4 * k..][..4].try_into().expect("four bytes of a triangle"))
    };
    let corners = |(t, facet): (usize, &[u8])| {
        let numbers: [f32; 9] = std::array::from_fn(|k| coordinate(facet, k));
        match numbers.iter().position(|x| !x.is_finite()) {
            None => Ok([0, 3, 6].map(|k| [numbers[k], numbers[k + 1], numbers[k + 2]])),
            Some(k) => Err(wrong(format!(
                "found the coordinate {} in triangle {} at byte {}, expected a finite number",
                numbers[k],
                t + 1,
                HEADER + t * FACET + 12 + 4 * k
            ))),
        }
    };
    facets.enumerate().map(corners).collect()
}

/// An error at a line.
fn at(path: &Path, line: usize, what: String) -> Error {
    Error::Input(vec![Problem { file: path.into(), line: Some(line), key: "".into(), what }])
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
    fn dialects_are_read() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let [_, ascii] = stl();
        let text = String::from_utf8(ascii).expect("ASCII");
        let flat = "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 6 -3 5 endloop endfacet\n";
        for (name, changed) in [
            ("upper", text.to_uppercase()),
            ("blank", format!("\n \n# by hand\n{text}")),
            ("nan", text.replace("normal 0 0 0", "normal NaN -nan(ind) inf")),
            ("without normals", text.replace("facet normal 0 0 0", "facet")),
            (
                "apart",
                text.replace("endloop", "end loop").replace("endsolid", "end solid").replace("endfacet", "END facet"),
            ),
            ("windows", text.replace('\n', "\r\n")),
            ("one line", text.replace('\n', " ").replacen("solid tip", "solid tip\n", 1)),
            ("junk", text.clone() + "junk {} \u{0}\n"),
            ("flat", text.replacen("facet", &(flat.to_string() + "facet"), 1)),
        ] {
            let mesh = read_stl(&write(&folder, name, changed.as_bytes()), 14.0);
            assert_eq!(mesh.unwrap_or_else(|error| panic!("{error}")), tetrahedron(14.0), "{name}");
        }
    }

    #[test]
    fn what_is_wrong_with_a_file_is_said() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let complaint = |name: &str, bytes: &[u8]| {
            let error = read_stl(&write(&folder, name, bytes), 1.0).expect_err("a broken file").to_string();
            error.rsplit_once(&format!("{name}: ")).expect("it names the file").1.to_string()
        };
        let [binary, ascii] = stl();
        let counted = "found 4 triangles in the header of a binary STL file and";
        let short = complaint("short.stl", &binary[..binary.len() - 1]);
        assert_eq!(short, format!("{counted} 199 bytes after it, which hold 3; expected 200"));
        let more = [&binary[..], &[0; 50]].concat();
        assert_eq!(complaint("more.stl", &more), format!("{counted} 250 bytes after it, which hold 5; expected 200"));
        let mut not_finite = binary.clone();
        not_finite[84 + 50 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
        let found = complaint("nan.stl", &not_finite);
        assert_eq!(found, "found the coordinate NaN in triangle 2 at byte 146, expected a finite number");
        assert_eq!(complaint("empty.stl", b"solid tip\nendsolid tip\n"), "has no triangle with an area");
        assert!(complaint("utf16.stl", b"\xff\xfes\0o\0").contains("text in UTF-16"));
        let text = String::from_utf8(ascii).expect("ASCII");
        for (old, new, expected) in [
            ("facet normal 0 0 0\nouter", "facet abnormal", "2: found `abnormal`, expected `outer`"),
            ("vertex 0 0 0", "vertex 0 0,5 0", "4: found `0,5`, expected a finite number in single precision"),
            ("vertex 0 0 0", "vertex 1e300 0 0", "4: found `1e300`, expected a finite number in single precision"),
            ("endloop", "vertex 0 0 0", "7: found `vertex`, expected `endloop`"),
            (
                "solid tip\n",
                "v 0 0 0\n",
                "1: found `v`, expected an STL file, binary or with `solid` in its first line",
            ),
        ] {
            let changed = text.replacen(old, new, 1);
            let error = read_stl(&write(&folder, "words.stl", changed.as_bytes()), 1.0).expect_err("a broken file");
            assert!(error.to_string().ends_with(&format!("words.stl:{expected}")), "{error}");
        }
        let cut = &text[..text.len() / 2];
        let error = read_stl(&write(&folder, "cut.stl", cut.as_bytes()), 1.0).expect_err("half a file").to_string();
        assert!(error.contains("expected"), "{error}");
        let missing = read_stl(&folder.path().join("missing.stl"), 1.0).expect_err("no file").to_string();
        assert!(missing.contains("missing.stl: cannot be read: "), "{missing}");
    }

    #[test]
    fn every_word_that_is_out_of_place_is_reported_with_its_line() {
        let parsed =
            |text: &str| parse_stl(Path::new("a.stl"), text.as_bytes(), 1.0).map_err(|error| error.to_string());
        let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        let solid = format!("solid\n{facet}endsolid\n");
        assert_eq!(parsed(&solid).map(|mesh| mesh.triangles().len()), Ok(1));
        for (text, expected) in [
            (solid.replace("facet normal", "face normal"), "2: found `face`, expected `facet` or `endsolid`"),
            (solid.replace("outer", "inner"), "3: found `inner`, expected `outer`"),
            (solid.replace("loop\nvertex 0 0 0", "ring\nvertex 0 0 0"), "3: found `ring`, expected `loop`"),
            (solid.replace("vertex 1 0 0", "corner 1 0 0"), "5: found `corner`, expected `vertex`"),
            (solid.replace("vertex 1 0 0\n", ""), "6: found `endloop`, expected `vertex`"),
            (
                solid.replace("vertex 1 0 0", "vertex 1 0 x"),
                "5: found `x`, expected a finite number in single precision",
            ),
            (
                solid.replace("vertex 1 0 0", "vertex 1 0 inf"),
                "5: found `inf`, expected a finite number in single precision",
            ),
            (solid.replace("endfacet", "end loop"), "8: found `endloop`, expected `endfacet`"),
            (solid.replace("endfacet", "end\nfacet"), "8: found `end`, expected `endfacet`"),
            (solid.replace("0 0 1\nouter", "0 0\nouter"), "3: found `loop`, expected `outer`"),
            ("solid\nfacet normal 0 0".into(), "2: the file ends here, expected the three numbers of a normal"),
            ("solid\nfacet".into(), "2: the file ends here, expected `outer loop`"),
            ("solid\nfacet normal 0 0 1\n".into(), "2: the file ends here, expected `outer loop`"),
            ("solid\nfacet\nouter loop vertex 0".into(), "3: the file ends here, expected a coordinate"),
            ("solid\nfacet\nouter loop vertex 0 0 0\n".into(), "3: the file ends here, expected `vertex`"),
            (
                format!("remark\n{solid}"),
                "1: found `remark`, expected an STL file, binary or with `solid` in its first line",
            ),
            (
                format!("{}\n", "x".repeat(50)),
                &format!(
                    "1: found `{}`, expected an STL file, binary or with `solid` in its first line",
                    "x".repeat(40)
                ),
            ),
        ] {
            assert_eq!(parsed(&text), Err(format!("a.stl:{expected}")), "{text}");
        }
        // Between solids anything may stand, on the line of the end and on others.
        let two = format!(
            "solid a facet\n{facet}endsolid a facet\nremark facet\n\nsolid b\nfacet normal 0 0 1 outer loop vertex 5 0 0 vertex 6 0 0 vertex 5 1 0 end loop end facet\nend solid\n"
        );
        assert_eq!(parsed(&two).map(|mesh| mesh.triangles().len()), Ok(2));
    }

    #[test]
    fn a_binary_file_is_as_long_as_its_triangles_and_may_have_a_tail() {
        let [binary, _] = stl();
        let parsed = |bytes: &[u8]| parse_stl(Path::new("a.stl"), bytes, 1.0).map_err(|error| error.to_string());
        assert_eq!(parsed(&[&binary[..], &[7; 49]].concat()), Ok(tetrahedron(1.0)));
        let marked = ["\u{feff}".as_bytes(), &binary].concat();
        assert_eq!(parsed(&marked), Ok(tetrahedron(1.0)));
        for (length, expected) in [
            (83, "found 83 bytes, expected a binary STL file of at least 84".to_string()),
            (84, "found 4 triangles in the header of a binary STL file and 0 bytes after it, which hold 0; expected 200".into()),
            (133, "found 4 triangles in the header of a binary STL file and 49 bytes after it, which hold 0; expected 200".into()),
        ] {
            assert_eq!(parsed(&binary[..length]), Err(format!("a.stl: {expected}")));
        }
        // No coordinate may be infinite.
        for k in [0, 4, 8] {
            let mut wrong = binary.clone();
            wrong[84 + 2 * 50 + 12 + 4 * k..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
            let place = 84 + 2 * 50 + 12 + 4 * k;
            assert_eq!(
                parsed(&wrong),
                Err(format!("a.stl: found the coordinate inf in triangle 3 at byte {place}, expected a finite number"))
            );
        }
        // A zero byte beyond the header makes no file binary.
        let text = format!("solid {}\n", "x".repeat(90))
            + "facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid \0";
        assert_eq!(parsed(text.as_bytes()).map(|mesh| mesh.triangles().len()), Ok(1));
        assert!(is_binary(&[&[b'x'; 83][..], &[0]].concat()) && !is_binary(&[&[b'x'; 84][..], &[0]].concat()));
    }
}
