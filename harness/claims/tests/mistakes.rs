//! Mistakes of lobes break the law that names them.

use ask::numbers;
use std::f64::consts::PI;

use claims::{Kind, Law};
use groundtruth::math::{cos, sin};
use serde_json::{Value, json};

use super::counted::{Lambert, card, data, first};

/// Multiplies all numbers of a value.
pub fn times(value: &mut Value, factor: f64) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(|it| times(it, factor)),
        value => *value = json!(value.as_f64().map(|x| factor * x)),
    }
}

/// Multiplies these fields of `eval`, and those of each sample.
pub fn scaled(mut answer: Value, eval: &str, sample: &[&str], factor: f64) -> Value {
    match &mut answer {
        Value::Array(samples) => {
            let fields = samples.iter_mut().flat_map(|it| {
                let fields = it.as_object_mut().expect("a sample").iter_mut();
                fields.filter(|(key, _)| sample.contains(&key.as_str()))
            });
            fields.for_each(|(_, field)| times(field, factor));
        }
        values => {
            if let Some(field) = values.get_mut(eval) {
                times(field, factor);
            }
        }
    }
    answer
}

/// Samples at this height for their random numbers, where they have one; their weights and densities follow.
fn moved(question: &Value, mut answer: Value, height: impl Fn(&[f64]) -> Option<f64>) -> Value {
    let u = data(question)["u"].as_array().into_iter().flatten();
    for (sample, u) in answer.as_array_mut().into_iter().flatten().zip(u) {
        let u = numbers(u).expect("numbers");
        let Some(z) = height(&u) else { continue };
        let (r, phi) = ((1.0 - z * z).max(0.0).sqrt(), 2.0 * PI * u[1]);
        *sample =
            json!({"wi": [r * cos(phi), r * sin(phi), z], "weight": vec![0.7; 3], "pdf": z / PI});
    }
    answer
}

/// One sample of eighteen is uniform.
pub fn few_are_uniform(question: &Value, answer: Value) -> Value {
    moved(question, answer, |u| (u[2] < 0.055).then_some(u[0]))
}

fn viewer(question: &Value, axis: usize) -> f64 {
    data(question)["wo"][axis].as_f64().expect("a number")
}

/// The law that should name a mistake, and what becomes of the answer to a question that is the n-th.
type Planted = (&'static str, fn(usize, &Value, Value) -> Value);

/// One for each law.
const PLANTED: [Planted; 10] = [
    ("repeated", |n, _, a| scaled(a, "f", &["weight"], 1.0 - 1e-3 * n as f64)),
    ("positive", |_, _, a| scaled(a, "f", &[], -1.0)),
    ("sides", |_, _, mut a| {
        let values = a.get_mut("f").and_then(Value::as_array_mut);
        values.into_iter().flatten().for_each(|f| *f = json!(vec![0.7 / PI; 3]));
        a
    }),
    ("same pdf", |_, _, a| scaled(a, "", &["pdf"], 2.0)),
    ("weight", |_, q, a| scaled(a, "", &["weight"], viewer(q, 2))),
    ("density", |_, q, a| moved(q, a, |u| Some((1.0 - u[0] * u[0]).sqrt()))),
    ("whole", |_, _, a| scaled(scaled(a, "pdf", &["pdf"], PI), "", &["weight"], 1.0 / PI)),
    ("turned", |_, q, a| scaled(a, "f", &["weight"], 1.0 - 0.5 * viewer(q, 0))),
    ("reciprocal", |_, q, a| scaled(a, "f", &["weight"], 1.0 - 0.5 * viewer(q, 2))),
    ("albedo", |_, _, a| scaled(a, "f", &["weight"], 2.0)),
];

/// Law: a mistake of each law is found, and by this law. Oracle: what was planted.
#[test]
fn each_law_finds_its_mistake() {
    assert!(Law::of(Kind::Lobe).iter().map(|law| law.name).eq(PLANTED.map(|it| it.0)));
    for (law, change) in PLANTED {
        let claims = json!({"isotropic": law == "turned", "reciprocal": law == "reciprocal"});
        let mut asked = 0;
        let changed = |question: &Value, answer: Value| {
            asked += 1;
            change(asked, question, answer)
        };
        let card = card(&mut Lambert::new(claims, json!({}), changed), 3);
        assert_eq!(first(&card), Some(law), "{card}");
    }
}
