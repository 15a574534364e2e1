//! Laws of texts: documents and their three prints, numbers, and what others read.

#[macro_use]
extern crate testkit;

mod digits;
mod document;
mod html;
mod percent;
#[cfg(unix)]
mod shell;
mod xml;
