//! Points drawn on a surface, for lights (Suffern, ch. 18).
//!
//! By area, as in the book, a part of the surface is drawn with a probability proportional to its
//! area. By solid angle it is proportional to the solid angle of the part at the shading point: no
//! sample falls on a part that faces away, and all have the same weight.

use std::fmt::Debug;

use super::{Candidate, Surface};
use crate::math::Point;

/// How points are drawn on a surface.
#[kind]
#[schemars(title = "ways of sampling")]
pub enum Sampling {
    /// In proportion to area, as in the book.
    Area,
    /// In proportion to solid angle, for spheres and rectangles.
    SolidAngle,
}

/// A surface on which points are drawn. Contract: `tests/contracts/light.rs`, of the lamps made of
/// it.
pub trait SampledSurface: Debug + Send + Sync {
    /// A point for two numbers in `[0, 1)`, and its density per steradian as seen from `from`:
    /// positive and finite. `None` for a point that is not seen, or edge-on.
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)>;

    /// The candidate of the point for these two numbers, as far as its texture coordinates and its
    /// triangle need it. Called only if the lamp's colour is a texture.
    fn candidate(&self, _from: Point, _u: [f64; 2]) -> Candidate {
        Candidate::at(0.0)
    }

    /// The density with which [`SampledSurface::sample`] draws this point of the surface, per
    /// steradian.
    fn pdf(&self, from: Point, at: &Surface) -> f64;
}

/// A surface on which points can be drawn evenly.
pub(super) trait EvenSurface: Debug + Send + Sync {
    /// Its area.
    fn area(&self) -> f64;

    /// A point for two numbers in `[0, 1)`; equal areas for equal areas of the square.
    fn point(&self, u: [f64; 2]) -> Surface;

    /// As [`SampledSurface::candidate`].
    fn candidate(&self, _u: [f64; 2]) -> Candidate {
        Candidate::at(0.0)
    }

    /// Whether the surface itself hides this point of it, as the far side of a sphere is hidden.
    fn is_hidden(&self, _from: Point, _at: &Surface) -> bool {
        false
    }

    /// As [`SampledSurface::sample`], by area.
    fn sample_by_area(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        let at = self.point(u);
        let pdf = self.pdf_by_area(from, &at);
        (pdf > 0.0).then_some((at, pdf))
    }

    /// As [`SampledSurface::pdf`], by area: `d²/(A |cosθ'|)`, the density `1/A` seen from afar; 0
    /// for a point seen edge-on, which sends no light.
    fn pdf_by_area(&self, from: Point, at: &Surface) -> f64 {
        if self.is_hidden(from, at) {
            return 0.0;
        }
        let way = at.point - from;
        let (squared, along) = (way.length_squared(), at.normal.dot(way).abs());
        let pdf = squared / self.area() * (squared.sqrt() / along);
        if pdf.is_finite() { pdf } else { 0.0 }
    }
}

/// A surface that is sampled by area.
#[derive(Debug)]
pub(super) struct ByArea<S>(pub S);

impl<S: EvenSurface> SampledSurface for ByArea<S> {
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        self.0.sample_by_area(from, u)
    }

    fn candidate(&self, _: Point, u: [f64; 2]) -> Candidate {
        self.0.candidate(u)
    }

    fn pdf(&self, from: Point, at: &Surface) -> f64 {
        self.0.pdf_by_area(from, at)
    }
}
