//! Answers the questions of `groundtruth conform`: fill in what your ray tracer has.
//!
//! Make a package (`cargo new my_tracer`), put this into `src/main.rs`, and into `Cargo.toml`:
//!
//! ```toml
//! [dependencies]
//! serde_json = { version = "1", features = ["float_roundtrip"] }
//! ```
//!
//! Run: `cargo build --release && groundtruth conform -- target/release/my_tracer`
//!
//! `docs/probe.md` describes the questions, `docs/conform.md` the run, and `examples/conform/adapter.rs` is one filled
//! in. Each function below is a question: it gets the question's data and returns the answer. What you do not have is
//! unsupported, also one shape among others. A function that is filled in begins, for example, with
//! `let origin: [f64; 3] = reals(&q["ray"]["origin"])?;` and ends with `Ok(json!({"t": t, "normal": normal}))`.

use std::io::{self, BufRead, Write};

use serde_json::{Value, json};

/// Why a question has no answer.
enum Refusal {
    /// Your program does not have what is asked for.
    Unsupported(String),
    /// Something is wrong: it is shown on the card, with the question.
    Error(String),
}

type Answer = Result<Value, Refusal>;

fn unsupported(what: &str) -> Answer {
    Err(Refusal::Unsupported(what.to_owned()))
}

/// A number; infinity is a text.
fn real(value: &Value) -> Result<f64, Refusal> {
    match value.as_str() {
        Some("inf") => Ok(f64::INFINITY),
        Some("-inf") => Ok(f64::NEG_INFINITY),
        _ => value.as_f64().ok_or_else(|| Refusal::Error(format!("{value} is no number"))),
    }
}

#[allow(dead_code)] // until you use it
fn reals<const N: usize>(value: &Value) -> Result<[f64; N], Refusal> {
    let none = || Refusal::Error(format!("{value} is no list of {N} numbers"));
    let numbers: Result<Vec<f64>, Refusal> =
        value.as_array().ok_or_else(none)?.iter().map(real).collect();
    numbers?.try_into().map_err(|_| none())
}

/// `{"shape": …, "ray": {"origin": […], "direction": […]}}` → {"t": …, "normal": […]} or null
fn intersect(_: &Value) -> Answer {
    unsupported("intersect")
}

/// `{"shape": …, "segment": {"from": […], "to": […]}}` → true or false
fn occluded(_: &Value) -> Answer {
    unsupported("occluded")
}

/// `{"camera": …, "image": …, "pixel": [x, y]}` → {"origin": […], "direction": […]}
fn camera_ray(_: &Value) -> Answer {
    unsupported("camera_ray")
}

/// `{"camera": …, "image": …, "point": […]}` → {"image": [x, y]} or null
fn project(_: &Value) -> Answer {
    unsupported("project")
}

/// `{"sampler": …, "n": 16, "seed": 1, "sets": 2}` → [[[x, y], …], …]
fn samples(_: &Value) -> Answer {
    unsupported("samples")
}

/// `{"to": …, "u": [a, b]}` → a point; {"to": …, "point": […]} -> [a, b]
fn map(_: &Value) -> Answer {
    unsupported("map")
}

/// `{"lobe": …, "wo": […], "wi": […]}` → {"f": [r, g, b], "pdf": …, "albedo": [r, g, b]}
fn lobe(_: &Value) -> Answer {
    unsupported("lobe")
}

/// `{"eta": …, "cos_i": …}` → {"reflected": …, "transmitted": …}
fn fresnel(_: &Value) -> Answer {
    unsupported("fresnel")
}

/// `{"light": …, "from": […]}` → {"direction": […], "distance": …, "radiance": [r, g, b]}
fn light(_: &Value) -> Answer {
    unsupported("light")
}

/// `{"texture": …, "point": […]}` → [r, g, b]
fn texture(_: &Value) -> Answer {
    unsupported("texture")
}

/// `{"mapping": "spherical", "point": […]}` → [u, v]
fn mapping(_: &Value) -> Answer {
    unsupported("mapping")
}

/// `{"noise": …, "point": […]}` → {"value": …, "fbm": …, "turbulence": …}
fn noise(_: &Value) -> Answer {
    unsupported("noise")
}

/// `{"steps": […]}` → {"matrix": [three rows of four], "inverse": [three rows of four]}
fn transform(_: &Value) -> Answer {
    unsupported("transform")
}

/// `{"boxes": […], "multiplier": 2}` → {"resolution": [nx, ny, nz]}
fn grid(_: &Value) -> Answer {
    unsupported("grid")
}

/// `{"scene": …, "ray": …}` → {"mean": [r, g, b]}
fn radiance(_: &Value) -> Answer {
    unsupported("radiance")
}

/// `{"scene": …, "ray": …}` → {"radiance": [r, g, b], "rays": [{"kind": "camera", "origin": …, "direction": …}, …]}
fn trace(_: &Value) -> Answer {
    unsupported("trace")
}

fn answer(name: &str, q: &Value) -> Answer {
    match name {
        "intersect" => intersect(q),
        "occluded" => occluded(q),
        "camera_ray" => camera_ray(q),
        "project" => project(q),
        "samples" => samples(q),
        "map" => map(q),
        "lobe" => lobe(q),
        "fresnel" => fresnel(q),
        "light" => light(q),
        "texture" => texture(q),
        "mapping" => mapping(q),
        "noise" => noise(q),
        "transform" => transform(q),
        "grid" => grid(q),
        "radiance" => radiance(q),
        "trace" => trace(q),
        _ => unsupported(name),
    }
}

/// The protocol: a question is a line, and so is its answer, with the same id.
pub fn reply(line: &str) -> String {
    let question: Value = serde_json::from_str(line).expect("every line is JSON");
    let fields = question.as_object().expect("every line is an object");
    let (name, data) = fields.iter().find(|(key, _)| *key != "id").expect("it has a question");
    let id = &question["id"];
    let reply = match answer(name, data) {
        Ok(answer) => json!({"id": id, "answer": answer}),
        Err(Refusal::Unsupported(what)) => json!({"id": id, "unsupported": what}),
        Err(Refusal::Error(text)) => json!({"id": id, "error": text}),
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
