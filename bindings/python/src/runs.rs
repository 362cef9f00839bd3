//! Run folders as they are read.

use crate::errors::{caught, exception};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use veridem::error::Error;
use veridem::output::{Event, Finding, Found, Manifest, Property, ReadFrame, ReadTable, RunFolder, Series};
use veridem::papers::PAPERS;

/// Title, status in words and manifest (as JSON) of a run.
#[pyfunction]
pub(crate) fn summary(run: PathBuf) -> PyResult<(String, String, String)> {
    caught(|| {
        let read = || -> Result<_, Error> {
            let folder = RunFolder::open(&run)?;
            let manifest = Manifest::read(&folder)?;
            let title = PAPERS.read(&folder.case())?.title;
            let json = serde_json::to_string(&manifest).expect("a manifest is plain data");
            Ok((title, manifest.status_word(&folder).to_string(), json))
        };
        read().map_err(exception)
    })
}

/// The files of a run by what they are.
#[pyfunction]
pub(crate) fn files(py: Python<'_>, run: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    caught(|| {
        let folder = RunFolder::open(&run).map_err(exception)?;
        let files = PyDict::new(py);
        files.set_item("case", folder.case())?;
        files.set_item("resolved", folder.resolved())?;
        files.set_item("series", folder.series())?;
        files.set_item("windows", folder.windows())?;
        files.set_item("profiles", folder.profiles())?;
        files.set_item("report", folder.report())?;
        Ok(files)
    })
}

/// The stages of a run that have begun, with the file of the columns that only they have.
#[pyfunction]
pub(crate) fn stages(run: PathBuf) -> PyResult<Vec<(String, PathBuf)>> {
    caught(|| {
        let folder = RunFolder::open(&run).map_err(exception)?;
        let series = Series::read(&folder).map_err(exception)?;
        Ok(series.stages().into_iter().map(|stage| (stage.into(), folder.series_of(stage))).collect())
    })
}

/// The columns of a table: numbers where all cells are, otherwise words.
#[pyfunction]
pub(crate) fn table(py: Python<'_>, file: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    caught(|| {
        let ReadTable { columns, rows, .. } = py.detach(|| ReadTable::read(&file)).map_err(exception)?;
        let table = PyDict::new(py);
        for (place, name) in columns.into_iter().enumerate() {
            let cells = || rows.iter().map(|row| row[place].as_str());
            let counts: Option<Vec<i64>> = cells().map(|cell| cell.parse().ok()).collect();
            let numbers: Option<Vec<f64>> = cells().map(|cell| cell.parse().ok()).collect();
            match (counts.filter(|_| !rows.is_empty()), numbers) {
                (Some(counts), _) => table.set_item(name, counts.into_pyarray(py))?,
                (None, Some(numbers)) => table.set_item(name, numbers.into_pyarray(py))?,
                (None, None) => table.set_item(name, cells().collect::<Vec<_>>())?,
            }
        }
        Ok(table)
    })
}

/// Stage, time and text of the events of a run.
#[pyfunction]
pub(crate) fn events(run: PathBuf) -> PyResult<Vec<(String, f64, String)>> {
    caught(|| {
        let events = RunFolder::open(&run).and_then(|folder| Event::all(&folder)).map_err(exception)?;
        Ok(events.into_iter().map(|Event { stage, time_ns, event }| (stage, time_ns, event)).collect())
    })
}

/// Name, value, unit, standard error, target, and why there is no value.
pub(crate) type Row = (String, Py<PyAny>, String, Option<f64>, Option<f64>, Option<String>);

/// The results of a run.
#[pyfunction]
pub(crate) fn results(py: Python<'_>, run: PathBuf) -> PyResult<Vec<Row>> {
    caught(|| {
        let findings = RunFolder::open(&run).and_then(|folder| Finding::of_run(&folder)).map_err(exception)?;
        findings.into_iter().map(|finding| of_finding(py, finding)).collect()
    })
}

/// A result as a row.
pub(crate) fn of_finding(py: Python<'_>, finding: Finding) -> PyResult<Row> {
    let (value, error, reason) = match finding.found {
        Found::Number(value, error) => (value.into_pyobject(py)?.into_any().unbind(), error, None),
        Found::Numbers(values) => (values.into_pyarray(py).into_any().unbind(), None, None),
        Found::Count(count) => (count.into_pyobject(py)?.into_any().unbind(), None, None),
        Found::Words(words) => (words.into_pyobject(py)?.into_any().unbind(), None, None),
        Found::NotReached(reason) => (py.None(), None, Some(reason)),
    };
    Ok((finding.name, value, finding.unit, error, finding.target, reason))
}

/// The files of the frames of a run, in the order of its stages and of time.
#[pyfunction]
pub(crate) fn frame_files(run: PathBuf) -> PyResult<Vec<PathBuf>> {
    caught(|| {
        let read = || {
            let folder = RunFolder::open(&run)?;
            let series = Series::read(&folder)?;
            ReadFrame::all(&folder, &series.stages())
        };
        read().map_err(exception)
    })
}

/// A frame: stage, time, sides, whether they are periodic, its columns, its pairs with theirs, and its surfaces.
#[pyfunction]
pub(crate) fn frame(py: Python<'_>, file: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    caught(|| {
        let frame = py.detach(|| ReadFrame::read(&file)).map_err(exception)?;
        let of = PyDict::new(py);
        of.set_item("stage", frame.stage)?;
        of.set_item("time", frame.time)?;
        of.set_item("sides", frame.sides.to_vec().into_pyarray(py))?;
        of.set_item("periodic", frame.periodic.to_vec().into_pyarray(py))?;
        let (count, pairs) = (frame.count, frame.pairs.len());
        of.set_item("columns", columns(py, frame.properties, count)?)?;
        let places: Vec<i64> = frame.pairs.iter().flat_map(|(places, _)| places.map(i64::from)).collect();
        of.set_item("pairs", places.into_pyarray(py).reshape([pairs, 2])?)?;
        let pair_columns = columns(py, frame.pair_properties, pairs)?;
        let kinds: Vec<i64> = frame.pairs.iter().map(|(_, kind)| i64::from(*kind)).collect();
        pair_columns.set_item("kind", kinds.into_pyarray(py))?;
        of.set_item("pair_columns", pair_columns)?;
        let (corners, triangles) = frame.surfaces;
        let count = [corners.len(), triangles.len()];
        let corners: Vec<f64> = corners.into_iter().flatten().collect();
        let triangles: Vec<i64> = triangles.into_iter().flatten().map(i64::from).collect();
        of.set_item("corners", corners.into_pyarray(py).reshape([count[0], 3])?)?;
        of.set_item("triangles", triangles.into_pyarray(py).reshape([count[1], 3])?)?;
        Ok(of)
    })
}

fn columns(py: Python<'_>, properties: Vec<Property>, count: usize) -> PyResult<Bound<'_, PyDict>> {
    let columns = PyDict::new(py);
    for Property { name, whole, components, numbers } in properties {
        let shape = if components == 1 { vec![count] } else { vec![count, components] };
        if whole {
            let numbers: Vec<i64> = numbers.into_iter().map(|number| number as i64).collect();
            columns.set_item(name, numbers.into_pyarray(py).reshape(shape)?)?;
        } else {
            columns.set_item(name, numbers.into_pyarray(py).reshape(shape)?)?;
        }
    }
    Ok(columns)
}
