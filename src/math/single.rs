//! Three numbers in single precision, processed at once.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::Vec3A;

use super::vectors::Vector;

/// Three numbers in single precision, for what need not be exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Singles(Vec3A);

impl Vector {
    /// Rounds three numbers to single precision.
    #[inline(always)]
    pub(crate) fn to_singles(self) -> Singles {
        Singles(self.0.as_vec3a())
    }
}

impl Singles {
    /// This number three times.
    #[inline(always)]
    pub(crate) fn all(number: f32) -> Self {
        Self(Vec3A::splat(number))
    }

    #[inline(always)]
    pub(crate) fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// Clamps each to [−`most`, `most`]; none may be NaN.
    #[inline(always)]
    pub(crate) fn within(self, most: f32) -> Self {
        Self(self.0.min(Vec3A::splat(most)).max(Vec3A::splat(-most)))
    }

    /// One bit for each sign that is negative, that of −0 too; the first is the lowest.
    #[inline(always)]
    pub(crate) fn signs(self) -> usize {
        self.0.is_negative_bitmask() as usize
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [f32; 3] {
        self.0.to_array()
    }
}

macro_rules! operators {
    ($($operator:ident, $name:ident;)*) => {$(
        impl $operator for Singles {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(self.0.$name(other.0))
            }
        }
    )*};
}
operators! { Add, add; Sub, sub; Mul, mul; Div, div; }

impl Neg for Singles {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
