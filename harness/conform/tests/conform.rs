//! Laws of `conform`: the judge is judged.

mod altered;
mod book;
mod constants;
mod exact;
mod grades;
mod harmless;
mod lines;
mod mistakes;
mod planted_scenes;
mod radiance;
mod runs;
mod scenes;
mod streams;
