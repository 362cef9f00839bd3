//! A sphere falls on the tip in the engine as the energy integral says: on a square of two triangles, far larger than itself.

use super::engine::{dry, spheres};
use crate::golden::{Complaints, Run, steps};
use crate::run::advance_until;
use crate::simulation::{Settings, Simulation};
use crate::spec::Vec3;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::TIP;
use crate::system::{Mesh, PrescribedMotion, Shape, Surface, System};

/// A time step that is stable and quick, ns.
const DT: f64 = 20e-6;

/// The run with a plane, and none without.
pub(super) fn fall(run: &Run, complaints: &mut Complaints) -> Result<(), String> {
    if run.word("partner")? != "plane" {
        return Ok(());
    }
    let nano = |key| run.number(key).map(|number| 1e9 * number);
    let (radius, start, end, expected) = (nano("r")?, nano("delta_start")?, nano("delta_end")?, nano("total_time")?);
    let [a, b, c, d] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Vec3([x, y, 0.0]) * 2e3);
    let sheet = Shape::Mesh(Mesh::new(&[[a, b, c], [a, c, d]]).expect("a sheet"));
    let surfaces = vec![Surface::new("tip", TIP, sheet, PrescribedMotion::Still)];
    let sphere = spheres(&[Vec3([0.0, 0.0, radius + start])], radius, sphere_mass(1e-6 * run.number("rho")?, radius));
    let system = System { surfaces, ..sphere };
    let settings = Settings::new(DT).skin(2.0).max_overlap(0.1);
    let mut simulation = Simulation::new(dry(), system, settings).map_err(|halt| halt.to_string())?;
    let late = steps(2.0 * expected / DT)?;
    let fallen = |now: &mut Simulation<_>| now.system().particles.x[0].0[2] <= radius + end || now.system().step > late;
    advance_until(&mut simulation, fallen).map_err(|halt| halt.to_string())?;
    let (system, speed) = (simulation.system(), run.number("final_speed")?);
    complaints.near("total_time, ns, in the engine", system.time, expected, 2.0 * DT);
    complaints.near("final_speed in the engine", -system.particles.v[0].0[2], speed, 1e-4 * speed);
    complaints.near_vector("spin in the engine", system.particles.w[0], Vec3::zero(), 0.0);
    Ok(())
}
