//! What a program says of a lobe: its parameters, and what it claims.

use std::collections::BTreeMap;

use exact::Draw;
use libm::{exp, log};
use serde::Deserialize;
use serde_json::{Map, Value};

/// A lobe as the program lists it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Its name, which questions repeat.
    pub name: String,
    /// From where the parameters of cases are drawn.
    #[serde(default)]
    pub parameters: BTreeMap<String, Values>,
    /// What it claims.
    #[serde(default)]
    pub claims: Claims,
}

/// The values of a parameter.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Values {
    /// Always the same number.
    Number(f64),
    /// From the low to the high end; by their logarithms if the high one is at least ten times the low one.
    Range([f64; 2]),
    /// One of these.
    Choices {
        /// Any values of JSON.
        one_of: Vec<Value>,
    },
}

/// What a lobe claims. A claim that is left out is not held against it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Claims {
    /// `f(wo, wi) = f(wi, wo)`; across a boundary, divided by the square of the index on the side of the first.
    pub reciprocal: bool,
    /// All light is scattered: the albedo is 1.
    pub lossless: bool,
    /// A turn of both directions about the normal changes nothing.
    pub isotropic: bool,
    /// On which side of the surface light leaves, seen from the viewer.
    pub sides: Sides,
    /// Whether viewers below the surface are served, too.
    pub from_below: bool,
    /// The index of refraction below over the one above: a number, or the name of a parameter.
    pub eta: Option<Index>,
    /// All numbers are of single precision.
    pub float: bool,
    /// All samples are of single directions, for which `eval` has no value.
    pub delta: bool,
    /// `sample` draws numbers of its own and does not look at `u`.
    pub random: bool,
}

/// Where the light comes from that a viewer sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sides {
    /// From the viewer's side.
    #[default]
    Reflects,
    /// From the other side.
    Transmits,
    /// From both.
    Both,
}

/// An index of refraction.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Index {
    /// Always the same.
    Number(f64),
    /// The value of the parameter of this name.
    Parameter(String),
}

/// How many significant digits drawn parameters have: they are read and typed again.
const DIGITS: usize = 2;

impl Description {
    /// Parameters of a case: the first two cases have the low and the high ends.
    pub fn parameters(&self, case: usize, draw: &mut Draw) -> Map<String, Value> {
        let value = |values: &Values, draw: &mut Draw| match values {
            Values::Number(number) => Value::from(*number),
            Values::Range([low, high]) => match case {
                0 => Value::from(*low),
                1 => Value::from(*high),
                _ => Value::from(within(*low, *high, draw).clamp(*low, *high)),
            },
            Values::Choices { one_of } => match case {
                0 => one_of.first().cloned().unwrap_or_default(),
                _ => one_of.get(draw.below(one_of.len().max(1))).cloned().unwrap_or_default(),
            },
        };
        self.parameters.iter().map(|(name, values)| (name.clone(), value(values, draw))).collect()
    }

    /// The index below over the one above, of a case with these parameters; 1 if there is none.
    pub fn eta(&self, parameters: &Map<String, Value>) -> f64 {
        match &self.claims.eta {
            None => 1.0,
            Some(Index::Number(eta)) => *eta,
            Some(Index::Parameter(name)) => parameters[name].as_f64().expect("it was checked"),
        }
    }

    /// The relative rounding of its numbers.
    pub fn rounding(&self) -> f64 {
        if self.claims.float { f64::from(f32::EPSILON) / 2.0 } else { f64::EPSILON / 2.0 }
    }

    /// What is wrong with it, if anything is.
    pub fn problem(&self) -> Option<String> {
        for (name, values) in &self.parameters {
            let is_good = match values {
                Values::Number(number) => number.is_finite(),
                Values::Range([low, high]) => low.is_finite() && high.is_finite() && low <= high,
                Values::Choices { one_of } => !one_of.is_empty(),
            };
            if !is_good {
                return Some(format!(
                    "the values of the parameter `{name}` are none: write a number, [low, high], or \
                     {{\"one_of\": […]}}"
                ));
            }
        }
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        match self.claims.eta.as_ref()? {
            Index::Number(eta) if is_positive(*eta) => None,
            Index::Number(eta) => Some(format!("claims.eta is {eta}, but an index is positive")),
            Index::Parameter(name) => match self.parameters.get(name) {
                Some(Values::Number(low) | Values::Range([low, _])) if is_positive(*low) => None,
                Some(_) => Some(format!("claims.eta names `{name}`, which needs positive numbers")),
                None => Some(format!("claims.eta names `{name}`, which is no parameter")),
            },
        }
    }
}

/// A number of few digits between two ends.
fn within(low: f64, high: f64, draw: &mut Draw) -> f64 {
    let drawn = if low > 0.0 && high >= 10.0 * low {
        exp(draw.between(log(low), log(high)))
    } else {
        draw.between(low, high)
    };
    let text = format!("{drawn:.*e}", DIGITS - 1);
    text.parse().expect("a printed number can be read")
}
