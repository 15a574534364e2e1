//! Programs that answer the same to every question, nothing, too much, or something else in one place of a right answer.

use ask::{Asking, Reply, Stop, Subject};
use std::collections::{BTreeMap, BTreeSet};

use conform::family::{Family, Judge};
use conform::{Judgement, Ours, Profile, ours, suite};
use serde_json::{Value, json};

use super::altered::{Altered, card};

struct Constant(Value);

impl Subject for Constant {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|_| Ok(self.0.clone())).collect()
    }
}

/// Cases of a family: enough that not all of them have the same answer.
const CASES: usize = 6;
/// Statistical laws ask up to 1500 questions a case; the hard families have the judges of the ordinary ones.
fn is_cheap(family: &Family) -> bool {
    family.ordinary && !family.name.ends_with(".density") && !family.name.ends_with(".stream")
}

/// The judge's word on a case.
fn judged(family: &Family, subject: &mut dyn Subject, case: &Value) -> Option<Judgement> {
    match family.judge {
        Judge::Answer(judge) => match subject.ask(std::slice::from_ref(case)).pop() {
            Some(Ok(answer)) => Some(judge(case, &answer, Profile::Careful)),
            _ => None,
        },
        Judge::Law(law) => law(&mut Asking::new(subject), case, Profile::Careful).ok(),
    }
}

fn is_wrong(judgement: &Option<Judgement>) -> bool {
    matches!(judgement, Some(Judgement::Wrong(_)))
}

/// The families that let a subject pass all of their first cases; `subject` is told the right answer to the first.
fn blind(
    families: &[Family],
    cases: usize,
    mut subject: impl FnMut(&Value) -> Constant,
) -> Vec<String> {
    let passes = |family: &&Family| {
        let cases = (family.cases)(7, cases);
        let answers = cases.iter().filter_map(|case| ours(case).ok());
        // that nothing is there is another constant
        let first = answers.into_iter().find(|it| !it.is_null()).unwrap_or_default();
        let mut subject = subject(&first);
        !cases.iter().any(|case| is_wrong(&judged(family, &mut subject, case)))
    };
    families.iter().filter(passes).map(|family| family.name.clone()).collect()
}

/// Law: no family is passed by one answer to everything, and no answer stops the judge. Oracle: constants of every
/// kind of JSON, nothing, an empty object, NaN, and the right answer to the family's first case.
#[test]
fn no_constant_passes() {
    let families: Vec<Family> = suite::all().into_iter().filter(is_cheap).collect();
    let constants =
        [json!(null), json!(false), json!(42), json!([]), json!({}), json!("nan"), json!("pi")];
    for constant in constants {
        let names = blind(&families, CASES, |_| Constant(constant.clone()));
        // some shapes are hit by no ray of a few, or by each
        let is_guess = |name: &String| {
            let half = name.starts_with("occluded.") && constant == json!(false);
            let misses = name.starts_with("intersect.") && constant.is_null();
            let sides = name.ends_with(".sides") && constant == json!([]);
            half || misses || sides || name.starts_with("project.") && constant.is_null()
        };
        let names: Vec<String> = names.into_iter().filter(|name| !is_guess(name)).collect();
        assert!(names.is_empty(), "{constant} passes {names:?}");
    }
    let names = blind(&families, 48, |first| Constant(first.clone()));
    // two laws hold for one answer to all: it is the same again, and as smooth
    let names: Vec<String> = names.into_iter().filter(|name| !is_law_of_one_answer(name)).collect();
    assert!(names.is_empty(), "the first right answer passes {names:?}");
}

/// Laws that a right answer keeps, whatever the question: another family of the same question tells it.
fn is_law_of_one_answer(name: &str) -> bool {
    let last = name.rsplit('.').next().unwrap_or_default();
    ["energy", "reciprocity", "shares", "inverse", "sides", "smooth", "strata", "sample"]
        .contains(&last)
}

/// A name, and what it makes of a part of an answer.
type Change = (&'static str, fn(&Value) -> Value);

/// What is put in the place of a part of a right answer.
const CHANGES: [Change; 6] = [
    ("another value", |value| match value {
        Value::Number(x) => json!(x.as_f64().map_or(0.0, |x| 1.5 * x + 0.25)),
        Value::Bool(is) => json!(!is),
        Value::String(text) if text == "inf" => json!(3.0),
        Value::String(text) => json!(format!("{text}!")),
        Value::Array(items) => items.iter().rev().skip(1).rev().cloned().collect(),
        _ => json!({"other": 1}),
    }),
    ("text", |_| json!("yes")),
    ("a truth value or a number", |value| if value.is_boolean() { json!(1) } else { json!(true) }),
    ("NaN", |_| json!("nan")),
    ("an empty list", |value| if *value == json!([]) { json!([0.5]) } else { json!([]) }),
    ("one item more", |value| match value {
        Value::Array(items) => {
            let more = items.last().cloned().unwrap_or_else(|| json!(0.5));
            items.iter().cloned().chain([more]).collect()
        }
        _ => json!([value, value]),
    }),
];

/// All places of an answer, as JSON pointers; and the same with `*` for indices.
fn places(value: &Value, path: &str, all: &mut Vec<(String, String)>, name: &str) {
    if !path.is_empty() {
        all.push((path.to_owned(), name.to_owned()));
    }
    match value {
        Value::Object(fields) => fields.iter().for_each(|(key, value)| {
            places(value, &format!("{path}/{key}"), all, &format!("{name}/{key}"))
        }),
        Value::Array(items) => items.iter().enumerate().for_each(|(i, value)| {
            places(value, &format!("{path}/{i}"), all, &format!("{name}/*"))
        }),
        _ => {}
    }
}

/// Fields that docs/conform.md says are not judged: another program does not have them, or has them in a way of its own.
pub const NOT_JUDGED: [&str; 9] = [
    "error",
    "path",
    "shading_normal",
    "uv",
    "condition",
    "standard_error",
    "replicas",
    "samples",
    "rays",
];

/// Of these, those that are judged of meshes, whose corners the question gives.
const OF_MESHES: [&str; 2] = ["shading_normal", "uv"];

/// Fields that may be left out, and are judged where they are there.
const OPTIONAL: [&str; 21] = [
    "vector",
    "fractal_sum",
    "turbulence",
    "fbm",
    "vector_fbm",
    "point",
    "front",
    "film",
    "pdf",
    "albedo",
    "distance",
    "ambient",
    "inverse",
    "min",
    "max",
    "transmitted",
    "r_s",
    "r_p",
    "t_s",
    "t_p",
    "refracted",
];

/// Law: a right answer in which one part has another value, another type, is NaN, is shorter or longer, or is missing
/// where it is needed, is wrong, or named as missing. Oracle: our answers, altered in each place; an alteration passes only if the field is
/// one of those that are not judged, or if the case is undecided.
#[test]
fn each_part_of_an_answer_is_judged() {
    let mut problems: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut tried = 0;
    for family in suite::all().iter().filter(|family| is_cheap(family)) {
        let Judge::Answer(judge) = family.judge else { continue };
        // exact answers take long, and have one judge
        let is_exact = ["intersect", "occluded"].contains(&family.question());
        let has_judge_of_another = is_exact && !family.name.ends_with(".ordinary");
        let is_list = ["intersect.sphere.all_roots", "intersect.scene.first_hit"];
        if has_judge_of_another && !is_list.contains(&&*family.name) {
            continue;
        }
        let cases = (family.cases)(7, 4);
        let answered = cases.iter().filter_map(|case| Some((case, ours(case).ok()?)));
        let answered = answered.filter(|(_, right)| !right.is_null());
        for (case, right) in answered.take(if is_exact { 1 } else { 3 }) {
            let mut all = Vec::new();
            places(&right, "", &mut all, "");
            let is_of_mesh = family.about == "shapes/mesh";
            let is_judged = |(_, name): &&(String, String)| {
                let is_free =
                    |part| NOT_JUDGED.contains(&part) && !(is_of_mesh && OF_MESHES.contains(&part));
                !name.split('/').any(is_free)
            };
            for (path, name) in all.iter().filter(is_judged) {
                for (change, by) in CHANGES {
                    let mut theirs = right.clone();
                    let slot = theirs.pointer_mut(path).expect("it is there");
                    let before = slot.clone();
                    *slot = by(&before);
                    if *slot == before || is_harmless(&family.name, path, &before, change) {
                        continue;
                    }
                    tried += 1;
                    if let Judgement::Right(_) = judge(case, &theirs, Profile::Careful) {
                        let what = format!("{} {name}", family.name);
                        problems.entry(what).or_default().insert(change.to_owned());
                    }
                }
            }
            for field in right.as_object().into_iter().flatten().map(|(field, _)| field) {
                let mut theirs = right.clone();
                theirs.as_object_mut().map(|fields| fields.remove(field));
                // of a hit in a scene, the object and its distance are needed
                let is_of_scene = family.name == "intersect.scene.first_hit" && field == "normal";
                let is_optional = NOT_JUDGED.contains(&&**field) || OPTIONAL.contains(&&**field);
                let is_optional = is_optional || is_of_scene;
                let judged = judge(case, &theirs, Profile::Careful);
                // what is left out of more parts is named
                let is_named = matches!(&judged, Judgement::Lacks(name) if name == field);
                if !is_optional && judged.is_right() && !is_named {
                    let what = format!("{} {field}", family.name);
                    problems.entry(what).or_default().insert("missing".to_owned());
                }
            }
        }
    }
    assert!(tried > 5_000, "{tried}");
    assert!(problems.is_empty(), "{problems:#?}");
}

/// What is another way to say the same.
fn is_harmless(family: &str, path: &str, before: &Value, change: &str) -> bool {
    // mirrors have no density: some programs say 1, some 0
    let is_specular = path == "/sample/pdf" && before == "inf" && change == "another value";
    // at an edge of two faces, either normal is right
    let is_normal = family.starts_with("intersect.") && path.contains("/normal/");
    is_specular || is_normal && change == "another value"
}

/// Law: a part that a law reads has to be a number, and there. Oracle: our answers to all questions, altered in one
/// field of those that the law holds against each other.
#[test]
fn laws_are_broken_by_what_is_no_number() {
    let mut problems = Vec::new();
    let read = [
        "t",
        "normal",
        "f",
        "albedo",
        "pdf",
        "image",
        "matrix",
        "direction",
        "distance",
        "reflected",
        "value",
        "vector",
        "fractal_sum",
        "turbulence",
        "fbm",
        "vector_fbm",
    ];
    for family in suite::all().iter().filter(|family| is_cheap(family)) {
        let Judge::Law(_) = family.judge else { continue };
        let fields: Vec<&str> = read.into_iter().filter(|it| is_read(&family.name, it)).collect();
        if fields.is_empty() {
            continue;
        }
        let is_right = |subject: &mut dyn Subject, case: &Value| {
            judged(family, subject, case).is_some_and(|judgement| judgement.is_right())
        };
        let mut cases = (family.cases)(7, 3);
        cases.retain(|case| is_right(&mut Ours, case));
        for field in fields {
            for what in ["NaN", "text"] {
                if cases.iter().any(|case| is_right(&mut Broken { field, what }, case)) {
                    problems.push(format!("{}: {field} is {what}", family.name));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{problems:#?}");
}

/// Whether the law of a family needs a field.
fn is_read(family: &str, field: &str) -> bool {
    let last = family.rsplit('.').next().unwrap_or_default();
    match last {
        "direction_length" => field == "t",
        "sides" => family.starts_with("intersect.") && ["t", "normal"].contains(&field),
        "reciprocity" => field == "f",
        "energy" => field == "albedo",
        "there_and_back" => field == "image" && family.starts_with("camera_ray."),
        "inverse" => field == "matrix",
        "shares" => field == "reflected",
        "linear" | "cubic" | "knots" => field == "value",
        "sums" => ["value", "fractal_sum", "turbulence", "fbm", "vector_fbm"].contains(&field),
        _ => false,
    }
}

/// Our answers with one field that is no number, wherever it is.
struct Broken {
    field: &'static str,
    what: &'static str,
}

impl Broken {
    fn spoil(&self, value: &mut Value) {
        match value {
            Value::Object(fields) => {
                for (key, value) in fields {
                    match key == self.field {
                        true => *value = json!(if self.what == "NaN" { "nan" } else { "yes" }),
                        false => self.spoil(value),
                    }
                }
            }
            Value::Array(items) => items.iter_mut().for_each(|item| self.spoil(item)),
            _ => {}
        }
    }
}

impl Subject for Broken {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| match ours(question) {
            Ok(mut answer) => {
                self.spoil(&mut answer);
                Ok(answer)
            }
            Err(error) => Err(Stop::Refused(error)),
        };
        questions.iter().map(reply).collect()
    }
}

/// Law: three cells too many, and no cell, are no way through a grid. Oracle: our own cells.
#[test]
fn a_list_has_a_length() {
    let more: fn(&Value, Value) -> Value = |_, mut a| {
        if let Some(cells) = a["visited"].as_array_mut() {
            cells.extend(vec![json!({"cell": [0, 0, 0], "objects": []}); 3]);
        }
        a
    };
    let none: fn(&Value, Value) -> Value = |_, mut a| {
        a["visited"] = json!([]);
        a
    };
    for alter in [more, none] {
        let card = card(&mut Altered(alter), &["grid.boxes.visited"], Profile::Careful, 24);
        assert!(card.is_failed(), "{card}");
    }
}

/// Law: a question about an algebraic surface shrinks without end of the judge, though it may have no normal where it
/// is hit any more. Oracle: a program that says of every surface that it is missed.
#[test]
fn surfaces_without_a_normal_do_not_stop_the_judge() {
    let card =
        card(&mut Constant(json!(null)), &["intersect.algebraic.ordinary"], Profile::Careful, 4);
    assert!(card.is_failed());
}
