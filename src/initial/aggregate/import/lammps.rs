//! LAMMPS data files with spheres.

use super::{Raw, Source};
use crate::error::Error;

/// The section `Atoms # sphere`, rows `id type diameter density x y z`, or `Atoms # bpm/sphere`, with a molecule after the id. In order of the ids,
/// each in the copy of the box that its image flags tell, if three follow the coordinates.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
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
    let (least, sides) = (7 + skipped, sides(source)?);
    let mut rows = Vec::new();
    for (k, line) in lines.take_while(|(_, line)| !keyword(line)).filter(|(_, line)| !line.is_empty()) {
        let words: Vec<&str> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let (Some(&id), Some(&[diameter, _, x, y, z])) = (words.first(), words.get(2 + skipped..least)) else {
            return Err(source.at(k, &format!("found {} columns, expected at least {least}", words.len())));
        };
        let whole =
            |word: &str| word.parse().map_err(|_| source.at(k, &format!("found `{word}`, expected an integer")));
        let copy: [i64; 3] = match words[least..] {
            [] => [0; 3],
            [i, j, k] => [whole(i)?, whole(j)?, whole(k)?],
            _ => {
                let what =
                    format!("found {} columns, expected {least}, or {} with image flags", words.len(), least + 3);
                return Err(source.at(k, &what));
            }
        };
        let shift = match sides {
            _ if copy == [0; 3] => [0.0; 3],
            Some(sides) => std::array::from_fn(|a| copy[a] as f64 * sides[a]),
            None => return Err(source.at(k, "found image flags, expected none: the box is tilted or missing")),
        };
        rows.push((whole(id)?, k, diameter, [x, y, z], shift));
    }
    let announced = source.lines().find_map(|(k, line)| match line.split_whitespace().collect::<Vec<_>>()[..] {
        [number, "atoms", ..] => Some((k, number)),
        _ => None,
    });
    if let Some((k, number)) = announced.filter(|(_, number)| number.parse() != Ok(rows.len())) {
        return Err(source.at(k, &format!("found `{number} atoms` and {} rows of them", rows.len())));
    }
    rows.sort_unstable_by_key(|row| (row.0, row.1));
    if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(source.at(pair[1].1, &format!("found the id {} twice", pair[1].0)));
    }
    let mut raw = Raw::default();
    for (place, (_, k, diameter, x, shift)) in rows.into_iter().enumerate() {
        raw.push(source, k, x, Some(diameter))?;
        raw.centres[place] = std::array::from_fn(|a| raw.centres[place][a] + shift[a]);
    }
    for diameter in &mut raw.radii {
        *diameter *= 0.5;
    }
    Ok(raw)
}

/// The side lengths of the box; none if they are missing or it is tilted.
fn sides(source: &Source) -> Result<Option<[f64; 3]>, Error> {
    let (mut sides, mut upright) = ([None; 3], true);
    for (k, line) in source.lines() {
        let number = |word| source.number(k, word);
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            [low, high, "xlo", "xhi", ..] => sides[0] = Some(number(high)? - number(low)?),
            [low, high, "ylo", "yhi", ..] => sides[1] = Some(number(high)? - number(low)?),
            [low, high, "zlo", "zhi", ..] => sides[2] = Some(number(high)? - number(low)?),
            [xy, xz, yz, "xy", "xz", "yz", ..] => upright = [number(xy)?, number(xz)?, number(yz)?] == [0.0; 3],
            _ => {}
        }
    }
    Ok(match sides {
        [Some(x), Some(y), Some(z)] if upright => Some([x, y, z]),
        _ => None,
    })
}
