//! Each number of our own answers, moved by more and by less than its tolerance; each field with a value of another type, or
//! missing. By both profiles.

use std::collections::{BTreeMap, BTreeSet};

use conform::family::{Family, Judge};
use conform::{Judgement, Profile, ours, suite};
use serde_json::{Value, json};

use super::constants::is_cheap;
use testkit::as_many;

/// Families whose judge sees one answer, and costs little.
fn cheap() -> Vec<Family> {
    let mut all = suite::all();
    all.retain(|family| {
        let is_exact = ["intersect", "occluded"].contains(&family.question());
        let is_answered = matches!(family.judge, Judge::Answer(..));
        let has_scene = ["radiance", "trace"].contains(&family.question());
        family.ordinary
            && is_answered
            && !has_scene
            && (!is_exact || family.name.ends_with(".ordinary"))
    });
    all
}

fn judge(family: &Family) -> impl Fn(&Value, &Value, Profile) -> Judgement {
    match family.judge {
        Judge::Answer(judge, rules) => {
            move |question: &Value, answer: &Value, profile| judge(question, answer, profile, rules)
        }
        Judge::Law(_) => unreachable!("only judges of answers are left"),
    }
}

/// The pointers of all parts of a value, a part before those inside of it.
fn places(value: &Value, path: &str, all: &mut Vec<String>) {
    all.push(path.to_owned());
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, it)| places(it, &format!("{path}/{key}"), all));
        }
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, it)| places(it, &format!("{path}/{i}"), all))
        }
        _ => {}
    }
}

/// Those that are judged.
fn judged_places(family: &Family, right: &Value) -> Vec<String> {
    let is_of_mesh = family.about == "shapes/mesh";
    let is_free =
        |part: &str| is_in(NOT_JUDGED, part) && !(is_of_mesh && OF_MESHES.contains(&part));
    let mut all = Vec::new();
    places(right, "", &mut all);
    all.retain(|path| !path.split('/').any(is_free));
    all
}

/// The first cases with an answer, and our answer.
fn answered(family: &Family, seed: u64, count: usize) -> Vec<(Value, Value)> {
    let cases = (family.cases)(seed, 4).into_iter();
    let all = cases.filter_map(|case| ours(&case).ok().map(|answer| (case, answer)));
    all.filter(|(_, answer)| !answer.is_null()).take(count).collect()
}

/// The pointer with `*` for each index.
fn general(path: &str) -> String {
    let part = |part: &str| if part.parse::<usize>().is_ok() { "*" } else { part }.to_owned();
    path.split('/').map(part).collect::<Vec<_>>().join("/")
}

/// The largest number of the list that a number stands in, or its own size; at least 1.
fn size(answer: &Value, path: &str) -> f64 {
    let list = path.rsplit_once('/').and_then(|(list, _)| answer.pointer(list)?.as_array());
    let own = answer.pointer(path).and_then(Value::as_f64).unwrap_or(0.0).abs();
    let all = list.into_iter().flatten().filter_map(Value::as_f64).map(f64::abs);
    all.fold(own.max(1.0), f64::max)
}

/// Law: with the profile *careful* a number that is off by a thousandth of its size is not right, and one that is off
/// by 2⁻⁵² is not wrong; with *book* these are a fifth and 10⁻⁶. Oracle: our answers, moved; docs/conform.md allows 100
/// u and 10⁻⁴ for a condition of 1.
#[test]
fn each_number_is_judged_to_its_tolerance() {
    let mut problems: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut tried = BTreeMap::new();
    let moves = [
        (Profile::Careful, 1e-3, true),
        (Profile::Book, 0.2, true),
        (Profile::Careful, f64::EPSILON, false),
        (Profile::Book, 1e-6, false),
    ];
    for family in &cheap() {
        let judge = judge(family);
        for (case, right) in answered(family, 11, as_many(1, 2)) {
            for path in judged_places(family, &right) {
                let Some(x) = right.pointer(&path).and_then(Value::as_f64) else { continue };
                for (profile, by, is_wrong) in moves {
                    let mut theirs = right.clone();
                    *theirs.pointer_mut(&path).expect("it is there") =
                        json!(x + by * size(&right, &path));
                    let found = judge(&case, &theirs, profile);
                    let is_problem = if is_wrong { found.is_right() } else { found.is_wrong() };
                    *tried.entry((profile.name(), is_wrong)).or_insert(0) += 1;
                    if is_problem {
                        let words = if is_wrong { "passes" } else { "is wrong" };
                        let what = format!("{by:e} more {words}, {}", profile.name());
                        let name = format!("{} {}", family.name, general(&path));
                        problems.entry(name).or_default().insert(what);
                    }
                }
            }
        }
    }
    assert!(tried.values().all(|n| *n > 250), "numbers moved, of each profile: {tried:?}");
    assert!(problems.is_empty(), "numbers that are off by too much or too little: {problems:#?}");
}

type Change = (&'static str, fn(&Value) -> Value);

/// What is put in the place of a part of a right answer.
const VALUES: [Change; 6] = [
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

/// What is put there of another type, or of no size; by both profiles.
const TYPES: [Change; 6] = [
    ("infinite", |_| json!("inf")),
    ("minus infinity", |_| json!("-inf")),
    ("null", |_| Value::Null),
    ("an object", |_| json!({"value": 1})),
    ("in a list", |value| json!([value])),
    ("in quotes", |value| json!(value.to_string())),
];

/// Fields that docs/conform.md says are not judged: another program does not have them, or has them in a way of its own.
const NOT_JUDGED: &str =
    "error path shading_normal uv condition standard_error replicas samples rays";

/// Of these, those that are judged of meshes, whose corners the question gives.
const OF_MESHES: [&str; 2] = ["shading_normal", "uv"];

/// Fields that may be left out, and are judged where they are there.
const OPTIONAL: &str = "vector fractal_sum turbulence fbm vector_fbm point front film pdf albedo distance ambient inverse min max \
    transmitted r_s r_p t_s t_p refracted";

fn is_in(fields: &str, field: &str) -> bool {
    fields.split(' ').any(|it| it == field)
}

/// Names of parts, and what was done to them, where the answer passed.
type Problems = BTreeMap<String, BTreeSet<String>>;

/// Whether a part of a right answer changed by `by` is wrong, or the case is undecided; else it is a problem.
fn is_seen(
    (family, case, right): (&Family, &Value, &Value),
    (path, change): (&str, &str),
    profile: Profile,
    by: impl FnOnce(&mut Value),
    problems: &mut Problems,
) {
    let mut theirs = right.clone();
    by(&mut theirs);
    let judgement = judge(family)(case, &theirs, profile);
    let is_named =
        matches!(&judgement, Judgement::Lacks(name) if path.strip_prefix('/') == Some(name));
    if theirs != *right && judgement.is_right() && !is_named {
        let what = format!("{change}, {}", profile.name());
        problems.entry(format!("{} {}", family.name, general(path))).or_default().insert(what);
    }
}

/// Law: a right answer in which one part has another value, another type, is not finite, is shorter or longer, or is missing
/// where it is needed, is wrong, or named as missing. Oracle: our answers, altered in each place, by both profiles; an
/// alteration passes only if the field is one of those that are not judged, or if the case is undecided.
#[test]
fn each_part_of_an_answer_is_judged() {
    let (mut problems, mut tried) = (Problems::new(), 0);
    let lists = ["intersect.sphere.all_roots", "intersect.scene.first_hit"];
    for (number, family) in suite::all().iter().filter(|family| is_cheap(family)).enumerate() {
        // exact answers take long, and have one judge
        let is_exact = ["intersect", "occluded"].contains(&family.question());
        let has_judge_of_another = is_exact && !family.name.ends_with(".ordinary");
        let is_answered = matches!(family.judge, Judge::Answer(..));
        if !is_answered || has_judge_of_another && !lists.contains(&&*family.name) {
            continue;
        }
        let has_scene = ["radiance", "trace"].contains(&family.question()) || has_judge_of_another;
        for (index, (case, right)) in
            answered(family, 7, if is_exact { 1 } else { as_many(1, 3) }).iter().enumerate()
        {
            let it = (family, case, right);
            // a fifth of the places, of each family others
            let (first, step) = as_many((number % 5, 5), (0, 1));
            for path in judged_places(family, right).iter().skip(first).step_by(step) {
                let before = right.pointer(path).expect("it is there");
                let put = |after: Value| {
                    move |theirs: &mut Value| *theirs.pointer_mut(path).expect("there") = after
                };
                for (change, by) in VALUES.into_iter().filter(|_| !path.is_empty()) {
                    if !is_harmless(&family.name, path, before, change) {
                        tried += 1;
                        let place = (&**path, change);
                        is_seen(it, place, Profile::Careful, put(by(before)), &mut problems);
                    }
                }
                if index > 0 || has_scene {
                    continue;
                }
                for profile in Profile::ALL {
                    for (change, by) in TYPES {
                        let after = by(before);
                        // parts that are null, and other words, are judged by other laws
                        if !(before.is_null() || before.is_string() && after.is_string()) {
                            tried += 1;
                            is_seen(it, (path, change), profile, put(after), &mut problems);
                        }
                    }
                    // fields at the top may be optional
                    let inner = path.rsplit_once('/').filter(|(outer, _)| !outer.is_empty());
                    if let Some((outer, key)) = inner {
                        let without = |theirs: &mut Value| remove(theirs, outer, key);
                        is_seen(it, (path, "missing"), profile, without, &mut problems);
                    }
                }
            }
            for field in right.as_object().into_iter().flatten().map(|(field, _)| field) {
                // of a hit in a scene, the object and its distance are needed
                let is_of_scene = family.name == "intersect.scene.first_hit" && field == "normal";
                let is_optional = is_in(NOT_JUDGED, field) || is_in(OPTIONAL, field);
                if !is_optional && !is_of_scene {
                    let place = (&*format!("/{field}"), "missing");
                    let without = |theirs: &mut Value| remove(theirs, "", field);
                    is_seen(it, place, Profile::Careful, without, &mut problems);
                }
            }
        }
    }
    assert!(tried > 2_000, "{tried} alterations");
    assert!(problems.is_empty(), "alterations that pass: {problems:#?}");
}

/// Leaves out a field or an item.
fn remove(answer: &mut Value, of: &str, key: &str) {
    match answer.pointer_mut(of) {
        Some(Value::Object(fields)) => drop(fields.remove(key)),
        Some(Value::Array(items)) => drop(items.remove(key.parse().expect("an index"))),
        _ => {}
    }
}

/// What is another way to say the same.
fn is_harmless(family: &str, path: &str, before: &Value, change: &str) -> bool {
    // mirrors have no density: some programs say 1, some 0
    let is_specular = path == "/sample/pdf" && before == "inf" && change == "another value";
    // at an edge of two faces, either normal is right
    let is_normal = family.starts_with("intersect.") && path.contains("/normal/");
    is_specular || is_normal && change == "another value"
}
