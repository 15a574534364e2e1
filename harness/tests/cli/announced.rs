//! Long renderings are announced.

#[path = "../../cli/announce.rs"]
#[allow(dead_code)] // the commands use the rest of it
pub mod announce;

use self::announce::words;

/// Law: only long renderings are announced, with their size and time in a fitting unit. Oracle: written by hand.
#[test]
fn long_renderings_are_announced() {
    assert_eq!(words("a", 1, [3, 2], 4.9), None);
    let said = |pictures, seconds| words("a", pictures, [1, 100_000], seconds).expect("long");
    assert_eq!(said(1, 40.2), "a is rendered at the size of the picture, 1 × 100000: about 40 s");
    assert!(
        said(8, 300.0)
            .ends_with("rendered 8 times at the size of the picture, 1 × 100000: about 5 min")
    );
    assert!(said(1, 7200.0).ends_with("about 2 h"));
}
