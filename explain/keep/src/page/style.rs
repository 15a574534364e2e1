//! The rules of the page: light on every screen, readable from the last row of a room, and on paper of size A4.

use std::fmt::Write;

/// After the rules that all pages have in common.
pub const STYLE: &str = include_str!("style.css");

/// The most rays that light up together.
const LINKED: usize = 40;

/// Rules that light up a ray everywhere on the page if the pointer is on it anywhere.
pub fn linked(rays: usize) -> String {
    let mut rules = String::new();
    for ray in 0..rays.min(LINKED) {
        let _ = writeln!(
            rules,
            "body:has([data-ray=\"{ray}\"]:hover) summary[data-ray=\"{ray}\"] {{ background: #ffe9a8; }}\n\
             body:has([data-ray=\"{ray}\"]:hover) :is(polyline, g)[data-ray=\"{ray}\"] {{ filter: drop-shadow(0 0 4px \
             #f80); }}"
        );
    }
    rules
}
