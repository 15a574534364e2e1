//! Extreme names: none commands a terminal, and each is asked as it is.

use ask::Invocation;
use claims::{ClaimsCard, junit, page, told};
use groundtruth::printable;
use serde_json::{Value, json};

use super::counted::{Answers, data};

/// A lobe of this name, as negative everywhere as its density is wrong.
fn answer(name: &str, question: &Value) -> Value {
    if question.get("list").is_some() {
        let wide = json!({"a": [-1e308, 1e308], "b": 1e-320, name: {"one_of": [name, null]}});
        return json!([{"name": name, "parameters": wide, "claims": {"eta": 1e300}}]);
    }
    let all = |key: &str, one: Value| -> Vec<Value> {
        data(question)[key].as_array().into_iter().flatten().map(|_| one.clone()).collect()
    };
    match question.get("eval") {
        Some(_) => json!({"f": all("wi", json!(-1)), "pdf": all("wi", json!(1))}),
        None => json!(all("u", json!({"wi": [0, 0, 1], "weight": 0.5, "pdf": 1}))),
    }
}

/// Each form of a card; what a terminal obeys is on none.
fn forms(card: &ClaimsCard) -> String {
    let program = ["./\u{202e}mine".to_owned()];
    let invocation = Invocation { program: &program, ..Default::default() };
    let told = told(card, &invocation);
    let forms = [told.text(), page(card, &told, "./mine"), junit(card, "./mine")].concat();
    let obeyed = forms.chars().find(|c| printable::is_obeyed(*c) && *c != '\n');
    assert_eq!(obeyed, None, "a character that a terminal obeys");
    forms + &card.json().to_string()
}

/// Law: names with control and direction characters, quotes and markup are asked as they are and printed so that no terminal obeys
/// them; the questions on the card can still be read. Oracle: the name, found in the questions as JSON reads them.
#[test]
fn names_command_no_terminal_and_are_asked_as_they_are() {
    let names = ["b\u{202e}\u{1b}[31mc\r\n", "\"<&>'\u{7f}\u{e0001}", &"n".repeat(900)];
    for name in names {
        let mut subject = Answers(|question: &Value| Ok(answer(name, question)));
        let text = forms(&super::right::card(&mut subject, 1, 3));
        let question = text.lines().find_map(|line| line.trim().strip_prefix("question    "));
        let read: Value = serde_json::from_str(question.expect("one")).expect("JSON");
        assert_eq!(read["eval"]["lobe"], name);
    }
}
