//! Laws of `conform`: the judge is judged.

mod altered;
mod book;
mod constants;
mod exact;
mod harmless;
mod mistakes;
mod processes;
mod radiance;
mod runs;
mod scenes;
mod statuses;
mod streams;
