//! Mistakes that are another shape: what our function answers for it is what they would.

use serde_json::{Map, Value, json};

use super::super::mistakes::{Mistake, same};
use super::super::subject::ours;

/// A mistake, and what it makes of the data of a shape; `None` if there is nothing to change.
type Other = (Mistake, fn(&mut Map<String, Value>) -> Option<()>);

const fn mistake(name: &'static str, place: &'static str) -> Mistake {
    Mistake::of_answers(name, place, None)
}

static OTHERS: [Other; 14] = [
    (mistake("the range of azimuths is ignored", "ch. 19: part objects"), |shape| {
        range(shape, "phi", |_, _| [0.0, 360.0])
    }),
    (mistake("azimuths are measured from +x", "ch. 19: φ from +z towards +x"), |shape| {
        range(shape, "phi", |low, high| [90.0 - high, 90.0 - low])
    }),
    (mistake("azimuths turn the other way", "ch. 19: φ from +z towards +x"), |shape| {
        range(shape, "phi", |low, high| [-high, -low])
    }),
    (
        mistake("the other part of the circle is there", "ch. 19: φ_min ≤ φ ≤ φ_max"),
        |shape| range(shape, "phi", |low, high| [high, low + 360.0]),
    ),
    (mistake("the range of polar angles is ignored", "ch. 19: part objects"), |shape| {
        let whole = if shape.contains_key("swept_radius") { 360.0 } else { 180.0 };
        range(shape, "theta", |_, _| [0.0, 0.0])?;
        shape.insert("theta".to_owned(), json!([0.0, whole]));
        Some(())
    }),
    (mistake("polar angles are measured from below", "ch. 19: θ from +y down"), |shape| {
        range(shape, "theta", |low, high| [180.0 - high, 180.0 - low])
    }),
    (mistake("the ends y0 and y1 are ignored", "ch. 19: y0 < y < y1"), |shape| {
        number(shape, "y0", |y| y - 1000.0)?;
        number(shape, "y1", |y| y + 1000.0)
    }),
    (mistake("the hole is left out", "ch. 19: r_inner < r < r_outer"), |shape| {
        number(shape, "inner_radius", |_| 0.0)
    }),
    (mistake("the radius is taken for the diameter", "ch. 3, 19"), |shape| {
        number(shape, "radius", |r| 0.5 * r)
    }),
    (mistake("the radius for its square", "ch. 3, 19: d² < r²"), |shape| {
        number(shape, "radius", f64::sqrt)
    }),
    (mistake("the square of the radius for the radius", "ch. 3, 19: d² < r²"), |shape| {
        number(shape, "radius", |r| r * r)
    }),
    (mistake("the centre is left out", "ch. 3, 19: o − c"), |shape| {
        (*shape.get("center")? != json!([0.0, 0.0, 0.0])).then_some(())?;
        shape.insert("center".to_owned(), json!([0.0, 0.0, 0.0]));
        Some(())
    }),
    (mistake("height and radius are exchanged", "ch. 19: h and r"), |shape| {
        let [height, radius] = [shape.remove("height")?, shape.remove("radius")?];
        shape.insert("height".to_owned(), radius);
        shape.insert("radius".to_owned(), height);
        Some(())
    }),
    (mistake("`inward` is ignored", "ch. 19: concave objects"), |shape| {
        (shape.remove("inward")? == json!(true)).then_some(())
    }),
];

/// Changes a range of angles.
fn range(
    shape: &mut Map<String, Value>,
    name: &str,
    to: impl Fn(f64, f64) -> [f64; 2],
) -> Option<()> {
    let [low, high] = serde_json::from_value(shape.get(name)?.clone()).ok()?;
    shape.insert(name.to_owned(), json!(to(low, high)));
    Some(())
}

/// Changes a number.
fn number(shape: &mut Map<String, Value>, name: &str, to: impl Fn(f64) -> f64) -> Option<()> {
    let value = to(shape.get(name)?.as_f64()?);
    shape.insert(name.to_owned(), json!(value));
    Some(())
}

/// The mistakes with which our answer to an `intersect` is theirs. That nothing is hit says little: too many shapes are
/// elsewhere.
pub fn of_other_shapes(question: &Value, theirs: &Value) -> Vec<&'static Mistake> {
    if theirs.is_null() || theirs.as_array().is_some_and(Vec::is_empty) {
        return Vec::new();
    }
    let Ok(right) = ours(question) else { return Vec::new() };
    let is_it = |(_, change): &&Other| {
        let mut other = question.clone();
        let Some(data) = other.as_object_mut().and_then(|all| all.values_mut().next()) else {
            return false;
        };
        let changed = innermost(&mut data["shape"]).and_then(change);
        let answer = changed.and_then(|()| ours(&other).ok());
        answer.is_some_and(|answer| is_same(theirs, &answer) && !is_same(&right, &answer))
    };
    OTHERS.iter().filter(is_it).map(|(mistake, _)| mistake).collect()
}

/// The data of the shape inside all instances.
fn innermost(shape: &mut Value) -> Option<&mut Map<String, Value>> {
    match shape.get("instance").is_some() {
        true => innermost(&mut shape["instance"]["of"]),
        false => shape.as_object_mut()?.values_mut().next()?.as_object_mut(),
    }
}

/// Whether two answers have the same hits: distances and, of one hit, its normal.
fn is_same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
        }
        (Value::Object(_), Value::Object(_)) => ["t", "normal"].into_iter().all(|name| {
            let numbers = [a, b].map(|hit| match &hit[name] {
                Value::Array(all) => all.iter().filter_map(Value::as_f64).collect(),
                other => other.as_f64().into_iter().collect::<Vec<f64>>(),
            });
            same(&numbers[0], &numbers[1])
        }),
        _ => a == b,
    }
}
