//! What a program says of a subject: its kind, its parameters, and what it claims.

use ask::Draw;
use std::collections::BTreeMap;

use groundtruth::printable;
use libm::{exp, log};
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::domain::Domain;

/// What a subject is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A lobe: BRDF, BTDF or BSDF.
    #[default]
    Lobe,
    /// A light with some extent.
    Light,
    /// A map from the unit square.
    Map,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Lobe, Self::Light, Self::Map];

    /// Its name in lists and questions.
    pub fn word(self) -> &'static str {
        match self {
            Self::Lobe => "lobe",
            Self::Light => "light",
            Self::Map => "map",
        }
    }

    /// The name in questions of what a case is seen from.
    pub fn seen_from(self) -> &'static str {
        match self {
            Self::Lobe => "wo",
            Self::Light => "from",
            Self::Map => "",
        }
    }
}

/// A subject as the program lists it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Its name, which questions repeat.
    pub name: String,
    /// What it is.
    #[serde(default)]
    pub kind: Kind,
    /// From where the parameters of cases are drawn.
    #[serde(default)]
    pub parameters: BTreeMap<String, Values>,
    /// Two corners of a box: a light is asked from points in it.
    #[serde(default)]
    pub points: Option<[[f64; 3]; 2]>,
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

/// What a subject claims. A claim that is left out is not held against it.
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
    /// Both sides of a light shine.
    pub two_sided: bool,
    /// A light is infinitely far away in all directions.
    pub infinite: bool,
    /// The measure in which the points of a light are drawn alike from everywhere.
    pub sampling: Option<SamplingClaim>,
    /// What a map covers.
    pub domain: Option<Domain>,
    /// A map has an `inverse`.
    pub invertible: bool,
    /// Stratified points stay stratified in a map.
    pub stratified: bool,
}

/// How the points of a light are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SamplingClaim {
    /// With a density of area that does not depend on the point that is lit.
    Area,
    /// Uniformly in solid angle.
    SolidAngle,
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

/// What the values of a parameter may be.
const VALUES: &str = "write a number, [low, high], or {\"one_of\": […]}";
/// The most characters of a name: each question repeats it.
const LONGEST_NAME: usize = 1000;

impl Description {
    /// The entry of this index of a program's list.
    ///
    /// # Errors
    /// Names the entry and the parameter, and says what is wrong.
    pub fn read(index: usize, entry: &Value) -> Result<Self, String> {
        let name = entry["name"].as_str().map(|name| format!(" (`{}`)", printable::name(name)));
        let place = format!("entry {}{}", index + 1, name.unwrap_or_default());
        let refused = |problem: String| Err(format!("{place}: {problem}"));
        for (name, values) in entry["parameters"].as_object().into_iter().flatten() {
            if Values::deserialize(values).is_err() {
                let (name, values) = (printable::name(name), printable::name(&values.to_string()));
                return refused(format!("the parameter `{name}` is {values}: {VALUES}"));
            }
        }
        match Self::deserialize(entry) {
            Err(error) => refused(error.to_string()),
            Ok(found) => found.problem().map_or(Ok(found), refused),
        }
    }

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
        let long = |name: &&String| name.chars().nth(LONGEST_NAME).is_some();
        if let Some(name) = self.parameters.keys().chain([&self.name]).find(long) {
            let (name, length) = (printable::name(name), name.chars().count());
            return Some(format!(
                "the name `{name}` has {length} characters; at most {LONGEST_NAME} fit"
            ));
        }
        for (name, values) in &self.parameters {
            let is_good = match values {
                Values::Number(number) => number.is_finite(),
                Values::Range([low, high]) => low.is_finite() && high.is_finite() && low <= high,
                Values::Choices { one_of } => !one_of.is_empty(),
            };
            if !is_good {
                let name = printable::name(name);
                return Some(format!("the values of the parameter `{name}` are none: {VALUES}"));
            }
        }
        self.problem_of_kind().or_else(|| self.problem_of_index())
    }

    /// A claim that is none of its kind, or one that it needs.
    fn problem_of_kind(&self) -> Option<String> {
        let Claims { two_sided, infinite, sampling, domain, invertible, stratified, .. } =
            self.claims;
        let of_light = two_sided || infinite || sampling.is_some();
        let of_map = domain.is_some() || invertible || stratified;
        let is_box = |[low, high]: [[f64; 3]; 2]| {
            low.iter().zip(&high).all(|(a, b)| a.is_finite() && b.is_finite() && a <= b)
        };
        let problem = match self.kind {
            Kind::Light if !self.points.is_some_and(is_box) => {
                "a light needs `points`, the lowest and the highest corner of a box: it is asked from points in it"
            }
            Kind::Map if domain.is_none() => {
                "a map claims its `domain`: square, disk, triangle, hemisphere or sphere"
            }
            Kind::Lobe | Kind::Map if of_light => {
                "two_sided, infinite and sampling are claims of lights"
            }
            Kind::Lobe | Kind::Light if of_map => {
                "domain, invertible and stratified are claims of maps"
            }
            _ => return None,
        };
        Some(problem.to_owned())
    }

    fn problem_of_index(&self) -> Option<String> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        match self.claims.eta.as_ref()? {
            Index::Number(eta) if is_positive(*eta) => None,
            Index::Number(eta) => Some(format!("claims.eta is {eta}, but an index is positive")),
            Index::Parameter(name) => {
                let shown = printable::name(name);
                match self.parameters.get(name) {
                    Some(Values::Number(low) | Values::Range([low, _])) if is_positive(*low) => {
                        None
                    }
                    Some(_) => {
                        Some(format!("claims.eta names `{shown}`, which needs positive numbers"))
                    }
                    None => Some(format!("claims.eta names `{shown}`, which is no parameter")),
                }
            }
        }
    }
}

/// A point in a box, in coordinates of few digits.
pub fn point_within([low, high]: [[f64; 3]; 2], draw: &mut Draw) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let drawn = between(low[axis], high[axis], draw);
        rounded(drawn).clamp(low[axis], high[axis])
    })
}

/// A number of few digits between two ends.
fn within(low: f64, high: f64, draw: &mut Draw) -> f64 {
    let drawn = if low > 0.0 && high >= 10.0 * low {
        exp(draw.between(log(low), log(high)))
    } else {
        between(low, high, draw)
    };
    rounded(drawn)
}

/// A number between two ends, whose difference need not be one.
fn between(low: f64, high: f64, draw: &mut Draw) -> f64 {
    2.0 * draw.between(0.5 * low, 0.5 * high)
}

/// The number with few digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.*e}", DIGITS - 1).parse().expect("a printed number can be read")
}
