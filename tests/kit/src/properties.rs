//! `proptest`, with assertions that say the same as those of [`crate::asserts`].

pub use proptest::prelude::*;

/// As `assert!`, in a property.
#[macro_export]
macro_rules! property_holds {
    ($condition:expr $(, $($words:tt)*)?) => {
        match $condition {
            true => {}
            false => {
                let said = $crate::asserts::untrue(stringify!($condition), $crate::law_words!($($($words)*)?));
                return Err($crate::properties::TestCaseError::fail(format!("{said}\nat {}:{}", file!(), line!())));
            }
        }
    };
}
pub use crate::property_holds as prop_assert;

/// As `assert_eq!`, in a property.
#[macro_export]
macro_rules! property_is {
    ($($compared:tt)+) => {
        if let Some(said) = $crate::difference!($($compared)+) {
            return Err($crate::properties::TestCaseError::fail(format!("{said}\nat {}:{}", file!(), line!())));
        }
    };
}
pub use crate::property_is as prop_assert_eq;
