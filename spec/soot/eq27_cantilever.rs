//! The cantilever of the atomic force microscope, whose inertia filters the force.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 27**, Appendix: force that deflects the cantilever.
///
/// ```math
/// m_\mathrm{c} \ddot{u} + \eta_\mathrm{c} \dot{u} + k_\mathrm{c} u = f(t)
/// ```
///
/// # Reading
///
/// Read from left to right: the force that corresponds to a motion.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_c` | $m_\mathrm{c}$ | kg | > 0 | mass |
/// | `eta_c` | $\eta_\mathrm{c}$ | kg/s | >= 0 | damping coefficient |
/// | `k_c` | $k_\mathrm{c}$ | N/m | > 0 | stiffness |
/// | `u` | $u$ | m | any | deflection |
/// | `u_dot` | $\dot{u}$ | m/s | any | its rate |
/// | `u_ddot` | $\ddot{u}$ | m/s^2 | any | its acceleration |
/// | → `f` | $f$ | N | | force on the tip |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_reading_obeys_the_equation_of_the_deflection`
#[inline(always)]
pub fn cantilever_force<R: Real>(m_c: R, eta_c: R, k_c: R, u: R, u_dot: R, u_ddot: R) -> R {
    m_c * u_ddot + eta_c * u_dot + k_c * u
}

/// **Eq. 28**, Appendix: force that corresponds to a reading of the cantilever.
///
/// ```math
/// \frac{m_\mathrm{c}}{k_\mathrm{c}} \ddot{g} + \frac{\eta_\mathrm{c}}{k_\mathrm{c}} \dot{g} + g(t) = f(t)
/// ```
///
/// # Reading
///
/// Eq. 27 for the force derived from the deflection, $g = k_\mathrm{c} u$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_c` | $m_\mathrm{c}$ | kg | > 0 | mass |
/// | `eta_c` | $\eta_\mathrm{c}$ | kg/s | >= 0 | damping coefficient |
/// | `k_c` | $k_\mathrm{c}$ | N/m | > 0 | stiffness |
/// | `g` | $g$ | N | any | reading |
/// | `g_dot` | $\dot{g}$ | N/s | any | its rate |
/// | `g_ddot` | $\ddot{g}$ | N/s^2 | any | its second derivative |
/// | → `f` | $f$ | N | | force on the tip |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_reading_obeys_the_equation_of_the_deflection`
#[inline(always)]
pub fn force_of_reading<R: Real>(m_c: R, eta_c: R, k_c: R, g: R, g_dot: R, g_ddot: R) -> R {
    m_c / k_c * g_ddot + eta_c / k_c * g_dot + g
}

/// **Eq. 29**, Appendix: damping coefficient of the cantilever.
///
/// ```math
/// \eta_\mathrm{c} = 2 \sqrt{m_\mathrm{c} k_\mathrm{c}}
/// ```
///
/// # Reading
///
/// Critical damping, as printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_c` | $m_\mathrm{c}$ | kg | > 0 | mass |
/// | `k_c` | $k_\mathrm{c}$ | N/m | > 0 | stiffness |
/// | → `eta_c` | $\eta_\mathrm{c}$ | kg/s | | damping coefficient |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_critically_damped_cantilever_obeys_the_transfer_function`
#[inline(always)]
pub fn cantilever_damping<R: Real>(m_c: R, k_c: R) -> R {
    R::lit(2.0) * (m_c * k_c).sqrt()
}

/// **Eq. 31**, Appendix: natural frequency of the cantilever.
///
/// ```math
/// \omega_0 = \sqrt{\frac{k_\mathrm{c}}{m_\mathrm{c}}}
/// ```
///
/// # Reading
///
/// An angular frequency, as printed. The paper states neither it nor the mass.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_c` | $k_\mathrm{c}$ | N/m | > 0 | stiffness |
/// | `m_c` | $m_\mathrm{c}$ | kg | > 0 | mass |
/// | → `omega_0` | $\omega_0$ | rad/s | | natural frequency |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_critically_damped_cantilever_obeys_the_transfer_function`
#[inline(always)]
pub fn natural_frequency<R: Real>(k_c: R, m_c: R) -> R {
    (k_c / m_c).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq27_cantilever.rs", "soot-27", ["27"], cantilever_force),
        equation!("soot/eq27_cantilever.rs", "soot-28", ["28"], force_of_reading),
        equation!("soot/eq27_cantilever.rs", "soot-29", ["29"], cantilever_damping),
        equation!("soot/eq27_cantilever.rs", "soot-31", ["31"], natural_frequency),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::soot::eq30_transfer::transfer_function;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_reading_obeys_the_equation_of_the_deflection(
            m_c in 0.1..10.0, eta_c in 0.0..3.0, k_c in 0.1..10.0, u in -1.0..1.0, u_dot in -1.0..1.0, u_ddot in -1.0..1.0,
        ) {
            let f: f64 = cantilever_force(m_c, eta_c, k_c, u, u_dot, u_ddot);
            prop_assert!((force_of_reading(m_c, eta_c, k_c, k_c * u, k_c * u_dot, k_c * u_ddot) - f).abs() < 1e-13);
        }

        #[test]
        fn a_critically_damped_cantilever_obeys_the_transfer_function(m_c in 0.1..10.0, k_c in 0.1..10.0, s in 0.1..3.0) {
            // A reading that grows as the exponential of s t.
            let f = force_of_reading(m_c, cantilever_damping(m_c, k_c), k_c, 1.0, s, s * s);
            prop_assert!((transfer_function(natural_frequency(k_c, m_c), s, 0.0).0 * f - 1.0).abs() < 1e-14);
        }
    }
}
