//! Scenes of ours as input of other renderers: what can be said there is written, and all that cannot is listed.
//!
//! [`kinds()`] is the table of what each kind becomes. [`Target`] lists the other renderers; each has a folder, which writes
//! its language.

mod checkers;
mod exposure;
pub mod kinds;
pub mod leaves;
mod mitsuba;
mod parts;
mod pov;
mod renderer;
mod target;
mod without;
mod writer;

use std::fmt;

use groundtruth::printable;

pub use exposure::exposure;
pub use kinds::{AnyKind, How, KindRow, kinds};
pub use leaves::Leaf;
pub use renderer::Renderer;
pub use target::{Exported, Target};
pub use without::Term;

/// Something of a scene that another renderer cannot say, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported {
    /// Its place in the scene, as `objects[2] "ball": shape.lattice`.
    pub path: String,
    /// Why it cannot be said.
    pub problem: String,
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.problem)
    }
}

/// All that cannot be said of a scene, a line each.
pub fn listed(target: &str, all: &[Unsupported]) -> String {
    let lines: Vec<String> = all.iter().map(|it| format!("  {it}")).collect();
    let things = text::brief::count(all.len(), "thing");
    format!("{things} in this scene cannot be said to {target}:\n{}", lines.join("\n"))
}

/// The path of an item of a list, with its name if it has one.
pub(crate) fn item(list: &str, index: usize, name: &str) -> String {
    match name {
        "" => format!("{list}[{index}]"),
        name => format!("{list}[{index}] \"{}\"", printable::name(name)),
    }
}

/// The shortest decimal number that reads back as this one.
pub(crate) fn number(number: f64) -> String {
    let is_short = number == 0.0 || (1e-6..1e15).contains(&number.abs());
    if is_short { format!("{number}") } else { format!("{number:e}") }
}
