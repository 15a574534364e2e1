//! `groundtruth conform`: what cases cannot say.

#[path = "../conform/tests/conform/altered.rs"]
#[allow(dead_code)] // the laws of the judge use the rest of it
mod altered;

use std::sync::Arc;
use std::time::Duration;

use ask::{Limits, Program, Reply, Stop, Subject};
use conform::{Options, Profile, Status, ours, suite};
use serde_json::Value;

use self::altered::{each, families};
use crate::kit::{Folder, GROUNDTRUTH};

/// A program that looks through middles of pixels alone, and whose cameras look backwards.
struct MiddlesOnly;

impl Subject for MiddlesOnly {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| {
            if !question["camera_ray"]["place"].is_null() {
                return Err(Stop::Unsupported("place".to_owned()));
            }
            let mut answer = ours(question).expect("an answer");
            each(&mut answer["direction"], |x| -x);
            Ok(answer)
        };
        questions.iter().map(reply).collect()
    }
}

/// Law: a program that lacks a field of many cases is judged by the others, even if it lacks the first two. Oracle: its
/// mistake.
#[test]
fn a_family_is_not_given_up_for_its_first_two_cases() {
    let families = families(&["camera_ray.pinhole.values"]);
    let card = |seed: u64, cases: usize| {
        let options = Options { profile: Profile::Book, seed, ..options(cases) };
        conform::run(&mut MiddlesOnly, &families, &options, &mut |_| {}).expect("it answers")
    };
    let seed = (1..50).find(|&seed| card(seed, 2).rows[0].is_unsupported());
    let card = card(seed.expect("a seed whose first two cases have a place"), 48);
    assert!(card.count(Status::Wrong) > 10, "{card}");
}

/// Law: whatever a program answers, the card for continuous integration is a document of XML 1.0. Oracle: the production
/// `Char` of the specification, and a program that answers characters outside it.
#[test]
fn a_card_holds_no_character_that_xml_does_not() {
    let folder = Folder::new();
    folder.write(
        "odd",
        r#"$P | sed -u 's/"answer":.*/"answer":"\xef\xbf\xbe\\u0001\\ufffe \&<]]>"}/'"#,
    );
    let asked =
        "intersect.sphere.ordinary --cases 8 --junit 'card \u{ffff}.xml' -- sh odd '\u{fffe}'";
    folder.run(&format!("P='groundtruth probe' groundtruth conform {asked}")).expect(1, &[]);
    let card = folder.text("card \u{ffff}.xml");
    let is_held = |c: char| matches!(u32::from(c), 9 | 10 | 13 | 0x20..=0xd7ff | 0xe000..=0xfffd | 0x1_0000..);
    assert!(card.contains("fffe") && card.chars().all(is_held), "{card}");
}

fn options(cases: usize) -> Options {
    let (profile, interrupted) = (Profile::Careful, Arc::default());
    Options { profile, seed: 1, cases, shrink: true, interrupted }
}

/// A shell script as a program, with a second to start and a tenth for an answer.
fn script(text: &str) -> Program {
    let limits = Limits { answer: Duration::from_millis(100), start: Duration::from_secs(1) };
    let command = ["sh", "-c", text, GROUNDTRUTH].map(str::to_owned).to_vec();
    Program::new(command, limits, Arc::default())
}

/// Law: a program that answers nothing costs the time of a start once, whatever the number of kinds of questions.
/// Oracle: the count of texts with this time, and with that of an answer.
#[test]
fn silence_costs_the_time_of_a_start_once() {
    let error =
        conform::run(&mut script("cat > /dev/null"), &suite::all(), &options(1), &mut |_| ());
    let texts = error.expect_err("nothing is answered").0;
    let count = |text: &str| texts.iter().filter(|it| it.ends_with(text)).count();
    assert!(texts.len() >= 15, "{texts:?}");
    assert_eq!((count("within 1 s"), count("within 0.1 s")), (1, texts.len() - 1), "{texts:?}");
}

/// Law: who never answers one kind of question is judged by the others. Oracle: our probe behind a filter of lines.
#[test]
fn who_never_answers_one_kind_is_judged_by_the_others() {
    let mut deaf = script(r#"grep --line-buffered -v '"intersect"' | exec "$0" probe"#);
    let families = families(&["intersect.sphere.ordinary", "fresnel.cosine"]);
    let card = conform::run(&mut deaf, &families, &options(4), &mut |_| ()).expect("it answers");
    let of = |name: &str| card.rows.iter().find(|row| row.name == name).expect(name);
    assert!(of("intersect.sphere.ordinary").count(Status::Hung) > 0, "{card}");
    assert_eq!(of("fresnel.cosine").count(Status::Pass), 4, "{card}");
    // no case costs the time of a start
    assert!(!card.to_string().contains("within 1 s"), "{card}");
}
