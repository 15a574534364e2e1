//! Words of the window.

use std::fmt::Display;

/// `1 ray`, `2 rays`.
pub fn counted(count: impl Into<u64> + Display + Copy, thing: &str) -> String {
    let s = if count.into() == 1 { "" } else { "s" };
    format!("{count} {thing}{s}")
}
