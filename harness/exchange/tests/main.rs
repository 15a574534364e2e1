//! Laws of scenes in other words: those of other renderers, and plain ones.

mod describe;
mod export;
mod framing;
