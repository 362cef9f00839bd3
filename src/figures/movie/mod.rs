//! A film of a run that plays by itself: an animated GIF of its frames, with stage, time and scale.

mod canvas;

use super::round::{distance, duration, round_step};
use super::view::{chosen, upwards};
use crate::error::Error;
use crate::output::{ReadFrame, RunFolder, Series, write_atomically};
use canvas::{Canvas, TEXT, palette};
use std::path::{Path, PathBuf};

/// Most frames.
const MOST_FRAMES: usize = 240;
/// Width, and bounds of the height, pixels.
const WIDTH: usize = 720;
const HEIGHTS: (usize, usize) = (240, 720);
/// Height of the stripes with texts above and below the spheres, pixels.
const STRIPE: usize = 32;
/// Space at the sides, pixels.
const MARGIN: usize = 12;
/// Time that a frame is shown, and the last one, hundredths of a second.
const DELAY: u16 = 8;
const LAST_DELAY: u16 = 150;

/// Draws the frames of a run into a file; returns their number.
///
/// # Errors
///
/// If the run has no frames, a frame cannot be read, or the file cannot be written.
pub fn movie(folder: &RunFolder, file: &Path) -> Result<usize, Error> {
    let series = Series::read(folder)?;
    let all = ReadFrame::all(folder, &series.stages())?;
    let files: Vec<&PathBuf> = chosen(all.len(), MOST_FRAMES).into_iter().map(|k| &all[k]).collect();
    let scene = Scene::of(&files)?;
    let bytes = scene.film(&files)?;
    write_atomically(file, &bytes)?;
    Ok(files.len())
}

/// The part of space that all frames show.
struct Scene {
    /// The axes to the right, upwards, and towards the eye, with the direction of the last.
    axes: [usize; 3],
    towards: f64,
    /// The lowest coordinates along the first two.
    low: [f64; 2],
    /// Pixels per nm.
    scale: f64,
    height: usize,
    /// Of a solid, which is periodic along the line of sight, the half behind its middle is shown.
    cut: bool,
}

impl Scene {
    fn of(files: &[&PathBuf]) -> Result<Self, Error> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let mut first = None;
        for file in files {
            let frame = ReadFrame::read(file)?;
            for (x, radius) in frame.centres().zip(frame.radii()) {
                for k in 0..3 {
                    low[k] = low[k].min(x[k] - radius);
                    high[k] = high[k].max(x[k] + radius);
                }
            }
            first = first.or(Some(frame));
        }
        let Some(first) = first.filter(|_| low[0] < high[0]) else {
            return Err(Error::Usage("the run has no frames with spheres to show".into()));
        };
        let up = upwards(&first);
        let axes = [0, up, 3 - up];
        let size = axes.map(|axis| high[axis] - low[axis]);
        let room = [WIDTH - 2 * MARGIN, HEIGHTS.1 - 2 * STRIPE].map(|pixels| pixels as f64);
        let scale = (room[0] / size[0]).min(room[1] / size[1]);
        let height = ((size[1] * scale).ceil() as usize + 2 * STRIPE).max(HEIGHTS.0);
        // What does not fill the picture stands in its middle.
        let middle = [WIDTH as f64 / 2.0, height as f64 / 2.0];
        let low = [0, 1].map(|k| (low[axes[k]] + high[axes[k]]) / 2.0 - middle[k] / scale);
        let towards = if up == 1 { 1.0 } else { -1.0 };
        Ok(Self { axes, towards, low, scale, height, cut: first.periodic == [true; 3] })
    }

    fn film(&self, files: &[&PathBuf]) -> Result<Vec<u8>, Error> {
        let mut bytes = Vec::new();
        let (width, height) = (WIDTH as u16, self.height as u16);
        let mut film = gif::Encoder::new(&mut bytes, width, height, &palette()).expect("memory can always grow");
        film.set_repeat(gif::Repeat::Infinite).expect("memory can always grow");
        for (k, file) in files.iter().enumerate() {
            let canvas = self.picture(&ReadFrame::read(file)?);
            let delay = if k + 1 == files.len() { LAST_DELAY } else { DELAY };
            let frame = gif::Frame { width, height, delay, buffer: canvas.pixels.into(), ..gif::Frame::default() };
            film.write_frame(&frame).expect("memory can always grow");
        }
        drop(film);
        Ok(bytes)
    }

    fn picture(&self, frame: &ReadFrame) -> Canvas {
        let mut canvas = Canvas::new(WIDTH, self.height);
        let number = |name: &str, k: usize| frame.property(name).map_or(0.0, |property| property.numbers[k]);
        let middle = frame.sides[self.axes[2]] / 2.0;
        for (k, (x, radius)) in frame.centres().zip(frame.radii()).enumerate() {
            let [right, up, near] = self.axes.map(|axis| x[axis]);
            if self.cut && self.towards * (near - middle) > 0.0 {
                continue;
            }
            let place = [
                (right - self.low[0]) * self.scale,
                self.height as f64 - (up - self.low[1]) * self.scale,
                self.towards * near * self.scale,
            ];
            canvas.ball(place, radius * self.scale, number("body", k) as usize, number("wall", k) > 0.0);
        }
        canvas.text(MARGIN, (STRIPE - TEXT) / 2, &format!("{}  {}", frame.stage, duration(frame.time)));
        let length = round_step(0.1 * WIDTH as f64 / self.scale);
        let (long, text) = ((length * self.scale).round() as usize, distance(length));
        canvas.bar(MARGIN, self.height - 10, long);
        canvas.text(2 * MARGIN + long, self.height - 4 - TEXT, &text);
        canvas
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "Lattice=\"20 0 0 0 10 0 0 0 10\" pbc=\"F F F\" Time=";
    const COLUMNS: &str = "Properties=species:S:1:body:I:1:radius:R:1:pos:R:3";

    #[test]
    fn a_film_has_all_frames_and_balls_move_in_it() {
        let place = tempfile::tempdir().expect("a folder");
        let folder = RunFolder::at(place.path());
        folder.complete().expect("folders");
        std::fs::write(folder.series(), "stage,step,time [ns]\npull,0,0\n").expect("a series");
        for (k, x) in [2.0, 9.0, 16.0].into_iter().enumerate() {
            let text = format!("1\n{HEAD}{k} stage=pull {COLUMNS}\nX 1 2 {x} 5 5\n");
            std::fs::write(folder.frames().join(format!("pull.{k:06}.xyz")), text).expect("a frame");
        }
        let file = place.path().join("movie.gif");
        assert_eq!(movie(&folder, &file).expect("a film"), 3);
        let mut film =
            gif::DecodeOptions::new().read_info(std::fs::File::open(&file).expect("a film")).expect("a film");
        let mut middles = Vec::new();
        while let Some(frame) = film.read_next_frame().expect("a frame") {
            let width = usize::from(frame.width);
            // The columns of the balls, of the second colour.
            let of = |(k, pixel): (usize, &u8)| (15..30).contains(pixel).then_some(k % width);
            let columns: Vec<usize> = frame.buffer.iter().enumerate().filter_map(of).collect();
            middles.push(columns.iter().sum::<usize>() / columns.len());
        }
        // 18 nm are 696 pixels.
        assert_eq!(middles.len(), 3);
        assert!(middles.windows(2).all(|pair| pair[1].abs_diff(pair[0] + 270) < 3), "{middles:?}");
    }

    #[test]
    fn without_frames_there_is_no_film() {
        assert!(Scene::of(&[]).is_err_and(|error| error.to_string().contains("no frames")));
    }
}
