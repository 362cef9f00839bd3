//! Laws of intervals: they contain what they should, and hardly more.

mod bounds;

use super::*;
use crate::numbers::Reference;
use proptest::prelude::*;

/// Every operation once.
fn composite<R: Real>(x: R, y: R) -> R {
    let waves = (x * y).sin() + (x - y).cos() * (x / y).tanh();
    let chosen = R::select(x.lt(y) & x.ge(R::lit(0.5)) | y.gt(R::lit(2.0)), x.squared(), -y.abs());
    waves * (-x).exp() + (x + y).abs().ln() / (x.squared() + R::pi()).sqrt() + x.max(y) * x.floor().min(y) + chosen
}
fn one_of(interval: Interval, place: f64) -> f64 {
    (interval.lo + place * (interval.hi - interval.lo)).clamp(interval.lo, interval.hi)
}

prop_compose! {
    fn intervals(largest: f64)(lo in -largest..largest, width in prop_oneof![Just(0.0), 0.0..1e-9, 0.0..10.0]) -> Interval {
        Interval::new(lo, lo + width)
    }
}

/// One function over two numbers.
type Bounded = (fn(Interval) -> Interval, fn(f64) -> f64);

/// One function over three numbers.
type Function = (fn(Interval) -> Interval, fn(f64) -> f64, fn(Reference) -> Reference);

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn it_contains_the_double_and_the_exact_result(a in intervals(20.0), b in intervals(20.0), s in 0.0..=1.0, t in 0.0..=1.0) {
        let (x, y) = (one_of(a, s), one_of(b, t));
        let bounds = composite(a, b);
        let exact = composite(Reference::exact(x), Reference::exact(y));
        prop_assert!(bounds.contains(composite(x, y)), "{bounds:?} {}", composite(x, y));
        prop_assert!(bounds == Interval::LINE || exact.ge(Reference::exact(bounds.lo)) && exact.le(Reference::exact(bounds.hi)));
    }

    #[test]
    fn it_contains_every_transcendental_function(a in intervals(30.0), s in 0.0..=1.0) {
        let x = one_of(a, s);
        let functions: [Function; 6] = [
            (Real::exp, Real::exp, Real::exp),
            (Real::sin, Real::sin, Real::sin),
            (Real::cos, Real::cos, Real::cos),
            (Real::tanh, Real::tanh, Real::tanh),
            (|x| x.tanh().acos(), |x| Real::acos(Real::tanh(x)), |x| x.tanh().acos()),
            (|x| x.squared().ln(), |x| Real::ln(x.squared()), |x| x.squared().ln()),
        ];
        for (bounds, double, exact) in functions {
            let bounds = bounds(a);
            prop_assert!(bounds.contains(double(x)) && bounds.contains(exact(Reference::exact(x)).to_f64()), "{a:?} {x} {bounds:?}");
        }
    }

    #[test]
    fn a_point_stays_narrow(x in 0.1..10.0, y in 0.1..10.0) {
        let bounds = Interval::point(x) * Interval::point(y) + Interval::point(x).sqrt();
        // three roundings, each one unit of the last place to both sides
        prop_assert!(bounds.hi - bounds.lo <= 8.0 * f64::EPSILON * bounds.hi);
    }
}

#[test]
fn a_square_is_not_negative_and_a_wave_not_above_one() {
    let x = Interval::new(-2.0, 3.0);
    assert_eq!(x.squared().lo, 0.0);
    assert_eq!(x.abs(), Interval::new(0.0, 3.0));
    assert_eq!(x.sin(), Interval::new(-1.0, 1.0));
    assert_eq!(Interval::new(1.0, 2.0).sin().hi, 1.0);
    assert!(Interval::new(1.0, 1.5).sin().hi < 1.0);
}

proptest! {
    /// Both bounds are attained, up to the margin: a bound that is always true proves nothing.
    #[test]
    fn bounds_are_tight(lo in -8.0..8.0, width in prop_oneof![Just(0.0), 0.0..1e-6, 0.0..9.0]) {
        let x = Interval::new(lo, lo + width);
        let places: Vec<f64> = (0..=2000).map(|k| one_of(x, f64::from(k) / 2000.0)).collect();
        let functions: [Bounded; 8] = [
            (Real::sin, Real::sin),
            (Real::cos, Real::cos),
            (Real::exp, Real::exp),
            (Real::tanh, Real::tanh),
            (Real::squared, Real::squared),
            (Real::floor, Real::floor),
            (|x| (x * Interval::lit(0.05)).acos(), |x| Real::acos(x * 0.05)),
            (|x| (x.exp() + Interval::one()).ln().sqrt(), |x| Real::ln(Real::exp(x) + 1.0).sqrt()),
        ];
        for (k, (bounds, double)) in functions.into_iter().enumerate() {
            let (bounds, values) = (bounds(x), places.iter().map(|&place| double(place)));
            let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
            // between two of the places a wave rises above both by less than the square of their distance
            let slack = 1e-13 * (1.0 + most.abs()) + (width / 2000.0) * (width / 2000.0);
            prop_assert!(least - bounds.lo <= slack && bounds.hi - most <= slack, "{k}: {x:?} {bounds:?} {least} {most}");
        }
    }

    #[test]
    fn bounds_of_products_and_quotients_are_attained_at_corners(a in intervals(20.0), b in intervals(20.0)) {
        let corners = |f: fn(f64, f64) -> f64| {
            let values = [f(a.lo, b.lo), f(a.lo, b.hi), f(a.hi, b.lo), f(a.hi, b.hi)];
            (values.into_iter().fold(f64::INFINITY, f64::min), values.into_iter().fold(f64::NEG_INFINITY, f64::max))
        };
        let close = |bounds: Interval, (least, most): (f64, f64)| {
            let slack = 4.0 * f64::EPSILON * (least.abs() + most.abs());
            least - bounds.lo <= slack && bounds.hi - most <= slack
        };
        prop_assert!(close(a + b, corners(|x, y| x + y)) && close(a - b, corners(|x, y| x - y)));
        prop_assert!(close(a * b, corners(|x, y| x * y)));
        prop_assert!(b.contains(0.0) || close(a / b, corners(|x, y| x / y)));
    }
}

#[test]
fn a_comparison_may_be_undecided() {
    let (a, b, c) = (Interval::new(0.0, 1.0), Interval::new(0.5, 2.0), Interval::new(2.0, 3.0));
    assert_eq!((a.lt(c), c.lt(a), a.lt(b)), (Truth::Always, Truth::Never, Truth::Sometimes));
    assert_eq!(b.le(c), Truth::Always);
    assert_eq!(Interval::select(a.lt(b), Interval::point(-1.0), Interval::point(4.0)), Interval::new(-1.0, 4.0));
    assert_eq!((a / a, Interval::one() / b == Interval::LINE), (Interval::LINE, false));
}
