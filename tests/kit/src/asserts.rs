//! The assertions of laws, in place of the standard ones of the same names: one that fails says what was measured (its source
//! text), what was found and what was expected, and after them the words of the law on its case.

use std::cell::RefCell;
use std::fmt::Debug;

type Opened = Box<dyn Fn() -> String>;

thread_local! {
    static OPENED: RefCell<Option<Opened>> = RefCell::new(None);
}

/// From now on a law of this thread that fails ends its message with what this says: how to open the scene that it is about.
pub fn on_failure(opened: impl Fn() -> String + 'static) {
    OPENED.set(Some(Box::new(opened)));
}

/// What [`on_failure`] was told, as a line of its own.
pub fn opened() -> String {
    OPENED.with_borrow(|it| it.as_ref().map_or(String::new(), |opened| format!("\n{}", opened())))
}

/// What a failed comparison says.
pub fn unequal(
    what: &str,
    found: &dyn Debug,
    expected: &dyn Debug,
    words: Option<String>,
) -> String {
    let words = words.map_or(String::new(), |words| format!("; {words}"));
    format!("`{what}`{words}\n   found {found:?}\nexpected {expected:?}{}", opened())
}

/// What a failed condition says.
pub fn untrue(condition: &str, words: Option<String>) -> String {
    let opened = opened();
    match words {
        Some(words) => {
            let found = words.strip_prefix("found ").unwrap_or(&words);
            format!("found {found}\nexpected `{condition}`{opened}")
        }
        None => format!("found the opposite, expected `{condition}`{opened}"),
    }
}

/// The message on a case, if there is one.
#[macro_export]
macro_rules! law_words {
    () => {
        None
    };
    ($($words:tt)+) => {
        Some(format!($($words)+))
    };
}

/// Fails unless the condition holds; the words are those of the law on its case.
#[macro_export]
macro_rules! assert {
    ($condition:expr $(, $($words:tt)*)?) => {
        // not `if !`: what is compared may be NaN
        match $condition {
            true => {}
            false => {
                panic!("{}", $crate::asserts::untrue(stringify!($condition), $crate::law_words!($($($words)*)?)))
            }
        }
    };
}

/// What a comparison says if it fails.
#[macro_export]
macro_rules! difference {
    ($found:expr, $expected:expr $(, $($words:tt)*)?) => {
        match (&$found, &$expected) {
            (found, expected) if *found == *expected => None,
            (found, expected) => {
                let words = $crate::law_words!($($($words)*)?);
                Some($crate::asserts::unequal(stringify!($found), &found, &expected, words))
            }
        }
    };
}

/// Fails unless both are equal: what was found, then what was expected.
#[macro_export]
macro_rules! assert_eq {
    ($($compared:tt)+) => {
        if let Some(said) = $crate::difference!($($compared)+) {
            panic!("{said}")
        }
    };
}
