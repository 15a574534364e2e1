//! Exact numbers: a pixel value as an integer, and the sums of these integers and of their squares.

use groundtruth::math::power_of_two;

/// A value `x` counts as the integer `k = x·2⁸⁰`.
const FRACTION_BITS: i32 = 80;

/// Values and sums are below 2⁴⁷ in magnitude, so that `k` fits in an `i128`.
const LARGEST_BITS: i32 = 47;

/// `x·2⁸⁰` rounded once to an integer, halves to even; `None` if `|x|` is 2⁴⁷ or more, infinite or NaN.
pub fn fixed(x: f64) -> Option<i128> {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    // |x| = mantissa · 2^exponent, also for subnormal values
    let (mantissa, exponent) =
        if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
    if exponent + 53 > LARGEST_BITS {
        return None;
    }
    let shift = exponent + FRACTION_BITS;
    let magnitude = if shift >= 0 {
        i128::from(mantissa) << shift
    } else {
        i128::from(rounded_shift(mantissa, shift.unsigned_abs()))
    };
    Some(if x.is_sign_negative() { -magnitude } else { magnitude })
}

/// `m / 2^shift` rounded to an integer, halves to even; `m` has at most 53 bits, `shift` is at least 1.
fn rounded_shift(m: u64, shift: u32) -> u64 {
    if shift > 54 {
        return 0; // less than a half
    }
    let (whole, rest, half) = (m >> shift, m & ((1 << shift) - 1), 1 << (shift - 1));
    whole + u64::from(rest > half || rest == half && whole & 1 == 1)
}

/// An integer from 0 to 2²⁵⁶ − 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct U256 {
    low: u128,
    high: u128,
}

impl U256 {
    /// The number of these two halves.
    pub fn new(low: u128, high: u128) -> Self {
        Self { low, high }
    }

    /// Its halves, the less significant one first.
    pub fn halves(self) -> [u128; 2] {
        [self.low, self.high]
    }

    /// `k²`.
    pub fn square(k: i128) -> Self {
        let k = k.unsigned_abs();
        let (a, b) = (k >> 64, k & u128::from(u64::MAX));
        // (a·2⁶⁴ + b)² = a²·2¹²⁸ + 2ab·2⁶⁴ + b²; 2ab may have 129 bits
        let cross = a * b;
        let (low, carry) = (b * b).overflowing_add(cross << 65);
        Self { low, high: a * a + (cross >> 63) + u128::from(carry) }
    }

    /// The sum; `None` if it is 2²⁵⁶ or more.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let (low, carry) = self.low.overflowing_add(other.low);
        let high = self.high.checked_add(other.high)?.checked_add(u128::from(carry))?;
        Some(Self { low, high })
    }

    /// Its product with `n`, in words of 64 bits, the least significant one first.
    fn times(self, n: u64) -> [u64; 5] {
        let mut product = [0; 5];
        let mut carry = 0_u128;
        for (word, digit) in product.iter_mut().zip(words(self)) {
            carry += u128::from(digit) * u128::from(n);
            *word = carry as u64;
            carry >>= 64;
        }
        product[4] = carry as u64;
        product
    }
}

fn words(number: U256) -> [u64; 4] {
    let [low, high] = number.halves();
    [low as u64, (low >> 64) as u64, high as u64, (high >> 64) as u64]
}

/// `Σk` and `Σk²` of one channel of one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ChannelSums {
    /// `Σk` of the finite values; the magnitude is below 2¹²⁷.
    pub sum: i128,
    /// `Σk²` of the finite values.
    pub squares: U256,
    /// The bits of the floating-point sum of the others: an infinity, the one NaN, or 0 if there is none. It does not
    /// depend on their order.
    pub others: u64,
}

impl ChannelSums {
    /// The sums of one value; `None` as for [`fixed`], but for values that are not finite.
    pub fn of(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return Some(Self { others: sum_of_others(0.0, x), ..Self::default() });
        }
        fixed(x).map(|k| Self { sum: k, squares: U256::square(k), others: 0 })
    }

    /// The sums of both; `None` if they do not fit.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let sum = self.sum.checked_add(other.sum).filter(|sum| *sum != i128::MIN)?;
        let squares = self.squares.checked_add(other.squares)?;
        Some(Self { sum, squares, others: sum_of_others(self.others(), other.others()) })
    }

    /// The floating-point sum of the values that are not finite; 0 if there is none.
    pub fn others(self) -> f64 {
        f64::from_bits(self.others)
    }

    /// The mean of `n` values, rounded once; `n` is from 1 to 2⁶³. With a value that is not finite, the sum of these.
    pub fn mean(self, n: u64) -> f64 {
        if self.others != 0 {
            return self.others();
        }
        let magnitude = self.sum.unsigned_abs();
        if magnitude == 0 {
            return 0.0;
        }
        // the quotient has more than 64 bits, and its last one stands for all that are cut off
        let shift = magnitude.leading_zeros();
        let (dividend, n) = (magnitude << shift, u128::from(n));
        let quotient = (dividend / n) | u128::from(!dividend.is_multiple_of(n));
        let mean = quotient as f64 * power_of_two(-FRACTION_BITS - shift as i32);
        if self.sum < 0 { -mean } else { mean }
    }

    /// The standard error of the mean of `n ≥ 2` values, `√(Σ(x − x̄)² / (n (n − 1)))`, to a few units in the
    /// last place; NaN with a value that is not finite.
    ///
    /// `n Σ(k − k̄)² = n Σk² − (Σk)²`: exact in integers, so nothing cancels.
    pub fn standard_error(self, n: u64) -> f64 {
        if self.others != 0 {
            return f64::NAN;
        }
        let spread = difference(self.squares.times(n), U256::square(self.sum).times(1));
        let count = n as f64;
        (rounded(spread) / (count * count * (count - 1.0))).sqrt() * power_of_two(-FRACTION_BITS)
    }
}

/// The bits of a sum of values of which none is finite, or 0: one NaN for all, whose sign and payload depend on the machine.
fn sum_of_others(a: f64, b: f64) -> u64 {
    let sum = a + b;
    if sum.is_nan() { f64::NAN.to_bits() } else { sum.to_bits() }
}

/// `a − b`, for `a ≥ b`.
fn difference(a: [u64; 5], b: [u64; 5]) -> [u64; 5] {
    let mut borrow = false;
    std::array::from_fn(|i| {
        let (once, under) = a[i].overflowing_sub(b[i]);
        let (twice, again) = once.overflowing_sub(u64::from(borrow));
        borrow = under || again;
        twice
    })
}

/// The nearest real number.
fn rounded(words: [u64; 5]) -> f64 {
    let top = words.iter().rposition(|&word| word != 0).unwrap_or(0).max(1);
    let is_cut = words[..top - 1].iter().any(|&word| word != 0);
    let leading = u128::from(words[top]) << 64 | u128::from(words[top - 1]) | u128::from(is_cut);
    leading as f64 * power_of_two(64 * (top as i32 - 1))
}
