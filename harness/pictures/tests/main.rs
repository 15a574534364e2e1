//! Laws of pictures: how two are compared, exact sums of replicas, and texts that others read.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/properties.rs"]
mod properties;

mod compare;
mod digits;
mod html;
mod percent;
#[cfg(unix)]
mod running;
#[cfg(unix)]
mod shell;
mod sums;
mod verbs;
mod xml;
