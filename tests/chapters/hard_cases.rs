//! The library's shapes against exact answers, on rays that bite (`/tests/oracle`).
//!
//! A hit is judged against its condition: an error is counted in units of `u · cond`, and 100 of
//! them are allowed, as if the input had been wrong by so much. Whether there is a hit at all must
//! be right unless a relative change of the input by 1e-13 would change the answer. For instances, see
//! [`groundtruth::verify::against`].

use std::fmt;
use std::sync::Arc;

use groundtruth::accel::{Accel, Method, Primitives};
use groundtruth::math::{Aabb, Ray, Span, Vector};
use groundtruth::shapes::{self, Candidate};
use groundtruth::verify::against::{ALLOWED, FLAT_NORMAL, is_decided, normal_error, t_error};
pub use groundtruth::verify::against::{Pair, instanced, pair, steps};
use oracle::hard::{Family, Kind, cases};
use oracle::{Answer, Root};

use crate::support::U;

/// The largest errors met, and where.
#[derive(Default)]
pub struct Worst {
    cases: usize,
    judged: usize,
    t: Error,
    normal: Error,
    failures: Vec<String>,
}

/// An error in units of what a relative change by `u` may do, and the case that has it.
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
    change: impl Fn(&oracle::Shape, &oracle::Ray, usize) -> Option<(Pair, oracle::Ray)>,
) {
    let families = Family::ALL.into_iter().flat_map(|family| {
        let numbered = cases(kind, family, seed, count).into_iter().enumerate();
        numbered.map(move |(index, case)| (family, index, case))
    });
    let mut refused = 0;
    judge_all(families.filter_map(|(family, index, (shape, ray))| {
        let name = format!("{kind:?} {family:?} seed {seed} index {index}");
        let changed = change(&shape, &ray, index);
        refused += usize::from(changed.is_none());
        changed.map(|(pair, ray)| (name, pair, ray))
    }));
    assert!(refused <= count / 10, "{refused} shapes were refused");
}

/// A ray, a shape, and what is known of them.
pub struct Case {
    pub name: String,
    pub ours: Arc<dyn shapes::Shape>,
    pub ray: Ray,
    pub exact: Answer,
    /// Of an instance's matrix.
    pub condition: f64,
}

/// A root, and which of several shapes it is of.
pub type Of = (usize, Root);

/// The roots of several shapes that are one, ascending.
pub fn merged(answers: &[Answer]) -> Vec<Of> {
    let of_shape =
        |(i, answer): (usize, &Answer)| answer.roots.clone().into_iter().map(move |root| (i, root));
    let mut roots: Vec<Of> = answers.iter().enumerate().flat_map(of_shape).collect();
    roots.sort_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
    roots
}

/// The answer for several shapes that are one and have these roots. It is open, with a margin of 0,
/// where roots of two shapes are so close that rounding may change their order.
pub fn union(answers: &[Answer], roots: Vec<Of>) -> Answer {
    let doubt = |root: &Root| ALLOWED * U * root.squeeze * root.cond.max(root.t.abs());
    let is_open = |pair: &[Of]| {
        let [(i, a), (j, b)] = [&pair[0], &pair[1]];
        i != j && b.t - a.t <= doubt(a) + doubt(b)
    };
    let margin = answers.iter().map(|answer| answer.margin).fold(f64::INFINITY, f64::min);
    let margin = if roots.windows(2).any(is_open) { 0.0 } else { margin };
    Answer { roots: roots.into_iter().map(|(_, root)| root).collect(), margin }
}

/// One of many shapes that are one, and half-spaces around it.
pub struct Piece {
    pub exact: oracle::Shape,
    /// `n` and `d` of unit length of all with `n·p ≤ d`.
    pub within: Vec<(Vector, f64)>,
    /// The farthest of its points from the origin.
    pub reach: f64,
}

impl Piece {
    /// A shape in a box.
    pub fn boxed(exact: oracle::Shape, [min, max]: [[f64; 3]; 2]) -> Self {
        let axes = [Vector::X, Vector::Y, Vector::Z].into_iter().zip(min.into_iter().zip(max));
        let within = axes.flat_map(|(axis, (low, high))| [(-axis, -low), (axis, high)]).collect();
        let reach = [min, max].map(|corner| Vector::from(corner).length());
        Self { exact, within, reach: reach[0].max(reach[1]) }
    }

    /// The exact answer. A ray that passes the half-spaces by, and does so wherever a relative change
    /// by 1e-11 may move it and the piece, is not asked: it is farther from them than the rounding here.
    pub fn answer(&self, exact: &oracle::Ray) -> Answer {
        const MARGIN: f64 = 1e-11;
        let ray = groundtruth::verify::against::ray(exact);
        let more = 4.0 * MARGIN * (Vector::from(exact.origin).length() + self.reach);
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        for &(normal, d) in &self.within {
            let (room, speed) =
                (d + more - normal.dot(ray.origin.to_vector()), normal.dot(ray.direction));
            if speed > 0.0 {
                to = to.min(room / speed);
            } else if speed < 0.0 {
                from = from.max(room / speed);
            } else if room < 0.0 {
                to = -1.0;
            }
        }
        if from > to {
            return Answer { roots: Vec::new(), margin: MARGIN };
        }
        oracle::intersect(&self.exact, exact)
    }
}

/// Judges `count` cases of each family; `None` is one that the library refuses.
pub fn judge_families(count: usize, case: impl Fn(Family, usize) -> Option<Case>) {
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
pub fn judge_all(cases: impl Iterator<Item = (String, Pair, oracle::Ray)>) {
    judge_cases(cases.map(|(name, Pair { ours, exact }, ray)| Case {
        name,
        ours,
        condition: exact.condition(),
        exact: oracle::intersect(&exact, &ray),
        ray: groundtruth::verify::against::ray(&ray),
    }));
}

/// Judges cases; fails with the worst of them, or if too few have an answer to judge.
pub fn judge_cases(cases: impl Iterator<Item = Case>) {
    let mut worst = Worst::default();
    for case in cases {
        worst.judge(&case);
    }
    println!("{worst}");
    assert!(worst.failures.is_empty(), "{} failures: {worst}", worst.failures.len());
    assert!(2 * worst.judged > worst.cases && worst.cases > 0, "too few to judge: {worst}");
}

impl Worst {
    fn judge(&mut self, Case { name, ours, ray, exact: answer, condition }: &Case) {
        let found = ours.roots(ray, Span::AHEAD);
        self.cases += 1;
        let mut fail = |problem: String| self.failures.push(format!("{name}: {problem}"));

        let nearest = ours.hit(ray, Span::AHEAD);
        if nearest != found.first().copied() {
            fail(format!("hit {nearest:?}, but roots {found:?}"));
        }
        if ours.shadow_hit(ray, Span::AHEAD).is_some() != nearest.is_some() {
            fail("hit and shadow differ".to_owned());
        }
        let ascending = found.windows(2).all(|pair| pair[0].t <= pair[1].t);
        if !ascending || found.iter().any(|hit| !(hit.t.is_finite() && hit.t > 0.0)) {
            fail(format!("no ascending distances: {found:?}"));
        }
        if !is_decided(answer, *condition) {
            return;
        }
        self.judged += 1;
        if found.len() != answer.roots.len() {
            let exact: Vec<f64> = answer.roots.iter().map(|root| root.t).collect();
            let found: Vec<f64> = found.iter().map(|hit| hit.t).collect();
            fail(format!(
                "found {found:?} for {exact:?}, margin {:e}, κ {condition:e}",
                answer.margin
            ));
            return;
        }
        if through_accelerator(&**ours, ray) != nearest {
            fail(format!("the rule of the own box loses {nearest:?}"));
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

/// The first hit of a scene with this shape alone.
fn through_accelerator(shape: &dyn shapes::Shape, ray: &Ray) -> Option<Candidate> {
    struct Alone<'a>(&'a dyn shapes::Shape, &'a Ray);
    impl Primitives for Alone<'_> {
        fn hit(&self, _: u32, span: Span) -> Option<Candidate> {
            self.0.hit(self.1, span)
        }
        fn bounds(&self, _: u32) -> Aabb {
            self.0.bounds()
        }
    }
    let accel = Accel::build(Method::List, &[shape.bounds()]);
    accel.nearest(&Alone(shape, ray), ray, Span::AHEAD).map(|(_, candidate)| candidate)
}
