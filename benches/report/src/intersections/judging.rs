//! Compares each intersection routine with the exact answer.

use std::fmt::Debug;
use std::sync::Arc;

use oracle::Answer;
use oracle::hard::{self, Family};

use super::{FamilyData, Routine};
use exact::backward_error::{
    ALLOWED, ShapePair, by_the_book, is_decided, pair, ray, span, t_error,
};
use exact::composites;
use groundtruth::math::{Ray, Span};
use groundtruth::shapes::Shape;
use groundtruth::shapes::textbook::EPSILON;
use statistics::quantile;

/// The kind of shape that is judged: a single shape or a composite.
pub struct TestedShape {
    /// The name of the enum variant.
    pub name: String,
    /// The number of rays that are timed together: their shapes fit into the processor's caches.
    timed: usize,
    questions: Box<dyn Fn(Family, u64, usize) -> Questions + Sync>,
}

/// The questions of a family, from a seed and a count; `None` for shapes that the library rejects.
type Questions = Box<dyn Iterator<Item = Option<Question>>>;

/// A case for both routines, and its exact answer.
struct Question {
    case: JudgedRay,
    exact: Answer,
    /// The condition number of an instance's matrix.
    condition: f64,
}

/// A ray, and the shape for both routines.
#[derive(Debug)]
pub struct JudgedRay {
    pub ray: Ray,
    /// The span of valid hits.
    pub span: Span,
    pub ours: Arc<dyn Shape>,
    pub textbook: Arc<dyn Shape>,
}

impl JudgedRay {
    /// The hit of the book's routine, beyond its epsilon.
    pub fn textbook_hit(&self) -> Option<f64> {
        let beyond = Span { min: EPSILON, ..Span::AHEAD };
        self.textbook.hit(&self.ray, beyond).map(|at| at.t)
    }
}

/// The results of one kind and family, and the rays for timing.
pub struct Judged {
    pub data: FamilyData,
    pub hits: Vec<JudgedRay>,
    pub misses: Vec<JudgedRay>,
}

impl TestedShape {
    pub fn all() -> impl Iterator<Item = Self> {
        let one = hard::Kind::ALL.into_iter().map(Self::one);
        one.chain(composites::Kind::ALL.into_iter().map(Self::composite))
    }

    fn one(kind: hard::Kind) -> Self {
        let questions = move |family, seed, count| -> Questions {
            let cases = hard::cases(kind, family, seed, count).into_iter();
            Box::new(cases.map(move |(shape, ray)| Question::of_one(family, &shape, &ray)))
        };
        Self { name: format!("{kind:?}"), timed: 256, questions: Box::new(questions) }
    }

    fn composite(kind: composites::Kind) -> Self {
        use composites::Kind::{Compound, Lattice, Mesh};
        let questions = move |family, seed, count| -> Questions {
            Box::new((0..count).map(move |i| Question::of_composite(kind, family, seed, i)))
        };
        let timed = if matches!(kind, Compound | Lattice | Mesh) { 64 } else { 16 };
        Self { name: format!("{kind:?}"), timed, questions: Box::new(questions) }
    }
}

impl Question {
    fn of_one(family: Family, shape: &oracle::Shape, exact_ray: &oracle::Ray) -> Option<Self> {
        let textbook = by_the_book(&exact::our_shape(shape)?)?;
        let ShapePair { ours, exact } = pair(shape)?;
        let ray = ray(exact_ray);
        let span = span(family, &*ours, &ray);
        Some(Self {
            condition: exact.condition(),
            exact: oracle::intersect_beyond(&exact, exact_ray, span.min),
            case: JudgedRay { ray, span, ours, textbook },
        })
    }

    fn of_composite(
        kind: composites::Kind,
        family: Family,
        seed: u64,
        index: usize,
    ) -> Option<Self> {
        let case = kind.case(family, seed, index, None)?;
        let (ours, ray) = (case.build()?, ray(&case.ray));
        let span = span(family, &*ours, &ray);
        let textbook = by_the_book(&case.ours)?;
        Some(Self {
            condition: case.condition,
            exact: case.answer(span.min),
            case: JudgedRay { ray, span, ours, textbook },
        })
    }
}

impl Judged {
    /// Judges the cases whose answer does not depend on rounding.
    pub fn new(subject: &TestedShape, family: Family, seed: u64, count: usize) -> Self {
        let (mut ours, mut book) = (Tally::default(), Tally::default());
        let (mut hits, mut misses) = (Vec::new(), Vec::new());
        let mut data = FamilyData { family: format!("{family:?}"), ..FamilyData::default() };
        for question in (subject.questions)(family, seed, count) {
            let Some(Question { case, exact, condition }) = question else {
                data.refused += 1;
                continue;
            };
            if !is_decided(&exact, condition) {
                continue;
            }
            data.judged += 1;
            let found = case.ours.hit(&case.ray, case.span).map(|found| found.t);
            ours.add(found, case.span, &exact);
            book.add(case.textbook_hit(), case.span, &exact);
            data.hits += usize::from(!exact.roots.is_empty());
            let timed = if exact.roots.is_empty() { &mut misses } else { &mut hits };
            if timed.len() < subject.timed {
                timed.push(case);
            }
        }
        (data.ours, data.textbook) = (ours.routine(), book.routine());
        Self { data, hits, misses }
    }
}

/// The errors and failures of one routine.
#[derive(Default)]
struct Tally {
    errors: Vec<f64>,
    failures: Routine,
}

impl Tally {
    /// Adds the distance that was found for one case.
    fn add(&mut self, found: Option<f64>, span: Span, answer: &Answer) {
        match (found, answer.roots.first()) {
            (None, None) => {}
            // the surface on which the ray starts
            (Some(t), _) if t <= span.min => self.failures.wrong += 1,
            (Some(_), None) => self.failures.wrong += 1,
            (None, Some(_)) => self.failures.lost += 1,
            (Some(t), Some(first)) => {
                let error = t_error(first, t);
                let off = first.t_error(t);
                let is_later = answer.roots[1..].iter().any(|root| root.t_error(t) < off);
                if !t.is_finite() || (is_later && error > ALLOWED) {
                    self.failures.lost += 1;
                } else {
                    self.errors.push(error);
                }
            }
        }
    }

    fn routine(self) -> Routine {
        let [median, p999, worst] = [0.5, 0.999, 1.0].map(|share| quantile(&self.errors, share));
        Routine { median, p999, worst, ..self.failures }
    }
}
