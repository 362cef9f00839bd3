//! Bonds that break by their energy.

use super::{NO_SPRINGS, UP, near, rough};
use veridem::spec::mechanics::four_springs::{Memory, Springs};
use veridem::spec::soot::{Coefficients, Strength};
use veridem::spec::wear::a31_fracture_energy::{separation_of_surface_energy, surface_energy, work_of_separation};
use veridem::spec::wear::def_contact::Parameters;
use veridem::spec::{Contact, PairModel, Vec3};

fn apart(gap: f64) -> Contact<f64> {
    Contact::new(UP * (2.0 + gap), Vec3::zero(), Vec3::zero(), Vec3::zero(), 1.0, 1.0)
}

/// exaDEM, `fragmentation/verification_test/traction`: two cubes with a face of 1 m² in common, joined at its four corners by springs of 1000 N/m, are pulled apart. It prints the displacements at which they part, cut off
/// after the second digit, and the work, which is summed in steps: 0.2 % are missing.
///
/// Equations: `wear-3`, `wear-A31`, `wear-A33`, `wear-A34`, `wear-contact`, `soot-spring-energy`.
#[test]
fn a_bond_breaks_by_its_energy_as_in_exa_dem() {
    let (k_n, area) = (4.0 * 1000.0f64, 1.0);
    for (gamma, parted, work) in [
        (5e-3, 0.0022, 0.01),
        (1e-2, 0.0031, 0.02),
        (2e-2, 0.0044, 0.04),
        (4e-2, 0.0063, 0.0799),
        (8e-2, 0.0089, 0.1597),
        (1e-1, 0.01, 0.1996),
    ] {
        // A spring that breaks where it is strongest: its strength follows from its length, and its length from the strength.
        let breaks = 2.0 * (gamma * area / k_n).sqrt();
        near(separation_of_surface_energy(gamma, k_n * breaks / area), breaks, 1e-14);
        let spent = work_of_separation(k_n, breaks, breaks);
        near(surface_energy(spent, area), gamma, 1e-14);
        near(spent, work, 2.5e-3);

        let law = Parameters { k_n, delta_e: breaks, delta_f: breaks, k_t: 0.0, f_mt: 0.0, c_n: 0.0, c_t: 0.0 };
        let pull = |gap: f64| -law.act(&apart(gap), Vec3::zero(), 0.0).wrench.force.0[2];
        near(pull(parted * (1.0 - 1e-9)), k_n * parted, 1e-8);
        assert_eq!(pull(parted + 1e-4), 0.0);

        // A neck that breaks when its springs hold this energy.
        let (necks, bonded) = (rough(Springs { k_n, ..NO_SPRINGS }, [0.0; 3]), Coefficients { bonded: 1.0 });
        let strength = Strength { energy: Some(2.0 * gamma * area), stress: None };
        let is_broken = |gap: f64| {
            let held = necks.stored(&apart(gap), &bonded, &Memory::zero());
            necks.neck_breaks(&apart(gap), &Memory::zero(), &held, &strength)
        };
        assert!(!is_broken(parted * (1.0 - 1e-9)) && is_broken(parted + 1e-4));
    }
}
