//! The textbook's intersections, as the thing compared against: the formulas of Suffern's chapters
//! 3, 19, 21 and 22 as they stand, with a constant epsilon, and no care for rounding. Where the book has no
//! formula, what would usually be done.
//!
//! Nothing renders with these; `groundtruth report` puts them beside the library's own. One file for
//! each shape, by the oracle's name for it, each with the shape's data as fields.

mod algebraic;
mod annulus;
mod compound;
mod cone;
mod cuboid;
mod cut_face;
mod disk;
mod grid;
mod instance;
mod open_cylinder;
mod paraboloid;
mod part_cylinder;
mod part_sphere;
mod part_torus;
mod plane;
mod quartic;
mod rectangle;
mod sphere;
mod torus;
mod triangle;
mod wedge;

use std::fmt::Debug;

pub use algebraic::Algebraic;
pub use annulus::{Annulus, PartAnnulus};
pub use compound::Compound;
pub use cone::OpenCone;
pub use cuboid::Cuboid;
pub use cut_face::CutFace;
pub use disk::Disk;
pub use grid::Grid;
pub use instance::Instance;
pub use open_cylinder::OpenCylinder;
pub use paraboloid::Paraboloid;
pub use part_cylinder::PartCylinder;
pub use part_sphere::PartSphere;
pub use part_torus::PartTorus;
pub use plane::Plane;
pub use quartic::{cubic_roots, quartic_roots};
pub use rectangle::Rectangle;
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle::Triangle;

use super::{against, many};
use crate::math::{Point, Ray, Vector, atan2, to_radians};

/// Hits at or before it do not count: the `kEpsilon` of plane, sphere, disk, rectangle, box,
/// annulus, open cylinder and triangle.
pub const K_EPSILON: f64 = 0.001;
/// The `kEpsilon` of tori, cones and part objects.
pub const SMALL_K_EPSILON: f64 = 0.0001;

/// A shape as the book intersects it.
pub trait Textbook: Debug + Send + Sync {
    /// The distance to the nearest hit beyond epsilon, in units of the direction.
    fn hit(&self, ray: &Ray) -> Option<f64>;
}

/// The textbook's form of one of the oracle's shapes.
pub fn of(shape: &oracle::Shape) -> Box<dyn Textbook> {
    use oracle::Shape;
    match shape {
        Shape::Plane { point, normal } => {
            Box::new(Plane { point: Point::from(*point), normal: Vector::from(*normal) })
        }
        Shape::Sphere { center, radius } => {
            Box::new(Sphere { center: Point::from(*center), radius: *radius })
        }
        Shape::Cuboid { min, max } => {
            Box::new(Cuboid { min: Point::from(*min), max: Point::from(*max) })
        }
        Shape::Triangle { vertices } => Box::new(Triangle { vertices: vertices.map(Point::from) }),
        Shape::Rectangle { corner, a, b } => {
            Box::new(Rectangle::new(Point::from(*corner), Vector::from(*a), Vector::from(*b)))
        }
        Shape::Disk { center, normal, radius } => Box::new(Disk {
            center: Point::from(*center),
            normal: Vector::from(*normal),
            radius: *radius,
        }),
        Shape::OpenCylinder { y0, y1, radius } => {
            Box::new(OpenCylinder { y0: *y0, y1: *y1, radius: *radius })
        }
        Shape::Annulus { center, normal, inner, outer } => Box::new(Annulus {
            center: Point::from(*center),
            normal: Vector::from(*normal),
            inner: *inner,
            outer: *outer,
        }),
        Shape::PartAnnulus { center, inner, outer, phi } => {
            let (center, normal) = (Point::from(*center), Vector::Y);
            let whole = Annulus { center, normal, inner: *inner, outer: *outer };
            Box::new(PartAnnulus { whole, phi: Angles::degrees(*phi) })
        }
        Shape::Cone { height, radius } => Box::new(OpenCone { height: *height, radius: *radius }),
        Shape::PartSphere { center, radius, phi, theta } => Box::new(PartSphere {
            center: Point::from(*center),
            radius: *radius,
            phi: Angles::degrees(*phi),
            theta: Angles::degrees(*theta),
        }),
        Shape::PartCylinder { y0, y1, radius, phi } => {
            Box::new(PartCylinder { y0: *y0, y1: *y1, radius: *radius, phi: Angles::degrees(*phi) })
        }
        Shape::Torus { swept_radius, tube_radius } => {
            Box::new(Torus { a: *swept_radius, b: *tube_radius })
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => Box::new(PartTorus {
            a: *swept_radius,
            b: *tube_radius,
            phi: Angles::degrees(*phi),
            theta: Angles::degrees(*theta),
        }),
        Shape::Instance { matrix, of: inner } => Box::new(Instance::new(*matrix, of(inner))),
        Shape::Paraboloid { height, radius } => {
            Box::new(Paraboloid { height: *height, radius: *radius })
        }
        Shape::CutFace { size, radius } => Box::new(CutFace { size: *size, radius: *radius }),
        Shape::Solid(solid) => Box::new(compound::of(solid)),
        Shape::Algebraic { terms, min, max } => Box::new(Algebraic {
            terms: terms.clone(),
            min: Point::from(*min),
            max: Point::from(*max),
        }),
    }
}

/// The textbook's form of a shape made of many: a compound of the pieces' forms, or a grid of them
/// where the book has grids. `None` where the library refuses a piece and there is no box for it.
pub fn of_many(kind: many::Kind, pieces: &[many::Piece]) -> Option<Box<dyn Textbook>> {
    use many::Kind;
    let boxed = |piece: &many::Piece| {
        let box_around = against::pair(&piece.exact)?.ours.bounds();
        Some((box_around, of(&piece.exact)))
    };
    let parts = pieces.iter().map(boxed).collect::<Option<_>>()?;
    Some(match kind {
        Kind::Compound => Box::new(Compound::new(parts)),
        Kind::RandomSpheres | Kind::Lattice | Kind::Mesh | Kind::TessellatedSphere => {
            Box::new(Grid::new(parts))
        }
    })
}

/// The roots of `a t² + b t + c` by the schoolbook's formula, smaller first for `a > 0`. The book
/// has no case for `a = 0`, where both are infinite or NaN.
fn schoolbook_roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let disc = b * b - 4.0 * a * c;
    if disc < 0.0 {
        return None;
    }
    let e = disc.sqrt();
    let denom = 2.0 * a;
    Some([(-b - e) / denom, (-b + e) / denom])
}

/// The azimuth about the y axis, from +z towards +x, in `[0, 2π)`.
fn azimuth(p: Point) -> f64 {
    let phi = atan2(p.x(), p.z());
    if phi < 0.0 { phi + 2.0 * std::f64::consts::PI } else { phi }
}

/// A range of angles in radians; a minimum above the maximum goes through 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// Where it starts.
    pub min: f64,
    /// Where it ends.
    pub max: f64,
}

impl Angles {
    /// The range between two angles in degrees.
    pub fn degrees([min, max]: [f64; 2]) -> Self {
        Self { min: to_radians(min), max: to_radians(max) }
    }

    /// Whether an angle in `[0, 2π)` lies inside.
    pub fn contains(self, angle: f64) -> bool {
        if self.min <= self.max {
            self.min <= angle && angle <= self.max
        } else {
            angle >= self.min || angle <= self.max
        }
    }
}
