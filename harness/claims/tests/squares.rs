//! Maps from the unit square as people write them, each with the mistakes that people make, as a program that answers.

#![allow(clippy::disallowed_methods)] // as people write it: the standard library's functions

use ask::{Reply, Subject, numbers};
use std::f64::consts::PI;

use serde_json::{Value, json};

/// The maps that answer.
pub const ALL: [&str; 5] = ["disk", "hemisphere", "sphere", "triangle", "tent"];

/// Answers in double precision, or with each number rounded to a single one.
pub struct Squares {
    pub maps: &'static [&'static str],
    pub mistake: &'static str,
    pub is_single: bool,
    asked: u64,
}

impl Squares {
    pub fn new(maps: &'static [&'static str], mistake: &'static str, is_single: bool) -> Self {
        Self { maps, mistake, is_single, asked: 0 }
    }

    fn is(&self, mistake: &str) -> bool {
        self.mistake == mistake
    }

    fn map(&self, name: &str, e: f64, [mut a, b]: [f64; 2]) -> Vec<f64> {
        if self.is("scrambled") {
            // small cells change places
            let [i, j] = [a, b].map(|u| (1000.0 * u).floor());
            a = ((617.0 * i + 389.0 * j) % 1000.0 + (1000.0 * a - i)) / 1000.0;
        }
        if self.is("numbers of its own") {
            a = (a + 0.618 * self.asked as f64).fract();
        }
        let phi = 2.0 * PI * b;
        let (sin, cos) = (phi.sin(), phi.cos());
        match name {
            "disk" => {
                let r = if self.is("radius without root") { a } else { a.sqrt() };
                let r = if self.is("square not halved") { 2.0 * r } else { r };
                vec![r * cos, r * sin]
            }
            "hemisphere" => {
                let z = (1.0 - a).powf(1.0 / (e + 1.0));
                let r = (1.0 - z * z).max(0.0).sqrt();
                vec![r * cos, r * sin, z]
            }
            "sphere" => {
                let z = if self.is("half a sphere") { 1.0 - a } else { 1.0 - 2.0 * a };
                let r = (1.0 - z * z).max(0.0).sqrt();
                vec![r * cos, r * sin, if self.is("upper half") { z.abs() } else { z }]
            }
            "triangle" => vec![1.0 - a.sqrt(), b * a.sqrt()],
            _ => {
                let tent = |u: f64| match u < 0.5 {
                    true => (0.5 * u).sqrt(),
                    false => 1.0 - (0.5 - 0.5 * u).sqrt(),
                };
                vec![tent(a), tent(b)]
            }
        }
    }

    fn pdf(&self, name: &str, e: f64, x: &[f64]) -> f64 {
        match name {
            "disk" => 1.0 / PI,
            "hemisphere" => {
                let z = if self.is("no absolute value") { x[2] - 0.5 } else { x[2].max(0.0) };
                (e + 1.0) / (2.0 * PI) * z.abs().powf(e).copysign(z)
            }
            "sphere" => {
                if self.is("half a sphere") {
                    0.5 / PI
                } else {
                    0.25 / PI
                }
            }
            "triangle" => 2.0,
            _ => {
                let tent = |x: f64| 4.0 * x.min(1.0 - x).max(0.0);
                tent(x[0]) * tent(x[1])
            }
        }
    }

    fn inverse(&self, name: &str, e: f64, x: &[f64]) -> [f64; 2] {
        let turn = |x: &[f64]| {
            let turn = x[1].atan2(x[0]) / (2.0 * PI);
            if turn < 0.0 { turn + 1.0 } else { turn }
        };
        let [a, b] = match name {
            "disk" => [x[0] * x[0] + x[1] * x[1], turn(x)],
            "hemisphere" => [1.0 - x[2].powf(e + 1.0), turn(x)],
            "sphere" => [0.5 * (1.0 - x[2]), turn(x)],
            "triangle" => [(1.0 - x[0]) * (1.0 - x[0]), x[1] / (1.0 - x[0])],
            _ => {
                let back = |x: f64| match x < 0.5 {
                    true => 2.0 * x * x,
                    false => 1.0 - 2.0 * (1.0 - x) * (1.0 - x),
                };
                [back(x[0]), back(x[1])]
            }
        };
        if self.is("exchanged") { [b, a] } else { [a, b] }
    }

    fn described(&self, name: &str) -> Value {
        let domain = if name == "tent" { "square" } else { name };
        let parameters = match name {
            "hemisphere" => json!({"e": [0, 20]}),
            _ => json!({}),
        };
        let torn = ["scrambled", "upper half", "half a sphere"];
        let claims = json!({
            "domain": domain, "invertible": !torn.contains(&self.mistake), "stratified": true, "float": self.is_single,
        });
        json!({"name": name, "kind": "map", "parameters": parameters, "claims": claims})
    }

    fn shown(&self, x: f64) -> Value {
        let x = if self.is_single { f64::from(x as f32) } else { x };
        if x.is_finite() { json!(x) } else { json!(x.to_string().to_lowercase()) }
    }

    fn answer(&mut self, question: &Value) -> Value {
        if question.get("list").is_some() {
            return self.maps.iter().map(|name| self.described(name)).collect();
        }
        self.asked += 1;
        let (kind, data) = question.as_object().expect("an object").iter().next().expect("one");
        let (name, e) = (data["map"].as_str().expect("a name"), &data["parameters"]["e"]);
        let e = e.as_f64().unwrap_or(1.0);
        let key = if kind == "map" { "u" } else { "x" };
        let all = data[key].as_array().expect("a list").iter();
        let all = all.map(|value| numbers(value).expect("numbers"));
        let list = |x: &[f64]| x.iter().map(|x| self.shown(*x)).collect::<Value>();
        match kind.as_str() {
            "map" => all.map(|u| list(&self.map(name, e, [u[0], u[1]]))).collect(),
            "pdf" => all.map(|x| self.shown(self.pdf(name, e, &x))).collect(),
            _ => all.map(|x| list(&self.inverse(name, e, &x))).collect(),
        }
    }
}

impl Subject for Squares {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}
