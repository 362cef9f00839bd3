//! Small oscillations about the equilibrium of a pair.

use super::def_radius::effective_radius;
use super::eq07_damping_coefficient::damping_coefficient;
use crate::equation::Equation;
use crate::mechanics::reduced_mass::effective_mass;
use crate::mechanics::sphere::sphere_mass;
use crate::{Real, equation};

/// **Section 2.2**, unnumbered: equilibrium under a constant attraction, linearised.
///
/// ```math
/// \delta_0 = \left(\frac{F_a}{k_n \sqrt{R_\text{eff}}}\right)^{2/3}, \quad k = \frac{3 F_a}{2 \delta_0}, \quad
/// \omega_0 = \sqrt{\frac{k}{m_\text{eff}}}, \quad \zeta = \frac{\gamma_n}{2 \sqrt{k \, m_\text{eff}}}
/// ```
///
/// # Reading
///
/// The motion shown in Fig. 3, for small displacements and an attraction independent of the distance. The masses are those of the bare spheres. The
/// power is evaluated for a dimensionless number, $\delta_0 = R_\text{eff} \exp\left(\frac{2}{3} \ln \frac{F_a}{k_n R_\text{eff}^2}\right)$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_n$ | Pa | > 0 | contact stiffness |
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | `f_a` | $F_a$ | N | > 0 | constant attraction |
/// | `rho` | $\rho$ | kg/m^3 | > 0 | density |
/// | `gamma_0` | $\gamma_0$ | N s/m^3 | > 0 | damping constant of Eq. 7 |
/// | → `delta_0` | $\delta_0$ | m | | overlap at equilibrium |
/// | → `k_lin` | $k$ | N/m | | stiffness there |
/// | → `m_eff` | $m_\text{eff}$ | kg | | effective mass |
/// | → `gamma_n` | $\gamma_n$ | kg/s | | damping coefficient |
/// | → `omega_0` | $\omega_0$ | rad/s | | natural frequency |
/// | → `zeta` | $\zeta$ | 1 | | damping ratio |
/// | → `tau` | $\tau$ | s | | time in which the amplitude decays by a factor of e |
///
/// Rounding: at most 5 ULP.
///
/// # Laws
///
/// * `repulsion_balances_the_attraction_with_that_stiffness`
/// * `both_sizes_of_the_figure_are_damped_alike_and_ten_times_more_by_the_program`
#[inline]
pub fn relaxation<R: Real>(k_n: R, r_i: R, r_j: R, h_n: R, f_a: R, rho: R, gamma_0: R) -> (R, R, R, R, R, R, R) {
    let r_eff = effective_radius(r_i + h_n, r_j + h_n).1;
    let delta_0 = r_eff * (R::lit(2.0) * (f_a / (k_n * r_eff.squared())).ln() / R::lit(3.0)).exp();
    let k_lin = R::lit(1.5) * f_a / delta_0;
    let m_eff = effective_mass(sphere_mass(rho, r_i), sphere_mass(rho, r_j));
    let gamma_n = damping_coefficient(effective_radius(r_i, r_j).0, gamma_0);
    let zeta = gamma_n / (R::lit(2.0) * (k_lin * m_eff).sqrt());
    (delta_0, k_lin, m_eff, gamma_n, (k_lin / m_eff).sqrt(), zeta, R::lit(2.0) * m_eff / gamma_n)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/def_relaxation.rs", "titania-relax-lin", [], relaxation)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::titania::eq07_damping_coefficient::GAMMA_0;
    use crate::titania::eq08_repulsion::repulsion;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn repulsion_balances_the_attraction_with_that_stiffness(k_n in 10.0..50.0, r_i in 1.0..12.0, r_j in 1.0..12.0, f_a in 0.1..6.0) {
            let (delta_0, k_lin, m_eff, _, omega_0, zeta, tau) = relaxation(k_n, r_i, r_j, 0.36, f_a, 4230.0, 0.5e6);
            let (_, f_nr, stiffness, _) = repulsion(k_n, delta_0, r_i, r_j, 0.36);
            prop_assert!(relative_eq!(f_nr, f_a, max_relative = 1e-12) && relative_eq!(stiffness, k_lin, max_relative = 1e-12));
            // the amplitude decays with the damping ratio times the frequency of that stiffness
            prop_assert!(relative_eq!(tau * zeta * omega_0, 1.0, max_relative = 1e-14));
            prop_assert!(relative_eq!(m_eff * omega_0 * omega_0, k_lin, max_relative = 1e-14));
        }
    }

    #[test]
    fn both_sizes_of_the_figure_are_damped_alike_and_ten_times_more_by_the_program() {
        for (r, k_n, f_a, zeta, period) in
            [(4e-9, 24.5e9, 1.8e-9, 0.0376, 33.5e-12), (8e-9, 33.7e9, 3.6e-9, 0.0382, 68.1e-12)]
        {
            let (_, _, _, _, omega_0, ratio, _) = relaxation(k_n, r, r, 0.36e-9, f_a, 4230.0, GAMMA_0.0);
            assert!((ratio - zeta).abs() < 5e-5, "{ratio}");
            assert!((2.0 * std::f64::consts::PI / omega_0 - period).abs() < 1e-13);
            let program = relaxation(k_n, r, r, 0.36e-9, f_a, 4230.0, GAMMA_0.1).5;
            assert!(relative_eq!(program, 10.0 * ratio, max_relative = 1e-14));
        }
    }
}
