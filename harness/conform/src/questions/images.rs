//! Answers about image textures, whose texels the question lists (Suffern, ch. 29).

use serde_json::{Value, json};

use super::super::mistakes as m;
use super::{Mistakes, change, data, remove, swap};

/// Those of `texture` about images.
pub const IMAGE: Mistakes = Mistakes {
    questions: &[
        (&m::TEXTURE_UPSIDE_DOWN, |question| of_rows(question, |rows| rows.reverse())),
        (&m::TEXTURE_MIRRORED, |question| {
            of_rows(question, |rows| {
                rows.iter_mut().filter_map(Value::as_array_mut).for_each(|row| row.reverse());
            })
        }),
        (&m::SWAP_U, |question| swap(data(question)?, "/uv/0", "/uv/1")),
        (&m::TEXTURE_NEAREST, |question| remove(image(question)?, "filtering")),
        (&m::TEXTURE_OF_OTHER_RULE, |question| {
            let image = image(question)?;
            image["rule"] = json!(if image["rule"] == "book" { "even" } else { "book" });
            Some(())
        }),
        (&m::NO_HALF_TEXEL, |question| {
            let image = image(question)?;
            let rows = image["texels"].as_array()?;
            let counts = [rows[0].as_array()?.len(), rows.len()].map(|n| n as f64);
            any_of(image, "filtering", "bilinear")?;
            let data = data(question)?;
            change(data, "/uv/0", |u| u + 0.5 / counts[0])?;
            change(data, "/uv/1", |v| v + 0.5 / counts[1])
        }),
        (&m::MIRROR_REPEATS, |question| {
            let image = image(question)?;
            let mirrored: Vec<&str> =
                ["wrap_u", "wrap_v"].into_iter().filter(|it| image[*it] == "mirror").collect();
            mirrored.iter().for_each(|field| image[*field] = json!("repeat"));
            (!mirrored.is_empty()).then_some(())
        }),
        (&m::WRAPS_CLAMPED, |question| wraps(question, "clamp")),
        (&m::WRAPS_REPEATED, |question| wraps(question, "repeat")),
        (&m::WRAPS_SWAPPED, |question| swap(image(question)?, "/wrap_u", "/wrap_v")),
        (&m::NO_UNIT, |question| change(image(question)?, "/unit", |_| 1.0)),
        (&m::SWAP_YZ, |question| swap(data(question)?, "/point/1", "/point/2")),
        (&m::SWAP_XZ, |question| swap(data(question)?, "/point/0", "/point/2")),
        (&m::FLIP_X, |question| change(data(question)?, "/point/0", |x| -x)),
        (&m::FLIP_Y, |question| change(data(question)?, "/point/1", |y| -y)),
        (&m::FLIP_Z, |question| change(data(question)?, "/point/2", |z| -z)),
    ],
    answers: &[],
};

fn image(question: &mut Value) -> Option<&mut Value> {
    question.pointer_mut("/texture/texture/image")
}

fn any_of(image: &Value, field: &str, word: &str) -> Option<()> {
    (image[field] == word).then_some(())
}

fn of_rows(question: &mut Value, change: impl Fn(&mut Vec<Value>)) -> Option<()> {
    change(image(question)?.get_mut("texels")?.as_array_mut()?);
    Some(())
}

fn wraps(question: &mut Value, as_if: &str) -> Option<()> {
    let image = image(question)?;
    for field in ["wrap_u", "wrap_v"] {
        image[field] = json!(as_if);
    }
    Some(())
}
