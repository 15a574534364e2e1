//! The few mistakes that explain most wrong answers of a family.

use serde_json::Value;

use super::super::card::{Row, Status};
use super::super::judgement::Wrong;
use super::*;
use judge::mistakes::known::Says;

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

/// The least share of the wrong answers that a name has to explain: all of fewer than ten.
const NEARLY_ALL: f64 = 0.9;
/// Names for the same wrong answers: more would only say that one cannot tell.
const MOST_ALIKE: usize = 2;
/// Answers from which on a name that only says how numbers differ tells something: one or two may agree by chance.
const SOME: usize = 3;
/// A factor this close to 1 is an error of rounding or of a constant, and is not named.
const NEAR_ONE: f64 = 1e-4;

/// The mistakes that explain nearly all of these answers, with how many each explains; the first explain most.
pub fn suspects(wrong: &[Wrong]) -> Vec<(&'static Mistake, usize)> {
    let mut all: Vec<(&'static Mistake, usize)> = Vec::new();
    for mistake in wrong.iter().flat_map(|one| &one.clues) {
        if all.iter().all(|(known, _)| known != mistake) {
            let explains =
                |one: &&Wrong| one.clues.contains(mistake) || one.beside.contains(mistake);
            let explains = wrong.iter().filter(explains).count();
            all.push((mistake, explains));
        }
    }
    all.retain(|(_, explains)| *explains as f64 >= NEARLY_ALL * wrong.len() as f64);
    // stable: of equals, the order in which the judges found them
    all.sort_by_key(|(mistake, explains)| (std::cmp::Reverse(*explains), says(mistake)));
    all
}

/// The names of a family's wrong answers: the mistake that explains most of them, and nearly all, or none. Of mistakes that
/// explain as many, the most specific are named; if they say only how numbers differ, one, or none.
pub fn names(wrong: &[Wrong]) -> Vec<Name> {
    let mut best = suspects(wrong);
    if let Some((first, most)) = best.first().copied() {
        best.retain(|(mistake, explains)| *explains == most && says(mistake) == says(first));
        let says_little = says(first) == Says::Numbers || [&BLACK, &ZERO].contains(&first);
        let is_either = best.len() > 1;
        if is_either && wrong.len() < SOME || says_little && (is_either || wrong.len() < SOME) {
            best.clear();
        }
    }
    let name = |(mistake, explains)| Name::Known { mistake, explains, of: wrong.len() };
    let mut names: Vec<Name> = best.into_iter().map(name).collect();
    let is_vague =
        |name: &Name| matches!(name, Name::Known { mistake, .. } if says(mistake) == Says::Numbers);
    if names.iter().all(is_vague) && has_one_value(wrong) {
        names = vec![Name::Known { mistake: &ALWAYS, explains: wrong.len(), of: wrong.len() }];
    }
    if names.is_empty() {
        names.extend(common_factor(wrong).map(Name::Factor));
    }
    names
}

/// Of several names of a family, keeps those that most other families share, if these are at most two. A name that no other
/// family has is dropped if it rests on few wrong answers, or if it is that of a scene and most other wrong scenes have
/// none. If all wrong answers of all families are those of left-handed axes, this is said first.
pub fn agree(rows: &mut [Row]) {
    let failed: Vec<&Row> = rows.iter().filter(|row| row.count(Status::Wrong) > row.fair).collect();
    // some rules have no numbers to compare
    let may_be = |row: &&Row| row.is_left_handed || row.names.is_empty();
    let count = failed.len();
    // where one family alone failed, a mistake that explains it is likelier
    let is_left_handed = failed.iter().any(|row| row.is_left_handed)
        && failed.iter().all(may_be)
        && (count > 1 || failed[0].names.is_empty());
    let is_scene = |row: &Row| row.about.starts_with("scenes/");
    let scenes = failed.iter().filter(|row| is_scene(row));
    let nameless = scenes.clone().filter(|row| row.names.is_empty()).count();
    let is_odd = 2 * nameless > scenes.count();
    let mut votes: Vec<(&'static Mistake, usize)> = Vec::new();
    for name in failed.iter().flat_map(|row| &row.names) {
        let Name::Known { mistake, .. } = name else { continue };
        match votes.iter_mut().find(|(known, _)| known == mistake) {
            Some((_, votes)) => *votes += 1,
            None => votes.push((mistake, 1)),
        }
    }
    let votes_of = |name: &Name| match name {
        Name::Known { mistake, .. } => {
            votes.iter().find(|(known, _)| known == mistake).map_or(0, |(_, votes)| *votes)
        }
        Name::Factor(_) => 1,
    };
    for row in rows {
        let wrong = row.count(Status::Wrong) as usize;
        if is_left_handed && wrong > 0 {
            let name = Name::Known { mistake: &LEFT_HANDED, explains: wrong, of: wrong };
            row.names.insert(0, name);
            row.names.truncate(MOST_ALIKE);
            continue;
        }
        let most = row.names.iter().map(votes_of).max().unwrap_or_default();
        let says_enough = most > 1 || count == 1 || wrong >= SOME && !(is_odd && is_scene(row));
        row.names.retain(|name| says_enough && votes_of(name) == most);
        if row.names.len() > MOST_ALIKE {
            row.names.clear();
        }
    }
}

/// The name of a family whose answers are all this one, if its wrong answers have no better name.
pub fn always(question: &str, answer: &Value, names: &[Name], wrong: &[Wrong]) -> Option<Name> {
    let is_vague = |name: &Name| match name {
        Name::Known { mistake, .. } => says(mistake) == Says::Numbers,
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

/// How much a mistake says, the most first.
fn says(mistake: &Mistake) -> Says {
    mistake.known().says
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
                write!(f, "{} ({}", mistake.words(), mistake.known().place)?;
                let picture = mistake.picture();
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
