//! The bounds themselves, to the last bit: how far each operation moves them outwards, and where it does not.

use super::*;
use std::f64::consts::FRAC_PI_2;

fn moved(lo: f64, hi: f64, ulps: usize) -> Interval {
    let outwards = |x: f64, step: fn(f64) -> f64| (0..ulps).fold(x, |x, _| step(x));
    Interval { lo: outwards(lo, f64::next_down), hi: outwards(hi, f64::next_up) }
}

/// All intervals between some numbers, of every sign, points too.
fn intervals_of_every_sign() -> Vec<Interval> {
    let ends = [f64::NEG_INFINITY, -3.0, -0.5, 0.0, 0.75, 2.0, f64::INFINITY];
    let pairs = ends.iter().flat_map(|&lo| ends.iter().map(move |&hi| (lo, hi)));
    pairs.filter(|(lo, hi)| lo <= hi && lo.is_finite() | hi.is_finite()).map(|(lo, hi)| Interval::new(lo, hi)).collect()
}

#[test]
fn arithmetic_moves_the_exact_bounds_by_one_unit_but_not_past_a_zero_that_is_one() {
    for a in intervals_of_every_sign() {
        for b in intervals_of_every_sign() {
            // all combinations of bounds are exact; a bound at infinity is never attained: times zero it is zero
            let of = |f: fn(f64, f64) -> f64| {
                let values = [f(a.lo, b.lo), f(a.lo, b.hi), f(a.hi, b.lo), f(a.hi, b.hi)];
                let values = values.map(|value| if value.is_nan() { 0.0 } else { value });
                let least = values.into_iter().fold(f64::INFINITY, f64::min);
                let most = values.into_iter().fold(f64::NEG_INFINITY, f64::max);
                let wide = moved(least, most, 1);
                let wide = if least >= 0.0 { Interval { lo: wide.lo.max(0.0), ..wide } } else { wide };
                if most <= 0.0 { Interval { hi: wide.hi.min(0.0), ..wide } } else { wide }
            };
            assert_eq!(a * b, of(|x, y| x * y), "{a:?} * {b:?}");
            let quotient = if b.lo <= 0.0 && b.hi >= 0.0 { Interval::LINE } else { of(|x, y| x / y) };
            assert_eq!(a / b, quotient, "{a:?} / {b:?}");
            let sum = match moved(a.lo + b.lo, a.hi + b.hi, 1) {
                wide if a.lo >= 0.0 && b.lo >= 0.0 => Interval { lo: wide.lo.max(0.0), ..wide },
                wide if a.hi <= 0.0 && b.hi <= 0.0 => Interval { hi: wide.hi.min(0.0), ..wide },
                wide => wide,
            };
            let zero = Interval::point(0.0);
            let sum = if a == zero && b == zero { zero } else { sum };
            assert_eq!((a + b, a - -b), (sum, sum), "{a:?} + {b:?}");
        }
    }
}

#[test]
fn functions_move_their_bounds_by_the_error_of_the_double_and_stay_in_their_range() {
    let x = Interval::new(0.25, 0.75);
    assert_eq!(x.sqrt(), moved(0.5, 0.75f64.sqrt(), 1));
    assert_eq!(x.squared(), moved(0.0625, 0.5625, 1));
    let increasing: [Bounded; 3] = [(Real::exp, Real::exp), (Real::ln, Real::ln), (Real::tanh, Real::tanh)];
    for (bounds, double) in increasing {
        assert_eq!(bounds(x), moved(double(0.25), double(0.75), 4));
    }
    assert_eq!(x.sin(), moved(Real::sin(0.25), Real::sin(0.75), 4));
    assert_eq!([x.cos(), x.acos()], [Real::cos, Real::acos].map(|f| moved(f(0.75), f(0.25), 4)));
    // at the ends of the domain and of the range
    let wide = Interval::new(-4.0, 4.0);
    assert_eq!(wide.sqrt(), Interval { lo: 0.0, hi: 2.0f64.next_up() });
    assert_eq!(wide.ln(), Interval { lo: f64::NEG_INFINITY, hi: moved(0.0, Real::ln(4.0), 4).hi });
    assert_eq!(wide.acos(), Interval { lo: 0.0, hi: moved(0.0, Real::acos(-1.0), 4).hi });
    assert_eq!(Interval::point(-800.0).exp().lo, 0.0);
    assert_eq!((Interval::point(-30.0).tanh().lo, Interval::point(30.0).tanh().hi), (-1.0, 1.0));
    assert_eq!([-4.0, 0.0].map(|lo| Interval::new(lo, 3.0).squared().lo), [0.0; 2]);
    assert_eq!(
        [(-2.0, -1.0), (-2.0, 1.0), (-1.0, 2.0), (1.0, 2.0)].map(|(lo, hi)| Interval::new(lo, hi).abs()),
        [Interval::new(1.0, 2.0), Interval::new(0.0, 2.0), Interval::new(0.0, 2.0), Interval::new(1.0, 2.0)]
    );
    let (a, b) = (Interval::new(-1.0, 3.0), Interval::new(0.0, 2.0));
    assert_eq!((a.min(b), a.max(b), a.hull(b)), (Interval::new(-1.0, 2.0), Interval::new(0.0, 3.0), a));
    assert_eq!(Interval::entry(&[5.0, 1.0, 4.0, 9.0], Interval::new(1.0, 2.0)), Interval::new(1.0, 4.0));
    assert!(Interval::pi().lo == PI && Interval::pi().hi == PI.next_up());
    assert!(Interval::LINE.contains(f64::NAN) && [0.0, 2.0].iter().all(|x| b.contains(*x)));
    assert!(![f64::NAN, -0.1, 2.1].iter().any(|x| b.contains(*x)));
    assert_eq!([0.0, 1.0].map(|hi| Interval { lo: 0.0, hi }.is_zero()), [true, false]);
    assert!(!Interval::new(-1.0, 0.0).is_zero());
}

#[test]
fn bounds_that_touch_decide_what_they_can() {
    let (a, b, line) = (Interval::new(0.0, 1.0), Interval::new(1.0, 2.0), Interval::LINE);
    assert_eq!((a.lt(b), b.lt(a), a.le(b), b.le(a)), {
        (Truth::Sometimes, Truth::Never, Truth::Always, Truth::Sometimes)
    });
    // what may have no value is not less than anything for certain, nor the contrary
    for end in [f64::NEG_INFINITY, 0.0, f64::INFINITY].map(Interval::point) {
        assert_eq!([end.lt(line), line.lt(end), end.le(line), line.le(end)], [Truth::Sometimes; 4]);
    }
    let truths = [Truth::Never, Truth::Sometimes, Truth::Always];
    for (k, a) in truths.into_iter().enumerate() {
        for (j, b) in truths.into_iter().enumerate() {
            assert_eq!((a & b, a | b, !a), (truths[k.min(j)], truths[k.max(j)], truths[2 - k]));
        }
    }
}

#[test]
fn crests_near_a_bound_and_large_angles_are_not_missed() {
    // too near a crest for a double to tell, and beyond it by the margin
    let rising = Interval::new(FRAC_PI_2 - 1e-9, FRAC_PI_2 - 5e-10);
    assert_eq!((rising.sin().hi, (-rising).sin().lo), (1.0, -1.0));
    assert!(rising.sin().lo > 1.0 - 1e-15);
    for (largest, known) in [(1e12, true), (1e12f64.next_up(), false)] {
        for end in [largest, -largest] {
            assert_eq!(Interval::point(end).sin() != Interval::new(-1.0, 1.0), known, "{end}");
        }
    }
    // large angles between crest and trough, and just beyond one
    for turn in 1..200 {
        let crest =
            (Reference::exact(f64::from(turn) * 5e8).floor() * Reference::pi() * Reference::exact(2.0)).to_f64();
        for crest in [crest, -crest] {
            assert!(Interval::new(crest + 1.0, crest + 1.5).cos().hi < 0.55);
            assert!(Interval::new(crest + 1.5, crest + 2.0).cos().lo > -0.5);
            let (before, after) = (Interval::new(crest - 1.0, crest), Interval::new(crest, crest + 1.0));
            let exact = Reference::exact(crest).sin().to_f64();
            assert_eq!(if exact > 0.0 { before } else { after }.cos().hi, 1.0, "{crest}");
        }
    }
}
