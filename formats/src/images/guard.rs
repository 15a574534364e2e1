//! Panics of other crates' decoders, made errors.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use super::Wrong;

thread_local! {
    static IS_DECODING: Cell<bool> = const { Cell::new(false) };
}

/// What `decode` returns. If it panics, nothing is printed and the file counts as damaged.
pub fn guarded<T>(decode: impl FnOnce() -> Result<T, Wrong>) -> Result<T, Wrong> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |info| {
            if !IS_DECODING.get() {
                usual(info);
            }
        }));
    });
    let outer = IS_DECODING.replace(true);
    let result = catch_unwind(AssertUnwindSafe(decode));
    IS_DECODING.set(outer);
    let unnamed = || "it is damaged in a way that its decoder cannot name".to_owned();
    result.unwrap_or_else(|_| Err(unnamed().into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: a panic is an error, and the next file is decoded. Oracle: the text.
    #[test]
    fn a_panic_of_a_decoder_is_an_error() {
        let problem = guarded::<()>(|| panic!("as a decoder does")).expect_err("it panics");
        assert!(problem.problem.contains("damaged"), "{problem:?}");
        assert_eq!(guarded(|| Ok(1)), Ok(1));
    }
}
