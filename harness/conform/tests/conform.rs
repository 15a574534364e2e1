//! Laws of `conform`: the judge is judged.

mod altered;
mod book;
mod borders;
mod cards;
mod constants;
mod counted;
mod exact;
mod fields;
mod grades;
mod harmless;
mod known;
mod lines;
mod mistakes;
mod planted_scenes;
mod points;
mod programs;
mod radiance;
mod runs;
mod scenes;
mod streams;
mod undecided;
