//! Laws of the golden images: how they are kept and compared.

#[macro_use]
extern crate testkit;

mod counted;
mod goldens;
mod review;
