//! A surface without edges and what is kept of it: a disk is a plane within a radius, a part
//! cylinder is a cylinder between two heights and two azimuths.
//!
//! A [`Carrier`] says where a line meets it, a [`Trim`] which of its points are kept and how far
//! they are from the edges. The rule of borders and the book's own routine are here once, for all
//! of them.

use std::fmt::Debug;
use std::sync::Arc;

use super::border::{Border, is_rounding, nears};
use super::textbook::{self, Form, first_on};
use super::{Candidate, SampledSurface, Sampling, Shape, Surface};
use crate::math::{Aabb, Point, Ray, Span, Vector};

/// A surface without edges.
pub trait Carrier: Clone + Debug + Send + Sync + 'static {
    /// What the whole surface of a part is called.
    const WHOLE: &'static str;

    /// The point from which trims measure.
    #[inline]
    fn center(&self) -> Point {
        Point::ORIGIN
    }

    /// Where the line meets it, ascending. Those outside of the span, or of `bounds`, are not
    /// needed.
    fn roots(&self, ray: &Ray, span: Span, bounds: &Aabb) -> impl Roots;

    /// The same by the book's formula.
    fn book_roots(&self, ray: &Ray, span: Span) -> impl IntoIterator<Item = f64>;

    /// The surface at the root `t` of this ray.
    fn surface(&self, ray: &Ray, t: f64) -> Surface;

    /// A box around all of it.
    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }
}

/// Where a line meets a surface, ascending.
pub trait Roots {
    /// The first that is in the span and on the shape.
    fn first(self, span: Span, has: impl Fn(f64) -> bool) -> Option<Candidate>;

    /// All that are in the span and on the shape.
    fn all(self, span: Span, has: impl Fn(f64) -> bool) -> Vec<Candidate>;
}

/// The one root of a plane, which is not finite if there is none.
impl Roots for f64 {
    #[inline(always)]
    fn first(self, span: Span, has: impl Fn(f64) -> bool) -> Option<Candidate> {
        (span.contains(self) && has(self)).then(|| Candidate::at(self))
    }

    fn all(self, span: Span, has: impl Fn(f64) -> bool) -> Vec<Candidate> {
        self.first(span, has).into_iter().collect()
    }
}

/// Two roots, or one and NaN. Both are tested: if the near one is beyond an end of the shape, the
/// far one may be on it.
impl Roots for Option<[f64; 2]> {
    #[inline]
    fn first(self, span: Span, has: impl Fn(f64) -> bool) -> Option<Candidate> {
        let counts = |t: f64| span.contains(t) && has(t);
        let [near, far] = self?;
        // not a loop, which costs as much as the square root
        if counts(near) {
            return Some(Candidate::at(near));
        }
        counts(far).then(|| Candidate::at(far))
    }

    fn all(self, span: Span, has: impl Fn(f64) -> bool) -> Vec<Candidate> {
        Searched(self.into_iter().flatten()).all(span, has)
    }
}

/// Roots that are searched one after the other.
pub struct Searched<I>(pub I);

impl<I: Iterator<Item = f64>> Roots for Searched<I> {
    fn first(mut self, span: Span, has: impl Fn(f64) -> bool) -> Option<Candidate> {
        self.0.find(|&t| span.contains(t) && has(t)).map(Candidate::at)
    }

    fn all(self, span: Span, has: impl Fn(f64) -> bool) -> Vec<Candidate> {
        self.0.filter(|&t| span.contains(t) && has(t)).map(Candidate::at).collect()
    }
}

/// What is kept of a carrier: the points between two edges, given from the carrier's centre. An
/// edge that does not exist is infinitely far away.
pub trait Trim: Clone + Debug + Send + Sync + 'static {
    /// Whether the point is kept.
    #[inline]
    fn has(&self, v: Vector) -> bool {
        let [first, last] = self.distances(v);
        first >= 0.0 && last >= 0.0
    }

    /// The same by the book's test.
    fn book_has(&self, v: Vector) -> bool {
        self.has(v)
    }

    /// The distances of the point from both edges, negative beyond.
    fn distances(&self, v: Vector) -> [f64; 2];

    /// The unit vectors along the surface away from both edges.
    fn away(&self, v: Vector) -> [Vector; 2];

    /// Whether the point, at `t` of the ray, is so near an edge that [`Trim::has`] may be wrong by
    /// rounding. `size` is the largest number in the test.
    #[inline]
    fn nears(&self, v: Vector, size: f64, _ray: &Ray, _t: f64) -> bool {
        nears(self.distances(v), size)
    }

    /// The normal of the wall that meets the carrier at the edges, if it is not along
    /// [`Trim::away`].
    fn wall(&self) -> Option<Vector> {
        None
    }
}

/// No trim: all of the carrier.
#[derive(Clone, Debug)]
pub struct All;

impl Trim for All {
    #[inline]
    fn distances(&self, _: Vector) -> [f64; 2] {
        [f64::INFINITY; 2]
    }

    fn away(&self, _: Vector) -> [Vector; 2] {
        [Vector::ZERO; 2]
    }

    #[inline]
    fn nears(&self, _: Vector, _size: f64, _: &Ray, _t: f64) -> bool {
        true
    }
}

/// What both trims keep of a carrier.
#[derive(Clone, Debug)]
pub struct Trimmed<C, A = All, B = All> {
    pub carrier: C,
    pub trims: (A, B),
    /// The largest number in the tests of the trims.
    pub size: f64,
    pub bounds: Aabb,
    /// As [`Shape::sampled`].
    pub sampler: fn(&Self, Sampling) -> Option<Box<dyn SampledSurface>>,
}

impl<C: Carrier> Trimmed<C> {
    /// All of the carrier.
    pub fn whole(carrier: C) -> Self {
        let bounds = carrier.bounds();
        Self::new(carrier, (All, All), 0.0, bounds)
    }
}

impl<C: Carrier, A: Trim, B: Trim> Trimmed<C, A, B> {
    /// A surface on which no points are drawn. `size` is the largest number in the tests of the
    /// trims.
    pub fn new(carrier: C, trims: (A, B), size: f64, bounds: Aabb) -> Self {
        Self { carrier, trims, size, bounds, sampler: |_, _| None }
    }

    /// Whether the root `t` of the ray is kept.
    #[inline]
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let ((a, b), v) = (&self.trims, ray.at(t) - self.carrier.center());
            let nears = || a.nears(v, self.size, ray, t) && b.nears(v, self.size, ray, t);
            a.has(v) && b.has(v) || nears() && is_rounding(self, ray, t)
        }
    }

    /// The border, near a point from the centre.
    #[inline]
    fn border(&self, v: Vector) -> Option<Box<Border>> {
        let (a, b) = &self.trims;
        let ([a0, a1], [b0, b1]) = (a.distances(v), b.distances(v));
        let border = Border::of([a0, a1, b0, b1], self.size, || {
            let ([a0, a1], [b0, b1]) = (a.away(v), b.away(v));
            [a0, a1, b0, b1]
        });
        match a.wall() {
            None => border,
            Some(wall) => border.map(|border| Box::new(border.cut_across(wall))),
        }
    }
}

impl<C: Carrier, A: Trim, B: Trim> Shape for Trimmed<C, A, B> {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.carrier.roots(ray, span, &self.bounds).first(span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = self.carrier.surface(ray, at.t);
        let border = self.border(surface.point - self.carrier.center());
        surface.within(border)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.carrier.roots(ray, span, &self.bounds).all(span, self.has(ray))
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        (self.sampler)(self, sampling)
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn whole(&self) -> Option<(&'static str, Arc<dyn Shape>)> {
        Some((C::WHOLE, Arc::new(Trimmed::whole(self.carrier.clone()))))
    }

    fn textbook(&self, epsilon: f64) -> Option<Arc<dyn Shape>> {
        textbook::form(self.clone(), self.clone(), epsilon)
    }
}

impl<C: Carrier, A: Trim, B: Trim> Form for Trimmed<C, A, B> {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let (a, b) = &self.trims;
        first_on(self.carrier.book_roots(ray, span), span, |t| {
            let v = ray.at(t) - self.carrier.center();
            a.book_has(v) && b.book_has(v)
        })
    }
}
