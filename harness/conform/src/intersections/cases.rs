//! Questions for rays and shapes.

use ask::{Draw, triple};
use serde::Deserialize;
use serde_json::{Value, json};

use super::question::IntersectQuestion;
use exact::backward_error;
use groundtruth::math::{Point, Vector};
use groundtruth::shapes;
use oracle::hard::{self, Family as Hard};

/// The questions for the nearest hit; those that the library has no shape for are left out.
pub fn nearest(kind: hard::Kind, family: Hard, seed: u64, n: usize) -> Vec<Value> {
    let cases = hard::cases(kind, family, seed, n).into_iter();
    let question = |(shape, ray): (oracle::Shape, oracle::Ray)| {
        let pair = backward_error::pair(&shape)?;
        let span = backward_error::span(family, &*pair.ours, &backward_error::ray(&ray));
        let kind = exact::our_shape(&shape)?;
        let mut question =
            json!({"shape": kind, "ray": {"origin": ray.origin, "direction": ray.direction}});
        if span.min > 0.0 {
            question["span"] = json!([span.min, "inf"]);
        }
        Some(json!({"intersect": question}))
    };
    cases.filter_map(question).collect()
}

/// Rays through the neighbourhood of the shape, in all directions, a quarter of them away from it and a third of them
/// from inside its bounds. The hard families aim at the surface: rays that go by, or meet what a wrong border lets in,
/// are found here.
pub fn around(kind: hard::Kind, seed: u64, n: usize) -> Vec<Value> {
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
        let (origin, aim) = (near(if index.is_multiple_of(3) { 0.75 } else { 3.0 }), near(1.0));
        let direction = if index.is_multiple_of(4) { origin - aim } else { aim - origin };
        question["intersect"]["ray"] =
            json!({"origin": origin.to_array(), "direction": direction.to_array()});
    }
    questions
}

/// Ordinary questions, changed.
pub fn changed(kind: hard::Kind, seed: u64, n: usize, change: fn(usize, &mut Value)) -> Vec<Value> {
    let mut questions = nearest(kind, Hard::Ordinary, seed, n);
    questions.iter_mut().enumerate().for_each(|(index, question)| change(index, question));
    questions
}

/// Parts within one turn, as the book has them, apart from ranges that go farther round (Suffern, ch. 19).
pub fn within_a_turn(kind: hard::Kind, seed: u64, n: usize) -> Vec<Value> {
    let mut plain = nearest(kind, Hard::Ordinary, seed ^ 0x360, 8 * n);
    let is_within = |question: &Value| {
        let shape = question["intersect"]["shape"].as_object();
        let data = shape.and_then(|shape| shape.values().next());
        let end = |i: usize| data.and_then(|data| data["phi"][i].as_f64());
        end(0).is_none_or(|low| low >= 0.0) && end(1).is_none_or(|high| high <= 360.0)
    };
    plain.retain(is_within);
    plain.truncate(n);
    plain
}

/// All roots, in half of the cases on the whole line, from between the roots in half of these.
pub fn all_roots(index: usize, question: &mut Value) {
    if index.is_multiple_of(4) {
        let t = first_root(question).unwrap_or(0.0);
        let ray = &mut question["intersect"]["ray"];
        let [origin, direction] =
            ["origin", "direction"].map(|it| triple(&ray[it]).unwrap_or_default());
        let moved: [f64; 3] = std::array::from_fn(|i| origin[i] + 1.0625 * t * direction[i]);
        ray["origin"] = json!(moved);
    }
    question["intersect"]["all"] = json!(true);
    if index.is_multiple_of(2) {
        question["intersect"]["span"] = json!(["-inf", "inf"]);
    }
}

/// The exact `t` of the nearest hit.
fn first_root(question: &Value) -> Option<f64> {
    Some(IntersectQuestion::of(question)?.answer()?.roots.first()?.t)
}

/// A segment that ends before or behind what it is aimed at.
pub fn occlusion(index: usize, question: &mut Value) {
    let length = [0.5, 0.9, 1.1, 2.0][index % 4] * first_root(question).unwrap_or(1.0);
    let mut inner = question["intersect"].take();
    let ray = inner["ray"].take();
    let numbers = [&ray["origin"], &ray["direction"]].map(|it| triple(it).unwrap_or_default());
    let [origin, direction] = numbers;
    let end: [f64; 3] = std::array::from_fn(|i| origin[i] + length * direction[i]);
    let segment = json!({"from": origin, "to": end});
    *question = json!({"occluded": {"shape": inner["shape"].take(), "segment": segment}});
}
