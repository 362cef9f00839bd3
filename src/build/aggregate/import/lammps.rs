//! LAMMPS data files with spheres.

use super::{Raw, Source};
use crate::error::Error;

/// The section `Atoms # sphere`, rows `id type diameter density x y z`, or `Atoms # bpm/sphere`, with a molecule after the id. In order of the ids.
pub fn read(source: &Source) -> Result<Raw, Error> {
    let keyword = |line: &str| line.starts_with(|c: char| c.is_ascii_alphabetic());
    let mut lines = source.lines().skip_while(|(_, line)| line.split_whitespace().next() != Some("Atoms"));
    let Some((head, title)) = lines.next() else {
        return Err(Error::input(source.file, "found no section `Atoms`"));
    };
    let skipped = match title.split_once('#').map(|(_, style)| style.trim()) {
        Some("sphere") => 0,
        Some("bpm/sphere") => 1,
        style => {
            let what = format!(
                "found `Atoms # {}`, expected `Atoms # sphere` or `Atoms # bpm/sphere`",
                style.unwrap_or_default()
            );
            return Err(source.at(head, &what));
        }
    };
    let mut rows = Vec::new();
    for (k, line) in lines.take_while(|(_, line)| !keyword(line)).filter(|(_, line)| !line.is_empty()) {
        let words: Vec<&str> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let (Some(&id), Some(&[diameter, _, x, y, z])) = (words.first(), words.get(2 + skipped..7 + skipped)) else {
            return Err(source.at(k, &format!("found {} columns, expected at least {}", words.len(), 7 + skipped)));
        };
        let id: u64 = id.parse().map_err(|_| source.at(k, &format!("found `{id}`, expected an id")))?;
        rows.push((id, k, diameter, [x, y, z]));
    }
    let announced = source.lines().find_map(|(k, line)| match line.split_whitespace().collect::<Vec<_>>()[..] {
        [number, "atoms", ..] => Some((k, number)),
        _ => None,
    });
    if let Some((k, number)) = announced.filter(|(_, number)| number.parse() != Ok(rows.len())) {
        return Err(source.at(k, &format!("found `{number} atoms` and {} rows of them", rows.len())));
    }
    rows.sort_unstable_by_key(|row| row.0);
    let mut raw = Raw::default();
    for (_, k, diameter, x) in rows {
        raw.push(source, k, x, Some(diameter))?;
    }
    for diameter in &mut raw.radii {
        *diameter *= 0.5;
    }
    Ok(raw)
}
