//! Frequencies of a necked pair.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::pair_geometry::mean_arm;
use super::primary_particle::solid_inertia;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 2.1.2**, unnumbered: frequencies of two equal spheres in the four degrees of freedom of their neck.
///
/// ```math
/// \omega_\mathrm{n} = \sqrt{\frac{2k_\mathrm{n}}{m}}, \quad \omega_\mathrm{t} = \sqrt{2k_\mathrm{t} \left(\frac{1}{m} + \frac{r^2}{I}\right)}, \quad
/// \omega_\mathrm{r} = \sqrt{\frac{2k_\mathrm{r} r^2}{I}}, \quad \omega_\mathrm{o} = \sqrt{\frac{2k_\mathrm{o} r^2}{I}}
/// ```
///
/// # Reading
///
/// Eqs. 1, 2 and 12 for small motions about rest, without damping. Solid spheres have $7k_\mathrm{t}/m$ and $5k_\mathrm{r}/m$ under the roots, hollow ones $5k_\mathrm{t}/m$ and $3k_\mathrm{r}/m$.
/// With the printed signs of Eq. 4 the second would be imaginary.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_\mathrm{n}$ | N/m | > 0 | normal stiffness |
/// | `k_t` | $k_\mathrm{t}$ | N/m | > 0 | tangential stiffness |
/// | `k_r` | $k_\mathrm{r}$ | N/m | > 0 | rolling stiffness |
/// | `k_o` | $k_\mathrm{o}$ | N/m | > 0 | torsional stiffness |
/// | `m` | $m$ | kg | > 0 | mass of each sphere |
/// | `i` | $I$ | kg m^2 | > 0 | its moment of inertia |
/// | `r` | $r$ | m | > 0 | its radius |
/// | → `omega_n` | $\omega_\mathrm{n}$ | rad/s | | normal |
/// | → `omega_t` | $\omega_\mathrm{t}$ | rad/s | | tangential |
/// | → `omega_r` | $\omega_\mathrm{r}$ | rad/s | | rolling |
/// | → `omega_o` | $\omega_\mathrm{o}$ | rad/s | | torsion |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `solid_and_hollow_spheres_have_the_stated_frequencies`
#[inline(always)]
pub fn neck_frequencies<R: Real>(k_n: R, k_t: R, k_r: R, k_o: R, m: R, i: R, r: R) -> (R, R, R, R) {
    let two = R::lit(2.0);
    let (shift, turn) = (two / m, two * r.squared() / i);
    ((k_n * shift).sqrt(), (k_t * (shift + turn)).sqrt(), (k_r * turn).sqrt(), (k_o * turn).sqrt())
}

/// **Section 2.1.1**, unnumbered: time step relative to the stability limit of sliding and rolling of two spheres.
///
/// ```math
/// \lambda = \tfrac{1}{2} \left(a + b + \sqrt{(a - b)^2 + 4c^2}\right), \quad a = s_\mathrm{t} \left(\tfrac{1}{m_i} + \tfrac{1}{m_j} + \tfrac{r_i^2}{I_i} + \tfrac{r_j^2}{I_j}\right), \quad
/// b = s_\mathrm{r} \bar{a}^2 \left(\tfrac{1}{I_i} + \tfrac{1}{I_j}\right), \quad c^2 = s_\mathrm{t} s_\mathrm{r} \bar{a}^2 \left(\tfrac{r_i}{I_i} - \tfrac{r_j}{I_j}\right)^2, \quad
/// s = k \Delta t^2 + 2 \eta \Delta t
/// ```
///
/// # Reading
///
/// Eqs. 1, 2 and 12 for small motions about rest; dashpots act with the velocity of the step before. The largest eigenvalue of the map of the two springs over a step; the step is stable below 4.
/// Equal spheres slide and roll independently, and each motion has the limit of a mass on a spring. Unequal spheres do not: undamped, the limit of a sphere against one of three times its radius
/// is nine tenths of the limit against an equal one, against an infinite one three quarters.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `s_t` | $s_\mathrm{t}$ | kg | >= 0 | spring and dashpot of sliding in a step |
/// | `s_r` | $s_\mathrm{r}$ | kg | >= 0 | spring and dashpot of rolling in a step |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `m_i` | $m_i$ | kg | > 0 | mass of i |
/// | `m_j` | $m_j$ | kg | > 0 | mass of j |
/// | → `lambda` | $\lambda$ | 1 | | stable below 4 |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `equal_spheres_slide_and_roll_independently`
/// * `a_large_partner_couples_sliding_and_rolling`
#[inline(always)]
pub fn slide_and_roll<R: Real>(s_t: R, s_r: R, r_i: R, r_j: R, m_i: R, m_j: R) -> R {
    let (i_i, i_j, arm) = (solid_inertia(m_i, r_i), solid_inertia(m_j, r_j), mean_arm(r_i, r_j));
    let slide = s_t * (R::one() / m_i + R::one() / m_j + r_i.squared() / i_i + r_j.squared() / i_j);
    let roll = s_r * arm.squared() * (R::one() / i_i + R::one() / i_j);
    let both = s_t * s_r * (arm * (r_i / i_i - r_j / i_j)).squared();
    R::lit(0.5) * (slide + roll + ((slide - roll).squared() + R::lit(4.0) * both).sqrt())
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/pair_frequency.rs", "soot-frequencies", [], neck_frequencies),
        equation!("mechanics/pair_frequency.rs", "soot-slide-and-roll", [], slide_and_roll),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::primary_particle::hollow_inertia;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equal_spheres_slide_and_roll_independently(k_t in 0.1..10.0f64, k_r in 0.1..10.0f64, m in 0.1..10.0, r in 0.1..10.0) {
            // Without dashpots the step over the limit of each motion, squared, and four times that.
            let (_, t, r_, _) = neck_frequencies(1.0, k_t, k_r, 1.0, m, solid_inertia(m, r), r);
            prop_assert!((slide_and_roll(k_t, k_r, r, r, m, m) / t.max(r_).powi(2) - 1.0).abs() < 1e-13);
        }

        #[test]
        fn a_large_partner_couples_sliding_and_rolling(k in 0.1..10.0f64, m in 0.1..10.0, r in 0.1..10.0) {
            // Equal spheres have 7. Against an infinite one the rolling arm is twice the radius: the matrix of 3.5, 10 and, off its diagonal, 5.
            let endless = 0.5 * (13.5 + 142.25f64.sqrt());
            let beside = slide_and_roll(k, k, r, 1e9 * r, m, 1e27 * m) * m / k;
            prop_assert!((beside - endless).abs() < 1e-6);
            let three = slide_and_roll(k, k, r, 3.0 * r, m, 27.0 * m) * m / k;
            prop_assert!(three > 7.0 && three < endless);
        }

        #[test]
        fn solid_and_hollow_spheres_have_the_stated_frequencies(k in 0.1..10.0f64, m in 0.1..10.0, r in 0.1..10.0) {
            let squares = |i: f64| {
                let (n, t, r, o) = neck_frequencies(k, k, k, k, m, i, r);
                [n, t, r, o].map(|omega| omega * omega.abs() * m / k)
            };
            for (squares, expected) in [(squares(solid_inertia(m, r)), [2.0, 7.0, 5.0, 5.0]), (squares(hollow_inertia(m, r)), [2.0, 5.0, 3.0, 3.0])] {
                prop_assert!(squares.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13));
            }
        }
    }
}
