//! The state of a simulation as LAMMPS with the plugin of `bindings/lammps` reads it: a data file, the history of the pairs, an input script.

use crate::motion::{self, BoxMotion};
use crate::simulation::{Integrator, Simulation};
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::{Flat, PairModel, Vec3};
use crate::system::{Motion, Particles, PrescribedMotion, Shape, Steering, System, Wall};
use std::fmt::Write;

/// Distance between the spheres and the sides of a box that are not periodic, nm.
const MARGIN: f64 = 50.0;
/// Moment of inertia that the plugin takes for that of a sphere that cannot turn.
const FIXED: f64 = 1e300;

/// What a script needs beside the state.
#[derive(Clone, Debug)]
pub struct LammpsScript<'a> {
    /// Title of the case, and name of the stage.
    pub title: String,
    /// The contact model: the last part of the name of the style, then keys and values.
    pub style: &'a str,
    /// Steps until the stage ends.
    pub steps: u64,
    /// Steps between rows of the log.
    pub series: u64,
    /// Steps between frames.
    pub frames: u64,
}

/// The files by name.
///
/// # Errors
///
/// What LAMMPS with the plugin cannot do, in words.
pub fn for_lammps<M: PairModel>(
    simulation: &Simulation<M>,
    script: &LammpsScript,
) -> Result<Vec<(&'static str, String)>, String> {
    possible(simulation)?;
    let files = [
        ("state.data", data(simulation)),
        ("state.history", history(simulation)),
        ("in.lammps", input(simulation, script)?),
    ];
    Ok(files.into())
}

/// Refuses what has no counterpart.
fn possible<M: PairModel>(simulation: &Simulation<M>) -> Result<(), String> {
    let (system, settings) = (simulation.system(), simulation.settings());
    let what = if settings.far_every != 1 {
        "`attraction_every` other than 1"
    } else if settings.relax_box.is_some_and(|relaxation| relaxation.target != [0.0; 3]) {
        "a box under a stress"
    } else if system.walls.iter().any(|wall| wall.spin != Vec3::zero()) {
        "a wall whose spheres turn"
    } else if system
        .surfaces
        .iter()
        .any(|surface| matches!(surface.shape, Shape::Mesh(_)) || surface.motion != PrescribedMotion::Still)
    {
        "a surface other than a plane at rest"
    } else if system.surfaces.iter().any(|surface| !surface.contacts.places.is_empty()) {
        "springs of contacts with a plane"
    } else {
        return Ok(());
    };
    Err(format!("found {what}, which the plugin for LAMMPS does not have"))
}

/// Places of the spheres by id, and the corners of the box.
fn corners(system: &System) -> ([f64; 3], [f64; 3]) {
    let x = &system.particles.x;
    let extreme = |a: usize, pick: fn(f64, f64) -> f64, from: f64| x.iter().fold(from, |most, x| pick(most, x.0[a]));
    let low = |a| if system.domain.periodic[a] { 0.0 } else { extreme(a, f64::min, f64::INFINITY) - MARGIN };
    let high = |a| match system.domain.periodic[a] {
        true => system.domain.sides[a],
        false => extreme(a, f64::max, f64::NEG_INFINITY) + MARGIN,
    };
    (std::array::from_fn(low), std::array::from_fn(high))
}

/// A centre in the box, and how many boxes away it is.
fn folded(system: &System, x: Vec3<f64>) -> (Vec3<f64>, [i64; 3]) {
    let (sides, periodic) = (system.domain.sides, system.domain.periodic);
    let image = std::array::from_fn(|a| if periodic[a] { (x.0[a] / sides[a]).floor() as i64 } else { 0 });
    (Vec3(std::array::from_fn(|a| x.0[a] - image[a] as f64 * sides[a])), image)
}

fn data<M: PairModel>(simulation: &Simulation<M>) -> String {
    let system = simulation.system();
    let Particles { v, w, radius, mass, wall, body, id, .. } = &system.particles;
    let (places, (low, high)) = (system.particles.by_id(), corners(system));
    let mut text =
        format!("veridem at {} ns\n\n{} atoms\n{} atom types\n\n", system.time, places.len(), 1 + system.walls.len());
    for (a, axis) in ["x", "y", "z"].into_iter().enumerate() {
        line(&mut text, format_args!("{} {} {axis}lo {axis}hi", low[a], high[a]));
    }
    let mut section = |title: &str, row: &dyn Fn(usize) -> String| {
        line(&mut text, format_args!("\n{title}\n"));
        places.iter().for_each(|&p| line(&mut text, format_args!("{} {}", id[p] + 1, row(p))));
    };
    section("Atoms # sphere", &|p| {
        let (Vec3([x, y, z]), [nx, ny, nz]) = folded(system, system.particles.x[p]);
        let density = mass[p] / sphere_mass(1.0, radius[p]);
        format!("{} {} {density} {x} {y} {z} {nx} {ny} {nz}", 1 + wall[p], 2.0 * radius[p])
    });
    section("Velocities", &|p| {
        let (Vec3([x, y, z]), Vec3([a, b, c])) = (v[p], w[p]);
        format!("{x} {y} {z} {a} {b} {c}")
    });
    section("Members", &|p| {
        let least = |moments: Vec3<f64>| moments.0.into_iter().fold(f64::INFINITY, f64::min);
        let moment = match (wall[p], body[p] as usize) {
            (0, 0) => motion::inertia(&system.particles, p),
            (0, body) => least(system.bodies[body - 1].moments),
            _ => FIXED,
        };
        format!("{} {moment:e}", body[p])
    });
    text
}

fn history<M: PairModel>(simulation: &Simulation<M>) -> String {
    let system = simulation.system();
    let mut rows: Vec<((u32, u32), String)> = Vec::new();
    for (i, j, _, memory) in simulation.contacts() {
        let ids = (system.particles.id[i], system.particles.id[j]);
        let joined = u8::from(system.necks.binary_search(&ids).is_ok());
        let springs: Vec<f64> = (0..M::Memory::<f64>::LEN).map(|k| *memory.at(k)).collect();
        if joined == 1 || springs.iter().any(|&number| number != 0.0) {
            let springs: Vec<String> = springs.iter().map(f64::to_string).collect();
            rows.push((ids, format!("{} {} {joined} {}", ids.0 + 1, ids.1 + 1, springs.join(" "))));
        }
    }
    rows.sort_unstable_by_key(|row| row.0);
    let mut text = "# ids of two spheres, 1 for a neck, springs\n".to_string();
    rows.iter().for_each(|(_, row)| line(&mut text, format_args!("{row}")));
    text
}

fn input<M: PairModel>(simulation: &Simulation<M>, script: &LammpsScript) -> Result<String, String> {
    let (system, settings) = (simulation.system(), simulation.settings());
    let boundary = system.domain.periodic.map(|periodic| if periodic { "p" } else { "s" }).join(" ");
    let mut text = format!(
        "# {}\n# lmp -in in.lammps -var plugin PATH\n\
         variable plugin index veridemplugin.so\n\
         units nano\natom_style sphere\natom_modify map yes\nnewton off\nboundary {boundary}\ncomm_modify vel yes\nplugin load ${{plugin}}\n\
         fix members all property/atom mol d_moment ghost yes\nread_data state.data fix members NULL Members\nreset_timestep {}\n\
         pair_style veridem/{}\npair_coeff * * history state.history\n",
        script.title, system.step, script.style
    );
    // The engine may list pairs without a skin; LAMMPS needs one.
    let largest = system.particles.radius.iter().copied().fold(0.0, f64::max);
    let skin = if settings.skin > 0.0 { settings.skin } else { 0.2 * largest };
    // A side that grows moves spheres, which the engine does not count as a displacement.
    let skin = if settings.relax_box.is_some() { 3.0 * skin } else { skin };
    line(&mut text, format_args!("neighbor {skin} bin\nneigh_modify every 1 delay 0 check yes"));
    for wall in 0..system.walls.len() {
        line(
            &mut text,
            format_args!(
                "group wall{} type {}\nneigh_modify exclude type {} {}",
                wall + 1,
                wall + 2,
                wall + 2,
                wall + 2
            ),
        );
    }
    if has_free_bodies(system) {
        line(
            &mut text,
            format_args!(
                "variable single atom mol==0\ngroup single variable single\ngroup walls type > 1\n\
                 group bodies subtract all single walls\ngroup free subtract single walls"
            ),
        );
        // The process of the sphere next to the centre of a body has copies of all others.
        let reach = reach(system) + skin;
        line(&mut text, format_args!("neigh_modify exclude molecule/intra bodies\ncomm_modify cutoff {reach}"));
    }
    line(&mut text, format_args!("timestep {}", settings.dt));
    for surface in &system.surfaces {
        if let Shape::Plane { point: Vec3([x, y, z]), normal: Vec3([a, b, c]) } = surface.shape {
            let material = ["substrate", "tip"].get(surface.material).ok_or("found an unknown surface")?;
            line(&mut text, format_args!("fix {material} all veridem/plane {material} {x} {y} {z} {a} {b} {c}"));
        }
    }
    motion_of(&mut text, simulation);
    let style = script.style.split(' ').next().unwrap_or_default();
    let LammpsScript { steps, series, frames, .. } = script;
    let planes: String = system.surfaces.iter().map(|surface| format!(" f_{}[*]", surface.name)).collect();
    let columns = "id type radius mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";
    line(
        &mut text,
        format_args!(
            "compute energies all pair veridem/{style}\ncompute moving all ke\ncompute turning all erotate/sphere\n\
             thermo {series}\nthermo_style custom step time pe c_moving c_turning c_energies[*]{planes}\n\
             thermo_modify norm no format float %.15g\n\
             dump frames all custom {frames} frames.*.dump {columns}\ndump_modify frames format float %.17g sort id pad 9\n\
             run {steps}\nwrite_data end.data nofix"
        ),
    );
    Ok(text)
}

/// Whether bodies move by themselves, not as parts of walls.
fn has_free_bodies(system: &System) -> bool {
    system.bodies.iter().any(|body| body.wall == 0)
}

/// Largest distance between the sphere of a body next to its centre and any other of its spheres; of bodies that move freely.
fn reach(system: &System) -> f64 {
    let Particles { body, arm, .. } = &system.particles;
    let mut nearest = vec![f64::INFINITY; system.bodies.len()];
    for (&body, arm) in body.iter().zip(arm).filter(|(body, _)| **body > 0) {
        let nearest = &mut nearest[body as usize - 1];
        *nearest = nearest.min(arm.norm());
    }
    let free = system.bodies.iter().zip(&nearest).filter(|(body, _)| body.wall == 0);
    free.map(|(body, nearest)| body.extent + nearest).fold(0.0, f64::max)
}

/// The fixes that move the spheres.
fn motion_of<M: PairModel>(text: &mut String, simulation: &Simulation<M>) {
    let (system, settings) = (simulation.system(), simulation.settings());
    let damping = settings.damping;
    if !has_free_bodies(system) && settings.integrator == Integrator::HalfStep {
        let relax = settings.relax_box.map_or(String::new(), |relaxation| {
            let (BoxMotion { rate, owed }, flux) = (simulation.box_motion(), simulation.momentum_flux());
            let numbers: String = [rate, owed, flux].into_iter().flatten().map(|number| format!(" {number}")).collect();
            format!(" relax {}{numbers}", relaxation.modulus)
        });
        line(text, format_args!("fix step all veridem/step damping {damping}{}{relax}", walls(system)));
    } else {
        synchronous_motion(text, system, damping);
    }
    for (number, steering) in (1..).zip(&system.steerings) {
        let Steering { spheres, stiffness, velocity, ramp, origin, age, .. } = steering;
        let ids: String = spheres.iter().map(|id| format!(" {}", id + 1)).collect();
        let three = |Vec3([x, y, z]): &Vec3<f64>| format!("{x} {y} {z}");
        let (stiffness, velocity, origin) = (three(stiffness), three(velocity), three(origin));
        line(text, format_args!("group pulled{number} id{ids}"));
        line(
            text,
            format_args!("fix pull{number} pulled{number} veridem/pull {stiffness} {velocity} {ramp} {origin} {age}"),
        );
    }
}

/// The walls as the fix that moves them wants them.
fn walls(system: &System) -> String {
    let drive = |wall: &Wall, motion: &Motion| match motion {
        Motion::Velocity(_) => "NULL".to_string(),
        Motion::Load(load) => load.to_string(),
        Motion::Return { speed, turn } => format!("return {speed} {turn} {}", wall.age),
    };
    let mut words = String::new();
    for (number, wall) in (1..).zip(&system.walls) {
        let [x, y, z] = wall.motion.each_ref().map(|motion| drive(wall, motion));
        write!(words, " wall wall{number} {} {x} {y} {z}", wall.mass).ok();
    }
    words
}

/// The fixes of LAMMPS's own, in which positions and velocities belong to the same time.
fn synchronous_motion(text: &mut String, system: &System, damping: f64) {
    if damping != 0.0 {
        let scales: String = (2..=1 + system.walls.len()).map(|kind| format!(" scale {kind} 0")).collect();
        line(text, format_args!("fix damping all viscous {damping}{scales}"));
    }
    if has_free_bodies(system) {
        line(
            text,
            format_args!(
                "fix rigid bodies rigid/small molecule\nfix free free nve/sphere\nfix walls walls veridem/step first{}",
                walls(system)
            ),
        );
    } else {
        line(text, format_args!("fix free all nve/sphere"));
    }
}

fn line(text: &mut String, words: std::fmt::Arguments) {
    // A text never refuses what is written into it.
    writeln!(text, "{words}").ok();
}
