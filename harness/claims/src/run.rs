//! A run: every subject in several cases, each case held to every law; and what chance may have done.

use ask::{Draw, Stop, Subject};
use std::collections::BTreeSet;

use groundtruth::math::hash;
use groundtruth::printable;
use serde_json::{Value, json};

use crate::asked::Counted;
use crate::description::{Description, Kind};
use crate::laws::{Breach, Finding, Law};
use crate::setting::{Case, Setting};
use crate::smaller;

/// The probability that chance calls any right lobe of a card wrong, before it is asked again.
const LEVEL: f64 = 1e-2;
/// So improbable numbers are judged at once, and no further case of the law is asked.
const AT_ONCE: f64 = 1e-12;
/// How many times the samples are drawn when a law of chance is asked again.
const AGAIN: usize = 10;
/// Questions to a subject for each of its cases, on average: right ones need at most 250.
const MOST_QUESTIONS: usize = 1000;

/// Cases of each subject, if it is not said how many.
pub const CASES: usize = 8;

/// At most so many can be asked for.
pub const MOST_CASES: usize = 10_000;

/// How subjects are asked.
#[derive(Clone, Copy, Debug)]
pub struct ClaimsOptions {
    /// Cases of each.
    pub cases: usize,
    /// Of the cases.
    pub seed: u64,
}

/// What became of a law for a lobe.
#[derive(Clone, Debug)]
pub enum LawStatus {
    /// It holds in so many cases.
    Holds(usize),
    /// It was not decided in any case, and why.
    Undecided(String),
    /// It is broken.
    Broken(Broken),
    /// The lobe does not claim it.
    NotClaimed,
}

/// A case in which a law is broken: the first, made smaller.
#[derive(Clone, Debug)]
pub struct Broken {
    /// The parameters, and from where it is seen.
    pub setting: Setting,
    /// What was found.
    pub breach: Breach,
}

/// What became of a lobe.
#[derive(Clone, Debug)]
pub struct SubjectRow {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Of each law of the kind.
    pub laws: Vec<LawStatus>,
    /// Why it could not be judged further, if so.
    pub trouble: Option<Stop>,
}

impl SubjectRow {
    /// The laws that it breaks.
    pub fn broken(&self) -> impl Iterator<Item = (&'static Law, &Broken)> {
        self.laws.iter().zip(Law::of(self.kind)).filter_map(|(status, law)| match status {
            LawStatus::Broken(broken) => Some((law, broken)),
            _ => None,
        })
    }

    /// Whether the program does not have it.
    pub fn is_unsupported(&self) -> bool {
        matches!(self.trouble, Some(Stop::Unsupported(_)))
    }

    /// Whether it breaks a law, or does not answer.
    pub fn is_failed(&self) -> bool {
        let is_silent = matches!(self.trouble, Some(Stop::Refused(_) | Stop::Fault(_)));
        is_silent || self.broken().next().is_some()
    }
}

/// What was found of all lobes.
#[derive(Clone, Debug)]
pub struct ClaimsCard {
    /// The lobes, in the program's order.
    pub rows: Vec<SubjectRow>,
    /// Of the cases.
    pub seed: u64,
    /// Tests that chance decides.
    pub tests: usize,
    /// Whether it was not interrupted.
    pub is_whole: bool,
}

impl ClaimsCard {
    /// Whether a lobe breaks a law.
    pub fn is_failed(&self) -> bool {
        self.rows.iter().any(SubjectRow::is_failed)
    }

    /// Whether a law was decided for any lobe.
    pub fn is_judged(&self) -> bool {
        let is_decided =
            |status: &LawStatus| matches!(status, LawStatus::Holds(_) | LawStatus::Broken(_));
        self.rows.iter().any(|row| row.laws.iter().any(is_decided))
    }
}

/// The lobes of OpenPBR of which its specification says that no light is lost.
pub fn openpbr() -> Vec<Description> {
    let file = toml::from_str::<Value>(include_str!("../packs/openpbr.toml"));
    read(&file.expect("it is TOML")["lobes"]).expect("it was tested")
}

/// The lobes that a program lists.
///
/// # Errors
/// Says why there are none.
pub fn listed(subject: &mut dyn Subject) -> Result<Vec<Description>, Stop> {
    let reply = subject.ask(&[json!({"list": {}})]).pop();
    read(&reply.ok_or(Stop::NotAsked)??)
}

fn read(list: &Value) -> Result<Vec<Description>, Stop> {
    let refused = |problem: String| Stop::Refused(format!("the answer to `list`: {problem}"));
    let none = || refused("it is no list of at least one entry".to_owned());
    let entries = list.as_array().filter(|list| !list.is_empty()).ok_or_else(none)?;
    let read = |(index, entry)| Description::read(index, entry).map_err(refused);
    let list: Vec<Description> = entries.iter().enumerate().map(read).collect::<Result<_, _>>()?;
    let mut names = BTreeSet::new();
    match list.iter().find(|lobe| !names.insert(&lobe.name)) {
        Some(twice) => Err(refused(format!("`{}` is listed twice", printable::name(&twice.name)))),
        None => Ok(list),
    }
}

/// A test of chance, to be judged when all are known.
struct Test {
    row: usize,
    law: usize,
    case: usize,
    p: f64,
}

/// Holds subjects to the laws; `finished` hears of each before chance is judged.
pub fn run(
    subject: &mut dyn Subject,
    lobes: &[Description],
    options: ClaimsOptions,
    finished: &mut dyn FnMut(&str),
) -> ClaimsCard {
    let (mut rows, mut tests) = (Vec::new(), Vec::new());
    let mut is_whole = true;
    for (index, lobe) in lobes.iter().enumerate() {
        // after an interruption nothing is asked, but the card has a row for each
        let options = if is_whole { options } else { ClaimsOptions { cases: 0, ..options } };
        let mut judge = Judge::new(subject, lobe, options, index, &mut tests);
        let mut row = judge.row();
        if !is_whole {
            row.trouble = Some(Stop::NotAsked);
        }
        is_whole &= row.trouble != Some(Stop::NotAsked);
        rows.push(row);
        if is_whole {
            finished(&lobe.name);
        }
    }
    let planned = tests.len();
    for test in rejected(tests) {
        let lobe = &lobes[test.row];
        let mut none = Vec::new();
        let mut judge = Judge::new(subject, lobe, options, test.row, &mut none);
        let found = match judge.again(test.law, test.case, planned) {
            Ok(found) => found,
            Err(trouble) => {
                is_whole &= trouble != Stop::NotAsked;
                rows[test.row].trouble = Some(trouble);
                Some(LawStatus::Undecided("it seemed broken, and was not asked again".to_owned()))
            }
        };
        let status = &mut rows[test.row].laws[test.law];
        if let (Some(found), false) = (found, matches!(status, LawStatus::Broken(_))) {
            *status = found;
        }
    }
    for (row, lobe) in rows.iter_mut().zip(lobes) {
        is_whole = is_whole && smaller::row(subject, lobe, options.seed, row).is_ok();
    }
    ClaimsCard { rows, seed: options.seed, tests: planned, is_whole }
}

/// The tests that fail at the level of the card (Holm, "A Simple Sequentially Rejective Multiple Test Procedure",
/// 1979), in the order of rows and cases.
fn rejected(mut tests: Vec<Test>) -> Vec<Test> {
    tests.sort_by(|a, b| a.p.total_cmp(&b.p));
    let count = tests.len();
    let holds = |(rank, test): (usize, &Test)| test.p > LEVEL / (count - rank) as f64;
    let first = tests.iter().enumerate().position(holds).unwrap_or(count);
    tests.truncate(first);
    tests.sort_by_key(|test| (test.row, test.law, test.case));
    tests
}

/// One lobe under the laws.
struct Judge<'a> {
    subject: Counted<'a>,
    lobe: &'a Description,
    options: ClaimsOptions,
    row: usize,
    tests: &'a mut Vec<Test>,
}

impl<'a> Judge<'a> {
    fn new(
        subject: &'a mut dyn Subject,
        lobe: &'a Description,
        options: ClaimsOptions,
        row: usize,
        tests: &'a mut Vec<Test>,
    ) -> Self {
        Self { subject: Counted { subject, asked: 0 }, lobe, options, row, tests }
    }

    fn row(&mut self) -> SubjectRow {
        let status = |law: &Law| match (law.applies)(&self.lobe.claims) {
            true => LawStatus::Holds(0),
            false => LawStatus::NotClaimed,
        };
        let mut laws: Vec<LawStatus> = Law::of(self.lobe.kind).iter().map(status).collect();
        let mut trouble = None;
        let most = MOST_QUESTIONS * self.options.cases;
        for case in 0..self.options.cases {
            if self.subject.asked > most {
                undecided(&mut laws, "left alone after more questions than any right one needs");
                break;
            }
            if let Err(found) = self.case(case, &mut laws) {
                trouble = Some(found);
                break;
            }
        }
        undecided(&mut laws, "no case was asked");
        SubjectRow { name: self.lobe.name.clone(), kind: self.lobe.kind, laws, trouble }
    }

    /// Holds one case to all laws that are not broken yet, until it has values that are none: nothing can be held to those,
    /// and integrals of them never settle.
    fn case(&mut self, index: usize, laws: &mut [LawStatus]) -> Result<(), Stop> {
        let (lobe, options, row) = (self.lobe, self.options, self.row);
        let (setting, draw) = Setting::drawn(lobe, options.seed, index);
        let mut case = Case::new(&mut self.subject, lobe, &setting, draw);
        for (number, law) in Law::of(lobe.kind).iter().enumerate() {
            let status = &mut laws[number];
            let is_known = matches!(status, LawStatus::Broken(_));
            if matches!(status, LawStatus::NotClaimed) || is_known && !law.ends_a_case() {
                continue;
            }
            let mut finding = law.check(&mut case, 1)?;
            if let Finding::Chance(p, _) = finding
                && p <= AT_ONCE
            {
                case.forget();
                finding = match law.check(&mut case, AGAIN)? {
                    Finding::Chance(p, breach) if p <= AT_ONCE => Finding::Broken(breach),
                    Finding::Chance(..) => Finding::Holds,
                    other => other,
                };
                case.forget();
            }
            match finding {
                Finding::Holds if is_known => {}
                Finding::Holds => count(status),
                Finding::Chance(p, _) => {
                    self.tests.push(Test { row, law: number, case: index, p });
                    count(status);
                }
                Finding::Undecided(why) => {
                    if let LawStatus::Holds(0) = status {
                        *status = LawStatus::Undecided(why);
                    }
                }
                Finding::Broken(breach) => {
                    let ends = law.ends_a_case() || breach.error.is_infinite();
                    if !is_known {
                        *status = LawStatus::Broken(Broken { setting: setting.clone(), breach });
                    }
                    if ends {
                        let what = format!("not asked where \"{}\" is broken", law.name);
                        undecided(laws, &what);
                        break;
                    }
                }
            }
        }
        Ok(())
    }

    /// What became of a law of chance that seemed broken, with more samples; `None` if it holds.
    fn again(&mut self, law: usize, index: usize, tests: usize) -> Result<Option<LawStatus>, Stop> {
        let seed = self.options.seed;
        let (setting, _) = Setting::drawn(self.lobe, seed, index);
        let draw = Draw::new(hash(&[seed, index as u64, law as u64]));
        let mut case = Case::new(&mut self.subject, self.lobe, &setting, draw);
        let breach = match Law::of(self.lobe.kind)[law].check(&mut case, AGAIN)? {
            Finding::Chance(p, breach) if p < LEVEL / tests.max(1) as f64 => Some(breach),
            Finding::Broken(breach) => Some(breach),
            _ => None,
        };
        Ok(breach.map(|breach| LawStatus::Broken(Broken { setting, breach })))
    }
}

/// Says why laws are not decided that were not asked in any case.
fn undecided(laws: &mut [LawStatus], why: &str) {
    for status in laws {
        if let LawStatus::Holds(0) = status {
            *status = LawStatus::Undecided(why.to_owned());
        }
    }
}

/// One case more in which a law holds.
fn count(status: &mut LawStatus) {
    match status {
        LawStatus::Holds(cases) => *cases += 1,
        other => *other = LawStatus::Holds(1),
    }
}
