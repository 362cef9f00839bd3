//! A frame in the extended XYZ format as it is read: its columns are those that its header names, in any order.

use super::{FrameName, RunFolder, read};
use crate::error::{AtPath, Error};
use std::path::{Path, PathBuf};

/// A column of a frame, with one or more numbers for each sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Its name in the header.
    pub name: String,
    /// Whether its numbers are whole.
    pub whole: bool,
    /// Number of its components.
    pub components: usize,
    /// Its numbers, sphere by sphere.
    pub numbers: Vec<f64>,
}

/// A surface: corners, and the corners of its triangles.
pub type Mesh = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// A frame: the state of all spheres at some time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadFrame {
    /// The stage.
    pub stage: String,
    /// The time, ns.
    pub time: f64,
    /// Number of spheres.
    pub count: usize,
    /// The side lengths of the box, nm.
    pub sides: [f64; 3],
    /// Whether the box is periodic along each axis.
    pub periodic: [bool; 3],
    /// The columns of numbers.
    pub properties: Vec<Property>,
    /// The pairs of spheres that act on each other, by their places in the frame, with their kind: 1 for a contact, 2 for a neck, 3 for a meniscus;
    /// empty if none are recorded.
    pub pairs: Vec<([u32; 2], u32)>,
    /// The other columns of pairs.
    pub pair_properties: Vec<Property>,
    /// The surfaces, if there are any.
    pub surfaces: Mesh,
}

impl ReadFrame {
    /// The files of all frames of a run, in the order of its `stages` and of time.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read.
    pub fn all(folder: &RunFolder, stages: &[&str]) -> Result<Vec<PathBuf>, Error> {
        let frames = folder.frames();
        let mut found = Vec::new();
        for entry in std::fs::read_dir(&frames).at(&frames)? {
            let path = entry.at(&frames)?.path();
            let ours = path.file_name().is_some_and(|name| FrameName::of_file(name).is_some());
            if !ours || path.extension().is_none_or(|ending| ending != "xyz") {
                continue;
            }
            // A frame that cannot be understood is left for its reader to refuse.
            let head = first_lines(&path)?;
            let head = head.lines().nth(1).map(Self::head).unwrap_or_default();
            let stage = stages.iter().position(|stage| *stage == head.stage);
            found.push((stage, head.time, path));
        }
        found.sort_by(|a, b| (a.0.cmp(&b.0)).then(a.1.total_cmp(&b.1)).then_with(|| a.2.cmp(&b.2)));
        Ok(found.into_iter().map(|(_, _, path)| path).collect())
    }

    /// Reads a frame, with the surfaces and the pairs in the files beside it.
    ///
    /// # Errors
    ///
    /// If a file cannot be read, or is no frame.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let broken = |what: &str| Error::input(path, what.to_string());
        let bytes = read(path)?;
        let text = std::str::from_utf8(&bytes).map_err(|error| broken(&error.to_string()))?;
        let mut frame = Self::parse(text).ok_or_else(|| broken("is no frame in the extended XYZ format"))?;
        let beside = |ending: &str| Some(path.with_extension(ending)).filter(|path| path.exists());
        if let Some(path) = beside("obj") {
            frame.surfaces = mesh(&String::from_utf8_lossy(&read(&path)?));
        }
        if let Some(path) = beside("bonds") {
            let (pairs, properties) = pairs(&String::from_utf8_lossy(&read(&path)?));
            let placed = frame.placed(&pairs);
            let kept = |property: Property| {
                let numbers = property.numbers.iter().zip(&placed).filter(|(_, pair)| pair.is_some());
                Property { numbers: numbers.map(|(number, _)| *number).collect(), ..property }
            };
            frame.pair_properties = properties.into_iter().map(kept).collect();
            frame.pairs = placed.into_iter().flatten().collect();
        }
        Ok(frame)
    }

    /// A column.
    pub fn property(&self, name: &str) -> Option<&Property> {
        self.properties.iter().find(|property| property.name == name)
    }

    /// The centres of the spheres, nm.
    pub fn centres(&self) -> impl Iterator<Item = [f64; 3]> {
        let numbers = self.property("pos").map_or(&[][..], |property| &property.numbers);
        numbers.chunks_exact(3).map(|x| [x[0], x[1], x[2]])
    }

    /// The radii of the spheres, nm.
    pub fn radii(&self) -> &[f64] {
        self.property("radius").map_or(&[], |property| &property.numbers)
    }

    fn parse(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        let count = lines.next()?.trim().parse().ok()?;
        let comment = lines.next()?;
        let mut frame = Self { count, ..Self::head(comment) };
        // The places of the columns that hold numbers.
        let (mut places, mut width) = (Vec::new(), 0);
        let properties = entries(comment).find(|(key, _)| *key == "Properties")?.1;
        let words: Vec<&str> = properties.split(':').collect();
        for column in words.chunks(3) {
            let &[name, kind, components] = column else { return None };
            let components: usize = components.parse().ok()?;
            if ["R", "I"].contains(&kind) {
                places.push(width..width + components);
                let (name, whole) = (name.into(), kind == "I");
                frame.properties.push(Property { name, whole, components, numbers: Vec::new() });
            }
            width += components;
        }
        for _ in 0..count {
            let cells: Vec<&str> = lines.next()?.split_ascii_whitespace().collect();
            if cells.len() != width {
                return None;
            }
            for (property, places) in frame.properties.iter_mut().zip(&places) {
                for cell in &cells[places.clone()] {
                    property.numbers.push(cell.parse().ok()?);
                }
            }
        }
        let three = |name| frame.property(name).is_some_and(|property| property.components == 3);
        (three("pos") && frame.radii().len() == count).then_some(frame)
    }

    /// What the second line of a frame says of its time and its box.
    fn head(comment: &str) -> Self {
        let mut head = Self::default();
        for (key, value) in entries(comment) {
            match key {
                "stage" => head.stage = value.into(),
                "Time" => head.time = value.parse().unwrap_or_default(),
                "Lattice" => {
                    let numbers = value.split(' ').map(|number| number.parse().unwrap_or_default());
                    numbers.step_by(4).zip(&mut head.sides).for_each(|(number, side)| *side = number);
                }
                "pbc" => value.split(' ').zip(&mut head.periodic).for_each(|(yes, periodic)| *periodic = yes == "T"),
                _ => {}
            }
        }
        head
    }

    /// Pairs of ids as pairs of places, where there are such spheres.
    fn placed(&self, pairs: &[([u32; 2], u32)]) -> Vec<Option<([u32; 2], u32)>> {
        let ids = self.property("id").map_or(&[][..], |property| &property.numbers);
        let places: std::collections::HashMap<u32, u32> =
            ids.iter().enumerate().map(|(place, id)| (*id as u32, place as u32)).collect();
        let placed = |&([i, j], kind): &([u32; 2], u32)| Some(([*places.get(&i)?, *places.get(&j)?], kind));
        pairs.iter().map(placed).collect()
    }
}

/// The first two lines of a frame.
fn first_lines(path: &Path) -> Result<String, Error> {
    use std::io::{BufRead, BufReader, Read};
    let file = std::fs::File::open(path).at(path)?;
    let mut lines = Vec::new();
    // No header is as long: what is no frame is not read to its end.
    let mut reader = BufReader::new(file.take(65_536));
    for _ in 0..2 {
        reader.read_until(b'\n', &mut lines).at(path)?;
    }
    Ok(String::from_utf8_lossy(&lines).into())
}

/// The entries `key=value` and `key="value"` of a comment.
fn entries(comment: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = comment;
    std::iter::from_fn(move || {
        let (key, value) = rest.split_once('=')?;
        let quoted = value.strip_prefix('"');
        let (value, after) = match quoted {
            Some(value) => value.split_once('"')?,
            None => value.split_once(' ').unwrap_or((value, "")),
        };
        rest = after;
        Some((key.trim(), value))
    })
}

/// All surfaces of a Wavefront file.
fn mesh(text: &str) -> Mesh {
    let mut mesh = Mesh::default();
    for line in text.lines() {
        let (kind, rest) = line.split_once(' ').unwrap_or((line, ""));
        let mut words = rest.split_ascii_whitespace();
        match kind {
            "v" => mesh.0.extend(three(&mut words)),
            "f" => {
                mesh.1.extend(three::<u32>(&mut words).map(|corners| corners.map(|corner| corner.saturating_sub(1))))
            }
            _ => {}
        }
    }
    let count = mesh.0.len() as u32;
    mesh.1.retain(|corners| corners.iter().all(|corner| *corner < count));
    mesh
}

fn three<'a, T: std::str::FromStr>(words: &mut impl Iterator<Item = &'a str>) -> Option<[T; 3]> {
    let mut next = || words.next()?.parse().ok();
    Some([next()?, next()?, next()?])
}

/// The ids and kinds of the pairs in a LAMMPS dump of local quantities, whose columns its header names, and the other columns.
fn pairs(text: &str) -> (Vec<([u32; 2], u32)>, Vec<Property>) {
    let mut lines = text.lines().skip_while(|line| !line.starts_with("ITEM: ENTRIES"));
    let Some(head) = lines.next() else { return Default::default() };
    let columns: Vec<&str> = head.split_ascii_whitespace().skip(2).collect();
    let place = |name: &str| columns.iter().position(|column| *column == name);
    let (Some(i), Some(j)) = (place("batom1"), place("batom2")) else { return Default::default() };
    let kind = place("btype");
    let others: Vec<usize> = (0..columns.len()).filter(|&at| at != i && at != j && Some(at) != kind).collect();
    let property =
        |&at: &usize| Property { name: columns[at].into(), whole: false, components: 1, numbers: Vec::new() };
    let (mut found, mut properties) = (Vec::new(), others.iter().map(property).collect::<Vec<_>>());
    for line in lines.take_while(|line| !line.starts_with("ITEM:")) {
        let cells: Vec<&str> = line.split_ascii_whitespace().collect();
        let id = |place: usize| cells.get(place)?.parse().ok();
        let (Some(i), Some(j)) = (id(i), id(j)) else { continue };
        found.push(([i, j], kind.and_then(id).unwrap_or(1)));
        for (property, &at) in properties.iter_mut().zip(&others) {
            property.numbers.push(cells.get(at).and_then(|cell| cell.parse().ok()).unwrap_or(f64::NAN));
        }
    }
    (found, properties)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: &str = "2\nLattice=\"2 0 0 0 4 0 0 0 6\" Origin=\"0 0 0\" pbc=\"T F T\" Time=0.5 stage=\"pulling 2\" \
        Properties=species:S:1:force:R:3:radius:R:1:id:I:1:pos:R:3\nX 1 2 3 0.25 7 1.5 1 2\nX 4 5 6 0.5 3 1 1 1\n";

    #[test]
    fn columns_are_found_by_the_header_and_in_any_order() {
        let frame = ReadFrame::parse(FRAME).expect("a frame");
        assert_eq!((&*frame.stage, frame.time, frame.sides), ("pulling 2", 0.5, [2.0, 4.0, 6.0]));
        assert_eq!(frame.periodic, [true, false, true]);
        assert_eq!(frame.property("force").map(|force| &force.numbers[3..]), Some(&[4.0, 5.0, 6.0][..]));
        assert_eq!(frame.centres().collect::<Vec<_>>(), [[1.5, 1.0, 2.0], [1.0; 3]]);
        assert_eq!(frame.radii(), [0.25, 0.5]);
        assert!(frame.property("id").is_some_and(|id| id.whole) && frame.property("species").is_none());
    }

    #[test]
    fn what_is_cut_off_is_no_frame() {
        for end in [0, 1, 2, 40, FRAME.len() - 4, FRAME.len() - 20] {
            assert!(ReadFrame::parse(&FRAME[..end]).is_none(), "{end}");
        }
    }

    #[test]
    fn pairs_are_named_by_ids_and_have_a_kind() {
        let text = "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ENTRIES\n2\nITEM: ENTRIES distance batom1 batom2 btype\n1.5 7 3 2\n2 3 9 1\n";
        let (found, properties) = pairs(text);
        assert_eq!(found, [([7, 3], 2), ([3, 9], 1)]);
        assert_eq!((&*properties[0].name, &properties[0].numbers[..]), ("distance", &[1.5, 2.0][..]));
        assert_eq!(ReadFrame::parse(FRAME).expect("a frame").placed(&found), [Some(([0, 1], 2)), None]);
        assert_eq!(pairs("ITEM: TIMESTEP\n"), Default::default());
    }

    #[test]
    fn surfaces_keep_only_triangles_that_have_corners() {
        let mesh = mesh("o tip\nv 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\nf 1 2 9\n");
        assert_eq!((mesh.0.len(), mesh.1), (3, vec![[0, 1, 2]]));
    }
}
