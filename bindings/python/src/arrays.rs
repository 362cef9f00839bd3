//! Arguments as arrays of numbers, and how they are broadcast against each other.

use crate::errors::{caught, wrong};
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyFloat, PyInt, PyString};

/// Numbers, or vectors of a fixed size, in the order of C.
pub(crate) enum Numbers<'py> {
    /// One of them, which is the same everywhere.
    One(Vec<f64>),
    /// Many: an array whose last axis holds the components of a vector.
    Many(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> Numbers<'py> {
    /// Takes numbers or vectors of `size` components from any object that numpy makes an array of real numbers.
    pub(crate) fn of(value: &Bound<'py, PyAny>, name: &str, size: usize) -> PyResult<Self> {
        if size == 1
            && !value.is_instance_of::<PyBool>()
            && (value.is_instance_of::<PyFloat>() || value.is_instance_of::<PyInt>())
        {
            return Ok(Self::One(vec![value.extract()?]));
        }
        let array = array(value, name)?;
        let shape = array.shape();
        if size > 1 && shape.last() != Some(&size) {
            return Err(wrong(format!("`{name}` has the shape {}, expected (..., {size})", told(shape))));
        }
        let array = array.try_readonly()?;
        let scalar = shape_of(array.shape(), size).is_empty();
        if scalar { Ok(Self::One(slice(&array)?.to_vec())) } else { Ok(Self::Many(array)) }
    }

    /// All its numbers.
    pub(crate) fn slice(&self) -> PyResult<&[f64]> {
        match self {
            Self::One(numbers) => Ok(numbers),
            Self::Many(array) => slice(array),
        }
    }

    /// Its shape, without the axis of components.
    pub(crate) fn shape(&self, size: usize) -> &[usize] {
        match self {
            Self::One(_) => &[],
            Self::Many(array) => shape_of(array.shape(), size),
        }
    }

    /// The same, with as many numbers as this shape has, unless there is only one.
    pub(crate) fn broadcast(self, py: Python<'py>, shape: &[usize], size: usize) -> PyResult<Self> {
        let Self::Many(array) = &self else { return Ok(self) };
        let own = shape_of(array.shape(), size);
        if own == shape {
            return Ok(self);
        }
        if array.len() == size {
            return Ok(Self::One(slice(array)?.to_vec()));
        }
        let components = (size > 1).then_some(size);
        let whole: Vec<usize> = shape.iter().copied().chain(components).collect();
        let spread = py.import("numpy")?.call_method1("broadcast_to", (array.as_any(), whole))?;
        Ok(Self::Many(ordered(&spread)?.try_readonly()?))
    }
}

fn shape_of(shape: &[usize], size: usize) -> &[usize] {
    if size == 1 { shape } else { &shape[..shape.len() - 1] }
}

fn slice<'a>(array: &'a PyReadonlyArrayDyn<'_, f64>) -> PyResult<&'a [f64]> {
    array.as_slice().map_err(|error| wrong(error.to_string()))
}

/// An array of real numbers in the order of C, copied if it is not one already.
fn array<'py>(value: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = value.py();
    refuse_masked(value, name)?;
    if let Ok(array) = value.cast::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
        && array.is_aligned()
    {
        return Ok(array.clone());
    }
    let array = py.import("numpy")?.call_method1("asarray", (value,))?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !["f", "i", "u", "b"].contains(&&*kind) {
        let found =
            if value.is_instance_of::<PyString>() { value.repr()?.to_string() } else { value.get_type().to_string() };
        return Err(PyTypeError::new_err(format!("`{name}`: found {found}, expected real numbers")));
    }
    ordered(&array)
}

/// Refuses an array some of whose numbers are masked: a computation would take what is under the mask.
fn refuse_masked(value: &Bound<'_, PyAny>, name: &str) -> PyResult<()> {
    static MASKED: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if value.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(());
    }
    let class = MASKED.import(value.py(), "numpy.ma", "MaskedArray")?;
    if value.is_instance(class)? && value.getattr("mask")?.call_method0("any")?.extract()? {
        return Err(wrong(format!("`{name}`: some of its numbers are masked, expected numbers everywhere")));
    }
    Ok(())
}

/// Real numbers, or vectors of a fixed size, as an array of their own.
#[pyfunction]
pub(crate) fn numbers<'py>(value: &Bound<'py, PyAny>, name: &str, size: usize) -> PyResult<Bound<'py, PyAny>> {
    caught(|| {
        let numbers = Numbers::of(value, name, size)?;
        let components = (size > 1).then_some(size);
        let shape: Vec<usize> = numbers.shape(size).iter().copied().chain(components).collect();
        Ok(numbers.slice()?.to_vec().into_pyarray(value.py()).reshape(shape)?.into_any())
    })
}

/// The array as numbers of this processor, in the order of C and aligned.
fn ordered<'py>(array: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    static REQUIRE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let require = REQUIRE.import(array.py(), "numpy", "require")?;
    let double = numpy::dtype::<f64>(array.py());
    Ok(require.call1((array, double, ["C", "A"]))?.cast_into::<PyArrayDyn<f64>>()?)
}

/// The shape to which all of these are broadcast, as numpy does it.
pub(crate) fn common_shape(shapes: &[(&str, &[usize])]) -> PyResult<Vec<usize>> {
    let length = shapes.iter().map(|(_, shape)| shape.len()).max().unwrap_or(0);
    let mut common = vec![1; length];
    for (_, shape) in shapes {
        for (side, &own) in common[length - shape.len()..].iter_mut().zip(*shape) {
            if *side == 1 {
                *side = own;
            } else if own != 1 && own != *side {
                let all: Vec<String> = shapes.iter().map(|(name, shape)| format!("{name} {}", told(shape))).collect();
                return Err(wrong(format!("these shapes cannot be broadcast together: {}", all.join(", "))));
            }
        }
    }
    Ok(common)
}

/// A shape as Python writes it.
pub(crate) fn told(shape: &[usize]) -> String {
    let sides: Vec<String> = shape.iter().map(usize::to_string).collect();
    if let [side] = &sides[..] { format!("({side},)") } else { format!("({})", sides.join(", ")) }
}

/// The place with this number in an array, as Python writes it.
pub(crate) fn place(mut number: usize, shape: &[usize]) -> String {
    let mut index: Vec<String> = shape
        .iter()
        .rev()
        .map(|&side| {
            let own = number % side;
            number /= side;
            own.to_string()
        })
        .collect();
    index.reverse();
    if index.is_empty() { String::new() } else { format!("[{}]", index.join(", ")) }
}
