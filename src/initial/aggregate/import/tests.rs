use super::{parse as parse_with, read as read_with, *};
use crate::initial::aggregate::{Method, Radii, Recipe, aggregate};
use crate::interrupt::Interrupt;
use quickcheck::quickcheck;
use std::path::PathBuf;

fn read(file: &Path, options: &Options) -> Result<Imported, Error> {
    read_with(file, options, &Interrupt::default())
}

fn parse(file: &Path, text: &str, options: &Options) -> Result<Imported, Error> {
    parse_with(file, text, options, &Interrupt::default())
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aggregates").join(name)
}

const UNIT: Options = Options { format: None, unit: Some(1.0), radius: None, disconnected: false };
const RADIUS: Options = Options { format: None, unit: None, radius: Some(14.0), disconnected: false };
const BOTH: Options = Options { format: None, unit: Some(1.0), radius: Some(14.0), disconnected: false };
const NEITHER: Options = Options { format: None, unit: None, radius: None, disconnected: false };

#[test]
fn three_spheres_are_the_same_in_every_format() {
    let expected: Vec<Sphere> =
        [[-28.0, 0.0, 0.0], [0.0; 3], [0.0, 28.0, 0.0]].map(|x| Sphere { centre: Vec3(x), radius: 14.0 }).to_vec();
    for (name, format, options) in [
        ("flage.xml", Format::Flage, RADIUS),
        ("mstm.txt", Format::Mstm, RADIUS),
        ("mstm3.pos", Format::Mstm, RADIUS),
        ("mstm4.pos", Format::FracVal, RADIUS),
        ("fracval.dat", Format::FracVal, UNIT),
        ("pyfracval.dat", Format::PyFracVal, UNIT),
        ("soot_dem.vtk", Format::Vtk, RADIUS),
        ("lammps.data", Format::Lammps, UNIT),
        ("plain.xyz", Format::Xyz, BOTH),
        ("extended.xyz", Format::Xyz, UNIT),
    ] {
        let found = read(&file(name), &options).unwrap();
        assert_eq!((found.format, &found.spheres), (format, &expected), "{name}");
        let Report { number, smallest_gap, overlaps, components } = found.report(&Interrupt::default()).unwrap();
        assert_eq!((number, smallest_gap, overlaps, components), (3, Some(0.0), 0, 1));
        let trouble = read(&file(name), &NEITHER).unwrap_err().to_string();
        let key = if found.format == Format::Flage || found.format == Format::Vtk { "radius" } else { "unit" };
        assert!(trouble.contains(&format!(" {key}: is missing, expected the ")), "{name}: {trouble}");
    }
}

#[test]
fn rounding_to_single_precision_is_no_overlap() {
    let recipe = Recipe { number: 400, d_f: 1.8, k_f: 1.4, radii: Radii::Equal(14.0), method: Method::Clusters };
    let mut spheres = aggregate(&recipe, 1, &Interrupt::default()).unwrap();
    for sphere in &mut spheres {
        sphere.centre = Vec3(sphere.centre.0.map(|x| f64::from((x + 1000.0) as f32)));
    }
    let report = Report::of(&spheres, 1, &Interrupt::default()).unwrap();
    assert!(report.overlaps == 0 && report.smallest_gap < Some(-28e-6), "{report}");
    let pair = |gap| [0.0, 28.0 + gap].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 14.0 });
    assert_eq!([-1e-5, -1e-4].map(|gap| Report::of(&pair(gap), 1, &Interrupt::default()).unwrap().overlaps), [0, 1]);
}

#[test]
fn image_flags_of_lammps_place_a_sphere_in_another_copy_of_the_box() {
    let box_of =
        |tilt| format!("0 100 xlo xhi\n0 100 ylo yhi\n0 50 zlo zhi\n{tilt} 0 0 xy xz yz\n\nAtoms # sphere\n\n");
    let rows = "1 1 28 1 90 0 0 0 0 0\n2 1 28 1 18 0 50 1 0 -1\n";
    let found = parse(Path::new("a.data"), &(box_of("0") + rows), &UNIT).unwrap();
    assert_eq!(found.spheres[1].centre, Vec3([118.0, 0.0, 0.0]));
    let trouble = parse(Path::new("a.data"), &(box_of("5") + rows), &UNIT).unwrap_err().to_string();
    assert!(trouble.starts_with("a.data:9: found image flags, expected none: the box is tilted"), "{trouble}");
}

#[test]
fn a_fifth_column_of_plain_xyz_is_the_radius_only_if_it_is_the_last() {
    let radii = |text: &str, options: &Options| {
        let found = parse(Path::new("a.xyz"), text, options).map_err(|trouble| trouble.to_string());
        found.map(|found| found.spheres.iter().map(|s| s.radius).collect::<Vec<_>>())
    };
    assert_eq!(radii("1\n\nC 0 0 0 7\n", &UNIT), Ok(vec![7.0]));
    assert_eq!(radii("1\n\nC 0 0 0 -0.765 1 0\n", &BOTH), Ok(vec![14.0]));
    let trouble = radii("1\n\nC 0 0 0 0.7 1 0\n", &UNIT).unwrap_err();
    assert!(trouble.contains("radius: is missing") && trouble.contains("fifth and last column"), "{trouble}");
}

#[test]
fn a_mark_of_the_encoding_and_foreign_letters_are_no_hindrance() {
    let folder = tempfile::tempdir().unwrap();
    for (name, options, comment) in [
        ("flage.xml", RADIUS, &b"<!-- \xe9 -->"[..]),
        ("mstm.txt", RADIUS, b"# \xe9\n"),
        ("plain.xyz", BOTH, b""),
        ("soot_dem.vtk", RADIUS, b"\xe9"),
    ] {
        let text = std::fs::read(file(name)).unwrap();
        let marked = folder.path().join(name);
        std::fs::write(&marked, [&b"\xef\xbb\xbf"[..], &text, comment].concat()).unwrap();
        assert_eq!(read(&marked, &options).unwrap().spheres, read(&file(name), &options).unwrap().spheres, "{name}");
    }
}

#[test]
fn a_unit_replaces_the_radius_where_the_file_has_radii() {
    let metres = Options { unit: Some(14.0), ..NEITHER };
    assert_eq!(read(&file("mstm.txt"), &metres).unwrap().spheres, read(&file("mstm.txt"), &RADIUS).unwrap().spheres);
    assert!(read(&file("mstm.txt"), &BOTH).unwrap_err().to_string().contains("expected only one of them"));
}

#[test]
fn necks_are_read_from_the_places_in_a_matrix() {
    let spheres = read(&file("soot_dem.vtk"), &RADIUS).unwrap().spheres;
    assert_eq!(read_necks(&file("soot_dem_necks.vtk"), &spheres, &Interrupt::default()).unwrap(), [(0, 1), (1, 2)]);
    let trouble =
        read_necks(&file("soot_dem_necks.vtk"), &spheres[..2], &Interrupt::default()).unwrap_err().to_string();
    assert!(trouble.contains("necks.vtk:15: found `3`, expected i * 2 + j"), "{trouble}");
}

#[test]
fn necks_of_another_aggregate_are_refused() {
    let spheres = read(&file("soot_dem.vtk"), &RADIUS).unwrap().spheres;
    let folder = tempfile::tempdir().unwrap();
    for (connections, expected) in [
        ("2 1 int\n2\n6\n", ":2: found 2, a neck of the spheres 0 and 2, whose gap is 11.598 nm, expected at most 0.1"),
        ("2 1 int\n1\n5\n", ":2: found 1, a neck of the spheres 0 and 1, but not 3, expected each neck from both ends"),
        ("4294967296 4294967296 int\n1\n", ":1: found 4294967296 times 4294967296 connections"),
    ] {
        let necks = folder.path().join("necks.vtk");
        std::fs::write(&necks, format!("connections {connections}")).unwrap();
        let trouble = read_necks(&necks, &spheres, &Interrupt::default()).unwrap_err().to_string();
        assert!(trouble.contains(expected), "{trouble}");
    }
}

#[test]
fn errors_name_file_line_and_what_was_expected() {
    for (text, expected) in [
        ("", "found nothing"),
        ("1 0 0 0\n1 0 2\n", ":2: found 3 columns, expected 4"),
        ("1 0 0 0\n1 0 2 x\n", ":2: found `x`, expected a number"),
        ("2\n\nC 0 0 0\nC 1e300 0 0\n", ":4: found a coordinate of 7.14"),
        ("1 0 0 0\n1 0 0 1e300\n", ":2: found a coordinate of 1e300 radii, expected at most 1e6"),
        ("3\n\nC 0 0 0\nC 0 0 2\n", ":5: found 2 spheres, expected 3"),
        ("1\n\nC 0 0\n", ":3: found 3 columns, expected at least 4"),
        ("1\n\nC 0 0 0\nC 0 0 2\n", ":4: found more rows than the 1 spheres"),
        (
            "<geometry_complex>\n<particle><position>1, 2</position></particle></geometry_complex>",
            ":2: found 2 numbers, expected the 3",
        ),
        ("<a>\n</b>", ":2: is not well-formed XML"),
        (
            "# vtk DataFile Version 4.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 FLOAT\n0 0 0 1",
            ":6: the file ends here, expected coordinates of 2 points",
        ),
        ("# vtk DataFile Version 4.0\nt\nBINARY\n", ":3: found `BINARY`"),
        ("2 atoms\n\nAtoms # sphere\n\n1 1 1 1 0 0 0\n", ":1: found `2 atoms` and 1 rows"),
        ("Atoms # sphere\n\n1 1 1 1 0 0 0 1 0 0\n", ":3: found image flags, expected none"),
        ("Atoms # sphere\n\n1 1 1 1 0 0 0 1\n", ":3: found 8 columns, expected 7, or 10 with image flags"),
        ("Atoms # sphere\n\n2 1 1 1 0 0 0\n2 1 1 1 1 0 0\n", ":4: found the id 2 twice"),
        ("1 atoms\n\nAtoms # oxdna\n", ":3: found `Atoms # oxdna`, expected `Atoms # sphere`"),
        ("3 40 0 5\n1 2 9 6\n", "format: is missing, expected `mstm`"),
    ] {
        let trouble = parse(Path::new("a.txt"), text, &BOTH).unwrap_err().to_string();
        assert!(trouble.starts_with("a.txt:") && trouble.contains(expected), "{text}: {trouble}");
    }
}

#[test]
fn a_format_may_be_given_where_the_rows_do_not_tell() {
    let rows = "2 4 2 2\n2 2 2 2\n";
    let read = |format| parse(Path::new("a.txt"), rows, &Options { format, unit: Some(1.0), ..Options::default() });
    assert!(read(None).unwrap_err().to_string().contains("format: is missing"));
    let first = |format| read(Some(format)).unwrap().spheres[0].centre;
    assert_eq!(first(Format::Mstm), Vec3([4.0, 2.0, 2.0]));
    assert_eq!(first(Format::FracVal), Vec3([2.0, 4.0, 2.0]));
}

#[test]
fn anything_may_stand_between_the_numbers_of_flage() {
    let text = "<!DOCTYPE g>\n<g><particle><position>X=0.0sep <!-- y -->1e0; Z:-2</position></particle></g>";
    let found = parse(Path::new("a.xml"), text, &Options { radius: Some(14.0), ..Options::default() }).unwrap();
    assert_eq!(found.spheres[0].centre, Vec3([0.0, 14.0, -28.0]));
}

#[test]
fn parts_that_do_not_touch_are_refused_unless_asked_for() {
    let text = "2\n\nC 0 0 0\nC 0 0 30\n";
    let trouble = parse(Path::new("a.xyz"), text, &BOTH).unwrap_err().to_string();
    assert!(trouble.contains("found 2 parts that do not touch"), "{trouble}");
    let found = parse(Path::new("a.xyz"), text, &Options { disconnected: true, ..BOTH }).unwrap();
    let report = found.report(&Interrupt::default()).unwrap();
    assert_eq!((report.components, report.smallest_gap), (2, Some(2.0)));
}

#[test]
fn what_is_misread_elsewhere_is_refused_by_line() {
    for (text, expected) in [
        ("3\nx\n-28.0 0.0 0.0 14\n0 0 0 14\n0 28 0 14\n", ":3: found `-28.0`, expected a species in the first column"),
        ("2\n\nC 0 0 0 1\n0 0 0 2 1\n", ":4: found `0`, expected a species"),
        (
            "1\nProperties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0\n",
            ":3: found 4 columns, expected 5, as `Properties` lists",
        ),
        (
            "1\nProperties=species:S:1:pos:R\nC 0 0 0\n",
            ":2: found `Properties=species:S:1:pos:R`, expected name, type and",
        ),
        ("1\nProperties=species:S:1:radius:R:1\nC 0\n", "expected `pos:R:3` among the properties"),
        ("3\n\nC 0 0 0 1\nC 2 0 0 1\nC -0.0 0 0 1\n", ":5: found the centre of the sphere in line 3 again"),
        ("1 atoms\n\nAtoms\n\n1 1 1 1 0 0 0\n", ":3: found `Atoms`, expected `Atoms # sphere`, another style"),
        ("1 atoms\n\nAtoms # hybrid\n\n1 1 1 1 0 0 0\n", ":3: found `Atoms # hybrid`, expected"),
        ("1\n\nC 0 0 \u{0}\n", ":3: found `\u{0}`, expected a number"),
        ("1\n\nC 0 nan 0\n", ":3: found `nan`, expected a number"),
        ("1 0 0 0\n1 2 0 inf\n", ":2: found `inf`, expected a number"),
    ] {
        let trouble = parse(Path::new("a.txt"), text, &Options { unit: Some(1.0), ..Options::default() });
        let trouble = trouble.map(drop).expect_err(text).to_string();
        assert!(trouble.starts_with("a.txt:") && trouble.contains(expected), "{text}: {trouble}");
    }
}

#[test]
fn dialects_of_xyz_and_lammps_are_read() {
    let header = "-100 100 xlo xhi\n-100 100 ylo yhi\n-100 100 zlo zhi\n\n";
    for text in [
        "2\nAtoms # sphere\nC 0 0 0 14\nC 28 0 0 14\n".to_string(),
        "2\nAtoms. Timestep: 0\n1 0 0 0 14\n2 28 0 0 14\n".into(),
        "2\ntitle=\"a Properties=no\" Properties=\"radius:R:1:species:S:1:pos:R:3\" pbc=\"F F F\"\n14 C 0 0 0\n14 C 28 0 0\n".into(),
        "2\nProperties=species:S:1:Diameter:R:1:pos:R:3\nC 28 0 0 0\nC 28 28 0 0\n".into(),
        "2\n\nC 0 0 0 14\nC 28 0 0 14\n2\n\nC 1 0 0 14\nC 29 0 0 14\n".into(),
        format!("Atoms of a soot dimer\n\n2 atoms\n\n{header}Atoms # sphere\n\n1 1 28 1 0 0 0\n2 1 2.8e1 1 28 0 0\n\nVelocities\n\n1 0 0 0\n2 0 0 0\n"),
        format!("150 atoms in 2 parts\n\n2 atoms # in all\n\n{header}Atoms # sphere\n\n# id\n1 1 28 1 0 0 0 0 0 0\n2 1 28 1 28 0 0 0 0 0\n"),
        format!("Atoms # sphere\n\n2 atoms\n\n{header}Atoms  # hybrid sphere bond\n\n1 1 0 0 0 28 1 1\n2 1 28 0 0 28 1 1 # b\n"),
        format!("Atoms\n\n2 atoms\n\n{header}Atoms # hybrid bond sphere\n\n1 1 0 0 0 1 28 1\n2 1 28 0 0 1 28 1\n"),
    ] {
        let found = parse(Path::new("a.txt"), &text, &Options { unit: Some(1.0), ..Options::default() });
        let found = found.unwrap_or_else(|error| panic!("{text}: {error}")).spheres;
        assert_eq!((found[1].centre, found[0].radius, found[1].radius), (Vec3([28.0, 0.0, 0.0]), 14.0, 14.0), "{text}");
    }
    let full = format!("2 atoms\n\n{header}Atoms # full\n\n1 1 1 -0.8 0 0 0\n2 1 1 0.4 28 0 0\n");
    assert_eq!(
        parse(Path::new("a.txt"), &full, &BOTH).map_err(|error| error.to_string()).unwrap().spheres[1].radius,
        14.0
    );
}

#[test]
fn formats_that_are_known_and_not_supported_are_named() {
    let folder = tempfile::tempdir().unwrap();
    for (bytes, expected) in [
        (&b"ITEM: TIMESTEP\n0\n"[..], "a LAMMPS dump of something other than atoms"),
        (b"<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">", "an XML VTK file (VTP, VTU)"),
        (b"\xff\xfe3\0", "text in UTF-16"),
        (b"\x1f\x8b\x08", "a gzip archive"),
        (b"PK\x03\x04", "a zip archive"),
        (b"\x89HDF\r\n", "an HDF5 file"),
        (b"\xdf\x65\xdf\x65\xdf\x65\xdf\x65", "a GSD file"),
    ] {
        let foreign = folder.path().join("foreign");
        std::fs::write(&foreign, bytes).unwrap();
        let trouble = read(&foreign, &BOTH).unwrap_err().to_string();
        assert!(trouble.contains(&format!("found {expected}, which is not supported: ")), "{trouble}");
    }
}

#[test]
fn a_file_whose_unit_and_radius_do_not_fit_ends_at_once() {
    let row = |k: usize| format!("C {} {} {}\n", k % 50, k / 50 % 50, k / 2500);
    let text = format!("100000\n\n{}", (0..100_000).map(row).collect::<String>());
    let trouble = parse(Path::new("a.xyz"), &text, &Options { radius: Some(1000.0), ..BOTH }).unwrap_err().to_string();
    assert!(trouble.contains("unit and radius do not fit"), "{trouble}");
}

quickcheck! {
    fn what_is_written_is_read_back(seed: u64) -> bool {
        let radii = Radii::LogNormal { median: 14.0, deviation: 1.3 };
        let spheres = aggregate(&Recipe { number: 25, d_f: 1.8, k_f: 1.4, radii, method: Method::Clusters }, seed, &Interrupt::default()).unwrap();
        let rows = |row: &dyn Fn(usize, [f64; 3], f64) -> String| -> String {
            spheres.iter().enumerate().map(|(k, s)| row(k + 1, s.centre.0, s.radius)).collect()
        };
        let files = [
            (Format::Flage, format!("<geometry_complex><data_particle>{}</data_particle></geometry_complex>", rows(&|_, [x, y, z], r| {
                format!("<particle><position>{x} , {y} , {z}</position><radius>{r}</radius></particle>")
            }))),
            (Format::Mstm, rows(&|_, [x, y, z], r| format!("{r} {x} {y} {z}\n"))),
            (Format::FracVal, rows(&|_, [x, y, z], r| format!("{x:e} {y:e} {z:e} {r:e}\n"))),
            (Format::PyFracVal, format!("# generation_info:\n{}", rows(&|_, [x, y, z], r| format!("{x:.17e} {y:.17e} {z:.17e} {r:.17e}\n")))),
            (Format::Lammps, format!("25 atoms\n\nAtoms # bpm/sphere\n\n{}", rows(&|k, [x, y, z], r| format!("{k} 1 1 {} 1.7 {x} {y} {z}\n", 2.0 * r)))),
            (Format::Xyz, extended_xyz(&spheres, &Extras::default())),
            (Format::Xyz, format!("25\n\n{}", rows(&|_, [x, y, z], r| format!("C {x} {y} {z} {r}\n")))),
        ];
        files.iter().all(|(format, text)| {
            let found = parse(Path::new("a"), text, &UNIT).unwrap();
            found.format == *format && found.spheres == spheres
        })
    }
}

#[test]
fn an_input_file_of_mstm_is_named_with_its_remedy() {
    let trouble = read(&file("mstm.inp"), &UNIT).unwrap_err().to_string();
    assert!(trouble.contains("found an MSTM input file") && trouble.contains("`sphere_data`"), "{trouble}");
}

#[test]
fn aggregates_of_pyfracval_touch_or_overlap_as_its_tolerance_says() {
    let smallest = |name: &str| {
        let found = read(&file(name), &UNIT).unwrap();
        assert_eq!(
            (
                found.format,
                found.report(&Interrupt::default()).unwrap().number,
                found.report(&Interrupt::default()).unwrap().components
            ),
            (Format::PyFracVal, 20, 1),
            "{name}"
        );
        found.report(&Interrupt::default()).unwrap().smallest_gap.unwrap()
    };
    assert!(smallest("pyfracval_polydisperse.dat") > -1e-4);
    assert!((-1.5..-0.5).contains(&smallest("pyfracval_overlapping.dat")), "{}", smallest("pyfracval_overlapping.dat"));
}

#[test]
fn every_reader_stops_when_it_is_asked_to() {
    let interrupt = Interrupt::default();
    interrupt.request();
    let vtk = "# vtk DataFile Version 4.0\nt\nASCII\nPOINTS 1 float\n0 0 0\n";
    for (format, text) in [
        (Format::Flage, "<g><particle><position>0 0 0</position></particle></g>"),
        (Format::Mstm, "1 0 0 0\n"),
        (Format::FracVal, "0 0 0 1\n"),
        (Format::Vtk, vtk),
        (Format::Lammps, "Atoms # sphere\n\n1 1 2 1 0 0 0\n"),
        (Format::Dump, "ITEM: ATOMS id x y z\n1 0 0 0\n"),
        (Format::Xyz, "1\n\nC 0 0 0 1\n"),
        (Format::Csv, "0,0,0,1\n"),
    ] {
        let source = Source { file: Path::new("a"), text, interrupt: &interrupt };
        let found = raw(&source, &Options { format: Some(format), ..UNIT });
        assert!(matches!(found, Err(Error::Interrupted)), "{format}");
    }
    let source = Source { file: Path::new("a"), text: "", interrupt: &interrupt };
    let sphere = Raw { centres: vec![[0.0; 3]], lines: vec![1], radii: vec![1.0], ..Raw::default() };
    assert!(matches!(scaled(&source, &sphere, &UNIT), Err(Error::Interrupted)));
    let spheres = [0.0, 2.0].map(|x| Sphere { centre: Vec3([x, 0.0, 0.0]), radius: 1.0 });
    for necks in ["0,1\n", "connections 1 1 int 1\n"] {
        let found = parse_necks(Path::new("a"), necks.as_bytes(), &spheres, &interrupt);
        assert!(matches!(found, Err(Error::Interrupted)), "{necks}");
    }
}

#[test]
fn extended_xyz_has_the_columns_that_there_are() {
    let sphere = [Sphere { centre: Vec3([1.0, 2.5, -3.0]), radius: 0.5 }];
    let (v, w) = (vec![Vec3([4.0, 5.0, 6.0])], vec![Vec3([7.0, 8.0, 9.0])]);
    let head = "1\nProperties=species:S:1:pos:R:3:radius:R:1";
    assert_eq!(extended_xyz(&sphere, &Extras::default()), format!("{head}\nX 1 2.5 -3 0.5\n"));
    let all = extended_xyz(&sphere, &Extras { bodies: vec![2], v, w: w.clone() });
    assert_eq!(all, format!("{head}:body:I:1:velo:R:3:angular_velocity:R:3\nX 1 2.5 -3 0.5 2 4 5 6 7 8 9\n"));
    let spin = extended_xyz(&sphere, &Extras { w, ..Extras::default() });
    assert_eq!(spin, format!("{head}:angular_velocity:R:3\nX 1 2.5 -3 0.5 7 8 9\n"));
}

#[test]
fn a_format_is_told_by_the_content() {
    let format = |text: &str| {
        let source = Source { file: Path::new("a"), text, interrupt: &Interrupt::default() };
        detect(&source).map_err(|error| error.to_string())
    };
    let atoms = "Atoms # sphere\n\n1 1 2 1 0 0 0\n";
    for (text, expected) in [
        ("\n <g/>".to_string(), Format::Flage),
        ("\n# vtk DataFile Version 2.0\n".into(), Format::Vtk),
        (format!("12\n\n1 atoms\n\n{atoms}"), Format::Lammps),
        (format!("title\n{atoms}"), Format::Lammps),
        ("1\nAtoms # sphere\nC 0 0 0\n".into(), Format::Xyz),
        ("# by pyfracval\n0 0 0 1\n".into(), Format::PyFracVal),
        ("0 0 0 1\n# generation_info\n".into(), Format::PyFracVal),
        ("# by others\n0 0 0 1\n".into(), Format::FracVal),
        ("\n\n1\n\nC 0 0 0\n".into(), Format::Xyz),
        ("1 0 0 0\n".into(), Format::Mstm),
    ] {
        assert_eq!(format(&text), Ok(expected), "{text}");
    }
    assert_eq!(format("\n \n"), Err("a: found nothing, expected the spheres of an aggregate".into()));
    assert!(format("fracval 0 0 0\n").unwrap_err().contains("found"));
}

#[test]
fn numbers_are_finite() {
    let source = Source { file: Path::new("a"), text: "", interrupt: &Interrupt::default() };
    let number = |word: &str| source.number(7, word).map_err(|error| error.to_string());
    assert_eq!(["1d2", "1D2", "-1e2", ".5"].map(number), [Ok(100.0), Ok(100.0), Ok(-100.0), Ok(0.5)]);
    assert_eq!(number("1e400"), Err("a:7: found `1e400`, expected a number of at most 1.7976931348623157e308".into()));
    for word in ["inf", "nan", "x", ""] {
        assert_eq!(number(word), Err(format!("a:7: found `{word}`, expected a number")));
    }
}
