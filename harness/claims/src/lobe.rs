//! A lobe under questions: its value, density and samples, for given parameters.

use ask::{Stop, number, triple};
use groundtruth::math::Vector;
use serde_json::{Value, json};

use crate::asked::{Asked, BATCH, Numbers, color, list, needed};

/// A lobe of the program, with parameters.
pub struct Lobe<'a> {
    /// What is asked.
    pub asked: Asked<'a>,
}

/// The answer of `eval` for one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluated {
    /// Radiance for irradiance, per steradian, without the cosine.
    pub f: [f64; 3],
    /// The density of `sample` there, per steradian.
    pub pdf: f64,
}

/// The answer of `sample` for one list of random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    /// The direction that the light comes from.
    pub wi: Vector,
    /// `f |cos θ| / pdf`.
    pub weight: [f64; 3],
    /// The density there; `None` for a single direction, which has none.
    pub pdf: Option<f64>,
}

impl Lobe<'_> {
    /// The question for the values in these directions.
    pub fn eval_question(&self, wo: Vector, wi: &[Vector]) -> Value {
        let wi: Value = wi.iter().map(|wi| json!(wi.to_array())).collect();
        self.asked.question("eval", [("wo", json!(wo.to_array())), ("wi", wi)])
    }

    /// The question for the samples of these numbers.
    pub fn sample_question(&self, wo: Vector, u: &[Numbers]) -> Value {
        self.asked.question("sample", [("wo", json!(wo.to_array())), ("u", json!(u))])
    }

    /// The values in these directions.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn eval(&mut self, wo: Vector, wi: &[Vector]) -> Result<Vec<Evaluated>, Stop> {
        let questions: Vec<Value> = wi.chunks(BATCH).map(|wi| self.eval_question(wo, wi)).collect();
        let mut all = Vec::with_capacity(wi.len());
        for (answer, wi) in self.asked.answers(&questions)?.iter().zip(wi.chunks(BATCH)) {
            let list = |key: &str| list(&answer[key], &format!("`{key}`"), wi.len());
            for (f, pdf) in list("f")?.iter().zip(list("pdf")?) {
                let (f, pdf) = (needed(color(f), "f", f)?, needed(number(pdf), "pdf", pdf)?);
                all.push(Evaluated { f, pdf });
            }
        }
        Ok(all)
    }

    /// The samples of these numbers; `None` where nothing is scattered.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn sample(&mut self, wo: Vector, u: &[Numbers]) -> Result<Vec<Option<Sampled>>, Stop> {
        let questions: Vec<Value> = u.chunks(BATCH).map(|u| self.sample_question(wo, u)).collect();
        let mut all = Vec::with_capacity(u.len());
        for (answer, u) in self.asked.answers(&questions)?.iter().zip(u.chunks(BATCH)) {
            for sample in list(answer, "the answer to `sample`", u.len())? {
                all.push(if sample.is_null() { None } else { Some(sampled(sample)?) });
            }
        }
        Ok(all)
    }
}

fn sampled(sample: &Value) -> Result<Sampled, Stop> {
    let wi = needed(triple(&sample["wi"]), "wi", &sample["wi"])?;
    let weight = needed(color(&sample["weight"]), "weight", &sample["weight"])?;
    let pdf = match &sample["pdf"] {
        Value::Null => None,
        pdf => Some(needed(number(pdf), "pdf", pdf)?),
    };
    Ok(Sampled { wi: wi.into(), weight, pdf })
}
