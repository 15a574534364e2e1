//! The plane of a section, with coordinates of its own.

use groundtruth::math::{Frame, Normal, Point, Vector};

/// A ray whose sine to the normal is smaller meets the surface straight: its plane of incidence is not determined.
const STRAIGHT: f64 = 1e-7;

/// A plane through a hit that contains the normal there. Its coordinates are lengths: x along the surface, y along the
/// normal, from the hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPlane {
    /// The hit, at (0, 0).
    pub origin: Point,
    frame: Frame,
    /// Whether the direction that it was made for is along the normal, so that another plane would do as well.
    pub is_any: bool,
}

impl SectionPlane {
    /// The plane of this normal and direction, which goes to the right. If the direction is along the normal, the plane is
    /// that of the world's x axis; of z, if that is nearer to a right angle with the normal.
    pub(super) fn of(origin: Point, normal: Normal, direction: Vector) -> Self {
        let along = |vector: Vector| vector - vector.dot(normal) * Vector::from(normal);
        let right = along(direction);
        let is_any = right.length() <= STRAIGHT * direction.length();
        let axis = if normal.x().abs() <= normal.z().abs() { Vector::X } else { Vector::Z };
        let right = if is_any { along(axis) } else { right };
        // an axis that is not the one nearest to the normal has a part along the surface
        let u = right.unit().unwrap_or_default();
        // once more: of a short vector the part along the normal is not rounded away
        let u = along(u).unit().unwrap_or(u);
        Self { origin, frame: Frame { u, v: normal.into(), w: u.cross(normal) }, is_any }
    }

    /// The coordinates of the point of the plane that is nearest to this one.
    pub fn to_plane(&self, point: Point) -> [f64; 2] {
        self.along(point - self.origin)
    }

    /// The coordinates of a vector's projection.
    pub fn along(&self, vector: Vector) -> [f64; 2] {
        [vector.dot(self.frame.u), vector.dot(self.frame.v)]
    }

    /// The point of the world at these coordinates.
    pub fn to_space(&self, [x, y]: [f64; 2]) -> Point {
        self.origin + self.vector([x, y])
    }

    /// The vector of the world with these coordinates.
    pub fn vector(&self, [x, y]: [f64; 2]) -> Vector {
        x * self.frame.u + y * self.frame.v
    }

    /// The plane's own normal, unit.
    pub fn normal(&self) -> Vector {
        self.frame.w
    }
}
