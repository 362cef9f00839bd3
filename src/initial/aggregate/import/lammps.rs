//! LAMMPS data files with spheres.

use super::{Raw, Source};
use crate::error::{Error, notice};
use std::collections::BTreeMap;

/// The columns of an atom style.
#[derive(Clone, Copy)]
struct Style {
    /// Of the first coordinate.
    x: usize,
    /// Of the diameter, if the style has one.
    diameter: Option<usize>,
    /// Of the number of the molecule, if the style has one.
    molecule: Option<usize>,
    /// Their number without image flags.
    width: usize,
}

/// An atom style: its name, the columns before the coordinates, the diameter among them, its columns in a hybrid style, the diameter among those; and
/// whether it has molecules, whose column is the second, and the first in a hybrid style.
type Columns = (&'static str, usize, Option<usize>, usize, Option<usize>, bool);

/// The atom styles.
const STYLES: &[Columns] = &[
    ("angle", 3, None, 1, None, true),
    ("atomic", 2, None, 0, None, false),
    ("bond", 3, None, 1, None, true),
    ("bpm/sphere", 5, Some(3), 3, Some(1), true),
    ("charge", 3, None, 1, None, false),
    ("ellipsoid", 4, None, 2, None, false),
    ("full", 4, None, 2, None, true),
    ("molecular", 3, None, 1, None, true),
    ("sphere", 4, Some(2), 2, Some(0), false),
];

/// The columns of `sphere`, or of `hybrid sphere bond`: id, type, coordinates, and the columns of each style in turn.
fn style(words: &str) -> Option<Style> {
    let known = |word: &str| STYLES.iter().find(|style| style.0 == word);
    let mut words = words.split_whitespace();
    let first = words.next()?;
    if first != "hybrid" {
        let &(_, x, diameter, .., molecules) = known(first)?;
        let molecule = molecules.then_some(1);
        return words.next().is_none().then_some(Style { x, diameter, molecule, width: x + 3 });
    }
    let start = Style { x: 2, diameter: None, molecule: None, width: 5 };
    let (mut all, mut none) = (start, true);
    for word in words {
        let &(_, _, _, width, diameter, molecules) = known(word)?;
        all.diameter = all.diameter.or(diameter.map(|column| all.width + column));
        all.molecule = all.molecule.or(molecules.then_some(all.width));
        (all.width, none) = (all.width + width, false);
    }
    (!none).then_some(all)
}

/// The line `Atoms` that begins the section, alone or with a style; the last one, as the title may be the same.
pub(super) fn section<'a>(source: &Source<'a>) -> Option<(usize, &'a str)> {
    let is_section = |line: &str| {
        line.strip_prefix("Atoms").is_some_and(|rest| rest.is_empty() || rest.trim_start().starts_with('#'))
    };
    source.lines().filter(|(_, line)| is_section(line)).last()
}

/// The line `N atoms` of the header, the last before the section.
pub(super) fn announced<'a>(source: &Source<'a>) -> Option<(usize, &'a str)> {
    let number = |line: &'a str| {
        let (number, rest) = line.split('#').next()?.trim().split_once(char::is_whitespace)?;
        (rest.trim() == "atoms" && number.parse::<u64>().is_ok()).then_some(number)
    };
    source.lines().filter_map(|(k, line)| Some((k, number(line)?))).last()
}

/// The section `Atoms`, whose style must be named: `Atoms # sphere`. In order of the ids, each in the copy of the box that its image flags tell, if
/// three follow the other columns.
pub(super) fn read(source: &Source) -> Result<Raw, Error> {
    let keyword = |line: &str| line.starts_with(|c: char| c.is_ascii_alphabetic());
    let Some((head, title)) = section(source) else {
        return Err(Error::input(source.file, "found no section `Atoms`"));
    };
    let named = title.split_once('#').map(|(_, style)| style.trim()).unwrap_or_default();
    let Some(Style { x, diameter, molecule, width: least }) = style(named) else {
        let names: Vec<&str> = STYLES.iter().map(|style| style.0).collect();
        let what = format!(
            "found `{title}`, expected `Atoms # sphere`, another style ({}), or `hybrid` with its styles, as in `Atoms # hybrid sphere bond`",
            names.join(", ")
        );
        return Err(source.at(head, &what));
    };
    if diameter.is_some() {
        notice(format!("{}: the density is not read", source.file.display()));
    }
    let sides = sides(source)?;
    let mut rows = Vec::new();
    let lines = source.lines().skip(head);
    for (k, line) in
        lines.take_while(|(_, line)| !keyword(line)).filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
    {
        let words: Vec<&str> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let (Some(&id), Some(&[a, b, c])) = (words.first(), words.get(x..x + 3)) else {
            return Err(source.at(k, &format!("found {} columns, expected at least {least}", words.len())));
        };
        if words.len() < least {
            return Err(source.at(k, &format!("found {} columns, expected at least {least}", words.len())));
        }
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
        let [diameter, molecule] = [diameter, molecule].map(|column| column.map(|column| words[column]));
        rows.push((whole(id)?, k, (diameter, molecule), [a, b, c], shift));
    }
    if let Some((k, number)) = announced(source).filter(|(_, number)| number.parse() != Ok(rows.len())) {
        return Err(source.at(k, &format!("found `{number} atoms` and {} rows of them", rows.len())));
    }
    rows.sort_unstable_by_key(|row| (row.0, row.1));
    if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(source.at(pair[1].1, &format!("found the id {} twice", pair[1].0)));
    }
    let mut raw = Raw::default();
    let mut motion = velocities(source)?;
    for (place, (id, k, (diameter, molecule), x, shift)) in rows.into_iter().enumerate() {
        raw.push(source, k, x, diameter)?;
        if let Some(molecule) = molecule {
            raw.extras.push_body(source, k, molecule)?;
        }
        if let Some(motion) = &mut motion {
            let Some((line, v, w)) = motion.remove(&id) else {
                return Err(source.at(k, &format!("found no row for {id} in the section `Velocities`")));
            };
            raw.extras.push_motion(source, line, Some(v), w)?;
        }
        raw.centres[place] = std::array::from_fn(|a| raw.centres[place][a] + shift[a]);
    }
    for diameter in &mut raw.radii {
        *diameter *= 0.5;
    }
    Ok(raw)
}

/// Line, velocity and angular velocity of a sphere.
type Moving<'a> = (usize, [&'a str; 3], Option<[&'a str; 3]>);

/// The section `Velocities`, if there is one: rows of id and velocity, with the angular velocity in those of spheres.
fn velocities<'a>(source: &Source<'a>) -> Result<Option<BTreeMap<i64, Moving<'a>>>, Error> {
    let keyword = |line: &str| line.starts_with(|c: char| c.is_ascii_alphabetic());
    let is_section = |line: &str| line.split('#').next().is_some_and(|line| line.trim() == "Velocities");
    let Some((head, _)) = source.lines().filter(|(_, line)| is_section(line)).last() else { return Ok(None) };
    let mut found: BTreeMap<i64, Moving> = BTreeMap::new();
    let rows = source.lines().skip(head).take_while(|(_, line)| !keyword(line));
    for (k, line) in rows.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        let words: Vec<&str> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let (id, v, w) = match words[..] {
            [id, x, y, z] => (id, [x, y, z], None),
            [id, x, y, z, a, b, c] => (id, [x, y, z], Some([a, b, c])),
            _ => return Err(source.at(k, &format!("found {} columns, expected 4, or 7 with spins", words.len()))),
        };
        let id = id.parse().map_err(|_| source.at(k, &format!("found `{id}`, expected an integer")))?;
        if found.values().next().is_some_and(|(.., first)| first.is_some() != w.is_some()) {
            return Err(source.at(k, &format!("found {} columns, expected as many as in the rows above", words.len())));
        }
        found.insert(id, (k, v, w));
    }
    Ok(Some(found))
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

#[cfg(test)]
mod tests;
