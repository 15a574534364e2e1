//! Noise, its sums, and what textures and bumps make of it (Suffern, ch. 31). Random numbers are everybody's own: laws
//! hold a program's answers against each other; values are asked for tables that the question gives.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile};
use super::super::laws;
use super::super::mistakes as m;
use super::super::suite::Law;
use super::super::values::{self, Rules};
use super::{any, family, kinds, round, swap, vector};
use exact::Draw;
use groundtruth::math::Pcg32;
use groundtruth::textures;

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

/// A family of the lattice: its last name, its share of the cases, its law, and a case.
type OfLattice = (&'static str, f64, Law, fn(&mut Draw) -> Value);

/// The families.
pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    let lattice: [OfLattice; 6] = [
        ("smooth", 1.0, laws::noise_is_smooth, |draw| octaves(draw, false)),
        ("repeats", 1.0, laws::repeats, |draw| octaves(draw, false)),
        // these ask up to 64 questions
        ("linear", 0.5, laws::interpolates, |draw| single(draw, "linear")),
        ("cubic", 0.25, laws::interpolates, |draw| single(draw, "cubic")),
        ("knots", 0.25, laws::knots_differ, |draw| single(draw, "cubic")),
        ("sums", 0.5, laws::octaves_add_up, |draw| octaves(draw, true)),
    ];
    for (name, share, law, case) in lattice {
        let name = format!("noise.lattice.{name}");
        let family = family(&name, "noise/lattice", "ch31", Judge::Law(law), case);
        all.push(Family { share, ..family });
    }
    let given =
        family("noise.given.values", "noise/lattice", "ch31", Judge::Answer(given), with_tables);
    // a case has a thousand numbers
    all.push(Family { share: 0.25, is_shrunk: false, ..given });
    all.extend(of_textures());
    all.push(family(
        "texture.noise.still",
        "textures/noise",
        "ch31",
        Judge::Answer(still),
        without_noise,
    ));
    let bumps = family(
        "radiance.bump.noise",
        "bumps/noise",
        "ch31",
        Judge::Law(laws::bump_adds_noise),
        bumped,
    );
    all.push(Family { share: 0.5, ..bumps });
    all
}

/// Textures of noise as functions of the point, and of the noise there.
fn of_textures() -> Vec<Family> {
    let mut all = Vec::new();
    for (tag, chapter, specimens) in kinds(textures::Kind::ENTRIES) {
        // random colours are those of objects, not of points
        if !OF_NOISE.contains(&&*tag) || tag == "random_colors" {
            continue;
        }
        let about = format!("textures/{tag}");
        let case = move |draw: &mut Draw| {
            let texture = any(draw, &specimens).clone();
            json!({"texture": {"texture": texture, "point": vector(draw, 4.0)}})
        };
        let repeats = Judge::Law(laws::repeats);
        let family_of = |last: &str| format!("texture.{tag}.{last}");
        let repeated = family(&family_of("repeats"), &about, chapter, repeats, case);
        all.push(Family { share: 0.25, ..repeated });
        if tag == "wood" || tag == "stripes" {
            continue;
        }
        let name = family_of("of_its_noise");
        let law = Judge::Law(laws::texture_of_noise);
        all.push(family(&name, &about, chapter, law, move |draw| plain(draw, &tag)));
    }
    all
}

fn octaves(draw: &mut Draw, other: bool) -> Value {
    let mut noise = json!({"octaves": 1 + draw.below(6)});
    if other {
        noise["gain"] = json!(round(draw.between(0.3, 1.2)));
        noise["lacunarity"] = json!(round(draw.between(1.5, 3.5)));
    }
    json!({"noise": {"noise": noise, "point": vector(draw, 20.0)}})
}

fn single(draw: &mut Draw, interpolation: &str) -> Value {
    let noise = json!({"octaves": 1, "interpolation": interpolation});
    json!({"noise": {"noise": noise, "point": vector(draw, 20.0)}})
}

/// A noise texture of plain colours.
fn plain(draw: &mut Draw, tag: &str) -> Value {
    let color = |draw: &mut Draw| json!([(); 3].map(|()| round(draw.between(0.1, 1.0))));
    let noise = json!({
        "octaves": 1 + draw.below(4), "gain": round(draw.between(0.4, 0.7)),
        "lacunarity": round(draw.between(1.5, 3.0)),
    });
    let mut fields = json!({"noise": noise, "size": draw.pick(&[0.5, 1.0, 2.0])});
    let range = [round(draw.between(0.0, 0.3)), round(draw.between(0.6, 1.0))];
    match tag {
        "ramp_fbm" | "wrapped_ramp" => {
            let colors = json!([color(draw), color(draw), color(draw)]);
            fields["ramp"] = json!({"colors": colors});
            match tag {
                "ramp_fbm" => fields["perturbation"] = json!(round(draw.between(0.0, 5.0))),
                _ => fields["expansion"] = json!(round(draw.between(1.0, 8.0))),
            }
        }
        _ => {
            [fields["min"], fields["max"]] = range.map(|x| json!(x));
            if tag == "fbm" || tag == "turbulence" {
                // brighter than 1 is red in the one, and bright in the other
                fields["max"] = json!(round(draw.between(0.6, 1.6)));
                fields["color"] = color(draw);
            } else {
                fields["expansion"] = json!(round(draw.between(1.0, 8.0)));
                let names: &[&str] = match tag {
                    "wrapped_fbm" => &["color"],
                    "two_colors" => &["color1", "color2"],
                    _ => &["color1", "color2", "color3"],
                };
                for name in names {
                    fields[*name] = color(draw);
                }
                if tag == "three_colors" {
                    fields["expansion"] = json!(round(draw.between(2.0, 6.0)));
                    fields["thresholds"] =
                        json!([round(draw.between(0.5, 1.5)), round(draw.between(1.5, 3.0))]);
                }
            }
        }
    }
    json!({"texture": {"texture": {tag: fields}, "point": vector(draw, 4.0)}})
}

/// Textures of noise in which the noise counts nothing: they have exact values.
fn without_noise(draw: &mut Draw) -> Value {
    let color = |draw: &mut Draw| json!([(); 3].map(|()| round(draw.between(0.1, 1.0))));
    let size = draw.pick(&[0.5, 1.0, 2.0]);
    let level = round(draw.between(0.2, 0.9));
    let texture = match draw.below(4) {
        0 => {
            let colors = json!([color(draw), color(draw), color(draw)]);
            json!({"ramp_fbm": {"ramp": {"colors": colors}, "size": size, "perturbation": 0.0}})
        }
        1 => json!({"fbm": {"size": size, "min": level, "max": level, "color": color(draw)}}),
        2 => {
            json!({"turbulence": {"size": size, "min": level, "max": level, "color": color(draw)}})
        }
        _ => json!({"wood": {
            "size": size, "light": color(draw), "dark": color(draw),
            "ring_frequency": round(draw.between(1.0, 5.0)), "ring_unevenness": 0.0, "ring_noise": 0.0,
            "trunk_wobble": 0.0, "angular_wobble": 0.0, "grainy": 0.0, "ringy": level,
        }}),
    };
    json!({"texture": {"texture": texture, "point": vector(draw, 2.0)}})
}

fn still(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules { needed: &[], free: &[], questions: &[], answers: &[] };
    values::judge(question, answer, profile, &RULES)
}

/// A rough floor, far from whose only light nothing is.
fn bumped(draw: &mut Draw) -> Value {
    let share = |draw: &mut Draw| round(draw.between(0.2, 0.9));
    let colors = json!([share(draw), share(draw), share(draw)]);
    let noise = json!({
        "octaves": 1 + draw.below(4), "gain": round(draw.between(0.3, 0.6)),
        "lacunarity": round(draw.between(1.5, 2.5)),
    });
    let bump = json!({"noise": {
        "noise": noise, "size": draw.pick(&[0.5, 1.0, 2.0]),
        "perturbation": round(draw.between(0.1, 0.3)),
    }});
    let recipe = json!({"matte": {"ka": 0.0, "kd": share(draw), "cd": colors}});
    let sun = [draw.between(-0.4, 0.4), 1.0, draw.between(-0.4, 0.4)].map(round);
    let scene = json!({
        "image": {"width": 1, "height": 1},
        "camera": {"eye": [0.0, 2.0, 6.0], "lens": {"pinhole": {"distance": 8.0}}},
        "tracer": "ray_cast",
        "lights": [{"name": "sun", "source": {"directional": {"ls": 3.0, "direction": sun}}}],
        "materials": [{"name": "rough", "recipe": recipe, "bump": bump}],
        "objects": [{"name": "floor", "material": "rough",
            "shape": {"plane": {"point": [0.0, 0.0, 0.0], "normal": [0.0, 1.0, 0.0]}}}],
    });
    let aim = [draw.between(-4.0, 4.0), 0.0, draw.between(-4.0, 4.0)].map(round);
    let origin = [aim[0] + 0.25, 2.0, aim[2] - 0.25];
    let direction: [f64; 3] = std::array::from_fn(|i| aim[i] - origin[i]);
    json!({"radiance": {"scene": scene, "ray": {"origin": origin, "direction": direction}, "replicas": 1}})
}

/// A noise whose tables stand in the question.
fn with_tables(draw: &mut Draw) -> Value {
    let mut question = octaves(draw, true);
    let mut permutation: [u8; 256] = std::array::from_fn(|i| i as u8);
    Pcg32::new(draw.below(1 << 30) as u64, 0).shuffle(&mut permutation);
    let values: Vec<f64> = (0..256).map(|_| round(draw.between(-1.0, 1.0))).collect();
    let vectors: Vec<[f64; 3]> = (0..256).map(|_| draw.direction().to_array().map(round)).collect();
    let data = &mut question["noise"];
    data["noise"]["interpolation"] = json!(draw.pick(&["linear", "cubic"]));
    data["lattice"] =
        json!({"permutation": permutation.to_vec(), "values": values, "vectors": vectors});
    question
}

fn given(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    // a lattice of permuted coordinates, interpolated, is the noise of permuted coordinates
    const RULES: Rules = Rules {
        needed: &["value"],
        free: &[],
        questions: &[
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/1")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/2")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/1", "/point/2")
            }),
        ],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}
