//! The coefficient of restitution for a given damping, exact and in the paper's approximation.

use super::a19_critical_damping::critical_pair_damping;
use super::a37_frequency::damped_frequency;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.42**, Appendix A.2: restitution coefficient for a given damping.
///
/// ```math
/// \eta = e^{-\frac{\pi c_N}{2 \omega m_{\text{eff}}}}
/// ```
///
/// # Reading
///
/// Exact with the damped frequency A.37; zero at and beyond critical damping. In terms of the damping ratio it is
/// $e^{-\pi \zeta / \sqrt{1 - \zeta^2}}$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_that_of_the_damping_ratio`
/// * `nothing_comes_back_beyond_critical_damping`
#[inline(always)]
pub fn pair_restitution<R: Real>(k_n: R, m_eff: R, c_n: R) -> R {
    let parts = c_n.lt(critical_pair_damping(k_n, m_eff));
    R::select(parts, (-loss_exponent(k_n, m_eff, c_n)).exp(), R::zero())
}

/// **Eq. A.43**, Appendix A.2: restitution coefficient for weak damping.
///
/// ```math
/// \eta \approx 1 - \frac{\pi c_N}{2 \omega m_{\text{eff}}}
/// ```
///
/// # Reading
///
/// The first two terms of the series of A.42, hence never above it; below critical damping only.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient, approximately |
///
/// Rounding: at most 2.5 ULP.
///
/// # Laws
///
/// * `both_approximations_are_below_by_half_the_square_of_the_loss`
#[inline(always)]
pub fn weak_restitution<R: Real>(k_n: R, m_eff: R, c_n: R) -> R {
    R::one() - loss_exponent(k_n, m_eff, c_n)
}

/// **Eq. A.44**, Appendix A.2: the same with the natural frequency.
///
/// ```math
/// \eta \approx 1 - \frac{\pi c_N}{2 \sqrt{k_N m_{\text{eff}}}}
/// ```
///
/// # Reading
///
/// As printed: A.38 substituted into A.43. It becomes negative above 0.318 of the critical damping.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | → `eta` | $\eta$ | 1 | | restitution coefficient, approximately |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `both_approximations_are_below_by_half_the_square_of_the_loss`
#[inline(always)]
pub fn weaker_restitution<R: Real>(k_n: R, m_eff: R, c_n: R) -> R {
    R::one() - R::pi() * c_n / critical_pair_damping(k_n, m_eff)
}

/// The exponent common to A.40 to A.43.
#[inline(always)]
fn loss_exponent<R: Real>(k_n: R, m_eff: R, c_n: R) -> R {
    R::pi() * c_n / (R::lit(2.0) * damped_frequency(k_n, m_eff, c_n) * m_eff)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a42_restitution.rs", "wear-A42", ["A42"], pair_restitution),
        equation!("wear/a42_restitution.rs", "wear-A43", ["A43"], weak_restitution),
        equation!("wear/a42_restitution.rs", "wear-A44", ["A44"], weaker_restitution),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_restitution::{damping_ratio_of, restitution};
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_that_of_the_damping_ratio((k, m) in (0.5..2.0, 0.5..2.0), zeta in 0.0..0.9) {
            let c = zeta * critical_pair_damping(k, m);
            let exact = restitution(damping_ratio_of(c, k, m));
            // The exponent reaches 6.5.
            assert_relative_eq!(pair_restitution(k, m, c), exact, epsilon = 0.0, max_relative = 128.0 * f64::EPSILON);
        }

        #[test]
        fn nothing_comes_back_beyond_critical_damping(zeta in 1.0..5.0) {
            prop_assert_eq!(pair_restitution(1.0, 1.0, 2.0 * zeta), 0.0);
        }

        #[test]
        fn both_approximations_are_below_by_half_the_square_of_the_loss(zeta in 0.0001f64..0.03) {
            let (c, loss) = (2.0 * zeta, std::f64::consts::PI * zeta);
            let exact = pair_restitution(1.0, 1.0, c);
            let (weak, weaker) = (weak_restitution(1.0, 1.0, c), weaker_restitution(1.0, 1.0, c));
            prop_assert!(weak <= weaker && weaker < exact);
            // The next term of the series is a sixth of the cube; the frequency adds zeta^3.
            for approximate in [weak, weaker] {
                assert_abs_diff_eq!(exact - approximate, 0.5 * loss * loss, epsilon = loss.powi(3));
            }
        }
    }
}
