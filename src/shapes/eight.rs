//! Eight numbers of double precision at once, by AVX2 or AVX-512.
//!
//! Everything is inlined into code that is compiled for these instructions, and no function has
//! them as an attribute: such functions are not always inlined, and a call for each operation would
//! cost more than the operation. Sums and products round as those of `f64` do.

#![allow(unsafe_code, reason = "instructions that not every processor has")]
#![allow(clippy::missing_safety_doc, reason = "one condition for all, said of the trait")]

/// Eight numbers.
///
/// # Safety
/// All methods may be called only where the processor has the instructions.
pub trait Eight: Copy {
    unsafe fn load(from: &[f64; 8]) -> Self;
    /// The same number eight times.
    unsafe fn all(one: f64) -> Self;
    unsafe fn minus(self, other: Self) -> Self;
    unsafe fn times(self, other: Self) -> Self;
    /// The lesser of each two; one that is no number may be overlooked.
    unsafe fn min(self, other: Self) -> Self;
    unsafe fn max(self, other: Self) -> Self;
    /// For each place the number at that one of the eight places.
    unsafe fn pick(self, places: &[u8; 8]) -> Self;
    /// Where this is less, one bit each; never where either is no number.
    unsafe fn less(self, than: Self) -> u8;
}

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512};

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;

    use super::Eight;

    /// Needs AVX2.
    #[derive(Clone, Copy)]
    pub struct Avx2(__m256d, __m256d);

    /// Needs AVX-512.
    #[derive(Clone, Copy)]
    pub struct Avx512(__m512d);

    impl Eight for Avx512 {
        #[inline(always)]
        unsafe fn load(from: &[f64; 8]) -> Self {
            // SAFETY: there are eight; here and below, the processor has the instructions
            Self(unsafe { _mm512_loadu_pd(from.as_ptr()) })
        }

        #[inline(always)]
        unsafe fn all(one: f64) -> Self {
            Self(unsafe { _mm512_set1_pd(one) })
        }

        #[inline(always)]
        unsafe fn minus(self, other: Self) -> Self {
            Self(unsafe { _mm512_sub_pd(self.0, other.0) })
        }

        #[inline(always)]
        unsafe fn times(self, other: Self) -> Self {
            Self(unsafe { _mm512_mul_pd(self.0, other.0) })
        }

        #[inline(always)]
        unsafe fn min(self, other: Self) -> Self {
            Self(unsafe { _mm512_min_pd(self.0, other.0) })
        }

        #[inline(always)]
        unsafe fn max(self, other: Self) -> Self {
            Self(unsafe { _mm512_max_pd(self.0, other.0) })
        }

        #[inline(always)]
        unsafe fn pick(self, places: &[u8; 8]) -> Self {
            let places = unsafe { _mm_cvtsi64_si128(i64::from_le_bytes(*places)) };
            Self(unsafe { _mm512_permutexvar_pd(_mm512_cvtepu8_epi64(places), self.0) })
        }

        #[inline(always)]
        unsafe fn less(self, than: Self) -> u8 {
            unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, than.0) }
        }
    }

    impl Eight for Avx2 {
        #[inline(always)]
        unsafe fn load(from: &[f64; 8]) -> Self {
            // SAFETY: there are eight; here and below, the processor has the instructions
            unsafe { Self(_mm256_loadu_pd(from.as_ptr()), _mm256_loadu_pd(from.as_ptr().add(4))) }
        }

        #[inline(always)]
        unsafe fn all(one: f64) -> Self {
            unsafe { Self(_mm256_set1_pd(one), _mm256_set1_pd(one)) }
        }

        #[inline(always)]
        unsafe fn minus(self, other: Self) -> Self {
            unsafe { Self(_mm256_sub_pd(self.0, other.0), _mm256_sub_pd(self.1, other.1)) }
        }

        #[inline(always)]
        unsafe fn times(self, other: Self) -> Self {
            unsafe { Self(_mm256_mul_pd(self.0, other.0), _mm256_mul_pd(self.1, other.1)) }
        }

        #[inline(always)]
        unsafe fn min(self, other: Self) -> Self {
            unsafe { Self(_mm256_min_pd(self.0, other.0), _mm256_min_pd(self.1, other.1)) }
        }

        #[inline(always)]
        unsafe fn max(self, other: Self) -> Self {
            unsafe { Self(_mm256_max_pd(self.0, other.0), _mm256_max_pd(self.1, other.1)) }
        }

        #[inline(always)]
        unsafe fn pick(self, places: &[u8; 8]) -> Self {
            let places = u64::from_le_bytes(*places);
            unsafe { Self(self.pick_four(places as u32), self.pick_four((places >> 32) as u32)) }
        }

        #[inline(always)]
        unsafe fn less(self, than: Self) -> u8 {
            unsafe {
                let low = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, than.0));
                let high = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.1, than.1));
                (low | high << 4) as u8
            }
        }
    }

    impl Avx2 {
        /// By the lower two bits of its place from both halves, by the third from one of them. (A
        /// double moves as two singles.)
        #[inline(always)]
        unsafe fn pick_four(self, places: u32) -> __m256d {
            unsafe {
                let places = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(places as i32));
                let twice = _mm256_or_si256(places, _mm256_slli_epi64::<32>(places));
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
