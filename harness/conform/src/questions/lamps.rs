//! Lights of some extent (Suffern, ch. 17, 18): each shape, each way to sample it, and each way to place it is a family
//! of its own, so that what a program does not have hides nothing that it has.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::laws;
use super::{family, round, square, vector};
use exact::Draw;
use groundtruth::math::{Normal, Vector};

/// Means ask many questions a case.
const FEW: f64 = 0.06;

pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    for (tag, samplings) in [
        ("rectangle", &["area", "solid_angle"][..]),
        ("disk", &["area"]),
        ("sphere", &["area", "solid_angle"]),
        ("triangle", &["area"]),
        ("mesh", &["area"]),
    ] {
        for &sampling in samplings {
            let case = move |draw: &mut Draw| lamp(draw, tag, &[], sampling);
            all.push(of_lamp(&format!("{tag}.{sampling}"), case));
            let case = move |draw: &mut Draw| near(draw, tag, sampling);
            all.push(mean(
                &format!("light.area.{tag}.{sampling}_mean"),
                "lights/area",
                "ch18",
                case,
            ));
        }
    }
    for tag in ["rectangle", "disk"] {
        all.push(of_lamp(&format!("{tag}.sides"), move |draw| sides(draw, tag)));
    }
    all.push(of_lamp("rectangle.textured", textured));
    for tag in ["rectangle", "disk", "sphere", "mesh"] {
        all.push(of_lamp(&format!("{tag}.turned"), move |draw| {
            let axis = draw.pick(&["rotate_x", "rotate_y", "rotate_z"]);
            let turn = json!({axis: round(draw.between(-170.0, 170.0))});
            let steps = [turn, json!({"translate": vector(draw, 1.0)})];
            lamp(draw, tag, &steps, "area")
        }));
        all.push(of_lamp(&format!("{tag}.mirrored"), move |draw| {
            let steps = [json!({"reflect": draw.pick(&["x", "y", "z"])})];
            lamp(draw, tag, &steps, "area")
        }));
        all.push(of_lamp(&format!("{tag}.stretched"), move |draw| {
            let steps = match tag {
                // a ball stays one
                "sphere" => vec![json!({"scale": [2.0, 2.0, 2.0]})],
                // tilted first: a normal along an axis is scaled as a vector is
                _ => {
                    let tilt = json!({draw.pick(&["rotate_x", "rotate_z"]): round(draw.between(20.0, 70.0))});
                    let scale: [f64; 3] = std::array::from_fn(|_| round(draw.between(0.5, 2.0)));
                    vec![tilt, json!({"scale": scale})]
                }
            };
            lamp(draw, tag, &steps, "area")
        }));
    }
    all.extend(of_skies());
    all.extend(of_jittered());
    all
}

fn of_lamp(name: &str, case: impl Fn(&mut Draw) -> Value + Send + Sync + 'static) -> Family {
    let judge = Judge::Law(laws::lamp_sample);
    let mut family = family(&format!("light.area.{name}"), "lights/area", "ch18", judge, case);
    family.share = 0.5;
    family
}

fn mean(
    name: &str,
    about: &str,
    chapter: &'static str,
    case: impl Fn(&mut Draw) -> Value + Send + Sync + 'static,
) -> Family {
    let mut family = family(name, about, chapter, Judge::Law(laws::irradiance), case);
    family.share = FEW;
    family
}

/// A lamp of about unit size about the origin.
fn shape(draw: &mut Draw, tag: &str) -> Value {
    let mut size = || round(draw.between(0.5, 1.5));
    let [a, b] = [size(), size()];
    match tag {
        "rectangle" => {
            json!({"rectangle": {"corner": [-a, 0, -b], "a": [2.0 * a, 0, 0], "b": [0, 0, 2.0 * b]}})
        }
        "disk" => json!({"disk": {"center": [0, 0, 0], "normal": [0, -1, 0], "radius": a}}),
        "sphere" => json!({"sphere": {"center": [0, 0, 0], "radius": a}}),
        "triangle" => json!({"triangle": {"vertices": [[-a, 0, 0], [a, 0, b], [b, 0, -a]]}}),
        // triangles of different areas
        _ => json!({"mesh": {
            "vertices": [[-a, 0, -b], [a, 0, -b], [a, 0, b], [-a, 0, b], [0, 0, b + 0.25]],
            "triangles": [[0, 2, 1], [0, 3, 2], [3, 4, 2]],
        }}),
    }
}

/// A lamp through the steps, seen from far enough that all of it is above a surface that faces it.
fn lamp(draw: &mut Draw, tag: &str, steps: &[Value], sampling: &str) -> Value {
    let shape = shape(draw, tag);
    let shape = match steps {
        [] => shape,
        steps => json!({"instance": {"of": shape, "transform": steps}}),
    };
    let color = json!(round(draw.between(1.0, 8.0)));
    let away = draw.direction().to_array();
    let far = draw.between(5.0, 9.0);
    let from = away.map(|x| round(far * x));
    json!({"light": {
        "light": {"area": {"object": "lamp", "sampling": sampling}},
        "lamp": {"shape": shape, "material": {"emissive": {"ls": color}}, "two_sided": draw.coin()},
        "from": from, "normal": away.map(|x| -x), "u": [square(draw)],
    }})
}

/// Both sides of lamps that shine on one, and on both, from all distances.
fn sides(draw: &mut Draw, tag: &str) -> Value {
    let mut question = lamp(draw, tag, &[], "area");
    let scale = draw.pick(&[0.5, 1.0, 4.0]);
    if let Some(from) = question["light"]["from"].as_array_mut() {
        from.iter_mut().for_each(|x| *x = json!(scale * x.as_f64().unwrap_or(0.0)));
    }
    question
}

/// A lamp of two colours.
fn textured(draw: &mut Draw) -> Value {
    let mut question = lamp(draw, "rectangle", &[], "area");
    let [a, b] =
        [0; 2].map(|_| std::array::from_fn::<f64, 3, _>(|_| round(draw.between(0.0, 1.0))));
    let checker =
        json!({"checker3d": {"size": round(draw.between(0.2, 0.8)), "color1": a, "color2": b}});
    let light = &mut question["light"];
    light["lamp"]["material"]["emissive"]["ce"] = checker;
    light["lamp"]["two_sided"] = json!(true);
    // the plane y = 0 is in one layer of cubes: the offset of the texture is a share of the size
    question
}

/// A lamp so near that it matters which of its points are drawn, and a surface that has all of it above.
fn near(draw: &mut Draw, tag: &str, sampling: &str) -> Value {
    let mut question = lamp(draw, tag, &[], sampling);
    let light = &mut question["light"];
    light["lamp"]["two_sided"] = json!(true);
    let height = round(draw.between(1.5, 3.0));
    let tilt = round(draw.between(0.0, 0.25));
    // on the axis of disks
    let aside = if tag == "disk" { 0.0 } else { round(draw.between(-0.5, 0.5)) };
    light["from"] = json!([aside, -height, 0.0]);
    let normal = Normal::new(Vector::new(tilt, 1.0, -tilt)).unwrap_or(Normal::Y);
    light["normal"] = json!(normal.to_array());
    question
}

/// Skies and ambient occluders.
fn of_skies() -> Vec<Family> {
    let anywhere = |draw: &mut Draw, light: Value| {
        let normal = draw.direction().to_array();
        json!({"light": {"light": light, "from": vector(draw, 3.0), "normal": normal, "u": [square(draw)]}})
    };
    let color = |draw: &mut Draw| {
        json!((std::array::from_fn::<f64, 3, _>(|_| round(draw.between(0.25, 2.0)))))
    };
    let sky = move |draw: &mut Draw| {
        let mut question = anywhere(draw, json!({"environment": {}}));
        question["light"]["background"] = color(draw);
        question
    };
    let occluder = move |draw: &mut Draw| {
        let ls = round(draw.between(0.5, 3.0));
        let least = round(draw.between(0.0, 1.0));
        let color = color(draw);
        let light = json!({"ambient_occluder": {"ls": ls, "color": color, "min_amount": least}});
        anywhere(draw, light)
    };
    let extended = move |draw: &mut Draw| {
        let mut question = occluder(draw);
        let it = &mut question["light"]["light"]["ambient_occluder"];
        it["max_distance"] = json!(round(draw.between(0.5, 20.0)));
        it["min_amount"] = json!(round(draw.between(0.25, 1.0)));
        it["occluded_color"] = color(draw);
        question
    };
    let sample = Judge::Law(laws::sky_sample);
    let occluders = "lights/ambient_occluder";
    let mut drawn = family(
        "light.ambient_occluder.cosine",
        occluders,
        "ch17",
        Judge::Law(laws::cosine_drawn),
        occluder,
    );
    drawn.share = FEW;
    vec![
        family("light.environment.values", "lights/environment", "ch18", sample, sky),
        mean("light.environment.mean", "lights/environment", "ch18", sky),
        family("light.ambient_occluder.values", occluders, "ch17", sample, occluder),
        family("light.ambient_occluder.extended", occluders, "ch17", sample, extended),
        mean("light.ambient_occluder.mean", occluders, "ch17", occluder),
        drawn,
    ]
}

/// Jittered directions and places.
fn of_jittered() -> Vec<Family> {
    let directional = |draw: &mut Draw| {
        let to = draw.direction().to_array();
        json!({"light": {
            "light": {"jittered_directional": {
                "ls": round(draw.between(0.5, 3.0)), "direction": to.map(|x| round(5.0 * x)),
                "jitter": round(draw.between(0.1, 0.5)),
            }},
            "from": vector(draw, 2.0), "normal": to, "u": [square(draw), square(draw)],
        }})
    };
    let spherical = |draw: &mut Draw| {
        let to = draw.direction().to_array();
        json!({"light": {
            "light": {"fake_spherical": {
                "ls": round(draw.between(0.5, 3.0)), "location": to.map(|x| round(8.0 * x)),
                "jitter": round(draw.between(0.5, 2.0)), "attenuation": draw.pick(&[0.0, 1.0, 2.0]),
            }},
            "from": vector(draw, 1.0), "normal": to, "u": [square(draw), square(draw)],
        }})
    };
    let moments = |name: &str, case: fn(&mut Draw) -> Value| {
        let about = format!("lights/{name}");
        let judge = Judge::Law(laws::jittered_moments);
        let mut family = family(&format!("light.{name}.moments"), &about, "ch18", judge, case);
        family.share = FEW;
        family
    };
    vec![moments("jittered_directional", directional), moments("fake_spherical", spherical)]
}
