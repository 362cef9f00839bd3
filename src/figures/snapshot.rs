//! A snapshot of the spheres, coloured by their initial body; a solid is cut open in the middle.

use super::COLOURS;
use super::round::{distance, duration, round_step};
use crate::error::Error;
use crate::output::{RunFolder, with_suffix, write_atomically};
use crate::spec::Vec3;
use crate::system::{Shape, Surface, System};
use std::fmt::Write;

/// Width of the picture, pixels.
const WIDTH: f64 = 640.0;
/// Resolution for the detection of hidden spheres, pixels per pixel of the picture.
const RESOLUTION: f64 = 0.5;

/// Draws the particles in their present state into the figures of a run, with the given axis pointing upwards.
///
/// # Errors
///
/// If the file cannot be written.
pub fn picture(folder: &RunFolder, name: &str, system: &System, upwards: usize) -> Result<(), Error> {
    let mut turned;
    let system = if upwards == 1 {
        system
    } else {
        turned = system.clone();
        turned.domain.sides.swap(1, upwards);
        turned.domain.periodic.swap(1, upwards);
        turned.particles.x.iter_mut().for_each(|x| x.0.swap(1, upwards));
        &turned
    };
    let height = system.domain.sides[1];
    let path = with_suffix(folder.figures().join(name), "svg");
    write_atomically(&path, snapshot(system, [-0.1 * height, 1.2 * height]).as_bytes())
}

/// The spheres seen along z, with x to the right and y upwards, or, in contact with surfaces, along y with z upwards; of a solid, which is periodic along z, the half behind the middle plane. The
/// frame is given by `heights`, the lowest and the highest coordinate shown, so that the pictures of a run can be compared.
pub fn snapshot(system: &System, heights: [f64; 2]) -> String {
    let scale = WIDTH / system.domain.sides[0];
    let height = (heights[1] - heights[0]) * scale;
    let p = &system.particles;
    let (up, towards) =
        if system.surfaces.is_empty() { (1, Vec3([0.0, 0.0, 1.0])) } else { (2, Vec3([0.0, -1.0, 0.0])) };
    let middle = if system.domain.periodic[2] { 0.5 * system.domain.sides[2] } else { f64::INFINITY };
    let mut order: Vec<(f64, usize)> =
        (0..p.len()).map(|i| (system.domain.folded(p.x[i]).dot(towards), i)).filter(|&(z, _)| z <= middle).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(p.id[a.1].cmp(&p.id[b.1])));
    // A sphere that crosses a side of the box is drawn at both sides.
    let mut discs = Vec::new();
    for &(_, i) in &order {
        let (x, y) = (system.domain.folded(p.x[i]).0[0] * scale, (heights[1] - p.x[i].0[up]) * scale);
        let r = p.radius[i] * scale;
        let colour = p.tag[i] as usize % COLOURS.len() + if p.wall[i] > 0 { COLOURS.len() } else { 0 };
        for x in [x, x - WIDTH, x + WIDTH] {
            if x + r > 0.0 && x - r < WIDTH {
                discs.push(Disc { x, y, r, colour });
            }
        }
    }
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height:.0}\" viewBox=\"0 0 {WIDTH} {height:.0}\">\n<defs>"
    );
    for (k, &colour) in COLOURS.iter().enumerate() {
        gradient(&mut svg, k, colour, 1.0);
        gradient(&mut svg, k + COLOURS.len(), colour, 0.55);
    }
    svg.push_str("</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    for disc in visible(&discs, height) {
        // Writing into a string cannot fail.
        let _ = writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{:.1}\" fill=\"url(#c{})\"/>",
            disc.x, disc.y, disc.r, disc.colour
        );
    }
    for surface in &system.surfaces {
        silhouette(&mut svg, surface, |x| [x.0[0] * scale, (heights[1] - x.0[up]) * scale]);
    }
    caption(&mut svg, system.time, scale, height);
    svg.push_str("</svg>\n");
    svg
}

/// The time, and a bar of a round length, on a ground that no sphere can hide.
fn caption(svg: &mut String, time: f64, scale: f64, height: f64) {
    let length = round_step(0.1 * WIDTH / scale);
    let (x, y, wide) = (WIDTH - 14.0, height - 12.0, length * scale);
    let _ = writeln!(
        svg,
        "<g font-family=\"sans-serif\" font-size=\"28\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"6\" paint-order=\"stroke\">\
         <text x=\"12\" y=\"{y:.0}\">{}</text><text x=\"{x:.0}\" y=\"{:.0}\" text-anchor=\"end\">{}</text></g>\n\
         <path d=\"M{x:.1} {y:.1}h-{wide:.1}\" stroke=\"#fff\" stroke-width=\"7\"/><path d=\"M{x:.1} {y:.1}h-{wide:.1}\" stroke=\"#111\" stroke-width=\"3\"/>",
        duration(time),
        y - 10.0,
        distance(length),
    );
}

/// A surface, shaded; for a plane, the half-space behind it within the picture.
fn silhouette(svg: &mut String, surface: &Surface, place: impl Fn(Vec3<f64>) -> [f64; 2]) {
    let mut polygon = |corners: &[Vec3<f64>]| {
        let points: Vec<String> =
            corners.iter().map(|&x| place(x + surface.way)).map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"#555\" fill-opacity=\".35\"/>", points.join(" "));
    };
    match &surface.shape {
        Shape::Mesh(mesh) => (0..mesh.triangles().len()).for_each(|t| polygon(&mesh.triangle(t))),
        Shape::Plane { point, normal } => {
            let (along, down) = (Vec3([normal.0[2], 0.0, -normal.0[0]]) * FAR, -(*normal * FAR));
            polygon(&[*point - along, *point + along, *point + along + down, *point - along + down]);
        }
    }
}

/// Beyond the frame of any picture, nm.
const FAR: f64 = 1e5;

struct Disc {
    x: f64,
    y: f64,
    r: f64,
    colour: usize,
}

/// A ball lit from the upper left.
fn gradient(svg: &mut String, name: usize, (r, g, b): (u8, u8, u8), light: f64) {
    let shade = |c: u8, factor: f64| (f64::from(c) * factor * light) as u8;
    let bright = |c: u8| ((f64::from(c) + 0.55 * (255.0 - f64::from(c))) * light) as u8;
    let _ = write!(
        svg,
        "<radialGradient id=\"c{name}\" cx=\".35\" cy=\".35\" r=\".75\"><stop offset=\"0\" stop-color=\"rgb({},{},{})\"/>\
         <stop offset=\".6\" stop-color=\"rgb({},{},{})\"/><stop offset=\"1\" stop-color=\"rgb({},{},{})\"/></radialGradient>",
        bright(r),
        bright(g),
        bright(b),
        shade(r, 1.0),
        shade(g, 1.0),
        shade(b, 1.0),
        shade(r, 0.5),
        shade(g, 0.5),
        shade(b, 0.5),
    );
}

/// The discs that are at least partly visible, in order: far fewer than all.
fn visible(discs: &[Disc], height: f64) -> impl Iterator<Item = &Disc> {
    let (columns, rows) = ((WIDTH * RESOLUTION) as usize, (height * RESOLUTION).max(1.0) as usize);
    let mut owner = vec![usize::MAX; columns * rows];
    for (k, disc) in discs.iter().enumerate() {
        let (x, y, r) = (disc.x * RESOLUTION, disc.y * RESOLUTION, disc.r * RESOLUTION);
        let span = |centre: f64, reach: f64, end: usize| {
            (((centre - reach).ceil().max(0.0)) as usize).min(end)
                ..(((centre + reach).floor() + 1.0).max(0.0) as usize).min(end)
        };
        for row in span(y, r, rows) {
            let off = row as f64 - y;
            for column in span(x, (r * r - off * off).max(0.0).sqrt(), columns) {
                owner[row * columns + column] = k;
            }
        }
    }
    let mut seen = vec![false; discs.len()];
    owner.into_iter().filter(|&k| k != usize::MAX).for_each(|k| seen[k] = true);
    discs.iter().enumerate().filter(move |(k, _)| seen[*k]).map(|(_, disc)| disc)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::hcp;

    #[test]
    fn only_the_rear_half_is_drawn_and_hidden_spheres_are_left_out() {
        let deep = hcp(1.0, [8, 4, 8], 1.0);
        let picture = snapshot(&deep, [0.0, deep.domain.sides[1]]);
        let drawn = picture.matches("<circle").count();
        // Of 16 layers the two nearest to the cut hide all others: 8 x 4 x 2 spheres each, and images across the sides.
        assert!((128..256).contains(&drawn), "{drawn}");
        assert_eq!(picture, snapshot(&deep, [0.0, deep.domain.sides[1]]));
    }

    #[test]
    fn a_picture_tells_its_time_and_its_scale() {
        let mut system = hcp(1.0, [8, 4, 8], 1.0);
        system.time = 2.5;
        let picture = snapshot(&system, [0.0, 7.0]);
        // A bar of 1 nm in a box that is 8 nm wide.
        assert!(picture.contains(">2.5 ns<") && picture.contains(">1 nm<"), "{picture}");
        assert!(picture.contains(&format!("h-{:.1}", WIDTH / system.domain.sides[0])), "{picture}");
    }

    #[test]
    fn a_sphere_across_the_side_of_the_box_is_drawn_twice() {
        let mut system = hcp(1.0, [4, 4, 2], 1.0);
        system.particles = system.particles.pick(&[0]);
        let picture = |x: f64| {
            let mut moved = system.clone();
            moved.particles.x[0].0[0] = x;
            snapshot(&moved, [0.0, 7.0]).matches("<circle").count()
        };
        assert_eq!((picture(2.0), picture(0.1), picture(-3.9)), (1, 2, 2));
    }
}
