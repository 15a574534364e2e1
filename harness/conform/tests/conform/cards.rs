//! What a card prints of cases whose outcomes are known.

use ask::{Fault, Invocation, Reply, Stop, Subject};

use conform::card::{junit, page, told};
use conform::family::{Family, Judge};
use conform::{Card, Judgement, Profile, Rules, WHOLE, run};
use serde_json::{Value, json};

use super::altered::{family, options};

/// What becomes of a case, written into its question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    Right,
    Undecided,
    /// By both profiles.
    Wrong,
    /// By the profile *careful* alone.
    Fair,
    Refused,
    Unsupported,
    Hung,
    Died,
    Garbled,
    /// The judge fails.
    Ours,
}

const OUTCOMES: [Outcome; 10] = [
    Outcome::Right,
    Outcome::Undecided,
    Outcome::Wrong,
    Outcome::Fair,
    Outcome::Refused,
    Outcome::Unsupported,
    Outcome::Hung,
    Outcome::Died,
    Outcome::Garbled,
    Outcome::Ours,
];

/// The outcome that a question says.
fn outcome(question: &Value) -> Outcome {
    let data = question.as_object().and_then(|it| it.values().next()).expect("data");
    let name = data["outcome"].as_str().expect("an outcome");
    *OUTCOMES.iter().find(|it| format!("{it:?}") == name).expect("one of them")
}

fn error(question: &Value) -> f64 {
    let data = question.as_object().and_then(|it| it.values().next()).expect("data");
    data["error"].as_f64().expect("an error")
}

fn judge(question: &Value, _: &Value, profile: Profile, _: &Rules) -> Judgement {
    match (outcome(question), profile) {
        (Outcome::Right, _) | (Outcome::Fair, Profile::Book) => Judgement::Right(error(question)),
        (Outcome::Undecided, _) => Judgement::Undecided,
        (Outcome::Ours, _) => panic!("it fails"),
        _ => Judgement::wrong("number", error(question), "another"),
    }
}

/// Does what a question says.
struct Obedient;

impl Subject for Obedient {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| match outcome(question) {
            Outcome::Refused => Err(Stop::Refused("no".to_owned())),
            Outcome::Unsupported => Err(Stop::Unsupported("no".to_owned())),
            Outcome::Hung => Err(Stop::Fault(Fault::Hung("no answer".to_owned()))),
            Outcome::Died => Err(Stop::Fault(Fault::Died("a crash".to_owned()))),
            Outcome::Garbled => Err(Stop::Fault(Fault::Garbled("a line".to_owned()))),
            // no two answers are the same
            _ => Ok(question.clone()),
        };
        questions.iter().map(reply).collect()
    }
}

/// A family, and what becomes of its cases.
pub struct Plan {
    pub name: String,
    pub chapter: &'static str,
    pub outcomes: Vec<(Outcome, f64)>,
}

impl Plan {
    fn family(&self) -> Family {
        let question = self.name.split('.').next().unwrap_or_default().to_owned();
        let cases: Vec<Value> = self
            .outcomes
            .iter()
            .enumerate()
            .map(|(is, (outcome, error))| {
                let outcome = format!("{outcome:?}");
                json!({&question: {"is": is, "outcome": outcome, "error": error}})
            })
            .collect();
        let cases = move |n: usize| cases[..n.min(cases.len())].to_vec();
        let family = family(&self.name, Judge::Answer(judge, &WHOLE), cases);
        Family { about: "tests/cards".to_owned(), chapter: self.chapter, ..family }
    }
}

pub fn card(plans: &[Plan]) -> Option<Card> {
    let families: Vec<Family> = plans.iter().map(Plan::family).collect();
    run(&mut Obedient, &families, &options(7), &mut |_| ()).ok()
}

/// Law: every count on a card, of cases by status, families and chapters, in its verdict, table, page, JUnit's file and JSON,
/// is that of the cases that were asked; the first wrong case is shown, and the worst right one. Oracle: the forms of the card,
/// read by a person beside the outcomes that are written into the questions.
#[test]
fn every_count_on_a_card_is_that_of_its_cases() {
    let plan = |(index, outcomes): (usize, Vec<Outcome>)| {
        let errors = (1..).map(|i| 7.5 * f64::from(i) % 20.0);
        let chapter = ["ch03", "ch05", "ch19"][index % 3];
        let name = format!("question{index}.tests.family{index}");
        Plan { name, chapter, outcomes: outcomes.into_iter().zip(errors).collect() }
    };
    use Outcome::{Fair, Right, Undecided, Unsupported, Wrong};
    let each = OUTCOMES.map(|outcome| vec![Right, outcome, Right, outcome, Undecided]);
    let more = [vec![Right; 4], vec![Unsupported; 3], vec![Undecided, Fair, Wrong, Fair, Right]];
    let plans: Vec<Plan> = each.into_iter().chain(more).enumerate().map(plan).collect();
    let card = card(&plans).expect("it answers");
    let program = ["./mine".to_owned()];
    let invocation = Invocation { program: &program, ..Default::default() };
    let told = told(&card, &invocation);
    let page = page(&card, &told, "./mine");
    let rows: Vec<&str> = page.lines().filter(|line| line.contains("<tr")).collect();
    let json = card.json();
    let families = json["families"].as_array().into_iter().flatten();
    let families: Vec<String> = families.map(ToString::to_string).collect();
    let forms = [told.text(), rows.join("\n"), junit(&card, "./mine"), families.join("\n")];
    insta::assert_snapshot!("card", forms.join("\n\n"));
}

/// Law: single precision is advised if more than half of the wrong answers are fair, and not at half of them (docs/conform.md:
/// "if these are most"). Oracle: one case on both sides.
#[test]
fn advice_begins_above_half() {
    for (fair, is_advised) in [(1, false), (2, false), (3, true), (4, true)] {
        let outcomes = (0..4)
            .map(|i| (if i < fair { Outcome::Fair } else { Outcome::Wrong }, 200.0))
            .collect();
        let plan = Plan { name: "a.b".to_owned(), chapter: "ch03", outcomes };
        let text = card(&[plan]).expect("it answers").to_string();
        assert_eq!(text.contains("--profile book"), is_advised, "{fair} of 4 are fair: {text}");
    }
}
