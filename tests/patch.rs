//! Does a patch test end when its sample fails?

mod common;

use common::{column, run_to_the_end};
use veridem::output::ReadTable;

/// A small lattice that may be stretched to twice its length.
const CASE: &str = "
title: A lattice that is torn apart
model:
  wear: {young_modulus: 1 GPa, poisson_ratio: 0.15, tensile_strength: 0.2 GPa, shear_strength: 0.1 GPa, surface_energy: 1.5 N/m, restitution: 0.95, density: 1000 kg/m^3, scaling: 0.5}
sample:
  hcp: {diameter: 0.6 d_c, size: [6 d_0, 8 d_0, 3 d_0]}
experiment:
  patch: {tension: {strain_per_step: 1e-3, strain: 1}}
output: {series: 20 steps}
";

#[test]
fn a_stretched_lattice_fails_once_its_strain_is_half_as_large_again_as_at_the_peak_and_its_stress_less_than_half() {
    let (_place, folder) = run_to_the_end(CASE);
    let table = ReadTable::read(&folder.series()).expect("a series");
    let [strain, stress, step] = ["normal strain", "normal stress [MPa]", "step"].map(|header| column(&table, header));
    let fails = |row: usize| {
        let peak = (0..=row).max_by(|&a, &b| stress[a].total_cmp(&stress[b])).expect("a row");
        strain[row] > 1.5 * strain[peak] && stress[row] < 0.5 * stress[peak]
    };
    // The sample is judged every hundred steps.
    let judged: Vec<usize> = (0..step.len()).filter(|&row| step[row] > 0.0 && step[row] % 100.0 == 0.0).collect();
    let (last, before) = judged.split_last().expect("steps");
    assert_eq!(*last, step.len() - 1, "the test ends when the sample is judged");
    assert!(fails(*last) && !before.iter().any(|&row| fails(row)) && strain[*last] < 0.99, "{strain:?} {stress:?}");
}
