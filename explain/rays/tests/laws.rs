use rays::{Outcome, RayVerdict, Traced, read, world_of};
use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

#[derive(Deserialize)]
struct Cases {
    case: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    law: String,
    log: Vec<String>,
    broken: Vec<(usize, Map<String, Value>)>,
    cause: Option<String>,
}

fn cases() -> Vec<Case> {
    let cases: Cases = toml::from_str(include_str!("laws.toml")).expect("cases");
    cases.case
}

/// The log with these lines.
pub fn traced(lines: &[String]) -> Traced {
    let text = lines.iter().map(|line| format!("{line}\n")).collect::<String>();
    let log = read(text.as_bytes()).expect("a log");
    assert_eq!(log.damaged, []);
    let world = world_of(&log, Path::new(""), |name| Err(name.to_owned())).expect("objects");
    Traced::of(log, world.map(|(_, world)| Arc::new(world)))
}

fn edited(case: &Case) -> Vec<String> {
    let mut lines = case.log.clone();
    for (number, fields) in &case.broken {
        let mut line: Map<String, Value> =
            serde_json::from_str(&lines[number - 1]).expect("an object");
        for (name, value) in fields {
            // TOML has no null
            let value = if value == "null" { Value::Null } else { value.clone() };
            line.insert(name.clone(), value);
        }
        lines[number - 1] = Value::Object(line).to_string();
    }
    lines
}

/// Law: an honest log breaks no law; with a mistake the law that it is about is broken first, and its cause is named.
/// Oracle: logs worked out by hand (`laws.toml`).
#[test]
fn a_mistake_breaks_its_law() {
    for case in &cases() {
        let honest = traced(&case.log);
        let verdict = RayVerdict::of(honest);
        assert!(!verdict.is_broken(), "{}: honest, but: {}", case.law, verdict.text());
        let wrong = traced(&edited(case));
        let verdict = RayVerdict::of(wrong);
        let broken = verdict.of_outcome(Outcome::Broken).find(|(law, _)| law.name == case.law);
        let Some((law, asked)) = broken else {
            panic!("{}: not broken: {}", case.law, verdict.text())
        };
        let first = verdict.first().map(|(law, ..)| law.name);
        assert_eq!(first, Some(&*case.law), "what is said first");
        let named = law.cause(asked.roots());
        let begins = |cause: &String| named.is_some_and(|named| named.starts_with(cause.as_str()));
        assert!(
            case.cause.as_ref().is_none_or(begins),
            "{}: {named:?} for {:?}",
            case.law,
            case.cause
        );
    }
}

/// Law: a ray that breaks a law of directions should go where the law gives, whatever it does. Oracle: the honest logs.
#[test]
fn a_broken_ray_should_go_as_the_honest_one() {
    let cases = cases();
    let of_directions = cases.iter().filter(|case| ["mirrored", "snell"].contains(&&*case.law));
    let mut found = 0;
    for case in of_directions {
        let (honest, verdict) = (traced(&case.log), RayVerdict::of(traced(&edited(case))));
        let broken = verdict.asked.iter().find(|(law, _)| law.name == case.law);
        for finding in broken.map(|(_, asked)| &asked.findings).expect("asked") {
            let expected = verdict.expected(finding.ray).expect("a direction");
            let right = honest.ray(finding.ray).direction.unit().expect("not zero");
            assert!((expected - right).length() <= 1e-9, "{}: {expected:?}", case.law);
            found += 1;
        }
    }
    assert!(found >= 7, "{found} rays");
}

/// Law: each law has a case that breaks it, but those of many rays, which have tests of their own. Oracle: the list of laws.
#[test]
fn each_law_has_a_case() {
    let of_many = "samples-differ drawn-as-claimed one-camera falloff energy path-sum fresnel lamp-density surfaces-agree \
                   one-space as-ours through-its-pixel";
    let cases = cases();
    let has_case = |law: &str| cases.iter().any(|case| case.law == law);
    let mut missing: Vec<&str> = rays::LAWS.iter().map(|law| law.name).collect();
    missing.retain(|law| !has_case(law) && !of_many.split(' ').any(|it| it == *law));
    assert!(missing.is_empty(), "{missing:?}");
}

/// Law: the checks name the causes that have words, and no others. Oracle: the sources.
#[test]
fn causes_have_words() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/laws");
    let files = std::fs::read_dir(folder).expect("files").flatten().map(|it| it.path());
    let sources = files.filter(|path| path.extension().is_some_and(|it| it == "rs"));
    let text: String = sources.map(|path| std::fs::read_to_string(path).expect("a file")).collect();
    let is_key = |text: &&str| {
        text.contains('-') && !text.contains(|c: char| !c.is_ascii_alphanumeric() && c != '-')
    };
    let mut named: BTreeSet<&str> = text.split('"').filter(is_key).collect();
    named.retain(|key| rays::LAWS.iter().all(|law| law.name != *key));
    let words: BTreeSet<&str> =
        rays::LAWS.iter().flat_map(|law| &law.causes).map(|it| it.0).collect();
    assert_eq!(named, words);
}
