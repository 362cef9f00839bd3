//! Arrays taken apart into columns, a stretch at a time, for the loops of the specification.

use crate::arrays::{Numbers, common_shape};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use veridem_spec::columns::Results;

/// How many evaluations are in the columns at a time: all of them stay in the second cache.
const STRETCH: usize = 1024;

/// An argument: its name, how many numbers it is, and its values.
pub(crate) struct Argument<'a, 'py> {
    pub name: &'a str,
    pub size: usize,
    pub numbers: Numbers<'py>,
}

/// Results, each in an array of its own, one after the other.
pub(crate) struct Computed {
    /// The shape of the broadcast arguments.
    pub shape: Vec<usize>,
    /// The numbers of each result, and the axes of its components.
    results: Vec<(Vec<f64>, Vec<usize>)>,
}

/// Evaluates something over columns: it receives those of the arguments and fills those of the results, whose components have these axes.
pub(crate) fn over_columns<'py>(
    py: Python<'py>,
    arguments: Vec<Argument<'_, 'py>>,
    results: &[&[usize]],
    evaluate: impl Fn(&[&[f64]], Results<'_, '_>) + Send,
) -> PyResult<Computed> {
    let shapes: Vec<_> = arguments.iter().map(|a| (a.name, a.numbers.shape(a.size))).collect();
    let shape = common_shape(&shapes)?;
    let count: usize = shape.iter().product();
    let spread = |a: Argument<'_, 'py>| Ok((a.size, a.numbers.broadcast(py, &shape, a.size)?));
    let arguments = arguments.into_iter().map(spread).collect::<PyResult<Vec<_>>>()?;
    let sources: Vec<(usize, &[f64])> =
        arguments.iter().map(|(size, numbers)| Ok((*size, numbers.slice()?))).collect::<PyResult<_>>()?;
    let room = |axes: &&[usize]| vec![0.0; axes.iter().product::<usize>() * count];
    let mut numbers: Vec<Vec<f64>> = results.iter().map(room).collect();
    py.detach(|| {
        let sizes = results.iter().map(|axes| axes.iter().product());
        let mut computed: Vec<(usize, &mut [f64])> = sizes.zip(numbers.iter_mut().map(Vec::as_mut_slice)).collect();
        stretches(count, &sources, &mut computed, evaluate);
    });
    Ok(Computed { results: numbers.into_iter().zip(results.iter().map(|axes| axes.to_vec())).collect(), shape })
}

fn stretches(
    count: usize,
    sources: &[(usize, &[f64])],
    computed: &mut [(usize, &mut [f64])],
    evaluate: impl Fn(&[&[f64]], Results<'_, '_>),
) {
    let width = STRETCH.min(count);
    let mut input = vec![vec![0.0; width]; sources.iter().map(|source| source.0).sum()];
    let mut output = vec![vec![0.0; width]; computed.iter().map(|result| result.0).sum()];
    for begin in (0..count).step_by(STRETCH) {
        let length = width.min(count - begin);
        let mut columns = input.iter_mut();
        for &(size, numbers) in sources {
            for (component, column) in columns.by_ref().take(size).enumerate() {
                if numbers.len() > size {
                    let from = numbers[begin * size..][..length * size].iter().skip(component).step_by(size);
                    column.iter_mut().zip(from).for_each(|(to, number)| *to = *number);
                } else if begin == 0 {
                    column.fill(numbers[component]);
                }
            }
        }
        let arguments: Vec<&[f64]> = input.iter().map(|column| &column[..length]).collect();
        let mut results: Vec<&mut [f64]> = output.iter_mut().map(|column| &mut column[..length]).collect();
        evaluate(&arguments, &mut results);
        let mut columns = output.iter();
        for (size, numbers) in &mut *computed {
            let to = &mut numbers[begin * *size..][..length * *size];
            for (component, column) in columns.by_ref().take(*size).enumerate() {
                let to = to.iter_mut().skip(component).step_by(*size);
                to.zip(column).for_each(|(to, number)| *to = *number);
            }
        }
    }
}

impl Computed {
    /// The first evaluation with a result that is not finite, and its results.
    pub(crate) fn first_not_finite(&self) -> Option<(usize, Vec<f64>)> {
        let sized = || self.results.iter().map(|(numbers, axes)| (numbers, axes.iter().product::<usize>()));
        let first = |(numbers, size): (&Vec<f64>, usize)| Some(numbers.iter().position(|x| !x.is_finite())? / size);
        let at = sized().filter_map(first).min()?;
        let found = sized().flat_map(|(numbers, size)| &numbers[at * size..][..size]);
        Some((at, found.copied().collect()))
    }

    /// The results as Python has them: floats, or arrays with the axes of their components last.
    pub(crate) fn into_python(self, py: Python<'_>) -> PyResult<Vec<Bound<'_, PyAny>>> {
        let Self { shape, results } = self;
        let object = |(numbers, axes): (Vec<f64>, Vec<usize>)| {
            if shape.is_empty() && axes.is_empty() {
                return Ok(numbers[0].into_pyobject(py)?.into_any());
            }
            Ok(numbers.into_pyarray(py).reshape([&shape[..], &axes].concat())?.into_any())
        };
        results.into_iter().map(object).collect()
    }
}
