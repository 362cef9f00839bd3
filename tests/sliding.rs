//! Do two bodies that slide on each other have the tables that they should, on a way longer than their box?

mod common;

use common::{column, run_to_the_end};
use veridem::output::{Column, ReadTable, Series};

/// A crystal with flat faces, slid by more than its length.
const CASE: &str = "
title: A crystal
model:
  wear: {young_modulus: 73 GPa, poisson_ratio: 0.17, tensile_strength: 16 GPa, shear_strength: 9 GPa, surface_energy: 1.5 N/m, restitution: 0.5, density: 2200 kg/m^3, scaling: 0.5}
sample:
  hcp: {diameter: 3 nm, size: [4 d_0, 7 d_0, 3 d_0]}
experiment:
  sliding: {asperity_height: 0 nm, shear_velocity: 400 m/s, normal_stress: 1 GPa, duration: 1200 steps, window: 1 d_0}
output: {series: 100 steps}
";

#[test]
fn the_walls_of_a_profile_move_with_the_bodies_and_the_layer_lies_between_them() {
    let (_place, folder) = run_to_the_end(CASE);
    let (windows, profiles) = (ReadTable::read(&folder.windows()), ReadTable::read(&folder.profiles()));
    let (windows, profiles) = (windows.expect("windows"), profiles.expect("profiles"));
    let slid = column(&windows, "slid [nm]");
    let side = column(&ReadTable::read(&folder.series()).expect("a series"), "side x [nm]")[0];
    assert!(slid.len() >= 5 && *slid.last().expect("a window") > side, "{slid:?} in a box of {side} nm");
    let [time, height, velocity, displacement, spheres] =
        ["time [ns]", "height [nm]", "mean velocity [m/s]", "mean displacement [nm]", "spheres"]
            .map(|header| column(&profiles, header));
    let all = spheres.iter().sum::<f64>() / slid.len() as f64;
    let times = column(&windows, "time [ns]");
    for (&now, &slid) in times.iter().zip(&slid) {
        let layers: Vec<usize> = (0..time.len()).filter(|&row| time[row] == now).collect();
        let (low, high) = (layers[0], layers[layers.len() - 1]);
        assert!((velocity[low], displacement[low]) == (0.0, 0.0), "the lower wall rests");
        // No step back by the length of the box when a sphere leaves it.
        assert!((velocity[high] / 400.0 - 1.0).abs() < 1e-9 && (displacement[high] / slid - 1.0).abs() < 1e-9);
        assert!(layers.windows(2).all(|pair| height[pair[0]] < height[pair[1]]));
        assert_eq!(layers.iter().map(|&row| spheres[row]).sum::<f64>(), all);
    }
    let between = 7.0 * 3.0;
    for header in ["thickness of the shear layer [nm]", "thickness of the third body [nm]"] {
        let thickness = column(&windows, header);
        assert!(thickness.iter().all(|&thickness| thickness < between), "{header}: {thickness:?}");
        assert!(thickness.iter().any(|&thickness| thickness > 0.0), "{header}: {thickness:?}");
    }
    let [friction, normal, ratio] =
        ["mean friction [pN]", "mean normal force [pN]", "friction coefficient"].map(|header| column(&windows, header));
    assert!((0..slid.len()).all(|row| ratio[row] == friction[row] / normal[row]));
    let series = Series::read(&folder).expect("a series");
    let [speed, at] = ["mean velocity", "height"].map(|name| {
        let unit = if name == "height" { "nm" } else { "m/s" };
        Column { name, unit, about: "" }
    });
    assert_eq!(series.profiles("sliding", speed, at).len(), slid.len(), "a profile for every window");
    for title in ["shear layer", "third body", "velocity", "displacement"] {
        assert!(folder.figures().join(format!("{title}.svg")).exists(), "a figure of {title}");
    }
}
