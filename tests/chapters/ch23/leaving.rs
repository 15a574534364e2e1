//! Leaving the surfaces of this chapter's kinds.

use crate::support::leaving::check_kinds;

/// Law: a ray that leaves a surface of any kind of the chapter does not hit the same point again. If it
/// leaves to the outside, it hits the next surface from outside, and if to the inside, from inside. It
/// finds every surface that is more than 8 error bounds away. Scales are from 1e-6 to 1e6, distances
/// from the origin up to a thousand sizes, angles to the surface down to 1e-9. Oracle: a ray leaves and
/// enters a closed solid in turn.
#[test]
fn every_kind_of_the_chapter_is_left_for_good() {
    check_kinds("ch23", 2390);
}
