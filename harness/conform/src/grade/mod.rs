//! Grades: what a teacher asks of a program, the points that it gets, and hints that do not give answers away.
//!
//! A [`Table`] is a file of parts, each with points and with words that select families. [`Grade::of`] asks a program
//! all of them at once, by the profile *book*, so that a program in single precision loses nothing.
//! Students may read [`Grade::text`] and [`results`]: no question, no answer, no seed, no name of a mistake and
//! nothing that their program wrote is in them, since it may have written a question down. [`Grade::json`] has all,
//! for the teacher.

mod class;
mod gradescope;
mod hint;
mod points;
mod table;
mod text;

pub use class::{ClassError, with_row};
pub use gradescope::results;
pub use points::{Grade, PartGrade};
pub use table::{TEMPLATE, TEMPLATE_SEED, Table};
