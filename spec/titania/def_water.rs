//! The water: pressure and curvature of a meniscus, thickness of the layer, surface tension.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// Not in the paper, Kelvin's equation: suction in a meniscus that is in equilibrium with humid air, and its radius of curvature.
///
/// ```math
/// P_c = \frac{k_B T}{V} \ln\frac{1}{\text{RH}}, \quad r_K = \frac{\gamma}{P_c}
/// ```
///
/// # Reading
///
/// Classical capillarity, on which the paper builds. $V$ is the volume of a molecule: the quotient is the gas constant times the temperature over the
/// molar volume, 138.2 MPa for water at 300 K. At a humidity of one half the suction is 95.8 MPa whatever the surface tension.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | N/m | > 0 | surface tension |
/// | `kt` | $k_B T$ | J | > 0 | thermal energy |
/// | `volume` | $V$ | m^3 | > 0 | volume of a molecule of the liquid |
/// | `rh` | $\text{RH}$ | 1 | (0, 1) | relative humidity |
/// | → `suction` | $P_c$ | Pa | | pressure of the air minus pressure of the liquid |
/// | → `r_k` | $r_K$ | m | | Kelvin radius |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `vapour_above_a_meniscus_of_that_curvature_has_the_humidity`
/// * `water_at_room_temperature_and_half_humidity_has_96_megapascal`
#[inline]
pub fn kelvin<R: Real>(gamma: R, kt: R, volume: R, rh: R) -> (R, R) {
    let suction = -(kt / volume * rh.ln());
    (suction, gamma / suction)
}

/// Piecewise linear interpolation of the given points `(x, y)`, with `x` starting at zero; constant beyond the last.
#[inline]
fn broken_line<R: Real, const N: usize>(x: R, points: [(f64, f64); N]) -> R {
    let last = points[N - 1];
    let cases = std::array::from_fn::<_, N, _>(|k| {
        let ((x_0, y_0), (x_1, y_1)) = (points[k], points[(k + 1).min(N - 1)]);
        let slope = if x_1 > x_0 { (R::lit(y_1) - R::lit(y_0)) / (R::lit(x_1) - R::lit(x_0)) } else { R::zero() };
        (x.lt(R::lit(x_1)), R::lit(y_0) + slope * (x - R::lit(x_0)))
    });
    piecewise(cases, R::lit(last.1))
}

/// Not in the paper: thickness of the free water layer as a function of humidity.
///
/// ```math
/// h_w = h_w(\text{RH})
/// ```
///
/// # Reading
///
/// The table of the authors' program, for oxide particles of 10 nm, interpolated linearly; 0.438 nm at half humidity, within the $0.41 \pm 0.03$ nm
/// that the paper states. It bounds the meniscus; contact begins at the thinner compressed layer.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rh` | $\text{RH}$ | 1 | [0, 1] | relative humidity |
/// | `nanometre` | $\text{nm}$ | m | > 0 | a nanometre in the caller's units |
/// | → `h_w` | $h_w$ | m | | thickness of the layer |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_layer_grows_with_the_humidity`
/// * `the_layer_is_that_of_the_paper_at_half_humidity`
/// * `the_layer_has_the_points_of_the_table_and_lines_between_them`
#[inline]
pub fn water_layer<R: Real>(rh: R, nanometre: R) -> R {
    let points = [
        (0.0, 0.262533),
        (0.123667, 0.262533),
        (0.247692, 0.330526),
        (0.422529, 0.4097),
        (0.629865, 0.486277),
        (0.793, 0.574083),
        (0.897458, 0.697542),
        (0.951875, 0.809125),
    ];
    broken_line(rh, points) * nanometre
}

/// Not in the paper: surface tension of the adsorbed water as a function of size and humidity.
///
/// ```math
/// \gamma = \text{scale} \cdot \gamma_0(d_\text{core}, \text{RH})
/// ```
///
/// # Reading
///
/// The tables of the authors' program, computed for the water model TIP3P and particles of 4, 6, 8 and 10 nm: linear in the humidity, the nearest size
/// below 5, 7, 9 nm and above. The size is the core diameter of the smaller particle. The scale of 0.072/0.04729279 converts the tension of TIP3P into
/// the tension of water; one leaves it unchanged. Rounded to a thousandth of the unit N/m, as there. The steps from size to size make the stiffness of
/// Eq. 9 fall between 5 and 6 nm and between 9 and 10 nm.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d_core` | $d_\text{core}$ | m | > 0 | core diameter of the smaller particle |
/// | `rh` | $\text{RH}$ | 1 | [0, 1] | relative humidity |
/// | `scale` | $\text{scale}$ | 1 | > 0 | tension relative to that of TIP3P |
/// | `nanometre` | $\text{nm}$ | m | > 0 | a nanometre in the caller's units |
/// | `newton_per_metre` | $\text{N/m}$ | N/m | > 0 | a newton per metre in the caller's units |
/// | → `gamma` | $\gamma$ | N/m | | surface tension |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `at_half_humidity_it_has_four_values`
/// * `water_is_less_tense_the_more_humid_the_air`
/// * `the_tension_has_the_points_of_the_four_tables_and_lines_between_them`
#[inline]
pub fn surface_tension<R: Real>(d_core: R, rh: R, scale: R, nanometre: R, newton_per_metre: R) -> R {
    let four = [
        (0.0, 0.109052),
        (0.184389, 0.109052),
        (0.402225, 0.095479),
        (0.577136, 0.081527),
        (0.725398, 0.06858),
        (0.897598, 0.063857),
        (1.028767, 0.058307),
    ];
    let six = [
        (0.0, 0.107892),
        (0.131611, 0.107892),
        (0.286943, 0.086195),
        (0.59432, 0.065728),
        (0.826887, 0.060347),
        (1.0, 0.0523),
    ];
    let eight = [
        (0.0, 0.098067),
        (0.134375, 0.098067),
        (0.261, 0.090194),
        (0.578747, 0.064652),
        (0.796143, 0.057125),
        (1.0, 0.0523),
    ];
    let ten = [
        (0.0, 0.081457),
        (0.123667, 0.081457),
        (0.247692, 0.067124),
        (0.422529, 0.062073),
        (0.629865, 0.055896),
        (0.793, 0.053576),
        (0.897458, 0.051417),
        (0.951875, 0.0523),
    ];
    let below = |size: f64| d_core.lt(R::lit(size) * nanometre);
    let small =
        [(below(5.0), broken_line(rh, four)), (below(7.0), broken_line(rh, six)), (below(9.0), broken_line(rh, eight))];
    let thousandths = R::lit(1000.0) * scale * piecewise(small, broken_line(rh, ten));
    (thousandths + R::lit(0.5)).floor() / R::lit(1000.0) * newton_per_metre
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_water.rs", "titania-kelvin", [], kelvin),
        equation!("titania/def_water.rs", "titania-water-layer", [], water_layer),
        equation!("titania/def_water.rs", "titania-surface-tension", [], surface_tension),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    const WATER: f64 = 0.072 / 0.04729279;

    proptest! {
        #[test]
        fn vapour_above_a_meniscus_of_that_curvature_has_the_humidity(gamma in 0.01..1.0f64, kt in 0.1..1.0, volume in 0.1..1.0, rh in 0.01..0.99) {
            let (suction, r_k) = kelvin(gamma, kt, volume, rh);
            prop_assert!(relative_eq!((-(gamma / r_k) * volume / kt).exp(), rh, max_relative = 1e-13));
            prop_assert!(relative_eq!(gamma / r_k, suction, max_relative = 1e-14));
        }

        #[test]
        fn the_layer_grows_with_the_humidity(rh in 0.0..1.0, more in 0.0..1.0) {
            prop_assert!(water_layer(rh + more * (1.0 - rh), 1.0) >= water_layer(rh, 1.0));
        }

        #[test]
        fn water_is_less_tense_the_more_humid_the_air(d in 3.0..23.0, rh in 0.0..0.89, more in 0.0..1.0) {
            let tension = |rh| surface_tension(d, rh, WATER, 1.0, 1.0);
            prop_assert!(tension(rh + more * (0.89 - rh)) <= tension(rh));
        }
    }

    #[test]
    fn water_at_room_temperature_and_half_humidity_has_96_megapascal() {
        let (suction, r_k) = kelvin(0.108, 8.314462175 * 300.0, 1.8047731e-5, 0.5);
        assert!(relative_eq!(suction, 95.798e6, max_relative = 1e-5));
        assert!(relative_eq!(r_k, 1.127367e-9, max_relative = 1e-6));
    }

    #[test]
    fn the_layer_is_that_of_the_paper_at_half_humidity() {
        assert!((water_layer(0.5, 1.0) - 0.4383).abs() < 1e-4);
        assert!((water_layer(0.5f64, 1.0) - 0.41).abs() < 0.03);
        for (rh, h_w) in [(0.2, 0.304), (0.35, 0.377), (0.65, 0.497), (0.8, 0.582), (0.9, 0.703), (1.0, 0.809125)] {
            assert!((water_layer(rh, 1.0) - h_w).abs() < 6e-4, "{rh}");
        }
    }

    #[test]
    fn the_layer_has_the_points_of_the_table_and_lines_between_them() {
        let points = [
            (0.0, 262533),
            (0.123667, 262533),
            (0.247692, 330526),
            (0.422529, 409700),
            (0.629865, 486277),
            (0.793, 574083),
            (0.897458, 697542),
            (0.951875, 809125),
        ];
        are_points_of(&points, |rh| water_layer(rh, 1.0));
        assert_eq!(water_layer(1.0, 1.0), 0.809125);
    }

    #[test]
    fn the_tension_has_the_points_of_the_four_tables_and_lines_between_them() {
        let four = [
            (0.0, 109052),
            (0.184389, 109052),
            (0.402225, 95479),
            (0.577136, 81527),
            (0.725398, 68580),
            (0.897598, 63857),
            (1.028767, 58307),
        ];
        let six =
            [(0.0, 107892), (0.131611, 107892), (0.286943, 86195), (0.59432, 65728), (0.826887, 60347), (1.0, 52300)];
        let eight =
            [(0.0, 98067), (0.134375, 98067), (0.261, 90194), (0.578747, 64652), (0.796143, 57125), (1.0, 52300)];
        let ten = [
            (0.0, 81457),
            (0.123667, 81457),
            (0.247692, 67124),
            (0.422529, 62073),
            (0.629865, 55896),
            (0.793, 53576),
            (0.897458, 51417),
            (0.951875, 52300),
        ];
        for (sizes, points) in
            [([3.0, 4.999], &four[..]), ([5.0, 6.999], &six), ([7.0, 8.999], &eight), ([9.0, 23.0], &ten)]
        {
            for d_core in sizes {
                // a scale of a thousand: rounded to a millionth instead of a thousandth
                are_points_of(points, |rh| surface_tension(d_core, rh, 1000.0, 1.0, 1.0) / 1000.0);
            }
        }
        // the size in nanometres, the tension in newton per metre, rounded to the nearest thousandth
        let tension = |scale: f64| surface_tension(9.0 * 1e-9, 1.0, scale, 1e-9, 2.0) / 2.0;
        assert_eq!([tension(1.0), tension(0.0534 / 0.0523), tension(0.0536 / 0.0523)], [0.052, 0.053, 0.054]);
    }

    /// A function has these values, in millionths, and between two of them their mean halfway.
    fn are_points_of(points: &[(f64, i32)], function: impl Fn(f64) -> f64) {
        let millionths = |x: f64| function(x) * 1e6;
        for &(x, y) in points {
            assert!((millionths(x) - f64::from(y)).abs() < 1e-6, "{x}");
        }
        for ends in points.windows(2) {
            let mean = 0.5 * f64::from(ends[0].1 + ends[1].1);
            assert!((millionths(0.5 * (ends[0].0 + ends[1].0)) - mean).abs() < 0.51, "{ends:?}");
        }
    }

    #[test]
    fn at_half_humidity_it_has_four_values() {
        for (d_core, gamma) in
            [(4.9, 0.133), (5.1, 0.110), (6.9, 0.110), (7.1, 0.108), (8.9, 0.108), (9.1, 0.091), (22.0, 0.091)]
        {
            assert_eq!(surface_tension(d_core, 0.5, WATER, 1.0, 1.0), gamma);
        }
        for (rh, gamma) in [(0.2, 0.143), (0.35, 0.126), (0.65, 0.095), (0.8, 0.087), (0.9, 0.083)] {
            assert_eq!(surface_tension(7.43, rh, WATER, 1.0, 1.0), gamma);
        }
    }
}
