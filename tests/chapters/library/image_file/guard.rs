//! Decoders that panic.

use formats::images::guard::guarded;

/// Law: a panic is an error, and the next file is decoded. Oracle: the text.
#[test]
fn a_panic_of_a_decoder_is_an_error() {
    let problem = guarded::<(), String>(|| panic!("as a decoder does")).expect_err("it panics");
    assert!(problem.contains("damaged"), "{problem}");
    assert_eq!(guarded::<i32, String>(|| Ok(1)), Ok(1));
}
