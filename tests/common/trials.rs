//! The number of trials and their seed, which the environment may set.

/// The number in a variable of the environment, 1 unless it is set.
pub(crate) fn setting(name: &str) -> u64 {
    std::env::var(name).map_or(1, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}: no number")))
}
