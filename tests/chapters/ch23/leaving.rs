//! Leaving the surfaces of this chapter's kinds.

use crate::support::leaving::check_kinds;

/// Law: every kind of the chapter is left for good, at scales from 1e-6 to 1e6, up to a thousand
/// sizes from the origin and down to 1e-9 of grazing: what a ray that leaves hits next it meets from the
/// side that it left to, and it finds whatever lies beyond 8 error bounds. Oracle: what is closed is
/// left and entered in turn.
#[test]
fn every_kind_of_the_chapter_is_left_for_good() {
    check_kinds("ch23", [30, 80], 2390);
}

/// The same, at a thousand scales.
#[test]
#[ignore = "cost: cargo test ch23 -- --ignored"]
fn every_kind_of_the_chapter_is_left_for_good_thoroughly() {
    check_kinds("ch23", [1000, 1000], 2391);
}
