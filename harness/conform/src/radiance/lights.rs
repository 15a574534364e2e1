//! Lights of several kinds, and the switches of shadows (Suffern, ch. 14, 16).

use serde_json::{Value, json};

use super::stage::{self, Exact, between, color, light, share, still_life, within};
use exact::Draw;
use groundtruth::math::power;

pub const ALL: &[Exact] = &[
    ("lights.directional", "ch14", |draw| {
        let (light, at) = sun(draw);
        still_life(draw, vec![light], at)
    }),
    ("lights.attenuated", "ch14", |draw| {
        let exponent = draw.pick(&[1.0, 2.0]);
        let (light, at) = lamp(draw, "lamp", exponent);
        still_life(draw, vec![light], at)
    }),
    ("lights.spot", "ch14", spot),
    ("lights.several", "ch14", |draw| {
        let (lights, at) = several(draw);
        still_life(draw, lights, at)
    }),
    ("lights.switched_off", "ch14", |draw| {
        let (mut lights, at) = several(draw);
        lights.iter_mut().for_each(|light| switch(draw, light, "enabled"));
        let mut question = still_life(draw, lights, at);
        switch_each(draw, &mut question, "objects", "enabled");
        question
    }),
    ("shadows.of_lights", "ch16", |draw| {
        let (mut lights, at) = several(draw);
        lights.iter_mut().for_each(|light| switch(draw, light, "shadows"));
        still_life(draw, lights, at)
    }),
    ("shadows.of_objects", "ch16", |draw| {
        let (light, at) = lamp(draw, "lamp", 0.0);
        let mut question = still_life(draw, vec![light], at);
        switch_each(draw, &mut question, "objects", "casts_shadows");
        question
    }),
    ("shadows.of_materials", "ch16", |draw| {
        let (light, at) = lamp(draw, "lamp", 0.0);
        let mut question = still_life(draw, vec![light], at);
        switch_each(draw, &mut question, "materials", "casts_shadows");
        question
    }),
    ("shadows.of_parts", "ch16", parts),
    ("shadows.lamp_between", "ch16", lamp_between),
];

/// A directional light from anywhere, mostly from above, and a far point in its direction, which is not unit.
fn sun(draw: &mut Draw) -> (Value, [f64; 3]) {
    let to = within(draw, [-6.0, -2.0, -4.0], [6.0, 10.0, 8.0]);
    let (ls, color) = (between(draw, 1.0, 4.0), color(draw));
    let source = json!({"directional": {"ls": ls, "color": color, "direction": to}});
    (light("sun", source), to.map(|x| 1e3 * x))
}

/// A point light from anywhere, mostly from above.
fn lamp(draw: &mut Draw, name: &str, exponent: f64) -> (Value, [f64; 3]) {
    let at = within(draw, [-5.0, -1.0, -3.0], [5.0, 7.0, 6.0]);
    let near = if exponent > 0.0 { power(4.0, exponent) } else { 1.0 };
    let ls = between(draw, near, 4.0 * near);
    let source =
        json!({"point": {"ls": ls, "color": color(draw), "location": at, "attenuation": exponent}});
    (light(name, source), at)
}

/// Three lights, and where one of them is.
fn several(draw: &mut Draw) -> (Vec<Value>, [f64; 3]) {
    let (sun, far) = sun(draw);
    let (first, at) = lamp(draw, "lamp", 0.0);
    let (second, other) = lamp(draw, "candle", 2.0);
    let looked = draw.pick(&[far, at, other]);
    (vec![first, sun, second], looked)
}

/// A spot over the scene, mostly seen between its two angles.
fn spot(draw: &mut Draw) -> Value {
    let at = within(draw, [-3.0, 3.0, -1.0], [3.0, 6.0, 3.0]);
    let aim = within(draw, [-1.0, 0.0, -0.5], [1.0, 1.0, 0.5]);
    let direction: [f64; 3] = std::array::from_fn(|i| aim[i] - at[i]);
    let source = json!({"spot": {
        "ls": between(draw, 20.0, 60.0), "color": color(draw), "location": at, "direction": direction,
        "inner": between(draw, 4.0, 12.0), "outer": between(draw, 25.0, 50.0), "attenuation": 2.0,
    }});
    still_life(draw, vec![light("spot", source)], at)
}

/// Switches something off, or says that it is on.
fn switch(draw: &mut Draw, item: &mut Value, field: &str) {
    item[field] = json!(draw.coin());
}

fn switch_each(draw: &mut Draw, question: &mut Value, list: &str, field: &str) {
    let items = question["radiance"]["scene"][list].as_array_mut();
    items.into_iter().flatten().for_each(|item| switch(draw, item, field));
}

/// The ball and the box as parts of one object, with materials that cast shadows or do not.
fn parts(draw: &mut Draw) -> Value {
    let (lamp, at) = lamp(draw, "lamp", 0.0);
    let mut question = still_life(draw, vec![lamp], at);
    switch_each(draw, &mut question, "materials", "casts_shadows");
    let objects = &mut question["radiance"]["scene"]["objects"];
    let [ball, block] = [0, 1].map(|i| objects[i]["shape"].clone());
    let things = json!({"compound": {"parts": [
        {"material": "chalk", "shape": ball}, {"material": "enamel", "shape": block},
    ]}});
    *objects = json!([stage::object("things", "stone", things), objects[2].clone()]);
    question
}

/// A lamp between the ball and the box, so that each is behind it for the other.
fn lamp_between(draw: &mut Draw) -> Value {
    let at = within(draw, [0.35, 0.2, -0.4], [0.65, 1.8, 0.4]);
    let source = json!({"point": {"ls": between(draw, 1.0, 4.0), "location": at}});
    let dim = json!({"directional": {"ls": share(draw), "direction": [1.0, 2.0, 1.0]}});
    still_life(draw, vec![light("lamp", source), light("sun", dim)], at)
}
