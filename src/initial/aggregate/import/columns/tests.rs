use super::super::{Imported, Options, parse};
use super::*;
use crate::error::was_said;
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use std::path::Path;

const NM: Options = Options { format: None, unit: Some(1.0), radius: None, disconnected: true };

fn read(text: &str, options: &Options) -> Result<Imported, String> {
    parse(Path::new("a.txt"), text, options, &Interrupt::default()).map_err(|error| error.to_string())
}

fn first(text: &str) -> ([f64; 3], f64) {
    let found = read(text, &NM).unwrap_or_else(|trouble| panic!("{text}: {trouble}"));
    (found.spheres[0].centre.0, found.spheres[0].radius)
}

#[test]
fn the_most_decimals_of_a_coordinate_count() {
    for (rows, expected) in [
        ("C 1 2 3 0.5\n", 0),
        ("C 1. 2 3 0.5\n", 0),
        ("C 1.5 2 3 0.25\n", 1),
        ("C 1 2 3.125 0.5\nC 9 9.25 9 0.5\n", 3),
        ("C 1 2.5 3 0.5\nC 9 9.25 9.0 0.5\n", 2),
        ("C 1.5 1 2e1 0.5\nC 9 9.25 9 0.5\n", usize::MAX),
        ("C 1.5 1 2D1 0.5\n", usize::MAX),
    ] {
        let found = read(&format!("{}\n\n{rows}", rows.lines().count()), &NM).unwrap();
        assert_eq!(found.decimals, expected, "{rows}");
    }
}

#[test]
fn rows_are_four_numbers_before_refractive_indices_and_between_brackets_and_commas() {
    let radius_first = Options { format: Some(Format::Mstm), ..NM };
    let centre =
        |text: &str| read(text, &radius_first).map(|found| (found.spheres[0].centre.0, found.spheres[0].radius));
    let expected = Ok(([2.0, 3.0, 4.0], 1.0));
    for text in [
        "1 2 3 4\n",
        "# r x y z\n\n 1, 2, 3, 4\n",
        "1 2 3 4 (1.5,0.1)\n",
        "1\t2 3 4 1.5 0.1 1.6 0.2\n",
        "1d0 2.0D0 3e0 40E-1\n",
    ] {
        assert_eq!(centre(text), expected, "{text}");
    }
    for (text, columns) in [("1 2 3\n", 3), ("1 2 3 4 5\n", 5), ("1 2 3 4 5 6 7\n", 7), ("1 2 3 4 5 6 7 8 9\n", 9)] {
        let what = "expected 4: a centre and a radius, or 6 or 8 with the refractive indices of MSTM";
        assert_eq!(centre(text), Err(format!("a.txt:1: found {columns} columns, {what}")));
    }
}

#[test]
fn the_order_of_columns_is_the_one_whose_spheres_hang_together_or_that_goes_well_for_longer() {
    for (text, expected) in [
        // Radii of 1 before centres 2 apart, and after them.
        ("1 0 0 0\n1 2 0 0\n", Ok(Format::Mstm)),
        ("0 0 0 1\n2 0 0 1\n", Ok(Format::FracVal)),
        // The radius of the other order is no radius, whether the spheres hang together or not.
        ("1 0 0 0\n1 9 0 0\n", Ok(Format::Mstm)),
        ("0 0 0 1\n9 0 0 1\n", Ok(Format::FracVal)),
        // The other order is one of spheres apart.
        ("1 0 0 0.1\n1 2 0 0.1\n", Ok(Format::Mstm)),
        ("0.1 0 0 1\n0.1 2 0 1\n", Ok(Format::FracVal)),
        // Both orders are of one part, or both of several.
        ("2 4 2 2\n2 2 2 2\n", Err("format: is missing, expected `mstm`")),
        ("1 90 0 1\n1 0 90 1\n", Err("format: is missing, expected `mstm`")),
        // Neither is: the error is that of the order that came farther.
        ("1 5 5 0\n1 7 5 0\n0 9 5 0\n", Err("a.txt:3: found a radius of `0`")),
        ("5 5 0 1\n0 5 0 1\n5 9 0 0\n", Err("a.txt:3: found a radius of `0`")),
        ("0 5 0 1\n1 5 0 0\n", Err("a.txt:2: found a radius of `0`")),
        ("a 0 0 b\n", Err("a.txt:1: found `a`")),
    ] {
        match (read(text, &NM), expected) {
            (Ok(found), Ok(format)) => assert_eq!(found.format, format, "{text}"),
            (Err(trouble), Err(expected)) => assert!(trouble.contains(expected), "{text}: {trouble}"),
            (found, _) => panic!("{text}: {found:?}"),
        }
    }
}

#[test]
fn values_in_a_comment_are_found_by_key_in_quotes_or_without() {
    let comment = " a=1 text in between Stage = 'a b=2' Lattice=\"1 0 c=3\" d= 4 e='open f=5";
    for (key, expected) in [
        ("a", Some("1")),
        ("stage", Some("a b=2")),
        ("LATTICE", Some("1 0 c=3")),
        ("d", Some("4")),
        ("e", Some("open f=5")),
        ("text", None),
        ("b", None),
        ("c", None),
        ("f", None),
    ] {
        assert_eq!(property(comment, key).as_deref(), expected, "{key}");
    }
    assert_eq!(property("", "a"), None);
}

#[test]
fn named_columns_are_read_wherever_they_stand() {
    let sphere = ([1.0, 2.0, 3.0], 0.5);
    for (properties, row) in [
        ("species:S:1:pos:R:3:radius:R:1", "C 1 2 3 0.5"),
        ("radius:R:1:positions:R:3", "0.5 1 2 3"),
        ("id:I:2:Position:R:3:type:I:1:RADII:R:1", "7 7 1 2 3 7 0.5"),
        ("diameter:R:1:charge:R:2:pos:R:3", "1 7 7 1 2 3"),
        // The radius counts beside a diameter; columns of another width are others.
        ("diameter:R:1:radius:R:1:pos:R:3", "9 0.5 1 2 3"),
        ("radius:R:1:diameter:R:1:pos:R:3", "0.5 9 1 2 3"),
        ("pos:R:3:radius:R:2:radius:R:1", "1 2 3 9 9 0.5"),
        ("pos:R:2:pos:R:3:radius:R:1", "9 9 1 2 3 0.5"),
    ] {
        assert_eq!(first(&format!("1\nProperties={properties}\n{row}\n")), sphere, "{properties}");
    }
    let wide = format!("1\nProperties=a:R:1000:pos:R:3:radius:R:1\n{}1 2 3 0.5\n", "0 ".repeat(1000));
    assert_eq!(first(&wide), sphere);
    let text =
        "1\nProperties=pos:R:3:molecule:I:1:velo:R:3:angular_velocity:R:3:radius:R:1\n1 2 3 4 5 6 7 8 9 10 0.5\n";
    let extras = read(text, &NM).unwrap().extras;
    assert_eq!(
        (extras.bodies, extras.v, extras.w),
        (vec![4], vec![Vec3([5.0, 6.0, 7.0])], vec![Vec3([8.0, 9.0, 10.0])])
    );
}

#[test]
fn what_is_no_frame_is_reported_with_its_line() {
    let named = |rest: &str| format!("1\nProperties={rest}");
    for (text, expected) in [
        ("3\n\nC 0 0 0 1\n\nC 9 0 0 1\n".to_string(), "4: found 1 spheres, expected 3, the number in the first line"),
        ("3\n".into(), "2: found 0 spheres, expected 3, the number in the first line"),
        ("2\n\nC 0 0 0 1\nC 9 0 0\n".into(), "4: expected a radius in every row or in none"),
        ("2\n\nC 0 0 0\nC 9 0 0 1\n".into(), "4: expected a radius in every row or in none"),
        ("1\n\nC 0 0\n".into(), "3: found 3 columns, expected at least 4"),
        (
            "1\n\n0 0 0 0 1\n".into(),
            "3: found `0`, expected a species in the first column: rows `x y z r` are of the format `fracval`, or `Properties` in line 2 names the columns",
        ),
        (
            "1\n\n1.5 0 0 0 1\n".into(),
            "3: found `1.5`, expected a species in the first column: rows `x y z r` are of the format `fracval`, or `Properties` in line 2 names the columns",
        ),
        ("1\n\nC 0 0 0 1\n\nend\n".into(), "5: found more rows than the 1 spheres of the first line"),
        (named("pos:R:3:a:R:0\n"), "2: found `Properties=pos:R:3:a:R:0`, expected a number of columns for `a`"),
        (named("pos:R:3:a:R:1001\n"), "2: found `Properties=pos:R:3:a:R:1001`, expected a number of columns for `a`"),
        (named("pos:R:3:a:R:x\n"), "2: found `Properties=pos:R:3:a:R:x`, expected a number of columns for `a`"),
        (
            named("pos:R:3:radius\n"),
            "2: found `Properties=pos:R:3:radius`, expected name, type and number of columns for each property",
        ),
        (
            named("pos:R:2:radius:R:1\n"),
            "2: found `Properties=pos:R:2:radius:R:1`, expected `pos:R:3` among the properties",
        ),
        (named("pos:R:3:radius:R:1\n0 0 0\n"), "3: found 3 columns, expected 4, as `Properties` lists"),
        (named("pos:R:3:radius:R:1\n0 0 0 1 1\n"), "3: found 5 columns, expected 4, as `Properties` lists"),
        (
            named("pos:R:3:radius:R:1:body:I:1\n0 0 0 1 0.5\n"),
            "3: found `0.5`, expected the number of a rigid body, or 0 for a sphere by itself",
        ),
        (named("pos:R:3:radius:R:1:velo:R:3\n0 0 0 1 0 0 a\n"), "3: found `a`, expected a number"),
    ] {
        assert_eq!(read(&text, &NM).map(|found| found.spheres), Err(format!("a.txt:{expected}")), "{text}");
    }
    // With the format given, the first line need be no number.
    let trouble = read("C 0 0 0\n", &Options { format: Some(Format::Xyz), ..NM }).unwrap_err();
    assert_eq!(trouble, "a.txt:1: found `C 0 0 0`, expected the number of spheres");
}

#[test]
fn the_first_of_several_frames_is_read() {
    let two = "1\n\nC 1 2 3 0.5\n\n1\n\nC 0 0 0 9\n";
    assert_eq!(first(two), ([1.0, 2.0, 3.0], 0.5));
    assert_eq!(read(two, &NM).unwrap().spheres.len(), 1);
    // An atomic number is a species too.
    assert_eq!(first("1\n\n14 1 2 3 0.5\n"), ([1.0, 2.0, 3.0], 0.5));
}

#[test]
fn what_is_left_out_is_said() {
    let parsed = |name: &str, text: &str| parse(Path::new(name), text, &NM, &Interrupt::default()).map(|_| ()).is_ok();
    let two = "1\n\nC 0 0 0 1\n1\n\nC 0 0 0 1\n";
    assert!(parsed("one.xyz", &two[..two.len() / 2]) && parsed("two.xyz", two));
    let frames = |name: &str| was_said(&format!("{name}: holds several frames, the first is read"));
    assert_eq!([frames("one.xyz"), frames("two.xyz")], [false, true]);
    // Frames of this program have columns that are no part of a sample; it knows its own by their stage.
    let unread = |name: &str, columns: &str| was_said(&format!("{name}: the columns {columns} are not read"));
    let properties = "Properties=pos:R:3:radius:R:1:mass:R:1:charge:R:1";
    assert!(parsed("own.xyz", &format!("1\n{properties} stage=end\n0 0 0 1 1 1\n")) && unread("own.xyz", "charge"));
    assert!(parsed("other.xyz", &format!("1\n{properties}\n0 0 0 1 1 1\n")) && unread("other.xyz", "mass, charge"));
    assert!(parsed("all.xyz", "1\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n") && !unread("all.xyz", ""));
}
