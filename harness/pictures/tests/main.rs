//! Laws of pictures: how two are compared, exact sums of replicas.

#[macro_use]
extern crate testkit;

mod compare;
#[cfg(unix)]
mod running;
mod sums;
mod verbs;
