//! Fig. 3 of the titania paper: two particles approach their equilibrium.

use super::{SIZES, paper, plan};
use crate::case::quantity::{Scaled, quantity};
use crate::error::Error;
use crate::figures::{Curve, Mark};
use crate::interrupt::Interrupt;
use crate::papers::titania::case::Approach;
use crate::papers::titania::stage::Stage;
use crate::papers::titania::study::Plan;
use crate::reproduce::{Claim, Evidence, Figure, near};
use crate::run::{self, Driver, Each};
use crate::spec::mechanics::reduced_mass::effective_mass;
use crate::spec::titania::def_relaxation::relaxation;
use crate::system::System;
use std::f64::consts::PI;
use std::ops::ControlFlow;

const DT: f64 = 1e-4;
/// Amplitudes of small oscillations, nm: at most an eighth of the overlap at equilibrium.
const SMALL: std::ops::Range<f64> = 1e-4..2e-2;
/// Contact stiffness (caption of Fig. 6, GPa) and attraction at equilibrium (nN, calculated independently) of either size.
const STATED: [(f64, f64); 2] = [(24.5, 1.8), (33.7, 3.6)];

fn apart(system: &System) -> f64 {
    (system.particles.x[0] - system.particles.x[1]).norm()
}

/// A release of two particles.
struct Release {
    /// Distances from the equilibrium in every step, nm.
    course: Vec<f64>,
    /// Time after which it is below 5 pm for good, ns.
    settled: f64,
}

impl Release {
    fn run(d: f64, factor: f64, interrupt: &Interrupt) -> Result<Self, Error> {
        let test = Approach { from: quantity("0.5 nm"), duration: Scaled::times(50_000.0) };
        let mut titania = paper();
        titania.damping_constant.value *= factor;
        let plan = plan(&titania, DT, vec![Stage::approach(&test, [d; 2], DT)]);
        let mut course = vec![0.5];
        let mut see = Each(|stage: &mut run::RunningStage<'_, Plan>, _: &run::Step| {
            course.push(apart(stage.simulation.system()) - d);
            ControlFlow::Continue(())
        });
        Driver::new(&plan, interrupt).run(&mut see)?;
        let settled = course.iter().rposition(|x| x.abs() > 5e-3).map_or(0.0, |step| step as f64 * DT);
        Ok(Self { course, settled })
    }

    /// Period (ps) and damping ratio of the small oscillations, from the times and the decrement of their extrema.
    fn oscillation(&self) -> (f64, f64) {
        let rest = self.course[self.course.len() - 1];
        let extreme = |k: usize| {
            let [before, here, after] = [k - 1, k, k + 1].map(|k| self.course[k]);
            (here - before) * (after - here) < 0.0
        };
        let small: Vec<(f64, f64)> = (1..self.course.len() - 1)
            .filter(|&k| extreme(k))
            .map(|k| (k as f64 * DT * 1e3, (self.course[k] - rest).abs()))
            .filter(|(_, amplitude)| SMALL.contains(amplitude))
            .collect();
        let (Some(first), Some(last)) = (small.first(), small.last()) else { return (f64::NAN, f64::NAN) };
        let halves = (small.len() - 1) as f64;
        let decrement = libm::log(first.1 / last.1) / halves;
        (2.0 * (last.0 - first.0) / halves, decrement / libm::hypot(PI, decrement))
    }
}

/// Damping coefficient (pN s/m) of two particles of a nominal diameter whose oscillations have this period (ps) and damping ratio.
fn coefficient(d: f64, period: f64, ratio: f64) -> f64 {
    let (_, mass) = paper().particle(d);
    let rate = 2.0 * PI / (period * 1e-3) * ratio / f64::sqrt(1.0 - ratio * ratio);
    2.0 * effective_mass(mass, mass) * rate
}

/// Oscillations about the equilibrium, with the damping constant of the paper and with that of the authors' program.
pub(super) fn approach(chapter: &mut Evidence, interrupt: &Interrupt) -> Result<(), Error> {
    let mut curves = Vec::new();
    for (factor, who) in [(1.0, "paper"), (10.0, "authors' program")] {
        for (d, (k_n, pull)) in SIZES.into_iter().zip(STATED) {
            let release = Release::run(d, factor, interrupt)?;
            let (least, end) =
                (release.course.iter().copied().fold(0.0, f64::min), release.course[release.course.len() - 1]);
            chapter.claims.push(Claim::new(
                "Fig. 3",
                format!("two particles of {d} nm released 0.5 nm from equilibrium oscillate about it and settle; damping constant of the {who}"),
                "quickly, by a damped oscillation; times in the figure only",
                format!(
                    "smallest distance {:.3} nm below equilibrium, within 5 pm of it after {:.2} ns, final deviation {:.1e} nm",
                    -least,
                    release.settled,
                    end.abs()
                ),
                least < 0.0 && end.abs() < 1e-3,
            ));
            let r = 0.5 * d;
            let (.., stated_gamma, omega_0, _, _) =
                relaxation(k_n * 1e9, r * 1e-9, r * 1e-9, 0.36e-9, pull * 1e-9, 4230.0, 0.5e6);
            let (stated, (period, ratio)) = (2e12 * PI / omega_0, release.oscillation());
            let gamma = coefficient(d, period, ratio);
            chapter.claims.push(Claim::new(
                "Eq. 7",
                format!("damping coefficient by the decay of their small oscillations, within 25 %; damping constant of the {who}"),
                format!("{:.1} pN s/m", stated_gamma * 1e12),
                format!("{gamma:.1} pN s/m; damping ratio {ratio:.4}"),
                near(gamma, stated_gamma * 1e12, 0.25),
            ));
            if factor == 1.0 {
                chapter.claims.push(Claim::new(
                    "Fig. 3",
                    "period of their small oscillations, within 10 %",
                    format!("{stated:.1} ps, linearised with {k_n} GPa"),
                    format!("{period:.1} ps"),
                    near(period, stated, 0.1),
                ));
            }
            let shown = release.course.iter().enumerate().step_by(20).take(300);
            let points = shown.map(|(step, x)| (step as f64 * DT * 1e3, *x)).collect();
            curves.push(Curve::new(format!("{d} nm, {who}"), Mark::Line, points));
        }
    }
    let caption = "Fig. 3: two particles released 0.5 nm from equilibrium";
    chapter.figures.push(Figure::linear("approach", caption, ["time [ps]", "distance from equilibrium [nm]"], curves));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn period_and_damping_ratio_of_a_damped_oscillation_are_found() {
        for zeta in [0.0376, 0.38] {
            let omega = 2.0 * PI / 40.0 / f64::sqrt(1.0 - zeta * zeta);
            let at = |k: i32| {
                let t = f64::from(k) * DT * 1e3;
                0.5 * libm::exp(-zeta * omega * t) * libm::cos(2.0 * PI / 40.0 * t)
            };
            let (period, ratio) = Release { course: (0..50_000).map(at).collect(), settled: 0.0 }.oscillation();
            assert!(near(period, 40.0, 1e-2) && near(ratio, zeta, 1e-2), "{period} {ratio}");
        }
    }
}
