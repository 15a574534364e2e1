//! The library's shapes against exact answers, on hard rays (`/oracle`).
//!
//! A hit is judged by its condition number: an error is measured in units of `u · cond`, and 100 of them are
//! allowed, as if the input had been wrong by 100 u. Whether there is a hit at all must be right unless a
//! relative change of the input by 1e-13 would change the answer. For instances, see
//! [`exact::backward_error`].

use std::fmt;

use exact::backward_error::{ALLOWED, FLAT_NORMAL, is_decided, normal_error, t_error};
pub use exact::backward_error::{ShapePair, instanced, pair};
use exact::{backward_error, composites};
use groundtruth::accel::Accel;
use oracle::Answer;
use oracle::hard::{Family, Kind, cases};

use super::U;
use crate::prelude::*;

/// The largest errors found, and their cases.
#[derive(Default)]
pub struct Worst {
    cases: usize,
    judged: usize,
    t: Error,
    normal: Error,
    failures: Vec<String>,
}

/// An error in units of the effect of a relative change by `u`, and its case.
#[derive(Default)]
struct Error {
    size: f64,
    case: String,
}

impl Error {
    fn meet(&mut self, size: f64, case: &str) {
        if size.is_nan() || size > self.size {
            let size = if size.is_nan() { f64::INFINITY } else { size };
            *self = Self { size, case: case.to_owned() };
        }
    }
}

impl fmt::Display for Worst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cases, judged, t, normal, failures } = self;
        write!(f, "{cases} rays, {judged} hits or misses judged; worst in u·cond: ")?;
        writeln!(f, "t {:.2} ({}), normal {:.2} ({})", t.size, t.case, normal.size, normal.case)?;
        failures.iter().take(12).try_for_each(|failure| writeln!(f, "  {failure}"))
    }
}

/// Judges `count` cases of each family; fails with the worst of them.
pub fn sweep(kind: Kind, seed: u64, count: usize) {
    sweep_as(kind, seed, count, |shape, ray, _| pair(shape).map(|pair| (pair, ray.clone())));
}

/// As [`sweep`], each case turned into another by `change`, which also gets its number; `None`
/// where the library refuses the shape.
pub fn sweep_as(
    kind: Kind,
    seed: u64,
    count: usize,
    change: impl Fn(&oracle::Shape, &oracle::Ray, usize) -> Option<(ShapePair, oracle::Ray)>,
) {
    let families = Family::ALL.into_iter().flat_map(|family| {
        let numbered = cases(kind, family, seed, count).into_iter().enumerate();
        numbered.map(move |(index, case)| (family, index, case))
    });
    let mut refused = 0;
    judge_cases(families.filter_map(|(family, index, (shape, ray))| {
        let name = format!("{kind:?} {family:?} seed {seed} index {index}");
        let changed = change(&shape, &ray, index);
        refused += usize::from(changed.is_none());
        changed.map(|(pair, ray)| Case::of(name, family, pair, &ray))
    }));
    assert!(refused <= count / 10, "{refused} shapes were refused");
}

/// A ray, a shape, and what is known of them.
struct Case {
    name: String,
    ours: Arc<dyn shapes::Shape>,
    ray: Ray,
    /// The span in which hits are requested.
    span: Span,
    exact: Answer,
    /// The condition number of an instance's matrix.
    condition: f64,
}

impl Case {
    fn of(
        name: String,
        family: Family,
        ShapePair { ours, exact }: ShapePair,
        exact_ray: &oracle::Ray,
    ) -> Self {
        let ray = backward_error::ray(exact_ray);
        let span = backward_error::span(family, &*ours, &ray);
        let condition = exact.condition();
        let exact = oracle::intersect_beyond(&exact, exact_ray, span.min);
        Self { name, ours, ray, span, exact, condition }
    }
}

/// The acceleration methods of a composite shape; `None` is its own choice.
const METHODS: [Option<Method>; 4] =
    [None, Some(Method::List), Some(Method::Grid), Some(Method::Bvh)];

/// Judges `count` cases of each family of a composite shape; each method gets `in_a_row` cases in turn.
pub fn sweep_many(kind: composites::Kind, seed: u64, count: usize, in_a_row: usize) {
    sweep_many_as(kind, seed, count, in_a_row, |case, _| Some(case));
}

/// As [`sweep_many`], each case turned into another by `change`, which also gets its number.
pub fn sweep_many_as(
    kind: composites::Kind,
    seed: u64,
    count: usize,
    in_a_row: usize,
    change: impl Fn(composites::Composite, usize) -> Option<composites::Composite>,
) {
    judge_families(count, |family, index| {
        let accel = METHODS[index / in_a_row % METHODS.len()];
        let case = change(kind.case(family, seed, index, accel)?, index)?;
        let (ours, ray) = (case.build()?, backward_error::ray(&case.ray));
        let span = backward_error::span(family, &*ours, &ray);
        Some(Case {
            name: format!("{kind:?} {family:?} seed {seed} index {index}"),
            exact: case.answer(span.min),
            condition: case.condition,
            ours,
            ray,
            span,
        })
    });
}

/// Judges `count` cases of each family; `None` is one that the library refuses.
fn judge_families(count: usize, case: impl Fn(Family, usize) -> Option<Case>) {
    let mut refused = 0;
    let all = Family::ALL.into_iter().flat_map(|family| (0..count).map(move |i| (family, i)));
    judge_cases(all.filter_map(|(family, index)| {
        let case = case(family, index);
        refused += usize::from(case.is_none());
        case
    }));
    assert!(refused <= count / 10, "{refused} shapes were refused");
}

/// Judges named shapes; see [`judge_cases`].
pub fn judge_all(cases: impl Iterator<Item = (String, ShapePair, oracle::Ray)>) {
    judge_cases(cases.map(|(name, pair, ray)| Case::of(name, Family::Ordinary, pair, &ray)));
}

/// Judges cases; fails with the worst of them, or if too few have an answer to judge.
fn judge_cases(cases: impl Iterator<Item = Case>) {
    let mut worst = Worst::default();
    for case in cases {
        worst.judge(&case);
    }
    println!("{worst}");
    assert!(worst.failures.is_empty(), "{} failures: {worst}", worst.failures.len());
    assert!(2 * worst.judged > worst.cases && worst.cases > 0, "too few to judge: {worst}");
}

impl Worst {
    fn judge(&mut self, Case { name, ours, ray, span, exact: answer, condition }: &Case) {
        self.cases += 1;
        let mut fail = |problem: String| self.failures.push(format!("{name}: {problem}"));
        for span in [Span::AHEAD, *span] {
            if let Err(problem) = is_consistent(&**ours, ray, span) {
                fail(problem);
            }
        }
        if !is_decided(answer, *condition) {
            return;
        }
        self.judged += 1;
        let found = ours.roots(ray, *span);
        if found.len() != answer.roots.len() {
            let exact: Vec<f64> = answer.roots.iter().map(|root| root.t).collect();
            let found: Vec<f64> = found.iter().map(|hit| hit.t).collect();
            fail(format!(
                "found {found:?} for {exact:?}, margin {:e}, κ {condition:e}",
                answer.margin
            ));
            return;
        }
        if through_accelerator(&**ours, ray, *span) != found.first().copied() {
            fail(format!("the test of the shape's own box loses the first of {found:?}"));
        }
        for (hit, root) in found.iter().zip(&answer.roots) {
            let t = t_error(root, hit.t);
            self.t.meet(t, name);
            if t.is_nan() || t > ALLOWED {
                fail(format!("t {:e}, exactly {:e}: {t:.1} u·cond", hit.t, root.t));
            }
            let normal = ours.surface(ray, hit).normal;
            let length = (Vector::from(normal).length() - 1.0).abs() / U;
            if length.is_nan() || length > FLAT_NORMAL {
                fail(format!("normal {normal:?} is not unit"));
            }
            let judged = normal_error(root, normal.to_array(), ray.direction, *condition);
            let Some((error, allowed)) = judged else { continue };
            self.normal.meet(error, name);
            if error.is_nan() || error > allowed {
                fail(format!("normal {normal:?}, exactly {:?}: {error:.1} u·cond", root.normal));
            }
        }
    }
}

/// Whether hit, shadow hit and roots agree, and the roots ascend within the span.
fn is_consistent(shape: &dyn shapes::Shape, ray: &Ray, span: Span) -> Result<(), String> {
    let (roots, nearest) = (shape.roots(ray, span), shape.hit(ray, span));
    if nearest != roots.first().copied() {
        return Err(format!("hit {nearest:?}, but roots {roots:?}"));
    }
    if shape.shadow_hit(ray, span).is_some() != nearest.is_some() {
        return Err("hit and shadow differ".to_owned());
    }
    let ascending = roots.windows(2).all(|pair| pair[0].t <= pair[1].t);
    if !ascending || !roots.iter().all(|hit| span.contains(hit.t)) {
        return Err(format!("no ascending distances in {span:?}: {roots:?}"));
    }
    Ok(())
}

/// The first hit of a scene with this shape alone.
fn through_accelerator(shape: &dyn shapes::Shape, ray: &Ray, span: Span) -> Option<Candidate> {
    let accel = Accel::build(Method::List, &[shape.bounds()]);
    accel.nearest(ray, span, |_, span| shape.hit(ray, span)).map(|(_, candidate)| candidate)
}
