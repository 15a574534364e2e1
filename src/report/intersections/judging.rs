//! How far from the exact answer each routine is.

use std::fmt::Debug;
use std::sync::Arc;

use oracle::hard::{Family, Kind, cases};

use super::{FamilyData, Routine};
use crate::math::{Ray, Span};
use crate::shapes::Shape;
use crate::verify::against::{ALLOWED, is_decided, pair, ray, t_error};
use crate::verify::quantile;
use crate::verify::textbook::{self, Textbook};

/// A ray and the shape that it is tested against, in both forms.
#[derive(Debug)]
pub struct Case {
    pub ray: Ray,
    pub ours: Arc<dyn Shape>,
    pub textbook: Box<dyn Textbook>,
}

/// One kind and family, judged, and the rays to be timed.
pub struct Judged {
    pub data: FamilyData,
    pub hits: Vec<Case>,
    pub misses: Vec<Case>,
}

/// Rays that are timed together: their shapes fit into the processor's caches.
const TIMED: usize = 256;

impl Judged {
    /// Judges the cases that do not turn on rounding.
    pub fn new(kind: Kind, family: Family, seed: u64, count: usize) -> Self {
        let (mut ours, mut book) = (Tally::default(), Tally::default());
        let (mut hits, mut misses) = (Vec::new(), Vec::new());
        let (mut refused, mut judged, mut hit_count) = (0, 0, 0);
        for (shape, exact_ray) in cases(kind, family, seed, count) {
            let Some(pair) = pair(&shape) else {
                refused += 1;
                continue;
            };
            let answer = oracle::intersect(&pair.exact, &exact_ray);
            let condition = pair.exact.condition();
            if !is_decided(&answer, condition) {
                continue;
            }
            judged += 1;
            let ray = ray(&exact_ray);
            let textbook = textbook::of(&pair.exact);
            let found = pair.ours.hit(&ray, Span::AHEAD).map(|candidate| candidate.t);
            ours.meet(found, &answer);
            book.meet(textbook.hit(&ray), &answer);
            hit_count += usize::from(!answer.roots.is_empty());
            let timed = if answer.roots.is_empty() { &mut misses } else { &mut hits };
            if timed.len() < TIMED {
                timed.push(Case { ray, ours: pair.ours, textbook });
            }
        }
        let data = FamilyData {
            family: format!("{family:?}"),
            refused,
            judged,
            hits: hit_count,
            ours: ours.routine(),
            textbook: book.routine(),
        };
        Self { data, hits, misses }
    }
}

/// What one routine got right and wrong.
#[derive(Default)]
struct Tally {
    errors: Vec<f64>,
    lost: usize,
    wrong: usize,
}

impl Tally {
    fn meet(&mut self, found: Option<f64>, answer: &oracle::Answer) {
        match (found, answer.roots.first()) {
            (None, None) => {}
            (Some(_), None) => self.wrong += 1,
            (None, Some(_)) => self.lost += 1,
            (Some(t), Some(first)) => {
                let error = t_error(first, t);
                let off = first.t_error(t);
                let is_later = answer.roots[1..].iter().any(|root| root.t_error(t) < off);
                if !t.is_finite() || (is_later && error > ALLOWED) {
                    self.lost += 1;
                } else {
                    self.errors.push(error);
                }
            }
        }
    }

    fn routine(&self) -> Routine {
        let at = |share| quantile(&self.errors, share);
        Routine {
            median: at(0.5),
            p999: at(0.999),
            worst: at(1.0),
            lost: self.lost,
            wrong: self.wrong,
            hit_ns: None,
            miss_ns: None,
        }
    }
}
