//! Answers the questions of `groundtruth laws`: name your lobes, and fill in two functions.
//!
//! Make a package (`cargo new my_bsdfs`), put this into `src/main.rs`, and into `Cargo.toml`:
//!
//! ```toml
//! [dependencies]
//! serde_json = { version = "1", features = ["float_roundtrip"] }
//! ```
//!
//! Run: `cargo build --release && groundtruth laws -- target/release/my_bsdfs`
//!
//! `docs/laws.md` describes the questions and the claims, and `examples/laws/bsdfs.py` is one with more lobes.
//! All directions are unit vectors in the local frame of the surface: z is the normal. `wo` points to the viewer, `wi`
//! to the light. The lobe below is Lambert's; put yours in its place.

use std::f64::consts::PI;
use std::io::{self, BufRead, Write};

use serde_json::{Value, json};

/// What you have: names, from where parameters are drawn, and what you claim. A claim that is left out is not tested.
/// `[0, 1]` is a range; `{"one_of": ["copper", "gold"]}` chooses, a number is fixed.
const LOBES: &str = r#"[
    {"name": "lambert", "parameters": {"albedo": [0, 1]}, "claims": {"reciprocal": true, "isotropic": true}}
]"#;

type Vector = [f64; 3];

/// f(wo, wi), without a cosine; and the density of `sample` at wi, per steradian.
fn evaluate(_name: &str, parameters: &Value, wo: Vector, wi: Vector) -> Option<(Vector, f64)> {
    if wo[2] <= 0.0 || wi[2] <= 0.0 {
        return Some(([0.0; 3], 0.0));
    }
    let albedo = parameters["albedo"].as_f64()?;
    Some(([albedo / PI; 3], wi[2] / PI))
}

/// A direction, its weight f |cos| / pdf, and its density, which is `None` for a single direction.
type Sample = (Vector, Vector, Option<f64>);

/// A sample for four random numbers in [0, 1); `Some(None)` where nothing is scattered.
fn sample(_name: &str, parameters: &Value, wo: Vector, u: [f64; 4]) -> Option<Option<Sample>> {
    if wo[2] <= 0.0 {
        return Some(None);
    }
    let (r, phi) = (u[0].sqrt(), 2.0 * PI * u[1]);
    let wi = [r * phi.cos(), r * phi.sin(), (1.0 - u[0]).sqrt()];
    let albedo = parameters["albedo"].as_f64()?;
    Some(Some((wi, [albedo; 3], Some(wi[2] / PI))))
}

// The protocol: a question is a line, and so is its answer, with the same id.

fn reals<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    numbers?.try_into().ok()
}

/// The answer; `None` if the question lacks something.
fn answer(question: &Value) -> Option<Value> {
    if question.get("list").is_some() {
        return serde_json::from_str(LOBES).ok();
    }
    let is_eval = question.get("eval").is_some();
    let data = &question[if is_eval { "eval" } else { "sample" }];
    let (name, parameters) = (data["lobe"].as_str()?, &data["parameters"]);
    let wo: Vector = reals(&data["wo"])?;
    if is_eval {
        let wi = data["wi"].as_array()?.iter();
        let values: Option<Vec<(Vector, f64)>> =
            wi.map(|wi| evaluate(name, parameters, wo, reals(wi)?)).collect();
        let (f, pdf): (Vec<Vector>, Vec<f64>) = values?.into_iter().unzip();
        return Some(json!({"f": f, "pdf": pdf}));
    }
    let drawn = data["u"].as_array()?.iter().map(|u| {
        let sample = sample(name, parameters, wo, reals(u)?)?;
        let shown = |(wi, weight, pdf): Sample| json!({"wi": wi, "weight": weight, "pdf": pdf});
        Some(sample.map_or(Value::Null, shown))
    });
    drawn.collect::<Option<Vec<Value>>>().map(Value::from)
}

/// The answer to a line, as a line.
pub fn reply(line: &str) -> String {
    let question: Value = serde_json::from_str(line).expect("every line is JSON");
    let id = &question["id"];
    let reply = match answer(&question) {
        Some(answer) => json!({"id": id, "answer": answer}),
        None => json!({"id": id, "error": "the question lacks something"}),
    };
    reply.to_string()
}

fn main() -> io::Result<()> {
    let mut output = io::stdout();
    for line in io::stdin().lock().lines() {
        // print nothing else here: messages belong to the standard error
        writeln!(output, "{}", reply(&line?))?;
        output.flush()?;
    }
    Ok(())
}
