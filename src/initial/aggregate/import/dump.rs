//! LAMMPS dumps in text, of the style `atom` or `custom`.

use super::{Raw, Source};
use crate::error::{Error, notice};

/// How the line begins that names the columns.
const ATOMS: &str = "ITEM: ATOMS";

/// Whether a file is one.
pub(super) fn is_dump(source: &Source) -> bool {
    source.text.starts_with("ITEM: TIMESTEP") && source.lines().any(|(_, line)| line.starts_with(ATOMS))
}

/// The spheres of the first snapshot in the order of their ids, where they are: in the box, or beyond it with `xu yu zu`.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
    let mut lines = source.lines().skip_while(|(_, line)| !line.starts_with(ATOMS));
    let Some((head, names)) = lines.next() else { return Err(source.at(1, "found no line `ITEM: ATOMS`")) };
    let names: Vec<&str> = names[ATOMS.len()..].split_whitespace().collect();
    let place = |name: &str| names.iter().position(|found| *found == name);
    let three = |names: [&str; 3]| Some([place(names[0])?, place(names[1])?, place(names[2])?]);
    let (Some(id), Some(x)) = (place("id"), three(["xu", "yu", "zu"]).or_else(|| three(["x", "y", "z"]))) else {
        let found = names.join(" ");
        return Err(source.at(head, &format!("found the columns `{found}`, expected `id` and `x y z` or `xu yu zu`")));
    };
    let (radius, diameter, body) = (place("radius"), place("diameter"), place("mol"));
    let (v, w) = (three(["vx", "vy", "vz"]), three(["omegax", "omegay", "omegaz"]));
    let mut rows: Vec<(i64, usize, Vec<&str>)> = Vec::new();
    for (k, line) in lines.by_ref().take_while(|(_, line)| !line.starts_with("ITEM:")) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if words.len() != names.len() {
            return Err(source.at(k, &format!("found {} columns, expected {}", words.len(), names.len())));
        }
        let number = words[id].parse();
        rows.push((number.map_err(|_| source.at(k, &format!("found the id `{}`", words[id])))?, k, words));
    }
    if lines.next().is_some() {
        notice(format!("{}: holds several snapshots, the first is read", source.file.display()));
    }
    rows.sort_unstable_by_key(|row| (row.0, row.1));
    if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(source.at(pair[1].1, &format!("found the id {} twice", pair[1].0)));
    }
    let mut raw = Raw::default();
    for (_, k, words) in rows {
        let of = |places: [usize; 3]| places.map(|place| words[place]);
        raw.push(source, k, of(x), radius.or(diameter).map(|place| words[place]))?;
        if let Some(place) = body {
            raw.extras.push_body(source, k, words[place])?;
        }
        raw.extras.push_motion(source, k, v.map(of), w.map(of))?;
    }
    if radius.is_none() {
        raw.radii.iter_mut().for_each(|diameter| *diameter *= 0.5);
    }
    Ok(raw)
}

#[cfg(test)]
mod tests {
    use super::super::{Extras, Format, Imported, Options, parse};
    use super::*;
    use crate::error::was_said;
    use crate::interrupt::Interrupt;
    use crate::spec::Vec3;
    use std::path::Path;

    const HEAD: &str = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n";

    /// The content of a dump of some columns and rows; the rows begin in line 10.
    fn dump(columns: &str, rows: &str) -> Result<Imported, String> {
        let text = format!("{HEAD}ITEM: ATOMS{columns}\n{rows}");
        let options = Options { unit: Some(1.0), radius: None, disconnected: true, format: None };
        let found = parse(Path::new("a.dump"), text, &options, &Interrupt::default());
        found.map_err(|error| error.to_string())
    }

    fn places(found: &Imported) -> Vec<([f64; 3], f64)> {
        found.spheres.iter().map(|sphere| (sphere.centre.0, sphere.radius)).collect()
    }

    #[test]
    fn columns_go_by_their_names_in_any_order_and_spheres_by_their_ids() {
        let columns = " omegaz vx mol id radius diameter y xu x omegay vz vy yu z zu omegax type";
        let rows = "6 1 2 9 1.5 7 0 20 0 5 3 2 30 0 40 4 1\n0 0 0 -3 2.5 7 0 50 0 0 0 0 60 0 70 0 1\n";
        let found = dump(columns, rows).unwrap();
        assert_eq!(found.format, Format::Dump);
        assert_eq!(places(&found), [([50.0, 60.0, 70.0], 2.5), ([20.0, 30.0, 40.0], 1.5)]);
        let moving = |u| [[0.0; 3], u].map(Vec3).to_vec();
        let expected = Extras { bodies: vec![0, 2], v: moving([1.0, 2.0, 3.0]), w: moving([4.0, 5.0, 6.0]) };
        assert_eq!(found.extras, expected);
    }

    #[test]
    fn a_diameter_counts_by_half_and_places_in_the_box_where_no_others_are() {
        let rows = "2 8 0 1 3\n1 0 0 1 5\n";
        let found = dump(" id x y z diameter", rows).unwrap();
        assert_eq!(places(&found), [([0.0, 0.0, 1.0], 2.5), ([8.0, 0.0, 1.0], 1.5)]);
        assert_eq!(found.extras, Extras::default());
        let again = format!("{rows}{HEAD}ITEM: ATOMS id x y z diameter\n1 0 0 0 1\n");
        assert_eq!(places(&dump(" id x y z diameter", &again).unwrap()), places(&found));
    }

    #[test]
    fn it_is_said_that_only_the_first_snapshot_is_read() {
        let text = format!("{HEAD}ITEM: ATOMS id x y z radius\n1 0 0 0 1\n");
        let options = Options { unit: Some(1.0), ..Options::default() };
        for (name, text, said) in [("one.dump", text.clone(), false), ("two.dump", text.repeat(2), true)] {
            assert!(parse(Path::new(name), text, &options, &Interrupt::default()).is_ok());
            assert_eq!(was_said(&format!("{name}: holds several snapshots, the first is read")), said, "{name}");
        }
    }

    #[test]
    fn what_is_no_table_of_spheres_is_reported_with_its_line() {
        let columns = " id x y z radius";
        for (columns, rows, expected) in [
            (" x y z radius", "", ":9: found the columns `x y z radius`, expected `id` and `x y z` or `xu yu zu`"),
            (" id x y zu radius", "", ":9: found the columns `id x y zu radius`, expected"),
            (" id xs ys zs radius", "", ":9: found the columns `id xs ys zs radius`, expected"),
            (columns, "1 0 0 0\n", ":10: found 4 columns, expected 5"),
            (columns, "1 0 0 0 1\n1 0 0 0 1 2\n", ":11: found 6 columns, expected 5"),
            (columns, "1.5 0 0 0 1\n", ":10: found the id `1.5`"),
            (columns, "2 0 0 0 1\n1 5 5 0 1\n2 9 9 0 1\n", ":12: found the id 2 twice"),
            (columns, "1 0 0 no 1\n", ":10: found `no`, expected a number"),
            (columns, "1 0 0 0 0\n", ":10: found a radius of `0`, expected one above 0"),
            (" id x y z radius mol", "1 0 0 0 1 -2\n", ":10: found `-2`, expected the number of a rigid body"),
            (" id x y z radius vx vy vz", "1 0 0 0 1 2 3 c\n", ":10: found `c`, expected a number"),
            (columns, "", ": found no spheres"),
        ] {
            let trouble = dump(columns, rows).unwrap_err();
            assert!(trouble.starts_with(&format!("a.dump{expected}")), "{columns}, {rows}: {trouble}");
        }
    }

    #[test]
    fn a_dump_begins_with_a_time_and_has_atoms() {
        let is = |text: &str| is_dump(&Source { file: Path::new("a"), text, interrupt: &Interrupt::default() });
        let atoms = "ITEM: ATOMS id x y z\n";
        assert_eq!([format!("{HEAD}{atoms}"), HEAD.into(), atoms.into()].map(|text| is(&text)), [true, false, false]);
        let options = Options { format: Some(Format::Dump), ..Options::default() };
        let trouble = parse(Path::new("a"), "1 0 0 0\n", &options, &Interrupt::default()).unwrap_err();
        assert_eq!(trouble.to_string(), "a:1: found no line `ITEM: ATOMS`");
    }
}
