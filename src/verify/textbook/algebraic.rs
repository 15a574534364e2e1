//! A polynomial's surface in a box. The book has no formula for it; this is the usual way, by samples
//! along the ray. A sign that changes twice between two of them is lost.

use std::iter::repeat_n;

use super::{SMALL_K_EPSILON, Textbook, cuboid};
use crate::math::{Point, Ray};

/// The steps of a ray through the box.
const STEPS: u32 = 100;
/// Of a step, where the sign changes: to the last digits of `f64`.
const HALVINGS: u32 = 48;

/// Where a polynomial is zero in a box.
#[derive(Clone, Debug)]
pub struct Algebraic {
    /// A coefficient, and the powers of x, y and z.
    pub terms: Vec<(f64, [u32; 3])>,
    /// The corner of least coordinates.
    pub min: Point,
    /// The corner of greatest coordinates.
    pub max: Point,
}

impl Algebraic {
    fn value(&self, p: Point) -> f64 {
        let factors = |powers: [u32; 3]| p.to_array().into_iter().zip(powers);
        let product = |(x, power): (f64, u32)| repeat_n(x, power as usize).product::<f64>();
        let term = |&(c, powers): &(f64, _)| c * factors(powers).map(product).product::<f64>();
        self.terms.iter().map(term).sum()
    }
}

impl Textbook for Algebraic {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (t0, t1) = cuboid::slabs(ray, self.min, self.max);
        let t0 = t0.max(SMALL_K_EPSILON);
        if t0 >= t1 {
            return None;
        }
        let is_positive = |t: f64| self.value(ray.at(t)) > 0.0;
        let first = is_positive(t0);
        let at = |i: u32| t0 + (t1 - t0) * f64::from(i) / f64::from(STEPS);
        let changed = (1..=STEPS).find(|&i| is_positive(at(i)) != first)?;
        let (mut low, mut high) = (at(changed - 1), at(changed));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *(if is_positive(middle) == first { &mut low } else { &mut high }) = middle;
        }
        Some(high)
    }
}
