//! From the paper to the specification and back: no equation is missing, claimed twice, unproven or mislabelled.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use veridem::book::files;
use veridem::equations::{Entry, Registry};
use veridem::golden::{documented, index};
use veridem::papers::PAPERS;
use veridem_spec::equation::Equation;
use veridem_spec::finding::{Finding, Kind};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Names of the arguments of a function, from its source.
fn argument_names(equation: &Equation) -> Vec<String> {
    let start = equation.source.find(&format!("pub fn {}<", equation.function)).expect("the function is in its file");
    let signature = &equation.source[start..];
    let signature = &signature[signature.find('(').expect("arguments")..signature.find(" -> ").expect("a result")];
    signature
        .trim_matches(['(', ')'])
        .split(", ")
        .flat_map(|part| part.split(",\n"))
        .filter_map(|argument| argument.split_once(':').map(|(name, _)| name.trim().to_string()))
        .collect()
}

#[test]
fn tables_list_the_arguments_in_order_with_their_shapes() {
    for (equation, document) in documented().unwrap() {
        let names: Vec<String> = document.arguments.iter().map(|q| q.name.clone()).collect();
        assert_eq!(names, argument_names(&equation), "{}", equation.id);
        let shape = (equation.shape)();
        let sizes =
            |quantities: &[veridem_spec::document::Quantity]| quantities.iter().map(|q| q.size).collect::<Vec<_>>();
        assert_eq!(sizes(&document.arguments), shape.arguments, "{}", equation.id);
        assert_eq!(sizes(&document.results), shape.results, "{}", equation.id);
        let unique: BTreeSet<&String> = document.arguments.iter().chain(&document.results).map(|q| &q.name).collect();
        assert_eq!(unique.len(), document.arguments.len() + document.results.len(), "{}: a name twice", equation.id);
    }
}

#[test]
fn every_equation_shows_its_number_its_formula_and_its_reading() {
    for (equation, document) in documented().unwrap() {
        assert!(!document.formula.is_empty(), "{}: no formula", equation.id);
        assert!(equation.covers.is_empty() || !document.reading.is_empty(), "{}: no reading", equation.id);
        // a formula that the paper prints twice has one function and one documentation, which names both numbers
        for number in equation.covers {
            let printed = number.replace('A', "A.");
            let text = format!("{} {}", document.title, document.reading);
            let named =
                text.split(|c: char| !c.is_alphanumeric() && c != '.').any(|word| word.trim_matches('.') == printed);
            assert!(named, "{} does not mention Eq. {printed}", equation.id);
        }
    }
}

/// The functions in the module `laws` of a file: name, whether a test, whether inside `proptest!`.
fn laws_of(source: &str) -> Vec<(String, bool, bool)> {
    let Some((_, module)) = source.split_once("\n#[cfg(test)]\n") else { return vec![] };
    assert!(
        module.lines().next().is_some_and(|line| line.ends_with("mod laws {")),
        "laws are all that is for tests only"
    );
    let (mut attributes, mut out, mut in_proptest) = (vec![], vec![], false);
    for line in module.lines() {
        match line.trim() {
            "proptest! {" => in_proptest = true,
            text if line == "    }" && text == "}" => in_proptest = false,
            text if text.starts_with("#[") => attributes.push(text.to_string()),
            text if text.starts_with("fn ") => {
                let name = text[3..].split(['(', '<']).next().unwrap_or_default().to_string();
                let is_test =
                    attributes.iter().any(|a| a == "#[test]") && !attributes.iter().any(|a| a.contains("ignore"));
                out.push((name, is_test, in_proptest));
                attributes.clear();
            }
            "" => attributes.clear(),
            _ => {}
        }
    }
    out
}

#[test]
fn laws_are_exactly_the_tests_that_run() {
    let mut listed: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    let documented = documented().unwrap();
    for (equation, document) in &documented {
        assert!(!document.laws.is_empty(), "{} has no law", equation.id);
        listed.entry(equation.file).or_default().extend(document.laws.iter().cloned());
    }
    for (equation, _) in &documented {
        let laws = laws_of(equation.source);
        for (name, is_test, in_proptest) in &laws {
            assert!(*is_test || !in_proptest, "spec/{}: `{name}` is not marked #[test], it never runs", equation.file);
        }
        let tests: BTreeSet<String> = laws.into_iter().filter(|law| law.1).map(|law| law.0).collect();
        assert_eq!(
            tests, listed[equation.file],
            "spec/{}: tests on the left, laws in the documentation on the right",
            equation.file
        );
    }
}

/// The text of each function in the module `laws` of a file, by its name, without comments.
fn bodies(source: &str) -> BTreeMap<String, String> {
    let Some((_, module)) = source.split_once("\n#[cfg(test)]\n") else { return BTreeMap::new() };
    let (mut out, mut current): (BTreeMap<String, String>, Option<(String, String)>) = (BTreeMap::new(), None);
    for line in module.lines() {
        let text = line.split("//").next().unwrap_or_default();
        let indent = &line[..line.len() - line.trim_start().len()];
        if let Some((name, end)) = &current {
            out.get_mut(name).expect("begun").push_str(text);
            if line == end {
                current = None;
            }
        } else if let Some(signature) = text.trim_start().strip_prefix("fn ") {
            let name = signature.split(['(', '<']).next().unwrap_or_default().to_string();
            out.insert(name.clone(), signature[name.len()..].to_string());
            current = Some((name, format!("{indent}}}")));
        }
    }
    out
}

/// Whether a text contains a name, whole.
fn names(text: &str, name: &str) -> bool {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name)
}

/// Whether a law calls a function, itself or through another function beside it.
fn calls(bodies: &BTreeMap<String, String>, law: &str, function: &str) -> bool {
    let (mut seen, mut next) = (BTreeSet::new(), vec![law]);
    while let Some(name) = next.pop() {
        let Some(body) = bodies.get(name).filter(|_| seen.insert(name)) else { continue };
        if names(body, function) {
            return true;
        }
        next.extend(bodies.keys().map(String::as_str).filter(|other| names(body, other)));
    }
    false
}

#[test]
fn every_equation_is_called_by_one_of_its_laws() {
    for (equation, document) in documented().unwrap() {
        let bodies = bodies(equation.source);
        let called = document.laws.iter().any(|law| calls(&bodies, law, equation.function));
        assert!(called, "{}: no law in spec/{} calls `{}`", equation.id, equation.file, equation.function);
    }
}

#[test]
fn a_law_that_calls_something_else_is_noticed() {
    let source = "\n#[cfg(test)]\nmod laws {\n    fn help(x: f64) -> f64 {\n        double(x)\n    }\n    #[test]\n    fn through() {\n        help(1.0);\n    }\n    #[test]\n    fn beside() {\n        doubled(1.0); // double(1.0)\n    }\n}\n";
    let bodies = bodies(source);
    assert!(calls(&bodies, "through", "double") && !calls(&bodies, "beside", "double"));
}

#[test]
fn a_law_that_would_not_run_is_noticed() {
    let source = "\n#[cfg(test)]\nmod laws {\n    proptest! {\n        #[test]\n        fn runs(x in 0.0..1.0) {}\n\n        fn never(x in 0.0..1.0) {}\n    }\n    #[test]\n    #[ignore]\n    fn ignored() {}\n";
    let laws = laws_of(source);
    let expected = [("runs", true, true), ("never", false, true), ("ignored", false, false)];
    assert_eq!(laws, expected.map(|(name, test, inside)| (name.to_string(), test, inside)));
}

#[test]
fn every_erratum_states_its_effect_and_the_laws_that_fail_for_it() {
    let documented = documented().unwrap();
    let mut errata = 0;
    for (equation, document) in &documented {
        let labelled = ["Erratum", "Ambiguous", "Cancellation"].iter().any(|word| document.reading.starts_with(word));
        let Some(finding) = Finding::of(document) else {
            assert!(!labelled, "{}: the label of its reading ends with a colon", equation.id);
            continue;
        };
        if finding.kind == Kind::Erratum {
            errata += 1;
            assert!(!finding.effect.is_empty() && !finding.proof.is_empty(), "{}: no effect or no proof", equation.id);
        }
        let beside = documented.iter().filter(|(other, _)| other.file == equation.file);
        let laws: BTreeSet<&str> = beside.flat_map(|(_, document)| document.laws.iter().map(String::as_str)).collect();
        for law in finding.proof {
            assert!(laws.contains(law), "{}: `{law}` is no law in spec/{}", equation.id, equation.file);
        }
    }
    assert!(errata > 20, "{errata} errata");
}

#[test]
fn every_number_of_a_paper_is_carried_by_exactly_one_equation() {
    let mut ids = BTreeSet::new();
    for paper in veridem_spec::papers() {
        let mut carried = BTreeSet::new();
        for equation in (paper.equations)() {
            assert!(ids.insert(equation.id), "{}: an id twice", equation.id);
            assert!(equation.id.starts_with(&format!("{}-", paper.name)), "{}: not of {}", equation.id, paper.name);
            for number in equation.covers {
                assert_eq!(equation.id, format!("{}-{number}", paper.name), "the id says the number");
                assert!(carried.insert(number.to_string()), "Eq. {number} is carried twice");
            }
        }
        assert_eq!(carried, BTreeSet::from_iter(paper.numbers), "{}", paper.name);
    }
}

#[test]
fn the_index_is_up_to_date() {
    let now = index(root(), &documented().unwrap()).unwrap();
    let kept = std::fs::read_to_string(root().join(veridem::golden::INDEX)).unwrap();
    assert!(now == kept, "run `veridem golden regenerate`");
}

/// The book with all its pages, of which each is made of what the repository has.
#[test]
fn the_book_shows_laws_values_of_others_claims_and_links() {
    let registry = Registry::new();
    let pages: BTreeMap<String, String> = files(root(), &registry, PAPERS).unwrap().into_iter().collect();
    for Entry { equation, document } in &registry.0 {
        let page = &pages[&format!("{}.html", equation.id)];
        for law in &document.laws {
            assert!(page.contains(&law[1..].replace('_', " ")), "{}: {law}", equation.id);
        }
        // Beside its laws, what the page of proofs says, and what holds by construction.
        let count = page.matches("class=\"status\"").count();
        assert!(count > document.laws.len() + 1, "{}: {count} statements", equation.id);
    }
    let shows = |page: &str, text: &str| pages[page].contains(text);
    assert!(shows("soot-18.html", "azplugins") && !shows("soot-1.html", "azplugins"));
    assert!(shows("wear-published-contact.html", "href=\"wear-contact.html\""));
    assert!(shows("claims-wear.html", "<a href=\"wear-19.html\">Eq. 19, Table 4</a>"));
    assert!(shows("wear-19.html", "Table 4") && !shows("wear-4.html", "Table 4"));
    assert!(shows("tables.html", "73 GPa"));
    assert!(shows("claims.html", "never measured") && shows("claims.html", "href=\"index.html#claims\""));
    assert!(shows("verification.html", "href=\"titania.eq02_torque.rs.html\""));
}
