//! Each number of our own answers, moved by more and by less than its tolerance; each field with a value of another type, or
//! missing. By both profiles.

use std::collections::{BTreeMap, BTreeSet};

use conform::family::{Family, Judge};
use conform::{Judgement, Profile, ours, suite};
use serde_json::{Value, json};

use super::constants::NOT_JUDGED;

/// Families whose judge sees one answer, and costs little.
fn cheap() -> Vec<Family> {
    let mut all = suite::all();
    all.retain(|family| {
        let is_exact = ["intersect", "occluded"].contains(&family.question());
        let is_answered = matches!(family.judge, Judge::Answer(_));
        let has_scene = ["radiance", "trace"].contains(&family.question());
        family.ordinary
            && is_answered
            && !has_scene
            && (!is_exact || family.name.ends_with(".ordinary"))
    });
    all
}

fn judge(family: &Family) -> fn(&Value, &Value, Profile) -> Judgement {
    match family.judge {
        Judge::Answer(judge) => judge,
        Judge::Law(_) => unreachable!("only judges of answers are left"),
    }
}

/// The pointers of all parts of a value that are judged; a part stands before those inside of it.
fn places(value: &Value, path: &str, all: &mut Vec<String>) {
    if path.split('/').any(|part| NOT_JUDGED.contains(&part)) {
        return;
    }
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

/// The first cases with an answer, and our answer.
fn answered(family: &Family, count: usize) -> Vec<(Value, Value)> {
    let cases = (family.cases)(11, 4).into_iter();
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
        for (case, right) in answered(family, 2) {
            let mut all = Vec::new();
            places(&right, "", &mut all);
            for path in all {
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
    assert!(tried.values().all(|n| *n > 500), "numbers moved, of each profile: {tried:?}");
    assert!(problems.is_empty(), "numbers that are off by too much or too little: {problems:#?}");
}

type Change = (&'static str, fn(&Value) -> Value);

const CHANGES: [Change; 6] = [
    ("infinite", |_| json!("inf")),
    ("minus infinity", |_| json!("-inf")),
    ("null", |_| Value::Null),
    ("an object", |_| json!({"value": 1})),
    ("in a list", |value| json!([value])),
    ("in quotes", |value| json!(value.to_string())),
];

/// Law: by both profiles, a part of a right answer that is infinite, null, of another type or, inside of a needed
/// field, missing is wrong or the case is not decided. Oracle: our answers, altered; fields that docs/conform.md does
/// not judge are left out.
#[test]
fn each_part_is_judged_by_its_type() {
    let mut problems: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut tried = 0;
    for family in &cheap() {
        let judge = judge(family);
        for (case, right) in answered(family, 1) {
            let mut all = Vec::new();
            places(&right, "", &mut all);
            for path in &all {
                let before = right.pointer(path).expect("it is there");
                for profile in Profile::ALL {
                    for (change, by) in CHANGES {
                        let after = by(before);
                        // parts that are null, and other words, are judged by other laws
                        let is_word = before.is_string() && after.is_string();
                        if after == *before || before.is_null() || is_word {
                            continue;
                        }
                        let mut theirs = right.clone();
                        *theirs.pointer_mut(path).expect("it is there") = after;
                        tried += 1;
                        if judge(&case, &theirs, profile).is_right() {
                            let name = format!("{} {}", family.name, general(path));
                            let what = format!("{change}, {}", profile.name());
                            problems.entry(name).or_default().insert(what);
                        }
                    }
                    // fields at the top may be optional
                    let Some((outer, key)) = path.rsplit_once('/') else { continue };
                    if outer.is_empty() {
                        continue;
                    }
                    let mut theirs = right.clone();
                    match theirs.pointer_mut(outer) {
                        Some(Value::Object(fields)) => {
                            fields.remove(key);
                        }
                        Some(Value::Array(items)) => {
                            items.remove(key.parse().expect("an index"));
                        }
                        _ => continue,
                    }
                    tried += 1;
                    if judge(&case, &theirs, profile).is_right() {
                        let name = format!("{} {}", family.name, general(path));
                        problems
                            .entry(name)
                            .or_default()
                            .insert(format!("missing, {}", profile.name()));
                    }
                }
            }
        }
    }
    assert!(tried > 5_000, "{tried} alterations");
    assert!(problems.is_empty(), "alterations that pass: {problems:#?}");
}
