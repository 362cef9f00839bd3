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

/// Numbers of samples of each property: for the first try, for what has survived it, and for the sweep.
pub(crate) const FEW: &str = "16";
pub(crate) const MANY: &str = "128";
pub(crate) const SWEEP: &str = "64";

/// Number of no mutant.
pub(crate) const NONE: u32 = 1 << 20;

/// The laws, and the mutants that each reaches.
pub(crate) struct Laws {
    program: PathBuf,
    /// All laws, with the time that each takes.
    times: BTreeMap<String, Duration>,
    reached: BTreeMap<u32, BTreeSet<String>>,
}

impl Laws {
    /// The laws of the copy, all of which hold without a mutant.
    pub(crate) fn of(copy: &Copy) -> Self {
        let list = Command::new(&copy.tests).args(["--list", "--format=terse"]).output().expect("a list");
        let list = String::from_utf8_lossy(&list.stdout).to_string();
        let names: Vec<String> =
            list.lines().filter_map(|line| line.strip_suffix(": test").map(String::from)).collect();
        Self {
            program: copy.tests.clone(),
            times: names.into_iter().map(|name| (name, Duration::ZERO)).collect(),
            reached: BTreeMap::new(),
        }
    }

    /// Finds which mutants each law reaches, and how long it takes; kept as long as code and laws are the same.
    pub(crate) fn record(&mut self, copy: &Copy) {
        let names: Vec<String> = self.times.keys().cloned().collect();
        let folder = copy.home.join(format!("reached-{}", copy.laws));
        std::fs::create_dir_all(&folder).expect("a folder");
        let found = in_parallel(&names, |_, name| {
            let file = folder.join(name.replace("::", "."));
            if let Some(kept) = recorded(&file) {
                return kept;
            }
            let (begin, growing) = (Instant::now(), folder.join(format!("{name}.growing")));
            let holds = self.hold(&[name.as_str()], None, Some(&growing), ENDLESS, FEW);
            assert!(holds, "{name} fails without any mutant");
            let time = begin.elapsed();
            let reached = std::fs::read_to_string(&growing).unwrap_or_default();
            let _ = std::fs::remove_file(&growing);
            std::fs::write(&file, format!("{}\n{reached}", time.as_millis())).expect("a file");
            recorded(&file).expect("what has just been written")
        });
        for (name, (time, reached)) in names.into_iter().zip(found) {
            for id in reached {
                self.reached.entry(id).or_default().insert(name.clone());
            }
            self.times.insert(name, time);
        }
    }

    /// The full name of a law of a file.
    pub(crate) fn named(&self, file: &str, law: &str) -> Option<&str> {
        let path = format!("{}::laws::{law}", module(file));
        self.times.get_key_value(&path).map(|(name, _)| name.as_str())
    }

    /// Those that reach a mutant in a file: those of the file first, the others; each by the time they take.
    pub(crate) fn reaching(&self, mutant: u32, file: &str) -> [Vec<&str>; 2] {
        let all = self.reached.get(&mutant).into_iter().flatten().map(String::as_str);
        let begin = format!("{}::", module(file));
        let (mut own, mut others): (Vec<&str>, Vec<&str>) = all.partition(|name| name.starts_with(&begin));
        own.sort_by_key(|name| self.times[*name]);
        others.sort_by_key(|name| self.times[*name]);
        [own, others]
    }

    /// How long laws take together without a mutant.
    pub(crate) fn time(&self, names: &[&str]) -> Duration {
        names.iter().map(|name| self.times[*name]).sum()
    }

    /// All laws of a file.
    pub(crate) fn of_file(&self, file: &str) -> Vec<&str> {
        let begin = format!("{}::", module(file));
        self.times.keys().map(String::as_str).filter(|name| name.starts_with(&begin)).collect()
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
        let mut command = Command::new(&self.program);
        command
            .args(["--exact", "--quiet", "--test-threads=1"])
            .args(names)
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
        ends_well(command.spawn().expect("the tests"), patience)
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
