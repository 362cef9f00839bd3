//! Claims of the titania paper that follow from its equations and parameters alone.

use super::paper;
use crate::case::section::defaults;
use crate::papers::titania::case::{Spectroscopy, Stretching};
use crate::reproduce::{Claim, Evidence};
use crate::spec::mechanics::drive::{drag, tip};
use crate::spec::titania::def_radius::effective_radius;
use crate::spec::titania::def_rayleigh::rayleigh_time;
use crate::spec::titania::def_water::water_layer;
use crate::spec::titania::eq04_solvation::solvation_force;
use crate::spec::titania::eq05_amplitude::amplitude;
use crate::spec::titania::eq11_contact_area::contact_area;
use crate::spec::{Contact, PairModel, Vec3};

/// Thickness of the water layer that the paper states, with its error, nm.
const LAYER: (f64, f64) = (0.41, 0.03);
/// Density, shear modulus and Poisson's ratio of rutile, kg/m^3, Pa; the paper does not print them.
const RUTILE: (f64, f64, f64) = (4230.0, 111e9, 0.27);
/// Length of the systems to which the paper's rates refer, nm.
const LENGTH: f64 = 100.0;
/// Remark on claims for which the authors give the formula but no result.
const ALONE: &str = "calculated independently";

/// The test of a film with the published values.
fn film() -> Spectroscopy {
    serde_yaml::from_str("depth: 2 µm").expect("the other keys have defaults")
}

/// Water, solvation, damping, time step, rates and the motion of the tip.
pub(super) fn chapter() -> Evidence {
    let mut claims = water();
    claims.extend(solvation());
    claims.extend(friction());
    claims.extend([(4.0, "8.0"), (8.0, "32.0")].map(|(r, figure)| {
        let claim = format!("damping coefficient of particles with bare radii of {r} nm, {ALONE}");
        Claim::number("Eq. 7", claim, figure, damping(r), "pN s/m", 6.0).exact()
    }));
    claims.extend(time_step());
    claims.extend(rates());
    Evidence { claims, ..Evidence::default() }
}

/// Sections 2 and 2.3.
fn water() -> Vec<Claim> {
    let (titania, (layer, error)) = (paper(), LAYER);
    let found = water_layer(titania.humidity, 1.0);
    vec![
        Claim::new(
            "Section 2",
            "thickness of the water layer at half humidity, by the table of the authors' program",
            format!("{layer} ± {error} nm"),
            format!("{found:.3} nm"),
            (found - layer).abs() <= error,
        ),
        Claim::number(
            "Section 2.3",
            "thickness of the compressed layer relative to the stated one",
            "0.88",
            titania.layer.value / layer,
            "",
            2.0,
        )
        .exact(),
    ]
}

/// Eqs. 4 and 5: the amplitude, and period and decay of the force itself.
fn solvation() -> Vec<Claim> {
    let law = paper().law();
    let of = |r: f64| amplitude(effective_radius(r, r).0, law.f_00, law.f_01) * 1e-3;
    let force = |gap: f64| solvation_force(of(4.0), 8.0 + gap, 4.0, 4.0, law.sigma);
    // A maximum of the amplitude's cosine and the next one differ by the decay over one period.
    let decay = libm::log(force(0.0) / force(law.sigma)) / law.sigma;
    let claim = |r: f64| format!("amplitude of the solvation force of particles with bare radii of {r} nm, {ALONE}");
    let decays = Claim::number("Table 1", "decay length of the solvation force", "0.21", 1.0 / decay, "nm", 2.0);
    let amplitudes = [(4.0, "-20.6"), (8.0, "-30.2")]
        .map(|(r, figure)| Claim::number("Eq. 5", claim(r), figure, of(r), "nN", 6.0).exact());
    amplitudes.into_iter().chain([decays.exact()]).collect()
}

/// Table 1: the constants of friction, found from the forces of two particles with bare radii of 4 nm that are pressed together by 0.1 nm.
fn friction() -> Vec<Claim> {
    let (titania, none) = (paper(), Vec3::zero());
    let (law, (r, m)) = (titania.law(), titania.particle(8.0 + titania.core_gap.value));
    let (constants, distance) = (law.coefficients(r, r, m, m), law.equilibrium(r, r) - 0.1);
    let act = |spring: f64, spin: f64| {
        let turning = Vec3::new(0.0, 0.0, spin);
        let contact = Contact::new(Vec3::new(distance, 0.0, 0.0), none, turning, -turning, r, r);
        law.pair(&contact, &constants, Vec3::new(0.0, spring, 0.0), 1e-4)
    };
    let (area, _) = contact_area(4.0, 4.0, titania.layer.value, distance);
    // The longest spring that is left as it was.
    let (mut held, mut slipped) = (0.1, 0.9);
    while slipped - held > 1e-9 {
        let middle = 0.5 * (held + slipped);
        if act(middle, 0.0).memory.norm() < middle { slipped = middle } else { held = middle }
    }
    let peak = act(held, 0.0).wrench.force.0[1].abs();
    // So fast that the torque could not stop the particles within the step.
    let torque = act(0.0, 1e9).wrench.torque_i.norm();
    let rolling = torque / (effective_radius(r, r).1 * area);
    let number = |claim: &str, figure: &str, value: f64, unit: &str| {
        Claim::number("Table 1", format!("{claim}, from the forces of two particles"), figure, value, unit, 4.0).exact()
    };
    vec![
        number("period of stick and slip", "0.50", held, "nm"),
        number("shear strength of sliding", "0.65", peak / area * 1e-3, "GPa"),
        number("shear strength of rolling", "0.25", rolling * 1e-3, "GPa"),
    ]
}

/// Damping coefficient of two equal particles of a bare radius (nm), pN s/m.
fn damping(r: f64) -> f64 {
    let titania = paper();
    let (r, m) = titania.particle(2.0 * r + titania.core_gap.value);
    titania.law().parameters(r, r, m, m).gamma_n
}

/// Section 2.5: the Rayleigh time of the smallest particles, of which the time step is half.
fn time_step() -> Vec<Claim> {
    let (titania, (rho, g, nu)) = (paper(), RUTILE);
    let test = film();
    let rayleigh = rayleigh_time(1.5e-9, rho, g, nu) * 1e12;
    let (r, m) = titania.particle(3.0);
    let limit = titania.law().critical_time_step(r, m) * 1e3;
    let dt = test.dt.value * 1e3;
    vec![
        Claim::number("Section 2.5", "Rayleigh time of rutile particles of 3 nm", "1.00", rayleigh, "ps", 2.0).exact(),
        Claim::new(
            "Section 2.5",
            "half the Rayleigh time is a safe time step: at most half the limit of small oscillations of free particles of 3 nm",
            "0.5 ps",
            format!("{dt} ps; limit {limit:.2} ps"),
            dt <= 0.5 * limit,
        ),
    ]
}

/// Sections 3.1, 3.2, 4.1 and 5.4: rates, drag, and the motion of the tip.
fn rates() -> Vec<Claim> {
    let (stretching, spectroscopy) = (defaults::<Stretching>(), film());
    let (speed, turn) = (spectroscopy.speed.value, spectroscopy.reversal.value);
    let pull = |coefficient: f64| -drag(coefficient, Vec3::new(1.0, 0.0, 0.0)).0[0];
    let deepest = tip(speed, turn, 0.5 * turn).1;
    let (after, _) = tip(speed, turn, turn);
    let (before, _) = tip(speed, turn, 0.0);
    let window = spectroscopy.average.value;
    let way = tip(speed, turn, turn + window).1 - tip(speed, turn, turn).1;
    let rate = |id: &'static str, name: &str, velocity: f64, figure: &str| {
        let claim = format!("{name}: velocity over a length of {LENGTH} nm");
        Claim::number(id, claim, figure, velocity / LENGTH * 1e3, "1/µs", 6.0)
    };
    let claims = [
        rate("Section 3.1", "strain rate of the agglomerate, 5e7/s", stretching.velocity.value, "50"),
        rate("Section 4.1", "loading rate of the film, 5e6/s", speed, "5"),
        Claim::number(
            "Section 5.4",
            "drag on a particle of a relaxing film at 1 m/s",
            "10",
            pull(spectroscopy.drag.value),
            "pN",
            6.0,
        ),
        Claim::number(
            "Section 5.4",
            "the same in a relaxing agglomerate",
            "10",
            pull(stretching.drag.value),
            "pN",
            6.0,
        ),
        Claim::number("Section 5.4", "displacement of the tip while a force is averaged", "5", way, "nm", 6.0),
        Claim::new(
            "Section 5.4",
            "the tip moves at -0.5 m/s until its setpoint and at 0.5 m/s after 0.2 µs; it sinks in further in between",
            "-0.5 and 0.5 m/s",
            format!("{before} and {after} m/s, {:.1} nm further", -deepest),
            before == -0.5 && after == 0.5 && deepest < 0.0,
        ),
    ];
    claims.into_iter().map(Claim::exact).collect()
}
