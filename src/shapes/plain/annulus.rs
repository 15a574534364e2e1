//! The annulus (Suffern, ch. 19), a disk with a hole: the points `p` of the plane through `c` with
//! the normal `n` for which `r_in² ≤ |p − c|² ≤ r_out²`.
//!
//! A ray meets the plane at `t = (c − o)·n / d·n`, and then the point is tested, as in the book,
//! whose own test has `<` for `≤`.

use crate::invalid::{Invalid, shown};
use crate::math::{Length, Point, Vector, Width};
use crate::shapes::border::along;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::trimmed::{All, Trim, Trimmed};
use crate::shapes::{Context, Made, Specification, made};

/// The points of a plane from `inner_radius` to `outer_radius` away from `center`.
#[kind(PartialEq)]
pub struct Annulus {
    /// The centre.
    pub center: Point,
    /// Perpendicular to the annulus; not zero, need not be unit.
    pub normal: Vector,
    /// The radius of the hole; not negative.
    pub inner_radius: Width,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: Length,
}

/// The points with `r_in² ≤ |p − c|² ≤ r_out²`.
#[derive(Clone, Debug)]
pub struct Radii {
    inner: f64,
    pub outer: f64,
    squares: [f64; 2],
}

impl Specification for Annulus {
    fn make(&self, _: &mut Context) -> Made {
        let plane = PlaneThrough::checked(self.center, self.normal)?;
        let radii = Radii::between(radii(self.inner_radius, self.outer_radius)?);
        let (size, bounds) = (radii.size(self.center), plane.bounds_within(radii.outer));
        made(Trimmed::new(plane, (radii, All), size, bounds))
    }
}

/// The fields `inner_radius` and `outer_radius`, if they are in order.
pub fn radii(inner: f64, outer: f64) -> Result<[f64; 2], Invalid> {
    if inner >= outer {
        let (inner, outer) = (shown(inner), shown(outer));
        let problem = format!("found {outer}, but it must be above inner_radius, {inner}");
        return Err(Invalid::field("outer_radius", problem));
    }
    Ok([inner, outer])
}

impl Radii {
    pub fn between([inner, outer]: [f64; 2]) -> Self {
        Self { inner, outer, squares: [inner * inner, outer * outer] }
    }

    /// All points up to this radius. In the book's test an inner radius of 0 would leave out the
    /// centre.
    pub fn within(outer: f64) -> Self {
        Self { squares: [f64::NEG_INFINITY, outer * outer], ..Self::between([0.0, outer]) }
    }

    /// The largest number in the test.
    pub fn size(&self, center: Point) -> f64 {
        self.outer + center.to_vector().max_abs()
    }
}

impl Trim for Radii {
    #[inline]
    fn has(&self, v: Vector) -> bool {
        let ([inner, outer], square) = (self.squares, v.length_squared());
        inner <= square && square <= outer
    }

    fn book_has(&self, v: Vector) -> bool {
        let ([inner, outer], square) = (self.squares, v.length_squared());
        inner < square && square < outer
    }

    /// From both circles, the outer one first; a hole of radius 0 is none.
    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        let rho = v.length();
        [self.outer - rho, if self.inner > 0.0 { rho - self.inner } else { f64::INFINITY }]
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        let radial = along(v);
        [-radial, radial]
    }
}
