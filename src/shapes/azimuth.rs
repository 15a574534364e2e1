//! The range of azimuths of part objects (Suffern, ch. 19).

use crate::invalid::Invalid;
use crate::math::{Vector, cos_degrees, sin_degrees};

/// The directions about the y axis from one azimuth φ up to another, both included; as the book
/// measures φ, `x = ρ sin φ` and `z = ρ cos φ`.
///
/// No angle is taken of a point: sides are told by cross products with the two ends, which are
/// exact at multiples of 90°, so that ranges with a common end leave no gap.
#[derive(Clone, Copy, Debug)]
pub struct Azimuth {
    /// `(sin φ, cos φ)` of the first end.
    start: [f64; 2],
    /// … and of the last.
    end: [f64; 2],
    width: Width,
}

#[derive(Clone, Copy, Debug)]
enum Width {
    /// Up to 180°: what is past the start and before the end.
    Narrow,
    /// More: what is past the start or before the end.
    Wide,
    All,
}

/// All around: the default of scene files.
pub fn full_turn() -> [f64; 2] {
    [0.0, 360.0]
}

impl Azimuth {
    /// From the first number of degrees up to the second; through 360° where the first is larger.
    pub fn new(field: &str, range @ [from, to]: [f64; 2]) -> Result<Self, Invalid> {
        let fits = |degrees: &f64| (-360.0..=360.0).contains(degrees);
        let width = if to >= from { to - from } else { (to - from).rem_euclid(360.0) };
        if !range.iter().all(fits) || width == 0.0 {
            let problem = format!(
                "found {range:?}, but two different azimuths in degrees from -360 to 360 are needed; \
                 [350, 10] passes through 360"
            );
            return Err(Invalid::field(field, problem));
        }
        let width = match width {
            w if w >= 360.0 => Width::All,
            w if w > 180.0 => Width::Wide,
            _ => Width::Narrow,
        };
        let [start, end] = range.map(|phi| [sin_degrees(phi), cos_degrees(phi)]);
        Ok(Self { start, end, width })
    }

    /// Whether the direction from the y axis to this point is in the range; the axis itself is.
    pub fn contains(&self, v: Vector) -> bool {
        let ([s0, c0], [s1, c1]) = (self.start, self.end);
        let past_start = v.x() * c0 - v.z() * s0 >= 0.0; // sin(φ − φ₀)
        let before_end = v.z() * s1 - v.x() * c1 >= 0.0; // sin(φ₁ − φ)
        match self.width {
            Width::Narrow => past_start && before_end,
            Width::Wide => past_start || before_end,
            Width::All => true,
        }
    }

    /// The corners of the smallest box of height 0 around the points of the range at distances
    /// from `near` to `far` from the axis.
    pub fn bounds(&self, near: f64, far: f64) -> [Vector; 2] {
        let at = |[s, c]: [f64; 2], distance: f64| Vector::new(distance * s, 0.0, distance * c);
        let ends = [self.start, self.end].into_iter().flat_map(|e| [at(e, near), at(e, far)]);
        let axes = [Vector::X, Vector::Z, -Vector::X, -Vector::Z].into_iter();
        let axes = axes.filter(|&axis| self.contains(axis)).map(|axis| far * axis);
        let all: Vec<Vector> = ends.chain(axes).collect();
        let max = all.iter().copied().reduce(Vector::max).unwrap_or_default();
        let min = all.iter().map(|&v| -v).reduce(Vector::max).unwrap_or_default();
        [-min, max]
    }
}
