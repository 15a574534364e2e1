//! The solid angle of a rectangle as seen from a point, and directions drawn evenly in it.
//!
//! Source: Ureña, Fajardo & King, "An Area-Preserving Parametrization for Spherical Rectangles",
//! EGSR
//! 2013. The paper takes the four angles between the planes through the edges by `acos` of unit
//!       normals; here they are `atan2` of products, which keeps its digits.

use std::f64::consts::PI;

use crate::math::{Point, Vector, atan2, cos, sin};

/// A rectangle seen from a point, in coordinates along its sides about that point; `z < 0`.
#[derive(Clone, Copy, Debug)]
pub(in crate::shapes) struct SphericalRectangle {
    from: Point,
    axes: [Vector; 3],
    x: [f64; 2],
    y: [f64; 2],
    z: f64,
    /// In steradians.
    pub solid_angle: f64,
    /// The angle at which the area parameter starts, `k` in the paper.
    start: f64,
}

/// The solid angle is a difference of angles near 2π, with an error of some 1e-15: a smaller one
/// has too few digits. Such a rectangle is almost edge-on and sends hardly any light.
const MIN_SOLID_ANGLE: f64 = 1e-9;
/// The square of diagonal over distance. Below it all points of the rectangle look almost equally
/// large, and sampling by area is as good.
const MIN_SIZE_SQUARED: f64 = 1e-4;

impl SphericalRectangle {
    /// `None` for a rectangle that looks too small for it, or is seen edge-on.
    pub fn seen_from(from: Point, corner: Point, [a, b]: [Vector; 2]) -> Option<Self> {
        let (width, height) = (a.length(), b.length());
        let (along_x, along_y) = (a / width, b / height);
        let across = along_x.cross(along_y);
        let d = corner - from;
        let z = d.dot(across);
        let sign = 1.0_f64.copysign(-z);
        let axes = [along_x, along_y, sign * across];
        let z = sign * z;
        let [x0, y0] = [d.dot(along_x), d.dot(along_y)];
        let (x, y) = ([x0, x0 + width], [y0, y0 + height]);
        // between the planes through two neighbouring edges, at the corner (x, y)
        let angle =
            |x: f64, y: f64, product: f64| atan2(-z * (x * x + y * y + z * z).sqrt(), product);
        let [x0, x1] = x;
        let [y0, y1] = y;
        let g0 = angle(x1, y0, x1 * y0);
        let g1 = angle(x1, y1, -x1 * y1);
        let g2 = angle(x0, y1, x0 * y1);
        let g3 = angle(x0, y0, -x0 * y0);
        let start = 2.0 * PI - g2 - g3;
        let solid_angle = g0 + g1 - start;
        let is_near = width * width + height * height >= MIN_SIZE_SQUARED * d.length_squared();
        let fits = is_near && solid_angle >= MIN_SOLID_ANGLE && z < 0.0;
        fits.then_some(Self { from, axes, x, y, z, solid_angle, start })
    }

    /// The point of the rectangle in the direction for two numbers in `[0, 1)`.
    #[inline]
    pub fn point(&self, [u, v]: [f64; 2]) -> Point {
        let Self { from, axes, x: [x0, x1], y: [y0, y1], z, .. } = *self;
        let plane = |y: f64| y / (y * y + z * z).sqrt();
        let (b0, b1) = (-plane(y0), plane(y1));
        let angle = self.start + u * self.solid_angle;
        let f = (cos(angle) * b0 - b1) / sin(angle);
        // from a point on the rectangle itself f may be 0/0; its limit is infinite
        let c = if f.is_nan() { 0.0 } else { 1.0 / (f * f + b0 * b0).sqrt() };
        let c = c.copysign(f).clamp(-1.0, 1.0);
        let x = (-(c * z) / ((1.0 - c) * (1.0 + c)).sqrt()).clamp(x0, x1);
        let d = (x * x + z * z).sqrt();
        let height = |y: f64| y / (d * d + y * y).sqrt();
        let (h0, h1) = (height(y0), height(y1));
        let h = h0 + v * (h1 - h0);
        let y = (h * d / ((1.0 - h) * (1.0 + h)).sqrt()).clamp(y0, y1);
        from + (x * axes[0] + y * axes[1] + z * axes[2])
    }
}
