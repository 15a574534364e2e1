//! The oracle's inputs: a ray and a shape, as plain numbers.

use crate::{
    real::{Real, real},
    solid::Solid,
};

/// A half-line `origin + t·direction`, `t > 0`; the direction need not be unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray<T = f64> {
    /// The point at `t = 0`.
    pub origin: [T; 3],
    /// Not zero; `t` is in units of its length.
    pub direction: [T; 3],
}

/// A surface (`T` is `f64` everywhere outside the oracle).
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<T = f64> {
    /// All `p` with `(p − point)·normal = 0`.
    Plane {
        /// A point of it.
        point: [T; 3],
        /// Any length but 0.
        normal: [T; 3],
    },
    /// All `p` at distance `radius > 0` from `center`; the normal points outwards.
    Sphere {
        /// The centre.
        center: [T; 3],
        /// More than 0.
        radius: T,
    },
    /// The surface of the box between `min ≤ max`; the normal points outwards.
    Cuboid {
        /// The corner of least coordinates.
        min: [T; 3],
        /// The corner of greatest coordinates.
        max: [T; 3],
    },
    /// The triangle with its border; the normal is `(v₁ − v₀) × (v₂ − v₀)`.
    Triangle {
        /// The three corners.
        vertices: [[T; 3]; 3],
    },
    /// All `p = corner + x` in the plane of `a` and `b` with `0 ≤ x·a ≤ a·a` and `0 ≤ x·b ≤ b·b`;
    /// `a` and `b` are perpendicular except for rounding. The normal is `a × b`.
    Rectangle {
        /// Where both sides start.
        corner: [T; 3],
        /// The first side.
        a: [T; 3],
        /// The second side.
        b: [T; 3],
    },
    /// All `p` of the plane `(p − center)·normal = 0` no farther than `radius` from `center`.
    Disk {
        /// The centre.
        center: [T; 3],
        /// Any length but 0.
        normal: [T; 3],
        /// More than 0.
        radius: T,
    },
    /// All `p` with `x² + z² = radius²` and `y0 ≤ y ≤ y1`; the normal points away from the axis.
    OpenCylinder {
        /// The lower rim.
        y0: T,
        /// The upper rim.
        y1: T,
        /// More than 0.
        radius: T,
    },
    /// All `p` of the plane `(p − center)·normal = 0` from `inner` to `outer` away from `center`.
    Annulus {
        /// The centre.
        center: [T; 3],
        /// Any length but 0.
        normal: [T; 3],
        /// Not less than 0.
        inner: T,
        /// More than `inner`.
        outer: T,
    },
    /// The part of a level annulus, with normal `(0, 1, 0)`, within a range of azimuths.
    PartAnnulus {
        /// The centre.
        center: [T; 3],
        /// Not less than 0.
        inner: T,
        /// More than `inner`.
        outer: T,
        /// In degrees from +z to +x: from the first up to the second, through 360 if it is larger.
        phi: [T; 2],
    },
    /// All `p` with `√(x² + z²)/radius = (height − y)/height` and `0 ≤ y ≤ height`; the normal points
    /// away from the axis.
    Cone {
        /// Of the apex over the base; more than 0.
        height: T,
        /// Of the base; more than 0.
        radius: T,
    },
    /// All `p` with `y/height = (x² + z²)/radius²` and `y ≤ height`; the normal points away from the
    /// axis.
    Paraboloid {
        /// Of the rim over the vertex; more than 0.
        height: T,
        /// Of the rim; more than 0.
        radius: T,
    },
    /// The part of a sphere within ranges of azimuths and of polar angles.
    PartSphere {
        /// The centre.
        center: [T; 3],
        /// More than 0.
        radius: T,
        /// In degrees from +z to +x: from the first up to the second, through 360 if it is larger.
        phi: [T; 2],
        /// In degrees from +y, ascending, from 0 to 180.
        theta: [T; 2],
    },
    /// The part of an open cylinder within a range of azimuths.
    PartCylinder {
        /// The lower rim.
        y0: T,
        /// The upper rim.
        y1: T,
        /// More than 0.
        radius: T,
        /// In degrees from +z to +x: from the first up to the second, through 360 if it is larger.
        phi: [T; 2],
    },
    /// All `p` at distance `tube_radius` from the circle of `swept_radius > tube_radius > 0` about
    /// the origin in y = 0; the normal points out of the tube.
    Torus {
        /// Of the circle.
        swept_radius: T,
        /// Of the tube.
        tube_radius: T,
    },
    /// The points of a torus within two ranges of angles, ends included; a range whose first end is
    /// the larger goes on through 360°.
    PartTorus {
        /// Of the circle.
        swept_radius: T,
        /// Of the tube.
        tube_radius: T,
        /// Azimuth in degrees, from +z to +x.
        phi: [T; 2],
        /// Around the tube in degrees, from the outermost line upwards.
        theta: [T; 2],
    },
    /// All `p` inside the box where the sum of the terms is 0; the normal is the direction of growth.
    Algebraic {
        /// A coefficient, and the powers of x, y and z.
        terms: Vec<(T, [u32; 3])>,
        /// The corner of least coordinates.
        min: [T; 3],
        /// The corner of greatest coordinates.
        max: [T; 3],
    },
    /// The points of y = 0 with `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`; the normal is
    /// `(0, 1, 0)`.
    CutFace {
        /// Of the sides; more than 0.
        size: T,
        /// Of the hole; more than 0, less than `size/√2`.
        radius: T,
    },
    /// A closed surface of several parts.
    Solid(Solid<T>),
    /// `of`, transformed by the affine `matrix`; the normal transforms by the inverse transpose.
    Instance {
        /// The rows of the map from object to world, translation last; not singular.
        matrix: [[T; 4]; 3],
        /// The shape in object space.
        of: Box<Shape<T>>,
    },
}

impl Ray {
    pub(crate) fn exact(&self) -> Ray<Real> {
        Ray { origin: self.origin.map(real), direction: self.direction.map(real) }
    }
}

impl Shape {
    /// The product of the [`condition`](crate::condition)s of all nested instances; 1 for others.
    pub fn condition(&self) -> f64 {
        match self {
            Shape::Instance { matrix, of } => crate::condition(matrix) * of.condition(),
            _ => 1.0,
        }
    }

    pub(crate) fn exact(&self) -> Shape<Real> {
        self.map(&|x| real(*x))
    }
}

/// The same kind of shape or solid with `f` applied to its numbers: of each kind its points and ranges, then what is
/// one number. A kind that holds something else has an arm of its own.
macro_rules! with_each {
    ($f:expr, $of:expr, $enum:ident { $($kind:ident ($($point:ident)*; $($number:ident)*))* } $($other:tt)*) => {
        match $of {
            $($enum::$kind { $($point,)* $($number,)* } => $enum::$kind {
                $($point: $point.each_ref().map($f),)*
                $($number: $f($number),)*
            },)*
            $($other)*
        }
    };
}
pub(crate) use with_each;

impl<T> Shape<T> {
    /// The same shape with `f` applied to every number.
    pub(crate) fn map<U>(&self, f: &impl Fn(&T) -> U) -> Shape<U> {
        with_each!(f, self, Shape {
            Plane (point normal;)
            Sphere (center; radius)
            Cuboid (min max;)
            Rectangle (corner a b;)
            Disk (center normal; radius)
            OpenCylinder (; y0 y1 radius)
            Annulus (center normal; inner outer)
            PartAnnulus (center phi; inner outer)
            Cone (; height radius)
            Paraboloid (; height radius)
            PartSphere (center phi theta; radius)
            PartCylinder (phi; y0 y1 radius)
            Torus (; swept_radius tube_radius)
            PartTorus (phi theta; swept_radius tube_radius)
            CutFace (; size radius)
        }
        Shape::Triangle { vertices } => Shape::Triangle {
            vertices: vertices.each_ref().map(|vertex| vertex.each_ref().map(f)),
        },
        Shape::Algebraic { terms, min, max } => Shape::Algebraic {
            terms: terms.iter().map(|(c, powers)| (f(c), *powers)).collect(),
            min: min.each_ref().map(f),
            max: max.each_ref().map(f),
        },
        Shape::Solid(solid) => Shape::Solid(solid.map(f)),
        Shape::Instance { matrix, of } => Shape::Instance {
            matrix: matrix.each_ref().map(|row| row.each_ref().map(f)),
            of: Box::new(of.map(f)),
        })
    }
}
