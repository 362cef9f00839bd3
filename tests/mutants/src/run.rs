//! Runs laws with one mutant active.

use crate::copy::Copy;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Laws without a mutant take no longer, however busy the machine is.
pub(crate) const ENDLESS: Duration = Duration::from_secs(3600);

/// Laws that with a mutant still run after this time have noticed something, if they take `time` without.
pub(crate) fn patience(time: Duration) -> Duration {
    10 * time + Duration::from_secs(20)
}

/// Laws that take longer while what they reach is recorded are timed again without.
const RECORDED: Duration = Duration::from_secs(1);

/// Numbers of samples of each property: for the first try, for what has survived it, and for the sweep.
pub(crate) const FEW: &str = "16";
pub(crate) const MANY: &str = "128";
pub(crate) const SWEEP: &str = "64";

/// Number of no mutant.
pub(crate) const NONE: u32 = 1 << 20;

/// A test.
struct Law {
    program: PathBuf,
    /// Its name in the program.
    name: String,
    /// How long it takes.
    time: Duration,
    /// How many mutants it has been tried with, and how many it has noticed.
    tried: AtomicUsize,
    noticed: AtomicUsize,
}

impl Law {
    /// How long it takes for every mutant that it notices, as far as is known.
    fn cost(&self) -> Duration {
        let [tried, noticed] = [&self.tried, &self.noticed].map(|count| count.load(Ordering::Relaxed) as f64);
        self.time.mul_f64((tried + 2.0) / (noticed + 1.0))
    }
}

/// The laws, and the mutants that each reaches.
pub(crate) struct Laws {
    laws: BTreeMap<String, Law>,
    reached: BTreeMap<u32, BTreeSet<String>>,
}

impl Laws {
    /// The laws of the copy, all of which hold without a mutant.
    pub(crate) fn of(copy: &Copy) -> Self {
        let mut laws = BTreeMap::new();
        for (begin, program) in &copy.tests {
            let list = Command::new(program).args(["--list", "--format=terse"]).output().expect("a list");
            let list = String::from_utf8_lossy(&list.stdout).to_string();
            let names = list.lines().filter_map(|line| line.strip_suffix(": test"));
            let law = |name: &str| Law {
                program: program.clone(),
                name: name.into(),
                time: Duration::ZERO,
                tried: AtomicUsize::new(0),
                noticed: AtomicUsize::new(0),
            };
            laws.extend(names.map(|name| (format!("{begin}{name}"), law(name))));
        }
        Self { laws, reached: BTreeMap::new() }
    }

    /// Finds which mutants each law reaches, and how long it takes; kept as long as code and laws are the same.
    pub(crate) fn record(&mut self, copy: &Copy) {
        let names: Vec<String> = self.laws.keys().cloned().collect();
        let folder = copy.home.join(format!("reached-{}", copy.laws));
        std::fs::create_dir_all(&folder).expect("a folder");
        let found = in_parallel(&names, |_, name| {
            let file = folder.join(name.replace("::", ".").replace(": ", "."));
            if let Some(kept) = recorded(&file) {
                return kept;
            }
            let (begin, growing) = (Instant::now(), PathBuf::from(format!("{}.growing", file.display())));
            let holds = self.hold(&[name.as_str()], None, Some(&growing), ENDLESS, FEW);
            assert!(holds, "{name} fails without any mutant");
            let mut time = begin.elapsed();
            if time > RECORDED {
                let begin = Instant::now();
                self.hold(&[name.as_str()], Some(NONE), None, ENDLESS, FEW);
                time = begin.elapsed();
            }
            let reached = std::fs::read_to_string(&growing).unwrap_or_default();
            let _ = std::fs::remove_file(&growing);
            std::fs::write(&file, format!("{}\n{reached}", time.as_millis())).expect("a file");
            recorded(&file).expect("what has just been written")
        });
        for (name, (time, reached)) in names.into_iter().zip(found) {
            for id in reached {
                self.reached.entry(id).or_default().insert(name.clone());
            }
            self.laws.get_mut(&name).expect("a law").time = time;
        }
    }

    /// The full name of a law of a file.
    pub(crate) fn named(&self, file: &str, law: &str) -> Option<&str> {
        let path = format!("{}::laws::{law}", module(file));
        self.laws.get_key_value(&path).map(|(name, _)| name.as_str())
    }

    /// Those that reach a mutant in a file: those of the file first, the others; each by the time they are likely to need.
    pub(crate) fn reaching(&self, mutant: u32, file: &str) -> [Vec<&str>; 2] {
        let all = self.reached.get(&mutant).into_iter().flatten().map(String::as_str);
        let begin = format!("{}::", module(file));
        let (mut own, mut others): (Vec<&str>, Vec<&str>) = all.partition(|name| name.starts_with(&begin));
        own.sort_by_cached_key(|name| self.laws[*name].cost());
        others.sort_by_cached_key(|name| self.laws[*name].cost());
        [own, others]
    }

    /// How long laws take together without a mutant.
    pub(crate) fn time(&self, names: &[&str]) -> Duration {
        names.iter().map(|name| self.laws[*name].time).sum()
    }

    /// All laws of a file.
    pub(crate) fn of_file(&self, file: &str) -> Vec<&str> {
        let begin = format!("{}::", module(file));
        self.laws.keys().map(String::as_str).filter(|name| name.starts_with(&begin)).collect()
    }

    /// Whether laws hold with a mutant, within some time, for a number of samples of each property.
    pub(crate) fn hold(
        &self,
        names: &[&str],
        mutant: Option<u32>,
        reached: Option<&Path>,
        patience: Duration,
        samples: &str,
    ) -> bool {
        names.chunk_by(|a, b| self.laws[*a].program == self.laws[*b].program).all(|names| {
            let mut command = Command::new(&self.laws[names[0]].program);
            command
                .args(["--exact", "--quiet", "--test-threads=1"])
                .args(names.iter().map(|name| &self.laws[*name].name))
                .stdout(Stdio::null())
                .stderr(Stdio::null());
            // the same samples for every mutant, fewer of them, and no search for the simplest one that fails
            command.envs([("PROPTEST_RNG_SEED", "1"), ("PROPTEST_CASES", samples), ("PROPTEST_MAX_SHRINK_ITERS", "0")]);
            command.env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1").env("RUST_BACKTRACE", "0");
            if let Some(mutant) = mutant {
                command.env("VERIDEM_MUTANT", mutant.to_string());
            }
            if let Some(file) = reached {
                command.env("VERIDEM_REACHED", file);
            }
            let holds = ends_well(command.spawn().expect("the tests"), patience);
            for law in names.iter().map(|name| &self.laws[*name]) {
                law.tried.fetch_add(1, Ordering::Relaxed);
                law.noticed.fetch_add(usize::from(!holds), Ordering::Relaxed);
            }
            holds
        })
    }
}

/// The time that a law takes, and what it reaches, as it was written down.
fn recorded(file: &Path) -> Option<(Duration, Vec<u32>)> {
    let text = std::fs::read_to_string(file).ok()?;
    let mut numbers = text.lines().map(str::parse::<u32>);
    let time = Duration::from_millis(numbers.next()?.ok()?.into());
    Some((time, numbers.map(|number| number.expect("a number")).collect()))
}

fn module(file: &str) -> String {
    file.trim_end_matches(".rs").trim_end_matches("/mod").replace('/', "::")
}

fn ends_well(mut child: Child, patience: Duration) -> bool {
    let begin = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("a status") {
            return status.success();
        }
        if begin.elapsed() > patience {
            let _ = child.kill();
            let _ = child.wait();
            return false;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Does the same with every item, on all processors; results in the order of the items.
pub(crate) fn in_parallel<T: Sync, U: Send>(items: &[T], work: impl Fn(usize, &T) -> U + Sync) -> Vec<U> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(k) else { break };
                    let result = work(k, item);
                    done.lock().expect("no panic").insert(k, result);
                }
            });
        }
    });
    done.into_inner().expect("no panic").into_values().collect()
}
