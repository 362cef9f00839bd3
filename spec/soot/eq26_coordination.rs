//! The coordination number of primary particles.

use super::eq03_geometry::gap;
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 26**, Section 3.2: mean coordination number of an aggregate.
///
/// ```math
/// c = \frac{1}{N} \sum_{i=1}^{N} N_{\mathrm{nb},i}
/// ```
///
/// # Reading
///
/// Every pair of neighbours is counted twice in the sum. The sum is the argument here.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `sum` | $\sum N_{\mathrm{nb},i}$ | 1 | >= 0 | sum of the numbers of neighbours |
/// | `n` | $N$ | 1 | > 0 | number of primary particles |
/// | → `c` | $c$ | 1 | | mean coordination number |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_chain_has_a_coordination_number_just_below_two`
#[inline(always)]
pub fn coordination_number<R: Real>(sum: R, n: R) -> R {
    sum / n
}

/// **Section 3.2**, unnumbered: whether two primary particles are neighbours.
///
/// ```math
/// \delta < 0.01 \cdot 2r
/// ```
///
/// # Reading
///
/// The surfaces are less than one hundredth of a diameter apart; an overlap counts. For unequal spheres $2r$ is $r_i + r_j$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, another one |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `threshold` | | 1 | > 0 | largest gap as a fraction of the diameter, 0.01 |
/// | → `neighbours` | | 1 | | one if they are neighbours, else zero |
///
/// Rounding: at most 0 ULP.
///
/// # Laws
///
/// * `neighbours_are_less_than_a_hundredth_of_a_diameter_apart`
/// * `a_gap_of_just_the_threshold_is_too_far`
#[inline(always)]
pub fn are_neighbours<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>, r_i: R, r_j: R, threshold: R) -> R {
    R::select(gap(x_i, x_j, r_i, r_j).lt(threshold * (r_i + r_j)), R::one(), R::zero())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/eq26_coordination.rs", "soot-26", ["26"], coordination_number),
        equation!("soot/eq26_coordination.rs", "soot-neighbours", [], are_neighbours),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{unit, vector};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_chain_has_a_coordination_number_just_below_two(n in 2usize..20, along in unit()) {
            let at = |k: usize| along * (2.0 * k as f64);
            let sum: f64 = (0..n).flat_map(|i| (0..n).filter(move |j| i != *j).map(move |j| (i, j)))
                .map(|(i, j)| are_neighbours(at(i), at(j), 1.0, 1.0, 0.01))
                .sum();
            prop_assert!((coordination_number(sum, n as f64) - (2.0 - 2.0 / n as f64)).abs() < 1e-15);
        }

        #[test]
        fn neighbours_are_less_than_a_hundredth_of_a_diameter_apart(x in vector(), n in unit(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            let apart = |share: f64| are_neighbours(x, x + n * ((r_i + r_j) * (1.0 + share)), r_i, r_j, 0.01);
            prop_assert_eq!((apart(-0.1), apart(0.0), apart(0.0099), apart(0.0101)), (1.0, 1.0, 1.0, 0.0));
        }
    }

    #[test]
    fn a_gap_of_just_the_threshold_is_too_far() {
        let apart = |gap: f64| are_neighbours(Vec3::zero(), Vec3::new(2.0 + gap, 0.0, 0.0), 1.0, 1.0, 0.125);
        assert_eq!([apart(0.25 - 1e-15), apart(0.25)], [1.0, 0.0]);
    }
}
