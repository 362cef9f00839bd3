//! Claims that follow from the equations alone.

mod elements;

use crate::case::section::defaults;
use crate::geometry::{SphereExtent, gyration_radius};
use crate::initial::aggregate::necks::{NeckLength, necks};
use crate::initial::aggregate::{Method, Radii, Recipe, aggregate};
use crate::interrupt::Interrupt;
use crate::papers::soot::case::{NeckSet, Soot};
use crate::reproduce::{Claim, Evidence};
use crate::spec::PairModel;
use crate::spec::mechanics::oscillation::speed_of_fall;
use crate::spec::mechanics::primary_particle::solid_inertia;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::Along;
use crate::spec::soot::eq19_equal_hamaker::{equal_hamaker_energy, saturated_hamaker};
use crate::spec::soot::eq21_hamaker_plane::plane_energy;
use crate::spec::soot::eq24_fractal;
use crate::spec::soot::eq25_tip::tip_way;
use crate::spec::soot::eq26_coordination::coordination_number;

/// Radius of the spheres, nm.
const RADIUS: f64 = 14.0;
/// Density of soot, ag/nm^3.
const DENSITY: f64 = 1.7e-3;
/// Hamaker constant of two spheres, zJ; ten times as large for a sphere and the tip.
const HAMAKER: f64 = 100.0;
/// Gap of spheres that touch up to rounding, nm.
const TOUCH: f64 = 1e-6;
/// Remark on claims for which the authors give inputs but no result.
const ALONE: &str = "calculated independently";

/// Masses, sizes, displacements of the tip, falls, and time steps, in nm, ns, ag.
pub fn chapter() -> Evidence {
    let m = sphere_mass(DENSITY, RADIUS);
    let mut claims = vec![
        Claim::number("Section 2.1", format!("mass of a sphere, {ALONE}"), "19.5399", m, "ag", 4.0),
        Claim::number(
            "Section 2.1",
            format!("moment of inertia of a sphere, {ALONE}"),
            "1532",
            solid_inertia(m, RADIUS),
            "ag nm^2",
            0.0,
        ),
    ];
    claims.extend(grown());
    claims.extend(tip());
    claims.extend(attraction(m));
    claims.extend(NECKS.map(|(necks, step, name)| time_step(m, necks, step, name)));
    claims.extend(elements::claims());
    Evidence { claims: claims.into_iter().map(Claim::exact).collect(), ..Evidence::default() }
}

/// Section 3.2: the fractal law of the aggregates, and an aggregate grown by it.
fn grown() -> Vec<Claim> {
    let (number, k_f, d_f) = (150, 1.4, 1.8);
    let law = eq24_fractal::gyration_radius(k_f, number as f64, RADIUS, d_f);
    let recipe = Recipe { number, d_f, k_f, radii: Radii::Equal(RADIUS), method: Method::Clusters };
    let spheres = aggregate(&recipe, 1, &Interrupt::default()).expect("an ordinary aggregate");
    let radius = gyration_radius(&spheres, SphereExtent::Centres);
    let contacts = necks(&spheres, TOUCH, NeckLength::Touching, false, &Interrupt::default());
    let contacts = contacts.expect("nothing asks to stop").len();
    let claim = |what: &str| format!("{what}, {ALONE}");
    vec![
        Claim::number("Eq. 24", claim("R_g of 150 spheres"), "187.88", law, "nm", 2.0),
        Claim::number("Eq. 24", claim("R_g of a grown aggregate of 150 spheres"), "187.88", radius, "nm", 2.0),
        Claim::number(
            "Fig. 8a",
            claim("coordination number of that aggregate, whose contacts form a tree, near misses excluded"),
            "1.98667",
            coordination_number(2.0 * contacts as f64, number as f64),
            "",
            5.0,
        ),
    ]
}

/// Section 3.1.2: displacement of the tip, which starts half a radius above a sphere.
fn tip() -> Vec<Claim> {
    let way = |t: f64| tip_way(t, 1.5, 0.1, 10.8);
    let claim = |what: &str| format!("{what}, {ALONE}");
    vec![
        Claim::number("Eq. 25", claim("largest downward displacement of the tip"), "-7.440", way(10.8), "nm", 3.0),
        Claim::number("Eq. 25", claim("indentation depth"), "0.44", -way(10.8) - 0.5 * RADIUS, "nm", 2.0),
        Claim::number("Eq. 25", claim("displacement of the tip after 500 ns"), "715.96", way(500.0), "nm", 2.0),
    ]
}

/// Van der Waals attraction: the force at saturation, and the fall of a released sphere.
fn attraction(m: f64) -> Vec<Claim> {
    let claim = |what: &str| format!("{what}, {ALONE}");
    let spheres = |gap| equal_hamaker_energy(RADIUS, gap, HAMAKER);
    let tip = |gap| plane_energy(RADIUS, gap, 10.0 * HAMAKER);
    let (pull, _) = saturated_hamaker(RADIUS, RADIUS, 0.0, HAMAKER, 1.0);
    let (far, _) = fall(0.5 * m, 14.0, 1.0, spheres);
    let (near, speed) = fall(0.5 * m, 5.0, 1.0, spheres);
    let (to_the_tip, _) = fall(m, 7.0, 1.0, tip);
    vec![
        Claim::number(
            "Eq. 20",
            claim("attraction of two spheres at and below a gap of 1 nm"),
            "101.357",
            pull,
            "pN",
            3.0,
        ),
        Claim::number("Eq. 19", claim("fall of two spheres from a gap of 14 nm to 1 nm"), "34.3594", far, "ns", 4.0),
        Claim::number("Eq. 19", claim("fall of two spheres from a gap of 5 nm to 1 nm"), "4.60581", near, "ns", 5.0),
        Claim::number("Eq. 19", claim("relative velocity at the end of this fall"), "3.8210", speed, "m/s", 4.0),
        Claim::number("Eq. 21", claim("fall onto the tip from 7 nm to 1 nm"), "2.22949", to_the_tip, "ns", 5.0),
    ]
}

/// Number of intervals of the quadrature of a fall.
const INTERVALS: u32 = 20_000;

/// Duration and final velocity of a fall from rest at the gap `from` to the gap `to`, by conservation of energy.
fn fall(mass: f64, from: f64, to: f64, energy: impl Fn(f64) -> f64) -> (f64, f64) {
    let speed = |gap: f64| speed_of_fall(mass, energy(from), energy(gap));
    // The substitution of s^2 for the distance makes the integrand smooth, as the velocity is proportional to s at first.
    let ds = 1.0 / f64::from(INTERVALS);
    let duration = |k: u32| {
        let s = (f64::from(k) + 0.5) * ds;
        2.0 * (from - to) * s * ds / speed(from - (from - to) * s * s)
    };
    ((0..INTERVALS).map(duration).sum(), speed(to))
}

/// The published springs of a neck, the time step at which they are stable, and their name.
const NECKS: [(NeckSet, f64, &str); 2] = [(NeckSet::S, 50e-6, "S"), (NeckSet::P, 5e-6, "P")];

/// Section 3: the softer necks are stable at the longer of the published steps, the stiffer ones only at the shorter.
fn time_step(m: f64, necks: NeckSet, step: f64, name: &str) -> Claim {
    let limit = Soot { necks: Some(necks), ..defaults() }.law(Along).critical_time_step(RADIUS, m);
    Claim::new(
        "Section 3",
        format!("necks of set {name} are stable at {:.0} fs but not at ten times that", step * 1e6),
        format!("{:.0} fs", step * 1e6),
        format!("limit {:.1} fs", limit * 1e6),
        step < limit && 10.0 * step > limit,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::Verdict;

    #[test]
    fn everything_follows_from_the_equations() {
        let failed: Vec<_> = chapter().claims.into_iter().filter(|claim| claim.verdict == Verdict::Differs).collect();
        assert!(failed.is_empty(), "{failed:?}");
    }
}
