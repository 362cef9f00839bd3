//! Streams of random numbers, one for every purpose, the same on every machine.

use crate::spec::Real;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

/// Random numbers that depend only on the seed and on their purpose.
pub struct Stream(ChaCha12Rng);

impl Stream {
    /// The stream of a purpose; its first 24 bytes count.
    pub fn new(seed: u64, purpose: &str) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        for (slot, byte) in key[8..].iter_mut().zip(purpose.bytes()) {
            *slot = byte;
        }
        Self(ChaCha12Rng::from_seed(key))
    }

    /// Uniform between 0 (included) and 1.
    pub fn uniform(&mut self) -> f64 {
        self.0.random()
    }

    /// Normal with mean 0 and standard deviation 1, by Marsaglia's polar method.
    pub fn normal(&mut self) -> f64 {
        loop {
            let (u, v) = (2.0 * self.uniform() - 1.0, 2.0 * self.uniform() - 1.0);
            let s = u * u + v * v;
            if s > 0.0 && s < 1.0 {
                return u * (-2.0 * Real::ln(s) / s).sqrt();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_of_different_purposes_and_seeds_differ_and_repeat() {
        let draw = |seed, purpose| Stream::new(seed, purpose).uniform();
        assert_eq!(draw(1, "sizes"), draw(1, "sizes"));
        assert_ne!(draw(1, "sizes"), draw(1, "positions"));
        assert_ne!(draw(1, "sizes"), draw(2, "sizes"));
    }

    #[test]
    fn normal_numbers_have_mean_zero_and_variance_one() {
        let mut stream = Stream::new(7, "test");
        let n = 40_000;
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..n {
            let x = stream.normal();
            sum += x;
            squares += x * x;
        }
        // Five standard errors: of the mean 1/sqrt(n), of the variance sqrt(2/n).
        let n = f64::from(n);
        assert!((sum / n).abs() < 5.0 / n.sqrt(), "{}", sum / n);
        assert!((squares / n - 1.0).abs() < 5.0 * (2.0 / n).sqrt(), "{}", squares / n);
    }
}
