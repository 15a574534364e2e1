//! Eight numbers at a time by AVX2 or AVX-512, for formulas of [`Lanes`].
//!
//! Everything is inlined into code that is compiled for these instructions. No function has a
//! `target_feature` attribute: such functions are not always inlined, and a call costs more than
//! the operation. All operations round as those of `f64` do.

use crate::math::Lanes;

/// Eight numbers. A value of this type proves that the processor has the instructions.
pub trait Eight: Lanes {
    /// # Safety
    /// The processor has the instructions.
    #[allow(unsafe_code, reason = "instructions that not every processor has")]
    unsafe fn load(from: &[f64; 8]) -> Self;
    fn store(self, to: &mut [f64; 8]);
    /// For each lane, the number in the lane of this index.
    fn pick(self, indices: &[u8; 8]) -> Self;
}

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512};

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code, reason = "instructions that not every processor has")]
mod x86 {
    use std::arch::x86_64::*;
    use std::ops::{Add, Div, Mul, Sub};

    use super::Eight;
    use crate::math::Lanes;

    /// Needs AVX2.
    #[derive(Clone, Copy)]
    pub struct Avx2(__m256d, __m256d);

    /// Needs AVX-512 (F).
    #[derive(Clone, Copy)]
    pub struct Avx512(__m512d);

    macro_rules! operators {
        ($($operator:ident, $name:ident: $four:ident, $eight:ident;)*) => {$(
            impl $operator for Avx512 {
                type Output = Self;
                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    // SAFETY: here and below, there is a value, so the processor has the instructions
                    Self(unsafe { $eight(self.0, other.0) })
                }
            }

            impl $operator for Avx2 {
                type Output = Self;
                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    unsafe { Self($four(self.0, other.0), $four(self.1, other.1)) }
                }
            }
        )*};
    }

    operators! {
        Add, add: _mm256_add_pd, _mm512_add_pd;
        Sub, sub: _mm256_sub_pd, _mm512_sub_pd;
        Mul, mul: _mm256_mul_pd, _mm512_mul_pd;
        Div, div: _mm256_div_pd, _mm512_div_pd;
    }

    impl Lanes for Avx512 {
        #[inline(always)]
        fn all(self, number: f64) -> Self {
            Self(unsafe { _mm512_set1_pd(number) })
        }

        #[inline(always)]
        fn abs(self) -> Self {
            Self(unsafe { _mm512_abs_pd(self.0) })
        }

        #[inline(always)]
        fn min(self, other: Self) -> Self {
            Self(unsafe { _mm512_min_pd(self.0, other.0) })
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Self(unsafe { _mm512_max_pd(self.0, other.0) })
        }

        #[inline(always)]
        fn less(self, than: Self) -> u8 {
            unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, than.0) }
        }
    }

    impl Eight for Avx512 {
        #[inline(always)]
        unsafe fn load(from: &[f64; 8]) -> Self {
            // SAFETY: there are eight; and the caller's
            Self(unsafe { _mm512_loadu_pd(from.as_ptr()) })
        }

        #[inline(always)]
        fn store(self, to: &mut [f64; 8]) {
            unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) };
        }

        #[inline(always)]
        fn pick(self, indices: &[u8; 8]) -> Self {
            unsafe {
                let indices = _mm_cvtsi64_si128(i64::from_le_bytes(*indices));
                Self(_mm512_permutexvar_pd(_mm512_cvtepu8_epi64(indices), self.0))
            }
        }
    }

    impl Lanes for Avx2 {
        #[inline(always)]
        fn all(self, number: f64) -> Self {
            unsafe { Self(_mm256_set1_pd(number), _mm256_set1_pd(number)) }
        }

        #[inline(always)]
        fn abs(self) -> Self {
            unsafe {
                let sign = _mm256_set1_pd(-0.0);
                Self(_mm256_andnot_pd(sign, self.0), _mm256_andnot_pd(sign, self.1))
            }
        }

        #[inline(always)]
        fn min(self, other: Self) -> Self {
            unsafe { Self(_mm256_min_pd(self.0, other.0), _mm256_min_pd(self.1, other.1)) }
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            unsafe { Self(_mm256_max_pd(self.0, other.0), _mm256_max_pd(self.1, other.1)) }
        }

        #[inline(always)]
        fn less(self, than: Self) -> u8 {
            unsafe {
                let low = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, than.0));
                let high = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.1, than.1));
                (low | high << 4) as u8
            }
        }
    }

    impl Eight for Avx2 {
        #[inline(always)]
        unsafe fn load(from: &[f64; 8]) -> Self {
            // SAFETY: there are eight; and the caller's
            unsafe { Self(_mm256_loadu_pd(from.as_ptr()), _mm256_loadu_pd(from.as_ptr().add(4))) }
        }

        #[inline(always)]
        fn store(self, to: &mut [f64; 8]) {
            unsafe {
                _mm256_storeu_pd(to.as_mut_ptr(), self.0);
                _mm256_storeu_pd(to.as_mut_ptr().add(4), self.1);
            }
        }

        #[inline(always)]
        fn pick(self, indices: &[u8; 8]) -> Self {
            let indices = u64::from_le_bytes(*indices);
            Self(self.pick_four(indices as u32), self.pick_four((indices >> 32) as u32))
        }
    }

    impl Avx2 {
        /// The lower two bits of an index select a number from each half, the third bit selects the
        /// half. (A double is moved as two singles.)
        #[inline(always)]
        fn pick_four(self, indices: u32) -> __m256d {
            unsafe {
                let indices = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(indices as i32));
                let twice = _mm256_or_si256(indices, _mm256_slli_epi64::<32>(indices));
                let halves = _mm256_set1_epi64x(1 << 32);
                let singles = _mm256_add_epi32(_mm256_slli_epi32::<1>(twice), halves);
                let low = _mm256_permutevar8x32_ps(_mm256_castpd_ps(self.0), singles);
                let high = _mm256_permutevar8x32_ps(_mm256_castpd_ps(self.1), singles);
                let third = _mm256_castsi256_ps(_mm256_slli_epi32::<29>(twice));
                _mm256_castps_pd(_mm256_blendv_ps(low, high, third))
            }
        }
    }
}
