//! Questions to a program, and counts of its answers: parameters, viewers, random numbers, and the numbers on each form of the
//! card.

use ask::{Reply, Subject, numbers};
use std::f64::consts::PI;

use claims::{ClaimsCard, junit, page, told};
use serde_json::{Value, json};

/// Lambert's lobe, whose answers may be changed, and what it was asked.
pub struct Lambert<F> {
    claims: Value,
    pub parameters: Value,
    /// From question and answer.
    change: F,
    pub heard: Vec<Value>,
}

impl<F: FnMut(&Value, Value) -> Value> Lambert<F> {
    pub fn new(claims: Value, parameters: Value, change: F) -> Self {
        Self { claims, parameters, change, heard: Vec::new() }
    }

    fn answer(&mut self, question: &Value) -> Value {
        if question.get("list").is_some() {
            return json!([{"name": "lambert", "claims": self.claims, "parameters": self.parameters}]);
        }
        self.heard.push(question.clone());
        // a direction that `change` made no direction comes back in questions
        let vector = |w: &Value| -> [f64; 3] {
            numbers(w).and_then(|w| w.try_into().ok()).unwrap_or([0.0, 0.0, 1.0])
        };
        let is_eval = question.get("eval").is_some();
        let data = &question[if is_eval { "eval" } else { "sample" }];
        let wo = vector(&data["wo"]);
        let list = |key: &str| data[key].as_array().expect("a list").iter();
        let pdf = |z: f64| if z * wo[2] > 0.0 { z.abs() / PI } else { 0.0 };
        let answer = if is_eval {
            let z: Vec<f64> = list("wi").map(|w| vector(w)[2]).collect();
            let f = |z: &f64| if z * wo[2] > 0.0 { [0.7 / PI; 3] } else { [0.0; 3] };
            json!({
                "f": z.iter().map(f).collect::<Vec<_>>(),
                "pdf": z.iter().map(|z| pdf(*z)).collect::<Vec<f64>>(),
            })
        } else {
            let one = |u: &Value| {
                let u = numbers(u).expect("numbers");
                let (r, phi) = (u[0].sqrt(), 2.0 * PI * u[1]);
                let [x, y] =
                    [groundtruth::math::cos(phi), groundtruth::math::sin(phi)].map(|c| r * c);
                let z = (1.0 - u[0]).sqrt().copysign(wo[2]);
                json!({"wi": [x, y, z], "weight": vec![0.7; 3], "pdf": pdf(z)})
            };
            list("u").map(one).collect()
        };
        (self.change)(question, answer)
    }
}

impl<F: FnMut(&Value, Value) -> Value> Subject for Lambert<F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}

pub fn card(subject: &mut dyn Subject, cases: usize) -> ClaimsCard {
    super::right::card(subject, cases, 5)
}

pub fn first(card: &ClaimsCard) -> Option<&'static str> {
    Some(card.rows[0].broken().next()?.0.name)
}

/// Answers by a function.
pub struct Answers<F>(pub F);

impl<F: FnMut(&Value) -> Reply> Subject for Answers<F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(&mut self.0).collect()
    }
}

pub type Vector = [f64; 3];

/// A vector of three numbers, or of two and 0.
pub fn vector(value: &Value) -> Vector {
    let mut all = numbers(value).expect("numbers");
    all.resize(3, 0.0);
    [all[0], all[1], all[2]]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// The data of a question.
pub fn data(question: &Value) -> &Value {
    question.as_object().and_then(|it| it.values().next()).expect("data")
}

/// Law (docs/laws.md): the first case has the low ends of all ranges and the first choice, the second the high ends; in others,
/// values lie between, with two digits; numbers stay. The angle of the viewer is 45°, 45°, 10°, 75° and 89° in the first five
/// cases, then anything below 88°; the first azimuth is 0; every second viewer is below the surface if that is claimed. Oracle:
/// these numbers, and the questions.
#[test]
fn cases_have_the_parameters_and_viewers_that_are_documented() {
    for is_below in [false, true] {
        let parameters = json!({
            "a": 0.25, "b": [0.5, 3.0], "c": [0.001, 100.0], "d": {"one_of": ["x", "y", "z"]},
        });
        let claims = json!({"from_below": is_below, "reciprocal": true});
        let mut subject = Lambert::new(claims, parameters, |_, answer| answer);
        let found = card(&mut subject, 9);
        assert_eq!(first(&found), None, "{found}");
        // the first question of each case is that of the law of repetition: a sample of four
        let mut cases: Vec<(Value, [f64; 3])> = Vec::new();
        for question in subject.heard.iter().filter(|it| it.get("sample").is_some()) {
            let given = &data(question)["parameters"];
            if data(question)["u"].as_array().map(Vec::len) == Some(4)
                && cases.last().is_none_or(|last| last.0 != *given)
            {
                let wo = numbers(&data(question)["wo"]).expect("a direction");
                cases.push((given.clone(), [wo[0], wo[1], wo[2]]));
            }
        }
        assert_eq!(cases.len(), 9, "cases that were asked");
        for (index, (given, [x, y, z])) in cases.iter().enumerate() {
            let number = |key: &str| given[key].as_f64().expect("a number");
            assert_eq!(number("a"), 0.25, "the number of case {index}");
            for (key, low, high) in [("b", 0.5, 3.0), ("c", 0.001, 100.0)] {
                let found = number(key);
                match index {
                    0 => assert_eq!(found, low, "the low end of {key}"),
                    1 => assert_eq!(found, high, "the high end of {key}"),
                    _ => {
                        assert!((low..=high).contains(&found), "{key} = {found} in case {index}");
                        let typed: f64 = format!("{found:.1e}").parse().expect("a number");
                        assert_eq!(typed, found, "two digits of {key} in case {index}");
                    }
                }
            }
            let choice = given["d"].as_str().expect("a text");
            assert!(index > 0 || choice == "x", "the first choice is {choice}");
            assert!(["x", "y", "z"].contains(&choice), "the choice {choice}");
            let length = (x * x + y * y + z * z).sqrt();
            assert!((length - 1.0).abs() < 1e-14, "the length of the viewer {index} is {length}");
            let is_under = is_below && index % 2 == 1;
            assert_eq!(*z < 0.0, is_under, "whether the viewer {index} is below");
            let angle = groundtruth::math::to_degrees(groundtruth::math::acos(z.abs()));
            match [45.0, 45.0, 10.0, 75.0, 89.0].get(index) {
                Some(easy) => assert!((angle - easy).abs() < 1e-9, "the angle {index} is {angle}"),
                None => assert!((0.0..88.0).contains(&angle), "the angle {index} is {angle}"),
            }
            assert!(index > 0 || *y == 0.0 && *x > 0.0, "the azimuth of the first viewer");
        }
    }
}

/// Law: each form of a card has the counts of its rows. Oracle: the forms, read by a person.
#[test]
fn forms_of_a_card_say_the_same() {
    let change = |_: &Value, answer| super::mistakes::scaled(answer, "", &["weight"], 2.0);
    let card = card(&mut Lambert::new(json!({"isotropic": true}), json!({}), change), 2);
    let told = told(&card, &Default::default());
    let page = page(&card, &told, "./mine");
    let rows: Vec<&str> = page.lines().filter(|line| line.contains("<tr")).collect();
    let forms = [told.text(), rows.join("\n"), junit(&card, "./mine"), card.json().to_string()];
    insta::assert_snapshot!("card", forms.join("\n\n"));
}

/// Law: a mistake in one sample of eighteen, which no single case shows beyond doubt, is found from all cases together; the law is
/// asked again with other random numbers, ten times as many. Oracle: what was planted; all numbers that the program was asked
/// with, of which no four come twice.
#[test]
fn what_is_asked_again_has_numbers_of_its_own() {
    let mut subject = Lambert::new(json!({}), json!({}), super::mistakes::few_are_uniform);
    let card = card(&mut subject, 6);
    assert_eq!(first(&card), Some("density"), "{card}");
    // a few numbers are those of the law of repetition; a case that is made smaller has the same ones for each viewer
    let asked = subject
        .heard
        .iter()
        .filter_map(|it| Some((&it["sample"]["wo"], it["sample"]["u"].as_array()?)));
    let asked = asked.filter(|(_, u)| u.len() > 4);
    let mut heard: Vec<String> =
        asked.flat_map(|(wo, u)| u.iter().map(move |u| format!("{wo} {u}"))).collect();
    let count = heard.len();
    // of each case 2,048 place the cells and 16,384 are counted; 163,840 are counted again
    assert!(count > 6 * 16_384 + 163_840, "numbers that were asked with: {count}");
    heard.sort_unstable();
    heard.dedup();
    assert_eq!(heard.len(), count, "different numbers of {count}");
}

/// Law: points that are not stratified have the variance of independent points. Oracle: the ratio 1, for a map that scrambles
/// its strata; the mean of eight cards.
#[test]
fn scrambled_points_have_the_variance_of_independent_ones() {
    let shares = (0..8).map(|seed| {
        let mut map = super::squares::Squares::new(&["disk"], "scrambled", false);
        let card = super::right::card(&mut map, 1, seed);
        let broken = card.rows[0].broken().find(|(law, _)| law.name == "stratified");
        let (_, broken) =
            broken.unwrap_or_else(|| panic!("scrambled points are not found\n{card}"));
        let number = broken.breach.found.split("have ").nth(1).and_then(|it| it.split(' ').next());
        number.and_then(|it| it.parse::<f64>().ok()).expect("a number")
    });
    let mean = shares.sum::<f64>() / 8.0;
    // over 8 × 48 degrees of freedom its standard deviation is 0.07
    assert!((mean - 1.0).abs() < 0.2, "the variance is {mean} times that of independent points");
}
