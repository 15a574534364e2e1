//! The tent filter: it falls linearly from the pixel's centre.

use super::{Filter, Made, Specification, made};

/// `(1 − |x|/r)/r` within the radius `r`.
#[kind(PartialEq)]
pub struct Tent {
    /// The radius in pixels: positive, at most 16. At 1 the tents of all pixels add up to 1
    /// everywhere.
    #[default(1.0)]
    pub radius: f64,
}

impl Specification for Tent {
    fn make(&self, (): &mut ()) -> Made {
        super::radius(self.radius)?;
        made(self.clone())
    }
}

impl Filter for Tent {
    /// The area of a corner of the triangle is the square of its side: `u = ½ (1 + x/r)²` left of
    /// the centre.
    fn draw(&self, u: f64) -> (f64, f64) {
        let x = if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() };
        (0.5 + self.radius * x, 1.0)
    }

    fn value(&self, x: f64) -> f64 {
        (1.0 - x.abs() / self.radius).max(0.0) / self.radius
    }

    fn radius(&self) -> f64 {
        self.radius
    }
}
