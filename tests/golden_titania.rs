//! The trajectories of the titania paper in `golden/trajectories`, moved by the contact law.

use serde_json::Value;
use std::path::Path;
use veridem_spec::titania::Parameters;
use veridem_spec::titania::eq12_sliding::{sawtooth, sliding_spring, spring_energy};
use veridem_spec::titania::eq13_rolling::RollingOver;
use veridem_spec::{Contact, Vec3};

fn runs(name: &str) -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/trajectories").join(name);
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(file["schema"], "veridem golden trajectories 1");
    file["runs"].as_array().unwrap().clone()
}
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}
fn samples(run: &Value) -> Vec<Vec<f64>> {
    let row = |row: &Value| row.as_array().unwrap().iter().map(number).collect();
    run["samples"].as_array().unwrap().iter().map(row).collect()
}

#[test]
fn pairs_approach_and_relax_as_integrated_independently() {
    for run in runs("titania_relaxation.json") {
        let get = |key: &str| number(&run[key]);
        let (r, f_a, m_eff) = (get("r_i") + get("h_n"), get("f_a"), get("m_eff"));
        let law = Parameters {
            k_n: get("k_n"),
            r_eff: 0.5 * r,
            gamma_n: get("gamma_n"),
            tau_s: 0.0,
            tau_r: 0.0,
            lambda_t: r,
            slip: 0.0,
            inertia: 1.0,
        };
        let (samples, none) = (samples(&run), Vec3::zero());
        let (mut delta, mut rate) = (samples[0][1], samples[0][2]);
        let fastest = samples.iter().map(|sample| sample[2].abs()).fold(0.0, f64::max);
        let steps = 4000;
        for window in samples.windows(2) {
            let dt = (window[1][0] - window[0][0]) / f64::from(steps);
            for _ in 0..steps {
                let along = |x| Vec3::new(x, 0.0, 0.0);
                let c = Contact::new(along(2.0 * r - delta), along(-rate), none, none, r, r);
                rate -= law.act(RollingOver::Rolling, [r - 0.5 * delta; 2], &c, -f_a, none, dt).wrench.force.0[0]
                    / m_eff
                    * dt;
                delta += rate * dt;
            }
            // the scheme is of first order: at most a few steps ahead or behind
            let what = format!("{} at {}: {delta} {rate}, expected {window:?}", run["name"], window[1][0]);
            assert!((delta - window[1][1]).abs() < 4.0 * dt * fastest, "{what}");
            assert!((rate - window[1][2]).abs() < 5e-3 * fastest, "{what}");
        }
    }
}

#[test]
fn the_spring_slips_back_and_forth_along_the_exact_path() {
    for run in runs("titania_sawtooth.json") {
        // places are multiples of 0.05 nm: in that unit they are whole and nothing is rounded
        let unit = 0.05;
        let (tau_s, a) = (number(&run["tau_s_gpa"]), number(&run["a_nm2"]));
        let lambda = (number(&run["lambda_t_nm"]) / unit).round();
        let (x, mut xi, mut at, mut slips, mut lost) = (Vec3::new(1.0, 0.0, 0.0), Vec3::zero(), 0.0, 0, 0.0);
        for sample in samples(&run) {
            let place = (sample[0] / unit).round();
            let stretched = xi + x * (place - at);
            let (force, kept) = sliding_spring(tau_s, a, lambda, stretched, 1.0);
            if stretched.norm() >= lambda {
                slips += 1;
                let energy = |xi| unit * spring_energy(tau_s, a, lambda, xi);
                lost += energy(stretched) - energy(kept);
            }
            (xi, at) = (kept, place);
            assert!((kept.0[0] - sample[1] / unit).abs() < 1e-12, "{sample:?}");
            assert!((force.0[0] - sample[2]).abs() < 1e-12, "{sample:?}");
            let direction = x * if place < 0.0 { -1.0 } else { 1.0 };
            let printed = sawtooth(tau_s, a, place.abs(), lambda, direction).1;
            assert!((printed.0[0] - sample[3]).abs() < 1e-12, "{sample:?}");
        }
        assert_eq!(slips, run["slips"].as_u64().unwrap());
        assert!((lost - slips as f64 * number(&run["lost_per_slip_nn_nm"])).abs() < 1e-12);
    }
}
