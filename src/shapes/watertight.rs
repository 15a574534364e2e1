//! The watertight ray-triangle test, for single triangles and meshes.
//!
//! Source: Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013. The
//! triangle is moved and sheared so that the ray is the z axis; three edge functions in the plane
//! then tell on which side of each edge the ray passes. Their signs are right or they are zero, and
//! zero is inside: two triangles that share an edge leave no gap. A hit computes them again without
//! cancellation, so that `t` keeps its digits on triangles a million times longer than wide.

use crate::math::Normal;
use crate::math::{Aabb, Point, Ray, UNIT_ROUNDOFF, Vector, difference_of_products, exact_cross};

/// From this on plain products do: the area of a triangle as a ray sees it, in terms of the products
/// of which it is the sum. Each of the three weights is then wrong by a share of 2u/`LEAST_AREA` = 32u
/// at most, all together, and `t` by so much of the depth between corners, which is less than what the
/// rounding of the corners themselves can make of it, its condition.
const LEAST_AREA: f64 = 1.0 / 16.0;

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
        match ray.direction.dominant_axis() {
            0 => Self::along::<0>(ray),
            1 => Self::along::<1>(ray),
            _ => Self::along::<2>(ray),
        }
    }

    /// The meeting with a triangle, at any `t`; `None` if the ray passes beside it, lies in its
    /// plane, or anything is not a number.
    #[inline]
    pub fn meet(&self, corners: &[Point; 3]) -> Option<Meeting> {
        match self.axes[2] {
            0 => self.meet_along::<0>(corners),
            1 => self.meet_along::<1>(corners),
            _ => self.meet_along::<2>(corners),
        }
    }

    /// The same bits for a ray that is asked for one triangle: what `new` and `meet` do, with one
    /// choice of the axis for both.
    #[inline]
    pub fn meet_once(ray: &Ray, corners: &[Point; 3]) -> Option<Meeting> {
        match ray.direction.dominant_axis() {
            0 => Self::along::<0>(ray).meet_along::<0>(corners),
            1 => Self::along::<1>(ray).meet_along::<1>(corners),
            _ => Self::along::<2>(ray).meet_along::<2>(corners),
        }
    }

    #[inline]
    fn along<const Z: usize>(ray: &Ray) -> Self {
        let (kx, ky) = ((Z + 1) % 3, (Z + 2) % 3);
        let d = ray.direction.to_array();
        let inverse = 1.0 / d[Z];
        let shear = [d[kx] * inverse, d[ky] * inverse, inverse];
        Self { origin: ray.origin, axes: [kx, ky, Z], shear }
    }

    /// A vertex as the ray sees it: offset across the ray, and depth.
    #[inline]
    fn see<const Z: usize>(&self, vertex: Point) -> [f64; 3] {
        let v = (vertex - self.origin).to_array();
        let [shear_x, shear_y, shear_z] = self.shear;
        let (x, y, z) = (v[(Z + 1) % 3], v[(Z + 2) % 3], v[Z]);
        [x - shear_x * z, y - shear_y * z, shear_z * z]
    }

    // Inlined, and without `map` of arrays, which is called and hands over in memory: together two
    // thirds of the time.
    #[inline(always)]
    fn meet_along<const Z: usize>(&self, corners: &[Point; 3]) -> Option<Meeting> {
        let [ax, ay, az] = self.see::<Z>(corners[0]);
        let [bx, by, bz] = self.see::<Z>(corners[1]);
        let [cx, cy, cz] = self.see::<Z>(corners[2]);
        // the edge functions: twice the areas of the parts into which the ray divides the triangle
        let (u_plus, u_minus) = (cx * by, cy * bx);
        let (v_plus, v_minus) = (ax * cy, ay * cx);
        let (w_plus, w_minus) = (bx * ay, by * ax);
        let (mut u, mut v, mut w) = (u_plus - u_minus, v_plus - v_minus, w_plus - w_minus);
        if is_outside(u, v, w) {
            return None;
        }
        let products = (u_plus.abs() + u_minus.abs())
            + (v_plus.abs() + v_minus.abs())
            + (w_plus.abs() + w_minus.abs());
        let is_large = (u + v + w).abs() > LEAST_AREA * products;
        if !is_large {
            [u, v, w] = careful_parts([ax, ay], [bx, by], [cx, cy]);
            if is_outside(u, v, w) {
                return None;
            }
        }
        let sum = u + v + w;
        let t = (u * az + v * bz + w * cz) / sum; // no slower: it need not wait for the reciprocal
        if t.is_nan() {
            return None;
        }
        // the true t lies between the depths of the corners; a rounded one must too, or a
        // bounding box could hide it from one accelerator and not from another
        let t = t.clamp(least(az, bz, cz), greatest(az, bz, cz));
        let inverse = 1.0 / sum;
        Some(Meeting { t, barycentric: [v * inverse, w * inverse] })
    }
}

/// Whether the signs of the edge functions differ.
fn is_outside(u: f64, v: f64, w: f64) -> bool {
    least(u, v, w) < 0.0 && greatest(u, v, w) > 0.0
}

/// The edge functions without cancellation.
#[cold]
fn careful_parts([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]) -> [f64; 3] {
    [
        difference_of_products(cx, by, cy, bx),
        difference_of_products(ax, cy, ay, cx),
        difference_of_products(bx, ay, by, ax),
    ]
}

/// The least of three. (`f64::min` takes care of NaN, which costs three instructions more; here what
/// is not a number fails in the end anyway.)
fn least(a: f64, b: f64, c: f64) -> f64 {
    let ab = if a < b { a } else { b };
    if ab < c { ab } else { c }
}

fn greatest(a: f64, b: f64, c: f64) -> f64 {
    let ab = if a > b { a } else { b };
    if ab > c { ab } else { c }
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
