//! A triangle that is hit: what textures need of it.

use crate::math::{Point, Vector, exact_cross};

/// A triangle that is hit, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its corners, in the coordinates of the innermost shape.
    pub corners: [Point; 3],
    /// The texture coordinates of the corners, if the surface has any.
    pub uvs: Option<[[f64; 2]; 3]>,
    /// The barycentric coordinates β and γ of the point: the shares of the second and the third
    /// corner.
    pub barycentric: [f64; 2],
}

impl Facet {
    /// The texture coordinates of the point, if the surface has any.
    pub fn uv(&self) -> Option<[f64; 2]> {
        let [a, b, c] = self.uvs?;
        let [beta, gamma] = self.barycentric;
        Some([0, 1].map(|i| a[i] + beta * (b[i] - a[i]) + gamma * (c[i] - a[i])))
    }

    /// The same triangle at a point that is moved by a short vector along it. The barycentric
    /// coordinates are linear in its plane, also beyond its edges: `by = β (b − a) + γ (c − a)`,
    /// solved with the normal `N = (b − a) × (c − a)`.
    pub(super) fn moved(self, by: Vector) -> Self {
        let [a, b, c] = self.corners;
        let normal = exact_cross(a, b, c);
        let [beta, gamma] = self.barycentric;
        let square = normal.length_squared();
        let moved = [by.cross(c - a), (b - a).cross(by)].map(|part| part.dot(normal) / square);
        Self { barycentric: [beta + moved[0], gamma + moved[1]], ..self }
    }
}
