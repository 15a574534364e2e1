//! Programs that answer nothing, or not every kind of question.

use std::sync::Arc;
use std::time::Duration;

use conform::{Limits, Profile, Program, Status, suite};

use super::altered::families;

fn options(cases: usize) -> conform::Options {
    let (profile, interrupted) = (Profile::Careful, Arc::default());
    conform::Options { profile, seed: 1, cases, shrink: true, interrupted }
}

/// A shell script as a program, with a second to start and a tenth for an answer.
fn script(text: &str) -> Program {
    let limits = Limits { answer: Duration::from_millis(100), start: Duration::from_secs(1) };
    let command = ["sh", "-c", text, env!("CARGO_BIN_EXE_groundtruth")].map(str::to_owned).to_vec();
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
