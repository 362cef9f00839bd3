//! Curves against axes, linear or logarithmic, as SVG.

use super::COLOURS;
use super::page::escaped;
use super::raised::raised;
use super::ticks::Ticked;
use plotters::prelude::*;
use serde_json::json;
use std::error::Error;
use std::ops::Range;

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
        Self { label: raised(label), log: false }
    }
    /// A logarithmic axis.
    pub fn log(label: &str) -> Self {
        Self { label: raised(label), log: true }
    }

    /// The position of a value on the axis.
    fn place(&self, value: f64) -> f64 {
        if self.log { libm::log10(value) } else { value }
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

/// Size of a plot without its legend, pixels: text stays legible when a telephone shows it.
const SIZE: (i32, i32) = (520, 340);
/// Sizes of the text and of a character, pixels.
const TEXT: (i32, i32) = (13, 7);
/// Space around a plot.
const MARGIN: i32 = 12;
/// Distance of the rows of the legend.
const ROW: i32 = 18;
/// Most points of a line that are drawn: several for each pixel.
const MOST: usize = 3000;

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
    /// The plot as an SVG document, which holds the points of its curves as metadata, from which a page reads them off.
    pub fn svg(&self) -> String {
        let curves: Vec<Curve> = self.curves.iter().map(|curve| self.shown(curve)).collect();
        let mut svg = String::new();
        let scales = self.draw(&curves, &mut svg).expect("drawing into a string cannot fail");
        let read_off = curves.iter().filter(|curve| !matches!(curve.mark, Mark::Band | Mark::Guide));
        let points = |curve: &Curve| json!({ "label": curve.label, "points": curve.points.iter().map(|&(x, y)| [rounded(x), rounded(y)]).collect::<Vec<_>>() });
        let [x, y] = [(&self.x, scales[0]), (&self.y, scales[1])]
            .map(|(axis, scale)| json!({ "label": axis.label, "log": axis.log, "scale": scale }));
        let data = json!({ "x": x, "y": y, "curves": read_off.map(points).collect::<Vec<_>>() });
        let begin = svg.find('>').map_or(0, |end| end + 1);
        svg.insert_str(begin, &format!("\n<metadata>{}</metadata>", escaped(&data.to_string())));
        svg
    }

    /// The points of a curve that can be shown, and not more than can be seen.
    fn shown(&self, curve: &Curve) -> Curve {
        let finite = |&&(x, y): &&(f64, f64)| self.x.place(x).is_finite() && self.y.place(y).is_finite();
        let points: Vec<(f64, f64)> = curve.points.iter().filter(finite).copied().collect();
        let points = if curve.mark == Mark::Line { thinned(&points) } else { points };
        Curve { points, ..curve.clone() }
    }

    /// Draws the curves; returns the pixel of the origin and the length of a unit in pixels, of both axes.
    fn draw<'a>(&'a self, curves: &'a [Curve], out: &'a mut String) -> Result<[[f64; 2]; 2], Box<dyn Error + 'a>> {
        let place = |&(x, y): &(f64, f64)| (self.x.place(x), self.y.place(y));
        let all = || curves.iter().flat_map(|curve| &curve.points).map(place);
        let (across, up) = (range(all().map(|p| p.0)), range(all().map(|p| p.1)));
        let [across, up] = [(across, self.x.log), (up, self.y.log)].map(|(range, log)| Ticked::new(range, log));
        let widest = up.texts().map(width).max().unwrap_or(0);
        let (places, rows) = legend(curves);
        let root = SVGBackend::with_string(out, (SIZE.0 as u32, (SIZE.1 + rows * ROW) as u32)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(&self.title, ("sans-serif", 15))
            .margin(MARGIN)
            .margin_right(MARGIN + 8)
            .margin_bottom(MARGIN + rows * ROW)
            .x_label_area_size(44)
            // The title of the axis stands left of the longest tick.
            .y_label_area_size(widest + 34)
            .build_cartesian_2d(across.clone(), up.clone())?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .label_style(("sans-serif", TEXT.0))
            .draw()?;
        let mut next = 0;
        for (curve, entry) in curves.iter().zip(places) {
            let points: Vec<(f64, f64)> = curve.points.iter().map(place).collect();
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
            if let Some((x, y)) = entry {
                if dotted {
                    root.draw(&Circle::new((x + 9, y), 4, colour.filled()))?;
                } else {
                    root.draw(&PathElement::new([(x, y), (x + 18, y)], style))?;
                }
                root.draw(&Text::new(curve.label.as_str(), (x + 24, y - 7), ("sans-serif", TEXT.0)))?;
            }
        }
        let (across, up) = (across.range(), up.range());
        let corner = |x: f64, y: f64| chart.backend_coord(&(x, y));
        let (from, to) = (corner(across.start, up.start), corner(across.end, up.end));
        let scale = |range: &Range<f64>, from: i32, to: i32| {
            let unit = f64::from(to - from) / (range.end - range.start);
            [f64::from(from) - unit * range.start, unit]
        };
        let scales = [scale(&across, from.0, to.0), scale(&up, from.1, to.1)];
        root.present()?;
        Ok(scales)
    }
}

/// The width of a text, pixels.
fn width(text: &str) -> i32 {
    TEXT.1 * text.chars().count() as i32
}

/// The places of the entries of a legend, in rows below the plot, where they hide nothing, and the number of rows.
fn legend(curves: &[Curve]) -> (Vec<Option<(i32, i32)>>, i32) {
    let (mut x, mut row) = (2 * MARGIN, -1);
    let mut places = Vec::new();
    for curve in curves {
        let wide = 40 + width(&curve.label);
        if curve.label.is_empty() || curve.mark == Mark::Band {
            places.push(None);
            continue;
        }
        if row < 0 || x + wide > SIZE.0 {
            (x, row) = (2 * MARGIN, row + 1);
        }
        places.push(Some((x, SIZE.1 + row * ROW)));
        x += wide;
    }
    (places, row + 1)
}

/// The lowest and the highest of the points that follow each other, where there are more than can be seen.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= MOST {
        return points.to_vec();
    }
    let parts = points.chunks(points.len().div_ceil(MOST / 2));
    let ends = parts.flat_map(|part| {
        let places = || (0..part.len()).map(|k| (part[k].1, k));
        let low = places().min_by(|a, b| a.0.total_cmp(&b.0)).map_or(0, |least| least.1);
        let high = places().max_by(|a, b| a.0.total_cmp(&b.0)).map_or(0, |most| most.1);
        let both = [low.min(high), low.max(high)];
        both.into_iter().take(if low == high { 1 } else { 2 }).map(|k| part[k])
    });
    ends.collect()
}

/// A coordinate with as many digits as can be read off.
fn rounded(value: f64) -> f64 {
    format!("{value:.6e}").parse().expect("a number that was just written")
}

/// A range a little wider than the values.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
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
    fn a_title_stands_beside_its_ticks() {
        let mut plot = plot(false, vec![(0.0, -2e-6), (1.0, 1.5e-6)]);
        plot.y.label = "relative residual".into();
        let svg = plot.svg();
        // A turned text stands at the middle of its place, ticks end at theirs.
        let places: Vec<(f64, String)> = svg
            .split("<text ")
            .skip(1)
            .filter_map(|text| {
                let x = text.strip_prefix("x=\"")?.split('"').next()?.parse().ok()?;
                Some((x, text.split('>').nth(1)?.split('<').next()?.trim().to_string()))
            })
            .collect();
        let title = places.iter().find(|(_, text)| text == "relative residual").expect("a title").0;
        let ticks: Vec<_> = places.iter().filter(|(_, text)| text.ends_with("e-6")).collect();
        assert!(ticks.len() > 2, "{svg}");
        for (x, text) in ticks {
            assert!(x - f64::from(width(text)) > title + 10.0, "{text} at {x} lies on the title at {title}");
        }
    }

    #[test]
    fn a_long_line_keeps_its_peaks_and_its_points_are_read_off() {
        let points: Vec<(f64, f64)> =
            (0..100_000).map(|k| (f64::from(k), if k == 77_777 { 9.0 } else { 0.0 })).collect();
        let few = thinned(&points);
        assert!(few.len() <= MOST && few.contains(&(77_777.0, 9.0)), "{}", few.len());
        let svg = plot(false, vec![(1.0, 2.0), (3.0, 4.0)]).svg();
        assert!(svg.contains("&quot;points&quot;:[[1.0,2.0],[3.0,4.0]]"), "{svg}");
    }
}
