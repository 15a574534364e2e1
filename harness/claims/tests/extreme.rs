//! Extreme values and names: nothing panics on them, no work is without an end, and no name commands a terminal.

use ask::{Invocation, Reply, Subject};
use std::f64::consts::PI;

use claims::{ClaimsCard, ClaimsOptions, junit, listed, page, run, told};
use groundtruth::math::{cos, sin};
use groundtruth::printable;
use serde_json::{Value, json};
use testkit::as_many;

/// Uniform lobes, lights and maps with an extreme value in one field of all answers.
struct Extreme {
    list: Value,
    field: &'static str,
    value: Value,
    asked: usize,
}

impl Extreme {
    /// What belongs into a field, or the extreme value.
    fn field(&self, name: &str, right: Value) -> Value {
        match self.field == name {
            true if right.is_array() => json!([self.value, self.value, 0.5]),
            true => self.value.clone(),
            false => right,
        }
    }

    fn answer(&self, question: &Value) -> Value {
        let Some((name, data)) = question.as_object().and_then(|it| it.iter().next()) else {
            return Value::Null;
        };
        let count = |key: &str| data[key].as_array().map_or(0, Vec::len);
        let all = |key: &str, name: &str, right: f64| -> Value {
            (0..count(key)).map(|_| self.field(name, json!(right))).collect()
        };
        let is_map = data.get("map").is_some();
        let one = |u: &Value| {
            let [a, b] = [0, 1].map(|i| u[i].as_f64().unwrap_or(0.5));
            let (z, r, phi) = (a, (1.0 - a * a).sqrt(), 2.0 * PI * b);
            match is_map {
                true => {
                    let at = self.field("x", json!([a, b, 0.0]));
                    json!([at[0], at[1]])
                }
                false => json!({
                    "wi": self.field("wi", json!([r * cos(phi), r * sin(phi), z])),
                    "weight": self.field("weight", json!(0.5 * z)),
                    "radiance": self.field("radiance", json!(1.0)),
                    "distance": self.field("distance", json!(1.0)),
                    "pdf": self.field("pdf", json!(0.5 / PI)),
                }),
            }
        };
        match name.as_str() {
            "list" => self.list.clone(),
            "eval" => json!({
                "f": all("wi", "f", 0.25 / PI), "radiance": all("wi", "radiance", 1.0),
                "pdf": all("wi", "pdf", 0.5 / PI),
            }),
            "pdf" => all("x", "pdf", 1.0),
            "inverse" => {
                (0..count("x")).map(|_| json!([self.field("inverse", json!(0.5)), 0.5])).collect()
            }
            _ => data["u"].as_array().into_iter().flatten().map(one).collect(),
        }
    }
}

impl Subject for Extreme {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        self.asked += questions.len();
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}

/// One subject of each kind, of this name.
fn list(name: &str) -> Value {
    let wide = json!({"a": [-1e308, 1e308], "b": 1e-320, name: {"one_of": [name, null]}});
    json!([
        {"name": name, "parameters": wide, "claims": {"reciprocal": true, "isotropic": true, "eta": 1e300}},
        {"name": format!("{name} light"), "kind": "light", "points": [vec![-1e308; 3], vec![1e308; 3]]},
        {"name": format!("{name} map"), "kind": "map",
         "claims": {"domain": "square", "invertible": true, "stratified": true}},
    ])
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

/// Law: whatever number a field has, a run ends, on each form of the card, without a panic; where it is none or negative, after few
/// questions. Oracle: a count, 40 for each case, and 300 for each finding that is made smaller; of other values 1000 and 1500.
#[test]
fn extreme_values_end_after_few_questions() {
    let none = ["nan", "inf", "-inf"].map(Value::from).into_iter().take(as_many(1, 3));
    let negative = [-1.0, -1e308].map(Value::from).into_iter().take(as_many(1, 2));
    let bad = none.chain(negative).map(|value| (value, true));
    let others =
        [json!(1e308), json!("x")].into_iter().take(as_many(1, 2)).map(|value| (value, false));
    let fields: [&[&str]; 3] = [
        &["f", "pdf", "weight", "wi"],
        &["radiance", "pdf", "wi", "distance"],
        &["pdf", "x", "inverse"],
    ];
    let list = list("a");
    for (value, is_bad) in bad.chain(others) {
        for (index, fields) in fields.iter().enumerate() {
            for field in *fields {
                let list = json!([list[index]]);
                let mut subject = Extreme { list, field, value: value.clone(), asked: 0 };
                let lobes = listed(&mut subject).expect("a list");
                let options = ClaimsOptions { cases: 2, seed: 3 };
                let card = run(&mut subject, &lobes, options, &mut |_| {});
                forms(&card);
                let findings = card.rows[0].broken().count();
                let is_positive = card.rows[0].broken().any(|(law, _)| law.name == "positive");
                // the last case, and the last that is tried for a finding, may need many more than others
                let most = match is_bad && is_positive {
                    true => 2 * 40 + 300 * findings,
                    false => 2 * 1000 + 1500 * (1 + findings),
                };
                assert!(subject.asked <= most, "{index} {field} {value}: {}", subject.asked);
            }
        }
    }
}

/// Law: names with control and direction characters, quotes and markup are asked as they are and printed so that no terminal obeys
/// them; the questions on the card can still be read. Oracle: the name, found in the questions as JSON reads them.
#[test]
fn names_command_no_terminal_and_are_asked_as_they_are() {
    let names = ["b\u{202e}\u{1b}[31mc\r\n", "\"<&>'\u{7f}\u{e0001}", &"n".repeat(900)];
    for name in names {
        let mut subject = Extreme { list: list(name), field: "f", value: json!(-1), asked: 0 };
        let lobes = listed(&mut subject).expect("a list");
        let card = run(&mut subject, &lobes, ClaimsOptions { cases: 1, seed: 3 }, &mut |_| {});
        let text = forms(&card);
        let question = text.lines().find_map(|line| line.trim().strip_prefix("question    "));
        let read: Value = serde_json::from_str(question.expect("one")).expect("JSON");
        assert_eq!(read["eval"]["lobe"], name);
    }
}
