//! Image textures, whose texels the question lists (Suffern, ch. 29): a family for each way to reach a texel.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::surfaces::on;
use super::{change, data, family, remove, swap};
use exact::Draw;
use groundtruth::textures::Mapping;

/// A case: the fields of its image beside `texels`, and those of its question beside `texture`.
type Case = fn(&mut Draw) -> (Value, Value);

const CASES: &[(&str, Case)] = &[
    ("uv", |draw| (json!({}), json!({"uv": super::square(draw)}))),
    ("bilinear", |draw| (json!({"filtering": "bilinear"}), json!({"uv": super::square(draw)}))),
    ("wraps", |draw| {
        let [wrap_u, wrap_v] = [(); 2].map(|()| draw.pick(&["repeat", "clamp", "mirror"]));
        (json!({"wrap_u": wrap_u, "wrap_v": wrap_v}), json!({"uv": beyond(draw)}))
    }),
    ("bilinear_wraps", |draw| {
        let [wrap_u, wrap_v] = [(); 2].map(|()| draw.pick(&["repeat", "clamp", "mirror"]));
        let image = json!({"filtering": "bilinear", "wrap_u": wrap_u, "wrap_v": wrap_v});
        (image, json!({"uv": beyond(draw)}))
    }),
    ("rule_of_the_book", |draw| (json!({"rule": "book"}), json!({"uv": super::square(draw)}))),
    ("unit", |draw| {
        let unit = draw.pick(&[0.25, 0.5, 2.0, 3.0]);
        let scaled = |point: Value| match point.as_array() {
            Some(all) => {
                json!(all.iter().filter_map(Value::as_f64).map(|x| unit * x).collect::<Vec<_>>())
            }
            None => point,
        };
        (
            json!({"mapping": "square", "unit": unit}),
            json!({"point": scaled(on(Mapping::Square, draw))}),
        )
    }),
];

/// The families, with one for each mapping.
pub fn families() -> Vec<Family> {
    let listed = CASES.iter().map(|(name, case)| {
        named(name, move |draw| {
            let (image, question) = case(draw);
            asked(draw, image, question)
        })
    });
    let mapped = [
        (Mapping::Square, "square"),
        (Mapping::Cylindrical, "cylindrical"),
        (Mapping::Spherical, "spherical"),
        (Mapping::LightProbe, "light_probe"),
        (Mapping::Panoramic, "panoramic"),
    ]
    .into_iter()
    .map(|(mapping, name)| {
        named(name, move |draw| {
            let point = json!({"point": on(mapping, draw)});
            asked(draw, json!({"mapping": name}), point)
        })
    });
    listed.chain(mapped).collect()
}

fn named(name: &str, case: impl Fn(&mut Draw) -> Value + Send + Sync + 'static) -> Family {
    let name = format!("texture.image.{name}.values");
    family(&name, "textures/image", "ch29", Judge::Answer(judge), case)
}

fn asked(draw: &mut Draw, mut image: Value, mut question: Value) -> Value {
    image["texels"] = texels(draw);
    question["texture"] = json!({"image": image});
    json!({"texture": question})
}

/// Coordinates in the image and around it.
fn beyond(draw: &mut Draw) -> Value {
    json!([draw.between(-2.0, 3.0), draw.between(-2.0, 3.0)])
}

/// A few rows of colours that single precision holds.
fn texels(draw: &mut Draw) -> Value {
    let (columns, rows) = (3 + draw.below(3), 2 + draw.below(3));
    let color = |draw: &mut Draw| [(); 3].map(|()| super::round(draw.between(0.0, 1.0)));
    let row = |draw: &mut Draw| (0..columns).map(|_| color(draw)).collect::<Vec<_>>();
    json!((0..rows).map(|_| row(draw)).collect::<Vec<_>>())
}

/// Judges by our own answer.
fn judge(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &[],
        free: &[],
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
    values::judge(question, answer, profile, &RULES)
}

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
