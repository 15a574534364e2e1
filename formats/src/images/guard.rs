//! Panics of other crates' decoders, made errors.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    static IS_DECODING: Cell<bool> = const { Cell::new(false) };
}

/// What `decode` returns. If it panics, nothing is printed and the file counts as damaged.
///
/// # Errors
/// Those of `decode`, and that the file is damaged.
pub fn guarded<T, E: From<String>>(decode: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
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
