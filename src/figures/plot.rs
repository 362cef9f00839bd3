//! Curves against axes, linear or logarithmic, as SVG.

use super::COLOURS;
use plotters::prelude::*;

/// An axis of a plot.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Its label, with unit.
    pub label: String,
    /// Whether it is logarithmic; values that are not positive are then omitted.
    pub log: bool,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str) -> Self {
        Self { label: label.into(), log: false }
    }
    /// A logarithmic axis.
    pub fn log(label: &str) -> Self {
        Self { label: label.into(), log: true }
    }

    /// The position of a value on the axis.
    fn place(&self, value: f64) -> f64 {
        if self.log { libm::log10(value) } else { value }
    }

    /// The label of a tick.
    fn tick(&self, place: f64) -> String {
        let value = if self.log { libm::exp10(place) } else { place };
        if value == 0.0 {
            return "0".into();
        }
        let digits = (2.0 - libm::log10(value.abs()).floor()).clamp(0.0, 12.0) as usize;
        let text = format!("{value:.digits$}");
        let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        // A tick at zero may be off by rounding.
        if short == "-0" { "0" } else { short }.into()
    }
}

/// The style of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Points joined by a line.
    Line,
    /// Filled dots joined by a thin line.
    Dots,
    /// Filled dots only, for events.
    Points,
    /// A thin grey line: a target, a theory.
    Guide,
    /// A shaded area within a closed line, in the colour of the next curve.
    Band,
}

/// A curve and its name.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its entry in the legend; empty for none.
    pub label: String,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// Its style.
    pub mark: Mark,
}

impl Curve {
    /// A named curve.
    pub fn new(label: impl Into<String>, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, mark }
    }

    /// The area within `(x, y, margin)` of a curve.
    pub fn band(points: &[(f64, f64, f64)]) -> Self {
        let upper = points.iter().map(|&(x, y, margin)| (x, y + margin));
        let lower = points.iter().rev().map(|&(x, y, margin)| (x, y - margin));
        Self::new("", Mark::Band, upper.chain(lower).collect())
    }
}

/// Width of a plot without its legend, pixels.
const PLOT: i32 = 640;

/// A plot.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Its title.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Its curves.
    pub curves: Vec<Curve>,
}

impl Plot {
    /// The plot as an SVG document.
    pub fn svg(&self) -> String {
        let mut out = String::new();
        self.draw(&mut out).expect("drawing into a string cannot fail");
        out
    }

    fn draw(&self, out: &mut String) -> Result<(), Box<dyn std::error::Error + '_>> {
        let placed: Vec<Vec<(f64, f64)>> = self.curves.iter().map(|curve| self.placed(curve)).collect();
        // The legend stands beside the plot, where it hides nothing.
        let longest = self.curves.iter().map(|curve| curve.label.chars().count() as u32).max().unwrap_or(0);
        let legend = if longest > 0 { 40 + 7 * longest } else { 0 };
        let root = SVGBackend::with_string(out, (PLOT as u32 + legend, 420)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(&self.title, ("sans-serif", 17))
            .margin(12)
            .margin_right(12 + legend)
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(
                range(placed.iter().flatten().map(|p| p.0)),
                range(placed.iter().flatten().map(|p| p.1)),
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_label_formatter(&|place| self.x.tick(*place))
            .y_label_formatter(&|place| self.y.tick(*place))
            .label_style(("sans-serif", 13))
            .draw()?;
        let (mut next, mut line) = (0, 40);
        for (curve, points) in self.curves.iter().zip(placed) {
            let (r, g, b) = COLOURS[next % COLOURS.len()];
            let colour = if curve.mark == Mark::Guide { RGBColor(140, 140, 140) } else { RGBColor(r, g, b) };
            if curve.mark == Mark::Band {
                chart.draw_series(std::iter::once(Polygon::new(points, colour.mix(0.15))))?;
                continue;
            }
            next += usize::from(curve.mark != Mark::Guide);
            let style = ShapeStyle::from(&colour).stroke_width(if curve.mark == Mark::Line { 2 } else { 1 });
            let dotted = matches!(curve.mark, Mark::Dots | Mark::Points);
            let joined = if curve.mark == Mark::Points { &[] } else { &points[..] };
            if dotted {
                chart.draw_series(points.iter().map(|&p| Circle::new(p, 4, colour.filled())))?;
            }
            chart.draw_series(LineSeries::new(joined.iter().copied(), style))?;
            if !curve.label.is_empty() {
                if dotted {
                    root.draw(&Circle::new((PLOT + 9, line), 4, colour.filled()))?;
                } else {
                    root.draw(&PathElement::new([(PLOT, line), (PLOT + 18, line)], style))?;
                }
                root.draw(&Text::new(curve.label.as_str(), (PLOT + 24, line - 7), ("sans-serif", 13)))?;
                line += 18;
            }
        }
        root.present()?;
        Ok(())
    }

    fn placed(&self, curve: &Curve) -> Vec<(f64, f64)> {
        let places = curve.points.iter().map(|&(x, y)| (self.x.place(x), self.y.place(y)));
        places.filter(|(x, y)| x.is_finite() && y.is_finite()).collect()
    }
}

/// A range a little wider than the values.
fn range(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return 0.0..1.0;
    }
    let margin = if high > low { 0.05 * (high - low) } else { 0.5 * high.abs().max(1e-12) };
    low - margin..high + margin
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(log: bool, points: Vec<(f64, f64)>) -> Plot {
        let axis = |label| if log { Axis::log(label) } else { Axis::linear(label) };
        Plot { title: "title".into(), x: axis("x"), y: axis("y"), curves: vec![Curve::new("", Mark::Dots, points)] }
    }

    #[test]
    fn every_point_that_can_be_shown_is_a_dot() {
        let dots = |plot: Plot| plot.svg().matches("<circle").count();
        assert_eq!(dots(plot(false, vec![(0.0, 1.0), (1.0, -2.0), (f64::NAN, 1.0)])), 2);
        assert_eq!(dots(plot(true, vec![(0.0, 1.0), (1.0, 2.0), (10.0, 3.0), (1.0, -1.0)])), 2);
        assert_eq!(dots(plot(false, Vec::new())), 0);
    }

    #[test]
    fn a_band_is_one_area_in_the_colour_of_its_curve() {
        let mut plot = plot(false, vec![(0.0, 1.0), (1.0, 2.0)]);
        plot.curves.insert(0, Curve::band(&[(0.0, 1.0, 0.5), (1.0, 2.0, 0.5)]));
        let svg = plot.svg();
        assert_eq!((svg.matches("<polygon").count(), svg.matches("#0072B2").count() > 2), (1, true), "{svg}");
    }

    #[test]
    fn ticks_are_written_without_needless_digits() {
        let axis = Axis::log("x");
        assert_eq!(axis.tick(2.0), "100");
        assert_eq!(axis.tick(-2.0), "0.01");
        assert_eq!([0.0, -3e-17].map(|place| Axis::linear("x").tick(place)), ["0", "0"]);
        assert_eq!(Axis::linear("x").tick(2500.0), "2500");
    }
}
