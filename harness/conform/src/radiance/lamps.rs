//! Light that needs samples: of lamps, of the sky, of jittered lights, of a glossy lobe, of a lens (Suffern, ch. 4, 10,
//! 17, 18, 25).

use serde_json::{Value, json};

use super::super::judgement::triple;
use super::stage::{
    self, Exact, between, color, direct, light, material, matte, mean_along, object, phong, ray,
    share, whitted, within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("lamp.rectangle", "ch18", |draw| {
        let shape = rectangle(draw);
        lit(draw, shape, false)
    }),
    ("lamp.disk", "ch18", |draw| {
        let normal = within(draw, [-0.4, -1.0, -0.4], [0.4, -0.8, 0.4]);
        let radius = between(draw, 0.5, 1.25);
        lit(draw, json!({"disk": {"center": LAMP, "normal": normal, "radius": radius}}), false)
    }),
    ("lamp.sphere", "ch18", |draw| {
        let radius = between(draw, 0.4, 1.0);
        lit(draw, stage::sphere(LAMP, radius), false)
    }),
    ("lamp.two_sided", "ch18", |draw| {
        let shape = rectangle(draw);
        lit(draw, shape, true)
    }),
    ("lamp.stretched", "ch18", |draw| {
        let shape = stretched(draw);
        lit(draw, shape, false)
    }),
    ("lamp.shadow", "ch18", penumbra),
    ("lamp.highlight", "ch18", |draw| {
        let shape = rectangle(draw);
        let mut question = lit(draw, shape, false);
        let recipe = json!({"phong": phong(draw)});
        question["radiance"]["scene"]["materials"][0]["recipe"] = recipe;
        question
    }),
    ("lamp.two", "ch18", two_lamps),
    ("sky.open", "ch18", |draw| under_sky(draw, false)),
    ("sky.wall", "ch18", |draw| under_sky(draw, true)),
    ("lights.jittered", "ch18", |draw| {
        let source = json!({"jittered_directional": {
            "ls": between(draw, 1.0, 4.0), "color": color(draw),
            "direction": within(draw, [-3.0, 2.0, -3.0], [3.0, 6.0, 6.0]), "jitter": between(draw, 0.1, 0.5),
        }});
        jittered(draw, source)
    }),
    ("lights.fake_spherical", "ch18", |draw| {
        let source = json!({"fake_spherical": {
            "ls": between(draw, 10.0, 40.0), "color": color(draw), "attenuation": 2.0,
            "location": within(draw, [-3.0, 2.5, -2.0], [3.0, 5.0, 3.0]), "jitter": between(draw, 0.2, 1.0),
        }});
        jittered(draw, source)
    }),
    ("occlusion.wall", "ch17", |draw| occlusion(draw, |_, _| {})),
    ("occlusion.min_amount", "ch17", |draw| {
        occlusion(draw, |draw, occluder| occluder["min_amount"] = json!(between(draw, 0.2, 0.6)))
    }),
    ("occlusion.two_colors", "ch17", |draw| {
        occlusion(draw, |draw, occluder| {
            occluder["min_amount"] = json!(between(draw, 0.4, 0.9));
            occluder["occluded_color"] = color(draw);
        })
    }),
    ("occlusion.distance", "ch17", |draw| {
        occlusion(draw, |draw, occluder| occluder["max_distance"] = json!(between(draw, 0.3, 1.5)))
    }),
    ("gloss.sky", "ch25", |draw| gloss(draw, false)),
    ("gloss.ground", "ch25", |draw| gloss(draw, true)),
    ("pixel.box", "ch04", |draw| edges(draw, false)),
    ("pixel.thin_lens", "ch10", |draw| edges(draw, true)),
    ("pixel.lens_and_lamp", "ch18", |draw| through_lens(draw, penumbra)),
    ("pixel.lens_and_sky", "ch18", |draw| through_lens(draw, |draw| under_sky(draw, true))),
];

/// The middle of a lamp.
const LAMP: [f64; 3] = [0.25, 3.0, -0.5];

/// A rectangle that faces down, or up one time of five.
fn rectangle(draw: &mut Draw) -> Value {
    let (width, length) = (between(draw, 0.75, 2.5), between(draw, 0.75, 2.5));
    let (across, along) = ([width, 0.0, 0.0], [0.0, 0.0, length]);
    let (a, b) = if draw.below(5) == 0 { (along, across) } else { (across, along) };
    let corner = [LAMP[0] - 0.5 * width, LAMP[1], LAMP[2] - 0.5 * length];
    json!({"rectangle": {"corner": corner, "a": a, "b": b}})
}

/// A lamp as an instance whose area is that of no untransformed one, some of them mirrored.
fn stretched(draw: &mut Draw) -> Value {
    let (of, down) = match draw.below(3) {
        0 => {
            let square =
                json!({"corner": [-0.5, 0.0, -0.5], "a": [1.0, 0.0, 0.0], "b": [0.0, 0.0, 1.0]});
            (json!({"rectangle": square}), json!({"rotate_x": 15.0}))
        }
        1 => {
            let disk =
                json!({"center": [0.0, 0.0, 0.0], "normal": [0.0, -1.0, 0.0], "radius": 0.5});
            (json!({"disk": disk}), json!({"rotate_z": 20.0}))
        }
        _ => (stage::sphere([0.0; 3], 0.5), json!({"rotate_z": 30.0})),
    };
    let scale = within(draw, [0.75; 3], [2.5; 3]);
    let mut transform = vec![json!({"scale": scale}), down];
    if draw.coin() {
        transform.push(json!({"reflect": "x"}));
    }
    transform.push(json!({"translate": LAMP}));
    json!({"instance": {"of": of, "transform": transform}})
}

/// A matte ground under a lamp, and nothing else.
fn lit(draw: &mut Draw, shape: Value, two_sided: bool) -> Value {
    let mut lamp = material("glow", emission(draw));
    lamp["two_sided"] = json!(two_sided);
    let materials = vec![material("stone", matte(draw)), lamp];
    let objects = vec![object("floor", "stone", stage::ground()), object("lamp", "glow", shape)];
    let lights = vec![light("light", json!({"area": {"object": "lamp"}}))];
    let scene = stage::scene(direct(), lights, materials, objects);
    let aim = within(draw, [-2.5, 0.0, -2.0], [2.5, 0.0, 2.0]);
    mean_along(draw, scene, ray(from_below(aim), aim))
}

fn emission(draw: &mut Draw) -> Value {
    json!({"emissive": {"ls": between(draw, 2.0, 20.0), "ce": color(draw)}})
}

/// Below the lamp, so that it is not in the way.
fn from_below(aim: [f64; 3]) -> [f64; 3] {
    [aim[0] + 0.5, 1.25, aim[2] + 2.0]
}

/// A ball between lamp and ground, whose shadow has a soft border.
fn penumbra(draw: &mut Draw) -> Value {
    let shape = match draw.below(2) {
        0 => rectangle(draw),
        _ => stage::sphere(LAMP, 0.75),
    };
    let mut question = lit(draw, shape, false);
    let ball = object("ball", "stone", stage::sphere([0.25, 1.5, -0.5], 0.5));
    let data = &mut question["radiance"];
    if let Some(objects) = data["scene"]["objects"].as_array_mut() {
        objects.push(ball);
    }
    let aim = within(draw, [-0.75, 0.0, -1.25], [1.25, 0.0, 0.25]);
    data["ray"] = ray([aim[0] + 1.5, 0.5, aim[2] + 2.0], aim);
    question
}

/// Two lamps and a point light, each of another colour.
fn two_lamps(draw: &mut Draw) -> Value {
    let shape = rectangle(draw);
    let mut question = lit(draw, shape, false);
    let scene = &mut question["radiance"]["scene"];
    let added = [
        ("materials", material("ember", emission(draw))),
        ("objects", object("ember", "ember", stage::sphere([-2.0, 1.5, -2.0], 0.5))),
        ("lights", light("second", json!({"area": {"object": "ember"}}))),
        (
            "lights",
            light("candle", json!({"point": {"color": color(draw), "location": [2.5, 2.0, -1.0]}})),
        ),
    ];
    for (list, item) in added {
        if let Some(items) = scene[list].as_array_mut() {
            items.push(item);
        }
    }
    question
}

/// A ground, alone or beside a wall, under a sky of one colour: its light is sampled.
fn under_sky(draw: &mut Draw, with_wall: bool) -> Value {
    let materials = vec![material("stone", matte(draw)), material("chalk", matte(draw))];
    let mut objects = vec![object("floor", "stone", stage::ground())];
    if with_wall {
        objects.push(object("wall", "chalk", stage::wall(-1.0)));
    }
    let lights = vec![light("sky", json!({"environment": {}}))];
    let mut scene = stage::scene(direct(), lights, materials, objects);
    scene["background"] = color(draw);
    let aim = within(draw, [-2.0, 0.0, -0.9], [2.0, 0.0, 1.5]);
    mean_along(draw, scene, ray(from_below(aim), aim))
}

/// A ground and a ball in the light of a light that is somewhere else for each sample.
fn jittered(draw: &mut Draw, source: Value) -> Value {
    let materials = vec![material("stone", matte(draw)), material("chalk", matte(draw))];
    let objects = vec![
        object("floor", "stone", stage::ground()),
        object("ball", "chalk", stage::sphere([0.0, 0.75, 0.0], 0.75)),
    ];
    let scene = stage::scene(direct(), vec![light("lamp", source)], materials, objects);
    let aim = within(draw, [-2.0, 0.0, 0.0], [2.0, 1.0, 1.0]);
    let from = stage::before(draw);
    mean_along(draw, scene, ray(from, aim))
}

/// The ambient light of a ground beside a wall: a closed form, and where objects far away are not in the way, less.
fn occlusion(draw: &mut Draw, change: fn(&mut Draw, &mut Value)) -> Value {
    let mut occluder = json!({"ls": between(draw, 0.5, 2.0), "color": color(draw)});
    change(draw, &mut occluder);
    let materials = vec![material("stone", matte(draw)), material("chalk", matte(draw))];
    let objects = vec![
        object("floor", "stone", stage::ground()),
        object("wall", "chalk", stage::wall(-1.0)),
        object("ball", "chalk", stage::sphere([1.0, 0.75, 0.5], 0.75)),
    ];
    let lights = vec![light("sky", json!({"ambient_occluder": occluder}))];
    let scene = stage::scene(direct(), lights, materials, objects);
    let aim = within(draw, [-1.5, 0.0, -0.9], [1.0, 0.0, 0.5]);
    mean_along(draw, scene, ray(from_below(aim), aim))
}

/// A glossy ball under a sky, which is the same in all directions; or over a lit ground.
fn gloss(draw: &mut Draw, with_ground: bool) -> Value {
    let glossy = json!({"glossy_reflector": {
        "phong": phong(draw), "kr": share(draw), "cr": color(draw), "exponent": draw.pick(&[1.0, 4.0, 20.0, 100.0]),
    }});
    let materials = vec![material("gloss", glossy), material("stone", matte(draw))];
    let mut objects = vec![object("ball", "gloss", stage::sphere([0.0, 1.0, 0.0], 1.0))];
    let mut lights = Vec::new();
    if with_ground {
        objects.push(object("floor", "stone", stage::ground()));
        let at = within(draw, [-2.0, 3.0, 0.0], [2.0, 5.0, 4.0]);
        let source =
            json!({"point": {"ls": between(draw, 10.0, 40.0), "location": at, "attenuation": 2.0}});
        lights.push(light("lamp", source));
    }
    let mut scene = stage::scene(whitted(2), lights, materials, objects);
    scene["background"] = color(draw);
    let low = if with_ground { 0.3 } else { 0.8 };
    let aim = within(draw, [-0.4, low, 0.2], [0.4, 1.2, 0.6]);
    let from = stage::before(draw);
    mean_along(draw, scene, ray(from, aim))
}

/// A pixel over the edges of two bright rectangles, one of them far from the focal plane if there is a lens.
fn edges(draw: &mut Draw, with_lens: bool) -> Value {
    let glow =
        |draw: &mut Draw| json!({"emissive": {"ls": between(draw, 1.0, 4.0), "ce": color(draw)}});
    let materials = vec![material("near", glow(draw)), material("far", glow(draw))];
    let edge = |x: f64, y: f64, z: f64| json!({"rectangle": {"corner": [x, y, z], "a": [9.0, 0.0, 0.0], "b": [0.0, 9.0, 0.0]}});
    let near = [between(draw, -0.3, 0.3), between(draw, -0.3, 0.3)];
    let far = [-9.0 + between(draw, -0.6, 0.6), -9.0 + between(draw, -0.6, 0.6)];
    let objects = vec![
        object("near", "near", edge(near[0], near[1], 0.0)),
        object("far", "far", edge(far[0], far[1], -6.0)),
    ];
    let mut scene = stage::scene(direct(), Vec::new(), materials, objects);
    scene["background"] = color(draw);
    let (eye, lens) = match with_lens {
        true => {
            let focal = between(draw, 3.0, 11.0);
            let lens = json!({"distance": 4.0, "focal_distance": focal, "lens_radius": between(draw, 0.2, 0.5)});
            (5.0, json!({"thin_lens": lens}))
        }
        false => (5.0, json!({"pinhole": {"distance": 4.0}})),
    };
    scene["camera"] = json!({"eye": [0.0, 0.0, eye], "lens": lens});
    scene["image"] = json!({"width": 5, "height": 3, "pixel_size": 0.5});
    let pixel = [1 + draw.below(3), 1];
    let seed = draw.below(1 << 30);
    json!({"radiance": {
        "scene": scene, "pixel": pixel, "samples": stage::SAMPLES, "seed": seed, "replicas": 1,
    }})
}

/// What a lens of some size sees there, in a pixel of some size: a sample draws for all three, and each number once.
fn through_lens(draw: &mut Draw, of: fn(&mut Draw) -> Value) -> Value {
    let mut question = of(draw);
    let data = &mut question["radiance"];
    let ray = data["ray"].take();
    let [eye, towards] = ["origin", "direction"].map(|it| triple(&ray[it]).unwrap_or_default());
    let look_at: [f64; 3] = std::array::from_fn(|i| eye[i] + towards[i]);
    let lens = json!({"thin_lens": {
        "distance": 1.0, "focal_distance": between(draw, 1.0, 4.0), "lens_radius": between(draw, 0.2, 0.4),
    }});
    data["scene"]["camera"] = json!({"eye": eye, "look_at": look_at, "lens": lens});
    data["scene"]["image"] = json!({"width": 1, "height": 1, "pixel_size": 0.6});
    if let Some(data) = data.as_object_mut() {
        data.remove("ray");
        data.insert("pixel".to_owned(), json!([0, 0]));
    }
    question
}
