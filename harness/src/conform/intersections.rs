//! Rays and shapes, judged by exact answers (`oracle`).

use serde::Deserialize;
use serde_json::{Value, json};

use super::exact::exact;
use super::family::{Family, Judge};
use super::judgement::{Judgement, Profile, Wrong, first_wrong, number, triple};
use super::mistakes::{self, Mistake, clues, same};
use super::subject::ours;
use crate::verify::{Draw, backward_error};
use groundtruth::math::{Point, Step, Transform, UNIT_ROUNDOFF, Vector};
use groundtruth::shapes::{self, Instance};
use oracle::hard::{self, Family as Hard};
use oracle::{Answer, Root};

/// The families of every kind of shape.
pub fn families() -> Vec<Family> {
    let mut families = Vec::new();
    for kind in hard::Kind::ALL {
        let Some(tag) = tag_of(kind) else { continue };
        let chapter = super::chapters::shape(&tag);
        let mut add = |question: &str, name: &str, ordinary: bool, cases: Cases, judge: Judge| {
            families.push(Family {
                name: format!("{question}.{tag}.{name}"),
                about: format!("shapes/{tag}"),
                chapter,
                ordinary,
                share: 1.0,
                cases,
                judge,
            });
        };
        for family in Hard::ALL {
            let cases = move |seed, n| nearest(kind, family, seed, n);
            let ordinary = family == Hard::Ordinary;
            add("intersect", &name_of(family), ordinary, Box::new(cases), Judge::Answer(judge));
        }
        let around = move |seed, n| around(kind, seed + 3, n);
        add("intersect", "around", true, Box::new(around), Judge::Answer(judge));
        let all = move |seed, n| changed(kind, seed + 1, n, all_roots);
        add("intersect", "all_roots", true, Box::new(all), Judge::Answer(judge));
        let occluded = move |seed, n| changed(kind, seed + 2, n, occlusion);
        add("occluded", "segment", true, Box::new(occluded), Judge::Answer(judge_occluded));
    }
    families
}

type Cases = Box<dyn Fn(u64, usize) -> Vec<Value> + Send + Sync>;

/// `FarOrigin` as `far_origin`.
fn name_of(family: Hard) -> String {
    groundtruth::kinds::tag(&format!("{family:?}"))
}

/// The tag of a kind in scene files.
fn tag_of(kind: hard::Kind) -> Option<String> {
    let shape = hard::cases(kind, Hard::Ordinary, 1, 1).pop()?.0;
    let (ours, _) = backward_error::ours(&shape)?;
    let data = serde_json::to_value(ours).ok()?;
    data.as_object()?.keys().next().cloned()
}

/// The questions for the nearest hit; those that the library has no shape for are left out.
fn nearest(kind: hard::Kind, family: Hard, seed: u64, n: usize) -> Vec<Value> {
    let cases = hard::cases(kind, family, seed, n).into_iter();
    let question = |(shape, ray): (oracle::Shape, oracle::Ray)| {
        let pair = backward_error::pair(&shape)?;
        let span = backward_error::span(family, &*pair.ours, &backward_error::ray(&ray));
        let (kind, _) = backward_error::ours(&shape)?;
        let mut question =
            json!({"shape": kind, "ray": {"origin": ray.origin, "direction": ray.direction}});
        if span.min > 0.0 {
            question["span"] = json!([span.min, "inf"]);
        }
        Some(json!({"intersect": question}))
    };
    cases.filter_map(question).collect()
}

/// Rays through the neighbourhood of the shape, in all directions, a quarter of them away from it. The hard families
/// aim at the surface: rays that go by, or meet what a wrong border lets in, are found here.
fn around(kind: hard::Kind, seed: u64, n: usize) -> Vec<Value> {
    let mut questions = nearest(kind, Hard::Ordinary, seed, n);
    for (index, question) in questions.iter_mut().enumerate() {
        let mut draw = Draw::case(seed, index);
        let Ok(shape) = shapes::Kind::deserialize(&question["intersect"]["shape"]) else {
            continue;
        };
        let Ok(built) = shape.build(&mut shapes::Context::default()) else { continue };
        let bounds = built.bounds();
        let (middle, size) = match bounds.is_bounded() {
            true => (bounds.min + 0.5 * bounds.extent(), 0.5 * bounds.extent()),
            false => (Point::ORIGIN, Vector::new(2.0, 2.0, 2.0)),
        };
        let mut near = |scale: f64| {
            let share = draw.vector(scale).to_array();
            let offset = [0, 1, 2].map(|i| share[i] * size.to_array()[i].max(0.25 * size.length()));
            middle + Vector::from(offset)
        };
        let (origin, aim) = (near(3.0), near(1.0));
        let direction = if index % 4 == 0 { origin - aim } else { aim - origin };
        question["intersect"]["ray"] =
            json!({"origin": origin.to_array(), "direction": direction.to_array()});
    }
    questions
}

/// Ordinary questions, changed.
fn changed(kind: hard::Kind, seed: u64, n: usize, change: fn(usize, &mut Value)) -> Vec<Value> {
    let mut questions = nearest(kind, Hard::Ordinary, seed, n);
    questions.iter_mut().enumerate().for_each(|(index, question)| change(index, question));
    questions
}

fn all_roots(index: usize, question: &mut Value) {
    question["intersect"]["all"] = json!(true);
    if index % 2 == 0 {
        question["intersect"]["span"] = json!(["-inf", "inf"]);
    }
}

/// A segment that ends before or behind what it is aimed at.
fn occlusion(index: usize, question: &mut Value) {
    let parsed = Question::of(question);
    let t = parsed.and_then(|it| it.answer()).and_then(|answer| Some(answer.roots.first()?.t));
    let length = [0.5, 0.9, 1.1, 2.0][index % 4] * t.unwrap_or(1.0);
    let mut inner = question["intersect"].take();
    let ray = inner["ray"].take();
    let numbers = [&ray["origin"], &ray["direction"]].map(|it| triple(it).unwrap_or_default());
    let [origin, direction] = numbers;
    let end: [f64; 3] = std::array::from_fn(|i| origin[i] + length * direction[i]);
    let segment = json!({"from": origin, "to": end});
    *question = json!({"occluded": {"shape": inner["shape"].take(), "segment": segment}});
}

/// A question as the oracle sees it.
struct Question {
    kind: shapes::Kind,
    shape: oracle::Shape,
    ray: oracle::Ray,
    span: [f64; 2],
    all: bool,
}

impl Question {
    /// `None` if it is none, or about a shape that the oracle does not have.
    fn of(question: &Value) -> Option<Self> {
        let (name, data) = question.as_object()?.iter().next()?;
        let mut kind = shapes::Kind::deserialize(&data["shape"]).ok()?;
        if let Ok(steps) = Vec::<Step>::deserialize(&data["transform"]) {
            kind = Instance::new(kind, steps).into();
        }
        let end = |i: usize, other| data["span"].get(i).map_or(Some(other), number);
        let (ray, span) = if data.get("segment").is_some() {
            let [from, to] = ["from", "to"].map(|end| triple(&data["segment"][end]));
            let (from, to) = (from?, to?);
            let direction = std::array::from_fn(|i| to[i] - from[i]);
            (oracle::Ray { origin: from, direction }, [0.0, 1.0])
        } else {
            let [origin, direction] = ["origin", "direction"].map(|it| triple(&data["ray"][it]));
            let ray = oracle::Ray { origin: origin?, direction: direction? };
            (ray, [end(0, 0.0)?, end(1, f64::INFINITY)?])
        };
        let all = name == "intersect" && data["all"] == json!(true);
        Some(Self { shape: exact(&kind)?, kind, ray, span, all })
    }

    /// The exact roots in the span. From −∞ on, they are looked for from a point of the ray far behind the shape.
    fn answer(&self) -> Option<Answer> {
        let [min, max] = self.span;
        let start = if min.is_finite() { min } else { self.far_behind()? };
        let mut answer = oracle::intersect_beyond(&self.shape, &self.ray, start);
        // a root that rounding moves over the end
        let near_end = |root: &Root| max.is_finite() && (root.t - max).abs() <= 1e-9 * max.abs();
        if answer.roots.iter().any(near_end) {
            answer.margin = 0.0;
        }
        answer.roots.retain(|root| root.t < max);
        Some(answer)
    }

    fn far_behind(&self) -> Option<f64> {
        let built = self.kind.build(&mut shapes::Context::default()).ok()?;
        let roots = built.roots(&backward_error::ray(&self.ray), groundtruth::math::Span::LINE);
        let first = roots.first().map_or(0.0, |root| root.t);
        Some(first.min(0.0) * 2.0 - 1.0)
    }

    fn is_decided(&self, answer: &Answer, profile: Profile) -> bool {
        answer.margin > profile.margin() * self.shape.condition()
    }
}

fn judge_occluded(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    let Some(question) = Question::of(question) else { return Judgement::Undecided };
    let Some(exact) = question.answer() else { return Judgement::Undecided };
    if !question.is_decided(&exact, profile) {
        return Judgement::Undecided;
    }
    let right = !exact.roots.is_empty();
    match answer.as_bool() {
        Some(theirs) if theirs == right => Judgement::Right(0.0),
        Some(false) => Judgement::wrong("missed", f64::INFINITY, "true"),
        Some(true) => Judgement::wrong("no hit is there", f64::INFINITY, "false"),
        None => Judgement::wrong("no truth value", f64::INFINITY, right.to_string()),
    }
}

fn judge(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    let Some(parsed) = Question::of(question) else { return Judgement::Undecided };
    let Some(exact) = parsed.answer() else { return Judgement::Undecided };
    if !parsed.is_decided(&exact, profile) {
        return Judgement::Undecided;
    }
    let theirs: Vec<&Value> = match answer {
        Value::Null => Vec::new(),
        Value::Array(hits) if parsed.all => hits.iter().collect(),
        hit => vec![hit],
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
fn miscounted(question: &Question, theirs: &[&Value], right: &[Root]) -> Judgement {
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
    let mut judgement = Judgement::wrong(symptom, f64::INFINITY, expected);
    if let (Judgement::Wrong(wrong), [hit], []) = (&mut judgement, theirs, right) {
        wrong.clues = behind(question, hit["t"].as_f64().unwrap_or(f64::NAN));
    }
    if let (Judgement::Wrong(wrong), [], [root]) = (&mut judgement, theirs, right)
        && dot(root.normal, question.ray.direction) > 0.0
    {
        wrong.clues.push(&mistakes::INSIDE_MISSED);
    }
    judgement
}

/// Whether `t` is that of a hit behind the origin.
fn behind(question: &Question, t: f64) -> Vec<&'static Mistake> {
    let is_behind = other_roots(question).iter().any(|other| *other < 0.0 && same(&[t], &[*other]));
    if is_behind { vec![&mistakes::BEHIND] } else { Vec::new() }
}

/// All `t` of the whole line.
fn other_roots(question: &Question) -> Vec<f64> {
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

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    Vector::from(a).dot(Vector::from(b))
}

fn judge_hit(question: &Question, hit: &Value, root: &Root, profile: Profile) -> Judgement {
    let t = match hit.get("t").map(number) {
        Some(Some(t)) => t,
        _ => return Judgement::wrong("t is missing", f64::INFINITY, format!("t = {:?}", root.t)),
    };
    let t_error = backward_error::t_error(root, t);
    if !(t_error <= profile.allowed()) {
        let mut found = clues(&[t], &[root.t]);
        let length = Vector::from(question.ray.direction).length();
        if same(&[t], &[root.t * length]) && !same(&[root.t], &[root.t * length]) {
            found.push(&mistakes::UNIT_ASSUMED);
        }
        let others = other_roots(question);
        if others.iter().any(|other| *other > root.t && same(&[t], &[*other])) {
            found.push(&mistakes::FAR_ROOT);
        }
        found.extend(behind(question, t));
        return wrong("t", t_error, format!("t = {:?}", root.t), found, &[t], &[root.t]);
    }
    let normal = judge_normal(question, hit, root, profile);
    let point = judge_point(question, hit, root, profile);
    first_wrong([Judgement::Right(t_error), normal, judge_front(question, hit, root), point])
}

fn wrong(
    symptom: &str,
    error: f64,
    expected: String,
    clues: Vec<&'static Mistake>,
    theirs: &[f64],
    right: &[f64],
) -> Judgement {
    let ratio = mistakes::ratio(theirs, right);
    let symptom = symptom.to_owned();
    Judgement::Wrong(Box::new(Wrong { symptom, error, expected, clues, ratio }))
}

fn judge_normal(question: &Question, hit: &Value, root: &Root, profile: Profile) -> Judgement {
    let right = root.normal;
    let expected = format!("normal {right:?}");
    let Some(normal) = triple(&hit["normal"]) else {
        return Judgement::wrong("normal is missing", f64::INFINITY, expected);
    };
    let condition = question.shape.condition();
    let direction = Vector::from(question.ray.direction);
    let Some((error, allowed)) = backward_error::normal_error(root, normal, direction, condition)
    else {
        return Judgement::Right(0.0); // at an edge, either face's normal is right
    };
    if root.face_margin <= profile.margin() * condition {
        return Judgement::Right(0.0);
    }
    let allowed = if profile == Profile::Book { profile.allowed() } else { allowed };
    let length = Vector::from(normal).length();
    let is_unit = (length - 1.0).abs() <= allowed.max(4.0) * UNIT_ROUNDOFF;
    if error <= allowed && !is_unit {
        let clues = vec![&mistakes::NOT_NORMALISED_LENGTH];
        let off = (length - 1.0).abs() / UNIT_ROUNDOFF;
        return wrong("normal is not unit", off, expected, clues, &normal, &right);
    }
    if error <= allowed {
        return Judgement::Right(error);
    }
    let mut found = clues(&normal, &right);
    let is_back = dot(right, question.ray.direction) > 0.0;
    if same(&normal, &right.map(|x| -x)) && is_back {
        found.push(&mistakes::TO_VIEWER);
    }
    found.extend(by_transform(question, normal, right));
    wrong("normal", error, expected, found, &normal, &right)
}

/// How a normal of an instance can be transformed wrongly. With `n ∝ A⁻ᵀ g`, the gradient is `g ∝ Aᵀ n`.
fn by_transform(question: &Question, normal: [f64; 3], right: [f64; 3]) -> Vec<&'static Mistake> {
    let shapes::Kind::Instance(instance) = &question.kind else { return Vec::new() };
    let Ok(transform) = Transform::from_steps(&instance.transform) else { return Vec::new() };
    let rows = transform.rows();
    let linear = |v: [f64; 3], transposed: bool| -> [f64; 3] {
        let entry = |i: usize, j: usize| if transposed { rows[j][i] } else { rows[i][j] };
        std::array::from_fn(|i| (0..3).map(|j| entry(i, j) * v[j]).sum())
    };
    let unit = |v: [f64; 3]| Vector::from(v).unit().map(|n| n.to_array());
    let Some(local) = unit(linear(right, true)) else { return Vec::new() };
    let Some(by_matrix) = unit(linear(local, false)) else { return Vec::new() };
    let is = |other: [f64; 3]| same(&normal, &other) && !same(&right, &other);
    let mut found = Vec::new();
    if is(by_matrix) {
        found.push(&mistakes::NORMAL_BY_MATRIX);
    }
    if is(local) {
        found.push(&mistakes::NORMAL_UNTRANSFORMED);
    }
    found
}

fn judge_front(question: &Question, hit: &Value, root: &Root) -> Judgement {
    let Some(front) = hit.get("front") else { return Judgement::Right(0.0) };
    let right = dot(root.normal, question.ray.direction) < 0.0;
    match front.as_bool() == Some(right) {
        true => Judgement::Right(0.0),
        false => Judgement::wrong("front", f64::INFINITY, format!("front: {right}")),
    }
}

/// The point is on the ray at `t`: as far off as `t` may be, and the rounding of its coordinates.
fn judge_point(question: &Question, hit: &Value, root: &Root, profile: Profile) -> Judgement {
    let Some(point) = hit.get("point") else { return Judgement::Right(0.0) };
    let oracle::Ray { origin, direction } = question.ray;
    let right: [f64; 3] = std::array::from_fn(|i| origin[i] + root.t * direction[i]);
    let expected = format!("point {right:?}");
    let Some(point) = triple(point) else {
        return Judgement::wrong("point", f64::INFINITY, expected);
    };
    let length = |v: [f64; 3]| Vector::from(v).length();
    let off = length(std::array::from_fn(|i| point[i] - right[i]));
    let moved = root.squeeze * root.cond.max(root.t.abs()) * length(direction);
    // an instance's point is rounded in object space
    let error = off
        / (UNIT_ROUNDOFF * question.shape.condition() * (moved + length(origin) + length(right)));
    match error <= profile.allowed() {
        true => Judgement::Right(0.0),
        false => wrong("point", error, expected, clues(&point, &right), &point, &right),
    }
}
