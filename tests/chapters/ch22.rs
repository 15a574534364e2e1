//! Chapter 22: acceleration. Only its equality with the list is promised so far; the book's regular
//! grid is not built.

mod chaos;
mod equal;
