//! Points, vectors and normals: three types, so that meaningless sums and products do not compile.
//!
//! ```compile_fail
//! use groundtruth::math::Point;
//! let _ = Point::new(0.0, 0.0, 0.0) + Point::new(1.0, 0.0, 0.0);
//! ```
//! ```compile_fail
//! use groundtruth::math::Point;
//! let _ = 2.0 * Point::new(1.0, 0.0, 0.0);
//! ```
//! ```compile_fail
//! use groundtruth::math::{Normal, Vector};
//! let v = Vector::new(0.0, 2.0, 0.0);
//! let n: Normal = v; // a normal is unit by construction: `Normal::new(v)` may fail
//! ```
//! ```compile_fail
//! use groundtruth::math::{Point, Vector};
//! let _ = Point::new(0.0, 0.0, 0.0).dot(Vector::new(1.0, 0.0, 0.0));
//! ```
//! The sum of normals is a vector, and says so:
//! ```
//! use groundtruth::math::{Normal, Vector};
//! let (n, m) = (Normal::X, Normal::Y);
//! let sum: Vector = n + m;
//! assert_eq!(sum, Vector::new(1.0, 1.0, 0.0));
//! ```

use std::borrow::Cow;
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use glam::DVec3;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize};

use super::lists;

const TWO_TO_600: f64 = f64::from_bits((600 + 1023) << 52);

/// A position. `Point − Point` is a [`Vector`]; points cannot be added or scaled.
#[derive(Clone, Copy, PartialEq, Default, Serialize)]
#[serde(into = "[f64; 3]")]
pub struct Point(pub(super) DVec3);

/// A displacement or direction, of any length.
#[derive(Clone, Copy, PartialEq, Default, Serialize)]
#[serde(into = "[f64; 3]")]
pub struct Vector(pub(super) DVec3);

/// A unit vector perpendicular to a surface; every way to make one normalises.
#[derive(Clone, Copy, PartialEq, Serialize)]
#[serde(into = "[f64; 3]")]
pub struct Normal(pub(super) DVec3);

macro_rules! coordinates {
    ($($kind:ident),*) => {$(
        impl $kind {
            /// The x coordinate.
            pub fn x(self) -> f64 {
                self.0.x
            }

            /// The y coordinate.
            pub fn y(self) -> f64 {
                self.0.y
            }

            /// The z coordinate.
            pub fn z(self) -> f64 {
                self.0.z
            }

            /// The coordinate along axis 0, 1 or 2.
            pub fn along(self, axis: usize) -> f64 {
                self.to_array()[axis] // `self.0[axis]` would compile to a chain of branches
            }

            /// The three coordinates.
            pub fn to_array(self) -> [f64; 3] {
                self.0.to_array()
            }

            /// Whether no coordinate is NaN or infinite.
            pub fn is_finite(self) -> bool {
                self.0.is_finite()
            }
        }

        impl From<$kind> for [f64; 3] {
            fn from(it: $kind) -> Self {
                it.0.to_array()
            }
        }

        impl fmt::Debug for $kind {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let [x, y, z] = self.to_array();
                write!(f, concat!(stringify!($kind), "({:?}, {:?}, {:?})"), x, y, z)
            }
        }
    )*};
}
coordinates!(Point, Vector, Normal);

// a coordinate of a point in schemas
#[derive(JsonSchema)]
#[schemars(inline, extend("x-dimension" = "length"))]
struct Coordinate(#[expect(dead_code)] f64);

macro_rules! from_array {
    ($($kind:ident of $part:ty, written as $written:literal;)*) => {$(
        impl From<[f64; 3]> for $kind {
            fn from(it: [f64; 3]) -> Self {
                Self(DVec3::from_array(it))
            }
        }

        impl JsonSchema for $kind {
            fn schema_name() -> Cow<'static, str> {
                stringify!($kind).into()
            }

            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                let mut schema = <[$part; 3]>::json_schema(generator);
                schema.insert("description".to_owned(), $written.into());
                schema
            }
        }

        impl<'de> Deserialize<'de> for $kind {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                lists::exactly(deserializer).map(|coordinates: [f64; 3]| coordinates.into())
            }
        }
    )*};
}
from_array!(
    Point of Coordinate, written as "A point as `[x, y, z]`, three lengths.";
    Vector of f64, written as "A vector as `[x, y, z]`.";
);

impl Point {
    /// The origin of coordinates.
    pub const ORIGIN: Self = Self(DVec3::ZERO);

    /// The point with these coordinates.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self(DVec3::new(x, y, z))
    }

    /// The distance to another point.
    pub fn distance(self, other: Point) -> f64 {
        (other - self).length()
    }

    /// The square of the distance to another point.
    pub fn distance_squared(self, other: Point) -> f64 {
        (other - self).length_squared()
    }

    /// This point with the coordinate along `axis` replaced.
    pub fn with(mut self, axis: usize, value: f64) -> Self {
        self.0[axis] = value;
        self
    }

    /// The point `factor` times as far from the origin, in the same direction.
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }

    /// The smaller of each coordinate.
    pub fn min(self, other: Point) -> Self {
        Self(self.0.min(other.0))
    }

    /// The larger of each coordinate.
    pub fn max(self, other: Point) -> Self {
        Self(self.0.max(other.0))
    }

    /// The vector from the origin to this point.
    pub fn to_vector(self) -> Vector {
        Vector(self.0)
    }
}

impl Vector {
    /// The vector of length 0.
    pub const ZERO: Self = Self(DVec3::ZERO);
    /// The unit vector along x.
    pub const X: Self = Self(DVec3::X);
    /// The unit vector along y.
    pub const Y: Self = Self(DVec3::Y);
    /// The unit vector along z.
    pub const Z: Self = Self(DVec3::Z);

    /// The vector with these components.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self(DVec3::new(x, y, z))
    }

    /// The scalar product.
    pub fn dot(self, other: impl Into<Vector>) -> f64 {
        self.0.dot(other.into().0)
    }

    /// The vector product, `self ^ other` in the book.
    pub fn cross(self, other: impl Into<Vector>) -> Vector {
        Vector(self.0.cross(other.into().0))
    }

    /// The length.
    pub fn length(self) -> f64 {
        self.0.length()
    }

    /// The square of the length.
    pub fn length_squared(self) -> f64 {
        self.0.length_squared()
    }

    /// The unit vector of the same direction, the book's `hat`; `None` for a vector that is zero
    /// or not finite.
    pub fn unit(self) -> Option<Vector> {
        Normal::new(self).map(Vector::from)
    }

    /// The largest absolute value of a component.
    pub fn max_abs(self) -> f64 {
        self.0.abs().max_element()
    }

    /// The part perpendicular to the y axis.
    #[must_use]
    pub fn across_y(self) -> Vector {
        Vector::new(self.x(), 0.0, self.z())
    }

    /// The larger of each component.
    #[must_use]
    pub fn max(self, other: Vector) -> Vector {
        Vector(self.0.max(other.0))
    }

    /// The absolute value of each component.
    pub fn abs(self) -> Vector {
        Vector(self.0.abs())
    }

    /// The axis (0, 1, 2) of the component of largest absolute value.
    pub fn dominant_axis(self) -> usize {
        let a = self.0.abs();
        let (axis, larger) = if a.x > a.y { (0, a.x) } else { (1, a.y) };
        if larger > a.z { axis } else { 2 }
    }
}

impl Normal {
    /// Along x.
    pub const X: Self = Self(DVec3::X);
    /// Along y.
    pub const Y: Self = Self(DVec3::Y);
    /// Along z.
    pub const Z: Self = Self(DVec3::Z);

    /// The normal in the direction of `v`, unit within 4u; `None` if `v` is zero or not finite.
    pub fn new(v: Vector) -> Option<Self> {
        let largest = v.max_abs(); // `max_abs` ignores NaN
        if largest == 0.0 || !v.is_finite() {
            return None;
        }
        // far from 1 the squares would overflow or underflow; scaling by a power of two is exact
        let v = match largest {
            l if l < 1e-140 => v * TWO_TO_600,
            l if l > 1e140 => v * (1.0 / TWO_TO_600),
            _ => v,
        };
        Some(Self(v.0 / v.length()))
    }

    /// The scalar product.
    pub fn dot(self, other: impl Into<Vector>) -> f64 {
        self.0.dot(other.into().0)
    }

    /// The vector product.
    pub fn cross(self, other: impl Into<Vector>) -> Vector {
        Vector(self.0.cross(other.into().0))
    }
}

impl From<Normal> for Vector {
    fn from(n: Normal) -> Self {
        Vector(n.0)
    }
}

macro_rules! operators {
    ($($left:ident $op:ident $method:ident $right:ident = $out:ident;)*) => {$(
        impl $op<$right> for $left {
            type Output = $out;
            fn $method(self, other: $right) -> $out {
                $out(self.0.$method(other.0))
            }
        }
    )*};
}
operators! {
    Vector Add add Vector = Vector;
    Vector Sub sub Vector = Vector;
    Point Add add Vector = Point;
    Point Sub sub Vector = Point;
    Point Sub sub Point = Vector;
    Normal Add add Normal = Vector;
    Normal Add add Vector = Vector;
    Vector Add add Normal = Vector;
    Vector Sub sub Normal = Vector;
}

macro_rules! scaling {
    ($($kind:ident),*) => {$(
        impl Mul<f64> for $kind {
            type Output = Vector;
            fn mul(self, a: f64) -> Vector {
                Vector(self.0 * a)
            }
        }
        impl Mul<$kind> for f64 {
            type Output = Vector;
            fn mul(self, v: $kind) -> Vector {
                Vector(v.0 * self)
            }
        }
        impl Neg for $kind {
            type Output = $kind;
            fn neg(self) -> $kind {
                $kind(-self.0)
            }
        }
    )*};
}
scaling!(Vector, Normal);

impl Div<f64> for Vector {
    type Output = Vector;
    fn div(self, a: f64) -> Vector {
        Vector(self.0 / a)
    }
}

impl AddAssign for Vector {
    fn add_assign(&mut self, other: Vector) {
        self.0 += other.0;
    }
}
