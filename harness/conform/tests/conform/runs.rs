//! A run: what is selected, what is left alone, and that a fault of one case, theirs or ours, costs no other.

use ask::{Fault, Reply, Stop, Subject};

use conform::family::{Family, Judge};
use conform::{self, Judgement, Options, Profile, Row, Rules, Status, WHOLE, ours};
use conform::{card as cards, suite};
use serde_json::{Value, json};

use super::altered::{Says, card_with, family, options};

fn panics_at_three(question: &Value, _: &Value, _: Profile, _: &Rules) -> Judgement {
    assert_ne!(question["number"]["is"], 3, "three is too much");
    Judgement::Right(0.0)
}

/// Law: a judge that panics costs its case, which is shown; all others are judged, and the card says whose fault it is.
/// Oracle: a judge that panics at one of ten cases.
#[test]
fn a_judge_that_panics_costs_one_case() {
    let by_law = Judge::Law(|ask, case, profile| {
        let answer = ask.ask(case)?;
        Ok(panics_at_three(case, &answer, profile, &WHOLE))
    });
    let cases = |n| (0..n).map(|i| json!({"number": {"is": i}})).collect();
    let families = [
        family("number.answer", Judge::Answer(panics_at_three, &WHOLE), cases),
        family("number.law", by_law, cases),
    ];
    let options = Options { shrink: true, ..options(10) };
    let mut null = Says(|_| Value::Null);
    let card = conform::run(&mut null, &families, &options, &mut |_| ()).expect("it answers");
    for row in &card.rows {
        let counts = (row.count(Status::Pass), row.count(Status::Undecided), row.ours);
        assert_eq!(counts, (9, 1, 1), "{}", row.name);
    }
    assert!(!card.is_failed() && card.is_not_judged());
    let text = card.to_string();
    assert!(
        text.contains("three is too much") && text.contains(r#"{"number":{"is":3}}"#),
        "{text}"
    );
    let last = card.to_string();
    assert!(last.contains("2 cases were not judged, by a fault of ours"), "{last}");
    let junit = cards::junit(&card, "null");
    assert!(junit.contains("errors=\"2\""), "{junit}");
}

/// Law: a word selects what begins with it and goes on with `/`, `.` or `_`, and no other. Oracle: names by hand.
#[test]
fn a_word_selects_whole_words_of_names() {
    let names = |word: &str| -> Vec<String> {
        let is_selected = |family: &Family| family.is_selected_by(word);
        suite::all().into_iter().filter(is_selected).map(|family| family.name).collect()
    };
    let lamps = names("light.area");
    for lamp in ["rectangle", "disk", "sphere"] {
        assert!(lamps.contains(&format!("light.area.{lamp}.area")), "{lamps:?}");
    }
    assert!(names("shapes/solid").iter().any(|name| name.starts_with("intersect.solid_cone.")));
    assert!(names("intersect.torus").iter().all(|name| name.starts_with("intersect.torus.")));
    for nothing in ["light.are", "intersect.tor", "shapes/tor", "ch0", ""] {
        assert_eq!(names(nothing), [""; 0], "{nothing:?}");
    }
}

/// Does not have lobes; dies of every question about grids.
struct Half;

impl Subject for Half {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| match question {
            question if question.get("lobe").is_some() => Err(Stop::Unsupported("no".to_owned())),
            question if question.get("grid").is_some() => {
                Err(Stop::Fault(Fault::Died("a crash".to_owned())))
            }
            question => Ok(ours(question).expect("an answer")),
        };
        questions.iter().map(reply).collect()
    }
}

/// Law: the first line counts families that failed, of those judged; a line those that were not, and were left alone; and a
/// family tells how many cases were not asked after faults. Oracle: a subject without lobes that dies of grids; counts
/// of the families' names.
#[test]
fn the_card_says_what_was_left_alone_and_why() {
    let words = ["lobe.lambertian.values", "lobe.lambertian.sample", "grid", "fresnel.cosine"];
    let card = card_with(&mut Half, &words, Profile::Careful, 200, false);
    let grids: Vec<&Row> = card.rows.iter().filter(|row| row.name.starts_with("grid.")).collect();
    let (first, text) = (cards::verdict(&card, false), card.to_string());
    let judged = grids.iter().filter(|row| row.total() > 0).count() + 1;
    let left = grids.iter().filter(|row| row.not_asked() > 0).count();
    assert!(left > 0, "{card}");
    let failed = format!("{} of {judged} families failed (seed 7); ", judged - 1);
    let rest =
        format!("\nnot judged: 2 families are unsupported, left alone after 8 cases; {left} w");
    assert!(first.starts_with(&failed), "{first}");
    assert!(text.contains(&rest) && text.contains("left alone after faults"), "{text}");
    let row = grids.iter().find(|row| row.not_asked() > 0 && row.total() > 0).expect("one");
    let text = format!(
        "{}: {} of {} cases were not asked after these faults",
        row.name,
        row.not_asked(),
        row.cases
    );
    assert!(card.to_string().contains(&text), "{text}: {card}");
    let json = card.json();
    let of_row =
        json["families"].as_array().into_iter().flatten().find(|it| it["family"] == *row.name);
    assert_eq!(of_row.expect("it is there")["not_asked"], row.not_asked());
}
