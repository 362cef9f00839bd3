use std::time::Instant;
use veridem::build::*;
use veridem::observe::links;
use veridem::reproduce::experiment::*;
use veridem::spec::wear::Material;
fn main() {
    let a: Vec<String> = std::env::args().skip(1).collect();
    let f = |k: usize| a[k].parse::<f64>().unwrap();
    let m = |nu, s| Material {
        young_modulus: 1.0,
        poisson_ratio: nu,
        tensile_strength: 0.2,
        shear_strength: 0.1,
        surface_energy: 1.5,
        restitution: 0.95,
        scaling: s,
    };
    let sio2 = Material {
        young_modulus: 73000.0,
        poisson_ratio: 0.17,
        tensile_strength: 16000.0,
        shear_strength: 9000.0,
        surface_energy: 1500.0,
        restitution: 0.9,
        scaling: 0.5,
    };
    let t = Instant::now();
    match a[0].as_str() {
        "hcp" => {
            // nu s ratio L
            let (nu, s, d, l) = (f(1), f(2), f(3) * 150.0, f(4));
            let sample = hcp(d, lattice::hcp_cells(d, [l * d, l * d, 3.0 * d]), 1.0);
            let material = m(nu, s);
            let e = elasticity(&sample, d, &material, 20000).unwrap();
            println!("n {} {:?} {:?}", sample.particles.len(), e, t.elapsed());
            if a.len() > 5 {
                std::process::exit(0)
            }
            for pull in [Pull::Tension, Pull::Shear] {
                let r = strength(&sample, d, &material, pull, 0.5).unwrap();
                if std::env::var("CURVE").is_ok() {
                    for p in r.curve.iter().step_by(10) {
                        println!("   {:.3} {:.5}", p.0, p.1);
                    }
                }
                println!(
                    "nu {nu} s {s} d {} {pull:?} peak {} at {:?} last {:?} {:?}",
                    f(3),
                    r.peak,
                    r.curve.iter().max_by(|a, b| a.1.total_cmp(&b.1)),
                    r.curve.last(),
                    t.elapsed()
                );
            }
        }
        "amo" => {
            // s ratio L seed
            let (s, d, l) = (f(1), f(2) * 150.0, f(3));
            let material = m(0.15, s);
            let r = relax(Sizes::around(d), [l * d, l * d, 4.0 * d], &material, 1.0, f(4) as u64).unwrap();
            println!(
                "n {} phi {} steps {} residual {:e} sides {:?} {:?}",
                r.system.particles.len(),
                r.volume_fraction,
                r.steps,
                r.residual,
                r.system.domain.sides,
                t.elapsed()
            );
            println!("{:?} {:?}", elasticity(&r.system, d, &material, 30000).unwrap(), t.elapsed());
            for pull in [Pull::Tension, Pull::Shear] {
                let q = strength(&r.system, d, &material, pull, 0.8).unwrap();
                println!(
                    "{pull:?} peak {} at {:?} last {:?} {:?}",
                    q.peak,
                    q.curve.iter().max_by(|a, b| a.1.total_cmp(&b.1)),
                    q.curve.last(),
                    t.elapsed()
                );
            }
        }
        "junction" => {
            // D d0 ns seed dir
            let (dd, d, ns) = (f(1), f(2), f(3));
            let sizes = Sizes { d_0: d, d_s: 0.75 * d, d_l: 7.5 };
            let r = relax(sizes, [60.0, 40.0, 40.0], &sio2, 2.2, f(4) as u64).unwrap();
            println!(
                "n {} phi {} steps {} residual {:e} sides {:?} {:?}",
                r.system.particles.len(),
                r.volume_fraction,
                r.steps,
                r.residual,
                r.system.domain.sides,
                t.elapsed()
            );
            let case: veridem::case::Junction = serde_yaml::from_str(&format!(
                "{{diameter: {dd} nm, shear_velocity: 10 m/s, normal_stress: 100 MPa, duration: {ns} ns}}"
            ))
            .unwrap();
            let stage = stages::junction(&case, d, sio2.young_modulus);
            std::fs::create_dir_all(&a[5]).unwrap();
            let mut k = 0;
            let w = shear_junction(&r.system, &stage, &sio2, 1.0, |sim, _l, w| {
                let row = w.rows.last().unwrap();
                if k % 5 == 0 {
                    println!("{:?} {row:?}", t.elapsed());
                    std::fs::write(
                        format!("{}/{k:03}.svg", a[5]),
                        veridem::figures::snapshot(sim.system(), [-2.0, 55.0]),
                    )
                    .unwrap();
                }
                k += 1;
            })
            .unwrap();
            println!("fate {:?} {:?}", w.fate(), t.elapsed());
        }
        _ => {}
    }
    let _ = links::<veridem::spec::wear::Wear>;
}
