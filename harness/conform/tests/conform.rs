//! Laws of `conform`: the judge is judged.

mod altered;
mod book;
mod borders;
mod cards;
mod constants;
mod counted;
mod exact;
mod extreme;
mod fields;
mod handed;
mod harmless;
mod known;
mod lines;
mod mistakes;
mod notation;
mod planted_scenes;
mod programs;
mod radiance;
mod runs;
mod scenes;
mod small;
mod streams;
mod undecided;
