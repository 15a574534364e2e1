//! Lights that are points or directions, textures and mappings (Suffern, ch. 14, 29, 30).

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile, number, numbers, triple};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{any, change, data, direction, family, kinds, only, swap, vector};
use crate::verify::Draw;
use groundtruth::math::{Vector, power};
use groundtruth::textures::Mapping;
use groundtruth::{lights, textures};

/// Textures that are made of noise or random numbers depend on our own tables: laws judge them.
pub const OF_NOISE: [&str; 10] = [
    "fbm",
    "turbulence",
    "wrapped_fbm",
    "two_colors",
    "three_colors",
    "ramp_fbm",
    "wrapped_ramp",
    "wood",
    "random_colors",
    "stripes",
];

pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    for (tag, chapter, specimens) in kinds(lights::Kind::ENTRIES) {
        if !["ambient", "directional", "point", "spot"].contains(&&*tag) {
            continue;
        }
        let name = format!("light.{tag}.values");
        let case = move |draw: &mut Draw| json!({"light": {"light": any(draw, &specimens), "from": vector(draw, 4.0)}});
        all.push(family(&name, &format!("lights/{tag}"), chapter, Judge::Answer(light), case));
    }
    for (tag, chapter, specimens) in kinds(textures::Kind::ENTRIES) {
        let specimens: Vec<Value> = specimens
            .into_iter()
            .filter(|data| {
                !OF_NOISE.iter().any(|noise| data.to_string().contains(&format!("\"{noise}\"")))
            })
            .collect();
        if specimens.is_empty() {
            continue;
        }
        let name = format!("texture.{tag}.values");
        let case = move |draw: &mut Draw| {
            let texture = any(draw, &specimens).clone();
            let mut question = json!({"texture": texture, "point": vector(draw, 2.0)});
            if question["texture"].get("image").is_some_and(|image| image.get("mapping").is_none())
            {
                question["uv"] = super::square(draw);
            }
            json!({"texture": question})
        };
        all.push(family(&name, &format!("textures/{tag}"), chapter, Judge::Answer(texture), case));
    }
    for of in [
        Mapping::Square,
        Mapping::Cylindrical,
        Mapping::Spherical,
        Mapping::Hemispherical,
        Mapping::LightProbe,
        Mapping::Panoramic,
    ] {
        let tag = serde_json::to_value(of).expect("a mapping is a word");
        let tag = tag.as_str().unwrap_or_default().to_owned();
        let (name, about) = (format!("mapping.{tag}.values"), format!("mappings/{tag}"));
        let case =
            move |draw: &mut Draw| json!({"mapping": {"mapping": of, "point": on(of, draw)}});
        all.push(family(&name, &about, "ch29", Judge::Answer(mapping), case));
    }
    // where the direction has no azimuth; the opposite one is a whole circle of the picture
    for (of, tag, z) in
        [(Mapping::LightProbe, "light_probe", 1.0), (Mapping::Panoramic, "panoramic", -1.0)]
    {
        let case = move |draw: &mut Draw| {
            let reach = draw.pick(&[0.0, 0.25]);
            let aside = draw.vector(reach);
            let point = Vector::new(aside.x(), aside.y(), z).unit().unwrap_or(Vector::Z);
            json!({"mapping": {"mapping": of, "point": point.to_array()}})
        };
        let (name, about) = (format!("mapping.{tag}.axis"), format!("mappings/{tag}"));
        all.push(family(&name, &about, "ch29", Judge::Answer(mapping), case));
    }
    all
}

/// A point of the generic object of a mapping.
fn on(mapping: Mapping, draw: &mut Draw) -> Value {
    match mapping {
        Mapping::Square => json!([draw.between(-0.99, 0.99), 0.0, draw.between(-0.99, 0.99)]),
        Mapping::Cylindrical => {
            let n = draw.direction().to_array();
            let rho = (n[0] * n[0] + n[2] * n[2]).sqrt().max(1e-3);
            json!([n[0] / rho, draw.between(-0.99, 0.99), n[2] / rho])
        }
        Mapping::Hemispherical => {
            let n = draw.direction().to_array();
            json!([n[0], n[1].abs(), n[2]])
        }
        _ => direction(draw),
    }
}

fn light(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &["radiance", "ambient", "direction"],
        free: &["pdf"],
        questions: &[(&m::NO_FALL_OFF, |question| {
            let light = only(&mut data(question)?["light"])?;
            change(light, "/attenuation", |_| 0.0)
        })],
        answers: &[
            (&m::FROM_LIGHT, |_, field, right| {
                (field == "direction").then(|| negated(&right["direction"]))?
            }),
            (&m::TIMES_DISTANCE, |_, field, right| {
                let distance = number(&right["distance"])?;
                let scaled = triple(&right["direction"])?.map(|x| distance * x);
                (field == "direction").then(|| scaled.to_vec())
            }),
            (&m::DISTANCE_SQUARED, |_, field, right| {
                let distance = number(&right["distance"])?;
                (field == "distance").then(|| vec![distance * distance])
            }),
            (&m::NO_FALL_OFF, |question, field, right| {
                let light = question["light"]["light"].as_object()?.values().next()?;
                let exponent = light["attenuation"].as_f64()?;
                let factor = power(number(&right["distance"])?, exponent);
                let all = numbers(&right["radiance"])?.into_iter().map(|x| factor * x).collect();
                (field == "radiance").then_some(all)
            }),
        ],
    };
    values::judge(question, answer, profile, &RULES)
}

fn negated(value: &Value) -> Option<Vec<f64>> {
    Some(numbers(value)?.into_iter().map(|x| -x).collect())
}

fn texture(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &[],
        free: &[],
        questions: &[
            (&m::SWAPPED_COLORS, |question| {
                swap(only(&mut data(question)?["texture"])?, "/color1", "/color2")
            }),
            (&m::NO_SIZE, |question| {
                change(only(&mut data(question)?["texture"])?, "/size", |_| 1.0)
            }),
            (&m::TRUNCATED_FLOOR, |question| {
                // up to 0, a truncated number is one more: the cube beside it
                let size = only(&mut data(question)?["texture"])?["size"].as_f64()?;
                for axis in ["/point/0", "/point/1", "/point/2"] {
                    change(data(question)?, axis, |x| if x <= 0.0 { x + size } else { x })?;
                }
                Some(())
            }),
            (&m::SWAP_U, |question| swap(data(question)?, "/uv/0", "/uv/1")),
            (&m::MIRROR_U, |question| change(data(question)?, "/uv/0", |u| 1.0 - u)),
            (&m::MIRROR_V, |question| change(data(question)?, "/uv/1", |v| 1.0 - v)),
            (&m::SWAP_YZ, |question| swap(data(question)?, "/point/1", "/point/2")),
            (&m::FLIP_X, |question| change(data(question)?, "/point/0", |x| -x)),
            (&m::FLIP_Y, |question| change(data(question)?, "/point/1", |x| -x)),
            (&m::FLIP_Z, |question| change(data(question)?, "/point/2", |x| -x)),
        ],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}

fn mapping(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &[],
        free: &[],
        questions: &[
            (&m::SWAP_YZ, |question| swap(data(question)?, "/point/1", "/point/2")),
            (&m::SWAP_XZ, |question| swap(data(question)?, "/point/0", "/point/2")),
            (&m::FLIP_X, |question| change(data(question)?, "/point/0", |x| -x)),
            (&m::FLIP_Z, |question| change(data(question)?, "/point/2", |x| -x)),
        ],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}
