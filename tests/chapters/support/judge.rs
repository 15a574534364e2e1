//! Assertion macros for numbers: each reports the measured value, the expected value and their distance. A
//! message on the case may follow the values, as in `assert!`.

use std::fmt::Debug;
use std::ops::Sub;

use crate::prelude::*;
use testkit::properties::*;

/// How large a difference is.
pub trait Size {
    fn size(self) -> f64;
}

impl Size for f64 {
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Size for Vector {
    fn size(self) -> f64 {
        self.length()
    }
}

/// The error message for a value that should be near another one; `None` if it is near.
pub fn far<A, B>(found: A, expected: B, tolerance: f64) -> Option<String>
where
    A: Copy + Debug + Sub<B>,
    B: Copy + Debug,
    A::Output: Size,
{
    let apart = (found - expected).size();
    // a NaN is near nothing
    let is_near = apart <= tolerance;
    (!is_near).then(|| {
        format!("found {found:?}, expected {expected:?}: {apart:e} apart, allowed {tolerance:e}")
    })
}

/// Fails unless two numbers, points or vectors are within a distance of each other: the measured one, the
/// expected one, the distance.
macro_rules! near {
    ($found:expr, $expected:expr, $tolerance:expr $(, $($words:tt)+)?) => {
        if let Some(wrong) = crate::support::judge::far($found, $expected, $tolerance) {
            panic!("`{}`: {wrong}{}", stringify!($found), judge_words!($($($words)+)?))
        }
    };
}

/// The largest difference of two colours in any channel, as a share of the larger value there.
pub fn off(found: Rgb, expected: Rgb) -> f64 {
    let channels = found.to_array().into_iter().zip(expected.to_array());
    let shares = channels.map(|(a, b)| match (a - b).abs() {
        0.0 => 0.0,
        apart => apart / a.abs().max(b.abs()),
    });
    shares.fold(0.0, |most, share| if share > most || share.is_nan() { share } else { most })
}

/// Fails unless two colours differ in each channel by no more than a share of the larger value: the
/// measured one, the expected one, the share.
macro_rules! close {
    ($found:expr, $expected:expr, $tolerance:expr $(, $($words:tt)+)?) => {{
        let (found, expected, tolerance): (_, _, f64) = ($found, $expected, $tolerance);
        if !crate::support::stage::close(found, expected, tolerance) {
            panic!(
                "`{}`: found {found:?}, expected {expected:?}: {:e} of it apart, allowed {tolerance:e}{}",
                stringify!($found),
                crate::support::judge::off(found, expected),
                judge_words!($($($words)+)?)
            )
        }
    }};
}

/// Fails unless the first value is below the second.
macro_rules! below {
    ($found:expr, $limit:expr $(, $($words:tt)+)?) => {
        in_order!($found, <, $limit, "less than", judge_words!($($($words)+)?))
    };
}

/// Fails unless the first value is below the second or equal to it.
macro_rules! at_most {
    ($found:expr, $limit:expr $(, $($words:tt)+)?) => {
        in_order!($found, <=, $limit, "at most", judge_words!($($($words)+)?))
    };
}

/// Fails unless the first value is above the second.
macro_rules! above {
    ($found:expr, $limit:expr $(, $($words:tt)+)?) => {
        in_order!($found, >, $limit, "more than", judge_words!($($($words)+)?))
    };
}

/// Fails unless the first value is above the second or equal to it.
macro_rules! at_least {
    ($found:expr, $limit:expr $(, $($words:tt)+)?) => {
        in_order!($found, >=, $limit, "at least", judge_words!($($($words)+)?))
    };
}

macro_rules! in_order {
    ($found:expr, $order:tt, $limit:expr, $expected:literal, $words:expr) => {
        match (&$found, &$limit) {
            (found, limit) if found $order limit => {}
            (found, limit) => panic!(
                "`{}`: found {found:?}, expected {} {limit:?}, `{}`{}",
                stringify!($found),
                $expected,
                stringify!($limit),
                $words
            ),
        }
    };
}

/// The message on a case.
macro_rules! judge_words {
    () => {
        testkit::asserts::opened()
    };
    ($($words:tt)+) => {
        format!("; {}{}", format!($($words)+), testkit::asserts::opened())
    };
}

/// Law: the macros accept values that are near or in order, refuse others, NaN included, and report both
/// values and their distance. Oracle: texts written by hand.
#[test]
fn verbs_say_what_was_found_and_what_was_expected() {
    near!(1.0, 1.25, 0.25);
    close!(Rgb::new(1.0, 2.0, 0.0), Rgb::new(1.0, 1.5, 0.0), 0.25);
    below!(1, 2);
    at_most!(1, 1);
    above!(2, 1);
    at_least!(1, 1);
    let said = |law: fn()| {
        let payload = std::panic::catch_unwind(law).expect_err("it is refused");
        payload.downcast_ref::<String>().expect("a text").clone()
    };
    let text = said(|| near!(1.0 + 1.0, 1.5, 0.25, "case {}", 7));
    assert_eq!(text, "`1.0 + 1.0`: found 2.0, expected 1.5: 5e-1 apart, allowed 2.5e-1; case 7");
    let text = said(|| close!(Rgb::new(1.0, 2.0, 0.0), Rgb::new(1.0, 1.5, 0.0), 1e-3));
    assert!(text.ends_with(": 2.5e-1 of it apart, allowed 1e-3"), "{text}");
    assert_eq!(said(|| below!(1, 1)), "`1`: found 1, expected less than 1, `1`");
    assert_eq!(said(|| at_most!(2, 1)), "`2`: found 2, expected at most 1, `1`");
    assert_eq!(said(|| above!(1, 1)), "`1`: found 1, expected more than 1, `1`");
    assert_eq!(said(|| at_least!(1, 2)), "`1`: found 1, expected at least 2, `2`");
    assert_eq!(said(|| assert!(1 > 2)), "found the opposite, expected `1 > 2`");
    assert_eq!(said(|| assert!(1 > 2, "{}", 7)), "found 7\nexpected `1 > 2`");
    assert_eq!(said(|| assert_eq!(1 + 1, 3)), "`1 + 1`\n   found 2\nexpected 3");
    assert_eq!(
        said(|| assert_eq!(0.5, 1.0, "case {}", 7)),
        "`0.5`; case 7\n   found 0.5\nexpected 1.0"
    );
    let property = || {
        prop_assert_eq!(1 + 1, 3, "case {}", 7);
        Ok(())
    };
    let TestCaseError::Fail(text) = property().expect_err("it is refused") else { unreachable!() };
    assert!(text.message().starts_with("`1 + 1`; case 7\n   found 2\nexpected 3\nat "), "{text}");
    assert_eq!(said(|| assert_eq!(f64::NAN, f64::NAN)), "`f64::NAN`\n   found NaN\nexpected NaN");
    let refused: [fn(); 3] =
        [|| near!(f64::NAN, 0.0, 1.0), || at_most!(f64::NAN, 0.0), || above!(f64::NAN, 0.0)];
    for law in refused {
        assert!(said(law).contains("found NaN"), "{}", said(law));
    }
}
