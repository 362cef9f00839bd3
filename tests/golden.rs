//! The golden vectors and trajectories of `golden/`: what the equations and the papers' models are compared with.

#[path = "common/trials.rs"]
mod trials;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use trials::setting;
use veridem::golden::{
    Trajectory, check, check_independent, check_trajectories, documented, file_of, measure, read, regenerate, samples,
};
use veridem::papers::PAPERS;
use veridem_spec::document::Document;
use veridem_spec::equation::Equation;
use veridem_spec::numbers::Dual;

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

#[test]
fn the_vectors_of_every_equation_hold() {
    let wrong: Vec<String> =
        documented().unwrap().iter().flat_map(|(e, document)| check(&golden(), e, document)).collect();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn no_file_of_vectors_is_without_an_equation() {
    let documented = documented().unwrap();
    let known: Vec<PathBuf> = documented.iter().map(|(equation, _)| file_of(&golden(), equation)).collect();
    for paper in veridem_spec::papers() {
        for entry in std::fs::read_dir(golden().join(paper.name)).unwrap() {
            let path = entry.unwrap().path();
            assert!(known.contains(&path), "{}", path.display());
        }
    }
}

#[test]
fn a_wrong_digit_in_a_vector_is_noticed() {
    let (equation, document) = documented().unwrap().into_iter().find(|(equation, _)| equation.id == "wear-7").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = file_of(folder.path(), &equation);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    let text = std::fs::read_to_string(file_of(&golden(), &equation)).unwrap();
    std::fs::write(&path, &text).unwrap();
    assert_eq!(check(folder.path(), &equation, &document), Vec::<String>::new());
    let digits = read(folder.path(), &equation).unwrap().vectors[0].out["k_n"].as_str().unwrap().to_string();
    let other = if digits.ends_with('1') { "2" } else { "1" };
    let end = digits.find('e').unwrap_or(digits.len());
    let changed = format!("{}{other}{}", &digits[..end - 1], &digits[end..]);
    std::fs::write(&path, text.replacen(&digits, &changed, 1)).unwrap();
    assert_eq!(check(folder.path(), &equation, &document).len(), 1);
}

/// `wear-7`, the product of the first two arguments over the sum of the others, with another function for `f64`.
fn broken(f64: fn(&[f64]) -> Vec<f64>) -> (Equation, Document) {
    let mut found = documented().unwrap().into_iter().find(|(equation, _)| equation.id == "wear-7").unwrap();
    found.0.eval.f64 = f64;
    found
}

fn right(x: &[f64]) -> f64 {
    x[0] * x[1] / (x[2] + x[3])
}

#[test]
fn a_value_that_is_lost_is_noticed() {
    let (whole, document) = broken(|x| vec![right(x)]);
    let inputs = samples(&whole, &document, 8);
    let ulps = |equation: &Equation| measure(equation, &inputs).ulps;
    assert_eq!(check(&golden(), &whole, &document), Vec::<String>::new());
    assert!(ulps(&whole) <= document.rounding.unwrap());
    let vectors = read(&golden(), &whole).unwrap().vectors.len();
    type Values = fn(&[f64]) -> Vec<f64>;
    let values: [Values; 3] = [|_| vec![f64::NAN], |_| vec![f64::INFINITY], |x| vec![1.01 * right(x)]];
    for f64 in values {
        let (mut lost, document) = broken(f64);
        // whatever the derivatives are
        for dual in [
            lost.eval.dual,
            |x| vec![Dual { value: x[0].value, slope: f64::INFINITY }],
            |x| vec![Dual { value: x[0].value, slope: f64::NAN }],
        ] {
            lost.eval.dual = dual;
            assert_eq!(check(&golden(), &lost, &document).len(), vectors);
            assert!(ulps(&lost) > document.rounding.unwrap());
            assert_eq!(
                samples(&lost, &document, 8).len(),
                inputs.len(),
                "inputs without a value in double precision are kept"
            );
        }
    }
}

#[test]
fn one_value_that_is_lost_among_many_is_noticed() {
    let (lost, document) = broken(|x| vec![if x[0] < 1e-14 { f64::NAN } else { right(x) }]);
    let inputs = samples(&lost, &document, 200);
    assert!(inputs.iter().filter(|sample| sample.numbers[0] < 1e-14).all(|sample| sample.flag == "small"));
    assert_eq!(measure(&lost, &inputs).ulps, f64::INFINITY);
    let wrong = check(&golden(), &lost, &document);
    assert!(!wrong.is_empty() && wrong.iter().all(|one| one.contains("inf ULP")), "{wrong:?}");
}

#[test]
fn every_equation_has_the_independent_vectors_of_the_list() {
    let wrong = check_independent(&golden(), &documented().unwrap());
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn independent_vectors_that_are_lost_with_their_file_are_missed() {
    let one: Vec<_> = documented().unwrap().into_iter().filter(|(equation, _)| equation.id == "wear-7").collect();
    let folder = tempfile::tempdir().unwrap();
    let listed = folder.path().join("independent.json");
    let told = |expected: &str| {
        let wrong = check_independent(folder.path(), &one);
        assert!(matches!(&wrong[..], [one] if one.contains(expected)), "{wrong:?}");
    };
    told("No such file");
    let file = read(&golden(), &one[0].0).unwrap();
    let count = file.vectors.iter().filter(|vector| vector.source.is_some()).count();
    std::fs::write(&listed, json!({ "wear-7": count }).to_string()).unwrap();
    regenerate(folder.path(), &one[0].0, &one[0].1).unwrap();
    told(&format!("wear-7: found 0 independent vectors, expected {count}"));
    std::fs::write(&listed, json!({ "wear-7": 0 }).to_string()).unwrap();
    told("wear-7: no independent vector");
    std::fs::write(&listed, json!({ "wear-7": count }).to_string()).unwrap();
    std::fs::copy(file_of(&golden(), &one[0].0), file_of(folder.path(), &one[0].0)).unwrap();
    assert_eq!(check_independent(folder.path(), &one), Vec::<String>::new());
    std::fs::write(&listed, json!({ "wear-7": count, "wear-0": 1 }).to_string()).unwrap();
    told("there is no equation `wear-0`");
}

#[test]
fn every_trajectory_holds() {
    let wrong = check_trajectories(&golden(), &PAPERS.trajectories());
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// Checks a trajectory whose file has this text, alone in its folder.
fn check_text(trajectory: &Trajectory, text: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("trajectories")).unwrap();
    std::fs::write(folder.path().join("trajectories").join(trajectory.file), text).unwrap();
    check_trajectories(folder.path(), &[trajectory])
}

fn content(trajectory: &Trajectory) -> Value {
    let text = std::fs::read_to_string(golden().join("trajectories").join(trajectory.file)).unwrap();
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_file_of_trajectories_is_complete_and_belongs_to_one_paper() {
    let trajectories = PAPERS.trajectories();
    let tip = trajectories.iter().find(|trajectory| trajectory.file == "soot_tip.json").unwrap();
    let whole = content(tip);
    assert_eq!(check_text(tip, &whole.to_string()), Vec::<String>::new());
    let told = |text: String, expected: &str| {
        let wrong = check_text(tip, &text);
        assert!(matches!(&wrong[..], [one] if one.contains("soot_tip.json: ") && one.contains(expected)), "{wrong:?}");
    };
    told(whole.to_string().replace(']', ""), "expected");
    told("{}".into(), "found the schema null");
    let changed = |change: fn(&mut Value)| {
        let mut changed = whole.clone();
        change(&mut changed);
        changed.to_string()
    };
    told(changed(|file| file["runs"] = json!([])), "expected a list of `runs`");
    told(changed(|file| file["runs"][0]["samples"] = Value::Null), "run `tip`, `samples`: expected two or more");
    told(
        changed(|file| file["runs"][0]["samples"][1] = json!([1, "x", 2])),
        "sample 1: found [1,\"x\",2], expected 3 numbers",
    );
    told(
        changed(|file| file["runs"][0]["samples"][2][1] = json!(0.5)),
        "run `tip`, sample 2: v: found 0.0, expected 0.5 to 1e-15",
    );

    let folder = tempfile::tempdir().unwrap();
    assert!(check_trajectories(folder.path(), &[])[0].contains("trajectories: "));
    std::fs::create_dir(folder.path().join("trajectories")).unwrap();
    assert!(matches!(&check_trajectories(folder.path(), &[tip])[..], [one] if one.contains("No such file")));
    std::fs::write(folder.path().join("trajectories/soot_tip.json"), whole.to_string()).unwrap();
    assert!(
        matches!(&check_trajectories(folder.path(), &[])[..], [one] if one.ends_with("soot_tip.json: no paper compares it"))
    );
    assert!(check_trajectories(folder.path(), &[tip, tip])[0].ends_with("compared by 2 entries, expected one"));
}

/// The places of all numbers in a value, as JSON pointers.
fn numbers(value: &Value, at: String, found: &mut Vec<String>) {
    match value {
        Value::Object(keys) => keys.iter().for_each(|(key, value)| numbers(value, format!("{at}/{key}"), found)),
        Value::Array(values) => values.iter().enumerate().for_each(|(k, v)| numbers(v, format!("{at}/{k}"), found)),
        Value::Number(_) => found.push(at),
        Value::String(text) if text.starts_with(|c: char| c == '-' || c.is_ascii_digit()) => found.push(at),
        _ => {}
    }
}

fn number(value: &Value) -> f64 {
    let part = |text: &str| text.parse::<f64>().unwrap();
    let quotient = |text: &str| text.split_once('/').map_or_else(|| part(text), |(a, b)| part(a) / part(b));
    value.as_f64().unwrap_or_else(|| quotient(value.as_str().unwrap()))
}

/// One number of a file is changed by a tenth of the largest in its column, or a parameter by a tenth; five times `VERIDEM_TRIALS`.
#[test]
fn a_changed_number_in_a_trajectory_is_noticed() {
    let trajectories = PAPERS.trajectories();
    let tried = 5 * setting("VERIDEM_TRIALS");
    let unnoticed = (0..tried).into_par_iter().filter_map(|trial| {
        let mut chance = ChaCha8Rng::seed_from_u64(trial);
        let mut draw = |n: usize| chance.next_u64() as usize % n;
        let trajectory = trajectories[draw(trajectories.len())];
        let mut file = content(trajectory);
        let runs = file["runs"].as_array().unwrap();
        let run = runs[draw(runs.len())].clone();
        let mut places = Vec::new();
        numbers(&run, String::new(), &mut places);
        let place = places.swap_remove(draw(places.len()));
        let (row, column) = place.rsplit_once('/').unwrap();
        let like = |other: &&String| match row.strip_prefix("/samples/") {
            Some(_) => other.starts_with("/samples/") && other.ends_with(&format!("/{column}")),
            None => **other == place,
        };
        places.push(place.clone());
        let largest =
            places.iter().filter(like).map(|other| number(run.pointer(other).unwrap()).abs()).fold(0.0, f64::max);
        let value = number(run.pointer(&place).unwrap());
        let change = if largest == 0.0 { 0.1 } else { 0.1 * largest };
        file["runs"] = json!([run]);
        *file["runs"][0].pointer_mut(&place).unwrap() = json!(value + change);
        let what = format!("{} {}{place}: {value:?} + {change:?}", trajectory.file, file["runs"][0]["name"]);
        check_text(trajectory, &file.to_string()).is_empty().then_some(what)
    });
    let unnoticed: Vec<String> = unnoticed.collect();
    println!("{tried} numbers changed, {} unnoticed", unnoticed.len());
    // A dashpot that nothing moves, or a friction that never slips, has no effect; some small numbers lie within the tolerance of their column.
    assert!(50 * unnoticed.len() as u64 <= tried, "\n{}", unnoticed.join("\n"));
}
