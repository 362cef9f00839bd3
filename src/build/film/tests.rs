use super::*;

/// The film of the paper in a column of other sides and with fewer spheres.
fn paper(spheres: usize, side: f64) -> FilmPlan {
    FilmPlan {
        spheres,
        sides: [side; 2],
        diameters: Diameters { median: 9.0, deviation: 1.45, smallest: 3, largest: 23 },
        numbers: Numbers { median: 36.0, deviation: 0.5, largest: 128 },
        cluster: 6,
        k_f: 1.0,
        d_f: 1.8,
        gas: Gas { temperature: 300.0, viscosity: 1.85e-2, free_path: 68.0 },
        drift: 0.1,
    }
}

#[test]
#[ignore]
fn look() {
    let n: usize = std::env::var("N").unwrap().parse().unwrap();
    let side: f64 = std::env::var("S").unwrap().parse().unwrap();
    let t = std::time::Instant::now();
    let var = |k: &str, d: f64| std::env::var(k).map_or(d, |v| v.parse().unwrap());
    let mut plan = paper(n, side);
    plan.drift = var("U", 0.1);
    plan.numbers.median = var("M", 36.0);
    plan.numbers.deviation = var("DEV", 0.5);
    plan.gas.temperature = var("T", 300.0);
    plan.cluster = var("CL", 6.0) as usize;
    plan.d_f = var("DF", 1.8);
    let a = aggregates::aggregates(&plan, 1).unwrap();
    println!("aggregates {} {:?}", a.len(), t.elapsed());
    let d: f64 = a.iter().map(|a| a.diffusion).sum::<f64>() / a.len() as f64;
    println!("D {d}");
    let film = deposition::deposited(&plan, a, 1).unwrap();
    println!("film {:?}", t.elapsed());
    let v: f64 = film.spheres.iter().map(|s| crate::build::sphere_volume(0.5 * s.diameter)).sum();
    let mean: f64 = film.spheres.iter().map(|s| s.centre.0[2]).sum::<f64>() / film.spheres.len() as f64;
    println!("{} spheres, thickness {} mean height {mean}, porosity {} and by mean {}", film.spheres.len(), film.thickness, 1.0 - v / side / side / film.thickness, 1.0 - v / side / side / (2.0 * mean));
}
