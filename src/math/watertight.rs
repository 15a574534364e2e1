//! The watertight ray-triangle test, for single triangles and meshes.
//!
//! Source: Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013. The
//! triangle is moved and sheared so that the ray is the z axis; three edge functions in the plane
//! then tell on which side of each edge the ray passes. Their signs are right or they are zero, and
//! zero is inside: two triangles that share an edge leave no gap. A hit computes them again without
//! cancellation, so that `t` keeps its digits on triangles a million times longer than wide.

use super::{
    Lanes, Normal, Point, Ray, UNIT_ROUNDOFF, Vector, difference_of_products, exact_cross,
};

/// The least projected area of a triangle, relative to the products it is the sum of, for which
/// plain products are accurate enough. The relative error of the three weights together is then at
/// most 2u/`MIN_AREA` = 32u, and that of `t` is 32u of the range of the corners' depths. The
/// rounding of the corners themselves (the condition of `t`) has a larger effect.
const MIN_AREA: f64 = 1.0 / 16.0;
/// Added to the least area, so that underflow of a product cannot matter.
const MIN_PRODUCTS: f64 = 1e-140;

/// A ray prepared for triangles.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    /// The world's axes that are its x, y and z.
    pub(crate) axes: [usize; 3],
    /// Its origin, in the order of its own axes.
    origin: [f64; 3],
    shear: [f64; 3],
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

    /// The intersection with a triangle, at any `t`; `None` if the ray passes beside it, lies in
    /// its plane, or a result is NaN.
    #[inline]
    pub fn meet(&self, corners: &[Point; 3]) -> Option<Meeting> {
        match self.axes[2] {
            0 => self.meet_along::<0>(corners),
            1 => self.meet_along::<1>(corners),
            _ => self.meet_along::<2>(corners),
        }
    }

    /// `new` and `meet` in one, with the same bits, for a ray that is tested against a single
    /// triangle.
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
        let axes = [(Z + 1) % 3, (Z + 2) % 3, Z];
        let [d, origin] = [ray.direction.to_array(), ray.origin.to_array()];
        let inverse = 1.0 / d[Z];
        let shear = [d[axes[0]] * inverse, d[axes[1]] * inverse, inverse];
        Self { axes, origin: [origin[axes[0]], origin[axes[1]], origin[Z]], shear }
    }

    /// Vertices, given along the ray's axes, in the ray's coordinates: two offsets across it, and
    /// depth.
    #[inline(always)]
    pub fn see<L: Lanes>(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let [origin_x, origin_y, origin_z] = self.origin;
        let [shear_x, shear_y, shear_z] = self.shear;
        let (x, y, z) = (x - x.all(origin_x), y - y.all(origin_y), z - z.all(origin_z));
        [x - x.all(shear_x) * z, y - y.all(shear_y) * z, z.all(shear_z) * z]
    }

    #[inline(always)]
    fn see_along<const Z: usize>(&self, vertex: Point) -> [f64; 3] {
        let v = vertex.to_array();
        self.see([v[(Z + 1) % 3], v[(Z + 2) % 3], v[Z]])
    }

    // inlined, and without `map` of arrays, which is a call that passes its result in memory: saves a
    // third of the time
    #[inline(always)]
    fn meet_along<const Z: usize>(&self, corners: &[Point; 3]) -> Option<Meeting> {
        let [ax, ay, az] = self.see_along::<Z>(corners[0]);
        let [bx, by, bz] = self.see_along::<Z>(corners[1]);
        let [cx, cy, cz] = self.see_along::<Z>(corners[2]);
        let (a, b, c) = ([ax, ay], [bx, by], [cx, cy]);
        let edges = Edges::of(a, b, c);
        let mut parts = edges.parts;
        if outside(parts) != 0 {
            return None;
        }
        if edges.large() == 0 {
            parts = careful_parts(a, b, c);
            if outside(parts) != 0 {
                return None;
            }
        }
        let Met { t, beta, gamma } = meeting(parts, [az, bz, cz]);
        (!t.is_nan()).then_some(Meeting { t, barycentric: [beta, gamma] })
    }
}

/// The edge functions, by plain products, of one triangle or of several.
#[derive(Clone, Copy)]
pub struct Edges<L> {
    /// Twice the projected areas of the three parts into which the ray divides the triangle.
    pub parts: [L; 3],
    /// The sum of the absolute products that `parts` are differences of.
    products: L,
}

impl<L: Lanes> Edges<L> {
    /// The edge functions of triangles with these corners in the ray's coordinates.
    #[inline(always)]
    pub fn of([ax, ay]: [L; 2], [bx, by]: [L; 2], [cx, cy]: [L; 2]) -> Self {
        let (u_plus, u_minus) = (cx * by, cy * bx);
        let (v_plus, v_minus) = (ax * cy, ay * cx);
        let (w_plus, w_minus) = (bx * ay, by * ax);
        Self {
            parts: [u_plus - u_minus, v_plus - v_minus, w_plus - w_minus],
            products: (u_plus.abs() + u_minus.abs())
                + (v_plus.abs() + v_minus.abs())
                + (w_plus.abs() + w_minus.abs()),
        }
    }

    /// Where plain products are accurate enough.
    #[inline(always)]
    pub fn large(&self) -> u8 {
        let [u, v, w] = self.parts;
        let least = u.all(MIN_AREA) * self.products + u.all(MIN_PRODUCTS);
        least.less((u + v + w).abs())
    }
}

/// Where the signs of the edge functions differ: the ray passes beside the triangle.
#[inline(always)]
pub fn outside<L: Lanes>(parts: [L; 3]) -> u8 {
    let zero = parts[0].all(0.0);
    least(parts).less(zero) & zero.less(greatest(parts))
}

/// Where rays meet triangles.
#[derive(Clone, Copy)]
pub struct Met<L> {
    /// Along the ray.
    pub t: L,
    /// The weight of the second corner.
    pub beta: L,
    /// The weight of the third corner.
    pub gamma: L,
}

/// The intersection by these edge functions with triangles whose corners have these depths.
#[inline(always)]
pub fn meeting<L: Lanes>([u, v, w]: [L; 3], depths: [L; 3]) -> Met<L> {
    let [a, b, c] = depths;
    let sum = u + v + w;
    let t = (u * a + v * b + w * c) / sum; // no slower: it does not wait for the reciprocal
    // The true t lies between the depths of the corners; the rounded one must too, or one accelerator's
    // bounding box could cull a hit that another finds.
    let t = greatest(depths).min(least(depths).max(t));
    let inverse = sum.all(1.0) / sum;
    Met { t, beta: v * inverse, gamma: w * inverse }
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

#[inline(always)]
fn least<L: Lanes>([a, b, c]: [L; 3]) -> L {
    a.min(b).min(c)
}

#[inline(always)]
fn greatest<L: Lanes>([a, b, c]: [L; 3]) -> L {
    a.max(b).max(c)
}

/// Twice the least area of a triangle: that of one as long as the shortest supported length, 1e-40,
/// and 1e40 times thinner. The reciprocal of a smaller one can overflow, and the weights of the
/// corners are then NaN.
const LEAST_AREA: f64 = 1e-120;

/// The normal of a triangle by its winding, `(b − a) × (c − a)`; `None` if its area is zero, or too
/// small to divide by.
pub fn normal([a, b, c]: [Point; 3]) -> Option<Normal> {
    let cross = exact_cross(a, b, c);
    if cross.max_abs() < LEAST_AREA {
        return None;
    }
    Normal::new(cross)
}

/// The point with these barycentric coordinates, and a bound of its distance, along the normal,
/// from the triangle that the test above intersects: rounding of the vertices relative to the ray's
/// origin, and of their shear.
pub fn point_on([a, b, c]: [Point; 3], [beta, gamma]: [f64; 2], n: Normal) -> (Point, f64) {
    let (ab, ac) = (b - a, c - a);
    let raw = a + (beta * ab + gamma * ac);
    let point = raw - (raw - a).dot(n) * n;
    let size = ab.max_abs().max(ac.max_abs());
    let magnitude = point.to_vector().abs() + a.to_vector().abs();
    let error = UNIT_ROUNDOFF * (10.0 * magnitude.dot(Vector::from(n).abs()) + 24.0 * size);
    (point, error)
}
