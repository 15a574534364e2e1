//! Instances by what a case needs (Suffern, ch. 20): each transformation alone, then two and three composed, each with
//! a sphere and with a box: a program that has some of them is judged by these. And parts of shapes within one turn,
//! as the book has them, apart from ranges that go farther round.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::intersections::{self, judge, judge_occluded};
use super::{family, round, vector};
use exact::Draw;
use groundtruth::math::Vector;

/// A name, and a case.
type Alone = (&'static str, fn(&mut Draw) -> Value);

/// Each transformation by name.
const ALONE: [Alone; 10] = [
    ("translate", |draw| json!({"translate": vector(draw, 4.0)})),
    ("scale_evenly", |draw| {
        let factor = round(draw.between(0.25, 3.0));
        json!({"scale": [factor, factor, factor]})
    }),
    (
        "scale",
        |draw| json!({"scale": (std::array::from_fn::<f64, 3, _>(|_| round(draw.between(0.25, 3.0))))}),
    ),
    ("rotate_x", |draw| json!({"rotate_x": angle(draw)})),
    ("rotate_y", |draw| json!({"rotate_y": angle(draw)})),
    ("rotate_z", |draw| json!({"rotate_z": angle(draw)})),
    ("rotate_about", |draw| {
        let (point, direction) = (vector(draw, 1.0), draw.direction().to_array().map(round));
        json!({"rotate_about": {"point": point, "direction": direction, "degrees": angle(draw)}})
    }),
    ("reflect", |draw| json!({"reflect": draw.pick(&["x", "y", "z"])})),
    (
        "shear",
        |draw| json!({"shear": (std::array::from_fn::<f64, 6, _>(|_| round(draw.between(-0.4, 0.4))))}),
    ),
    ("matrix", |draw| {
        let mut entry = |on_axis: bool| match on_axis {
            true => round(draw.between(0.5, 2.0)),
            false => round(draw.between(-0.4, 0.4)),
        };
        let mut rows = [[0.0; 4]; 4];
        for (i, row) in rows.iter_mut().enumerate() {
            *row = match i {
                3 => [0.0, 0.0, 0.0, 1.0],
                _ => std::array::from_fn(|j| entry(i == j)),
            };
        }
        json!({"matrix": rows})
    }),
];

/// An angle in degrees, none of them a quarter turn.
fn angle(draw: &mut Draw) -> f64 {
    round(draw.sign() * draw.between(5.0, 85.0) + draw.pick(&[0.0, 90.0]))
}

pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    for body in ["sphere", "box"] {
        for (name, step) in ALONE {
            all.push(of_steps(name, body, move |draw| vec![step(draw)]));
        }
        all.push(of_steps("rotate_translate", body, |draw| vec![turn(draw), one(draw, &[0])]));
        all.push(of_steps("translate_rotate", body, |draw| vec![one(draw, &[0]), turn(draw)]));
        all.push(of_steps("scale_rotate", body, |draw| vec![one(draw, &[2]), turn(draw)]));
        all.push(of_steps("scale_rotate_translate", body, |draw| {
            vec![one(draw, &[2]), turn(draw), one(draw, &[0])]
        }));
        all.push(of_steps("any_three", body, |draw| {
            let any: Vec<usize> = (0..ALONE.len()).collect();
            (0..3).map(|_| one(draw, &any)).collect()
        }));
    }
    all.push(occluded());
    all.extend(within_a_turn());
    all
}

/// One of these transformations.
fn one(draw: &mut Draw, of: &[usize]) -> Value {
    let (_, step) = ALONE[draw.pick(of)];
    step(draw)
}

fn turn(draw: &mut Draw) -> Value {
    one(draw, &[3, 4, 5])
}

fn of_steps(
    name: &str,
    body: &'static str,
    steps: impl Fn(&mut Draw) -> Vec<Value> + Send + Sync + 'static,
) -> Family {
    let case = move |draw: &mut Draw| {
        let steps = steps(draw);
        question(draw, body, &steps)
    };
    let name = format!("intersect.transformed.{name}.{body}");
    let mut family = family(&name, "shapes/instance", "ch20", Judge::Answer(judge), case);
    family.share = 0.5;
    family
}

/// A ray from outside to a point of the body's middle, both moved with it: so it hits.
fn question(draw: &mut Draw, body: &str, steps: &[Value]) -> Value {
    let shape = match body {
        "sphere" => {
            json!({"sphere": {"center": vector(draw, 0.5), "radius": round(draw.between(0.75, 1.5))}})
        }
        _ => json!({"box": {
            "min": (std::array::from_fn::<f64, 3, _>(|_| round(draw.between(-1.5, -0.75)))),
            "max": (std::array::from_fn::<f64, 3, _>(|_| round(draw.between(0.75, 1.5)))),
        }}),
    };
    // what the steps do to a point, by our matrix
    let matrix = super::super::subject::ours(&json!({"transform": {"steps": steps}}));
    let matrix = matrix.map(|answer| answer["matrix"].clone()).unwrap_or_default();
    let moved = |p: Vector| -> [f64; 3] {
        let p = p.to_array();
        std::array::from_fn(|i| {
            let entry = |j: usize| matrix[i][j].as_f64().unwrap_or(0.0);
            round(entry(0) * p[0] + entry(1) * p[1] + entry(2) * p[2] + entry(3))
        })
    };
    let from = moved(draw.between(3.0, 6.0) * draw.direction());
    let to = moved(draw.vector(0.5));
    let direction: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    json!({"intersect": {
        "shape": shape, "transform": steps, "ray": {"origin": from, "direction": direction},
    }})
}

/// Shadow rays past turned and stretched bodies.
fn occluded() -> Family {
    let case = |draw: &mut Draw| {
        let steps = [one(draw, &[2]), turn(draw), one(draw, &[0])];
        let body = if draw.coin() { "sphere" } else { "box" };
        let mut inner = question(draw, body, &steps)["intersect"].take();
        let ray = inner["ray"].take();
        let share = draw.pick(&[0.25, 0.5, 1.0, 2.0]);
        let at = |it: &str, i: usize| ray[it][i].as_f64().unwrap_or(0.0);
        let end = [0, 1, 2].map(|i| at("origin", i) + share * at("direction", i));
        let segment = json!({"from": ray["origin"], "to": end});
        json!({"occluded": {"shape": inner["shape"], "transform": steps, "segment": segment}})
    };
    let judge = Judge::Answer(judge_occluded);
    family("occluded.transformed.segment", "shapes/instance", "ch20", judge, case)
}

/// Of the part shapes, cases whose angles are within 0 … 360 degrees.
fn within_a_turn() -> Vec<Family> {
    let mut all = Vec::new();
    for part in intersections::families() {
        if !part.name.ends_with(".ordinary") || !part.name.starts_with("intersect.part_") {
            continue;
        }
        let cases = part.cases;
        let cases = move |seed: u64, n: usize| {
            let mut plain = cases(seed ^ 0x360, 8 * n);
            plain.retain(is_within_a_turn);
            plain.truncate(n);
            plain
        };
        let name = part.name.replace(".ordinary", ".within_a_turn");
        all.push(Family { name, share: 0.5, cases: Box::new(cases), ..part });
    }
    all
}

fn is_within_a_turn(question: &Value) -> bool {
    let shape = question["intersect"]["shape"].as_object();
    let data = shape.and_then(|shape| shape.values().next());
    let end = |i: usize| data.and_then(|data| data["phi"][i].as_f64());
    end(0).is_none_or(|low| low >= 0.0) && end(1).is_none_or(|high| high <= 360.0)
}
