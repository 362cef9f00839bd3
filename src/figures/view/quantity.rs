//! What the spheres of a view are coloured by: the columns of its frames, each number as a byte.

use crate::output::{Property, ReadFrame};
use serde_json::{Value, json};

/// Columns that are no quantities of a sphere.
const OTHERS: [&str; 2] = ["id", "pos"];
/// Columns whose numbers are names.
const NAMES: [&str; 3] = ["body", "wall", "third_body"];
/// Columns with another name for people, and their units in frames.
const KNOWN: [(&str, &str, &str); 10] = [
    ("velo", "speed", "m/s"),
    ("angular_velocity", "angular speed", "rad/ns"),
    ("radius", "radius", "nm"),
    ("mass", "mass", "ag"),
    ("force", "force", "pN"),
    ("coordination", "coordination number", ""),
    ("stress", "mean normal stress", "MPa"),
    ("torque", "torque", "zJ"),
    ("acceleration", "acceleration", "nm/ns²"),
    ("angular_acceleration", "angular acceleration", "rad/ns²"),
];
/// Part of the numbers at each end of the scale that have the colour of its end.
const OUTLIERS: f64 = 0.01;
/// Ratio of the largest number to the middle one from which the scale is logarithmic.
const WIDE: f64 = 30.0;
/// Most colours of names, which return in turn.
const MOST_NAMES: f64 = 8.0;

/// The bytes of a quantity, frame by frame.
type Bytes = Vec<Vec<u8>>;

/// The quantities that differ between spheres or frames, or the first if none does, and their bytes.
pub(super) fn quantities(frames: &[ReadFrame]) -> (Vec<Value>, Vec<Bytes>) {
    let names = frames[0].properties.iter().map(|property| &*property.name).filter(|name| !OTHERS.contains(name));
    let all: Vec<(bool, Value, Bytes)> = names.filter_map(|name| quantity(name, frames)).collect();
    let varied = all.iter().any(|(varies, ..)| *varies);
    let shown = all.into_iter().filter(|(varies, ..)| *varies || !varied);
    shown.take(if varied { usize::MAX } else { 1 }).map(|(_, about, bytes)| (about, bytes)).unzip()
}

/// Whether a quantity varies, its scale, and its bytes; none if a frame lacks it.
fn quantity(column: &str, frames: &[ReadFrame]) -> Option<(bool, Value, Bytes)> {
    let properties: Vec<&Property> = frames.iter().map(|frame| frame.property(column)).collect::<Option<_>>()?;
    let numbers: Vec<Vec<f64>> = properties.iter().map(|property| sizes(property)).collect();
    let mut sorted: Vec<f64> = numbers.iter().flatten().copied().filter(|number| number.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (&least, &most) = (sorted.first()?, sorted.last()?);
    let (_, name, unit) = KNOWN.into_iter().find(|known| known.0 == column).unwrap_or((column, column, ""));
    let name = name.replace('_', " ");
    if NAMES.contains(&column) {
        let bytes =
            numbers.iter().map(|of| of.iter().map(|number| number.rem_euclid(MOST_NAMES) as u8).collect()).collect();
        let names = sorted.chunk_by(|a, b| a == b).map(|same| same[0]).collect::<Vec<_>>();
        return Some((most > least, json!({ "name": name, "names": names }), bytes));
    }
    let at = |part: f64| sorted[(part * (sorted.len() - 1) as f64).round() as usize];
    let whole = properties[0].whole;
    let (mut low, high) = if whole { (least, most) } else { (at(OUTLIERS), at(1.0 - OUTLIERS)) };
    let log = !whole && least >= 0.0 && high > WIDE * at(0.5) && high > 0.0;
    if log {
        // A few powers of ten: what is smaller is at rest.
        low = low.max(1e-4 * high);
    } else if !whole && least >= 0.0 && low < 0.3 * high {
        low = 0.0;
    }
    let part = |number: f64| match log {
        true => libm::log(number / low) / libm::log(high / low),
        false => (number - low) / (high - low),
    };
    // What is no number has the lowest colour.
    let byte = |number: &f64| (255.0 * part(*number).clamp(0.0, 1.0)).round() as u8;
    let bytes = numbers.iter().map(|of| of.iter().map(byte).collect()).collect();
    let about = json!({
        "name": name, "unit": unit, "low": low, "high": high, "log": log, "whole": whole, "below": least < low, "above": most > high,
    });
    Some((most > least, about, bytes))
}

/// The numbers of a column, the lengths of vectors, the thirds of the traces of symmetric tensors.
fn sizes(property: &Property) -> Vec<f64> {
    let size = |components: &[f64]| match components {
        [number] => *number,
        [xx, yy, zz, _, _, _] => (xx + yy + zz) / 3.0,
        vector => vector.iter().map(|x| x * x).sum::<f64>().sqrt(),
    };
    property.numbers.chunks_exact(property.components.max(1)).map(size).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::frame;
    use super::*;

    #[test]
    fn vectors_are_shown_by_their_length_and_constants_not_at_all() {
        let frame = frame(&[("id", &[0.0, 1.0]), ("mass", &[2.0, 2.0]), ("velo", &[3.0, 4.0, 0.0, 0.0, 0.0, 0.0])]);
        let (about, bytes) = quantities(&[frame]);
        assert_eq!(about.len(), 1);
        assert_eq!(
            (&about[0]["name"], &about[0]["unit"], &about[0]["high"]),
            (&json!("speed"), &json!("m/s"), &json!(5.0))
        );
        assert_eq!(bytes, [[[255, 0]]]);
    }

    #[test]
    fn names_have_colours_and_counts_a_scale() {
        let frame = frame(&[("body", &[0.0, 9.0, 1.0]), ("coordination", &[0.0, 6.0, 3.0])]);
        let (about, bytes) = quantities(&[frame]);
        assert_eq!((&about[0]["names"], &bytes[0][0]), (&json!([0.0, 1.0, 9.0]), &vec![0, 1, 1]));
        assert_eq!(
            (&about[1]["high"], &about[1]["whole"], &bytes[1][0]),
            (&json!(6.0), &json!(true), &vec![0, 255, 128])
        );
    }

    #[test]
    fn a_few_outliers_do_not_hide_the_others() {
        let mut speeds: Vec<f64> = (0..1000).map(|k| 1.0 + f64::from(k) / 1000.0).collect();
        speeds.push(1e6);
        let (about, _) = quantities(&[frame(&[("charge", &speeds)])]);
        assert!(about[0]["high"].as_f64().is_some_and(|high| high < 2.0) && about[0]["above"] == true, "{about:?}");
    }

    #[test]
    fn a_tensor_is_shown_by_its_mean() {
        let stress = [1.0, 2.0, -6.0, 9.0, 9.0, 9.0, 3.0, 3.0, 3.0, 0.0, 0.0, 0.0];
        let (about, bytes) = quantities(&[frame(&[("radius", &[1.0, 1.0]), ("stress", &stress)])]);
        assert_eq!((&about[0]["low"], &about[0]["high"], &bytes[0][0]), (&json!(-1.0), &json!(3.0), &vec![0, 255]));
    }

    #[test]
    fn a_single_value_is_shown_if_nothing_varies() {
        let (about, bytes) = quantities(&[frame(&[("radius", &[2.0, 2.0]), ("mass", &[1.0, 1.0])])]);
        assert_eq!((about.len(), &about[0]["name"], &bytes[0][0]), (1, &json!("radius"), &vec![0, 0]));
    }
}
