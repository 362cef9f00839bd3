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
    for (d_0, count, step) in [(1.5, 6000.0, 20.0), (3.0, 2600.0, 40.0), (6.0, 600.0, 80.0)] {
        let (.., cubes) = truncated_moments(d_0, 0.75 * d_0, 7.5);
        let spheres = FILL * 1e5 / (cubes * sphere_volume(0.5));
        claims.push(Claim::new(
            "Table 6",
            format!("spheres in 100 000 nm^3 at d_0 = {d_0} nm, within 10 %"),
            format!("{count}"),
            format!("{spheres:.0}"),
            near(spheres, count, 0.1),
        ));
        let r = 0.375 * d_0 * 1e-9;
        let k_n = normal_stiffness(normal_cross_section(r, 0.17), e, r, r);
        let dt = 0.1 * critical_time_step(sphere_mass(2200.0, r), k_n) * 1e15;
        claims.push(Claim::new(
            "Table 6",
            format!("0.1 dt_c of the smallest sphere at d_0 = {d_0} nm, within 10 %"),
            format!("{step} fs"),
            format!("{dt:.1} fs"),
            near(dt, step, 0.1),
        ));
    }
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
        for claim in chapter().claims.iter().filter(|claim| claim.id != "Table 6") {
            assert_eq!(claim.verdict, Verdict::Holds, "{claim:?}");
        }
    }
}
