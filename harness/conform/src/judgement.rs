//! What a judge says of an answer.

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
            Self::Careful => exact::backward_error::ALLOWED,
            Self::Book => 1e-4 / groundtruth::math::UNIT_ROUNDOFF,
        }
    }

    /// An answer that a smaller relative change of the input turns is not judged.
    pub fn margin(self) -> f64 {
        match self {
            Self::Careful => exact::backward_error::MIN_MARGIN,
            Self::Book => 1e-5,
        }
    }
}

/// A judge's verdict on one case.
#[derive(Clone, Debug)]
pub enum Judgement {
    /// Right, with the largest error, in u·cond.
    Right(f64),
    /// Right by a convention of the book that is not ours: by the profile *book* only.
    ByTheBook(&'static Mistake),
    /// Right as far as it is there: this field is needed, and left out.
    Lacks(String),
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
        let (clues, beside, ratio, theirs) = (Vec::new(), Vec::new(), None, Vec::new());
        Self::Wrong(Box::new(Wrong { symptom, error, expected, clues, beside, ratio, theirs }))
    }

    /// The same, and if it is wrong, these mistakes give the answer, too.
    #[must_use]
    pub fn with(mut self, clues: impl IntoIterator<Item = &'static Mistake>) -> Self {
        if let Self::Wrong(wrong) = &mut self {
            wrong.clues.extend(clues);
        }
        self
    }

    /// The same, and if it is wrong: these mistakes give this answer, too, which is nothing (`null`, no hit, not blocked).
    #[must_use]
    pub fn beside(mut self, clues: impl IntoIterator<Item = &'static Mistake>) -> Self {
        if let Self::Wrong(wrong) = &mut self {
            wrong.beside.extend(clues);
        }
        self
    }

    /// Whether the answer is wrong.
    pub fn is_wrong(&self) -> bool {
        matches!(self, Self::Wrong(_))
    }

    /// Whether the answer is right as far as it is there, or by a convention of the book.
    pub fn is_right(&self) -> bool {
        matches!(self, Self::Right(_) | Self::ByTheBook(_) | Self::Lacks(_))
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
    /// Mistakes that give this answer, which is nothing, as with many mistakes: they count where other answers have them as clues.
    pub beside: Vec<&'static Mistake>,
    /// The ratio of the answer to the right one, where it is one number.
    pub ratio: Option<f64>,
    /// The wrong numbers, where they are some.
    pub theirs: Vec<f64>,
}

/// The truth about a list of checks: the first that fails, or the largest error; by the book or without a field, if one of
/// them is.
pub fn first_wrong(judgements: impl IntoIterator<Item = Judgement>) -> Judgement {
    let mut worst = 0.0_f64;
    let mut other = None;
    for judgement in judgements {
        match judgement {
            Judgement::Right(error) => worst = worst.max(error),
            Judgement::ByTheBook(_) | Judgement::Lacks(_) => other = other.or(Some(judgement)),
            failed => return failed,
        }
    }
    other.unwrap_or(Judgement::Right(worst))
}
