//! Files of formats that are known but not read, recognised by their first bytes.

/// What a file is, with its remedy, if no reader of this program can be meant.
pub(crate) fn recognised(bytes: &[u8]) -> Option<&'static str> {
    let text = bytes.trim_ascii_start();
    let begins = |magic: &[u8]| text.len() >= magic.len() && text[..magic.len()].eq_ignore_ascii_case(magic);
    let head = &bytes[..bytes.len().min(4096)];
    let holds = |word: &[u8]| head.windows(word.len()).any(|part| part == word);
    Some(match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "text in UTF-16, which is not supported: save it as UTF-8",
        [0x1f, 0x8b, ..] => "a gzip archive, which is not supported: decompress it",
        [b'B', b'Z', b'h', b'0'..=b'9', ..] => "a bzip2 archive, which is not supported: decompress it",
        [0xfd, b'7', b'z', b'X', b'Z', ..] => "an xz archive, which is not supported: decompress it",
        [0x28, 0xb5, 0x2f, 0xfd, ..] => "a zstd archive, which is not supported: decompress it",
        [b'P', b'K', 3, 4, ..] => "a zip archive, which is not supported: extract the file",
        [0x89, b'H', b'D', b'F', ..] => "an HDF5 file, which is not supported: export it as XYZ or STL",
        [0xdf, 0x65, 0xdf, 0x65, ..] | [0x65, 0xdf, 0x65, 0xdf, ..] => {
            "a GSD file, which is not supported: export it as extended XYZ"
        }
        [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => {
            "a NumPy array, which is not supported: write it with `numpy.savetxt`"
        }
        _ if holds(b"number_spheres") => {
            "an MSTM input file, which is not supported: take the file of its spheres, or the rows below `sphere_data` alone"
        }
        _ if begins(b"ITEM:") && !holds(b"ITEM: ATOMS") => {
            "a LAMMPS dump of something other than atoms, which is not supported: use `dump atom` or `dump custom`"
        }
        _ if begins(b"<") && holds(b"<VTKFile") => {
            "an XML VTK file (VTP, VTU), which is not supported: export it as extended XYZ or STL"
        }
        _ if begins(b"ply\n") || begins(b"ply\r") => "a PLY file, which is not supported: export it as STL",
        _ if begins(b"ISO-10303-21") => "a STEP file, which is not supported: export it as STL",
        _ if begins(b"HEADER ") || begins(b"CRYST1") => "a PDB file, which is not supported: export it as extended XYZ",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_known_by_their_first_bytes() {
        for (bytes, expected) in [
            (&b"\xff\xfe3\0"[..], "text in UTF-16"),
            (b"\xfe\xff\x003", "text in UTF-16"),
            (b"\x1f\x8b", "a gzip archive"),
            (b"BZh91AY", "a bzip2 archive"),
            (b"\xfd7zXZ\0", "an xz archive"),
            (b"\x28\xb5\x2f\xfd", "a zstd archive"),
            (b"PK\x03\x04", "a zip archive"),
            (b"\x89HDF\r\n", "an HDF5 file"),
            (b"\xdf\x65\xdf\x65", "a GSD file"),
            (b"\x65\xdf\x65\xdf", "a GSD file"),
            (b"\x93NUMPY", "a NumPy array"),
            (b"! remark\nnumber_spheres\n3", "an MSTM input file"),
            (b"ITEM: TIMESTEP\n0\nITEM: ENTRIES i\n", "a LAMMPS dump of something other than atoms"),
            (b"\n<?xml version=\"1.0\"?>\n<VTKFile>", "an XML VTK file"),
            (b"ply\nformat ascii", "a PLY file"),
            (b"PLY\r\nformat ascii", "a PLY file"),
            (b" ISO-10303-21;", "a STEP file"),
            (b"HEADER    PROTEIN", "a PDB file"),
            (b"CRYST1", "a PDB file"),
        ] {
            let found = recognised(bytes).unwrap_or_default();
            assert!(found.starts_with(expected), "{found}, not {expected}");
            assert!(found.contains(", which is not supported: "), "{found}");
        }
    }

    #[test]
    fn others_are_left_to_their_readers() {
        for bytes in [
            &b""[..],
            b"PK",
            b"BZhx",
            b"ITEM: TIMESTEP\n0\nITEM: ATOMS id x y z\n",
            b"<geometry_complex/>",
            b"title\n<VTKFile>",
            b"plywood\n",
            b"HEADERS\n",
            b"HEADER",
            b"x ITEM: TIMESTEP\n",
            b"# by the program ply\n1 0 0 0\n",
        ] {
            assert_eq!(recognised(bytes), None, "{}", String::from_utf8_lossy(bytes));
        }
    }

    #[test]
    fn a_word_is_sought_in_the_first_4096_bytes() {
        let at = |place: usize| recognised(&[&b" ".repeat(place)[..], b"number_spheres"].concat()).is_some();
        assert_eq!([at(0), at(4096 - 14), at(4096 - 13)], [true, true, false]);
    }
}
