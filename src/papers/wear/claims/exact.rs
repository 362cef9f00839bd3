//! Claims that follow from the equations alone.

use crate::initial::packing::FILL;
use crate::reproduce::{Claim, Evidence, near};
use crate::spec::mechanics::solids::sphere_volume;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::mechanics::truncated_lognormal::truncated_moments;
use crate::spec::wear::eq06_critical_time_step::critical_time_step;
use crate::spec::wear::eq07_normal_stiffness::normal_stiffness;
use crate::spec::wear::eq15_normal_cross_section::normal_cross_section;
use crate::spec::wear::eq16_tangential_cross_section::tangential_cross_section;
use crate::spec::wear::eq18_critical_diameter::critical_diameter;
use crate::spec::wear::eq19_minimum_diameter::minimum_diameter;
use crate::spec::wear::eq22_critical_length::{critical_length, shear_modulus, wave_velocity};

/// Atoms in 100 000 nm^3 of silica and their time step, fs (Table 6).
const ATOMS: (f64, f64) = (7.8e6, 1.0);
/// Duration of 10 ns of them by molecular dynamics, d, and of 10 ns of the spheres of each d_0, s (Table 6).
const DURATIONS: (f64, [f64; 3]) = (530.0, [240.0, 120.0, 25.0]);
/// Bond lengths of silica: Si-O, O-O, Si-Si (Section 4), nm.
const BONDS: [f64; 3] = [0.16, 0.26, 0.31];

/// Expected number of spheres in 100 000 nm^3.
fn number(d_0: f64) -> f64 {
    let (.., cubes) = truncated_moments(d_0, 0.75 * d_0, 7.5);
    FILL * 1e5 / (cubes * sphere_volume(0.5))
}

/// A tenth of the critical time step of the smallest sphere, fs.
fn step_of_smallest(d_0: f64) -> f64 {
    let r = 0.375 * d_0 * 1e-9;
    let k_n = normal_stiffness(normal_cross_section(r, 0.17), 73e9, r, r);
    0.1 * critical_time_step(sphere_mass(2200.0, r), k_n) * 1e15
}

/// Section 5: the cost compared with molecular dynamics, by the steps of particles that either needs.
fn speed_up(costs: &[f64]) -> Claim {
    let (atoms, spheres) = DURATIONS;
    let stated = spheres.map(|seconds| format!("{:.1e}", atoms * 86400.0 / seconds)).join(", ");
    let found = costs.iter().map(|cost| format!("{cost:.1e}")).collect::<Vec<_>>().join(", ");
    Claim::new(
        "Section 5",
        "computational cost relative to molecular dynamics, by number and time steps of the particles, d_0 = 1.5, 3 and 6 nm",
        format!("at least 5 orders of magnitude less; by the durations of Table 6 {stated}"),
        found,
        costs.iter().all(|cost| *cost >= 1e5),
    )
}

/// Sections 4 and 5: the spheres compared with atoms.
fn size_of_atoms() -> Claim {
    let ratios = BONDS.map(|bond| 1.5 / bond);
    Claim::new(
        "Section 4",
        "spheres of d_0 = 1.5 nm relative to the bond lengths Si-O, O-O and Si-Si of 0.16, 0.26 and 0.31 nm",
        "at least 10",
        ratios.map(|ratio| format!("{ratio:.1}")).join(", "),
        ratios.iter().all(|ratio| *ratio >= 10.0),
    )
}

/// Lengths, velocities and limits of Sections 3 and 4, and the counts and time steps of Table 6.
pub fn chapter() -> Evidence {
    let silica = [73e9, 16e9, 9e9, 1.5];
    let [e, sigma_n, sigma_t, gamma] = silica;
    let g = shear_modulus(e, 0.17);
    let exact = [
        Claim::number("Eq. 19, Table 4", "d_min", "30", minimum_diameter(1.5, 0.2), "", 9.0),
        Claim::number("Eq. 18, Table 4", "d_c", "150", critical_diameter(1.5, 1.0, 0.2), "", 9.0),
        Claim::number("Eq. 19, silica", "d_min", "0.37", minimum_diameter(gamma, sigma_n) * 1e9, "nm", 2.0),
        Claim::number("Eq. 18, silica", "d_c", "1.7", critical_diameter(gamma, e, sigma_n) * 1e9, "nm", 1.0),
        Claim::number("Eq. 22, silica", "d*", "18", critical_length(gamma, g, sigma_t) * 1e9, "nm", 0.0),
        Claim::number("Section 4, silica", "wave velocity", "5760", wave_velocity(e, 2200.0), "m/s", 0.0),
        Claim::new(
            "Eq. 16",
            "nu is at most 1/4: there the tangential stiffness vanishes, above it is negative",
            "limit 1/4",
            format!(
                "A_T(0.25) = {:e}, A_T(0.26) < 0: {}",
                tangential_cross_section(1.0, 0.25),
                tangential_cross_section(1.0, 0.26) < 0.0
            ),
            tangential_cross_section(1.0, 0.25) == 0.0 && tangential_cross_section(1.0, 0.26) < 0.0,
        ),
    ];
    let mut claims: Vec<Claim> = exact.into_iter().map(Claim::exact).collect();
    // Table 6 depends on samples and choices, not on the equations alone.
    let mut costs = Vec::new();
    for (d_0, count, step) in [(1.5, 6000.0, 20.0), (3.0, 2600.0, 40.0), (6.0, 600.0, 80.0)] {
        let spheres = number(d_0);
        claims.push(Claim::new(
            "Table 6",
            format!("spheres in 100 000 nm^3 at d_0 = {d_0} nm, within 10 %"),
            format!("{count}"),
            format!("{spheres:.0}"),
            near(spheres, count, 0.1),
        ));
        let dt = step_of_smallest(d_0);
        claims.push(Claim::new(
            "Table 6",
            format!("0.1 dt_c of the smallest sphere at d_0 = {d_0} nm, within 10 %"),
            format!("{step} fs"),
            format!("{dt:.1} fs"),
            near(dt, step, 0.1),
        ));
        costs.push(ATOMS.0 / ATOMS.1 / (spheres / dt));
    }
    claims.extend([speed_up(&costs), size_of_atoms()]);
    Evidence { claims, ..Evidence::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::Verdict;

    #[test]
    fn every_claim_names_its_place_in_the_paper() {
        let named = |claim: &Claim| ["Eq. ", "Section ", "Table "].iter().any(|place| claim.id.starts_with(place));
        assert!(chapter().claims.iter().all(named));
    }

    #[test]
    fn every_length_and_limit_of_the_paper_follows_from_its_equations() {
        for claim in chapter().claims.iter().filter(|claim| claim.exact) {
            assert_eq!(claim.verdict, Verdict::Holds, "{claim:?}");
        }
    }
}
