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
