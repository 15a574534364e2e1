//! The mistakes that explain a wrong number in an answer that ours is compared with: what our function gives for the question that
//! they make of it, or what they make of our answer.

use ask::{number, numbers};
use serde_json::{Value, json};

use super::super::handed;
use super::super::mistakes::{self, Mistake, same, tells};
use super::super::probe::ours;
use super::super::questions::mistakes as coded;
use super::Leaf;

/// The mistakes that give just the numbers that stand in one place of their answer, or what is no number there, such as 0/0.
pub fn of_leaf(
    question: &Value,
    leaf: &Leaf,
    answer: &Value,
    theirs: &Value,
) -> Vec<&'static Mistake> {
    let numbers = leaf.of(theirs).zip(leaf.right.numbers());
    let Some((theirs, right)) = numbers else { return Vec::new() };
    let coded = coded(name(question)).answers.iter();
    let coded =
        coded.filter_map(|(mistake, of)| Some((*mistake, of(question, &leaf.field, answer)?)));
    if leaf.is_nan_in(theirs) {
        return coded.filter(|(_, it)| it.iter().any(|x| x.is_nan())).map(|(it, _)| it).collect();
    }
    let Some(theirs) = &leaf.numbers_in(theirs) else { return Vec::new() };
    let mut found = match is_color(question, &leaf.field) {
        // a wrong cell of a texture has another of its colours, whatever that looks like
        _ if question.get("texture").is_some() => Vec::new(),
        true => mistakes::clues_of_color(theirs, right),
        false => mistakes::clues(theirs, right),
    };
    let of_leaf = |answer: &Value| leaf.of(answer).and_then(flat);
    let by_handedness =
        handed::answers(question, answer).iter().filter_map(of_leaf).collect::<Vec<_>>();
    if by_handedness.iter().any(|other| same(theirs, other) && !same(right, other)) {
        found.push(&mistakes::LEFT_HANDED);
    }
    let others = mistaken(question, answer);
    let others = others.iter().filter_map(|(mistake, answer)| Some((*mistake, of_leaf(answer)?)));
    let gives = |other: &[f64]| tells(other, theirs, right);
    found.extend(others.chain(coded).filter(|(_, it)| gives(it)).map(|(mistake, _)| mistake));
    found
}

/// The mistakes that give all of an answer.
pub fn of_answer(question: &Value, right: &Value, theirs: &Value) -> Vec<&'static Mistake> {
    let is_theirs =
        |other: &Value| is_alike(theirs, other, theirs) && !is_alike(right, other, theirs);
    let others = mistaken(question, right).into_iter();
    others.filter(|(_, other)| is_theirs(other)).map(|(mistake, _)| mistake).collect()
}

/// Whether a field of theirs that is right would be another with this mistake. Only of rays and matrices: the fields of lobes
/// and lights come from functions of their own, and a ray's point on the film may be told by another rule.
pub fn is_contradicted((question, right): (&Value, &Value), theirs: &Value, it: &Mistake) -> bool {
    let fields = match name(question) {
        "camera_ray" => ["origin", "direction"],
        "transform" => ["matrix", "inverse"],
        _ => return false,
    };
    let others = with(it, question, right);
    let differs = |other: &Value| {
        fields.iter().any(|field| {
            let alike = |a: &Value, b: &Value| is_alike(&a[field], &b[field], &b[field]);
            theirs.get(field).is_some() && alike(theirs, right) && !alike(other, right)
        })
    };
    !others.is_empty() && others.iter().all(differs)
}

/// The name of a question.
fn name(question: &Value) -> &str {
    question.as_object().and_then(|it| it.keys().next()).map_or("", String::as_str)
}

/// The answers of programs with one mistake. Those to whole scenes are looked for elsewhere.
fn mistaken(question: &Value, right: &Value) -> Vec<(&'static Mistake, Value)> {
    let mut all: Vec<&'static Mistake> = mistakes::OF_FUNCTIONS.iter().collect();
    for (mistake, _) in coded(name(question)).questions {
        if !all.contains(mistake) {
            all.push(mistake);
        }
    }
    let of = |it: &'static Mistake| {
        with(it, question, right).into_iter().map(move |answer| (it, answer))
    };
    all.into_iter().flat_map(of).collect()
}

/// The answers of programs with this mistake, one for each way to make it.
fn with(mistake: &Mistake, question: &Value, right: &Value) -> Vec<Value> {
    let name = name(question);
    let data = &question[name];
    if data.get("scene").is_some() || !data.is_object() {
        return Vec::new();
    }
    let by_code = coded(name).questions.iter().filter(|(coded, _)| *coded == mistake);
    let by_code = by_code.filter_map(|(_, change)| {
        let mut changed = question.clone();
        change(&mut changed)?;
        ours(&changed).ok()
    });
    let mut told = data.clone();
    told["answer"] = right.clone();
    let answered = |mut changed: Value| {
        let answer = changed.as_object_mut()?.remove("answer")?;
        if changed == *data { Some(answer) } else { ours(&json!({name: changed})).ok() }
    };
    let ways = mistake.known().ways(&told).into_iter().flatten();
    by_code.chain(ways.filter_map(answered)).collect()
}

/// Whether all that a mistake may give here is another answer than theirs, which is right, in the fields that it has.
pub fn refutes((question, theirs): &(Value, Value), mistake: &'static Mistake) -> bool {
    let Ok(right) = ours(question) else { return false };
    let is_of_fields = coded(name(question)).answers.iter().any(|(coded, _)| *coded == mistake);
    let others = with(mistake, question, &right);
    let differs = |other: &Value| !is_alike(other, &right, theirs);
    !is_of_fields && !others.is_empty() && others.iter().all(differs)
}

/// A number, or the numbers of a list.
fn flat(value: &Value) -> Option<Vec<f64>> {
    number(value).map(|x| vec![x]).or(numbers(value))
}

/// Whether two answers have the same numbers and words in the fields that a third has.
fn is_alike(a: &Value, b: &Value, has: &Value) -> bool {
    match (a, b, has) {
        (Value::Object(a), Value::Object(b), Value::Object(has)) => {
            has.iter().all(|(field, has)| match (a.get(field), b.get(field)) {
                (Some(a), Some(b)) => is_alike(a, b, has),
                _ => true,
            })
        }
        _ => match (flat(a), flat(b)) {
            (Some(a), Some(b)) => same(&a, &b),
            _ => a == b,
        },
    }
}

/// Whether the three numbers of a field are red, green and blue.
fn is_color(question: &Value, field: &str) -> bool {
    const COLORS: [&str; 7] = ["radiance", "mean", "f", "albedo", "weight", "ambient", "blocked"];
    question.get("texture").is_some()
        || field.rsplit('.').next().is_some_and(|last| COLORS.contains(&last))
}
