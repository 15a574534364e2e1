//! A run: questions go round the families, answers are judged, wrong ones named and made smaller.

use ask::{Asking, MOST_FAULTS, Stop, Subject, WINDOW, guarded};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use rayon::prelude::*;
use serde_json::Value;

use super::card::{Card, Failure, Row, Status};
use super::family::{Family, Judge};
use super::judgement::{Judgement, Profile, Wrong};
use super::mistakes::{LEFT_HANDED, Mistake, Name, agree, always, names, suspects};
use super::shrink;

/// Cases in each family, if it is not said how many.
pub const CASES: usize = 48;

/// At most so many can be asked for.
pub const MOST_CASES: usize = u32::MAX as usize;

/// What is asked.
#[derive(Clone, Debug)]
pub struct Options {
    /// How exact answers have to be.
    pub profile: Profile,
    /// Of the cases.
    pub seed: u64,
    /// How many cases a family has.
    pub cases: usize,
    /// Whether the first failure of each family is made small.
    pub shrink: bool,
    /// Set when the run is to end.
    pub interrupted: Arc<AtomicBool>,
}

/// Cases of a family in the first round, so that a run that is stopped soon has touched all families.
const FIRST_ROUND: usize = 2;
/// Unsupported cases after which a family is left alone. Not two: a program may lack a field of half of the cases, as a
/// camera's roll.
pub(super) const FEW: usize = 8;
/// Faults after which all families of a question are not asked any more.
const MOST_FAULTS_OF_QUESTION: u64 = 6;
/// Time for making the failures of all families smaller; those after it are shown as they were asked. A mistake that many
/// scenes show needs no small question in each.
const MOST_SHRINKING: Duration = Duration::from_secs(60);
/// Bytes of the answers to a question above which it is not made smaller.
const LONG: usize = 1 << 16;
/// Wrong answers of a family that are kept, to find what they have in common.
const KEPT: usize = 64;

/// The subject answered no question at all.
#[derive(Debug, thiserror::Error)]
#[error("the program answered no question; what came back:\n{}", .0.join("\n"))]
pub struct NoAnswer(pub Vec<String>);

/// Asks the families.
///
/// `watch` is told of each row whose questions have all been asked.
///
/// # Errors
/// [`NoAnswer`] if not even the easy questions get a reply that can be read.
pub fn run(
    subject: &mut dyn Subject,
    families: &[Family],
    options: &Options,
    watch: &mut dyn FnMut(&Row),
) -> Result<Card, NoAnswer> {
    let is_asked = |family: &&Family| options.profile == Profile::Careful || family.ordinary;
    let families: Vec<&Family> = families.iter().filter(is_asked).collect();
    easy_questions(subject, &families, options)?;
    let mut asked: Vec<Running<'_>> =
        families.iter().map(|family| Running::new(family, options)).collect();
    let mut faults: BTreeMap<String, u64> = BTreeMap::new();
    let most = asked.iter().map(|asked| asked.cases.len()).max().unwrap_or(0);
    let later = (FIRST_ROUND..most).step_by(WINDOW);
    let rounds: Vec<[usize; 2]> =
        std::iter::once([0, FIRST_ROUND]).chain(later.map(|from| [from, from + WINDOW])).collect();
    let mut shrinking = Duration::ZERO;
    for [from, to] in rounds {
        for asked in &mut asked {
            if options.interrupted.load(Ordering::Relaxed) {
                break;
            }
            let of_question = faults.entry(asked.family.question().to_owned()).or_default();
            if asked.is_done || *of_question >= MOST_FAULTS_OF_QUESTION {
                continue;
            }
            let before = asked.row.faults();
            asked.ask(subject, from, to, options.profile);
            *of_question += asked.row.faults() - before;
            if asked.is_done {
                asked.finish(subject, options, &mut shrinking);
                watch(&asked.row);
            }
        }
    }
    for asked in asked.iter_mut().filter(|asked| !asked.is_done) {
        asked.finish(subject, options, &mut shrinking);
        watch(&asked.row);
    }
    refute_by_others(&mut asked);
    let mut rows: Vec<Row> = asked.into_iter().map(|asked| asked.row).collect();
    agree(&mut rows);
    let is_whole = !options.interrupted.load(Ordering::Relaxed);
    Ok(Card { profile: options.profile, seed: options.seed, rows, is_whole })
}

/// Leaves out names of scenes without noise of which a right answer to another such scene of the chapter says that the program has
/// them not: all are traced by the same code.
fn refute_by_others(asked: &mut [Running<'_>]) {
    for index in 0..asked.len() {
        let mut names = std::mem::take(&mut asked[index].row.names);
        let chapter = asked[index].family.chapter;
        let others = || asked.iter().filter(|it| it.family.chapter == chapter);
        let is_refuted = |name: &Name| match name {
            Name::Known { mistake, .. } => others().any(|other| other.refutes(mistake)),
            Name::Factor(_) => false,
        };
        names.retain(|name| !asked[index].is_exact_scene() || !is_refuted(name));
        asked[index].row.names = names;
    }
}

/// Asks one question of each name, until there is a reply that can be read: a program may hang at one of them.
fn easy_questions(
    subject: &mut dyn Subject,
    families: &[&Family],
    options: &Options,
) -> Result<(), NoAnswer> {
    let mut seen = BTreeSet::new();
    let mut received = Vec::new();
    for family in families {
        if !family.ordinary || !seen.insert(family.question()) {
            continue;
        }
        let Some(question) = (family.cases)(options.seed, 1).pop() else { continue };
        match subject.ask(std::slice::from_ref(&question)).pop() {
            Some(Err(Stop::Fault(fault))) => {
                received.push(format!("{}: {}", family.question(), fault.text()))
            }
            _ => return Ok(()),
        }
    }
    if received.is_empty() { Ok(()) } else { Err(NoAnswer(received)) }
}

/// A family under questions.
struct Running<'a> {
    family: &'a Family,
    cases: Vec<Value>,
    row: Row,
    wrong: Vec<Wrong>,
    /// Questions with right answers, where a namer may hold mistakes against them.
    right: Vec<(Value, Value)>,
    /// The first wrong case.
    first: Option<(Value, Wrong)>,
    /// Its answer to every question until now, if they are one.
    common: CommonAnswer,
    is_done: bool,
}

/// What the answers of a family have in common.
enum CommonAnswer {
    /// There are none yet.
    Nothing,
    /// All are this one.
    Always(Value),
    /// They differ.
    Different,
}

impl<'a> Running<'a> {
    fn new(family: &'a Family, options: &Options) -> Self {
        let count = ((options.cases as f64 * family.share).ceil() as usize).max(1);
        let cases = (family.cases)(options.seed, count);
        let row = Row::new(&family.name, &family.about, family.chapter, cases.len() as u64);
        let is_done = cases.is_empty();
        let common = CommonAnswer::Nothing;
        let (wrong, right) = (Vec::new(), Vec::new());
        Self { family, cases, row, wrong, right, first: None, common, is_done }
    }

    /// Asks some of its cases; while nothing is supported, few of them.
    fn ask(&mut self, subject: &mut dyn Subject, from: usize, to: usize, profile: Profile) {
        if from < FEW && FEW < to && self.row.is_unsupported() {
            self.ask_range(subject, from, FEW, profile);
            if !self.is_done {
                self.ask_range(subject, FEW, to, profile);
            }
        } else {
            self.ask_range(subject, from, to, profile);
        }
    }

    fn ask_range(&mut self, subject: &mut dyn Subject, from: usize, to: usize, profile: Profile) {
        let to = to.min(self.cases.len());
        let cases: Vec<Value> = self.cases[from.min(to)..to].to_vec();
        match self.family.judge {
            Judge::Answer(judge, rules) => {
                let replies = subject.ask(&cases);
                let judged: Vec<Judged> = cases
                    .par_iter()
                    .zip(&replies)
                    .map(|(question, reply)| {
                        let judged = |profile| {
                            let answer = reply.as_ref().map_err(Stop::clone)?;
                            guarded(|| judge(question, answer, profile, rules)).map_err(Stop::Ours)
                        };
                        Judged::of(judged, profile)
                    })
                    .collect();
                for ((question, reply), mut judged) in cases.iter().zip(replies).zip(judged) {
                    let asked: Vec<_> =
                        reply.ok().into_iter().map(|answer| (question.clone(), answer)).collect();
                    asked.iter().for_each(|(_, answer)| self.common.and(answer));
                    self.name(&mut judged, &asked);
                    self.count(question, judged, asked);
                }
            }
            Judge::Law(law) => {
                for case in &cases {
                    let mut first = None;
                    let judged = |profile| {
                        let mut asking = Asking::new(subject);
                        let found = guarded(|| law(&mut asking, case, profile));
                        first.get_or_insert(asking.asked);
                        found.unwrap_or_else(|text| Err(Stop::Ours(text)))
                    };
                    let mut judged = Judged::of(judged, profile);
                    let asked = first.unwrap_or_default();
                    self.name(&mut judged, &asked);
                    self.count(case, judged, asked);
                    if self.row.faults() >= MOST_FAULTS as u64 {
                        break;
                    }
                }
            }
        }
        let is_left_alone = to >= FEW && self.row.is_unsupported();
        self.is_done =
            to == self.cases.len() || is_left_alone || self.row.faults() >= MOST_FAULTS as u64;
    }

    fn count(&mut self, question: &Value, judged: Judged, asked: Vec<(Value, Value)>) {
        let Judged { found, is_fair } = judged;
        let (status, text) = match &found {
            Ok(Judgement::Wrong(_)) => (Status::Wrong, None),
            Ok(Judgement::Undecided) => (Status::Undecided, None),
            Ok(_) => (Status::Pass, None),
            Err(Stop::Refused(text)) => (Status::Refused, Some(text.clone())),
            Err(Stop::Unsupported(text)) => (Status::Unsupported, Some(text.clone())),
            Err(Stop::Fault(fault)) => (Status::of(fault), Some(fault.text().to_owned())),
            Err(Stop::Ours(text)) => {
                let text = format!("not judged, by a fault of ours; please report it: {text}");
                (Status::Undecided, Some(text))
            }
            // not any more
            Err(Stop::NotAsked) => return,
        };
        let row = &mut self.row;
        row.counts[status as usize] += 1;
        row.ours += u64::from(matches!(found, Err(Stop::Ours(_))));
        row.fair += u64::from(is_fair);
        if let Some(text) = text {
            row.count_reason(status, &text);
            if row.messages.iter().all(|(other, ..)| *other != status) {
                row.messages.push((status, text, question.clone()));
            }
        }
        match found {
            Ok(Judgement::Right(error)) => row.worst = row.worst.max(error),
            Ok(Judgement::ByTheBook(mistake)) => row.count_convention(mistake),
            Ok(Judgement::Lacks(field)) => *row.lacks.entry(field).or_default() += 1,
            Ok(Judgement::Wrong(wrong)) => {
                if self.first.is_none() {
                    row.asked = asked.into_iter().map(|(q, a)| (q, a.to_string())).collect();
                    self.first = Some((question.clone(), (*wrong).clone()));
                }
                if self.wrong.len() < KEPT {
                    self.wrong.push(*wrong);
                }
            }
            _ => {}
        }
    }

    /// Adds the mistakes that the family's namer finds in a wrong case, and keeps a right one.
    fn name(&mut self, judged: &mut Judged, asked: &[(Value, Value)]) {
        let Some(namer) = self.family.namer else { return };
        match &mut judged.found {
            Ok(Judgement::Wrong(wrong)) => {
                let mut new = (namer.explain)(asked);
                new.retain(|it| !wrong.clues.contains(it));
                wrong.clues.extend(new);
            }
            Ok(found) if found.is_right() && self.right.len() < KEPT => {
                self.right.extend(asked.last().cloned());
            }
            _ => {}
        }
    }

    /// Whether it is of scenes without noise.
    fn is_exact_scene(&self) -> bool {
        self.family.about.starts_with("scenes/") && self.family.name.ends_with(".values")
    }

    /// Whether a right answer says that the program has not this mistake.
    fn refutes(&self, mistake: &'static Mistake) -> bool {
        let Some(namer) = self.family.namer else { return false };
        guarded(|| self.right.iter().any(|right| (namer.refutes)(right, mistake))).unwrap_or(false)
    }

    /// Leaves out mistakes of which a right answer says that the program has them not.
    fn refute(&self, wrong: &mut [Wrong]) {
        for (mistake, _) in suspects(wrong) {
            if self.refutes(mistake) {
                wrong.iter_mut().for_each(|one| one.clues.retain(|it| *it != mistake));
            }
        }
    }

    /// Names what is wrong, and makes the first failure smaller. Only right answers of scenes without noise are kept beyond that.
    fn finish(&mut self, subject: &mut dyn Subject, options: &Options, spent: &mut Duration) {
        self.is_done = true;
        self.cases = Vec::new();
        let mut wrong = std::mem::take(&mut self.wrong);
        self.refute(&mut wrong);
        // a point that is seen here and not there has no number to compare
        let is_left = |one: &Wrong| one.clues.contains(&&LEFT_HANDED);
        self.row.is_left_handed = wrong.iter().any(is_left)
            && wrong.iter().all(|one| is_left(one) || one.theirs.is_empty());
        wrong.iter_mut().for_each(|one| one.clues.retain(|it| *it != &LEFT_HANDED));
        if !self.is_exact_scene() {
            self.right = Vec::new();
        }
        self.row.names = guarded(|| names(&wrong)).unwrap_or_default();
        if let CommonAnswer::Always(answer) = &self.common
            && let Some(name) = always(self.family.question(), answer, &self.row.names, &wrong)
        {
            self.row.names = vec![name];
        }
        self.common = CommonAnswer::Nothing;
        let Some((question, wrong)) = self.first.take() else { return };
        let asked = std::mem::take(&mut self.row.asked);
        let first = Failure { question, wrong, asked };
        // each simpler question has as long an answer, which has to be read and judged
        let is_short = first.asked.iter().map(|(_, got)| got.len()).sum::<usize>() <= LONG;
        let is_shrunk = options.shrink && self.family.is_shrunk && *spent < MOST_SHRINKING;
        let begun = Instant::now();
        let failure = match is_shrunk && is_short && !options.interrupted.load(Ordering::Relaxed) {
            true => {
                let (judge, profile) = (self.family.judge, options.profile);
                guarded(|| shrink::smaller(subject, judge, first.clone(), profile)).unwrap_or(first)
            }
            false => first,
        };
        *spent += begun.elapsed();
        self.row.failure = Some(failure);
    }
}

/// What is said of one case.
struct Judged {
    found: Result<Judgement, Stop>,
    /// Wrong, but no failure in single precision.
    is_fair: bool,
}

impl CommonAnswer {
    /// With one more answer.
    fn and(&mut self, answer: &Value) {
        match self {
            Self::Nothing => *self = Self::Always(answer.clone()),
            Self::Always(before) if before != answer => *self = Self::Different,
            _ => {}
        }
    }
}

impl Judged {
    /// By the profile; what is wrong by *careful* is judged by *book*, too.
    fn of(mut judge: impl FnMut(Profile) -> Result<Judgement, Stop>, profile: Profile) -> Self {
        let found = judge(profile);
        let is_wrong = matches!(found, Ok(Judgement::Wrong(_)));
        let is_fair = is_wrong
            && profile == Profile::Careful
            && judge(Profile::Book).is_ok_and(|it| is_no_failure(&it));
        Self { found, is_fair }
    }
}

/// Whether it is right, or not judged; a convention of the book is no matter of precision.
fn is_no_failure(judgement: &Judgement) -> bool {
    matches!(judgement, Judgement::Right(_) | Judgement::Lacks(_) | Judgement::Undecided)
}
