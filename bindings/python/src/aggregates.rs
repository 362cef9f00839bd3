//! Aggregates grown and imported, and their shape.

use crate::arrays::Numbers;
use crate::errors::{caught, exception, wrong};
use crate::runs::{Row, of_finding};
use crate::work::{interruptible, limit, pool};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;
use veridem::error::Error;
use veridem::geometry::Sphere;
use veridem::initial::aggregate::import::{Extras, Format, Options, extended_xyz, read};
use veridem::initial::aggregate::necks::{NeckLength, necks};
use veridem::initial::aggregate::{Method, Radii, Recipe, aggregate};
use veridem::interrupt::Interrupt;
use veridem::observe::aggregate::AggregateShape;
use veridem::output::write_atomically;
use veridem_spec::Vec3;

/// Largest length, nm: the measures of a shape overflow far beyond it.
const METRE: f64 = 1e9;
/// Smallest radius, nm.
const SMALLEST: f64 = 1e-3;

type Arrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>);

/// Does something about spheres that can be interrupted, on all cores.
fn waited<T: Send>(py: Python<'_>, work: impl FnOnce(&Interrupt) -> Result<T, Error> + Send) -> PyResult<T> {
    interruptible(py, &pool(None)?, &limit(None)?, |interrupt, _: &Sender<()>| work(interrupt), |()| Ok(()))
}

fn arrays(py: Python<'_>, spheres: Vec<Sphere>) -> PyResult<Arrays<'_>> {
    let centres: Vec<f64> = spheres.iter().flat_map(|sphere| sphere.centre.0).collect();
    let radii: Vec<f64> = spheres.iter().map(|sphere| sphere.radius).collect();
    Ok((centres.into_pyarray(py).reshape([spheres.len(), 3])?, radii.into_pyarray(py)))
}

/// Spheres from their centres and radii.
fn spheres(positions: &Bound<'_, PyAny>, radii: &Bound<'_, PyAny>) -> PyResult<Vec<Sphere>> {
    let (x, r) = (Numbers::of(positions, "positions", 3)?, Numbers::of(radii, "radii", 1)?);
    let (x, r) = (x.slice()?, r.slice()?);
    if r.len() != 1 && r.len() != x.len() / 3 {
        return Err(wrong(format!("`radii` are of {} spheres, `positions` of {}", r.len(), x.len() / 3)));
    }
    let within = |x: &f64| x.abs() <= METRE;
    if x.is_empty() || !x.iter().all(within) || !r.iter().all(|r| within(r) && *r >= SMALLEST) {
        return Err(wrong(format!(
            "expected at least one sphere, positions of at most {METRE:e} nm and radii of {SMALLEST} to {METRE:e} nm"
        )));
    }
    let radius = |k: usize| if r.len() == 1 { r[0] } else { r[k] };
    let sphere = |(k, x): (usize, &[f64])| Sphere { centre: Vec3([x[0], x[1], x[2]]), radius: radius(k) };
    Ok(x.chunks_exact(3).enumerate().map(sphere).collect())
}

/// Grows an aggregate: centres and radii, nm.
#[pyfunction]
pub(crate) fn grow(
    py: Python<'_>,
    number: usize,
    law: [f64; 2],
    sizes: [f64; 2],
    one_by_one: bool,
    seed: u64,
) -> PyResult<Arrays<'_>> {
    caught(|| {
        let ([d_f, k_f], [median, deviation]) = (law, sizes);
        let radii = if deviation == 1.0 { Radii::Equal(median) } else { Radii::LogNormal { median, deviation } };
        let method = if one_by_one { Method::Spheres } else { Method::Clusters };
        let recipe = Recipe { number, d_f, k_f, radii, method };
        let grown = waited(py, |interrupt| aggregate(&recipe, seed, interrupt).map_err(|failure| failure.of("")))?;
        arrays(py, grown)
    })
}

/// Reads an aggregate from another program's file: centres and radii, nm, and the format.
#[pyfunction(name = "import_")]
pub(crate) fn import<'py>(
    py: Python<'py>,
    file: PathBuf,
    unit: Option<f64>,
    radius: Option<f64>,
    format: Option<&str>,
    disconnected: bool,
) -> PyResult<(Arrays<'py>, String)> {
    caught(|| {
        let format: Option<Format> = word("format", format)?;
        let options = Options { format, unit, radius, disconnected };
        let imported = waited(py, |interrupt| read(&file, &options, interrupt))?;
        let format = serde_yaml::to_string(&imported.format).unwrap_or_default();
        Ok((arrays(py, imported.spheres)?, format.trim().into()))
    })
}

/// A word that an argument may be.
fn word<W: serde::de::DeserializeOwned>(name: &str, text: Option<&str>) -> PyResult<Option<W>> {
    let word = |text| serde_yaml::from_str(text).map_err(|error| wrong(format!("`{name}`: {error}")));
    text.map(word).transpose()
}

/// The shape of an aggregate, as the results of a run.
#[pyfunction]
pub(crate) fn shape(py: Python<'_>, positions: &Bound<'_, PyAny>, radii: &Bound<'_, PyAny>) -> PyResult<Vec<Row>> {
    caught(|| {
        let spheres = spheres(positions, radii)?;
        let shape = waited(py, |interrupt| AggregateShape::of(&spheres, interrupt))?;
        shape.findings().into_iter().map(|finding| of_finding(py, finding)).collect()
    })
}

/// The pairs of spheres that necks join.
#[pyfunction]
pub(crate) fn neck_pairs<'py>(
    py: Python<'py>,
    positions: &Bound<'py, PyAny>,
    radii: &Bound<'py, PyAny>,
    distance: f64,
    as_given: bool,
) -> PyResult<Bound<'py, PyArray2<i64>>> {
    caught(|| {
        if !(distance > 0.0 && distance.is_finite()) {
            return Err(wrong(format!("`distance` = {distance}: expected a length above 0")));
        }
        let spheres = spheres(positions, radii)?;
        let length = if as_given { NeckLength::AsGiven } else { NeckLength::Touching };
        let found = waited(py, |interrupt| necks(&spheres, distance, length, true, interrupt))?;
        let pairs: Vec<i64> = found.iter().flat_map(|&(i, j)| [i as i64, j as i64]).collect();
        pairs.into_pyarray(py).reshape([found.len(), 2])
    })
}

/// Writes an aggregate as extended XYZ, nm.
#[pyfunction]
pub(crate) fn write(file: &str, positions: &Bound<'_, PyAny>, radii: &Bound<'_, PyAny>) -> PyResult<()> {
    caught(|| {
        let text = extended_xyz(&spheres(positions, radii)?, &Extras::default());
        write_atomically(Path::new(file), text.as_bytes()).map_err(exception)
    })
}
