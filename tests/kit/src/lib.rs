//! What the laws of several packages share.
//!
//! `#[macro_use] extern crate testkit;` puts its `assert!` and `assert_eq!` into the place of the standard ones.

pub mod asserts;
pub mod cases;
pub mod markup;
pub mod properties;
pub mod same_text;
pub mod scaling;

/// How many cases a law tries: `usual` ones, or with THOROUGH=1 in the environment `many`, which takes minutes.
pub fn as_many<T>(usual: T, many: T) -> T {
    if is_thorough() { many } else { usual }
}

/// Whether laws try all that they can, however long it takes: THOROUGH=1 in the environment.
pub fn is_thorough() -> bool {
    std::env::var_os("THOROUGH").is_some_and(|it| it == "1")
}
