//! Ends of the ranges of questions: a value at an end is answered, one beyond it is refused.

use conform::probe;
use serde_json::Value;

/// Law: a question is answered at both ends of each range (docs/probe.md), and refused just beyond them. Oracle: the ends, in
/// `ranges.txt`: of each part of a question (`→`) what fits, and behind a semicolon what does not.
#[test]
fn ends_of_ranges_are_answered_and_no_more() {
    let (mut question, mut count) = (Value::Null, 0);
    for line in include_str!("ranges.txt").lines().skip(2) {
        let json =
            |text: &str| serde_json::from_str(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        if let Some(next) = line.strip_prefix('→') {
            question = json(next);
            continue;
        }
        let (pointer, values) = line.split_once(": ").expect("a pointer and values");
        let (fit, unfit) = values.split_once("; ").expect("what fits and what does not");
        for (values, is_answered) in [(fit, true), (unfit, false)] {
            for value in values.split(" | ") {
                let mut asked = question.clone();
                *asked.pointer_mut(pointer).expect("it is there") = json(value);
                let reply: Value = json(&probe::answer(&asked.to_string()));
                let found = (reply.get("answer").is_some(), reply["error"].is_string());
                assert_eq!(found, (is_answered, !is_answered), "{pointer} = {value}: {reply}");
                count += 1;
            }
        }
    }
    assert!(count > 70, "{count} values");
}
