//! Sections 3.2 and 4: how many necks have to break, which branches collapse, and what sets the time.

use super::closures::{Closure, closures};
use super::ensemble::{COARSE, Protocol, points};
use crate::error::Error;
use crate::figures::{Axis, Curve, Mark, Plot};
use crate::geometry::Sphere;
use crate::interrupt::Interrupt;
use crate::observe::statistics::Mean;
use crate::output::aggregate::{CONVEXITY, COORDINATION, GYRATION_RADIUS};
use crate::output::columns::TIME;
use crate::output::{ReadFrame, RunFolder, Series};
use crate::reproduce::{Claim, Evidence, Figure, Setting};
use crate::spec::Vec3;

/// The output from which the chapter reads when spheres come to touch.
const OUTPUT: [(&str, &str); 2] = [("output.series", "0.1 ns"), ("output.frames", "1 ns")];

/// Necks of an aggregate of 150 spheres.
const NECKS: u32 = 149;
/// Broken necks of the first kinds, and the fraction that is kept.
const BROKEN: [(u32, &str); 6] = [(149, "0"), (75, "0.5"), (15, "0.9"), (5, "0.967"), (2, "0.987"), (1, "0.994")];
/// The place of the kind with two broken necks.
const TWO: usize = 4;
/// The place of the kind with one broken neck.
const ONE: usize = 5;
/// What may decide whether two broken necks suffice: the reading, and the keys.
const DECIDING: [(&str, &[(&str, &str)]); 3] = [
    ("torsion springs rotated into the contact plane, as printed", &[("model.soot.torsion", "as-printed")]),
    (
        "a coating that reaches six radii instead of four",
        &[("model.soot.capillary_reach", "84 nm"), ("model.soot.cutoff", "98 nm")],
    ),
    (
        "contacts without rolling and torsional friction",
        &[("model.soot.friction.at_rest", "[1.0, 0.0, 0.0]"), ("model.soot.friction.in_motion", "[1.0, 0.0, 0.0]")],
    ),
];
/// What may set the time without necks: its name and the keys; the first two are the driving force, by which the others are compared.
const TIMED: [(&str, &[(&str, &str)]); 4] = [
    ("a quarter of the capillary force", &[("model.soot.capillary_force", "0.25 nN")]),
    ("four times the capillary force", &[("model.soot.capillary_force", "4 nN")]),
    ("four times the Hamaker constant", &[("model.soot.hamaker_constant", "4e-19 J")]),
    (
        "a quarter of the friction",
        &[
            ("model.soot.friction.at_rest", "[0.25, 0.025, 0.025]"),
            ("model.soot.friction.in_motion", "[0.25, 0.025, 0.025]"),
        ],
    ),
];
/// Ratio of the two capillary forces.
const FORCES: f64 = 16.0;
/// Part of the decrease in the radius of gyration of an aggregate without necks that is a major restructuring.
const MAJOR: f64 = 0.5;

/// The keys of every kind.
fn kinds() -> Vec<Vec<(&'static str, String)>> {
    let kept = |fraction: &str| vec![("sample.aggregate.neck_fraction", fraction.to_string())];
    let with = |fraction: &str, keys: &[(&'static str, &str)]| {
        kept(fraction).into_iter().chain(keys.iter().map(|&(key, value)| (key, value.to_string()))).collect()
    };
    let broken = BROKEN.iter().map(|(_, fraction)| kept(fraction));
    let deciding = DECIDING.iter().map(|(_, keys)| with(BROKEN[TWO].1, keys));
    let timed = TIMED.iter().map(|(_, keys)| with(BROKEN[0].1, keys));
    broken.chain(deciding).chain(timed).collect()
}

/// What became of one aggregate.
struct Member {
    /// Coordination number, convexity and radius of gyration (nm) at the beginning and at the end.
    shape: [[f64; 2]; 3],
    /// Time at which half of the increase in the coordination number is reached for good, ns.
    half: f64,
    closures: Vec<Closure>,
}

impl Member {
    fn read(folder: &RunFolder, interrupt: &Interrupt) -> Result<Self, Error> {
        let series = Series::read(folder)?;
        let curves = [COORDINATION, CONVEXITY, GYRATION_RADIUS].map(|column| series.curve("", TIME, column));
        let ends = |curve: &Vec<(f64, f64)>| [0, curve.len() - 1].map(|k| curve[k].1);
        let shape = curves.each_ref().map(ends);
        let state = |path: &std::path::PathBuf| {
            let frame = ReadFrame::read(path)?;
            let spheres = frame.centres().zip(frame.radii()).map(|(x, &radius)| Sphere { centre: Vec3(x), radius });
            Ok((frame.time, spheres.collect()))
        };
        let frames = ReadFrame::all(folder, &series.stages())?;
        let states = frames.iter().map(state).collect::<Result<Vec<(f64, Vec<Sphere>)>, Error>>()?;
        Ok(Self { shape, half: half(&curves[0]), closures: closures(&states, interrupt)? })
    }

    /// Decrease of the radius of gyration, relative to its beginning.
    fn shrunk(&self) -> f64 {
        let [first, last] = self.shape[2];
        1.0 - last / first
    }

    /// Mean number of contacts along the aggregate between the spheres of the closures that are `of` its time; a NaN if there are none.
    fn length(&self, of: impl Fn(f64) -> bool) -> f64 {
        let lengths: Vec<f64> = self.closures.iter().filter(|one| of(one.time)).map(|one| one.contacts).collect();
        lengths.iter().sum::<f64>() / lengths.len() as f64
    }

    /// How much longer the later half of the closures are than the earlier.
    fn later_less_earlier(&self) -> f64 {
        let mut times: Vec<f64> = self.closures.iter().map(|one| one.time).collect();
        times.sort_unstable_by(f64::total_cmp);
        let Some(&middle) = times.get(times.len() / 2) else { return f64::NAN };
        self.length(|time| time >= middle) - self.length(|time| time < middle)
    }
}

/// Time after which a curve is at least half way from its first to its last value, by interpolation.
fn half(curve: &[(f64, f64)]) -> f64 {
    let (first, last) = (curve[0].1, curve[curve.len() - 1].1);
    let middle = 0.5 * (first + last);
    let Some(before) = curve.iter().rposition(|point| (point.1 - middle) * (last - first) < 0.0) else {
        return f64::NAN;
    };
    let Some((&(t, c), &(u, d))) = curve.get(before).zip(curve.get(before + 1)) else { return f64::NAN };
    t + (u - t) * (middle - c) / (d - c)
}

/// Which necks, branches and forces decide.
///
/// # Errors
///
/// If a run halts or fails, or is interrupted.
pub(super) fn chapter(setting: &Setting) -> Result<Evidence, Error> {
    let kinds = kinds();
    // The full protocol: more aggregates, with necks of set P.
    let (aggregates, keys) = setting.extent.of((4, COARSE), (20, &[]));
    let protocol = Protocol { aggregates, keys: &[keys, &OUTPUT].concat() };
    let setting = Setting { runs: setting.runs.join("pathway"), ..*setting };
    let runs = setting.run_all(&points(&protocol, &kinds, setting.read)?)?;
    let read = |folder: &Option<RunFolder>| folder.as_ref().map(|folder| Member::read(folder, setting.interrupt));
    let members = runs.folders.iter().map(|folder| read(folder).transpose()).collect::<Result<Vec<_>, Error>>()?;
    let whole: Vec<&[Option<Member>]> =
        members.chunks(kinds.len()).filter(|kinds| kinds.iter().all(Option::is_some)).collect();
    if whole.len() < 2 {
        return Err(Error::Stopped(None));
    }
    let found = Found((0..kinds.len()).map(|k| whole.iter().filter_map(|kinds| kinds[k].as_ref()).collect()).collect());
    let note = setting.extent.of(
        "4 aggregates of each kind, with necks of set S at 40 fs instead of set P at 5 fs".to_string(),
        format!("{} of 20 aggregates of each kind have finished", whole.len()),
    );
    Ok(Evidence { note, claims: found.claims(), figures: vec![found.figure()] })
}

/// The members of each kind, in the same order of aggregates.
struct Found<'a>(Vec<Vec<&'a Member>>);

impl Found<'_> {
    fn mean(&self, kind: usize, of: impl Fn(&Member) -> f64) -> Mean {
        let values: Vec<f64> = self.0[kind].iter().map(|member| of(member)).filter(|value| value.is_finite()).collect();
        Mean::of(&values)
    }

    /// The mean of what a member has relative to the same aggregate without necks.
    fn relative(&self, kind: usize, of: impl Fn(&Member) -> f64) -> Mean {
        let ratios = self.0[kind].iter().zip(&self.0[0]).map(|(member, loose)| of(member) / of(loose));
        Mean::of(&ratios.collect::<Vec<_>>())
    }

    fn claims(&self) -> Vec<Claim> {
        let mut claims = vec![self.length()];
        claims.extend([0, 1].map(|kind| self.order(kind)));
        claims.extend([ONE, TWO].map(|kind| {
            let (broken, _) = BROKEN[kind];
            self.major(kind, &format!("{broken} of {NECKS} broken"))
        }));
        let deciding = DECIDING.iter().enumerate();
        claims.extend(deciding.map(|(k, (what, _))| self.major(BROKEN.len() + k, &format!("2 broken, and {what}"))));
        claims.push(self.time());
        claims
    }

    fn length(&self) -> Claim {
        let lengths: Vec<Mean> = (0..ONE).map(|kind| self.mean(kind, |member| member.length(|_| true))).collect();
        let [least, most] = [lengths[0], lengths[TWO]];
        let broken: Vec<String> = BROKEN[..ONE].iter().map(|(broken, _)| broken.to_string()).collect();
        Claim::new(
            "Section 4",
            format!(
                "local compaction with few necks, global with many: contacts along the aggregate between spheres that newly touch, on average, \
                 with {} of {NECKS} necks broken; the last interval lies above the first",
                broken.join(", ")
            ),
            "increases",
            listed(&lengths, 1),
            least.value + least.margin < most.value - most.margin,
        )
    }

    /// Whether branches collapse in the order of their lengths.
    fn order(&self, kind: usize) -> Claim {
        let longer = self.mean(kind, Member::later_less_earlier);
        Claim::new(
            "Section 3.2",
            format!(
                "the shortest branches collapse first: contacts along the aggregate between spheres that newly touch, the later half of them less \
                 the earlier, with {} of {NECKS} necks broken",
                BROKEN[kind].0
            ),
            "above 0",
            format!("{longer:.1}"),
            longer.value - longer.margin > 0.0,
        )
    }

    fn major(&self, kind: usize, what: &str) -> Claim {
        let relative = self.relative(kind, Member::shrunk);
        let percent = |of: &dyn Fn(&Member) -> f64| {
            let Mean { value, margin } = self.mean(kind, of);
            format!("{:.1} ± {:.1} %", 100.0 * value, 100.0 * margin)
        };
        let risen = |k: usize| move |member: &Member| member.shape[k][1] / member.shape[k][0] - 1.0;
        Claim::new(
            "Section 4",
            format!(
                "major restructuring, {what}: the radius of gyration decreases by at least half as much as without necks"
            ),
            "major with one or two necks broken",
            format!(
                "{relative:.2} of that without necks: radius of gyration -{}, coordination number +{}, convexity +{}",
                percent(&Member::shrunk),
                percent(&risen(0)),
                percent(&risen(1))
            ),
            relative.value - relative.margin >= MAJOR,
        )
    }

    fn time(&self) -> Claim {
        let first = BROKEN.len() + DECIDING.len();
        // Of the same aggregate: the change of the logarithm of the time for a factor of four.
        let ratios = |one: usize, other: usize, power: f64| {
            let ratio = |(a, b): (&&Member, &&Member)| libm::log(a.half / b.half) * power;
            Mean::of(&self.0[one].iter().zip(&self.0[other]).map(ratio).collect::<Vec<_>>())
        };
        let force = ratios(first, first + 1, libm::log(4.0) / libm::log(FORCES));
        let others = [first + 2, first + 3].map(|kind| ratios(kind, 0, 1.0));
        let least = force.value.abs() - force.margin;
        let most = others.iter().map(|change| change.value.abs() + change.margin).fold(0.0, f64::max);
        let factor =
            |Mean { value, margin }: Mean| format!("{:.2} ± {:.2}", libm::exp(value), libm::exp(value) * margin);
        Claim::new(
            "Section 3.2",
            "the time scale depends mostly on the driving force: a quarter of the capillary force changes the time to half of the increase in the coordination number, without necks, more than four times the Hamaker constant or a quarter of the friction do",
            "mostly",
            format!(
                "times {} by the force, a power of {:.2} ± {:.2}; {} by the Hamaker constant, {} by the friction; {} ns",
                factor(force),
                -force.value / libm::log(4.0),
                force.margin / libm::log(4.0),
                factor(others[0]),
                factor(others[1]),
                self.mean(0, |member| member.half)
            ),
            least > most,
        )
    }

    fn figure(&self) -> Figure {
        let curve = |label: &str, of: &dyn Fn(&Member) -> f64| {
            let points: Vec<(f64, f64, f64)> = BROKEN
                .iter()
                .enumerate()
                .map(|(kind, &(broken, _))| (f64::from(broken), self.relative(kind, of)))
                .map(|(broken, mean)| (broken, mean.value, mean.margin))
                .collect();
            let line = points.iter().map(|&(x, y, _)| (x, y)).collect();
            [Curve::band(&points), Curve::new(label, Mark::Dots, line)]
        };
        let risen = |k: usize| move |member: &Member| member.shape[k][1] - member.shape[k][0];
        let curves = [
            curve("decrease of the radius of gyration", &Member::shrunk),
            curve("increase of the coordination number", &risen(0)),
            curve("increase of the convexity", &risen(1)),
        ];
        let caption = "compaction relative to that without necks, against the number of broken necks".to_string();
        let (x, y) = (Axis::log("broken necks"), Axis::linear("relative to no necks"));
        let plot = Plot { title: caption.clone(), x, y, curves: curves.into_iter().flatten().collect() };
        let caption = format!("{caption}; shaded: 95 % confidence interval of the mean");
        Figure { name: "soot-broken-necks".into(), caption, svg: plot.svg() }
    }
}

fn listed(means: &[Mean], digits: usize) -> String {
    means.iter().map(|mean| format!("{mean:.digits$}")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kept_fractions_leave_that_many_necks_broken() {
        for (broken, fraction) in BROKEN {
            let kept = (f64::from(NECKS) * fraction.parse::<f64>().expect("a number")).floor();
            assert_eq!(f64::from(NECKS) - kept, f64::from(broken));
        }
    }

    #[test]
    fn half_of_an_increase_is_reached_when_it_stays() {
        let curve = [(0.0, 1.0), (1.0, 2.5), (2.0, 1.5), (3.0, 2.5), (4.0, 3.0)];
        assert!((half(&curve) - 2.5).abs() < 1e-12);
        assert!(half(&[(0.0, 1.0), (1.0, 1.0)]).is_nan());
    }

    #[test]
    fn later_closures_are_compared_with_earlier_ones() {
        let closure = |contacts, time| Closure { contacts, time };
        let closures = vec![closure(2.0, 1.0), closure(4.0, 1.0), closure(9.0, 2.0), closure(5.0, 3.0)];
        let member = Member { shape: [[1.0, 2.0]; 3], half: 1.0, closures };
        assert_eq!(member.later_less_earlier(), 4.0);
        assert_eq!(member.length(|_| true), 5.0);
    }
}
