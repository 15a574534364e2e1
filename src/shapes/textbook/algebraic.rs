//! A polynomial's surface in a box. The book has no formula for it; this is the usual way, by
//! samples along the ray. A sign that changes twice between two of them is lost.

use std::iter::repeat_n;

use super::{Form, cuboid};
use crate::math::{Point, Ray, Span};
use crate::shapes::plain::algebraic::AlgebraicShape;
use crate::shapes::{Candidate, Term};

/// The steps of a ray through the box.
const STEPS: u32 = 100;
/// Of a step, where the sign changes: to the last digits of `f64`.
const HALVINGS: u32 = 48;

fn value(terms: &[Term], p: Point) -> f64 {
    let factors = |powers: [u32; 3]| p.to_array().into_iter().zip(powers);
    let product = |(x, power): (f64, u32)| repeat_n(x, power as usize).product::<f64>();
    let term = |term: &Term| term.coefficient * factors(term.powers).map(product).product::<f64>();
    terms.iter().map(term).sum()
}

impl Form for AlgebraicShape {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let (t0, t1) = cuboid::slabs(ray, self.domain.min, self.domain.max);
        let t0 = t0.max(span.min);
        if t0 >= t1 {
            return None;
        }
        let is_positive = |t: f64| value(&self.terms, ray.at(t)) > 0.0;
        let sign = is_positive(t0);
        let at = |i: u32| t0 + (t1 - t0) * f64::from(i) / f64::from(STEPS);
        let changed = (1..=STEPS).find(|&i| is_positive(at(i)) != sign)?;
        let (mut low, mut high) = (at(changed - 1), at(changed));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *(if is_positive(middle) == sign { &mut low } else { &mut high }) = middle;
        }
        span.contains(high).then(|| Candidate::at(high))
    }
}
