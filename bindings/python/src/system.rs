//! The system of a simulation, put together from arrays.

use crate::arrays::Numbers;
use crate::errors::{exception, wrong};
use pyo3::prelude::*;
use veridem::system::{Domain, Mesh, Motion, PrescribedMotion, Shape, Surface, System};
use veridem_spec::Vec3;

/// A wall: its spheres, its velocity, and the loads on it along the axes that have one.
type Wall = (Vec<u32>, [f64; 3], [Option<f64>; 3]);

/// Spheres and what is about them, as Python hands them over.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Parts<'py> {
    positions: Bound<'py, PyAny>,
    velocities: Bound<'py, PyAny>,
    spins: Bound<'py, PyAny>,
    radii: Bound<'py, PyAny>,
    masses: Bound<'py, PyAny>,
    necks: Vec<(u32, u32)>,
    bodies: Vec<Vec<u32>>,
    walls: Vec<Wall>,
    surfaces: Vec<Side<'py>>,
    domain: Option<([f64; 3], [bool; 3])>,
}

/// A surface.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Side<'py> {
    /// Its material, by number.
    material: usize,
    /// A point and a normal, or the corners of triangles.
    shape: Bound<'py, PyAny>,
    /// Final velocity along z, rate of the reversal and its time.
    reversal: Option<[f64; 3]>,
}

impl Parts<'_> {
    /// The system, for a law that knows this many materials of surfaces.
    pub(crate) fn system(self, materials: usize) -> PyResult<System> {
        let x = spheres(&self.positions, "positions", 3)?;
        let (v, w) = (spheres(&self.velocities, "velocities", 3)?, spheres(&self.spins, "spins", 3)?);
        let (r, m) = (spheres(&self.radii, "radii", 1)?, spheres(&self.masses, "masses", 1)?);
        let count = x.len() / 3;
        let vector = |of: &[f64], name: &str, k: usize| match of.len() {
            3 => Ok([of[0], of[1], of[2]]),
            length if length == 3 * count => Ok([of[3 * k], of[3 * k + 1], of[3 * k + 2]]),
            length => Err(unlike(name, length / 3, count)),
        };
        let number = |of: &[f64], name: &str, k: usize| match of.len() {
            1 => Ok(of[0]),
            length if length == count => Ok(of[k]),
            length => Err(unlike(name, length, count)),
        };
        let mut builder = System::builder();
        for k in 0..count {
            builder = builder
                .sphere(vector(&x, "positions", k)?, number(&r, "radii", k)?, number(&m, "masses", k)?)
                .velocity(vector(&v, "velocities", k)?)
                .spin(vector(&w, "spins", k)?);
        }
        for (i, j) in self.necks {
            builder = builder.neck(i, j);
        }
        for members in &self.bodies {
            builder = builder.body(members);
        }
        for (members, velocity, load) in &self.walls {
            let motion = |a: usize| load[a].map_or(Motion::Velocity(velocity[a]), Motion::Load);
            builder = builder.wall(members, [0, 1, 2].map(motion));
        }
        for (number, side) in self.surfaces.iter().enumerate() {
            if side.material >= materials {
                return Err(wrong(format!("surface {number}: this law has no such surfaces")));
            }
            builder = builder.surface(side.surface(number)?);
        }
        if let Some((sides, periodic)) = self.domain {
            builder = builder.domain(Domain { sides, periodic });
        }
        builder.build().map_err(exception)
    }
}

impl Side<'_> {
    fn surface(&self, number: usize) -> PyResult<Surface> {
        let flawed = |what: &str| wrong(format!("surface {number}: {what}"));
        let numbers = Numbers::of(&self.shape, "shape", 3)?;
        let vectors: Vec<Vec3<f64>> = numbers.slice()?.chunks_exact(3).map(|u| Vec3([u[0], u[1], u[2]])).collect();
        if vectors.iter().any(|u| u.0.iter().any(|a| !a.is_finite())) {
            return Err(flawed("expected finite numbers"));
        }
        let shape = match (numbers.shape(3), &vectors[..]) {
            ([2], &[point, normal]) if normal.norm() > 0.0 => {
                Shape::Plane { point, normal: normal * (1.0 / normal.norm()) }
            }
            ([2], _) => return Err(flawed("its normal is zero")),
            ([_, 3], corners) => {
                let triangles: Vec<_> = corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect();
                Shape::Mesh(Mesh::new(&triangles).map_err(|flaw| flawed(&flaw.to_string()))?)
            }
            _ => return Err(flawed("expected triangles of the shape (number, 3, 3)")),
        };
        let motion = match self.reversal {
            None => PrescribedMotion::Still,
            Some([velocity, rate, turn])
                if velocity.is_finite() && rate > 0.0 && rate.is_finite() && turn.is_finite() =>
            {
                PrescribedMotion::Reversal { velocity, rate, turn }
            }
            Some(_) => return Err(flawed("its reversal has a finite velocity, a rate above 0 and a finite time")),
        };
        Ok(Surface::new(&format!("surface {number}"), self.material, shape, motion))
    }
}

/// The numbers of all spheres, or of one that stands for all.
fn spheres(value: &Bound<'_, PyAny>, name: &str, size: usize) -> PyResult<Vec<f64>> {
    let numbers = Numbers::of(value, name, size)?;
    if numbers.shape(size).len() > 1 {
        return Err(wrong(format!("`{name}`: expected one row for each sphere")));
    }
    Ok(numbers.slice()?.to_vec())
}

fn unlike(name: &str, found: usize, expected: usize) -> PyErr {
    wrong(format!("`{name}` are of {found} spheres, `positions` of {expected}"))
}
