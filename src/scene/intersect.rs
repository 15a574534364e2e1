//! The choice between the library's intersection routines and the book's.

/// How rays are intersected with objects.
#[kind(Default)]
#[schemars(title = "intersection routines")]
pub enum Intersect {
    /// The routines of this library: no epsilon, no lost roots, no gaps between triangles.
    #[default]
    Robust,
    /// The routines as printed in the book (chapters 3 and 19), with rays that start at the hit
    /// point and a constant epsilon. They show surface acne, lost roots and gaps between triangles.
    Textbook,
}

impl Intersect {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Robust, Self::Textbook];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Robust => "robust",
            Self::Textbook => "textbook",
        }
    }
}
