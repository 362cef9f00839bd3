//! Stresses of a neck under tension, bending and torsion.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Not in the paper: the largest tensile and the largest shear stress in a neck, which decide when it breaks.
///
/// ```math
/// \sigma = \frac{f_\mathrm{n}}{\pi r_\mathrm{b}^2} + \frac{4 |\mathbf{m}_\perp|}{\pi r_\mathrm{b}^3}, \quad
/// \tau = \frac{|\mathbf{f}_\mathrm{t}|}{\pi r_\mathrm{b}^2} + \frac{2 |\mathbf{m} \cdot \mathbf{n}|}{\pi r_\mathrm{b}^3}
/// ```
///
/// # Reading
///
/// The paper's bonds have a tensile strength, but neither its value nor a cross-section is given. The neck is taken as a short elastic beam of circular cross-section, the bonded particles of
/// Potyondy and Cundall (2004): normal and shear force are distributed uniformly, the stresses of bending and torsion increase linearly with the distance from the axis. Both stresses are evaluated on the
/// circumference, where they are largest. If compression outweighs bending, no part of the neck is in tension and $\sigma$ is negative.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_n` | $f_\mathrm{n}$ | N | any | force along the normal, positive where it pulls |
/// | `f_t` | $\mathbf{f}_\mathrm{t}$ | N (3) | any | force across the normal |
/// | `m` | $\mathbf{m}$ | N m (3) | any | torque that bends and twists |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal |
/// | `r_b` | $r_\mathrm{b}$ | m | > 0 | radius of the neck |
/// | → `sigma` | $\sigma$ | Pa | | largest tensile stress |
/// | → `tau` | $\tau$ | Pa | | largest shear stress |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `stresses_over_the_section_add_up_to_what_the_neck_carries`
#[inline(always)]
pub fn neck_stress<R: Real>(f_n: R, f_t: Vec3<R>, m: Vec3<R>, n: Vec3<R>, r_b: R) -> (R, R) {
    let area = R::pi() * r_b.squared();
    let turned = |m: R, times: f64| R::lit(times) * m / (area * r_b);
    let (bending, twisting) = (m.perpendicular_to(n).norm(), m.dot(n).abs());
    (f_n / area + turned(bending, 4.0), f_t.norm() / area + turned(twisting, 2.0))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("soot/def_neck_stress.rs", "soot-neck-stress", [], neck_stress)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{unit, vector};
    use proptest::prelude::*;

    /// Rings and sectors of the section.
    const PARTS: u32 = 64;

    proptest! {
        #[test]
        fn stresses_over_the_section_add_up_to_what_the_neck_carries(
            f_n in -1.0..1.0f64, f_t in vector(), m in vector(), n in unit(), r_b in 0.3..3.0f64,
        ) {
            let f_t = f_t.perpendicular_to(n);
            let none = Vec3::zero();
            let (even, bent) = (neck_stress(f_n, none, none, n, r_b).0, neck_stress(0.0, none, m, n, r_b).0);
            let (across, twisted) = (neck_stress(0.0, f_t, none, n, r_b).1, neck_stress(0.0, none, m, n, r_b).1);
            // By the midpoints of rings, whose error is of second order in their width.
            let (mut area, mut bending, mut twisting) = (0.0, 0.0, 0.0);
            let (width, angle) = (r_b / f64::from(PARTS), std::f64::consts::TAU / f64::from(PARTS));
            for ring in 0..PARTS {
                let rho = (f64::from(ring) + 0.5) * width;
                for sector in 0..PARTS {
                    let along = rho * (f64::from(sector) * angle).cos();
                    let part = rho * width * angle;
                    area += part;
                    bending += bent * along / r_b * along * part;
                    twisting += twisted * rho / r_b * rho * part;
                }
            }
            prop_assert!((even * area - f_n).abs() < 1e-12);
            prop_assert!((across * area - f_t.norm()).abs() < 1e-12);
            prop_assert!((bending - m.perpendicular_to(n).norm()).abs() < 1e-3);
            prop_assert!((twisting - m.dot(n).abs()).abs() < 1e-3);
            // All at once they add up on the circumference.
            let (sigma, tau) = neck_stress(f_n, f_t, m, n, r_b);
            prop_assert!((sigma - even - bent).abs() < 1e-12 * (1.0 + bent) && (tau - across - twisted).abs() < 1e-12 * (1.0 + tau));
        }
    }
}
