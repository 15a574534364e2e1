//! Extreme answers: whatever stands in the place of each number, it is judged, and no judge fails on it.

use ask::Invocation;
use conform::{Profile, card as cards};
use groundtruth::printable;
use serde_json::{Value, json};

use super::altered::{Altered, all_numbers, card};
use testkit::as_many;

/// Law: extreme numbers, and texts, in the place of numbers end nothing; the card has no fault of ours, and no character that
/// a terminal obeys on any form. Oracle: what was planted.
#[test]
fn extreme_answers_are_judged_and_command_no_terminal() {
    let words = [
        "shapes/sphere",
        "fresnel",
        "project",
        "texture",
        "map",
        "lobe",
        "camera_ray",
        "intersect",
    ];
    let words = &words[..as_many(6, words.len())];
    let [nan, inf, less, obeyed] =
        ["nan", "inf", "-inf", "\u{202e}\u{1b}[31m\r<&>"].map(Value::from);
    let [most, least, small, zero] = [1e308, -1e308, 5e-324, -0.0].map(Value::from);
    let values = [
        obeyed,
        most, // the others behave so too
        nan,
        inf,
        less,
        least,
        small,
        zero,
        json!("x".repeat(100_000)),
        json!([[[[]]]]),
    ];
    let count = as_many(2, values.len());
    for value in values.into_iter().take(count) {
        let mut extreme = Altered(|_, answer| all_numbers(answer, &|_| value.clone()));
        let card = card(&mut extreme, words, Profile::Book, 1);
        assert!(card.is_failed(), "{value}");
        for row in &card.rows {
            assert_eq!(row.ours, 0, "{}: faults of ours with {value}", row.name);
        }
        let told = cards::told(&card, &Invocation::default());
        let forms =
            [told.text(), cards::page(&card, &told, "./mine"), cards::junit(&card, "./mine")];
        let obeyed = |c: &char| *c != '\n' && printable::is_obeyed(*c);
        assert_eq!(forms.concat().chars().find(obeyed), None, "a character that a terminal obeys");
    }
}
