//! The contract of [`Shape`]: hits against exact arithmetic, on hard rays (`/oracle`).
//!
//! A hit is judged by its condition number: an error is measured in units of `u · cond`, and 100 of them are
//! allowed, as if the input had been wrong by 100 u. Whether there is a hit at all must be right unless a
//! relative change of the input by 1e-13 would change the answer. For instances, see
//! [`exact::backward_error`].

use std::sync::Arc;

use ask::Draw;
use exact::backward_error::{self, ALLOWED, FLAT_NORMAL, ShapePair, instanced, is_decided, pair};
use exact::backward_error::{normal_error, t_error};
use exact::composites;
use groundtruth::accel::{Accel, Method};
use groundtruth::math::{Ray, Span, Transform, UNIT_ROUNDOFF, Vector};
use groundtruth::shapes::{Kind, Shape};
use libtest_mimic::Trial;
use oracle::hard::{self, Family, cases};
use oracle::{Answer, Root};
use testkit::as_many;

use super::{Holds, ensure};

/// A law for each kind that the oracle has, and for rays and shapes that no kind's own cases contain: hit or miss, every distance
/// and every normal are right within their condition; those of a solid are those of its parts. Oracle: 512-bit arithmetic; of an
/// instance, with the matrix as the library has it.
pub fn trials() -> Vec<Trial> {
    const LAW: &str = "hits_are_exact_within_their_condition";
    let mut trials = Vec::new();
    for entry in Kind::ENTRIES {
        let is_this = |name: String| name.to_lowercase() == entry.module.replace('_', "");
        let name = format!("{}::{}::contract::{LAW}", entry.chapter, entry.module);
        if let Some(kind) = hard::Kind::ALL.into_iter().find(|kind| is_this(format!("{kind:?}"))) {
            trials.push(trial(name, move || {
                judge(hard_cases(kind, as_many(40, 10_000), |shape, ray, _| {
                    Some((pair(&shape)?, ray))
                }))
            }));
        } else if let Some(kind) =
            composites::Kind::ALL.into_iter().find(|kind| is_this(format!("{kind:?}")))
        {
            trials.push(trial(name, move || of_composite(kind)));
        }
    }
    let instances = |law: &str| format!("ch21::instance::contract::{law}");
    trials.push(trial(instances("steps_make_their_matrix"), steps_make_their_matrix));
    trials.push(trial(instances("hits_of_flat_and_open_shapes_are_exact"), of_others));
    trials.push(trial("ch23::mesh::contract::hits_in_instances_are_exact".to_owned(), of_meshes));
    trials
}

fn trial(name: String, law: impl Fn() -> Holds + Send + 'static) -> Trial {
    Trial::test(name, move || Ok(law()?))
}

/// A ray, a shape, and what is known of them.
struct Case {
    name: String,
    ours: Arc<dyn Shape>,
    ray: Ray,
    /// The span in which hits are requested.
    span: Span,
    exact: Answer,
    /// The condition number of an instance's matrix.
    condition: f64,
}

impl Case {
    fn of(name: String, family: Family, pair: ShapePair, exact_ray: &oracle::Ray) -> Self {
        let ShapePair { ours, exact } = pair;
        let ray = backward_error::ray(exact_ray);
        let span = backward_error::span(family, &*ours, &ray);
        let condition = exact.condition();
        let exact = oracle::intersect_beyond(&exact, exact_ray, span.min);
        Self { name, ours, ray, span, exact, condition }
    }

    fn of_composite(name: String, family: Family, case: &composites::Composite) -> Option<Self> {
        let (ours, ray) = (case.build()?, backward_error::ray(&case.ray));
        let span = backward_error::span(family, &*ours, &ray);
        let (exact, condition) = (case.answer(span.min), case.condition);
        Some(Self { name, ours, ray, span, exact, condition })
    }

    /// Whether rounding cannot change the answer; the first thing wrong with it.
    fn judge(&self) -> Result<bool, String> {
        let Self { ours, ray, span, exact, condition, .. } = self;
        for span in [Span::AHEAD, *span] {
            is_consistent(&**ours, ray, span)?;
        }
        if !is_decided(exact, *condition) {
            return Ok(false);
        }
        let found = ours.roots(ray, *span);
        let ts: Vec<f64> = found.iter().map(|hit| hit.t).collect();
        let expected: Vec<f64> = exact.roots.iter().map(|root| root.t).collect();
        ensure!(ts.len() == expected.len(), "{ts:?} for {expected:?}, margin {:e}", exact.margin);
        let accel = Accel::build(Method::List, &[ours.bounds()]);
        let first =
            accel.nearest(ray, *span, &mut (), |_, span| ours.hit(ray, span)).map(|(_, at)| at);
        ensure!(first == found.first().copied(), "the shape's own box loses the first of {ts:?}");
        for (hit, root) in found.iter().zip(&exact.roots) {
            let error = t_error(root, hit.t);
            ensure!(error <= ALLOWED, "t {:e}, exactly {:e}: {error:.1} u·cond", hit.t, root.t);
            self.judge_normal(ours.surface(ray, hit).normal.into(), root)?;
        }
        Ok(true)
    }

    fn judge_normal(&self, normal: Vector, root: &Root) -> Holds {
        let length = (normal.length() - 1.0).abs() / UNIT_ROUNDOFF;
        ensure!(length <= FLAT_NORMAL, "normal {normal:?} is not unit");
        let judged = normal_error(root, normal.to_array(), self.ray.direction, self.condition);
        let Some((error, allowed)) = judged else { return Ok(()) };
        ensure!(
            error <= allowed,
            "normal {normal:?}, exactly {:?}: {error:.1} u·cond",
            root.normal
        );
        Ok(())
    }
}

/// Whether hit, shadow hit and roots agree, and the roots ascend within the span.
fn is_consistent(shape: &dyn Shape, ray: &Ray, span: Span) -> Holds {
    let (roots, nearest) = (shape.roots(ray, span), shape.hit(ray, span));
    ensure!(nearest == roots.first().copied(), "hit {nearest:?}, but roots {roots:?}");
    ensure!(shape.shadow_hit(ray, span).is_some() == nearest.is_some(), "hit and shadow differ");
    let ascending = roots.is_sorted_by(|a, b| a.t <= b.t);
    ensure!(ascending && roots.iter().all(|hit| span.contains(hit.t)), "{roots:?} in {span:?}");
    Ok(())
}

/// Judges cases; `None` is one whose shape the library refuses. Fails if too few have an answer to judge.
fn judge(cases: impl Iterator<Item = Option<Case>>) -> Holds {
    let (mut all, mut refused, mut judged) = (0, 0, 0);
    for case in cases {
        all += 1;
        let Some(case) = case else {
            refused += 1;
            continue;
        };
        let decided = case.judge().map_err(|wrong| format!("{}: {wrong}", case.name))?;
        judged += usize::from(decided);
    }
    ensure!(refused <= all / 60, "{refused} of {all} shapes are refused");
    ensure!(2 * judged > all, "{judged} of {all} rays have an answer");
    Ok(())
}

/// The cases of a kind, each turned into another by `change`, which also gets its number.
fn hard_cases(
    kind: hard::Kind,
    count: usize,
    change: impl Fn(oracle::Shape, oracle::Ray, usize) -> Option<(ShapePair, oracle::Ray)>,
) -> impl Iterator<Item = Option<Case>> {
    let numbered = Family::ALL.into_iter().flat_map(move |family| {
        let cases = cases(kind, family, 19, count).into_iter().enumerate();
        cases.map(move |(index, case)| (family, index, case))
    });
    numbered.map(move |(family, index, (shape, ray))| {
        let (pair, ray) = change(shape, ray, index)?;
        Some(Case::of(format!("{kind:?} {family:?} {index}"), family, pair, &ray))
    })
}

/// The matrices of the hard instances: scales from 10⁻⁴ to 10⁴, sheared and mirrored.
fn matrices() -> Vec<[[f64; 4]; 3]> {
    let all = [Family::Ordinary, Family::Scaled].map(|f| cases(hard::Kind::Instance, f, 2100, 50));
    let matrix = |(shape, _)| match shape {
        oracle::Shape::Instance { matrix, .. } => Some(matrix),
        _ => None,
    };
    all.into_iter().flatten().filter_map(matrix).collect()
}

/// Law: the steps that are computed from a matrix compose to that matrix. Oracle: the matrix.
fn steps_make_their_matrix() -> Holds {
    for matrix in matrices() {
        let steps = exact::steps(&matrix).ok_or("singular")?;
        let made = Transform::from_steps(&steps).map_err(|singular| singular.to_string())?.rows();
        let pairs = matrix.as_flattened().iter().zip(made.as_flattened());
        let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let largest = matrix.as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        // columns may be nearly equal
        ensure!(off <= 1e-14 * oracle::condition(&matrix) * largest, "{matrix:?}: {made:?}");
    }
    Ok(())
}

/// Law and oracle as of other kinds, for instances of kinds that the generator does not nest.
fn of_others() -> Holds {
    use hard::Kind::{OpenCylinder, Plane, Rectangle, Triangle};
    let matrices = matrices();
    for kind in [OpenCylinder, Triangle, Rectangle, Plane] {
        judge(hard_cases(kind, as_many(40, 10_000), |shape, ray, i| {
            instanced(&shape, &ray, matrices[i % matrices.len()])
        }))?;
    }
    Ok(())
}

/// The cases of a composite shape, each searched by one of the methods or by its own choice.
fn composites(
    kind: composites::Kind,
    change: impl Fn(composites::Composite, usize) -> Option<composites::Composite>,
) -> impl Iterator<Item = Option<Case>> {
    const METHODS: [Option<Method>; 4] =
        [None, Some(Method::List), Some(Method::Grid), Some(Method::Bvh)];
    let count = as_many(100, 10_000);
    let all = Family::ALL.into_iter().flat_map(move |family| (0..count).map(move |i| (family, i)));
    all.map(move |(family, index)| {
        let accel = Draw::case(22, index).pick(&METHODS);
        let case = change(kind.case(family, 22, index, accel)?, index)?;
        Case::of_composite(format!("{kind:?} {family:?} {index}"), family, &case)
    })
}

/// Law: a composite shape has every hit of its pieces, in their order, with their normals, whichever method
/// searches them. Oracle: the pieces in 512-bit arithmetic, one by one.
fn of_composite(kind: composites::Kind) -> Holds {
    judge(composites(kind, |case, _| Some(case)))
}

/// Law and oracle as above, for instances of meshes.
fn of_meshes() -> Holds {
    let matrices = matrices();
    judge(composites(composites::Kind::Mesh, |case, index| {
        case.instanced(&matrices[index % matrices.len()])
    }))
}
