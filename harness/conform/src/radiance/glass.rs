//! Transparent bodies: from outside and inside, in one another, with media that absorb (Suffern, ch. 27, 28).

use serde_json::{Value, json};

use super::stage::{
    self, Exact, along, between, color, light, material, matte, object, ray, share, whitted, within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("transparent.depth", "ch27", |draw| {
        let depth = draw.below(5);
        let recipe = transparent(draw, [1.2, 1.8]);
        from_outside(draw, recipe, stage::sphere(MIDDLE, 1.0), depth)
    }),
    ("transparent.box", "ch27", |draw| {
        let recipe = transparent(draw, [1.2, 1.8]);
        from_outside(draw, recipe, slab(), 5)
    }),
    ("transparent.rare", "ch27", |draw| {
        let recipe = transparent(draw, [0.6, 0.9]);
        from_outside(draw, recipe, stage::sphere(MIDDLE, 1.0), 4)
    }),
    ("transparent.inside", "ch27", |draw| {
        let recipe = transparent(draw, [1.2, 1.8]);
        from_inside(draw, recipe)
    }),
    ("dielectric.depth", "ch28", |draw| {
        let depth = draw.below(5);
        let recipe = dielectric(draw, [1.2, 1.8], false);
        from_outside(draw, recipe, stage::sphere(MIDDLE, 1.0), depth)
    }),
    ("dielectric.box", "ch28", |draw| {
        let recipe = dielectric(draw, [1.2, 1.8], false);
        from_outside(draw, recipe, slab(), 5)
    }),
    ("dielectric.rare", "ch28", |draw| {
        let recipe = dielectric(draw, [0.6, 0.9], false);
        from_outside(draw, recipe, stage::sphere(MIDDLE, 1.0), 4)
    }),
    ("dielectric.inside", "ch28", |draw| {
        let recipe = dielectric(draw, [1.2, 1.8], false);
        from_inside(draw, recipe)
    }),
    ("dielectric.unscaled", "ch28", |draw| {
        let recipe = dielectric(draw, [1.2, 1.8], false);
        let mut question = from_inside(draw, recipe);
        question["radiance"]["scene"]["transparency"] = json!({"scales_radiance": false});
        question
    }),
    ("dielectric.absorbing", "ch28", |draw| {
        let shape = if draw.coin() { slab() } else { stage::sphere(MIDDLE, 1.0) };
        let recipe = dielectric(draw, [1.2, 1.8], true);
        from_outside(draw, recipe, shape, 4)
    }),
    ("dielectric.filter", "ch28", |draw| {
        let recipe = dielectric(draw, [1.0, 1.0], true);
        from_outside(draw, recipe, slab(), 3)
    }),
    ("dielectric.nested", "ch28", nested),
    ("dielectric.camera_medium", "ch28", camera_medium),
    ("shadows.of_glass", "ch27", |draw| shadow_of_glass(draw, "opaque")),
    ("shadows.attenuated", "ch28", |draw| shadow_of_glass(draw, "attenuated")),
];

const MIDDLE: [f64; 3] = [0.0, 1.25, 0.0];

/// A turned box of glass, whose neighbouring faces reflect totally.
fn slab() -> Value {
    let block = json!({"box": {"min": [-0.875, -0.75, -0.5], "max": [0.875, 0.75, 0.5]}});
    let turn = json!([{"rotate_y": 25.0}, {"rotate_x": 15.0}, {"translate": MIDDLE}]);
    json!({"instance": {"of": block, "transform": turn}})
}

fn transparent(draw: &mut Draw, [low, high]: [f64; 2]) -> Value {
    let kr = between(draw, 0.05, 0.4);
    json!({"transparent": {
        "phong": highlight(draw), "kr": kr, "kt": 1.0 - kr, "eta": between(draw, low, high),
    }})
}

fn dielectric(draw: &mut Draw, [low, high]: [f64; 2], absorbs: bool) -> Value {
    let mut inside = json!({"eta": between(draw, low, high)});
    if absorbs {
        inside["absorption"] = color(draw);
    }
    json!({"dielectric": {"phong": highlight(draw), "inside": inside}})
}

fn highlight(draw: &mut Draw) -> Value {
    json!({"ks": share(draw), "exponent": draw.pick(&[20.0, 100.0])})
}

fn lights(draw: &mut Draw) -> Vec<Value> {
    let at = within(draw, [-3.0, 4.0, 0.0], [3.0, 7.0, 5.0]);
    let lamp = json!({"point": {"ls": between(draw, 2.0, 4.0), "location": at}});
    vec![light("lamp", lamp), light("sky", json!({"ambient": {"ls": share(draw)}}))]
}

/// A body of this material over a matte ground, before a matte ball, under a sky.
fn around(draw: &mut Draw, recipe: Value, shape: Value, depth: usize) -> Value {
    let materials = vec![
        material("glass", recipe),
        material("stone", matte(draw)),
        material("chalk", matte(draw)),
    ];
    let objects = vec![
        object("body", "glass", shape),
        object("floor", "stone", stage::ground()),
        object("ball", "chalk", stage::sphere([0.75, 1.0, -2.75], 1.0)),
    ];
    let mut scene = stage::scene(whitted(depth), lights(draw), materials, objects);
    scene["background"] = color(draw);
    scene
}

fn from_outside(draw: &mut Draw, recipe: Value, shape: Value, depth: usize) -> Value {
    let scene = around(draw, recipe, shape, depth);
    let aim = within(draw, [-0.7, 0.7, -0.2], [0.7, 1.8, 0.2]);
    along(scene, ray(stage::before(draw), aim))
}

/// A ray that starts inside a ball or a box, in any direction.
fn from_inside(draw: &mut Draw, recipe: Value) -> Value {
    let shape = if draw.coin() { slab() } else { stage::sphere(MIDDLE, 1.0) };
    let depth = 1 + draw.below(4);
    let scene = around(draw, recipe, shape, depth);
    let start = within(draw, [-0.35, 1.0, -0.35], [0.35, 1.5, 0.35]);
    let to = draw.direction().to_array();
    along(scene, ray(start, std::array::from_fn(|i| start[i] + to[i])))
}

/// A ball of another index in a ball: between them are two media, neither of them air.
fn nested(draw: &mut Draw) -> Value {
    let outer = json!({"eta": between(draw, 1.2, 1.5), "absorption": color(draw)});
    let inner = json!({"eta": between(draw, 1.6, 2.4), "absorption": color(draw)});
    let glass = json!({"dielectric": {"inside": outer}});
    let mut scene = around(draw, glass, stage::sphere(MIDDLE, 1.0), 4);
    let core = material("core", json!({"dielectric": {"inside": inner, "outside": outer}}));
    let shape = stage::sphere([0.125, 1.25, 0.0], 0.5);
    let pairs = [("materials", core), ("objects", object("core", "core", shape))];
    for (list, item) in pairs {
        if let Some(items) = scene[list].as_array_mut() {
            items.push(item);
        }
    }
    let aim = within(draw, [-0.45, 0.8, 0.0], [0.6, 1.7, 0.0]);
    along(scene, ray(stage::before(draw), aim))
}

/// The viewer is in water; what is behind its surface is in air.
fn camera_medium(draw: &mut Draw) -> Value {
    let water = json!({"eta": between(draw, 1.2, 1.5), "absorption": color(draw).as_array().map(
        |channels| channels.iter().map(|x| 0.25 * x.as_f64().unwrap_or(0.0)).collect::<Vec<f64>>(),
    )});
    let recipe = json!({"dielectric": {"inside": water}});
    let pool = json!({"box": {"min": [-8.0, -4.0, -8.0], "max": [8.0, 3.0, 8.0]}});
    let mut scene = around(draw, recipe, pool, 2);
    scene["camera"]["medium"] = water;
    let from = within(draw, [-2.0, 1.5, 2.0], [2.0, 2.5, 4.0]);
    let aim = within(draw, [-2.0, 0.0, -3.0], [2.0, 4.0, 0.0]);
    along(scene, ray(from, aim))
}

/// The ground in the shadow of a body of absorbing glass.
fn shadow_of_glass(draw: &mut Draw, shadows: &str) -> Value {
    let shape = if draw.coin() { slab() } else { stage::sphere(MIDDLE, 1.0) };
    let recipe = dielectric(draw, [1.2, 1.8], true);
    let mut scene = around(draw, recipe, shape, 3);
    scene["transparency"] = json!({"shadows": shadows});
    let lamp = within(draw, [-3.0, 4.5, -2.0], [3.0, 7.0, 3.0]);
    scene["lights"][0]["source"]["point"]["location"] = json!(lamp);
    let of = within(draw, [-0.6, 0.8, -0.6], [0.6, 1.7, 0.6]);
    // from nearby, so that glass is seldom in the way
    let aim = stage::shadow(of, lamp);
    let from = [aim[0] + between(draw, -0.2, 0.2), 0.25, aim[2] + between(draw, 0.1, 0.3)];
    along(scene, ray(from, aim))
}
