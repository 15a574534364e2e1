//! Laws of pictures: how two are compared, exact sums of replicas.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/properties.rs"]
mod properties;

mod compare;
#[cfg(unix)]
mod running;
mod sums;
mod verbs;
