//! The eigenvalues of the amplification matrix: on the unit circle up to the critical step, real and distinct above it.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.16**, Appendix A.1.1: eigenvalues of the amplification matrix.
///
/// ```math
/// \lambda_{1,2} = \frac{2 - \hat{\Delta t}^2 \pm \hat{\Delta t} \sqrt{\hat{\Delta t}^2 - 4}}{2}
/// ```
///
/// # Reading
///
/// Real and imaginary parts. With $s = \sqrt{|h^2 - 4|}$ the printed form is $-((h \mp s)/2)^2$ for real $s$, since
/// $(h \mp s)^2 = 2 h^2 - 4 \mp 2 h s$. That is what the code computes above two: $\lambda_2$ from its square, which is a
/// sum of terms of one sign, and $\lambda_1$ as its inverse, because their product is the determinant, one. In the
/// printed form $\lambda_1$ would suffer from cancellation.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `h` | $\hat{\Delta t}$ | 1 | >= 0 | scaled time step |
/// | → `re_1` | $\operatorname{Re} \lambda_1$ | 1 | | real part of the eigenvalue with the plus sign |
/// | → `im_1` | $\operatorname{Im} \lambda_1$ | 1 | | its imaginary part |
/// | → `re_2` | $\operatorname{Re} \lambda_2$ | 1 | | real part of the eigenvalue with the minus sign |
/// | → `im_2` | $\operatorname{Im} \lambda_2$ | 1 | | its imaginary part |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `are_those_that_faer_finds`
/// * `are_the_printed_roots`
/// * `their_product_is_one`
/// * `lie_on_the_unit_circle_up_to_a_step_of_two`
/// * `one_leaves_the_unit_circle_above_a_step_of_two`
#[inline(always)]
pub fn eigenvalues<R: Real>(h: R) -> (R, R, R, R) {
    let (zero, two) = (R::zero(), R::lit(2.0));
    let s = ((h - two) * (h + two)).abs().sqrt();
    let complex = h.lt(two);
    let larger = -((h + s) / two).squared();
    let centre = (two - h.squared()) / two;
    let height = R::select(complex, h * s / two, zero);
    (R::select(complex, centre, R::one() / larger), height, R::select(complex, centre, larger), -height)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/a16_eigenvalues.rs", "wear-A16", ["A16"], eigenvalues)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a11_scaled_step::amplification_matrix;
    use approx::assert_abs_diff_eq;
    use faer::mat;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn are_those_that_faer_finds(h in prop_oneof![0.1f64..1.9, 2.1f64..4.0]) {
            let (a, b, c, d) = amplification_matrix(h);
            let mut found = mat![[a, b], [c, d]].eigenvalues().expect("a matrix of finite numbers");
            found.sort_by(|one, other| (other.re, other.im).partial_cmp(&(one.re, one.im)).expect("no NaN"));
            let (re_1, im_1, re_2, im_2) = eigenvalues(h);
            for (ours, theirs) in [(re_1, found[0].re), (im_1, found[0].im), (re_2, found[1].re), (im_2, found[1].im)] {
                assert_abs_diff_eq!(ours, theirs, epsilon = 1e-12);
            }
        }

        #[test]
        fn are_the_printed_roots(h in 2.0f64..4.0) {
            let root = (h * h - 4.0).sqrt();
            let (re_1, im_1, re_2, im_2) = eigenvalues(h);
            prop_assert_eq!((im_1, im_2), (0.0, -0.0));
            // The printed form suffers from cancellation of numbers below 16; the root amplifies rounding near two.
            assert_abs_diff_eq!(re_1, (2.0 - h * h + h * root) / 2.0, epsilon = 1e-7);
            assert_abs_diff_eq!(re_2, (2.0 - h * h - h * root) / 2.0, epsilon = 1e-7);
        }

        #[test]
        fn their_product_is_one(h in 0.0..4.0) {
            let (re_1, im_1, re_2, im_2) = eigenvalues(h);
            assert_abs_diff_eq!(re_1 * re_2 - im_1 * im_2, 1.0, epsilon = 8.0 * f64::EPSILON);
            assert_abs_diff_eq!(re_1 * im_2 + im_1 * re_2, 0.0, epsilon = 8.0 * f64::EPSILON);
        }

        #[test]
        fn lie_on_the_unit_circle_up_to_a_step_of_two(h in 0.0..=2.0) {
            let (re_1, im_1, re_2, im_2) = eigenvalues(h);
            assert_abs_diff_eq!(re_1 * re_1 + im_1 * im_1, 1.0, epsilon = 8.0 * f64::EPSILON);
            assert_abs_diff_eq!(re_2 * re_2 + im_2 * im_2, 1.0, epsilon = 8.0 * f64::EPSILON);
        }

        #[test]
        fn one_leaves_the_unit_circle_above_a_step_of_two(excess in 1e-9..2.0) {
            let (re_1, _, re_2, _) = eigenvalues(2.0 + excess);
            prop_assert!(re_2 < -1.0 && -1.0 < re_1 && re_1 < 0.0);
        }
    }
}
