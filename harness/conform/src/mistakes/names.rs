//! The few mistakes that explain most wrong answers of a family.

use serde_json::Value;

use super::super::judgement::Wrong;
use super::clues::FACTORS;
use super::*;

/// What explains wrong answers of a family.
#[derive(Clone, Debug, PartialEq)]
pub enum Name {
    /// A known mistake.
    Known {
        /// The mistake.
        mistake: &'static Mistake,
        /// How many wrong answers it explains.
        explains: usize,
        /// Of how many.
        of: usize,
    },
    /// A constant factor that is none of the known ones.
    Factor(f64),
}

/// The least share of the wrong answers that a name has to explain, as a divisor.
const SHARE: usize = 3;
/// Names for the same wrong answers: more would only say that one cannot tell.
const MOST_ALIKE: usize = 2;
/// A factor this close to 1 is an error of rounding or of a constant, and is not named.
const NEAR_ONE: f64 = 1e-4;

/// The names of a family's wrong answers: in each step the mistake that explains most of those not yet explained,
/// until none explains a third of all. Of mistakes that explain the same answers, the most specific are named, at most
/// two. Of a single answer, known mistakes only: one ratio says nothing.
pub fn names(wrong: &[Wrong]) -> Vec<Name> {
    if let [only] = wrong
        && !only.theirs.is_empty()
        && only.theirs.iter().all(|x| *x == 0.0)
    {
        // a single black answer is that of many mistakes
        let says = |mistake: &&Mistake| [&BLACK, &ZERO, &IN_BLACK_SHADOW].contains(mistake);
        let left_out = only.clues.iter().copied().find(says);
        return left_out
            .map(|mistake| Name::Known { mistake, explains: 1, of: 1 })
            .into_iter()
            .collect();
    }
    let mut open: Vec<usize> = (0..wrong.len()).collect();
    let mut names = Vec::new();
    while !open.is_empty() {
        let best = most_explaining(wrong, &open);
        let Some(first) = best.first() else { break };
        let explained = |index: &usize| wrong[*index].clues.contains(first);
        let count = open.iter().filter(|index| explained(index)).count();
        if count < wrong.len() && count < wrong.len().div_ceil(SHARE).max(2) {
            break;
        }
        open.retain(|index| !explained(index));
        names.extend(best.into_iter().map(|mistake| {
            let explains = wrong.iter().filter(|one| one.clues.contains(&mistake)).count();
            Name::Known { mistake, explains, of: wrong.len() }
        }));
    }
    let is_vague = |name: &Name| matches!(name, Name::Known { mistake, .. } if tier(mistake) == LEAST_SPECIFIC);
    if names.iter().all(is_vague) && has_one_value(wrong) {
        names = vec![Name::Known { mistake: &ALWAYS, explains: wrong.len(), of: wrong.len() }];
    }
    if names.is_empty() {
        names.extend(common_factor(wrong).map(Name::Factor));
    }
    names
}

/// The name of a family whose answers are all this one, if its wrong answers have no better name.
pub fn always(question: &str, answer: &Value, names: &[Name], wrong: &[Wrong]) -> Option<Name> {
    let is_vague = |name: &Name| match name {
        Name::Known { mistake, .. } => tier(mistake) == LEAST_SPECIFIC,
        Name::Factor(_) => false,
    };
    let mistake = match (question, answer) {
        ("occluded", Value::Bool(false)) => &NO_SHADOW_HIT,
        ("occluded", Value::Bool(true)) => &ALWAYS_BLOCKED,
        ("intersect", Value::Null) => &ALWAYS_NULL,
        _ => return None,
    };
    let is_named = wrong.len() >= 2 && names.iter().all(is_vague);
    is_named.then_some(Name::Known { mistake, explains: wrong.len(), of: wrong.len() })
}

/// Whether all answers are the same numbers, though others are right.
fn has_one_value(wrong: &[Wrong]) -> bool {
    let [first, second, third, others @ ..] = wrong else { return false };
    let rights: std::collections::BTreeSet<&str> =
        wrong.iter().map(|one| one.expected.as_str()).collect();
    let is_same = |other: &Wrong| other.theirs == first.theirs && other.symptom == first.symptom;
    let is_zero = first.theirs.iter().all(|x| *x == 0.0);
    !is_zero && rights.len() >= 3 && [second, third].into_iter().chain(others).all(is_same)
}

/// The mistake that explains most of these answers, and those that explain the same ones and are as specific.
fn most_explaining(wrong: &[Wrong], open: &[usize]) -> Vec<&'static Mistake> {
    let explained = |mistake: &Mistake| -> Vec<usize> {
        open.iter().copied().filter(|index| wrong[*index].clues.contains(&mistake)).collect()
    };
    let mut candidates: Vec<(&'static Mistake, Vec<usize>)> = Vec::new();
    for mistake in open.iter().flat_map(|index| &wrong[*index].clues) {
        if !candidates.iter().any(|(known, _)| known == mistake) {
            candidates.push((mistake, explained(mistake)));
        }
    }
    // stable: of equals, the order in which the judges found them
    candidates.sort_by_key(|(mistake, all)| (std::cmp::Reverse(all.len()), tier(mistake)));
    let Some((first, most)) = candidates.first().cloned() else { return Vec::new() };
    let is_equal = |(mistake, all): &(&'static Mistake, Vec<usize>)| {
        *all == most && tier(mistake) == tier(first)
    };
    let equal = candidates.into_iter().filter(is_equal).map(|(mistake, _)| mistake);
    equal.take(MOST_ALIKE).collect()
}

/// The tier of what says least.
const LEAST_SPECIFIC: u8 = 2;

/// How specific a mistake is: 0 says what was done, 1 how components differ, 2 how numbers differ.
fn tier(mistake: &Mistake) -> u8 {
    let components = [
        &SWAP_XY,
        &SWAP_YZ,
        &SWAP_XZ,
        &FLIP_X,
        &FLIP_Y,
        &FLIP_Z,
        &SWAP_RG,
        &SWAP_GB,
        &SWAP_RB,
        &ONLY_RED,
        &NO_RED,
        &NO_GREEN,
        &NO_BLUE,
        &MIRROR_U,
        &MIRROR_V,
        &BLACK,
        &ZERO,
        &NEGATED,
        &NOT_NORMALISED_LENGTH,
    ];
    let numbers = [&SQUARED, &ROOT, &INVERSE, &COMPLEMENT, &MISSED];
    if components.contains(&mistake) {
        1
    } else if numbers.contains(&mistake) || FACTORS.iter().any(|(factor, _)| *factor == mistake) {
        LEAST_SPECIFIC
    } else {
        0
    }
}

/// The one factor by which all answers are off.
fn common_factor(wrong: &[Wrong]) -> Option<f64> {
    let ratios = wrong.iter().map(|one| one.ratio).collect::<Option<Vec<f64>>>()?;
    let [ratio, others @ ..] = &ratios[..] else { return None };
    let is_common = others.len() >= 2 && others.iter().all(|other| same(&[*other], &[*ratio]));
    (is_common && (ratio - 1.0).abs() > NEAR_ONE).then_some(*ratio)
}

impl std::fmt::Display for Name {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Known { mistake, explains, of } => {
                let Mistake { name, place, picture, .. } = mistake;
                write!(f, "{name} ({place}")?;
                picture.iter().try_for_each(|name| write!(f, "; {name} in docs/mistakes.md"))?;
                mistake.seen_in().iter().try_for_each(|scene| write!(f, "; seen in {scene}"))?;
                write!(f, ")")?;
                if explains < of { write!(f, ", explains {explains} of {of}") } else { Ok(()) }
            }
            Self::Factor(factor) => write!(f, "theirs = ours × {}, every time", digits(*factor)),
        }
    }
}

/// A number with six digits.
fn digits(x: f64) -> String {
    if (1e-4..1e6).contains(&x.abs()) { format!("{x:.6}") } else { format!("{x:.5e}") }
}
