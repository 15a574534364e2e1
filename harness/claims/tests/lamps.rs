//! Lights as people write them, each with the mistakes that people make, as a program that answers.
//!
//! They are written anew, without the library: a rectangle by area, a sphere by area and by the cone that it fills, and
//! a sky. `is("…")` says which mistake is made.

#![allow(clippy::disallowed_methods)] // as people write it: the standard library's functions

use ask::{Reply, Subject, numbers};
use std::f64::consts::PI;

use serde_json::{Value, json};

use super::counted::{Vector as V, dot, minus};

/// The lights that answer.
pub const ALL: [&str; 5] = ["rectangle", "window", "ball", "cone", "sky"];

/// The rectangle's corner and sides, and its normal: it shines down.
const CORNER: V = [-0.5, 2.0, -0.7];
const SIDES: [V; 2] = [[1.2, 0.0, 0.0], [0.0, 0.0, 1.5]];
const DOWN: V = [0.0, -1.0, 0.0];
const AREA: f64 = 1.8;
/// The ball.
const CENTER: V = [0.2, 2.0, 0.1];
const RADIUS: f64 = 0.6;

/// Answers in double precision, or with each number rounded to a single one.
pub struct Lamps {
    pub lights: &'static [&'static str],
    pub mistake: &'static str,
    pub is_single: bool,
    last: V,
}

/// A point of a light as it is seen.
struct At {
    distance: f64,
    normal: V,
    radiance: f64,
    pdf: f64,
}

fn along(p: V, t: f64, w: V) -> V {
    [0, 1, 2].map(|i| p[i] + t * w[i])
}

fn unit(a: V) -> V {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

impl Lamps {
    pub fn new(lights: &'static [&'static str], mistake: &'static str, is_single: bool) -> Self {
        Self { lights, mistake, is_single, last: [0.0; 3] }
    }

    fn is(&self, mistake: &str) -> bool {
        self.mistake == mistake
    }

    /// What the light makes of a point with this normal, of this density of area.
    fn seen(&self, name: &str, p: V, w: V, (x, normal, area): (V, V, f64)) -> At {
        let way = minus(x, p);
        let squared = dot(way, way);
        let mut cosine = -dot(normal, w);
        if name == "window" || self.is("both sides shine") {
            cosine = cosine.abs();
        }
        let mut radiance = if cosine > 0.0 { 2.0 } else { 0.0 };
        if self.is("radiance over d²") {
            radiance /= squared;
        }
        if self.is("radiance with cosine") {
            radiance *= cosine.abs();
        }
        let mut pdf = squared / (area * cosine.abs());
        if self.is("no d²") {
            pdf /= squared;
        }
        if self.is("area of the half") {
            pdf *= 2.0;
        }
        if self.is("negative cosine") {
            pdf = -pdf;
        }
        At { distance: squared.sqrt(), normal, radiance, pdf }
    }

    fn eval(&self, name: &str, p: V, w: V) -> Option<At> {
        match name {
            "sky" => {
                let pdf = 0.25 / PI;
                Some(At { distance: f64::INFINITY, normal: w, radiance: 1.0 + w[1], pdf })
            }
            "ball" | "cone" => {
                let way = minus(p, CENTER);
                let (b, c) = (dot(way, w), dot(way, way) - RADIUS * RADIUS);
                let root = (b * b - c).max(0.0).sqrt();
                let t = if c > 0.0 { -b - root } else { -b + root };
                if b * b < c || t <= 0.0 {
                    return None;
                }
                let x = along(p, t, w);
                let normal = unit(minus(x, CENTER));
                let mut at = self.seen(name, p, w, (x, normal, 4.0 * PI * RADIUS * RADIUS));
                if name == "cone" {
                    at.pdf = 1.0 / self.cone(p)?;
                }
                Some(at)
            }
            _ => {
                let t = (CORNER[1] - p[1]) / w[1];
                if !t.is_finite() || t <= 0.0 {
                    return None;
                }
                let x = along(p, t, w);
                let rest = minus(x, CORNER);
                let [a, b] = SIDES.map(|side| dot(rest, side) / dot(side, side));
                let is_on = |a: f64| (0.0..=1.0).contains(&a);
                let mut at = self.seen(name, p, w, (x, DOWN, AREA));
                if self.is("half of it never sampled") {
                    at.pdf *= if a < 0.5 { 2.0 } else { 0.0 };
                }
                (is_on(a) && is_on(b)).then_some(at)
            }
        }
    }

    /// The solid angle of the ball, outside of it.
    fn cone(&self, p: V) -> Option<f64> {
        let way = minus(CENTER, p);
        let sine2 = RADIUS * RADIUS / dot(way, way);
        let depth = sine2 / (1.0 + (1.0 - sine2).max(0.0).sqrt());
        (sine2 < 1.0).then_some(2.0 * PI * depth)
    }

    fn direction(&self, name: &str, p: V, u: [f64; 4]) -> Option<V> {
        let ball = |u: [f64; 4]| {
            let z = 1.0 - 2.0 * u[0];
            let (r, phi) = ((1.0 - z * z).max(0.0).sqrt(), 2.0 * PI * u[1]);
            [r * phi.cos(), z, r * phi.sin()]
        };
        match name {
            "sky" => Some(ball(u)),
            "ball" => {
                let normal = ball(u);
                let x = along(CENTER, RADIUS, normal);
                // the far side is hidden
                let is_seen = dot(normal, minus(p, x)) > 0.0;
                is_seen.then(|| unit(minus(x, p)))
            }
            "cone" => {
                let axis = unit(minus(CENTER, p));
                let depth = self.cone(p)? / (2.0 * PI);
                let cosine = 1.0 - depth * u[0];
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
                let level = if axis[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
                let s = unit(along(level, -dot(level, axis), axis));
                let t = [
                    axis[1] * s[2] - axis[2] * s[1],
                    axis[2] * s[0] - axis[0] * s[2],
                    axis[0] * s[1] - axis[1] * s[0],
                ];
                let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
                Some(along(along(along([0.0; 3], cosine, axis), sine * cos, s), sine * sin, t))
            }
            _ => {
                let mut u = u;
                if self.is("half of it never sampled") {
                    u[0] *= 0.5;
                }
                if self.is("more in the middle") {
                    u[0] = 0.5 * (u[0] + u[2]);
                }
                let x = along(along(CORNER, u[0], SIDES[0]), u[1], SIDES[1]);
                let way = minus(x, p);
                if self.is("not unit") { Some(way) } else { Some(unit(way)) }
            }
        }
    }

    fn sample(&self, name: &str, p: V, u: [f64; 4]) -> Option<(V, At)> {
        let w = self.direction(name, p, u)?;
        let mut at = self.eval(name, p, unit(w))?;
        if self.is("density of area in the sample") {
            at.pdf = 1.0 / AREA;
        }
        if self.is("cosine in the sample's radiance") {
            at.radiance *= dot(at.normal, w).abs();
        }
        Some((w, at))
    }

    fn described(&self, name: &str) -> Value {
        let mut claims = match name {
            "rectangle" | "ball" => json!({"sampling": "area"}),
            "window" => json!({"sampling": "area", "two_sided": true}),
            "cone" => json!({"sampling": "solid_angle"}),
            _ => json!({"infinite": true, "sampling": "solid_angle"}),
        };
        claims["float"] = self.is_single.into();
        let points = match name {
            "window" => json!([[-2, 0, -2], [2, 4, 2]]),
            _ => json!([[-2, -1, -2], [2, 1.2, 2]]),
        };
        json!({"name": name, "kind": "light", "points": points, "claims": claims})
    }

    fn shown(&self, x: f64) -> Value {
        let x = if self.is_single { f64::from(x as f32) } else { x };
        if x.is_finite() { json!(x) } else { Value::Null }
    }

    fn answer(&mut self, question: &Value) -> Value {
        if question.get("list").is_some() {
            return self.lights.iter().map(|name| self.described(name)).collect();
        }
        let is_eval = question.get("eval").is_some();
        let data = if is_eval { &question["eval"] } else { &question["sample"] };
        let name = data["light"].as_str().expect("a name");
        let vector =
            |value: &Value| -> V { numbers(value).expect("numbers").try_into().expect("three") };
        let here = vector(&data["from"]);
        let p = if self.is("point of the last call") { self.last } else { here };
        self.last = here;
        let list = |key: &str| data[key].as_array().expect("a list").iter();
        let wide = |v: V| -> Value { v.map(|x| self.shown(x)).into_iter().collect() };
        if !is_eval {
            let sample = |u: &Value| {
                let u = numbers(u).expect("numbers").try_into().expect("four");
                self.sample(name, p, u).map_or(Value::Null, |(w, at)| {
                    json!({
                        "wi": wide(w), "distance": self.shown(at.distance),
                        "normal": wide(at.normal), "radiance": self.shown(at.radiance),
                        "pdf": self.shown(at.pdf),
                    })
                })
            };
            return list("u").map(sample).collect();
        }
        let seen: Vec<Option<At>> =
            list("wi").map(|w| self.eval(name, p, unit(vector(w)))).collect();
        let each = |of: &dyn Fn(&At) -> f64, missing: f64| -> Vec<Value> {
            seen.iter().map(|at| self.shown(at.as_ref().map_or(missing, of))).collect()
        };
        let normals: Vec<Value> =
            seen.iter().map(|at| at.as_ref().map_or(Value::Null, |at| wide(at.normal))).collect();
        json!({
            "radiance": each(&|at| at.radiance, 0.0), "pdf": each(&|at| at.pdf, 0.0),
            "distance": each(&|at| at.distance, f64::NAN), "normal": normals,
        })
    }
}

impl Subject for Lamps {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}
