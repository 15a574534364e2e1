//! What a judge says of an answer.

use serde_json::Value;

use super::mistakes::Mistake;

/// How exact an answer has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Double precision, and the hard families: errors of at most 100 u·cond, as if the input had been wrong by
    /// 100 roundings.
    Careful,
    /// Single precision, and a constant ε: errors of at most 10⁻⁴·max(cond, |value|); ordinary families only.
    Book,
}

impl Profile {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Careful, Self::Book];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Careful => "careful",
            Self::Book => "book",
        }
    }

    /// The relative error of the input that an answer may look like, in double roundings u: the error allowed in
    /// an answer is this many u·cond.
    pub fn allowed(self) -> f64 {
        match self {
            Self::Careful => crate::verify::backward_error::ALLOWED,
            Self::Book => 1e-4 / groundtruth::math::UNIT_ROUNDOFF,
        }
    }

    /// An answer that a smaller relative change of the input turns is not judged.
    pub fn margin(self) -> f64 {
        match self {
            Self::Careful => crate::verify::backward_error::MIN_MARGIN,
            Self::Book => 1e-5,
        }
    }
}

/// A judge's verdict on one case.
#[derive(Clone, Debug)]
pub enum Judgement {
    /// Right, with the largest error, in u·cond.
    Right(f64),
    /// A tiny change of the question changes the answer, so that either is right.
    Undecided,
    /// Wrong.
    Wrong(Box<Wrong>),
}

impl Judgement {
    /// Wrong in this respect.
    pub fn wrong(symptom: &str, error: f64, expected: impl Into<String>) -> Self {
        let expected = expected.into();
        let symptom = symptom.to_owned();
        Self::Wrong(Box::new(Wrong { symptom, error, expected, clues: Vec::new(), ratio: None }))
    }
}

/// What is wrong with an answer.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// What differs, as `t` or `normal`; it stays the same when the question is made smaller.
    pub symptom: String,
    /// How far off, in u·cond; infinite where nothing can be measured.
    pub error: f64,
    /// What is right.
    pub expected: String,
    /// The mistakes that give exactly this answer.
    pub clues: Vec<&'static Mistake>,
    /// The ratio of the answer to the right one, where it is one number.
    pub ratio: Option<f64>,
}

/// The truth about a list of checks: the first that fails, or the largest error.
pub fn first_wrong(judgements: impl IntoIterator<Item = Judgement>) -> Judgement {
    let mut worst = 0.0_f64;
    for judgement in judgements {
        match judgement {
            Judgement::Right(error) => worst = worst.max(error),
            other => return other,
        }
    }
    Judgement::Right(worst)
}

/// A finite number of JSON, or an infinity by name.
pub fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(name) => match name.as_str() {
            "inf" => Some(f64::INFINITY),
            "-inf" => Some(f64::NEG_INFINITY),
            "nan" => Some(f64::NAN),
            _ => None,
        },
        _ => None,
    }
}

/// The numbers of a list.
pub fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(number).collect()
}

/// Three numbers.
pub fn triple(value: &Value) -> Option<[f64; 3]> {
    numbers(value)?.try_into().ok()
}
