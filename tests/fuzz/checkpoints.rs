//! Checkpoints whose checksum is right and whose content is not: the bytes are edits of the checkpoint of a stopped run.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tempfile::TempDir;
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::output::RunFolder;
use veridem::papers::PAPERS;

/// Small cases, and the steps after which they are stopped: with springs, walls, bodies, necks, surfaces and every kind of observer.
const CASES: [(&str, u64); 6] = [
    (
        "title: A tip\nmodel: {soot: {necks: S}}\nsample: {aggregate: {spheres: 6, neck_fraction: 1}}\nexperiment: {sequence: [\
         {deposition: {velocity: 2 m/s, duration: 120 steps}}, {indentation: {gap: 7 nm, cantilever: 70e-3 1/ns, duration: 90 steps}}]}\n\
         output: {series: 20 steps, frames: 60 steps, checkpoints: 1 s}\n",
        170,
    ),
    (
        "title: Tests\nmodel: {wear: {young_modulus: 1 GPa, poisson_ratio: 0.15, tensile_strength: 0.2 GPa, shear_strength: 0.1 GPa, \
         surface_energy: 1.5 N/m, restitution: 0.95, density: 1000 kg/m^3, scaling: 0.5}}\nsample: {hcp: {diameter: 0.6 d_c, size: [3 d_0, 6 d_0, 3 d_0]}}\n\
         experiment: {patch: {compression: {duration: 30 steps}, tension: {strain_per_step: 1e-3}, shear: {strain_per_step: 1e-3, strain: 0.3}}}\n\
         output: {series: 10 steps, frames: 1 s, checkpoints: 1 s}\n",
        50,
    ),
    (
        "title: A junction\nmodel: {wear: {young_modulus: 73 GPa, poisson_ratio: 0.17, tensile_strength: 16 GPa, shear_strength: 9 GPa, \
         surface_energy: 1.5 J/m^2, restitution: 0.9, density: 2200 kg/m^3, scaling: 0.5}}\n\
         sample: {amorphous: {diameter: 3 nm, largest: 4.5 nm, size: [18 nm, 24 nm, 14 nm], relaxation: {repulsion_steps: 50, residual_stress: 1e-1 E}}}\n\
         experiment: {junction: {diameter: 9 nm, walls: 3 nm, shear_velocity: 100 m/s, normal_stress: 100 MPa, duration: 300 steps}}\n\
         output: {series: 20 steps, frames: 1 s, checkpoints: 1 s}\n",
        200,
    ),
    (
        "title: A chain\nmodel: {titania: {}}\nsample: {agglomerate: {}}\n\
         experiment: {stretching: {relaxation: 20 ps, distance: 9 nm, dt: 0.5 ps}}\noutput: {series: 20 ps, frames: 1 s, checkpoints: 1 s}\n",
        60,
    ),
    (
        "title: A film\nseed: 5\nmodel: {titania: {damping_constant: 5e6 N s/m^3}}\n\
         sample: {film: {particles: 40, sides: [80 nm, 80 nm], aggregates: {median: 12, largest: 24}}}\n\
         experiment: {spectroscopy: {relaxation: 20 ps, tip: {radius: 10 nm, side: 40 nm}, speed: 5 m/s, setpoint: 40 pN, reversal: 4 ns, average: 0.5 ns, \
         depth: 60 nm, retraction: 160 nm, dt: 0.5 ps}}\noutput: {series: 20 ps, frames: 1 s, checkpoints: 1 s}\n",
        80,
    ),
    (
        "title: A pair\nmodel: {titania: {}}\nsample: {pair: {}}\nexperiment: {contact: {approach: {duration: 5 ps}, \
         slide: {settling: 0.5 ns, distance: 1.1 nm}, roll: {settling: 0.5 ns, velocity: 0.1 m/s, distance: 0.05 nm}}}\n\
         output: {series: 10 ps, frames: 1 s, checkpoints: 1 s}\n",
        80,
    ),
];

/// Steps that a resumed run takes.
const STEPS: u64 = 3;

/// Numbers that no state holds, or no such number.
const NUMBERS: [f64; 12] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, -1.0, 0.0, -0.0, 1.0, 1e30, 1e-30, -1e9];

const STOPPED: &str = "checkpoints/stopped.checkpoint";

/// A stopped run: its case, and the files of its folder.
struct Run {
    case: &'static str,
    files: Vec<(PathBuf, Vec<u8>)>,
    /// The checkpoint: heading with checksum, and content.
    head: Vec<u8>,
    body: Vec<u8>,
}

fn desk() -> TempDir {
    let memory = Path::new("/dev/shm");
    if memory.is_dir() { tempfile::tempdir_in(memory) } else { tempfile::tempdir() }.expect("a folder")
}

fn after(steps: u64) -> Interrupt {
    Interrupt::new(None, Some(steps)).expect("signal handlers")
}

fn read(folder: &Path, within: &Path, files: &mut Vec<(PathBuf, Vec<u8>)>) {
    for entry in std::fs::read_dir(folder.join(within)).expect("a folder") {
        let path = within.join(entry.expect("an entry").file_name());
        if folder.join(&path).is_dir() {
            read(folder, &path, files);
        } else {
            let bytes = std::fs::read(folder.join(&path)).expect("a file");
            files.push((path, bytes));
        }
    }
}

/// The runs that the edits are made in.
fn runs() -> &'static [Run] {
    static RUNS: OnceLock<Vec<Run>> = OnceLock::new();
    RUNS.get_or_init(|| CASES.iter().map(|&(case, steps)| run(case, steps)).collect())
}

fn run(case: &'static str, steps: u64) -> Run {
    let desk = desk();
    let root = desk.path().join("run");
    let job = PAPERS.parse(Path::new("a.yaml"), case).unwrap_or_else(|error| panic!("{case}{error}"));
    match job.launch(&root, false, &after(steps), &mut |_| {}) {
        Err(Error::Stopped(_)) => {}
        other => panic!("{case}{:?}", other.map(drop)),
    }
    let mut files = Vec::new();
    read(&root, Path::new(""), &mut files);
    let place = files.iter().position(|file| file.0 == Path::new(STOPPED)).expect("a checkpoint");
    let checkpoint = files.swap_remove(place).1;
    let head = checkpoint.iter().position(|&byte| byte == b'\n').expect("a heading") + 1;
    Run { case, files, head: checkpoint[..head].into(), body: checkpoint[head + 4..].into() }
}

/// Number of the runs.
#[cfg(test)]
pub(crate) fn number_of_runs() -> usize {
    runs().len()
}

/// The content of a checkpoint after the edits that some bytes stand for.
fn edited(body: &[u8], edits: &[u8]) -> Vec<u8> {
    let mut body = body.to_vec();
    for &[low, middle, high, action, value, count] in edits.as_chunks().0 {
        let at = u32::from_le_bytes([low, middle, high, 0]) as usize % body.len().max(1);
        let end = body.len().min(at + 8);
        match action % 7 {
            0 => body[at] = value,
            1 => body[at] ^= 1 << (value % 8),
            2 => body[at..end].copy_from_slice(&NUMBERS[value as usize % NUMBERS.len()].to_le_bytes()[..end - at]),
            3 => drop(body.drain(at..(at + 1 + count as usize % 16).min(body.len()))),
            4 => drop(body.splice(at..at, vec![value; 1 + count as usize % 16])),
            5 => {
                let to = (at + 8 * (1 + value as usize % 64)).min(body.len() - (end - at));
                body.copy_within(at..end, to);
            }
            _ => body.truncate(at),
        }
        if body.is_empty() {
            break;
        }
    }
    body
}

/// Resumes one of the runs after edits of its checkpoint: it continues, halts, or refuses a file of the run by its name.
pub(crate) fn resumed(bytes: &[u8]) {
    static AFTER: OnceLock<Interrupt> = OnceLock::new();
    let Some((&which, edits)) = bytes.split_first() else { return };
    let Run { case, files, head, body } = &runs()[which as usize % runs().len()];
    let (desk, body) = (desk(), edited(body, edits));
    let root = desk.path().join("run");
    for folder in ["checkpoints", "frames", "figures"] {
        std::fs::create_dir_all(root.join(folder)).expect("a folder");
    }
    for (path, bytes) in files {
        std::fs::write(root.join(path), bytes).expect("a file");
    }
    let checkpoint = root.join(STOPPED);
    std::fs::write(&checkpoint, [head, &crc32fast::hash(&body).to_le_bytes()[..], &body].concat()).expect("a file");
    let job = PAPERS.parse(Path::new("a.yaml"), case).expect("a good case");
    let folder = RunFolder::open(&root).expect("a run folder");
    match job.resume(&folder, AFTER.get_or_init(|| after(STEPS)), &mut |_| {}) {
        Ok(_) | Err(Error::Stopped(_) | Error::Halted(..) | Error::Verification(_)) => {}
        // What a checkpoint says of the record may be at odds with a file of the record.
        Err(Error::Input(problems)) => assert!(problems[0].file.starts_with(&root), "{}", problems[0]),
        Err(other) => panic!("{other}"),
    }
}
