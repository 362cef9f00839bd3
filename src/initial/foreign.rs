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
