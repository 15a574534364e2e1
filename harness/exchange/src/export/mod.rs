//! Scenes of ours as input of other renderers: what can be said there is written, and all that cannot is listed.
//!
//! [`kinds()`] is the table of what each kind becomes. [`pov`] writes the scene language of POV-Ray, [`mitsuba`] the XML of
//! Mitsuba 3.

mod exposure;
pub mod kinds;
pub mod leaves;
pub mod mitsuba;
mod parts;
pub mod pov;
mod target;
mod without;

use std::fmt;
use std::path::PathBuf;

use groundtruth::printable;

pub use exposure::exposure;
pub use kinds::{AnyKind, How, Row, kinds};
pub use leaves::Leaf;
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
    let things = groundtruth::explain::count(all.len(), "thing");
    format!("{things} in this scene cannot be said to {target}:\n{}", lines.join("\n"))
}

/// The path of an item of a list, with its name if it has one.
pub(crate) fn item(list: &str, index: usize, name: &str) -> String {
    match name {
        "" => format!("{list}[{index}]"),
        name => format!("{list}[{index}] \"{}\"", printable::name(name)),
    }
}

/// A number, with all of its digits.
pub(crate) fn number(number: f64) -> String {
    let is_short = number == 0.0 || (1e-6..1e15).contains(&number.abs());
    if is_short { format!("{number}") } else { format!("{number:e}") }
}

/// A program of this name: `given`, or the first of the folders in `PATH` that has it.
///
/// # Errors
/// There is none; the message says what to install or write.
pub fn program(name: &str, given: Option<PathBuf>, package: &str) -> Result<PathBuf, String> {
    // it is started in another folder
    let absolute = |file: PathBuf| std::path::absolute(&file).unwrap_or(file);
    if let Some(given) = given {
        return match given.is_file() {
            true => Ok(absolute(given)),
            false => Err(format!("--program {}: there is no such file", given.display())),
        };
    }
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&folders).map(|it| it.join(name)).find(|it| it.is_file());
    found.map(absolute).ok_or_else(|| {
        format!(
            "there is no program `{name}` on the path; install it (Debian: `apt-get install {package}`), or give its \
             file with --program"
        )
    })
}
