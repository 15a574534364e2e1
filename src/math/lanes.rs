//! One formula for one number at a time, or for several at once.

use std::ops::{Add, Div, Mul, Sub};

/// One number, or several: each operation is done for each of them.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// This number in each lane.
    fn all(self, number: f64) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// The lesser of each two; if one is NaN, the second.
    fn min(self, other: Self) -> Self;
    /// The greater of each two; if one is NaN, the second.
    fn max(self, other: Self) -> Self;
    /// A mask of the lanes where this is less; not set where either is NaN.
    fn less(self, than: Self) -> u8;
}

impl Lanes for f64 {
    #[inline(always)]
    fn all(self, number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    // `f64::min` handles NaN differently, which costs three more instructions
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn less(self, than: Self) -> u8 {
        u8::from(self < than)
    }
}
