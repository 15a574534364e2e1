//! The judge of hits: how many there are, then each one's distance, normal, side and point.

use ask::{nan_in, number, triple};
use serde_json::Value;

use super::super::judgement::{Judgement, Profile, Wrong, first_wrong};
use super::super::mistakes::{self, Mistake, clues};
use super::super::values::Rules;
use super::names;
use super::other_shapes::of_other_shapes;
use super::question::IntersectQuestion;
use exact::backward_error;
use groundtruth::math::{UNIT_ROUNDOFF, Vector};
use oracle::{Root, Shape};

/// Whether something is in the way.
pub fn judge_occluded(asked: &Value, answer: &Value, profile: Profile, _: &Rules) -> Judgement {
    let Some(question) = IntersectQuestion::of(asked) else { return Judgement::Undecided };
    let Some(exact) = question.answer() else { return Judgement::Undecided };
    if !question.is_decided(&exact, profile) {
        return Judgement::Undecided;
    }
    let right = !exact.roots.is_empty();
    match answer.as_bool() {
        Some(theirs) if theirs == right => Judgement::Right(0.0),
        Some(false) => {
            let judgement = Judgement::wrong("missed", f64::INFINITY, "true");
            judgement.with([&mistakes::MISSED]).beside(of_other_shapes(asked, answer))
        }
        Some(true) => {
            let judgement = Judgement::wrong("no hit is there", f64::INFINITY, "false");
            judgement.with(names::of_occlusion(&question)).with(of_other_shapes(asked, answer))
        }
        None => Judgement::wrong("no truth value", f64::INFINITY, right.to_string()),
    }
}

/// Judges hits.
pub fn judge(asked: &Value, answer: &Value, profile: Profile, _: &Rules) -> Judgement {
    let judged = hits(asked, answer, profile);
    let others = || of_other_shapes(asked, answer);
    match answer.is_null() || answer.as_array().is_some_and(Vec::is_empty) {
        _ if !judged.is_wrong() => judged,
        true => judged.beside(others()),
        false => judged.with(others()),
    }
}

fn hits(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    let Some(parsed) = IntersectQuestion::of(question) else { return Judgement::Undecided };
    let Some(exact) = parsed.answer() else { return Judgement::Undecided };
    if !parsed.is_decided(&exact, profile) {
        return Judgement::Undecided;
    }
    let theirs: Vec<&Value> = match answer {
        Value::Null => Vec::new(),
        Value::Array(hits) if parsed.all => hits.iter().collect(),
        hit @ Value::Object(_) if !parsed.all => vec![hit],
        _ => {
            let expected = if parsed.all { "a list of hits" } else { "a hit, or null" };
            return Judgement::wrong("other JSON", f64::INFINITY, expected);
        }
    };
    let right =
        if parsed.all { &exact.roots[..] } else { &exact.roots[..exact.roots.len().min(1)] };
    if theirs.len() != right.len() {
        return miscounted(&parsed, &theirs, right);
    }
    let judged = theirs.iter().zip(right).map(|(hit, root)| judge_hit(&parsed, hit, root, profile));
    first_wrong(judged)
}

/// Too many hits, or too few.
fn miscounted(question: &IntersectQuestion, theirs: &[&Value], right: &[Root]) -> Judgement {
    let listed = |root: &Root| format!("t = {:?}, normal {:?}", root.t, root.normal);
    let expected = match right {
        [] => "null".to_owned(),
        _ => right.iter().map(listed).collect::<Vec<_>>().join("; "),
    };
    let symptom = match (theirs.len(), right.len()) {
        (0, _) => "missed",
        (_, 0) => "no hit is there",
        (a, b) if a < b => "too few hits",
        _ => "too many hits",
    };
    let found = names::of_count(question, theirs, right);
    Judgement::wrong(symptom, f64::INFINITY, expected).with(found)
}

fn judge_hit(
    question: &IntersectQuestion,
    hit: &Value,
    root: &Root,
    profile: Profile,
) -> Judgement {
    let t = match hit.get("t").map(number) {
        Some(Some(t)) if !t.is_nan() => t,
        given => {
            let symptom = if given.is_some() { "t is not a number" } else { "t is missing" };
            return Judgement::wrong(symptom, f64::INFINITY, format!("t = {:?}", root.t));
        }
    };
    let t_error = backward_error::t_error(root, t);
    if t_error.is_nan() || t_error > profile.allowed() {
        let found = names::of_t(question, t, root);
        let expected = format!("t = {:?}", root.t);
        return wrong(("t", t_error), expected, found, (&[t], &[root.t]));
    }
    let normal = judge_normal(question, hit, root, profile);
    let point = judge_point(question, hit, root, profile);
    first_wrong([Judgement::Right(t_error), normal, judge_front(question, hit, root), point])
}

/// A normal, point or the like that is there, but not three numbers.
fn not_three(name: &str, given: &Value, expected: String) -> Judgement {
    let symptom = match nan_in(given) {
        true => format!("{name} is not a number"),
        false => format!("{name} is missing"),
    };
    Judgement::wrong(&symptom, f64::INFINITY, expected)
}

/// Wrong numbers: what differs, by how much, and their numbers with the right ones.
fn wrong(
    (symptom, error): (&str, f64),
    expected: String,
    clues: Vec<&'static Mistake>,
    (theirs, right): (&[f64], &[f64]),
) -> Judgement {
    let ratio = mistakes::ratio(theirs, right);
    let symptom = symptom.to_owned();
    Judgement::Wrong(Box::new(Wrong {
        beside: Vec::new(),
        symptom,
        error,
        expected,
        clues,
        ratio,
        theirs: theirs.to_vec(),
    }))
}

/// Three numbers, none of them NaN.
fn three(value: &Value) -> Option<[f64; 3]> {
    triple(value).filter(|three| three.iter().all(|x| !x.is_nan()))
}

fn judge_normal(
    question: &IntersectQuestion,
    hit: &Value,
    root: &Root,
    profile: Profile,
) -> Judgement {
    let right = root.normal;
    let expected = format!("normal {right:?}");
    if hit.get("normal").is_none() {
        return Judgement::Lacks("normal".to_owned());
    }
    let Some(normal) = three(&hit["normal"]) else {
        return not_three("normal", &hit["normal"], expected);
    };
    let length = Vector::from(normal).length();
    let is_unit = |allowed: f64| (length - 1.0).abs() <= allowed.max(4.0) * UNIT_ROUNDOFF;
    let off = (length - 1.0).abs() / UNIT_ROUNDOFF;
    let not_unit = |expected: String| {
        let clues = vec![&mistakes::NOT_NORMALISED_LENGTH];
        wrong(("normal is not unit", off), expected, clues, (&normal, &right))
    };
    let Some((error, allowed)) = normal_error(question, root, normal, profile) else {
        // at an edge, either face's normal is right
        return match is_unit(Profile::Book.allowed()) {
            true => Judgement::Right(0.0),
            false => not_unit("a unit normal".to_owned()),
        };
    };
    if error <= allowed {
        return if is_unit(allowed) { Judgement::Right(error) } else { not_unit(expected) };
    }
    let is_turned =
        names::is_turned_by_the_book(&question.shape) && names::is_turned(question, normal, root);
    let turned_back =
        is_turned.then(|| normal_error(question, root, normal.map(|x| -x), profile)).flatten();
    if profile == Profile::Book && turned_back.is_some_and(|(error, allowed)| error <= allowed) {
        return Judgement::ByTheBook(&mistakes::TO_VIEWER_BY_THE_BOOK);
    }
    let expected = match is_turned {
        true => expected + "; the book turns it to the viewer, too",
        false => expected,
    };
    let clues = names::of_normal(question, normal, root);
    wrong(("normal", error), expected, clues, (&normal, &right))
}

/// The error of a normal in u·cond, and the error allowed; `None` at an edge.
fn normal_error(
    question: &IntersectQuestion,
    root: &Root,
    normal: [f64; 3],
    profile: Profile,
) -> Option<(f64, f64)> {
    let condition = question.shape.condition();
    let direction = Vector::from(question.ray.direction);
    let (error, allowed) = backward_error::normal_error(root, normal, direction, condition)?;
    if root.face_margin <= profile.margin() * condition {
        return None;
    }
    Some(match condition_of_edges(&question.shape) {
        Some(cond) => (error / cond, profile.allowed()),
        None if profile == Profile::Book => (error, profile.allowed()),
        None => (error, allowed),
    })
}

/// How much the normal `a × b / |a × b|` of a shape given by the edges `a` and `b` from the corner `v` depends on
/// rounding; `None` for shapes whose normal is given or curved.
///
/// Moving the corners by a relative ε moves `a` by at most `ε (2|v| + |a|)`, because its other end is `v + a`, and
/// `b` alike. A change of `a` and `b` turns the unit normal by at most `(|Δa| |b| + |a| |Δb|) / |a × b|`, which is
/// `2ε (|a| |b| + |v| (|a| + |b|)) / |a × b|`. The rounding of the differences and products of a plain cross product
/// is `O(u |a| |b| / |a × b|)`, too.
fn condition_of_edges(shape: &Shape) -> Option<f64> {
    let (v, a, b) = match shape {
        Shape::Triangle { vertices } => {
            let [v0, v1, v2] = vertices.map(Vector::from);
            (v0, v1 - v0, v2 - v0)
        }
        Shape::Rectangle { corner, a, b } => {
            (Vector::from(*corner), Vector::from(*a), Vector::from(*b))
        }
        Shape::Instance { of, .. } => return condition_of_edges(of),
        _ => return None,
    };
    let (v, cross, a, b) = (v.length(), a.cross(b).length(), a.length(), b.length());
    Some(2.0 * (a * b + v * (a + b)) / cross)
}

fn judge_front(question: &IntersectQuestion, hit: &Value, root: &Root) -> Judgement {
    let Some(front) = hit.get("front") else { return Judgement::Right(0.0) };
    let faces = |normal: [f64; 3]| names::dot(normal, question.ray.direction) < 0.0;
    let right = faces(root.normal);
    // at an edge their normal may be that of the other face; turned to the viewer, it always faces the ray
    let theirs = triple(&hit["normal"]).map_or(right, faces);
    match front.as_bool() {
        Some(front) if front == right || front == theirs => Judgement::Right(0.0),
        _ => Judgement::wrong("front", f64::INFINITY, format!("front: {right}")),
    }
}

/// The point is on the ray at `t`: as far off as `t` may be, and the rounding of its coordinates.
fn judge_point(
    question: &IntersectQuestion,
    hit: &Value,
    root: &Root,
    profile: Profile,
) -> Judgement {
    let Some(point) = hit.get("point") else { return Judgement::Right(0.0) };
    let oracle::Ray { origin, direction } = question.ray;
    let right: [f64; 3] = std::array::from_fn(|i| origin[i] + root.t * direction[i]);
    let expected = format!("point {right:?}");
    let Some(point) = three(point) else { return not_three("point", point, expected) };
    let length = |v: [f64; 3]| Vector::from(v).length();
    let off = length(std::array::from_fn(|i| point[i] - right[i]));
    let moved = root.squeeze * root.cond.max(root.t.abs()) * length(direction);
    // an instance's point is rounded in object space
    let error = off
        / (UNIT_ROUNDOFF * question.shape.condition() * (moved + length(origin) + length(right)));
    match error <= profile.allowed() {
        true => Judgement::Right(0.0),
        false => wrong(("point", error), expected, clues(&point, &right), (&point, &right)),
    }
}
