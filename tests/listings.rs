//! Do the generated lists agree with the program: the JSON Schema of case files, and the page of columns and results?

use boon::{Compiler, Schemas};
use serde_json::Value;
use std::path::Path;
use veridem::case::json_schema::document;
use veridem::papers::PAPERS;

/// The problems of a document.
fn problems(case: &Value) -> Option<String> {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource("case.json", document(&PAPERS.keys())).expect("a resource");
    let schema = compiler.compile("case.json", &mut schemas).expect("a valid schema");
    schemas.validate(case, schema).err().map(|error| error.to_string())
}

fn yaml(text: &str) -> Value {
    serde_yaml::from_str(text).expect("YAML")
}

#[test]
fn every_good_case_is_valid() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut number = 0;
    for folder in ["cases", "cases/wear", "cases/soot", "cases/titania", "tests/cases/good"] {
        for entry in std::fs::read_dir(root.join(folder)).expect("a folder") {
            let path = entry.expect("a file").path();
            if path.extension().is_some_and(|extension| extension == "yaml") {
                let text = std::fs::read_to_string(&path).expect("a case");
                assert_eq!(problems(&yaml(&text)), None, "{}", path.display());
                number += 1;
            }
        }
    }
    assert!(number > 15, "{number}");
}

#[test]
fn a_wrong_key_unit_word_or_choice_is_refused() {
    let good =
        "title: x\nmodel: {soot: {}}\nsample: {aggregate: {spheres: 5}}\nexperiment: {deposition: {duration: 1 ns}}\n";
    assert_eq!(problems(&yaml(good)), None);
    for (right, wrong) in [
        ("title: x\n", ""),
        ("title: x", "title: x\ntitel: y"),
        ("1 ns", "1 nm"),
        ("1 ns", "1"),
        ("spheres: 5", "spheres: five"),
        ("spheres: 5", "spheers: 5"),
        ("{deposition: {duration: 1 ns}}", "{deposition: {}, restructuring: {}}"),
        ("experiment:", "output: {digits: eight}\nexperiment:"),
        ("experiment:", "output: {format: [xyz]}\nexperiment:"),
    ] {
        let case = good.replace(right, wrong);
        assert!(case != good && problems(&yaml(&case)).is_some(), "{case}");
    }
    for quantity in ["1 ns", ".5e-3 µs", "100 steps", "2 fs", "[1, 10, 100 steps]"] {
        let case = good.replace("experiment:", &format!("output: {{frames: {quantity}}}\nexperiment:"));
        assert_eq!(problems(&yaml(&case)), None, "{case}");
    }
}

#[test]
fn the_page_of_columns_and_results_is_up_to_date() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/results.md");
    let page = std::fs::read_to_string(page).expect("the page");
    assert!(page == PAPERS.quantities(), "write it again: veridem schema --results > docs/results.md");
}

#[test]
fn the_page_of_verification_has_every_equation_with_its_independent_vectors() {
    let read = |path: &str| std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("a file");
    let page = read("docs/verification.md");
    let counts: Value = serde_json::from_str(&read("golden/independent.json")).expect("counts");
    for equation in veridem_spec::equations() {
        let row = format!("\n| {} | {} | ", equation.id, counts[equation.id]);
        assert!(page.contains(&row), "{}: cargo run -p veridem-mutants -- table", equation.id);
    }
}
