//! `proptest`, with assertions that say the same as those of [`crate::asserts`].

pub use proptest::prelude::*;

macro_rules! property_holds {
    ($condition:expr $(, $($words:tt)*)?) => {
        match $condition {
            true => {}
            false => {
                let said = crate::asserts::untrue(stringify!($condition), law_words!($($($words)*)?));
                return Err(TestCaseError::fail(format!("{said}\nat {}:{}", file!(), line!())));
            }
        }
    };
}
pub(crate) use property_holds as prop_assert;

macro_rules! property_is {
    ($($compared:tt)+) => {
        if let Some(said) = difference!($($compared)+) {
            return Err(TestCaseError::fail(format!("{said}\nat {}:{}", file!(), line!())));
        }
    };
}
pub(crate) use property_is as prop_assert_eq;
