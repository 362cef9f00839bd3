//! Laws of [`Rounded`], whatever the formula.

use super::*;
use crate::numbers::Reference;
use num_traits::{One, Zero};
use proptest::prelude::*;

/// Every operation, smooth ones and such as jump.
fn operations<R: Real>(x: R, y: R) -> Vec<R> {
    let third = x / R::lit(3.0);
    let waves = (x * y).sin() + (x - y).cos() * third.tanh();
    let size = (x.squared() + y * y).sqrt();
    vec![
        waves * (-third).exp(),
        (x + y).abs().ln() - size,
        (x - y) * (y - third) / (x.squared() + R::pi()),
        (third / (R::one() + third.abs())).acos(),
        (x.abs() * y.abs()).sqrt() * R::lit(0.5),
        third.max(y * y) - third.min(x - y),
        third.floor() + R::entry(&[1.0, 5.0, -2.0, 0.5], x.abs().floor().min(R::lit(3.0))),
        // for some numbers three thirds are below one in `f64` alone
        R::select((third * R::lit(3.0)).lt(x) | (x * y).lt(third) & !x.le(y), x - R::lit(7.0), size),
        R::select((x - third - third - third).gt(R::zero()), R::one(), -R::one()),
        R::one() / (x - y),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn exact_values_doubles_and_errors_are_within_their_bounds(
        lo in prop::array::uniform2(prop_oneof![-9.0..9.0f64, -1e-6..1e-6f64, Just(0.0)]),
        width in prop::array::uniform2(prop_oneof![Just(0.0), 0.0..1e-12f64, 0.0..1e-3f64, 0.0..4.0f64]),
        place in prop::array::uniform2(0.0..=1.0f64),
    ) {
        let ranges: [Interval; 2] = std::array::from_fn(|k| Interval::new(lo[k], lo[k] + width[k]));
        let point: [f64; 2] = std::array::from_fn(|k| (lo[k] + place[k] * width[k]).clamp(ranges[k].lo, ranges[k].hi));
        let claimed = operations(Rounded::input(0, ranges[0]), Rounded::input(1, ranges[1]));
        let exact = operations(Reference::exact(point[0]), Reference::exact(point[1]));
        for ((claimed, double), exact) in claimed.iter().zip(operations(point[0], point[1])).zip(exact) {
            if claimed.trouble().is_none() {
                let error = (Reference::exact(double) - exact).abs().to_f64();
                prop_assert!(error <= claimed.error(), "{point:?}: {double} has an error of {error:e}, claimed are {claimed:?}");
                prop_assert!(claimed.computed().contains(double) && claimed.exact().contains(exact.to_f64()), "{claimed:?}");
            }
        }
    }

    #[test]
    fn products_of_powers_have_their_textbook_bound(x in 0.1..9.0f64, y in 0.1..9.0f64) {
        let wide = |k, x: f64| Rounded::input(k, Interval::new(x, 10.0 * x));
        let (a, b) = (wide(0, x), wide(1, y));
        // four roundings of half a unit
        let ulps = (a * b.squared() / (Rounded::lit(3.0) * b)).ulps(0.0);
        prop_assert!(ulps.first_order <= 2.0 + 1e-9 && ulps.rest < 1e-300, "{ulps:?}");
        let ulps = (a * b.squared()).ulps(0.0);
        prop_assert!(ulps.first_order <= 1.0 / 4.0 + 1e-9, "{ulps:?}");
        // a difference whose parts come near each other
        let ulps = (a * b - b).ulps(0.0);
        prop_assert!(ulps.first_order <= 1.0 + 1e-9, "{ulps:?}");
    }
}

#[test]
fn what_has_no_value_is_said() {
    let x = Rounded::input(0, Interval::new(-1.0, 4.0));
    assert_eq!((Rounded::one() / x).trouble(), Some(Trouble::Denominator));
    assert_eq!(x.sqrt().trouble(), Some(Trouble::Domain));
    assert_eq!((x - Rounded::one()).ln().trouble(), Some(Trouble::Domain));
    assert_eq!((x * Rounded::lit(1e308)).trouble(), Some(Trouble::Overflow));
    assert_eq!((x.squared() + Rounded::one()).sqrt().trouble(), None);
    // a case that is not taken does not count
    assert_eq!(Rounded::select(x.lt(Rounded::lit(5.0)), x, Rounded::zero() / Rounded::zero()).trouble(), None);
}

#[test]
fn a_number_times_itself_is_a_square_and_two_numbers_are_two() {
    let (x, y) = (Interval::new(-2.0, 3.0), Interval::new(-2.0, 3.0));
    let (x, y) = (Rounded::input(0, x), Rounded::input(1, y));
    assert_eq!((x * x).exact().lo, 0.0);
    assert!((x * y).exact().lo <= -6.0);
}
