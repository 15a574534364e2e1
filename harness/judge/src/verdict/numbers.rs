//! A number of the scene that another program has otherwise: which one, and what it is there.
//!
//! Numbers of materials and lights are changed one at a time. The picture's change by a small step of the number, held
//! against the difference, says how far to go (least squares); a few such steps find the number (Gauss and Newton).

use groundtruth::scene::Scene;
use serde_json::Value;
use text::digits::{short, three};

use super::linear::{fitted, less, product};
use crate::mistakes::local::Local;

/// Fields of materials and of lights that are tried.
const FIELDS: [(&str, &str, &[&str]); 2] = [
    ("materials", "recipe", &["ka", "kd", "cd", "ks", "exponent", "kr"]),
    ("lights", "source", &["ls", "color", "location", "direction"]),
];

/// A number is reported if it explains at least this part of the squared difference, noise counted.
const EXPLAINED: f64 = 0.8;

/// A first step that explains less than this part leads nowhere.
const PROMISING: f64 = 0.2;

const STEPS: usize = 6;

/// The small step, relative to the number.
const SMALL: f64 = 0.02;

/// One step leads no farther than to this many times the scale of the numbers.
const FARTHEST: f64 = 4.0;

/// A number of the scene, or the three of a colour, a point or a direction.
struct Number {
    pointer: String,
    words: String,
    values: Vec<f64>,
}

/// What is known of a picture.
pub(super) struct Searched<'a> {
    pub scene: &'a Scene,
    /// The change that another scene makes of its picture, over tiles; `None` if it has no picture, or nobody waits for it.
    pub change: &'a dyn Fn(&Scene) -> Option<Vec<f64>>,
    /// The picture less ours, over tiles.
    pub difference: &'a [f64],
    /// Of the tiles.
    pub weights: &'a [f64],
}

impl Searched<'_> {
    /// The scenes that explain most of the difference, of which one thing is other that is so many numbers: 1, or 3 for a
    /// colour, a point or a direction.
    pub fn scenes(&self, count: usize) -> Vec<Local> {
        let Ok(whole) = serde_json::to_value(self.scene) else { return Vec::new() };
        let tried = numbers(&whole).into_iter().filter(|number| number.values.len() == count);
        tried.filter_map(|number| self.fitted(&whole, &number)).collect()
    }

    /// The scene with the number that brings its picture nearest to theirs, if that is near.
    fn fitted(&self, whole: &Value, number: &Number) -> Option<Local> {
        let with = |values: &[f64]| {
            let mut whole = whole.clone();
            *whole.pointer_mut(&number.pointer)? = match values {
                [value] => (*value).into(),
                several => several.into(),
            };
            serde_json::from_value::<Scene>(whole).ok()
        };
        let change = |values: &[f64]| (self.change)(&with(values)?);
        let total = product(self.difference, self.difference, self.weights);
        let (mut values, mut tiles) = (number.values.clone(), vec![0.0; self.difference.len()]);
        let mut left = total;
        for step in 0..STEPS {
            let rest = less(self.difference, &tiles);
            let scale = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let small = SMALL * if scale > 0.0 { scale } else { 1.0 };
            let columns = (0..values.len()).map(|i| {
                let mut moved = values.clone();
                moved[i] += small;
                Some(less(&change(&moved)?, &tiles))
            });
            let columns = columns.collect::<Option<Vec<Vec<f64>>>>()?;
            let (multiples, explained) = fitted(&columns, &rest, self.weights)?;
            if step == 0 && explained < PROMISING * total {
                return None;
            }
            let next =
                values.iter().zip(multiples).map(|(value, multiple)| value + small * multiple);
            let far = if scale > 0.0 { FARTHEST * scale } else { f64::INFINITY };
            let next: Vec<f64> = next.map(|value| value.clamp(-far, far)).collect();
            let Some(changed) = change(&next) else { break };
            let rest = less(self.difference, &changed);
            let rest = product(&rest, &rest, self.weights);
            if rest >= left {
                break;
            }
            let is_over = rest > 0.99 * left;
            (values, tiles, left) = (next, changed, rest);
            if is_over {
                break;
            }
        }
        let words =
            format!("{} is {} in place of {}", number.words, shown(&values), shown(&number.values));
        let is_found = left <= (1.0 - EXPLAINED) * total;
        is_found.then(|| Some(Local { words, scene: with(&values)?, everywhere: None }))?
    }
}

fn numbers(whole: &Value) -> Vec<Number> {
    let mut all = Vec::new();
    for (list, inside, fields) in FIELDS {
        for (index, item) in whole[list].as_array().into_iter().flatten().enumerate() {
            let name = item["name"].as_str().unwrap_or_default();
            if item["enabled"] != Value::Bool(false) {
                let pointer = format!("/{list}/{index}/{inside}");
                collect(&item[inside], &pointer, name, fields, &mut all);
            }
        }
    }
    all
}

/// Adds the numbers in these fields of a table, and of the tables in it.
fn collect(value: &Value, pointer: &str, name: &str, fields: &[&str], all: &mut Vec<Number>) {
    for (key, value) in value.as_object().into_iter().flatten() {
        let pointer = format!("{pointer}/{key}");
        let values = match value {
            Value::Array(items) => items.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>(),
            other => other.as_f64().map(|value| vec![value]),
        };
        match values.filter(|_| fields.contains(&&**key)) {
            Some(values) => all.push(Number { pointer, words: format!("{key} of {name}"), values }),
            None => collect(value, &pointer, name, fields, all),
        }
    }
}

fn shown(values: &[f64]) -> String {
    <[f64; 3]>::try_from(values).map_or_else(|_| short(values[0]), three)
}
