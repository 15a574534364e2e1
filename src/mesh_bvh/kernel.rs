//! The processor's instructions for several boxes, or triangles, at once.
//!
//! The kernel is chosen when a structure is built and changes only the speed: every kernel gives
//! the same hits, to the last bit.

/// A set of instructions that this processor has; it cannot be made on a processor without them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kernel(Instructions);

/// The sets of instructions for which there are kernels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instructions {
    /// Plain Rust, for every processor.
    Plain,
    /// AVX2, FMA and BMI1: 4 numbers of double precision at once, 8 of single precision.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// AVX-512 (F and VL) too: 8 numbers of double precision at once, 16 of single precision.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Kernel {
    /// Plain Rust.
    pub const PLAIN: Self = Self(Instructions::Plain);

    /// For code that runs only where the processor has AVX2.
    #[cfg(target_arch = "x86_64")]
    pub(super) const AVX2: Self = Self(Instructions::Avx2);
    /// For code that runs only where the processor has AVX-512.
    #[cfg(target_arch = "x86_64")]
    pub(super) const AVX512: Self = Self(Instructions::Avx512);

    /// All that this processor has, the best first.
    pub fn available() -> Vec<Self> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
        {
            if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl") {
                all.push(Self(Instructions::Avx512));
            }
            all.push(Self(Instructions::Avx2));
        }
        all.push(Self::PLAIN);
        all
    }

    /// The fastest that this processor has.
    pub fn best() -> Self {
        Self::available()[0]
    }

    pub(crate) fn instructions(self) -> Instructions {
        self.0
    }
}

/// Prefetches 448 bytes that will be needed soon; does nothing if the address is not mapped.
#[inline(always)]
#[allow(unsafe_code, reason = "there is no other way to say it")]
pub(super) fn prefetch(soon: *const u8) {
    #[cfg(target_arch = "x86_64")]
    for line in 0..7 {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a prefetch changes nothing, and ignores an address that is not mapped
        unsafe { _mm_prefetch::<_MM_HINT_T0>(soon.wrapping_add(64 * line).cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = soon;
}
