//! A picture of balls, bars and texts in a palette of at most 256 colours.

use super::super::COLOURS;
use font8x8::{BASIC_FONTS, LATIN_FONTS, UnicodeFonts};

/// Shades of each colour, the darkest first.
const SHADES: usize = 15;
/// The direction of the light: from the upper left, in front.
const LIGHT: [f64; 3] = [-0.45, 0.55, 0.704];
/// Pixels of the picture for each of a letter.
const LETTER: usize = 2;
/// Size of a letter, pixels.
pub(super) const TEXT: usize = 8 * LETTER;
/// The places in the palette of white and black, after the shades of all colours, bright and dark.
const WHITE: u8 = (2 * COLOURS.len() * SHADES) as u8;
const BLACK: u8 = WHITE + 1;

/// Red, green and blue of every colour.
pub(super) fn palette() -> Vec<u8> {
    let shade = |(r, g, b): (u8, u8, u8), light: f64, k: usize| {
        let part = k as f64 / (SHADES - 1) as f64;
        [r, g, b].map(|c| {
            let c = f64::from(c);
            // From a dark rim through the colour to a highlight.
            let lit = if part < 0.75 {
                c * (0.35 + 0.65 * part / 0.75)
            } else {
                c + (255.0 - c) * 0.6 * (part - 0.75) / 0.25
            };
            (light * lit) as u8
        })
    };
    let of =
        |light: f64| COLOURS.iter().flat_map(move |&colour| (0..SHADES).flat_map(move |k| shade(colour, light, k)));
    of(1.0).chain(of(0.55)).chain([255, 255, 255, 17, 17, 17]).collect()
}

/// A picture under construction: the place of each pixel in the palette, and its distance towards the eye.
pub(super) struct Canvas {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) pixels: Vec<u8>,
    near: Vec<f64>,
}

impl Canvas {
    pub(super) fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Self { width, height, pixels: vec![WHITE; count], near: vec![f64::NEG_INFINITY; count] }
    }

    /// A ball in front of what lies behind it; everything in pixels, upwards and towards the eye.
    pub(super) fn ball(&mut self, [x, y, z]: [f64; 3], r: f64, colour: usize, dark: bool) {
        let first = SHADES * (colour % COLOURS.len() + if dark { COLOURS.len() } else { 0 });
        let span = |middle: f64, end: usize| {
            ((middle - r).ceil().max(0.0) as usize)..((middle + r + 1.0).floor().max(0.0) as usize).min(end)
        };
        for row in span(y, self.height) {
            for column in span(x, self.width) {
                let (right, up) = (column as f64 - x, y - row as f64);
                let square = r * r - right * right - up * up;
                if square < 0.0 {
                    continue;
                }
                let out = square.sqrt();
                let place = row * self.width + column;
                if z + out > self.near[place] {
                    self.near[place] = z + out;
                    let lit = (right * LIGHT[0] + up * LIGHT[1] + out * LIGHT[2]) / r;
                    self.pixels[place] = (first + (lit.clamp(0.0, 1.0) * (SHADES - 1) as f64).round() as usize) as u8;
                }
            }
        }
    }

    /// A black bar with its lower left corner at this pixel.
    pub(super) fn bar(&mut self, x: usize, y: usize, long: usize) {
        for row in y.saturating_sub(3)..y {
            for column in x..(x + long).min(self.width) {
                self.pixels[row * self.width + column] = BLACK;
            }
        }
    }

    /// A text in black on white with its upper left corner at this pixel.
    pub(super) fn text(&mut self, x: usize, y: usize, text: &str) {
        for (k, letter) in text.chars().enumerate() {
            let rows = BASIC_FONTS.get(letter).or_else(|| LATIN_FONTS.get(letter)).unwrap_or_default();
            for (down, across) in (0..TEXT).flat_map(|down| (0..TEXT).map(move |across| (down, across))) {
                let (row, column) = (y + down, x + k * TEXT + across);
                if row < self.height && column < self.width {
                    let inked = rows[down / LETTER] >> (across / LETTER) & 1 == 1;
                    self.pixels[row * self.width + column] = if inked { BLACK } else { WHITE };
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_ball_hides_the_other_in_any_order() {
        let drawn = |order: [usize; 2]| {
            let mut canvas = Canvas::new(20, 20);
            order.iter().for_each(|&k| canvas.ball([10.0, 10.0, k as f64], 5.0, k, false));
            canvas.pixels
        };
        assert_eq!(drawn([0, 1]), drawn([1, 0]));
        let colour = drawn([0, 1])[10 * 20 + 10] as usize / SHADES;
        assert_eq!(colour, 1);
        assert_eq!(drawn([0, 1])[0], WHITE);
    }

    #[test]
    fn a_palette_has_few_enough_colours() {
        let palette = palette();
        assert_eq!(palette.len(), 3 * (BLACK as usize + 1));
        assert_eq!(palette[3 * WHITE as usize..], [255, 255, 255, 17, 17, 17]);
    }

    #[test]
    fn letters_are_drawn_and_nothing_outside_of_the_picture() {
        let mut canvas = Canvas::new(40, 10);
        canvas.text(0, 0, "1 µs and more than fits");
        canvas.bar(30, 10, 100);
        assert!(canvas.pixels.iter().filter(|&&pixel| pixel == BLACK).count() > 60);
    }
}
