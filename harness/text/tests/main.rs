//! Laws of texts: documents and their three prints, numbers, and what others read.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/markup.rs"]
mod markup;

mod digits;
mod document;
mod html;
mod percent;
#[cfg(unix)]
mod shell;
mod xml;
