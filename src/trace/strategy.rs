//! The book's tracers as values.

use crate::scene::Tracer;

/// How light is followed: every tracer of the book is a value of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Strategy {
    /// What is followed from a hit.
    pub scatter: Scatter,
    /// A ray is cast if at most so many edges are before it.
    pub max_depth: u32,
}

/// What is followed from a hit. Lights are sampled at every hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scatter {
    /// Nothing.
    Nothing,
    /// Each lobe that lights' samples do not meet: a tree.
    TracedLobes,
}

impl Strategy {
    /// What the tracer of a scene does.
    pub fn of(tracer: Tracer) -> Self {
        match tracer {
            Tracer::RayCast => Self { scatter: Scatter::Nothing, max_depth: 0 },
            Tracer::Whitted(whitted) => {
                Self { scatter: Scatter::TracedLobes, max_depth: whitted.max_depth }
            }
        }
    }
}
