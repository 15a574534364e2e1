//! The mistakes that give exactly a wrong hit.

use serde_json::{Value, json};

use super::super::mistakes::{self as m, Mistake, clues, same};
use super::super::probe::ours;
use super::formulas;
use super::local::Local;
use super::question::IntersectQuestion;
use groundtruth::math::{Normal, Transform, Vector};
use oracle::{Root, Shape, Solid};

type Clues = Vec<&'static Mistake>;

/// What explains hits where there are none, none where there are some, and another number of hits.
pub fn of_count(question: &IntersectQuestion, theirs: &[&Value], right: &[Root]) -> Clues {
    let theirs: Vec<f64> = theirs.iter().filter_map(|hit| hit["t"].as_f64()).collect();
    let line = roots_of_line(question);
    let mut found = if theirs.is_empty() { vec![&m::MISSED] } else { Vec::new() };
    if let ([t], []) = (&theirs[..], right) {
        found.extend(behind(*t, &line));
        if Local::of(question)
            .is_some_and(|local| formulas::is_torus_coefficient(&local, question.span, *t))
        {
            found.push(&m::TORUS_COEFFICIENT);
        }
    }
    if let ([], [root]) = (&theirs[..], right)
        && dot(root.normal, question.ray.direction) > 0.0
    {
        found.push(if has_inside(&question.shape) { &m::INSIDE_MISSED } else { &m::ONE_SIDED });
    }
    if question.all && theirs.len() == 1 && right.iter().any(|root| same(&theirs, &[root.t])) {
        found.push(&m::NEAREST_ONLY);
    }
    if ignores_span(question, &theirs, &line) {
        found.push(&m::SPAN_IGNORED);
    }
    if let Some(t) = without_square_of_direction(question)
        && !question.all
        && (t.is_none() && theirs.is_empty() || t.is_some_and(|t| same(&theirs, &[t])))
    {
        found.push(&m::UNIT_ASSUMED);
    }
    if Local::of(question).is_some_and(|local| {
        formulas::is_count_of_cancellation(&local, question.span, &theirs, right.len())
    }) {
        found.push(&m::CANCELLATION);
    }
    found
}

/// Where a distance starts that is never set: at 0, or at what programs take for the farthest.
const NOT_SET: [f64; 12] =
    [0.0, 1e6, 1e7, 1e8, 1e9, 1e10, 1e20, 1e30, 1e38, 1e300, f64::MAX, f64::INFINITY];

/// What explains the distance of a hit.
pub fn of_t(question: &IntersectQuestion, t: f64, root: &Root) -> Clues {
    let mut found = clues(&[t], &[root.t]);
    let line = roots_of_line(question);
    let is = |other: f64| same(&[t], &[other]) && !same(&[root.t], &[other]);
    let length = Vector::from(question.ray.direction).length();
    let local = Local::of(question);
    // an instance's ray has another length inside
    let inside = local.as_ref().map_or(length, |local| local.ray.direction.length());
    let is_unit_assumed =
        [length, inside, inside / length].map(|by| is(root.t * by)).contains(&true);
    if is_unit_assumed || without_square_of_direction(question).flatten().is_some_and(is) {
        found.push(&m::UNIT_ASSUMED);
    }
    if local.is_some_and(|local| formulas::is_cancellation(&local, t, root)) {
        found.push(&m::CANCELLATION);
    }
    if Local::of(question)
        .is_some_and(|local| formulas::is_torus_coefficient(&local, question.span, t))
    {
        found.push(&m::TORUS_COEFFICIENT);
    }
    if NOT_SET.contains(&t.abs()) {
        found.push(&m::T_NOT_SET);
    }
    if line.iter().any(|other| *other > root.t && is(*other)) {
        found.push(&m::FAR_ROOT);
    }
    if !question.all && ignores_span(question, &[t], &line) {
        found.push(&m::SPAN_IGNORED);
    }
    found.extend(behind(t, &line));
    found
}

/// What explains a normal.
pub fn of_normal(question: &IntersectQuestion, normal: [f64; 3], root: &Root) -> Clues {
    let right = root.normal;
    let mut found = clues(&normal, &right);
    if is_turned(question, normal, root) {
        let by_the_book = is_turned_by_the_book(&question.shape);
        found.push(if by_the_book { &m::TO_VIEWER_BY_THE_BOOK } else { &m::TO_VIEWER });
    }
    let oracle::Ray { origin, direction } = question.ray;
    let point = std::array::from_fn(|i| origin[i] + root.t * direction[i]);
    if let Shape::Sphere { .. } = question.shape
        && let [Some(theirs), Some(from_origin)] = [unit(normal), unit(point)]
        && same(&theirs, &from_origin)
        && !same(&right, &from_origin)
    {
        found.push(&m::CENTER_FORGOTTEN);
    }
    if let Some(local) = Local::of(question) {
        found.extend(by_transform(&local, normal, root));
        match formulas::cone_normal(&local, root, Vector::from(normal)) {
            Some(true) => found.push(&m::CONE_NORMAL_SQUARE),
            Some(false) => found.push(&m::CONE_NORMAL_EQUAL),
            None => {}
        }
    }
    found
}

/// Whether a normal is the right one turned to the viewer.
pub fn is_turned(question: &IntersectQuestion, normal: [f64; 3], root: &Root) -> bool {
    let right = root.normal;
    same(&normal, &right.map(|x| -x)) && dot(right, question.ray.direction) > 0.0
}

/// Whether the book turns normals of this shape to the viewer: open and part cylinders, and the ring that is made of
/// them (Suffern, ch. 19, and its sample code).
pub fn is_turned_by_the_book(shape: &Shape) -> bool {
    match shape {
        Shape::OpenCylinder { .. } | Shape::PartCylinder { .. } => true,
        Shape::Solid(solid) => matches!(solid, Solid::ThickRing { .. }),
        Shape::Instance { of, .. } => is_turned_by_the_book(of),
        _ => false,
    }
}

/// What explains an occluder where none is between the ends.
pub fn of_occlusion(question: &IntersectQuestion) -> Clues {
    let is_beyond = roots_of_line(question).iter().any(|t| *t > 1.0);
    if is_beyond { vec![&m::SHADOW_RAYS_WITHOUT_END] } else { Vec::new() }
}

/// Whether the shape is closed, or curved with a concave side: not a flat sheet.
fn has_inside(shape: &Shape) -> bool {
    match shape {
        Shape::Plane { .. }
        | Shape::Triangle { .. }
        | Shape::Rectangle { .. }
        | Shape::Disk { .. }
        | Shape::Annulus { .. }
        | Shape::PartAnnulus { .. }
        | Shape::CutFace { .. } => false,
        Shape::Instance { of, .. } => has_inside(of),
        _ => true,
    }
}

/// Whether `t` is that of a hit behind the origin.
fn behind(t: f64, line: &[f64]) -> Option<&'static Mistake> {
    line.iter().any(|other| *other < 0.0 && same(&[t], &[*other])).then_some(&m::BEHIND)
}

/// Whether theirs are the hits ahead, of a question that asks for others. A root that is 0 up to rounding, where the
/// ray starts on the surface, is one of them or not.
fn ignores_span(question: &IntersectQuestion, theirs: &[f64], line: &[f64]) -> bool {
    let [min, max] = question.span;
    let is_asked = |t: &f64| min < *t && *t < max;
    let size = if min.is_finite() { min } else { 0.0 };
    let is_there =
        |t: &f64| line.iter().any(|other| (t - other).abs() <= 1e-5 * other.abs().max(size));
    let ahead = line.iter().filter(|t| **t > 0.0).count();
    let all = if question.all { theirs.len() == ahead } else { theirs.len() == 1 };
    let is_ahead = |t: &f64| *t >= 0.0 && is_there(t);
    all && theirs.iter().all(is_ahead)
        && (theirs.iter().any(|t| !is_asked(t)) || min < 0.0 && line.len() > ahead)
}

/// Their `t` where a sphere's equation is `t² + 2 b t + c = 0`, without `d·d`: `None` for other shapes, and no hit
/// where it has no root in the span. The ray is that in the sphere's coordinates, if it is in an instance.
///
/// Source: Suffern, ch. 3, with `b = (o − c)·d` and `c = |o − c|² − r²`.
fn without_square_of_direction(question: &IntersectQuestion) -> Option<Option<f64>> {
    let local = Local::of(question)?;
    let Shape::Sphere { center, radius } = *local.shape else { return None };
    let d = local.ray.direction;
    let from_center = local.ray.origin.to_vector() - Vector::from(center);
    let (b, c) = (from_center.dot(d), from_center.length_squared() - radius * radius);
    let root = (b * b - c).sqrt(); // NaN without a root, which no span contains
    let [min, max] = question.span;
    Some([-b - root, -b + root].into_iter().find(|t| min < *t && *t < max))
}

/// All `t` of the whole line.
fn roots_of_line(question: &IntersectQuestion) -> Vec<f64> {
    let line = json!({"intersect": {
        "shape": question.kind,
        "ray": {"origin": question.ray.origin, "direction": question.ray.direction},
        "span": ["-inf", "inf"],
        "all": true,
    }});
    let hits = ours(&line).ok();
    let hits = hits.as_ref().and_then(Value::as_array).into_iter().flatten();
    hits.filter_map(|hit| hit["t"].as_f64()).collect()
}

/// The product of numbers that may be points or normals.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    Vector::from(a).dot(Vector::from(b))
}

fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    Vector::from(v).unit().map(|n| n.to_array())
}

/// A mistake, and what it makes of a normal.
type Way = (&'static Mistake, fn(&Transform, Vector) -> Vector);

/// How a normal of an instance can be transformed wrongly.
fn by_transform(local: &Local<'_>, normal: [f64; 3], root: &Root) -> Clues {
    if local.transforms.is_empty() {
        return Vec::new();
    }
    let Some(inner) = local.normal(root) else { return Vec::new() };
    let ways: [Way; 4] = [
        (&m::NORMAL_BY_INVERSE, |transform, n| transform.inverse().vector(n)),
        (&m::NORMAL_BY_MATRIX, Transform::vector),
        (&m::NORMAL_UNTRANSFORMED, |_, n| n),
        (&m::NORMAL_BY_TRANSPOSE, |transform, n| {
            Normal::new(n).map_or(n, |n| transform.inverse().covector(n))
        }),
    ];
    let is = |by: fn(&Transform, Vector) -> Vector| {
        let other = local.out(inner, by).map(Vector::to_array);
        other.is_some_and(|other| same(&normal, &other) && !same(&root.normal, &other))
    };
    ways.into_iter().filter(|(_, by)| is(*by)).map(|(mistake, _)| mistake).collect()
}
