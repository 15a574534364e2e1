//! Powers, and transcendental functions with the same bits on every platform, by the crate `libm`.
//!
//! The platform's own `sin`, `pow` … differ in the last bit, so clippy forbids them.

use std::f64::consts::PI;

pub use libm::{
    acos, atan, atan2, cbrt, cos, erf, exp, expm1 as exp_m1, floor, log as ln, log1p as ln_1p, sin,
    sincos as sin_cos, tan,
};

/// `base^exponent` for `base ≥ 0`; whole exponents up to 2³⁰ by multiplication, because `pow` is
/// not correctly rounded even for exponent 3.
pub fn power(base: f64, exponent: f64) -> f64 {
    if exponent == floor(exponent) && (0.0..=1_073_741_824.0).contains(&exponent) {
        return by_squaring(base, exponent as u32);
    }
    libm::pow(base, exponent)
}

/// `2^exponent`, exactly, for exponents from −1022 to 1023.
pub fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + i64::from(exponent)) as u64) << 52)
}

fn by_squaring(mut base: f64, mut exponent: u32) -> f64 {
    let mut result = 1.0;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result *= base;
        }
        base *= base;
        exponent >>= 1;
    }
    result
}

/// Degrees to radians: times `π/180`. (The book prints the inverse factor; see its errata.)
pub fn to_radians(degrees: f64) -> f64 {
    degrees * (PI / 180.0)
}

/// Radians to degrees.
pub fn to_degrees(radians: f64) -> f64 {
    radians * (180.0 / PI)
}

/// The sine of an angle in degrees; exact at multiples of 90°.
pub fn sin_degrees(degrees: f64) -> f64 {
    sin_cos_degrees(degrees).0
}

/// The cosine of an angle in degrees; exact at multiples of 90°.
pub fn cos_degrees(degrees: f64) -> f64 {
    sin_cos_degrees(degrees).1
}

fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    // the remainder is exact, so 360° and 0° are the same angle to the last bit
    let quarter = libm::rint(degrees / 90.0);
    let rest = to_radians(degrees - 90.0 * quarter);
    let (s, c) = sin_cos(rest);
    match quarter.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}
