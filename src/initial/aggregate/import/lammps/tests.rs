use super::super::{Imported, Options, parse};
use super::*;
use crate::error::was_said;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use std::path::Path;

fn data(text: &str) -> Result<Imported, String> {
    let options = Options { unit: Some(1.0), disconnected: true, ..Options::default() };
    let found = parse(Path::new("a.data"), text, &options, &Interrupt::default());
    found.map_err(|error| error.to_string())
}

/// The columns of the styles as the manual of LAMMPS lists them, those of a hybrid below each style without id, type and coordinates.
const MANUAL: [(&str, &str); 9] = [
    ("angle", "id mol type x y z"),
    ("atomic", "id type x y z"),
    ("bond", "id mol type x y z"),
    ("bpm/sphere", "id mol type diameter density x y z"),
    ("charge", "id type q x y z"),
    ("ellipsoid", "id type flag density x y z"),
    ("full", "id mol type q x y z"),
    ("molecular", "id mol type x y z"),
    ("sphere", "id type diameter density x y z"),
];

/// Places of the first coordinate, the diameter and the molecule, and the number of columns.
type Places = (usize, Option<usize>, Option<usize>, usize);

fn places(columns: &[&str]) -> Places {
    let place = |name: &str| columns.iter().position(|column| *column == name);
    (place("x").expect("coordinates"), place("diameter"), place("mol"), columns.len())
}

fn found(words: &str) -> Option<Places> {
    style(words).map(|Style { x, diameter, molecule, width }| (x, diameter, molecule, width))
}

#[test]
fn columns_of_styles_and_hybrids_are_those_of_the_manual() {
    let own = |columns: &'static str| {
        columns.split(' ').filter(|column| !["id", "type", "x", "y", "z"].contains(column)).collect::<Vec<_>>()
    };
    for (name, columns) in MANUAL {
        assert_eq!(found(name), Some(places(&columns.split(' ').collect::<Vec<_>>())), "{name}");
        for (other, others) in MANUAL {
            let both: Vec<&str> =
                ["id", "type", "x", "y", "z"].into_iter().chain(own(columns)).chain(own(others)).collect();
            assert_eq!(found(&format!("hybrid {name} {other}")), Some(places(&both)), "{name} {other}");
        }
    }
    for unknown in ["", "hybrid", "hybrid sphere dipole", "sphere bond", "Sphere", "oxdna"] {
        assert_eq!(found(unknown), None, "{unknown}");
    }
}

#[test]
fn image_flags_count_boxes_along_each_axis() {
    let rows = "Atoms # sphere\n\n1 1 2 1 1 2 3 1 0 0\n2 1 2 1 1 2 3 0 -2 0\n3 1 2 1 1 2 3 0 0 3\n4 1 2 1 1 2 3\n";
    let sides = "-1 9 xlo xhi\n5 25 ylo yhi\n-30 0 zlo zhi\n";
    let centres = |text: &str| data(text).map(|found| found.spheres.iter().map(|s| s.centre.0).collect::<Vec<_>>());
    let expected = vec![[11.0, 2.0, 3.0], [1.0, -38.0, 3.0], [1.0, 2.0, 93.0], [1.0, 2.0, 3.0]];
    assert_eq!(centres(&format!("4 atoms\n{sides}0 0 0 xy xz yz\n{rows}")), Ok(expected));
    for (tilt, side) in
        [("0 1 0", sides), ("0 0 1", sides), ("0 0 0", "0 9 xlo xhi\n0 9 ylo yhi\n"), ("0 0 0", "0 9 zlo zhi\n")]
    {
        let trouble = centres(&format!("4 atoms\n{side}{tilt} xy xz yz\n{rows}")).unwrap_err();
        assert!(trouble.contains("found image flags, expected none: the box is tilted or missing"), "{trouble}");
    }
}

#[test]
fn what_is_no_row_of_a_section_is_reported_with_its_line() {
    let with = |velocities: &str| format!("Atoms # sphere\n\n1 1 2 1 0 0 0\n\n{velocities}");
    for (text, expected) in [
        ("Atoms # sphere\n\n1 1 2 1 0 0\n".to_string(), "3: found 6 columns, expected at least 7"),
        ("Atoms # hybrid sphere bond\n\n1 1 0 0 0 2 1\n".into(), "3: found 7 columns, expected at least 8"),
        ("Atoms # sphere\n\n1.5 1 2 1 0 0 0\n".into(), "3: found `1.5`, expected an integer"),
        ("Atoms # sphere\n\n1 1 2 1 0 0 0 0 0.5 0\n".into(), "3: found `0.5`, expected an integer"),
        ("Atoms # sphere\n\n1 1 2 1 0 0 0 0 0\n".into(), "3: found 9 columns, expected 7, or 10 with image flags"),
        ("Atoms # sphere\n\n1 1 0 1 0 0 0\n".into(), "3: found a radius of `0`, expected one above 0"),
        ("0 x xlo xhi\nAtoms # sphere\n\n1 1 2 1 0 0 0\n".into(), "1: found `x`, expected a number"),
        (
            "Atoms # bpm/sphere\n\n1 0.5 1 2 1 0 0 0\n".into(),
            "3: found `0.5`, expected the number of a rigid body, or 0 for a sphere by itself",
        ),
        (
            "2 atoms # in all\n1 atoms\n3 bonds\nAtoms # sphere\n\n1 1 2 1 0 0 0\n2 1 2 1 3 0 0\n".into(),
            "2: found `1 atoms` and 2 rows of them",
        ),
        ("Atoms # sphere\n\n1 1 2 1 0 0 0\n2 1 2 1 3 0 0\n1 1 2 1 6 0 0\n".into(), "5: found the id 1 twice"),
        (with("Velocities\n\n1 0 0\n"), "7: found 3 columns, expected 4, or 7 with spins"),
        (with("Velocities\n\n1 0 0 0 0\n"), "7: found 5 columns, expected 4, or 7 with spins"),
        (with("Velocities\n\n1.5 0 0 0\n"), "7: found `1.5`, expected an integer"),
        (with("Velocities\n\n1 0 0 0\n2 0 0 0 1 1 1\n"), "8: found 7 columns, expected as many as in the rows above"),
        (with("Velocities\n\n1 0 0 b\n"), "7: found `b`, expected a number"),
        (with("Velocities\n\n2 0 0 0\n"), "3: found no row for 1 in the section `Velocities`"),
    ] {
        assert_eq!(data(&text).map(|found| found.spheres), Err(format!("a.data:{expected}")), "{text}");
    }
}

#[test]
fn velocities_go_by_their_ids_among_comments_and_other_sections() {
    let text = "Velocities\n\nAtoms # sphere\n\n3 1 2 1 0 0 0\n# a remark\n1 1 4 1 5 0 0 # b\n\nBonds\n\n1 1 1 3\n\nVelocities # sphere\n\n# c\n\
        1 1 2 3 0 0 1\n3 4 5 6 7 8 9 # d\n\nBonds\n\nno\n";
    let found = data(text).unwrap();
    assert_eq!(found.spheres.iter().map(|s| s.radius).collect::<Vec<_>>(), [2.0, 1.0]);
    assert_eq!(found.extras.v, [Vec3([1.0, 2.0, 3.0]), Vec3([4.0, 5.0, 6.0])]);
    assert_eq!(found.extras.w, [Vec3([0.0, 0.0, 1.0]), Vec3([7.0, 8.0, 9.0])]);
}

#[test]
fn it_is_said_that_a_density_is_not_read() {
    let options = Options { unit: Some(1.0), radius: Some(1.0), ..Options::default() };
    for (name, text, said) in [
        ("dense.data", "Atoms # bpm/sphere\n\n1 0 1 2 1 0 0 0\n", true),
        ("light.data", "Atoms # atomic\n\n1 1 0 0 0\n", false),
    ] {
        let options = if said { Options { radius: None, ..options } } else { options };
        assert!(parse(Path::new(name), text, &options, &Interrupt::default()).is_ok(), "{name}");
        assert_eq!(was_said(&format!("{name}: the density is not read")), said, "{name}");
    }
}

#[test]
fn a_section_has_its_keyword_alone_or_with_a_style() {
    let of = |text: &str| {
        let source = Source { file: Path::new("a"), text, interrupt: &Interrupt::default() };
        (section(&source).map(|(line, _)| line), announced(&source).map(|(line, number)| (line, number.to_string())))
    };
    assert_eq!(of("Atoms\n1 atoms\n\nAtoms   # sphere\n"), (Some(4), Some((2, "1".into()))));
    assert_eq!(
        of("Atomsphere\nAtoms of soot\n12 atoms of soot\nx atoms\n 3  atoms # all\n4 bonds\n"),
        (None, Some((5, "3".into())))
    );
    assert_eq!(of("3 atoms\nx atoms\n"), (None, Some((1, "3".into()))));
    assert_eq!(of("Atoms\n"), (Some(1), None));
    assert_eq!(of("# 3 atoms\n"), (None, None));
}
