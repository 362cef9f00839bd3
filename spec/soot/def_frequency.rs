//! How fast a necked pair oscillates.

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

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("soot/def_frequency.rs", "soot-frequencies", [], neck_frequencies)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::soot::def_sphere::{hollow_inertia, solid_inertia};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn solid_and_hollow_spheres_have_the_stated_frequencies(k in 0.1..10.0f64, m in 0.1..10.0, r in 0.1..10.0) {
            let squares = |i: f64| {
                let (n, t, r, o) = neck_frequencies(k, k, k, k, m, i, r);
                [n, t, r, o].map(|omega| omega * omega * m / k)
            };
            for (squares, expected) in [(squares(solid_inertia(m, r)), [2.0, 7.0, 5.0, 5.0]), (squares(hollow_inertia(m, r)), [2.0, 5.0, 3.0, 3.0])] {
                prop_assert!(squares.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13));
            }
        }
    }
}
