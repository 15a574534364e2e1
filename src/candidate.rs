//! A hit that may turn out not to be the nearest.

/// What a shape answers a ray with: enough to compare distances, and to work out the surface later.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Where along the ray, in units of its direction.
    pub t: f64,
    /// Which of the shapes inside a compound, counted through all that are nested in it: those of
    /// its first part, then those of its second …; 0 for a shape that holds no others.
    pub leaf: u64,
    /// Which face of a box, which triangle of a mesh; 0 for shapes of one part.
    pub part: u32,
    /// Two parameters on that part, such as barycentric coordinates; 0 where none are needed.
    pub parameters: [f64; 2],
}

impl Candidate {
    /// A hit of a shape of one part.
    pub fn at(t: f64) -> Self {
        Self { t, leaf: 0, part: 0, parameters: [0.0; 2] }
    }
}
