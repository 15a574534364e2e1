//! A lobe under questions: its value, density and samples, for given parameters.

use conform::{Reply, Subject, number, numbers, triple};
use groundtruth::math::Vector;
use serde_json::{Map, Value, json};

/// Directions in one question.
const BATCH: usize = 1000;

/// Random numbers that a sample may use: two for the direction, two more to choose and to terminate.
pub type Numbers = [f64; 4];

/// A lobe of the program, with parameters.
pub struct Lobe<'a> {
    subject: &'a mut dyn Subject,
    /// The name and the parameters, as they stand in each question.
    pub of: Value,
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

/// Why there is no answer to be judged.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// The program does not do this.
    Unsupported(String),
    /// It refuses, or its answer is not of the form that is needed.
    Refused(String),
    /// It hung, died, or wrote what nobody can read.
    Fault(String),
    /// The run was interrupted.
    Interrupted,
}

impl Trouble {
    /// The program's words, or what happened.
    pub fn text(&self) -> &str {
        match self {
            Self::Unsupported(text) | Self::Refused(text) | Self::Fault(text) => text,
            Self::Interrupted => "interrupted",
        }
    }
}

impl<'a> Lobe<'a> {
    /// The lobe of this name with these parameters.
    pub fn new(subject: &'a mut dyn Subject, name: &str, parameters: Map<String, Value>) -> Self {
        Self { subject, of: json!({"lobe": name, "parameters": parameters}) }
    }

    /// The question for the values in these directions.
    pub fn eval_question(&self, wo: Vector, wi: &[Vector]) -> Value {
        let mut data = self.of.clone();
        data["wo"] = json!(wo.to_array());
        data["wi"] = wi.iter().map(|wi| json!(wi.to_array())).collect();
        json!({"eval": data})
    }

    /// The question for the samples of these numbers.
    pub fn sample_question(&self, wo: Vector, u: &[Numbers]) -> Value {
        let mut data = self.of.clone();
        data["wo"] = json!(wo.to_array());
        data["u"] = json!(u);
        json!({"sample": data})
    }

    /// The values in these directions.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn eval(&mut self, wo: Vector, wi: &[Vector]) -> Result<Vec<Evaluated>, Trouble> {
        let questions: Vec<Value> = wi.chunks(BATCH).map(|wi| self.eval_question(wo, wi)).collect();
        let mut all = Vec::with_capacity(wi.len());
        for (answer, wi) in self.answers(&questions)?.iter().zip(wi.chunks(BATCH)) {
            let list = |key: &str| match answer.get(key).and_then(Value::as_array) {
                Some(list) if list.len() == wi.len() => Ok(list),
                _ => Err(Trouble::Refused(format!("`{key}` is no list of {} values", wi.len()))),
            };
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
    pub fn sample(&mut self, wo: Vector, u: &[Numbers]) -> Result<Vec<Option<Sampled>>, Trouble> {
        let questions: Vec<Value> = u.chunks(BATCH).map(|u| self.sample_question(wo, u)).collect();
        let mut all = Vec::with_capacity(u.len());
        for (answer, u) in self.answers(&questions)?.iter().zip(u.chunks(BATCH)) {
            let Some(list) = answer.as_array().filter(|list| list.len() == u.len()) else {
                let problem = format!("the answer to `sample` is no list of {} samples", u.len());
                return Err(Trouble::Refused(problem));
            };
            for sample in list {
                all.push(if sample.is_null() { None } else { Some(sampled(sample)?) });
            }
        }
        Ok(all)
    }

    fn answers(&mut self, questions: &[Value]) -> Result<Vec<Value>, Trouble> {
        let replies = self.subject.ask(questions).into_iter();
        replies.map(answer).collect()
    }
}

/// The answer of a reply.
///
/// # Errors
/// Says why there is none.
pub fn answer(reply: Reply) -> Result<Value, Trouble> {
    match reply {
        Reply::Answer(value) => Ok(value),
        Reply::Refused(why) => Err(Trouble::Refused(why)),
        Reply::Unsupported(why) => Err(Trouble::Unsupported(why)),
        Reply::Fault(fault) => Err(Trouble::Fault(fault.text().to_owned())),
        Reply::NotAsked => Err(Trouble::Interrupted),
    }
}

fn sampled(sample: &Value) -> Result<Sampled, Trouble> {
    let wi = needed(triple(&sample["wi"]), "wi", &sample["wi"])?;
    let weight = needed(color(&sample["weight"]), "weight", &sample["weight"])?;
    let pdf = match &sample["pdf"] {
        Value::Null => None,
        pdf => Some(needed(number(pdf), "pdf", pdf)?),
    };
    Ok(Sampled { wi: wi.into(), weight, pdf })
}

/// Three channels, or one number for all of them.
fn color(value: &Value) -> Option<[f64; 3]> {
    number(value).map(|x| [x; 3]).or_else(|| numbers(value)?.try_into().ok())
}

fn needed<T>(found: Option<T>, key: &str, value: &Value) -> Result<T, Trouble> {
    found.ok_or_else(|| {
        Trouble::Refused(format!("`{key}` is {value}, which is no number of its form"))
    })
}
