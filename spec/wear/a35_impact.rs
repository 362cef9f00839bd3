//! The motion of two colliding spheres, for any damping.

use super::a19_critical_damping::critical_pair_damping;
use super::a37_frequency::damped_frequency;
use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// **Eq. A.35**, Appendix A.2: separation after two spheres have collided.
///
/// ```math
/// x = \frac{v_0}{\omega} e^{-\frac{c_N}{2 m_{\text{eff}}} t} \sin(\omega t)
/// ```
///
/// # Reading
///
/// Exact with the damped frequency A.37, and continued beyond critical damping, where the frequency is imaginary. With
/// $\beta = c_N / 2 m_{\text{eff}}$ and $\omega$ the magnitude,
///
/// ```math
/// \frac{x}{v_0} = \begin{cases} e^{-\beta t} \sin(\omega t) / \omega & c_N < c_c \\ t\, e^{-\beta t} & c_N = c_c \\
///   e^{-\beta t} \sinh(\omega t) / \omega & c_N > c_c \end{cases}
/// ```
///
/// The last case is computed as $e^{-(\beta - \omega) t} \tau / \omega (1 + \tau)$ with $\tau = \tanh(\omega t)$, since
/// $\sinh = e^{\omega t} \tau / (1 + \tau)$, and $\beta - \omega$ as $k_N / m_{\text{eff}} (\beta + \omega)$: nothing
/// overflows or cancels.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `v_0` | $v_0$ | m/s | any | rate of separation at first touch, at time zero |
/// | `t` | $t$ | s | >= 0 | time |
/// | → `x` | $x$ | m | | separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `starts_at_rest_length_with_the_given_velocity`
/// * `solves_the_equation_of_motion`
/// * `the_natural_frequency_does_not_solve_it`
/// * `continuous_through_critical_damping`
/// * `swings_back_below_critical_damping_and_never_above`
#[inline(always)]
pub fn impact_separation<R: Real>(k_n: R, m_eff: R, c_n: R, v_0: R, t: R) -> R {
    v_0 * swing(k_n, m_eff, c_n, t).0
}

/// **Eq. A.36**, Appendix A.2: rate of separation after two spheres have collided.
///
/// ```math
/// \dot x = -\frac{c_N v_0}{2 \omega m_{\text{eff}}} e^{-\frac{c_N}{2 m_{\text{eff}}} t} \sin(\omega t)
///   + v_0 e^{-\frac{c_N}{2 m_{\text{eff}}} t} \cos(\omega t)
/// ```
///
/// # Reading
///
/// The first term is $-\beta x$. At and beyond critical damping the motion obeys
/// $\dot x = v_0 e^{-(\beta + \omega) t} - (\beta - \omega) x$, which is evaluated in that range.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping |
/// | `v_0` | $v_0$ | m/s | any | rate of separation at first touch, at time zero |
/// | `t` | $t$ | s | >= 0 | time |
/// | → `v` | $\dot x$ | m/s | | rate of separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `starts_at_rest_length_with_the_given_velocity`
/// * `is_the_slope_of_the_separation`
/// * `continuous_through_critical_damping`
#[inline(always)]
pub fn impact_velocity<R: Real>(k_n: R, m_eff: R, c_n: R, v_0: R, t: R) -> R {
    let (swing, rest, rate) = swing(k_n, m_eff, c_n, t);
    v_0 * (rest - rate * swing)
}

/// The motion from unit velocity, as `x = swing` and `v = rest - rate swing`.
#[inline(always)]
fn swing<R: Real>(k_n: R, m_eff: R, c_n: R, t: R) -> (R, R, R) {
    let c_c = critical_pair_damping(k_n, m_eff);
    let (swings, creeps) = (c_n.lt(c_c), c_n.gt(c_c));
    let omega = damped_frequency(k_n, m_eff, c_n);
    let beta = c_n / (R::lit(2.0) * m_eff);
    let slow = k_n / m_eff / (beta + omega);
    let decay = (-beta * t).exp();
    let tau = (omega * t).tanh();
    let swing = piecewise(
        [(swings, decay * (omega * t).sin() / omega), (creeps, (-slow * t).exp() * tau / (omega * (R::one() + tau)))],
        t * decay,
    );
    let rest = R::select(swings, decay * (omega * t).cos(), (-(beta + omega) * t).exp());
    (swing, rest, R::select(swings, beta, slow))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a35_impact.rs", "wear-A35", ["A35"], impact_separation),
        equation!("wear/a35_impact.rs", "wear-A36", ["A36"], impact_velocity),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use crate::wear::a01_pair_motion::relative_acceleration;
    use crate::wear::a37_frequency::natural_frequency;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;

    /// Separation, velocity and acceleration after an impact with unit velocity; the acceleration is the slope of A.36.
    fn motion(k: f64, m: f64, zeta: f64, t: f64) -> [f64; 3] {
        let c = zeta * critical_pair_damping(k, m);
        let [k_d, m_d, c_d] = [k, m, c].map(Dual::constant);
        let v = impact_velocity(k_d, m_d, c_d, Dual::constant(1.0), Dual::variable(t));
        [impact_separation(k, m, c, 1.0, t), v.value, v.slope]
    }

    proptest! {
        #[test]
        fn starts_at_rest_length_with_the_given_velocity(zeta in 0.0..3.0, v_0 in -2.0..2.0) {
            prop_assert_eq!(impact_separation(1.0, 1.0, 2.0 * zeta, v_0, 0.0), 0.0);
            prop_assert_eq!(impact_velocity(1.0, 1.0, 2.0 * zeta, v_0, 0.0), v_0);
        }

        #[test]
        fn is_the_slope_of_the_separation(
            (k, m) in (0.5..2.0, 0.5..2.0), zeta in prop_oneof![0.0..3.0, Just(1.0)], t in 0.0..10.0,
        ) {
            let c = zeta * critical_pair_damping(k, m);
            let [k_d, m_d, c_d] = [k, m, c].map(Dual::constant);
            let x = impact_separation(k_d, m_d, c_d, Dual::constant(1.0), Dual::variable(t));
            assert_abs_diff_eq!(x.slope, impact_velocity(k, m, c, 1.0, t), epsilon = 1e-13);
        }

        #[test]
        fn solves_the_equation_of_motion(
            (k, m) in (0.5..2.0, 0.5..2.0), zeta in prop_oneof![0.0..3.0, Just(1.0)], t in 0.0..10.0,
        ) {
            let [x, v, a] = motion(k, m, zeta, t);
            let c = zeta * critical_pair_damping(k, m);
            assert_abs_diff_eq!(a, relative_acceleration(m, c, k, x, v), epsilon = 1e-13);
        }

        /// With the natural frequency, as the text of the paper says, A.35 leaves a residual.
        #[test]
        fn the_natural_frequency_does_not_solve_it((k, m) in (0.5..2.0, 0.5..2.0), zeta in 0.1..0.9) {
            let c = Dual::constant(zeta * critical_pair_damping(k, m));
            let (omega, beta) = (Dual::constant(natural_frequency(k, m)), c / Dual::constant(2.0 * m));
            let t = Dual::variable(0.5 / omega.value);
            let decay = (-beta * t).exp();
            let x = decay * (omega * t).sin() / omega;
            let v = decay * (omega * t).cos() - beta * x;
            let residual = v.slope - relative_acceleration(m, c.value, k, x.value, v.value);
            // beta^2 x is left over.
            assert_relative_eq!(residual, -(beta * beta * x).value, epsilon = 1e-13, max_relative = 1e-10);
            prop_assert!(residual.abs() > 1e-3 * k / m * x.value);
        }

        #[test]
        fn continuous_through_critical_damping((k, m) in (0.5..2.0, 0.5..2.0), t in 0.0..10.0) {
            let [x, v, a] = motion(k, m, 1.0, t);
            for zeta in [1.0 - 1e-9, 1.0 + 1e-9] {
                let near = motion(k, m, zeta, t);
                assert_abs_diff_eq!(near[0], x, epsilon = 1e-7);
                assert_abs_diff_eq!(near[1], v, epsilon = 1e-7);
                assert_abs_diff_eq!(near[2], a, epsilon = 1e-7);
            }
        }

        #[test]
        fn swings_back_below_critical_damping_and_never_above(zeta in 0.01..0.95, creep in 1.0..3.0, t in 0.01..30.0) {
            let half = std::f64::consts::PI / damped_frequency(1.0, 1.0, 2.0 * zeta);
            prop_assert!(impact_separation(1.0, 1.0, 2.0 * zeta, 1.0, 1.01 * half) < 0.0);
            prop_assert!(impact_separation(1.0, 1.0, 2.0 * creep, 1.0, t) > 0.0);
        }
    }
}
