//! Comma-separated values: rows `x,y,z,r`, or columns that a header names; and necks as rows `i,j`.

use super::{ASKED, Raw, Source};
use crate::error::{Error, notice};
use crate::geometry::Sphere;
use crate::initial::aggregate::necks::Neck;
use csv::{ReaderBuilder, StringRecord, Trim};

/// The columns by the names that a header may give them.
const NAMES: [(&str, &[&str]); 11] = [
    ("x", &["x"]),
    ("y", &["y"]),
    ("z", &["z"]),
    ("body", &["body", "molecule"]),
    ("vx", &["vx"]),
    ("vy", &["vy"]),
    ("vz", &["vz"]),
    ("wx", &["wx"]),
    ("wy", &["wy"]),
    ("wz", &["wz"]),
    ("r", &["r", "radius", "d", "diameter"]),
];
const BODY: usize = 3;
const VELOCITY: [usize; 3] = [4, 5, 6];
const SPIN: [usize; 3] = [7, 8, 9];
const SIZE: usize = 10;

/// Where the columns are.
struct Layout {
    columns: [Option<usize>; 11],
    /// Whether sizes are diameters.
    diameter: bool,
    width: usize,
}

/// Whether a file has a header with the names of coordinates.
pub(super) fn has_header(source: &Source) -> bool {
    let first = source.lines().find(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let names = |line: &str| line.split(',').any(|word| word.trim().trim_matches('"').eq_ignore_ascii_case("x"));
    first.is_some_and(|(_, line)| names(line))
}

/// The spheres.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
    let mut raw = Raw::default();
    let mut rows = rows(source).peekable();
    let Some(Ok((line, first))) = rows.peek() else {
        return rows.next().map_or(Ok(raw), |row| row.map(|_| Raw::default()));
    };
    let header = has_header(source);
    let layout = if header { named(source, *line, first)? } else { unnamed(source, *line, first)? };
    for row in rows.skip(usize::from(header)) {
        let (line, row) = row?;
        push(&mut raw, source, line, &layout, &row)?;
    }
    Ok(raw)
}

/// The records, with the numbers of their lines.
pub(super) fn rows<'a>(source: &'a Source) -> impl Iterator<Item = Result<(usize, StringRecord), Error>> + 'a {
    let mut builder = ReaderBuilder::new();
    builder.has_headers(false).flexible(true).comment(Some(b'#')).trim(Trim::All);
    builder.from_reader(source.text.as_bytes()).into_records().map(|row| {
        let row = row.map_err(|error| {
            let line = error.position().map_or(1, |position| position.line() as usize);
            source.at(line, &format!("is no row of comma-separated values: {error}"))
        })?;
        Ok((row.position().map_or(1, |position| position.line() as usize), row))
    })
}

fn named(source: &Source, line: usize, header: &StringRecord) -> Result<Layout, Error> {
    let (mut columns, mut diameter, mut unread) = ([None; 11], false, Vec::new());
    for (place, name) in header.iter().enumerate() {
        let lower = name.to_ascii_lowercase();
        match NAMES.iter().position(|(_, names)| names.contains(&lower.as_str())) {
            Some(column) if columns[column].is_some() => {
                return Err(
                    source.at(line, &format!("found the column `{name}` beside another one of the same meaning"))
                );
            }
            Some(column) => {
                columns[column] = Some(place);
                diameter |= column == SIZE && lower.starts_with('d');
            }
            None => unread.push(name),
        }
    }
    for group in [[0, 1, 2], VELOCITY, SPIN] {
        let missing = group.into_iter().find(|&column| columns[column].is_none());
        if let Some(missing) = missing.filter(|_| group[0] == 0 || group.iter().any(|&c| columns[c].is_some())) {
            return Err(source.at(line, &format!("found no column `{}`", NAMES[missing].0)));
        }
    }
    if !unread.is_empty() {
        notice(format!("{}: the columns {} are not read", source.file.display(), unread.join(", ")));
    }
    Ok(Layout { columns, diameter, width: header.len() })
}

fn unnamed(source: &Source, line: usize, row: &StringRecord) -> Result<Layout, Error> {
    let mut columns = [None; 11];
    columns[..3].copy_from_slice(&[Some(0), Some(1), Some(2)]);
    match row.len() {
        3 => {}
        4 => columns[SIZE] = Some(3),
        width => {
            let what = "expected `x,y,z` or `x,y,z,r`, or a header with the names of the columns";
            return Err(source.at(line, &format!("found {width} columns, {what}")));
        }
    }
    Ok(Layout { columns, diameter: false, width: row.len() })
}

fn push(raw: &mut Raw, source: &Source, line: usize, layout: &Layout, row: &StringRecord) -> Result<(), Error> {
    if row.len() != layout.width {
        return Err(source.at(line, &format!("found {} columns, expected {}", row.len(), layout.width)));
    }
    let word = |column: usize| layout.columns[column].map(|place| &row[place]);
    let three = |[a, b, c]: [usize; 3]| Some([word(a)?, word(b)?, word(c)?]);
    let x = three([0, 1, 2]).expect("every layout has coordinates");
    raw.push(source, line, x, word(SIZE))?;
    if layout.diameter {
        raw.radii.iter_mut().last().into_iter().for_each(|radius| *radius *= 0.5);
    }
    if let Some(body) = word(BODY) {
        raw.extras.push_body(source, line, body)?;
    }
    raw.extras.push_motion(source, line, three(VELOCITY), three(SPIN))
}

/// The necks: rows of two spheres, counted from 0, perhaps below a header. `allowed` says why two spheres cannot be joined.
pub(super) fn necks(
    source: &Source,
    spheres: &[Sphere],
    allowed: impl Fn(usize, usize) -> Result<(), String>,
) -> Result<Vec<Neck>, Error> {
    let mut found = Vec::new();
    for (number, row) in rows(source).enumerate() {
        if number.is_multiple_of(ASKED) {
            source.interrupt.check()?;
        }
        let (line, row) = row?;
        if number == 0 && row.iter().any(|word| word.starts_with(|c: char| c.is_ascii_alphabetic())) {
            continue;
        }
        let sphere = |word: &str| word.parse::<usize>().ok().filter(|&sphere| sphere < spheres.len());
        let ends: Vec<Option<usize>> = row.iter().map(sphere).collect();
        let &[Some(i), Some(j)] = &ends[..] else {
            let most = spheres.len().saturating_sub(1);
            let what = format!(
                "found `{}`, expected two spheres `i,j`, from 0 to {most}",
                row.iter().collect::<Vec<_>>().join(",")
            );
            return Err(source.at(line, &what));
        };
        if i == j {
            return Err(source.at(line, &format!("found a neck of the sphere {i} and itself")));
        }
        allowed(i, j).map_err(|what| source.at(line, &format!("found a neck of the spheres {i} and {j}, {what}")))?;
        found.push((i.min(j), i.max(j)));
    }
    found.sort_unstable();
    found.dedup();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::super::{Extras, Format, Options, extended_xyz, parse, parse_necks};
    use crate::error::was_said;
    use crate::geometry::Sphere;
    use crate::interrupt::Interrupt;
    use crate::spec::Vec3;
    use std::path::Path;

    const NM: Options = Options { format: None, unit: Some(1.0), radius: None, disconnected: true };

    fn read(name: &str, text: &str, options: &Options) -> Result<(Format, Vec<Sphere>, Extras), String> {
        let found = parse(Path::new(name), text, options, &Interrupt::default()).map_err(|error| error.to_string())?;
        Ok((found.format, found.spheres, found.extras))
    }

    #[test]
    fn columns_go_by_their_names_and_units_by_the_unit_of_the_file() {
        let spheres = [0.0, 8.0].map(|x| Sphere { centre: Vec3([x, 0.0, 1.0]), radius: 4.0 }).to_vec();
        let (format, found, extras) = read("a.txt", "# two\nz,y,x,r\n1,0,0,4\n1,0,8,4\n", &NM).unwrap();
        assert_eq!((format, &found, extras), (Format::Csv, &spheres, Extras::default()));
        assert_eq!(read("a.csv", "0,0,1,4\n8,0,1,4\n", &NM).unwrap().1, spheres);
        let rows =
            "X, Y, Z, d, Body, vx, vy, vz, wx, wy, wz\n0,0,1e-9,8e-9,3,1,2,3,0,0,4e9\n8e-9,0,1e-9,8e-9,0,0,0,0,0,0,0\n";
        let (_, found, Extras { bodies, v, w }) = read("a.txt", rows, &Options { unit: Some(1e9), ..NM }).unwrap();
        assert!((found[1].centre - spheres[1].centre).norm() < 1e-12 && (found[0].radius - 4.0).abs() < 1e-12);
        assert_eq!((bodies, v[0], v[1]), (vec![3, 0], Vec3([1.0, 2.0, 3.0]), Vec3::zero()));
        // 4e9 rad/s are 4 rad/ns.
        assert!((w[0] - Vec3([0.0, 0.0, 4.0])).norm() < 1e-12);
    }

    #[test]
    fn what_is_written_as_extended_xyz_is_read_again() {
        let rows = "x,y,z,r,body,vx,vy,vz,wx,wy,wz\n0.1,0,0,1,2,1,2,3,4,5,6\n2,0,0,1,2,0.1,0,0,0,0.3,0\n";
        let (_, spheres, extras) = read("a.csv", rows, &NM).unwrap();
        let (format, again, kept) = read("a.xyz", &extended_xyz(&spheres, &extras), &NM).unwrap();
        assert_eq!((format, again, kept), (Format::Xyz, spheres, extras));
    }

    #[test]
    fn lammps_gives_molecules_and_velocities() {
        let rows = "2 atoms\n\nAtoms # bpm/sphere\n\n2 7 1 2 1 2 0 0\n1 0 1 2 1 0 0 0\n\nVelocities\n\n1 1 2 3 4 5 6\n2 0 0 0 0 0 1\n";
        let (_, _, Extras { bodies, v, w }) = read("a.data", rows, &NM).unwrap();
        assert_eq!((bodies, v[0], w[1]), (vec![0, 7], Vec3([1.0, 2.0, 3.0]), Vec3([0.0, 0.0, 1.0])));
        let short = rows.replace("2 0 0 0 0 0 1\n", "");
        assert!(read("a.data", &short, &NM).unwrap_err().starts_with("a.data:5: found no row for 2 in the section"));
    }

    #[test]
    fn errors_name_the_line_and_what_was_expected() {
        for (text, expected) in [
            ("x,y,r\n0,0,1\n", "a.csv:1: found no column `z`"),
            ("x,y,z,r,vx\n0,0,0,1,2\n", "a.csv:1: found no column `vy`"),
            ("x,y,z,r,d\n0,0,0,1,2\n", "a.csv:1: found the column `d` beside another one of the same meaning"),
            ("x,y,z,r\n0,0,0,1\n0,0,2\n", "a.csv:3: found 3 columns, expected 4"),
            ("x,y,z,r\n0,0,0,no\n", "a.csv:2: found `no`, expected a number"),
            ("x,y,z,r,body\n0,0,0,1,-1\n", "a.csv:2: found `-1`, expected the number of a rigid body"),
            ("0,0,0,1,1\n", "a.csv:1: found 5 columns, expected `x,y,z` or `x,y,z,r`, or a header"),
            ("0,0,0\n", "radius: is missing"),
            ("", "found no spheres"),
            ("x,y,z,r\n", "found no spheres"),
        ] {
            let trouble = read("a.csv", text, &NM).unwrap_err();
            assert!(trouble.contains(expected), "{text}: {trouble}");
        }
    }

    #[test]
    fn necks_are_rows_of_two_spheres() {
        let spheres = [0.0, 2.0, 4.0].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 1.0 });
        let read = |text: &str| {
            parse_necks(Path::new("n.csv"), text.as_bytes(), &spheres, &Interrupt::default())
                .map_err(|trouble| trouble.to_string())
        };
        assert_eq!(read("i,j\n2,1\n0,1\n1,0\n"), Ok(vec![(0, 1), (1, 2)]));
        for (text, expected) in [
            ("0,3\n", "n.csv:1: found `0,3`, expected two spheres `i,j`, from 0 to 2"),
            ("0,1\n1,1\n", "n.csv:2: found a neck of the sphere 1 and itself"),
            ("0,2\n", "n.csv:1: found a neck of the spheres 0 and 2, whose gap is 2.000 nm, expected at most 0.1"),
            ("0,1,2\n", "n.csv:1: found `0,1,2`, expected two spheres"),
        ] {
            assert!(read(text).unwrap_err().starts_with(expected), "{text}: {:?}", read(text));
        }
    }

    #[test]
    fn a_header_is_a_first_row_of_names_and_necks_need_none() {
        let spheres = [0.0, 2.0].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 1.0 });
        let necks = |text: &str| {
            parse_necks(Path::new("n.csv"), text.as_bytes(), &spheres, &Interrupt::default())
                .map_err(|trouble| trouble.to_string())
        };
        let not_two = |row: &str| Err(format!("n.csv:{row}`, expected two spheres `i,j`, from 0 to 1"));
        for (text, expected) in [
            ("first,second\n0,1\n", Ok(vec![(0, 1)])),
            ("# i,j\n1, 0\n", Ok(vec![(0, 1)])),
            ("0,j\n", Ok(vec![])),
            ("", Ok(vec![])),
            ("0,1\ni,j\n", not_two("2: found `i,j")),
            ("1,2\n", not_two("1: found `1,2")),
            ("-1,0\n", not_two("1: found `-1,0")),
            ("0\n", not_two("1: found `0")),
        ] {
            assert_eq!(necks(text), expected, "{text}");
        }
        // Without spheres there is none to join.
        let none = parse_necks(Path::new("n.csv"), b"0,1\n", &[], &Interrupt::default()).unwrap_err().to_string();
        assert_eq!(none, "n.csv:1: found `0,1`, expected two spheres `i,j`, from 0 to 0");
        let format = |name: &str, text: &str| read(name, text, &NM).map(|(format, ..)| format);
        assert_eq!(format("a.txt", "#x\n\n\"X\",y,z,r\n0,0,0,1\n"), Ok(Format::Csv));
        assert_eq!(format("a.CSV", "0,0,0,1\n"), Ok(Format::Csv));
        assert!(format("a.txt", "y,z,r\nx,0,0,1\n").is_err());
    }

    #[test]
    fn sizes_are_radii_or_diameters_and_motion_has_all_its_columns() {
        let radius = |text: &str| read("a.csv", text, &NM).map(|(_, spheres, _)| spheres[0].radius);
        for (header, expected) in [("r", 3.0), ("Radius", 3.0), ("d", 1.5), ("DIAMETER", 1.5)] {
            assert_eq!(radius(&format!("x,y,z,density,{header}\n0,0,0,7,3\n")), Ok(expected), "{header}");
        }
        for (header, missing) in [
            ("y,z,x1,r", "x"),
            ("x,z,r", "y"),
            ("x,r", "y"),
            ("x,y,z,r,vx,vz", "vy"),
            ("x,y,z,r,vy,vz", "vx"),
            ("x,y,z,r,wx,wy", "wz"),
        ] {
            let text = format!("{header}\n{}\n", vec!["1"; header.split(',').count()].join(","));
            let options = Options { format: Some(Format::Csv), ..NM };
            let trouble = read("a.csv", &text, &options).map(|(format, ..)| format).unwrap_err();
            let expected =
                if missing == "x" { "expected a number".into() } else { format!("found no column `{missing}`") };
            assert!(trouble.contains(&expected), "{header}: {trouble}");
        }
        for (text, expected) in [
            ("x,y,z,r,X\n0,0,0,1,1\n", "a.csv:1: found the column `X` beside another one of the same meaning"),
            ("x,y,z,r\n0,0,0,1\n0,9,0,1,1\n", "a.csv:3: found 5 columns, expected 4"),
            (
                "0,0\n",
                "a.csv:1: found 2 columns, expected `x,y,z` or `x,y,z,r`, or a header with the names of the columns",
            ),
            ("0,0,0,1\n9,0,0\n", "a.csv:2: found 3 columns, expected 4"),
            ("x,y,z,r,wx,wy,wz\n0,0,0,1,0,0,a\n", "a.csv:2: found `a`, expected a number"),
        ] {
            assert_eq!(radius(text), Err(expected.into()), "{text}");
        }
    }

    #[test]
    fn columns_that_are_not_read_are_named() {
        let file = |name: &str, header: &str| read(name, &format!("{header}\n0,0,0,1,7,7\n"), &NM).map(|_| ());
        assert_eq!(file("unread.csv", "x,y,z,r,charge,Spin"), Ok(()));
        assert!(was_said("unread.csv: the columns charge, Spin are not read"));
        assert_eq!(read("all.csv", "x,y,z,r\n0,0,0,1\n", &NM).map(|_| ()), Ok(()));
        assert!(!was_said("all.csv: the columns  are not read"));
    }

    #[test]
    fn numbers_of_bodies_are_whole_and_counted_in_32_bits() {
        let body = |word: &str| {
            read("a.csv", &format!("x,y,z,r,body\n0,0,0,1,{word}\n"), &NM).map(|(_, _, extras)| extras.bodies[0])
        };
        assert_eq!([body("0"), body("3.0"), body("4294967295")], [Ok(0), Ok(3), Ok(u32::MAX)]);
        for word in ["-1", "0.5", "4294967296", "a"] {
            let what = "expected the number of a rigid body, or 0 for a sphere by itself";
            assert_eq!(body(word), Err(format!("a.csv:2: found `{word}`, {what}")));
        }
    }

    #[test]
    fn bodies_have_their_spheres_in_the_order_of_the_file() {
        let extras = Extras { bodies: vec![5, 0, 1, 5], ..Extras::default() };
        assert_eq!(extras.members(), [vec![0, 3], vec![2]]);
    }
}
