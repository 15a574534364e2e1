//! Eight or sixteen numbers of single precision, by AVX2 or AVX-512.
//!
//! Everything is inlined into code that is compiled for these instructions; see
//! `lanes64.rs`, where the same is done in double precision.

/// Several numbers: each operation is done for each of them. A value of this type proves that the
/// processor has the instructions.
#[allow(unsafe_code, reason = "instructions that not every processor has")]
pub trait Lanes: Copy {
    /// The number of lanes.
    const COUNT: usize;

    /// # Safety
    /// The processor has the instructions, and `COUNT` numbers can be read from there.
    unsafe fn load(from: *const f32) -> Self;
    /// # Safety
    /// The processor has the instructions.
    unsafe fn all(number: f32) -> Self;
    /// # Safety
    /// `COUNT` numbers can be written there.
    unsafe fn store(self, to: *mut f32);
    /// `self · factor + term`, rounded once.
    fn times_plus(self, factor: Self, term: Self) -> Self;
    /// The lesser of each two; of equal ones the second.
    fn min(self, other: Self) -> Self;
    /// The greater of each two; of equal ones, such as −0 and +0, the second.
    fn max(self, other: Self) -> Self;
    /// A mask of the lanes where this is not above the other.
    fn at_most(self, other: Self) -> u32;
}

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512};

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code, reason = "instructions that not every processor has")]
mod x86 {
    use std::arch::x86_64::*;

    use super::Lanes;

    /// Needs AVX2 and FMA.
    #[derive(Clone, Copy)]
    pub struct Avx2(__m256);

    /// Needs AVX-512 (F).
    #[derive(Clone, Copy)]
    pub struct Avx512(__m512);

    macro_rules! lanes {
        ($kind:ident, $count:literal, $load:ident, $all:ident, $store:ident, $times_plus:ident,
         $min:ident, $max:ident, $at_most:ident) => {
            impl Lanes for $kind {
                const COUNT: usize = $count;

                #[inline(always)]
                unsafe fn load(from: *const f32) -> Self {
                    // SAFETY: the caller's
                    Self(unsafe { $load(from) })
                }

                #[inline(always)]
                unsafe fn all(number: f32) -> Self {
                    // SAFETY: the caller's
                    Self(unsafe { $all(number) })
                }

                #[inline(always)]
                unsafe fn store(self, to: *mut f32) {
                    // SAFETY: the caller's
                    unsafe { $store(to, self.0) }
                }

                #[inline(always)]
                fn times_plus(self, factor: Self, term: Self) -> Self {
                    // SAFETY: here and below, there is a value, so the processor has the instructions
                    Self(unsafe { $times_plus(self.0, factor.0, term.0) })
                }

                #[inline(always)]
                fn min(self, other: Self) -> Self {
                    Self(unsafe { $min(self.0, other.0) })
                }

                #[inline(always)]
                fn max(self, other: Self) -> Self {
                    Self(unsafe { $max(self.0, other.0) })
                }

                #[inline(always)]
                fn at_most(self, other: Self) -> u32 {
                    unsafe { $at_most!(self.0, other.0) }
                }
            }
        };
    }

    macro_rules! at_most_256 {
        ($a:expr, $b:expr) => {
            _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>($a, $b)) as u32
        };
    }

    macro_rules! at_most_512 {
        ($a:expr, $b:expr) => {
            u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>($a, $b))
        };
    }

    lanes!(
        Avx2,
        8,
        _mm256_loadu_ps,
        _mm256_set1_ps,
        _mm256_storeu_ps,
        _mm256_fmadd_ps,
        _mm256_min_ps,
        _mm256_max_ps,
        at_most_256
    );
    lanes!(
        Avx512,
        16,
        _mm512_loadu_ps,
        _mm512_set1_ps,
        _mm512_storeu_ps,
        _mm512_fmadd_ps,
        _mm512_min_ps,
        _mm512_max_ps,
        at_most_512
    );
}
