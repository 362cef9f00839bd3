//! The shipped cases, reduced so that each runs in about a second, and variations of them.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;
use serde_yaml::Value;
use std::path::{Path, PathBuf};
use veridem::papers::PAPERS;

/// The reductions: wherever a case has the section, the key gets the value. A shipped case of another kind is run as it is until its sections are
/// added here.
const REDUCED: [(&str, &str, &str); 40] = [
    ("hcp", "size", "[6 d_0, 8 d_0, 3 d_0]"),
    ("amorphous", "largest", "1.5 d_0"),
    ("amorphous", "size", "[8 d_0, 8 d_0, 6 d_0]"),
    ("amorphous", "relaxation", "{repulsion_steps: 100, residual_stress: 1e-2 E}"),
    ("compression", "duration", "200 steps"),
    ("tension", "strain_per_step", "2e-3"),
    ("shear", "strain_per_step", "2e-3"),
    ("shear", "strain", "0.3"),
    ("junction", "diameter", "4.5 nm"),
    ("junction", "walls", "1.2 d_0"),
    ("junction", "shear_velocity", "100 m/s"),
    ("junction", "duration", "300 steps"),
    ("sliding", "asperity_height", "1 d_0"),
    ("sliding", "walls", "1.2 d_0"),
    ("sliding", "shear_velocity", "200 m/s"),
    ("sliding", "duration", "300 steps"),
    ("sliding", "window", "0.3 d_0"),
    ("aggregate", "spheres", "20"),
    ("deposition", "velocity", "50 m/s"),
    ("deposition", "duration", "800 steps"),
    ("indentation", "duration", "300 steps"),
    ("restructuring", "duration", "300 steps"),
    ("agglomerate", "particles", "14"),
    ("stretching", "relaxation", "50 ps"),
    ("stretching", "distance", "0.5 nm"),
    ("approach", "duration", "50 ps"),
    ("slide", "settling", "20 ps"),
    ("slide", "distance", "0.1 nm"),
    ("roll", "settling", "20 ps"),
    ("roll", "distance", "0.1 nm"),
    ("film", "particles", "100"),
    ("film", "sides", "[120 nm, 120 nm]"),
    ("film", "aggregates", "{median: 12, largest: 24}"),
    ("spectroscopy", "relaxation", "50 ps"),
    ("spectroscopy", "tip", "{radius: 10 nm, side: 60 nm}"),
    ("spectroscopy", "speed", "50 m/s"),
    ("spectroscopy", "reversal", "0.1 ns"),
    ("spectroscopy", "average", "20 ps"),
    ("spectroscopy", "depth", "20 nm"),
    ("spectroscopy", "retraction", "10 nm"),
];

/// Rows, frames and checkpoints of all reduced cases.
pub(crate) const OUTPUT: &str = "{series: 50 steps, frames: 400 steps, checkpoints: 150 steps}";

/// Values of which variations draw one. Those that do not go together are refused by the reader and drawn again.
const VARIED: [(&str, &str, &[&str]); 23] = [
    ("wear", "restitution", &["0.3", "0.7", "1"]),
    ("wear", "scaling", &["0", "0.5", "1"]),
    ("wear", "readings", &["own", "as-published"]),
    ("wear", "forget_stretched_springs", &["true"]),
    ("hcp", "size", &["[4 d_0, 6 d_0, 3 d_0]", "[5 d_0, 9 d_0, 3 d_0]"]),
    ("amorphous", "volume_fraction", &["0.6", "0.7"]),
    ("junction", "normal_stress", &["0 MPa", "1 GPa"]),
    ("sliding", "asperities", &["1", "2"]),
    ("soot", "torsion", &["spring", "as-printed", "as-published"]),
    ("soot", "capillary_force", &["0 nN", "3 nN"]),
    ("soot", "cutoff", &["30 nm", "100 nm"]),
    ("aggregate", "spheres", &["2", "9", "35"]),
    ("aggregate", "neck_fraction", &["0", "0.3", "1"]),
    ("aggregate", "deviation", &["1.2"]),
    ("aggregate", "growth", &["spheres"]),
    ("restructuring", "attraction_every", &["1", "3", "7"]),
    ("indentation", "velocity", &["20 m/s"]),
    ("titania", "surface_tension", &["tip3p", "experimental"]),
    ("titania", "humidity", &["0.2", "0.8"]),
    ("titania", "slip", &["reset", "remainder"]),
    ("titania", "moment_arms", &["half-gap", "half-layer"]),
    ("film", "particles", &["60", "140"]),
    ("spectroscopy", "setpoint", &["10 pN", "1 nN"]),
];

/// A case to be compared: its name, and its text.
pub(crate) struct Small {
    pub name: String,
    pub text: String,
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of cases") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "yaml") {
            found.push(path);
        }
    }
}

/// Sets a key in every section of this name.
fn set(case: &mut Value, section: &str, key: &str, value: &Value) {
    if let Value::Sequence(items) = case {
        items.iter_mut().for_each(|item| set(item, section, key, value));
    }
    let Value::Mapping(mapping) = case else { return };
    for (name, inner) in mapping.iter_mut() {
        match inner {
            Value::Mapping(keys) if name.as_str() == Some(section) => drop(keys.insert(key.into(), value.clone())),
            _ => {}
        }
        set(inner, section, key, value);
    }
}

fn parsed(text: &str) -> Value {
    serde_yaml::from_str(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn written(name: &str, case: &Value) -> Small {
    Small { name: name.into(), text: serde_yaml::to_string(case).expect("a case is plain data") }
}

impl Small {
    /// Every shipped case, reduced.
    pub(crate) fn shipped() -> Vec<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
        let mut found = Vec::new();
        files(&root, &mut found);
        found.sort();
        let reduced = |path: PathBuf| {
            let mut case = parsed(&std::fs::read_to_string(&path).expect("a case"));
            REDUCED.iter().for_each(|(section, key, value)| set(&mut case, section, key, &parsed(value)));
            let name = path.strip_prefix(&root).expect("a shipped case").display().to_string();
            written(&name, &case).with_output(OUTPUT)
        };
        found.into_iter().map(reduced).collect()
    }

    /// The same case with other rows, frames and checkpoints.
    pub(crate) fn with_output(&self, output: &str) -> Self {
        let mut case = parsed(&self.text);
        case.as_mapping_mut().expect("a case is a mapping").insert("output".into(), parsed(output));
        written(&self.name, &case)
    }

    /// The same case with another seed and some other values, with which it is accepted.
    pub(crate) fn varied(&self, random: &mut ChaCha8Rng) -> Self {
        loop {
            let mut case = parsed(&self.text);
            let seed = random.next_u32();
            case.as_mapping_mut().expect("a case is a mapping").insert("seed".into(), seed.into());
            for (section, key, values) in VARIED {
                if random.next_u32().is_multiple_of(3) {
                    let value = values[random.next_u32() as usize % values.len()];
                    set(&mut case, section, key, &parsed(value));
                }
            }
            let varied = written(&format!("{}, varied", self.name), &case);
            if PAPERS.parse(Path::new("varied.yaml"), &varied.text).is_ok() {
                return varied;
            }
        }
    }
}
