//! Confidence intervals of means of a few runs.

/// Part of the means that lie in their confidence interval.
const CONFIDENCE: f64 = 0.95;

/// The mean of a sample, and half the width of the 95 % confidence interval of the population mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Half the width of the interval; a NaN for a sample of one.
    pub margin: f64,
}

impl Mean {
    /// The mean of a sample, by Student's t: for values that are distributed normally, however few.
    pub fn of(sample: &[f64]) -> Self {
        let n = sample.len() as f64;
        let value = sample.iter().sum::<f64>() / n;
        if sample.len() < 2 {
            return Self { value, margin: f64::NAN };
        }
        Self { value, margin: students_t(sample.len() - 1) * standard_error(sample, value) }
    }

    /// Whether a value lies in the interval.
    pub fn covers(&self, value: f64) -> bool {
        (value - self.value).abs() <= self.margin
    }
}

impl std::fmt::Display for Mean {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digits = f.precision().unwrap_or(2);
        write!(f, "{:.digits$} ± {:.digits$}", self.value, self.margin)
    }
}

/// The standard error of the mean of a sample.
pub fn standard_error(sample: &[f64], mean: f64) -> f64 {
    let n = sample.len() as f64;
    let squares: f64 = sample.iter().map(|x| (x - mean) * (x - mean)).sum();
    (squares / (n - 1.0) / n).sqrt()
}

/// The standard error of an estimate, from the estimates without each of equal parts of the sample in turn.
pub fn jackknife(without: &[f64]) -> f64 {
    let n = without.len() as f64;
    let mean = without.iter().sum::<f64>() / n;
    ((n - 1.0) / n * without.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>()).sqrt()
}

/// The bound of the absolute value of Student's t, with this number of degrees of freedom, at the level of confidence.
fn students_t(freedom: usize) -> f64 {
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    // Halved until neighbouring numbers are left.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if within(middle, freedom) < CONFIDENCE { low = middle } else { high = middle }
    }
    (freedom as f64).sqrt() * libm::tan(low)
}

/// Probability that Student's t is absolutely below `sqrt(freedom) tan(theta)`: a finite sum of powers of the cosine.
fn within(theta: f64, freedom: usize) -> f64 {
    let (sine, cosine) = (libm::sin(theta), libm::cos(theta));
    let odd = freedom % 2;
    let (mut term, mut sum) = (if odd == 1 { cosine } else { 1.0 }, 0.0);
    for k in 0..freedom / 2 {
        sum += term;
        let lower = (2 * k + 1 + odd) as f64;
        term *= cosine * cosine * lower / (lower + 1.0);
    }
    if odd == 1 { (theta + sine * sum) * std::f64::consts::FRAC_2_PI } else { sine * sum }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Stream;

    #[test]
    fn students_t_has_its_tabulated_values() {
        for (freedom, t) in [(1, 12.7062), (2, 4.3027), (3, 3.1824), (4, 2.7764), (19, 2.0930), (49, 2.0096)] {
            assert!((students_t(freedom) - t).abs() < 5e-5, "{freedom}: {}", students_t(freedom));
        }
    }

    #[test]
    fn nineteen_of_twenty_intervals_cover_the_true_mean() {
        let mut stream = Stream::new(1, "test");
        let trials = 4000;
        let covering = (0..trials)
            .filter(|_| Mean::of(&std::array::from_fn::<f64, 4, _>(|_| 3.0 + stream.normal())).covers(3.0))
            .count();
        // Five standard deviations of the binomial distribution.
        let n = f64::from(trials);
        assert!((covering as f64 - 0.95 * n).abs() < 5.0 * (0.95 * 0.05 * n).sqrt(), "{covering}");
    }

    #[test]
    fn leaving_out_one_value_after_the_other_gives_the_standard_error_of_a_mean() {
        let sample = [1.0, 4.0, 2.0, 8.0, 5.0];
        let without = |k: usize| (sample.iter().sum::<f64>() - sample[k]) / 4.0;
        let error = jackknife(&std::array::from_fn::<f64, 5, _>(without));
        assert!((error - standard_error(&sample, 4.0)).abs() < 1e-12, "{error}");
    }

    #[test]
    fn one_value_says_nothing_about_the_width() {
        let alone = Mean::of(&[2.0]);
        assert!(alone.value == 2.0 && !alone.covers(2.0));
        assert_eq!(Mean::of(&[1.0, 1.0, 1.0]), Mean { value: 1.0, margin: 0.0 });
    }
}
