//! What is known while a verdict is made, in words for a terminal and a window.

use std::fmt;

use super::Evaluation;

/// How far a verdict is.
#[derive(Clone, Copy, Debug)]
pub enum Progress<'a> {
    /// The picture was held against the replicas that are rendered at first. Told once, unless these have no noise.
    Preliminary(&'a Evaluation),
    /// It was held against more; told before each further replica.
    Judged(&'a Evaluation),
    /// It differs, and explanations are tried.
    Explaining,
}

impl fmt::Display for Progress<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Preliminary(judged) | Self::Judged(judged) => {
                let ours = judged.pool.count() - 1;
                match judged.ranking.as_far_as(ours) {
                    0 => write!(f, "so far: differs — none of {ours} of ours is as far out"),
                    1 => write!(f, "so far: agrees — 1 of {ours} of ours is as far out"),
                    far => write!(f, "so far: agrees — {far} of {ours} of ours are as far out"),
                }
            }
            Self::Explaining => write!(f, "differs; explanations are tried"),
        }
    }
}
