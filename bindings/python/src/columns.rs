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

/// Results of some sizes, each in an array of its own, one after the other.
pub(crate) struct Computed {
    /// The shape of the broadcast arguments.
    pub shape: Vec<usize>,
    /// For each result its size and numbers.
    pub results: Vec<(usize, Vec<f64>)>,
}

/// Evaluates something over columns: it receives those of the arguments and fills those of the results, which have these sizes. It may refuse
/// the results from the evaluation with this number on.
pub(crate) fn over_columns<'py>(
    py: Python<'py>,
    arguments: Vec<Argument<'_, 'py>>,
    results: &[usize],
    evaluate: impl Fn(usize, &[&[f64]], Results<'_, '_>) -> PyResult<()> + Send,
) -> PyResult<Computed> {
    let shapes: Vec<_> = arguments.iter().map(|a| (a.name, a.numbers.shape(a.size))).collect();
    let shape = common_shape(&shapes)?;
    let count: usize = shape.iter().product();
    let spread = |a: Argument<'_, 'py>| Ok((a.size, a.numbers.broadcast(py, &shape, a.size)?));
    let arguments = arguments.into_iter().map(spread).collect::<PyResult<Vec<_>>>()?;
    let sources: Vec<(usize, &[f64])> =
        arguments.iter().map(|(size, numbers)| Ok((*size, numbers.slice()?))).collect::<PyResult<_>>()?;
    let mut computed: Vec<(usize, Vec<f64>)> = results.iter().map(|&size| (size, vec![0.0; size * count])).collect();
    py.detach(|| stretches(count, &sources, &mut computed, evaluate))?;
    drop(sources);
    Ok(Computed { shape, results: computed })
}

fn stretches(
    count: usize,
    sources: &[(usize, &[f64])],
    computed: &mut [(usize, Vec<f64>)],
    evaluate: impl Fn(usize, &[&[f64]], Results<'_, '_>) -> PyResult<()>,
) -> PyResult<()> {
    let width = STRETCH.min(count);
    let sum = |sizes: &mut dyn Iterator<Item = usize>| sizes.sum::<usize>();
    let mut input = vec![vec![0.0; width]; sum(&mut sources.iter().map(|source| source.0))];
    let mut output = vec![vec![0.0; width]; sum(&mut computed.iter().map(|result| result.0))];
    let mut first = true;
    for begin in (0..count).step_by(STRETCH) {
        let length = width.min(count - begin);
        let mut column = 0;
        for &(size, numbers) in sources {
            for component in 0..size {
                let target = &mut input[column][..length];
                column += 1;
                if numbers.len() == size {
                    if first {
                        target.fill(numbers[component]);
                    }
                } else {
                    let from = numbers[begin * size..(begin + length) * size].iter().skip(component).step_by(size);
                    target.iter_mut().zip(from).for_each(|(target, number)| *target = *number);
                }
            }
        }
        first = false;
        let arguments: Vec<&[f64]> = input.iter().map(|column| &column[..length]).collect();
        let mut results: Vec<&mut [f64]> = output.iter_mut().map(|column| &mut column[..length]).collect();
        evaluate(begin, &arguments, &mut results)?;
        let mut columns = output.iter();
        for (size, numbers) in &mut *computed {
            let target = &mut numbers[begin * *size..(begin + length) * *size];
            for component in 0..*size {
                let from = &columns.next().expect("a column for every component")[..length];
                target
                    .iter_mut()
                    .skip(component)
                    .step_by(*size)
                    .zip(from)
                    .for_each(|(target, number)| *target = *number);
            }
        }
    }
    Ok(())
}

impl Computed {
    /// The first evaluation with a result that is not finite, and its results.
    pub(crate) fn first_not_finite(&self) -> Option<(usize, Vec<f64>)> {
        let first =
            |(size, numbers): &(usize, Vec<f64>)| numbers.iter().position(|x| !x.is_finite()).map(|at| at / size);
        let at = self.results.iter().filter_map(first).min()?;
        let found = self.results.iter().flat_map(|(size, numbers)| &numbers[at * size..(at + 1) * size]);
        Some((at, found.copied().collect()))
    }

    /// The results as Python has them: floats, or arrays with an axis for the components of a vector and two for those of a tensor.
    pub(crate) fn into_python(self, py: Python<'_>) -> PyResult<Vec<Bound<'_, PyAny>>> {
        let Self { shape, results } = self;
        let object = |(size, numbers): (usize, Vec<f64>)| {
            if size == 1 && shape.is_empty() {
                return Ok(numbers[0].into_pyobject(py)?.into_any());
            }
            let components: &[usize] = match size {
                1 => &[],
                9 => &[3, 3],
                _ => &[size],
            };
            let shape: Vec<usize> = shape.iter().chain(components).copied().collect();
            Ok(numbers.into_pyarray(py).reshape(shape)?.into_any())
        };
        results.into_iter().map(object).collect()
    }
}
