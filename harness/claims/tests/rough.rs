//! A rough dielectric as people write it, in single and in double precision, as a program that answers.
//!
//! It is written after the papers (Walter et al. 2007; Heitz 2014, 2018) and not after the library. Directions are in the local
//! frame.

use ask::{Reply, Subject, numbers};
use serde_json::{Value, json};

/// Written twice by one macro: for `f32` and `f64`.
macro_rules! rough {
    ($module:ident, $F:ident) => {
        #[allow(clippy::disallowed_methods)] // as people write it: the standard library's functions
        mod $module {
            use std::$F::consts::PI;

            pub type V = [$F; 3];

            #[derive(Clone, Copy)]
            pub struct Lobe {
                pub roughness: [$F; 2],
                pub eta: $F,
                /// Whether f lacks 1/η².
                pub lacks: bool,
            }

            fn dot(a: V, b: V) -> $F {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            fn scaled(a: V, by: $F) -> V {
                a.map(|x| x * by)
            }

            fn sum(a: V, b: V) -> V {
                [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
            }

            fn cross(a: V, b: V) -> V {
                let of = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
                [of(1, 2), of(2, 0), of(0, 1)]
            }

            fn unit(a: V) -> V {
                let length = dot(a, a).sqrt();
                if length > 0.0 { scaled(a, 1.0 / length) } else { [0.0, 0.0, 1.0] }
            }

            fn below(a: V) -> V {
                [a[0], a[1], -a[2]]
            }

            /// Fresnel's equations, for η of the far side over the near one.
            fn fresnel(cosine: $F, eta: $F) -> $F {
                let sine2 = (1.0 - cosine * cosine).max(0.0) / (eta * eta);
                if sine2 >= 1.0 {
                    return 1.0;
                }
                let far = (1.0 - sine2).sqrt();
                let s = (cosine - eta * far) / (cosine + eta * far);
                let p = (eta * cosine - far) / (eta * cosine + far);
                0.5 * (s * s + p * p)
            }

            impl Lobe {
                fn d(&self, h: V) -> $F {
                    let [ax, ay] = self.roughness;
                    let inner = (h[0] / ax) * (h[0] / ax) + (h[1] / ay) * (h[1] / ay) + h[2] * h[2];
                    1.0 / (PI * ax * ay * inner * inner)
                }

                fn lambda(&self, w: V) -> $F {
                    let [ax, ay] = self.roughness;
                    let slope = (ax * w[0] * ax * w[0] + ay * w[1] * ay * w[1]) / (w[2] * w[2]);
                    0.5 * ((1.0 + slope).sqrt() - 1.0)
                }

                /// The density of visible normals.
                fn visible(&self, wo: V, h: V) -> $F {
                    dot(wo, h).max(0.0) * self.d(h) / (wo[2].abs() * (1.0 + self.lambda(wo)))
                }

                fn sample_visible(&self, wo: V, u: [$F; 2]) -> V {
                    let [ax, ay] = self.roughness;
                    let v = unit([ax * wo[0], ay * wo[1], wo[2]]);
                    let flat = v[0] * v[0] + v[1] * v[1];
                    let t1 = match flat > 0.0 {
                        true => scaled([-v[1], v[0], 0.0], 1.0 / flat.sqrt()),
                        false => [1.0, 0.0, 0.0],
                    };
                    let (r, phi) = (u[0].sqrt(), 2.0 * PI * u[1]);
                    let (a, s) = (r * phi.cos(), 0.5 * (1.0 + v[2]));
                    let b = (1.0 - s) * (1.0 - a * a).max(0.0).sqrt() + s * r * phi.sin();
                    let c = (1.0 - a * a - b * b).max(0.0).sqrt();
                    let n = sum(sum(scaled(t1, a), scaled(cross(v, t1), b)), scaled(v, c));
                    unit([ax * n[0], ay * n[1], n[2].max(0.0)])
                }

                /// From the other side, mirrored.
                fn turned(self) -> Self {
                    Self { eta: 1.0 / self.eta, ..self }
                }

                /// f and pdf.
                pub fn eval(&self, wo: V, wi: V) -> ([$F; 3], $F) {
                    if wo[2] < 0.0 {
                        return self.turned().eval(below(wo), below(wi));
                    }
                    let (eta, is_reflected) = (self.eta, wi[2] > 0.0);
                    let h = unit(sum(wo, if is_reflected { wi } else { scaled(wi, eta) }));
                    let h = if h[2] < 0.0 { scaled(h, -1.0) } else { h };
                    let (co, ci) = (dot(wo, h), dot(wi, h));
                    if co <= 0.0 || ci * wi[2] <= 0.0 || wi[2] == 0.0 || wo[2] == 0.0 {
                        return ([0.0; 3], 0.0);
                    }
                    let (reflected, visible) = (fresnel(co, eta), self.visible(wo, h));
                    let dg = self.d(h) / (1.0 + self.lambda(wo) + self.lambda(wi));
                    if is_reflected {
                        let f = dg * reflected / (4.0 * wo[2] * wi[2]);
                        return ([f; 3], visible / (4.0 * co) * reflected);
                    }
                    let half = (ci + co / eta) * (ci + co / eta);
                    let f = (dg * (1.0 - reflected) * ci * co / (half * wi[2] * wo[2])).abs();
                    let f = if self.lacks { f } else { f / (eta * eta) };
                    ([f; 3], visible * ci.abs() / half * (1.0 - reflected))
                }

                /// A direction, its weight and its pdf.
                pub fn sample(&self, wo: V, u: [$F; 3]) -> Option<(V, [$F; 3], $F)> {
                    if wo[2] < 0.0 {
                        let (wi, weight, pdf) = self.turned().sample(below(wo), u)?;
                        return Some((below(wi), weight, pdf));
                    }
                    let h = self.sample_visible(wo, [u[0], u[1]]);
                    let co = dot(wo, h);
                    let is_reflected = u[2] < fresnel(co, self.eta);
                    let sine2 = (1.0 - co * co).max(0.0) / (self.eta * self.eta);
                    let wi = match is_reflected {
                        true => sum(scaled(h, 2.0 * co), scaled(wo, -1.0)),
                        false => {
                            let far = (1.0 - sine2).max(0.0).sqrt();
                            sum(scaled(wo, -1.0 / self.eta), scaled(h, co / self.eta - far))
                        }
                    };
                    let (f, pdf) = self.eval(wo, wi);
                    let is_drawn = (wi[2] > 0.0) == is_reflected && pdf > 0.0;
                    is_drawn.then(|| (wi, f.map(|f| f * wi[2].abs() / pdf), pdf))
                }
            }
        }
    };
}

rough!(single, f32);
rough!(double, f64);

/// Answers in single or double precision.
pub struct Rough {
    pub is_single: bool,
    /// Whether f lacks 1/η².
    pub lacks: bool,
}

/// A number as the protocol writes it.
fn shown(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { json!(x.to_string()) }
}

impl Rough {
    fn answer(&self, question: &Value) -> Value {
        if question.get("list").is_some() {
            let parameters = json!({"x": [0.001, 1.0], "y": [0.001, 1.0], "eta": [1.1, 2.4]});
            let claims = json!({
                "reciprocal": true, "sides": "both", "eta": "eta", "from_below": true, "float": self.is_single,
            });
            return json!([{"name": "rough", "parameters": parameters, "claims": claims}]);
        }
        let data = question.get("eval").unwrap_or(&question["sample"]);
        let number = |key: &str| data["parameters"][key].as_f64().expect("a parameter");
        macro_rules! answered {
            ($module:ident, $F:ident) => {{
                let vector = |value: &Value| -> $module::V {
                    let v = numbers(value).expect("numbers");
                    [0, 1, 2].map(|i| v[i] as $F)
                };
                let roughness = ["x", "y"].map(|key| number(key) as $F);
                let lobe = $module::Lobe { roughness, eta: number("eta") as $F, lacks: self.lacks };
                let wide = |v: [$F; 3]| v.map(|x| shown(f64::from(x)));
                let (wo, list) = (vector(&data["wo"]), |key: &str| data[key].as_array());
                if let Some(wi) = list("wi") {
                    let values = wi.iter().map(|wi| lobe.eval(wo, vector(wi)));
                    let (f, pdf): (Vec<_>, Vec<_>) =
                        values.map(|(f, pdf)| (wide(f), shown(f64::from(pdf)))).unzip();
                    return json!({"f": f, "pdf": pdf});
                }
                let drawn = list("u").expect("a list").iter().map(|u| lobe.sample(wo, vector(u)));
                let sample = |(wi, weight, pdf): ([$F; 3], [$F; 3], $F)| json!({"wi": wide(wi), "weight": wide(weight), "pdf": shown(f64::from(pdf))});
                drawn.map(|it| it.map_or(Value::Null, sample)).collect()
            }};
        }
        if self.is_single { answered!(single, f32) } else { answered!(double, f64) }
    }
}

impl Subject for Rough {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}
