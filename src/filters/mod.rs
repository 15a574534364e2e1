//! Filters: how much a pixel counts what lies around its centre (Suffern, ch. 4; Pharr, Jakob &
//! Humphreys, "Physically Based Rendering", ch. 8).
//!
//! A sample's position is drawn with a density proportional to the filter's absolute value; its
//! radiance is weighted by the filter over the density, ±1 times a constant (Ernst, Stamminger &
//! Greiner, "Filter Importance Sampling", 2006). So a sample belongs to one pixel and is a pure
//! function.

mod cuboid;
mod gaussian;
mod mitchell;
mod tent;

use std::fmt::Debug;

use crate::invalid::{Invalid, positive, within};
use crate::math::{Tolerance, UNIT_ROUNDOFF, bracketed_root};

/// A filter of the plane: the product of the same function of x and of y. Contract:
/// `tests/contracts/filter.rs`.
pub trait Filter: Debug + Send + Sync {
    /// Along one axis, for a uniform number in `[0, 1)`: the position of a sample, in pixels from
    /// the pixel's lower edge (its centre is at ½), and its weight. The position increases with
    /// `u`.
    fn draw(&self, u: f64) -> (f64, f64);

    /// The filter along one axis, at a distance in pixels from the pixel's centre; its integral is
    /// 1.
    fn value(&self, x: f64) -> f64;

    /// Beyond this distance in pixels from the centre, along each axis, the filter is 0.
    fn radius(&self) -> f64;
}

crate::kinds! {
    /// How much samples count that lie around the centre of a pixel.
    Kind builds dyn Filter with ();
    ch04 cuboid::Box,
    ch04 tent::Tent,
    ch04 gaussian::Gaussian,
    ch04 mitchell::Mitchell,
}

impl Default for Kind {
    /// The book's filter: constant in the pixel, 0 outside.
    fn default() -> Self {
        Box {}.into()
    }
}

impl Kind {
    /// Whether it need not be written.
    pub(crate) fn is_default(&self) -> bool {
        matches!(self, Self::Box(_))
    }
}

/// The largest radius, in pixels: wider filters only blur, slowly.
const WIDEST: f64 = 16.0;

/// `radius`, if it is positive and not too wide.
fn radius(radius: f64) -> Result<f64, Invalid> {
    within("radius", positive("radius", radius)?, 0.0..=WIDEST)
}

/// The `x` in `[0, end]` at which an increasing function (given with its slope) reaches `target`.
fn inverse(target: f64, end: f64, function: impl Fn(f64) -> [f64; 2]) -> f64 {
    let above = |x: f64| {
        let [value, slope] = function(x);
        [value - target, slope]
    };
    // an absolute tolerance: a position in a pixel needs no more digits near 0 than elsewhere
    let tolerance = Tolerance { step: UNIT_ROUNDOFF, ..Tolerance::default() };
    bracketed_root(above, [0.0, end], 0.5 * end, tolerance)
}
