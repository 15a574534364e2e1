//! What a run asks, counted: rounds, shares, what is left alone, and what faults cost.

use ask::{Asking, Fault, Reply, Stop, Subject};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use conform::family::{Family, Judge};
use conform::{Card, Judgement, NoAnswer, Options, Profile, Status, WHOLE, run, suite};
use serde_json::{Value, json};

use super::altered::{self, options};

/// Keeps what it is asked, and answers by a function of the question and of how much was asked before.
struct Heard<F> {
    heard: Vec<Value>,
    answer: F,
}

impl<F: FnMut(&Value, usize) -> Reply> Heard<F> {
    fn new(answer: F) -> Self {
        Self { heard: Vec::new(), answer }
    }

    /// How many questions of this name there were.
    fn count(&self, question: &str) -> usize {
        self.heard.iter().filter(|it| it.get(question).is_some()).count()
    }
}

impl<F: FnMut(&Value, usize) -> Reply> Subject for Heard<F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let mut one = |question: &Value| {
            let reply = (self.answer)(question, self.heard.len());
            self.heard.push(question.clone());
            reply
        };
        questions.iter().map(&mut one).collect()
    }
}

/// The number of a case of [`family`].
fn number(question: &Value) -> usize {
    let data = question.as_object().and_then(|it| it.values().next());
    data.and_then(|data| data["is"].as_u64()).expect("a case has a number") as usize
}

/// The case of this number.
fn case(name: &str, is: usize) -> Value {
    let question = name.split('.').next().unwrap_or_default();
    json!({question: {"family": name, "is": is}})
}

/// Any answer is right; one question a case.
fn by_law(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Result<Judgement, Stop> {
    ask.ask(case).map(|_| Judgement::Right(0.0))
}

/// A family of numbered cases, each of which is right if it is answered.
fn family(name: &str, share: f64, judge: Judge) -> Family {
    let of = name.to_owned();
    let cases = move |n| (0..n).map(|is| case(&of, is)).collect();
    Family { share, ..altered::family(name, judge, cases) }
}

const ANSWER: Judge = Judge::Answer(|_, _, _, _| Judgement::Right(0.0), &WHOLE);

fn card(subject: &mut dyn Subject, families: &[Family], cases: usize) -> Card {
    run(subject, families, &options(cases), &mut |_| ()).expect("it answers")
}

fn died() -> Reply {
    Err(Stop::Fault(Fault::Died("a crash".to_owned())))
}

/// Law: a family has its share of the cases, rounded up, and at least one; each is asked once, in order, two of each family
/// first and then 64 of each (docs/conform.md), after one easy question. Oracle: the list of questions, written by hand from
/// these rules.
#[test]
fn each_case_is_asked_once_in_rounds_of_all_families() {
    let families = [
        family("whole.a", 1.0, ANSWER),
        family("half.b", 0.5, Judge::Law(by_law)),
        family("few.c", 0.04, ANSWER),
    ];
    for n in [1, 2, 3, 7, 8, 9, 10, 24, 25, 26, 65, 66, 67, 130, 131] {
        let mut subject = Heard::new(|_, _| Ok(json!(1)));
        let card = card(&mut subject, &families, n);
        let counts = [n, n.div_ceil(2), n.div_ceil(25)];
        let mut expected = vec![case("whole.a", 0)];
        let rounds = [(0, 2), (2, 66), (66, 130), (130, 194)];
        for (from, to) in rounds {
            for (family, count) in families.iter().zip(counts) {
                expected.extend((from..to.min(count)).map(|is| case(&family.name, is)));
            }
        }
        assert_eq!(subject.heard, expected, "the questions of a run of {n} cases");
        for (row, count) in card.rows.iter().zip(counts) {
            let found = (row.cases, row.count(Status::Pass), row.total(), row.not_asked());
            let count = count as u64;
            let expected = (count, count, count, 0);
            assert_eq!(
                found, expected,
                "cases, passed, asked and not asked of {} of {n}",
                row.name
            );
        }
    }
}

/// Law: a family whose first eight cases are unsupported is left alone, one with a single answer among them is not
/// (docs/conform.md). Oracle: the number of unsupported cases that it begins with.
#[test]
fn eight_unsupported_cases_are_the_most() {
    for judge in [ANSWER, Judge::Law(by_law)] {
        let families = [family("first.a", 1.0, ANSWER), family("lacking.b", 1.0, judge)];
        for n in [1, 7, 8, 9, 66, 100] {
            for lacking in [0, 1, 2, 7, 8, 9, 200] {
                let mut subject = Heard::new(|question: &Value, _| {
                    match question.get("lacking").is_some() && number(question) < lacking {
                        true => Err(Stop::Unsupported("no".to_owned())),
                        false => Ok(json!(1)),
                    }
                });
                let card = card(&mut subject, &families, n);
                let expected = if lacking >= 8 { n.min(8) } else { n };
                let found = subject.count("lacking");
                assert_eq!(found, expected, "questions of {n} of which {lacking} are unsupported");
                let row = &card.rows[1];
                let found = (row.total(), row.not_asked(), row.is_unsupported());
                let expected = (expected as u64, (n - expected) as u64, lacking >= n.min(8));
                assert_eq!(found, expected, "asked, not asked, unsupported: {lacking} of {n}");
            }
        }
    }
}

/// Law: after three faults a family is left alone, after six a whole question, of all families together; the others are asked
/// to their end (docs/conform.md). Oracle: these numbers, and families whose laws ask one question a case.
#[test]
fn three_faults_end_a_family_and_six_a_question() {
    let law = || Judge::Law(by_law);
    let names = ["bad.a", "bad.b", "bad.c", "bad.d", "bad.e"];
    for of_question in 1..=names.len() {
        let mut families = vec![family("good.x", 1.0, law())];
        families.extend(names[..of_question].iter().map(|name| family(name, 1.0, law())));
        let mut subject = Heard::new(|question: &Value, _| match question.get("bad") {
            Some(_) => died(),
            None => Ok(json!(1)),
        });
        let card = card(&mut subject, &families, 20);
        // two of each in the first round, while there were fewer than six; one more of each in the second
        let expected: &[u64] = match of_question {
            1 => &[3],
            2 => &[3, 3],
            3 => &[2, 2, 2],
            4 => &[2, 2, 2, 0],
            _ => &[2, 2, 2, 0, 0],
        };
        let found: Vec<u64> = card.rows[1..].iter().map(|row| row.count(Status::Died)).collect();
        assert_eq!(found, expected, "faults of each of {of_question} families of a question");
        let found = subject.count("bad") as u64;
        assert_eq!(found, expected.iter().sum::<u64>(), "questions of {of_question} families");
        assert_eq!(card.rows[0].count(Status::Pass), 20, "cases passed of another question");
    }
}

/// Law: while nothing is answered, one question of each name is tried, of ordinary families only, and what came back is told
/// for each; from the first reply on, also a refusal, the run goes on (docs/conform.md). Oracle: names by hand.
#[test]
fn one_question_of_each_name_is_tried() {
    let mut families: Vec<Family> =
        ["a.x", "a.y", "b.x", "c.x"].map(|name| family(name, 1.0, ANSWER)).into();
    families.insert(0, Family { ordinary: false, ..family("hard.x", 1.0, ANSWER) });
    let mut silent = Heard::new(|_: &Value, _| died());
    let found = run(&mut silent, &families, &options(5), &mut |_| ());
    let NoAnswer(texts) = found.expect_err("nothing is answered");
    assert_eq!(texts, ["a: a crash", "b: a crash", "c: a crash"], "what came back");
    let expected = ["a.x", "b.x", "c.x"].map(|name| case(name, 0));
    assert_eq!(silent.heard, expected, "the questions to a silent program");
    for reply in [Err(Stop::Refused("no".to_owned())), Err(Stop::Unsupported("no".to_owned()))] {
        let mut late = Heard::new(|question: &Value, _| match question.get("b") {
            Some(_) => reply.clone(),
            None => died(),
        });
        let card = card(&mut late, &families, 1);
        // two easy questions, and one of each of the five families
        assert_eq!(late.heard.len(), 7, "questions, of which b was the first with a reply");
        assert_eq!(card.rows.len(), 5, "families on the card");
    }
}

/// Law: an interrupted run is not whole, asks no family after that, and tells each family once. Oracle: after how many
/// questions it was interrupted.
#[test]
fn an_interrupted_run_asks_no_more() {
    let families = ["a.x", "b.x", "c.x"].map(|name| family(name, 1.0, ANSWER));
    for (after, expected) in [(1, [2, 0, 0]), (3, [2, 2, 0]), (6, [2, 2, 2]), (7, [20, 2, 2])] {
        let interrupted = Arc::new(AtomicBool::new(false));
        let options = Options { interrupted: Arc::clone(&interrupted), ..options(20) };
        let mut subject = Heard::new(|_: &Value, before| {
            interrupted.store(before + 1 > after, Ordering::Relaxed);
            Ok(json!(1))
        });
        let mut told = 0;
        let card = run(&mut subject, &families, &options, &mut |_| told += 1).expect("it answers");
        let found: Vec<u64> = card.rows.iter().map(conform::Row::total).collect();
        assert_eq!(found, expected, "cases asked, interrupted after {after} questions");
        assert_eq!((card.is_whole, told), (false, 3), "whole, and families told");
    }
}

/// Law: a question that is made smaller keeps at least a quarter of the first error (docs/conform.md). Oracle: a
/// program whose error is a tenth to a half of the first where the numbers are simple.
#[test]
fn a_smaller_question_keeps_a_quarter_of_its_error() {
    let family =
        || suite::all().into_iter().find(|it| it.name == "fresnel.cosine").expect("it is there");
    for share in [0.02, 0.1, 0.2, 0.3, 0.5, 1.0] {
        let error = |is_shrunk: bool| {
            let mut subject = Heard::new(|question: &Value, _| {
                let mut answer = conform::ours(question).expect("an answer");
                let data = &question["fresnel"];
                let is_simple = ["eta", "cos_i"].iter().any(|key| data[key].to_string().len() < 6);
                let by = 1e-3 * if is_simple { share } else { 1.0 };
                answer["reflected"] = json!(answer["reflected"].as_f64().expect("a number") + by);
                Ok(answer)
            });
            let options = Options { shrink: is_shrunk, ..options(4) };
            let card = run(&mut subject, &[family()], &options, &mut |_| ()).expect("it answers");
            let failure = card.rows[0].failure.clone().expect("it is wrong");
            (failure.wrong.error, failure.question.to_string().len())
        };
        let ((first, long), (smaller, short)) = (error(false), error(true));
        let kept = smaller / first;
        assert!(
            kept >= 0.25,
            "a smaller question keeps {kept} of its error, a simple one has {share}"
        );
        assert_eq!(
            short < long,
            share >= 0.25,
            "{long} letters became {short}, a simple one has {share} of the error"
        );
    }
}

/// Law: at most 500 questions are asked to make one smaller (docs/conform.md). Oracle: a question of many numbers that
/// is wrong only as it was asked first, and what the program hears.
#[test]
fn at_most_500_questions_make_one_smaller() {
    let mut draw = ask::Draw::new(3);
    let mut corner =
        |from: f64| -> Vec<f64> { (0..3).map(|_| draw.between(from, from + 0.9)).collect() };
    let boxes: Vec<Value> = (0..40)
        .map(|i| json!({"min": corner(f64::from(i)), "max": corner(f64::from(i) + 1.0)}))
        .collect();
    let first = json!({"grid": {"boxes": boxes}});
    let families = || {
        let all = suite::all();
        let mut family =
            all.into_iter().find(|it| it.name == "grid.boxes.resolution").expect("one");
        let first = first.clone();
        family.cases = Box::new(move |_, n| vec![first.clone(); n.min(1)]);
        [family]
    };
    let heard = |is_shrunk: bool| {
        let mut subject = Heard::new(|question: &Value, _| {
            let mut answer = conform::ours(question).expect("an answer");
            if *question == first {
                answer["resolution"] = json!([77, 77, 77]);
            }
            Ok(answer)
        });
        let options = Options { shrink: is_shrunk, ..options(1) };
        let card = run(&mut subject, &families(), &options, &mut |_| ()).expect("it answers");
        assert_eq!(card.rows[0].count(Status::Wrong), 1, "wrong answers: {card}");
        subject.heard.len()
    };
    let more = heard(true) - heard(false);
    // one of them asks whether the first is wrong by the book, too
    assert!((500..=501).contains(&more), "questions to make one smaller: {more}, not 500");
}
