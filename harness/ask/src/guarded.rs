//! A judge that panics costs one case, not the run.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a judge says, or the text of its panic. Nothing that a judge leaves half done is used again: it reads a question
/// and answers, and what it asked of a subject is over.
pub fn guarded<T>(judge: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(judge)).map_err(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        text.unwrap_or_else(|| "a panic without a text".to_owned())
    })
}
