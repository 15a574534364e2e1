//! The watertight ray-triangle test, for single triangles and meshes.
//!
//! Source: Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013. The
//! triangle is moved and sheared so that the ray is the z axis; three edge functions in the plane
//! then tell on which side of each edge the ray passes. Their signs are right or they are zero, and
//! zero is inside: two triangles that share an edge leave no gap. A hit computes them again without
//! cancellation, so that `t` keeps its digits on triangles a million times longer than wide.

use crate::math::Normal;
use crate::math::{Aabb, Point, Ray, UNIT_ROUNDOFF, Vector, difference_of_products, exact_cross};

/// The area of a triangle as a ray sees it, in terms of the products whose sum it is, from which on
/// plain products do: each weight is then wrong by at most 2u/`LEAST_AREA`, so `t` by twice as much
/// of the depths that the triangle spans, and those count in its condition.
const LEAST_AREA: f64 = 0.25;

/// A ray prepared for triangles.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    pub(super) origin: Point,
    pub(super) axes: [usize; 3],
    pub(super) shear: [f64; 3],
}

/// Where a ray meets a triangle `(a, b, c)`.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Along the ray.
    pub t: f64,
    /// The weights `β` of `b` and `γ` of `c`.
    pub barycentric: [f64; 2],
}

impl ShearedRay {
    /// Prepares a ray: its largest component becomes z, the shear makes the others zero.
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let kz = d.dominant_axis();
        let (kx, ky) = ([1, 2, 0][kz], [2, 0, 1][kz]);
        let d = d.to_array();
        let inverse = 1.0 / d[kz];
        let shear = [d[kx] * inverse, d[ky] * inverse, inverse];
        Self { origin: ray.origin, axes: [kx, ky, kz], shear }
    }

    /// A vertex as the ray sees it: offset across the ray, and depth.
    fn see(&self, vertex: Point) -> [f64; 3] {
        let v = (vertex - self.origin).to_array();
        let [kx, ky, kz] = self.axes;
        let z = v[kz];
        [v[kx] - self.shear[0] * z, v[ky] - self.shear[1] * z, self.shear[2] * z]
    }

    /// The meeting with a triangle, at any `t`; `None` if the ray passes beside it, lies in its
    /// plane, or anything is not a number.
    pub fn meet(&self, [a, b, c]: [Point; 3]) -> Option<Meeting> {
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (self.see(a), self.see(b), self.see(c));
        let outside = |u: f64, v: f64, w: f64| {
            (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)
        };
        // the edge functions are twice the areas of the parts into which the ray divides the triangle
        let products = [[cx * by, cy * bx], [ax * cy, ay * cx], [bx * ay, by * ax]];
        let [mut u, mut v, mut w] = products.map(|[plus, minus]| plus - minus);
        if outside(u, v, w) {
            return None;
        }
        let size = products.map(|[plus, minus]| plus.abs() + minus.abs());
        if !((u + v + w).abs() > LEAST_AREA * (size[0] + size[1] + size[2])) {
            u = difference_of_products(cx, by, cy, bx);
            v = difference_of_products(ax, cy, ay, cx);
            w = difference_of_products(bx, ay, by, ax);
            if outside(u, v, w) {
                return None;
            }
        }
        let inverse = 1.0 / (u + v + w);
        let t = (u * az + v * bz + w * cz) * inverse;
        if t.is_nan() {
            return None;
        }
        // the true t lies between the depths of the corners; a rounded one must too, or a
        // bounding box could hide it from one accelerator and not from another
        let t = t.clamp(az.min(bz).min(cz), az.max(bz).max(cz));
        Some(Meeting { t, barycentric: [v * inverse, w * inverse] })
    }
}

/// The normal of a triangle by its winding, `(b − a) × (c − a)`; `None` if its area is zero.
pub fn normal([a, b, c]: [Point; 3]) -> Option<Normal> {
    Normal::new(exact_cross(a, b, c))
}

/// The point with these barycentric coordinates, and a bound of how far along the normal the test
/// above may see the triangle from it: rounding of the vertices relative to the ray's origin, and
/// of their shear.
pub fn point_on([a, b, c]: [Point; 3], [beta, gamma]: [f64; 2], n: Normal) -> (Point, f64) {
    let (ab, ac) = (b - a, c - a);
    let raw = a + (beta * ab + gamma * ac);
    let point = raw - (raw - a).dot(n) * n;
    let size = ab.max_abs().max(ac.max_abs());
    let magnitude = point.to_vector().abs() + a.to_vector().abs();
    let error = UNIT_ROUNDOFF * (10.0 * magnitude.dot(Vector::from(n).abs()) + 24.0 * size);
    (point, error)
}

/// The box around a triangle.
pub fn bounds(corners: [Point; 3]) -> Aabb {
    Aabb::around(corners)
}
