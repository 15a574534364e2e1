//! Mathematics (Suffern, ch. 2 and 20): typed points, vectors and normals, rays, frames, bounds,
//! transforms, random numbers, and the functions that have the same bits on every platform.
//!
//! The only module that names glam. Everything is `f64`; angles are radians unless the name says
//! degrees. Nothing here has an absolute epsilon: multiplying all lengths by a power of two
//! multiplies every result by one.

mod bounds;
mod box_ray;
mod exact;
mod frame;
mod functions;
mod lanes;
pub mod lists;
pub mod maps;
pub mod polynomial;
mod quadrature;
mod random;
mod ranges;
mod ray;
mod roots;
mod single;
mod transform;
mod vectors;
pub mod watertight;

pub use bounds::Aabb;
pub use box_ray::{BoxRay, TwoBoxes};
pub use exact::{difference_of_products, exact_cross, less_products, two_product, two_sum};
pub use frame::Frame;
pub use functions::{
    acos, atan, atan2, cbrt, cos, cos_degrees, erf, exp, exp_m1, floor, ln, ln_1p, power,
    power_of_two, sin, sin_cos, sin_degrees, tan, to_degrees, to_radians,
};
pub use lanes::Lanes;
pub(crate) use quadrature::tanh_sinh;
pub use random::{Pcg32, hash, hash_onto, splitmix};
pub use ranges::{
    Coordinate, DIMENSION, Displacement, Distance, Finite, Index, Length, NonNegative, Positive,
    Share, Strength, Width,
};
pub use ray::{Ray, Span};
pub(crate) use roots::{Tolerance, bracketed_root};
pub use roots::{circle_roots, perpendicular_roots, quadratic};
pub(crate) use single::Singles;
pub use transform::{Axis, Singular, Step, Transform};
pub use vectors::{Normal, Point, Vector};

/// Half the distance from 1 to the next `f64`: the largest relative error of one rounding.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// The largest `f64` below 1.
pub const ONE_MINUS: f64 = 1.0 - UNIT_ROUNDOFF;
