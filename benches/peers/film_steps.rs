//! Advances a film of water-covered titania: what `liggghts.py` sets against LIGGGHTS.
//!
//!     cargo run --release -p veridem-peers --bin film_steps -- rigid|free SPHERES STEPS [INSTRUCTIONS]
//!
//! Aggregates are rigid bodies, or all their spheres are by themselves; those on the floor are fixed. Without steps it prints what the
//! film is: a line with the sides of the box, the number of pairs in contact and of those in range, and a line `aggregate x y z radius
//! mass fixed` for each sphere. Units: nm, ag.

use veridem::forces::Instructions;
use veridem::initial::film::{Bonding, FilmPlan};
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::titania::{Tabulated, Titania};

/// Spheres per area of the paper's film, 1/nm².
const PER_AREA: f64 = 200_000.0 / (1581.4 * 1581.4);
/// Density of titania, ag/nm³.
const DENSITY: f64 = 4.23e-3;

#[global_allocator]
static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [bonding, spheres, steps, set @ ..] = &words[..] else {
        return Err("expected rigid|free SPHERES STEPS".into());
    };
    if let Some(name) = set.first() {
        Instructions::named(name).expect("instructions that this processor has: baseline, avx2 or avx512").choose();
    }
    let (spheres, steps): (usize, u64) = (spheres.parse()?, steps.parse()?);
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global()?;

    let law = Titania::paper(1.0, 1e3, 1.0);
    let side = (spheres as f64 / PER_AREA).sqrt();
    let film = FilmPlan { drift: 10.0, ..FilmPlan::paper(spheres, [side; 2]) }
        .build(1, &veridem::interrupt::Interrupt::default())?;
    let bonding = if bonding == "rigid" { Bonding::Rigid } else { Bonding::Necks };
    let mut system = film.system(bonding, |d| {
        let r = law.contact_radius(d);
        (r, sphere_mass(DENSITY, r))
    });
    system.necks.clear();
    let radii: Vec<f64> = (3..=23).map(|d| law.contact_radius(f64::from(d))).collect();
    let settings = Settings::new(0.5e-3).skin(3.0);
    let mut simulation = Simulation::new(Tabulated::new(law, &radii, 0.1), system, settings)?;
    if steps == 0 {
        let (system, in_range) = (simulation.system(), simulation.contacts().count());
        let touching = simulation.contacts().filter(|(_, _, contact, _)| contact.gap < 0.0).count();
        let [a, b, c] = system.domain.sides;
        println!("{a} {b} {c} {touching} {in_range}");
        let p = &system.particles;
        for k in 0..p.len() {
            let [x, y, z] = p.x[k].0;
            println!("{} {x} {y} {z} {} {} {}", p.tag[k], p.radius[k], p.mass[k], p.wall[k]);
        }
    }
    advance(&mut simulation, steps)?;
    Ok(())
}
