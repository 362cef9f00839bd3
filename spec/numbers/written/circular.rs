//! Sine and cosine.

use super::polynomial;
use crate::numbers::bits::{Bits, ROUND};
use crate::piecewise;

/// Angles from here on, 2^20 quarter turns, have no sine and no cosine here: their remainder needs hundreds of bits of pi.
pub const LARGEST_ANGLE: f64 = 1_647_099.0;

/// pi/2 in four parts: the first three have 33 bits each. What remains after one, two and three of them.
const PARTS: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];
const REST: [f64; 3] = [6.077_100_506_506_192e-11, 2.022_266_248_795_950_6e-21, 8.478_427_660_368_9e-32];

/// Up to here an angle is reduced by a multiple of pi/2 that depends on these borders.
const BORDERS: [f64; 4] =
    [2.356_195_449_829_101_6, 3.926_992_416_381_836, 5.497_791_290_283_203, 7.068_588_256_835_937_5];
/// Near multiples of pi/2, where most bits cancel.
const NEAR: [[f64; 2]; 4] = [
    [1.570_796_012_878_418, 1.570_796_966_552_734_4],
    [3.141_592_025_756_836, 3.141_593_933_105_468_8],
    [4.712_387_084_960_937_5, 4.712_390_899_658_203],
    [6.283_184_051_513_672, 6.283_187_866_210_937_5],
];

/// The quarter turns, from 0 to 3, below an angle, and what remains of the angle in two parts.
fn reduced<R: Bits>(x: R) -> (R, R, R) {
    let (zero, one) = (R::zero(), R::one());
    let size = x.abs();
    let near = NEAR.map(|[from, to]| size.ge(R::lit(from)) & size.lt(R::lit(to)));
    let direct = size.lt(R::lit(BORDERS[3])) & !(near[0] | near[1] | near[2] | near[3]);
    let [first, second, third, _] = BORDERS.map(|border| size.lt(R::lit(border)));
    let count = piecewise([(first, one), (second, R::lit(2.0)), (third, R::lit(3.0))], R::lit(4.0));
    let counted = R::select(x.lt(zero), -count, count);
    let rounded = x * R::lit(std::f64::consts::FRAC_2_PI) + R::lit(ROUND) - R::lit(ROUND);
    let n = R::select(direct, counted, rounded);

    let mut r = x - n * R::lit(PARTS[0]);
    let mut w = n * R::lit(REST[0]);
    let mut y = r - w;
    let mut again = !direct;
    for (k, lost) in [(1, 16.0), (2, 49.0)] {
        again = again & (x.exponent() - y.exponent()).gt(R::lit(lost));
        let part = n * R::lit(PARTS[k]);
        let left = r - part;
        let rest = n * R::lit(REST[k]) - ((r - left) - part);
        (r, w) = (R::select(again, left, r), R::select(again, rest, w));
        y = r - w;
    }
    let quarters = n - R::lit(4.0) * (n * R::lit(0.25)).floor();
    (quarters, y, (r - y) - w)
}

const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_007e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// `x^3`, and the part of the sine's series that it is multiplied with from the second coefficient on.
fn sine_series<R: Bits>(x: R) -> (R, R, R) {
    let z = x * x;
    let w = z * z;
    let r = polynomial(z, [SINE[1], SINE[2], SINE[3]]) + z * w * polynomial(z, [SINE[4], SINE[5]]);
    (z, z * x, r)
}

/// Sine of an angle in two parts, of at most pi/4.
fn sine_of_parts<R: Bits>(x: R, y: R) -> R {
    let (z, v, r) = sine_series(x);
    x - ((z * (R::lit(0.5) * y - v * r) - y) - v * R::lit(SINE[0]))
}

/// Cosine of an angle in two parts, of at most pi/4.
fn cosine_of_parts<R: Bits>(x: R, y: R) -> R {
    let z = x * x;
    let w = z * z;
    let r =
        z * polynomial(z, [COSINE[0], COSINE[1], COSINE[2]]) + w * w * polynomial(z, [COSINE[3], COSINE[4], COSINE[5]]);
    let half = R::lit(0.5) * z;
    let head = R::one() - half;
    head + (((R::one() - head) - half) + (z * r - x * y))
}

/// An angle below which there is nothing to reduce: pi/4.
const SMALL: f64 = 0.785_398_483_276_367_2;

/// Sine of an angle in radians.
pub fn sin<R: Bits>(x: R) -> R {
    let (z, v, r) = sine_series(x);
    let small = x + v * (R::lit(SINE[0]) + z * r);
    let (quarters, y_0, y_1) = reduced(x);
    let (sine, cosine) = (sine_of_parts(y_0, y_1), cosine_of_parts(y_0, y_1));
    let size = x.abs();
    let cases = [
        (size.lt(R::lit(1.490_116_119_384_765_6e-8)), x),
        (size.lt(R::lit(SMALL)), small),
        (size.ge(R::lit(LARGEST_ANGLE)), R::lit(f64::NAN)),
        (quarters.lt(R::one()), sine),
        (quarters.lt(R::lit(2.0)), cosine),
        (quarters.lt(R::lit(3.0)), -sine),
    ];
    piecewise(cases, -cosine)
}

/// Cosine of an angle in radians.
pub fn cos<R: Bits>(x: R) -> R {
    let small = cosine_of_parts(x, R::zero());
    let (quarters, y_0, y_1) = reduced(x);
    let (sine, cosine) = (sine_of_parts(y_0, y_1), cosine_of_parts(y_0, y_1));
    let size = x.abs();
    let cases = [
        (size.lt(R::lit(1.053_670_928_286_010_2e-8)), R::one()),
        (size.lt(R::lit(SMALL)), small),
        (size.ge(R::lit(LARGEST_ANGLE)), R::lit(f64::NAN)),
        (quarters.lt(R::one()), cosine),
        (quarters.lt(R::lit(2.0)), -sine),
        (quarters.lt(R::lit(3.0)), -cosine),
    ];
    piecewise(cases, sine)
}
