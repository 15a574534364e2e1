//! Laws of scenes in other words: those of other renderers, plain ones, and the reference of scene files.

mod describe;
mod export;
mod scene_reference;
