//! Section 2.4 of the titania paper: shear strengths by the paper's own fit, and the power with which friction grows.

use super::super::{SIZES, SLAB, paper};
use crate::reproduce::{Claim, log_slope, near};
use crate::spec::titania::def_relaxation::relaxation;
use crate::spec::titania::eq11_contact_area::contact_area;

/// Contact stiffness with which the paper fits the forces on either size (caption of Fig. 6), GPa.
const STIFFNESS: [f64; 2] = [24.5, 33.7];
/// The results of its fits for spheres, GPa.
const SLIDING: [f64; 2] = [0.76, 0.57];
const ROLLING: [f64; 2] = [0.23, 0.13];
/// The same for a polyhedral particle with a nominal radius of 8 nm, GPa.
const POLYHEDRON: f64 = 0.23;

/// The claims, from the repulsion and the friction force (pN) of either size under all loads.
pub(super) fn claims(sliding: [Vec<(f64, f64)>; 2], rolling: [Vec<(f64, f64)>; 2]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (what, forces, stated) in [("sliding", &sliding, SLIDING), ("rolling", &rolling, ROLLING)] {
        for k in 0..SIZES.len() {
            let fit = strength(SIZES[k], STIFFNESS[k], &forces[k]);
            claims.push(Claim::new(
                "Section 2.4",
                format!(
                    "shear strength of {what}, fitted as in the paper to our forces on a particle with a nominal radius of {} nm, within 20 %",
                    0.5 * SIZES[k]
                ),
                format!("{} GPa, from molecular dynamics", stated[k]),
                format!("{fit:.3} GPa"),
                near(fit, stated[k], 0.2),
            ));
        }
    }
    let sphere = strength(SIZES[1], STIFFNESS[1], &rolling[1]);
    claims.push(Claim::new(
        "Section 2.4",
        "shear strength of rolling of a polyhedron of 32 edges, beside that of a sphere of the same size, within 20 %",
        format!("{POLYHEDRON} GPa, from molecular dynamics"),
        format!("{sphere:.3} GPa; the law has spheres only"),
        near(sphere, POLYHEDRON, 0.2),
    ));
    let powers = sliding.each_ref().map(|forces| log_slope(forces));
    claims.push(Claim::new(
        "Fig. 6",
        "power of the repulsion with which the peak friction grows, for either size: within 0.03 of 2/3",
        "linear in the contact area, Eqs. 8, 10 and 11: 2/3",
        format!("{:.3}, {:.3}", powers[0], powers[1]),
        powers.iter().all(|power| (power - 2.0 / 3.0).abs() < 0.03),
    ));
    claims
}

/// The strength (GPa) for which strength times area fits the forces best, if Eq. 8 with this stiffness gives the overlap with the slab.
fn strength(d: f64, k_n: f64, forces: &[(f64, f64)]) -> f64 {
    let (titania, r, slab) = (paper(), 0.5 * d, 0.5 * SLAB);
    let h_n = titania.layer.value;
    let area = |repulsion: f64| {
        let (overlap, ..) = relaxation(k_n, r, slab, h_n, repulsion * 1e-3, titania.density.value, 1.0);
        contact_area(r, slab, h_n, r + slab + 2.0 * h_n - overlap).0
    };
    let sum =
        |of: &dyn Fn(f64, f64) -> f64| forces.iter().map(|&(repulsion, force)| of(area(repulsion), force)).sum::<f64>();
    sum(&|area, force| area * force * 1e-3) / sum(&|area, _| area * area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::titania::eq08_repulsion::repulsion;

    #[test]
    fn the_strength_behind_the_forces_is_found() {
        let (k_n, h_n) = (24.5, paper().layer.value);
        let forces = [0.1, 0.2, 0.3].map(|overlap| {
            let (_, repulsion, ..) = repulsion(k_n, overlap, 4.0, 0.5 * SLAB, h_n);
            let area = contact_area(4.0, 0.5 * SLAB, h_n, 4.0 + 0.5 * SLAB + 2.0 * h_n - overlap).0;
            (1e3 * repulsion, 650.0 * area)
        });
        assert!(near(strength(8.0, k_n, &forces), 0.65, 1e-9));
    }
}
