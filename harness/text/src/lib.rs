//! What people read, and where it is printed: a [`document`] is a tree of elements, printed for a terminal, as HTML or
//! as Markdown; [`told`] is the form in which verdicts are said; [`brief`], [`digits`] and [`percent`] are numbers for people; and
//! text is made safe for pages ([`html`]), the [`shell`] and [`xml`]; [`loose`] reads numbers that JSON does not have.

pub mod brief;
pub mod digits;
pub mod document;
pub mod html;
pub mod loose;
mod markdown;
pub mod percent;
mod plain;
pub mod shell;
mod table;
pub mod told;
pub mod xml;
