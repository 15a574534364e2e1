//! The smallest question that fails in the same way.
//!
//! A fixed list of changes of the JSON value: instances are unwrapped, fields and list items dropped, directions turned
//! to axes, numbers set to 0, 1, −1, whole numbers, fewer decimals. A change is kept if
//!
//! - what is asked for is asked for still, unit vectors are unit, and points lie on what they are points of;
//! - the answer is wrong in the same respect, by at least a quarter of the first error, and by the profile *book* if the
//!   first is: else a gross mistake turns into something that looks like a tolerance, or as if rounding decided;
//! - one of the mistakes that explain the first answer explains this one;
//! - our own answer is right by the same rule, so that the question can be answered.

use ask::{Asking, Subject, simpler, smallest, triple, weight};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::card::Failure;
use super::family::Judge;
use super::judgement::{Judgement, Profile, Wrong};
use super::probe::ours;
use super::subject::Ours;

/// Questions for one failure.
const MOST_QUESTIONS: usize = 500;
/// Time for one failure.
const MOST_TIME: Duration = Duration::from_secs(10);
/// The share of the first error that has to stay.
const SHARE: f64 = 0.25;

/// The failure with a smaller question.
pub fn smaller(
    subject: &mut dyn Subject,
    judge: Judge,
    first: Failure,
    profile: Profile,
) -> Failure {
    let begun = Instant::now();
    let bounds = Bounds::of(subject, judge, &first, profile);
    let mut asked = 0;
    let kept = |best: &Failure, question: Value| {
        if question == best.question || !bounds.is_met_by(&question) || ours(&question).is_err() {
            return Some(None);
        }
        asked += 1;
        if asked > MOST_QUESTIONS || begun.elapsed() > MOST_TIME {
            return None;
        }
        let found = fails(subject, judge, &question, profile);
        Some(found.filter(|it| {
            bounds.has_same_cause(it)
                && bounds.is_as_clear(subject, judge, it)
                && is_right_of_ours(judge, it, profile)
        }))
    };
    smallest(first, |best| candidates(&best.question), kept)
}

/// What a smaller question has to keep of the first.
struct Bounds {
    question: Value,
    wrong: Wrong,
    /// Whether the first answer is wrong by the profile *book*, too.
    is_clear: bool,
}

impl Bounds {
    fn of(subject: &mut dyn Subject, judge: Judge, first: &Failure, profile: Profile) -> Self {
        let is_clear = profile == Profile::Book
            || fails(subject, judge, &first.question, Profile::Book).is_some();
        Self { question: first.question.clone(), wrong: first.wrong.clone(), is_clear }
    }

    /// Whether a question keeps what is asked for, and what has to be unit or on a surface.
    fn is_met_by(&self, candidate: &Value) -> bool {
        let [first, other] = [&self.question, candidate].map(data_of);
        let (Some(first), Some(other)) = (first, other) else { return false };
        let is_asked = |field: &&&str| first.get(**field).is_some();
        KEPT.iter().filter(is_asked).all(|field| {
            let (before, after) = (&first[*field], &other[*field]);
            let surfaces = SURFACES.iter().filter(|is_on| triple(before).is_some_and(is_on));
            !after.is_null()
                && match triple(after) {
                    Some(after) => surfaces.into_iter().all(|is_on| is_on(after)),
                    None => triple(before).is_none(),
                }
        })
    }

    /// Whether it fails in the same respect, by as much, and for a reason that the first may have.
    fn has_same_cause(&self, failure: &Failure) -> bool {
        let (first, wrong) = (&self.wrong, &failure.wrong);
        let is_alike =
            first.clues.is_empty() || first.clues.iter().any(|clue| wrong.clues.contains(clue));
        is_alike && wrong.symptom == first.symptom && wrong.error >= SHARE * first.error
    }

    /// Whether it is wrong by the profile *book*, if the first is.
    fn is_as_clear(&self, subject: &mut dyn Subject, judge: Judge, failure: &Failure) -> bool {
        let mut by_the_book = || fails(subject, judge, &failure.question, Profile::Book);
        !self.is_clear || by_the_book().is_some_and(|it| it.wrong.symptom == self.wrong.symptom)
    }
}

/// Fields of a question that say what is asked for, or that its rule needs.
const KEPT: [&str; 16] = [
    "u", "wi", "wo", "n", "normal", "all", "eye", "draw", "sets", "uv", "ray", "cell", "point",
    "leave", "segment", "lamp",
];

/// A set of points.
type Surface = fn([f64; 3]) -> bool;

/// What a point may lie on, and has to stay on: other programs may rely on it. The unit sphere and its upper half, the
/// cylinder of radius 1, the plane y = 0, the cube, and all but the origin.
const SURFACES: [Surface; 7] = [
    |[x, y, z]| (x * x + y * y + z * z - 1.0).abs() < 1e-14,
    |[x, y, z]| (x * x + z * z - 1.0).abs() < 1e-14 && y.abs() <= 1.0,
    |[_, y, _]| y == 0.0,
    |[_, y, _]| y >= 0.0,
    |[_, _, z]| z >= 0.0,
    |[x, y, z]| x.abs().max(y.abs()).max(z.abs()) <= 1.0,
    |point| point != [0.0; 3],
];

/// The data of a question.
fn data_of(question: &Value) -> Option<&Value> {
    question.as_object()?.values().next()
}

/// Whether our own answer to the question is right by the judge that called theirs wrong.
fn is_right_of_ours(judge: Judge, failure: &Failure, profile: Profile) -> bool {
    let question = &failure.question;
    match judge {
        Judge::Answer(judge, rules) => {
            ours(question).is_ok_and(|answer| judge(question, &answer, profile, rules).is_right())
        }
        Judge::Law(law) => {
            let found = law(&mut Asking::new(&mut Ours), question, profile);
            found.is_ok_and(|judgement| judgement.is_right())
        }
    }
}

/// The failure of a question, if it fails.
fn fails(
    subject: &mut dyn Subject,
    judge: Judge,
    question: &Value,
    profile: Profile,
) -> Option<Failure> {
    let failure =
        |wrong: Box<Wrong>, asked| Failure { question: question.clone(), wrong: *wrong, asked };
    match judge {
        Judge::Answer(judge, rules) => {
            let Some(Ok(answer)) = subject.ask(std::slice::from_ref(question)).pop() else {
                return None;
            };
            let Judgement::Wrong(wrong) = judge(question, &answer, profile, rules) else {
                return None;
            };
            Some(failure(wrong, vec![(question.clone(), answer.to_string())]))
        }
        Judge::Law(law) => {
            let mut asking = Asking::new(subject);
            let Ok(Judgement::Wrong(wrong)) = law(&mut asking, question, profile) else {
                return None;
            };
            let asked = asking.asked.into_iter().map(|(q, a)| (q, a.to_string())).collect();
            Some(failure(wrong, asked))
        }
    }
}

/// Simpler questions, the simplest first.
fn candidates(question: &Value) -> Vec<Value> {
    let mut paths = Vec::new();
    collect(question, String::new(), &mut paths);
    let mut all = Vec::new();
    let mut with = |path: &str, change: &dyn Fn(&mut Value)| {
        let mut changed = question.clone();
        if let Some(slot) = changed.pointer_mut(path) {
            change(slot);
            all.push(changed);
        }
    };
    for (path, value) in &paths {
        if let Some(of) = value.pointer("/instance/of") {
            with(path, &|slot| *slot = of.clone());
        }
    }
    paths.iter().for_each(|(path, value)| fewer_triangles(path, value, &mut with));
    paths.iter().for_each(|(path, value)| without_parts(path, value, &mut with));
    paths.iter().for_each(|(path, value)| simpler_triples(path, value, &mut with));
    paths.iter().for_each(|(path, value)| simpler_numbers(path, value, &mut with));
    all
}

/// Takes the path of a value in the question, and a change of it.
type With<'a> = dyn FnMut(&str, &dyn Fn(&mut Value)) + 'a;

/// A mesh of half of the triangles, with the vertices that these have.
fn fewer_triangles(path: &str, value: &Value, with: &mut With<'_>) {
    let lists = ["vertices", "triangles"].map(|list| value[list].as_array());
    let [Some(vertices), Some(triangles)] = lists else { return };
    let is_of_vertices = ["normals", "uvs"].iter().any(|list| value.get(list).is_some());
    if is_of_vertices || triangles.len() < 2 {
        return;
    }
    for kept in triangles.chunks(triangles.len().div_ceil(2)) {
        let corners = || kept.iter().filter_map(Value::as_array).flatten();
        let mut used: Vec<usize> =
            corners().filter_map(|corner| Some(corner.as_u64()? as usize)).collect();
        used.sort_unstable();
        used.dedup();
        let moved = |corner: &Value| used.iter().position(|it| json!(it) == *corner);
        with(path, &|slot| {
            slot["vertices"] = used.iter().filter_map(|it| vertices.get(*it).cloned()).collect();
            let corners: Vec<_> = corners().map(moved).collect();
            slot["triangles"] = json!(corners.chunks(3).collect::<Vec<_>>());
        });
    }
}

/// A table without one of its fields, a list without one of its items.
fn without_parts(path: &str, value: &Value, with: &mut With<'_>) {
    match value {
        Value::Object(fields) if path.matches('/').count() > 0 => {
            for key in fields.keys() {
                with(path, &|slot| {
                    slot.as_object_mut().map(|fields| fields.remove(key));
                });
            }
        }
        Value::Array(items) if triple(value).is_none() => {
            let halves = if items.len() < 8 { 0..0 } else { 0..2 };
            for half in halves {
                with(path, &|slot| {
                    let middle = items.len() / 2;
                    let (first, second) = items.split_at(middle);
                    *slot = json!([second, first][half]);
                });
            }
            for i in 0..items.len() {
                with(path, &|slot| {
                    slot.as_array_mut().map(|items| items.remove(i));
                });
            }
        }
        _ => {}
    }
}

fn simpler_triples(path: &str, value: &Value, with: &mut With<'_>) {
    const DIRECTIONS: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.6, 0.0, 0.8],
        [0.0, 0.6, 0.8],
        [1.0, 1.0, 1.0],
    ];
    let rank = |v: &[f64; 3]| v.iter().map(|x| weight(*x)).sum::<u32>();
    let Some(vector) = triple(value) else { return };
    for simple in DIRECTIONS.iter().filter(|simple| rank(simple) < rank(&vector)) {
        with(path, &|slot| *slot = json!(simple));
    }
}

fn simpler_numbers(path: &str, value: &Value, with: &mut With<'_>) {
    let Value::Number(number) = value else { return };
    let is_whole = number.is_u64() || number.is_i64();
    let Some(x) = number.as_f64() else { return };
    for y in simpler(x) {
        with(path, &|slot| *slot = if is_whole { json!(y as i64) } else { json!(y) });
    }
}

/// All values with their paths.
fn collect(value: &Value, path: String, paths: &mut Vec<(String, Value)>) {
    paths.push((path.clone(), value.clone()));
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| collect(value, format!("{path}/{key}"), paths));
        }
        Value::Array(items) => {
            let items = items.iter().enumerate();
            items.for_each(|(i, value)| collect(value, format!("{path}/{i}"), paths));
        }
        _ => {}
    }
}
