//! The view of a run in three dimensions: some of its frames, with coordinates and colours as whole numbers that a page can hold.

mod quantity;

use super::Report;
use crate::output::ReadFrame;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use quantity::quantities;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Most frames of a view.
const MOST_FRAMES: usize = 60;
/// Most spheres of all frames together: the page stays below 10 MB.
const MOST_SPHERES: usize = 400_000;
/// Most pairs of all frames together.
const MOST_PAIRS: usize = 300_000;
/// The kind of a pair that is a neck.
const NECK: u32 = 2;
/// Radius, relative to the smallest one, beyond which a sphere may leave the picture.
const LARGE: f64 = 20.0;
/// The largest coordinate.
const FINEST: f64 = 65_535.0;

/// Adds the view of these frames to a page, unless there is none to show.
pub(super) fn view(page: &mut Report, files: &[PathBuf]) {
    let Some(first) = files.iter().find_map(|file| ReadFrame::read(file).ok()) else { return };
    let (few, every) = fitting(first.count);
    let chosen = chosen(files.len(), few);
    let mut frames: Vec<ReadFrame> = chosen.iter().filter_map(|&k| ReadFrame::read(&files[k]).ok()).collect();
    frames.iter_mut().for_each(|frame| thin(frame, every));
    frames.retain(|frame| frame.count > 0);
    if frames.is_empty() {
        return;
    }
    let unreadable = chosen.len() - frames.len();
    // Where there are necks they are what holds the spheres together.
    let necks = frames.iter().flat_map(|frame| &frame.pairs).any(|pair| pair.1 == NECK);
    if necks {
        frames.iter_mut().for_each(|frame| frame.pairs.retain(|pair| pair.1 == NECK));
    }
    let pairs: usize = frames.iter().map(|frame| frame.pairs.len()).sum();
    if pairs > MOST_PAIRS {
        frames.iter_mut().for_each(|frame| frame.pairs.clear());
    }
    // A line of a script ends where markup begins.
    let scene = scene(&frames, if necks { "Necks" } else { "Contacts" }).to_string().replace('<', "\\u003c");
    page.markup(&format!(
        "<div class=\"view\" id=\"view\"></div>\n<script type=\"application/json\" id=\"scene\">{scene}</script>\n\
         <script>\n(() => {{\n{}}})();\n</script>\n",
        include_str!("view.js")
    ));
    let mut said = vec![format!(
        "Drag to rotate, wheel to zoom; arrow keys and + and − do the same. {} of {} frames",
        frames.len(),
        files.len()
    )];
    if every > 1 {
        said.push(format!("one sphere of {every}"));
    }
    if unreadable > 0 {
        said.push(format!("{unreadable} that cannot be read or are empty are left out"));
    }
    if pairs > MOST_PAIRS {
        said.push("pairs are left out, as there are too many".into());
    }
    page.note(&format!("{}; all of them, with all digits, are in frames/.", said.join("; ")));
}

/// The largest number of frames with this number of spheres that a page can hold, at least two, and the interval of the spheres that are shown.
fn fitting(spheres: usize) -> (usize, usize) {
    let frames = (MOST_SPHERES / spheres.max(1)).clamp(2, MOST_FRAMES);
    (frames, (frames * spheres).div_ceil(MOST_SPHERES).max(1))
}

/// The places of `few` out of `count` frames, the first and the last among them.
pub(super) fn chosen(count: usize, few: usize) -> Vec<usize> {
    let few = few.min(count);
    (0..few).map(|k| if few > 1 { k * (count - 1) / (few - 1) } else { 0 }).collect()
}

/// Keeps one sphere of `every`, with the pairs of those that are kept.
fn thin(frame: &mut ReadFrame, every: usize) {
    if every == 1 {
        return;
    }
    for property in &mut frame.properties {
        let spheres = property.numbers.chunks(property.components).step_by(every);
        property.numbers = spheres.flatten().copied().collect();
    }
    frame.count = frame.count.div_ceil(every);
    frame.pairs.clear();
}

fn scene(frames: &[ReadFrame], pairs: &str) -> Value {
    let (low, high) = extent(frames, f64::INFINITY);
    // A sphere as large as a wall does not say what there is to see.
    let least = frames.iter().flat_map(ReadFrame::radii).copied().fold(f64::INFINITY, f64::min);
    let (from, to) = extent(frames, LARGE * least);
    let span = (0..3).map(|k| high[k] - low[k]).fold(1e-9, f64::max);
    let largest = frames.iter().flat_map(ReadFrame::radii).copied().fold(1e-9, f64::max);
    let whole = |numbers: &mut dyn Iterator<Item = f64>| {
        packed(numbers.flat_map(|number| (number.round().clamp(0.0, FINEST) as u16).to_le_bytes()))
    };
    let (quantities, mut colours) = quantities(frames);
    let mut meshes = Vec::new();
    let shown = frames.iter().enumerate().map(|(at, frame)| {
        let centres =
            frame.centres().flat_map(|x| (0..3).map(move |k| (x[k] - low[k]) / span * FINEST).collect::<Vec<_>>());
        let colours: Vec<String> =
            colours.iter_mut().map(|of| packed(std::mem::take(&mut of[at]).into_iter())).collect();
        let (corners, faces) = &frame.surfaces;
        let faces = packed(faces.iter().flatten().flat_map(|corner| corner.to_le_bytes()));
        // Surfaces move and keep their triangles.
        let mesh = meshes.iter().position(|known| *known == faces).unwrap_or_else(|| {
            meshes.push(faces);
            meshes.len() - 1
        });
        json!({
            "stage": frame.stage,
            "time": frame.time,
            "centres": whole(&mut centres.into_iter()),
            "radii": whole(&mut frame.radii().iter().map(|radius| radius / largest * FINEST)),
            "colours": colours,
            "pairs": packed(frame.pairs.iter().flat_map(|pair| pair.0).flat_map(|place| place.to_le_bytes())),
            "sides": frame.sides,
            "corners": packed(corners.iter().flatten().flat_map(|x| (*x as f32).to_le_bytes())),
            "mesh": mesh,
        })
    });
    let shown: Vec<Value> = shown.collect();
    let first = &frames[0];
    json!({
        "low": low, "span": span, "from": from, "to": to, "radius": largest, "periodic": first.periodic, "upwards": upwards(first), "pairs": pairs,
        "quantities": quantities, "palette": super::COLOURS, "frames": shown, "meshes": meshes,
    })
}

/// The axis that points upwards, as in the pictures: the third where something lies on a surface, else the second.
pub(super) fn upwards(frame: &ReadFrame) -> usize {
    if !frame.surfaces.0.is_empty() || frame.periodic == [true, true, false] { 2 } else { 1 }
}

/// The box around the centres of all spheres of all frames that are no larger than this.
fn extent(frames: &[ReadFrame], largest: f64) -> ([f64; 3], [f64; 3]) {
    let mut ends = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let spheres = frames.iter().flat_map(|frame| frame.centres().zip(frame.radii()));
    for (x, _) in spheres.filter(|(_, radius)| **radius <= largest) {
        for k in 0..3 {
            ends.0[k] = ends.0[k].min(x[k]);
            ends.1[k] = ends.1[k].max(x[k]);
        }
    }
    ends
}

fn packed(bytes: impl Iterator<Item = u8>) -> String {
    BASE64_STANDARD.encode(bytes.collect::<Vec<u8>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::Property;

    pub(super) fn frame(numbers: &[(&str, &[f64])]) -> ReadFrame {
        let count = numbers[0].1.len();
        let property = |(name, numbers): &(&str, &[f64])| Property {
            name: (*name).into(),
            whole: numbers.iter().all(|number| number.fract() == 0.0),
            components: numbers.len() / count,
            numbers: numbers.to_vec(),
        };
        ReadFrame { count, properties: numbers.iter().map(property).collect(), ..ReadFrame::default() }
    }

    #[test]
    fn a_page_holds_a_bounded_number_of_spheres() {
        for spheres in [1, 100, 6000, 100_000, 200_001, 3_000_000] {
            let (frames, every) = fitting(spheres);
            assert!((2..=MOST_FRAMES).contains(&frames));
            assert!(
                frames * spheres.div_ceil(every) <= MOST_SPHERES + frames,
                "{spheres}: {frames} frames, one of {every}"
            );
        }
        assert_eq!((fitting(100), fitting(100_000)), ((60, 1), (4, 1)));
    }

    #[test]
    fn the_first_and_the_last_frame_are_shown() {
        assert_eq!(chosen(3, 60), [0, 1, 2]);
        assert_eq!(chosen(1, 60), [0]);
        let many = chosen(1000, 60);
        assert_eq!((many.len(), many[0], many[59]), (60, 0, 999));
        assert!(many.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn coordinates_are_parts_of_the_largest_extent() {
        let frame = frame(&[("radius", &[1.0, 2.0]), ("pos", &[0.0, 5.0, 0.0, 10.0, 5.0, 5.0])]);
        let scene = scene(&[frame], "Contacts");
        assert_eq!((&scene["from"], &scene["to"]), (&json!([0.0, 5.0, 0.0]), &json!([10.0, 5.0, 5.0])));
        assert_eq!(
            (&scene["low"], &scene["span"], &scene["radius"]),
            (&json!([0.0, 5.0, 0.0]), &json!(10.0), &json!(2.0))
        );
        let bytes = BASE64_STANDARD.decode(scene["frames"][0]["centres"].as_str().expect("a text")).expect("base64");
        let numbers: Vec<u16> = bytes.chunks(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect();
        assert_eq!(numbers, [0, 0, 0, 65_535, 0, 32_768]);
    }
}
