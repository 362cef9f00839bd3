//! What the book shows of a paper beside its equations.

/// A table of parameters that a paper prints, by the keys of a case that has its values.
pub struct Table {
    /// Its number, such as `Table 1`.
    pub number: &'static str,
    /// What it lists.
    pub title: &'static str,
    /// The case file, from the root of the repository.
    pub case: &'static str,
    /// The keys of the model; none for all.
    pub keys: &'static [&'static str],
}

/// A contact law whose forces are drawn: with the normal pulled apart, and sheared to and fro.
pub struct Law {
    /// The id of an equation, or of a law that is exported beside them.
    pub id: &'static str,
    /// What it is.
    pub title: &'static str,
    /// The range of gaps over which the spheres are pulled apart, m.
    pub gaps: [f64; 2],
    /// The gap at which they are sheared, m.
    pub gap: f64,
    /// How far they are sheared, m.
    pub path: f64,
    /// The values of the other arguments, in SI.
    pub values: Vec<(&'static str, f64)>,
}
