//! The lobes of [`scattering`](super::scattering) as a program that answers.

use ask::{Reply, Subject, numbers};
use serde_json::{Value, json};

use super::scattering::{double, single};

/// Answers in single or double precision, with one mistake in all lobes that can have it.
pub struct Adapter {
    pub is_single: bool,
    pub mistake: &'static str,
    /// The lobes that it lists.
    pub lobes: &'static [&'static str],
    last: Value,
}

pub const ALL: [&str; 7] =
    ["lambert", "oren_nayar", "conductor", "rough_dielectric", "layered", "mirror", "glass"];

impl Adapter {
    pub fn new(lobes: &'static [&'static str], mistake: &'static str, is_single: bool) -> Self {
        Self { is_single, mistake, lobes, last: Value::Null }
    }

    fn described(&self, name: &str) -> Value {
        let roughness = json!([0.001, 1.0]);
        let (parameters, mut claims) = match name {
            "lambert" => {
                (json!({}), json!({"isotropic": true, "reciprocal": true, "from_below": true}))
            }
            "oren_nayar" => {
                let claims = json!({"isotropic": true, "reciprocal": true, "from_below": true});
                (json!({"x": [0.0, 1.5]}), claims)
            }
            "conductor" => (json!({"x": roughness, "y": roughness}), json!({"reciprocal": true})),
            "rough_dielectric" => (
                json!({"x": roughness, "eta": [1.1, 2.4]}),
                json!({"isotropic": true, "reciprocal": true, "sides": "both", "eta": "eta",
                       "from_below": true}),
            ),
            "layered" => {
                let claims = json!({"isotropic": true, "reciprocal": true});
                (json!({"x": roughness, "eta": [1.1, 2.4]}), claims)
            }
            "mirror" => (json!({}), json!({"delta": true, "from_below": true})),
            _ => (
                json!({"eta": [1.1, 2.4]}),
                json!({"delta": true, "sides": "both", "eta": "eta", "lossless": true,
                       "from_below": true}),
            ),
        };
        claims["float"] = self.is_single.into();
        json!({"name": name, "parameters": parameters, "claims": claims})
    }

    fn answer(&mut self, question: &Value) -> Value {
        if question.get("list").is_some() {
            return self.lobes.iter().map(|name| self.described(name)).collect();
        }
        let is_eval = question.get("eval").is_some();
        let data = if is_eval { &question["eval"] } else { &question["sample"] };
        let mut wo = data["wo"].clone();
        if self.mistake == "viewer of the last call" && self.last.is_array() {
            wo = self.last.clone();
        }
        self.last = data["wo"].clone();
        let number = |key: &str, missing: f64| data["parameters"][key].as_f64().unwrap_or(missing);
        let x = number("x", 0.5);
        let (roughness, eta) = ([x, number("y", x)], number("eta", 1.5));
        let list = |key: &str| data[key].as_array().expect("a list").iter();
        macro_rules! answered {
            ($module:ident, $F:ident) => {{
                let name = data["lobe"].as_str().expect("a name").to_owned();
                let (roughness, eta) = (roughness.map(|x| x as $F), eta as $F);
                let lobe = $module::Lobe { name, roughness, eta, mistake: self.mistake };
                let vector = |value: &Value| -> $module::V {
                    let v = numbers(value).expect("numbers");
                    [0, 1, 2].map(|i| v[i] as $F)
                };
                let wide = |v: [$F; 3]| v.map(f64::from);
                let wo = vector(&wo);
                if is_eval {
                    let values: Vec<_> = list("wi").map(|wi| lobe.eval(wo, vector(wi))).collect();
                    let f: Vec<_> = values.iter().map(|it| json!(wide(it.0).map(shown))).collect();
                    let pdf: Vec<_> = values.iter().map(|it| shown(f64::from(it.1))).collect();
                    json!({"f": f, "pdf": pdf})
                } else {
                    let drawn = list("u").map(|u| {
                        let u = numbers(u).expect("numbers");
                        lobe.sample(wo, [0, 1, 2, 3].map(|i| u[i] as $F))
                    });
                    let sample = |(wi, weight, pdf): ([$F; 3], [$F; 3], Option<$F>)| {
                        let pdf = pdf.map(|pdf| shown(f64::from(pdf)));
                        json!({"wi": wide(wi), "weight": wide(weight).map(shown), "pdf": pdf})
                    };
                    drawn.map(|it| it.map_or(Value::Null, sample)).collect()
                }
            }};
        }
        if self.is_single { answered!(single, f32) } else { answered!(double, f64) }
    }
}

/// A number as the protocol writes it.
fn shown(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { json!(x.to_string()) }
}

impl Subject for Adapter {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}
