//! Numbers and vectors by their ranges. A field of plain data says its range by one of these names:
//! `#[kind]` checks it and says in the schema which numbers are lengths. The coordinates of a
//! [`Point`](super::Point) are always lengths, and finite.

use super::Vector;

/// The key of a field's dimension in the schema: `length`, `1/length`, one of them to the power of
/// another field as in `length^attenuation`, or `1` for a part without one.
pub const DIMENSION: &str = "x-dimension";

/// A length that shapes are made for, from 1e-40 to 1e40.
pub type Length = f64;

/// A coordinate or a difference of two: any finite length.
pub type Coordinate = f64;

/// A vector of finite lengths.
pub type Displacement = Vector;

/// A length above 0.
pub type Distance = f64;

/// A length of at least 0.
pub type Width = f64;

/// A finite number.
pub type Finite = f64;

/// A finite number above 0.
pub type Positive = f64;

/// A finite number of at least 0.
pub type NonNegative = f64;

/// A part of a whole, from 0 to 1.
pub type Share = f64;

/// A factor of light, from 0 to 1e30.
pub type Strength = f64;

/// An index of refraction, from 1e-10 to 1e10.
pub type Index = f64;
