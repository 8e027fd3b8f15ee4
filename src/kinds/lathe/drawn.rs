//! What the drawings of a turning show.

/// A closed contour in the half section, `[z, r]` from the part zero W1, mm; the last point is joined to the first.
pub type Contour = Vec<[f64; 2]>;

/// What is drawn, all in `[z, r]` from W1.
#[derive(Clone, Debug, Default)]
pub struct Drawn {
    /// The metal that is left.
    pub part: Vec<Contour>,
    /// The stock.
    pub stock: Vec<Contour>,
    /// Chuck body, jaws and tailstock.
    pub chuck: Vec<Contour>,
    /// The wanted profile, if there is one.
    pub wanted: Vec<[f64; 2]>,
    /// The paths of the tools at feed, each motion with its chords.
    pub feed: Vec<Vec<[f64; 2]>>,
    /// The same in rapid.
    pub rapid: Vec<Vec<[f64; 2]>>,
}
