//! Images on surfaces and as the sky (Suffern, ch. 29): their texels stand in the scene.

use serde_json::{Value, json};

use super::super::questions::{CORNERS, FACES, texels};
use super::stage::{
    self, Exact, along, between, color, direct, light, material, matte, mean_along, object, ray,
    share, whitted, within,
};
use exact::Draw;

/// Images seen directly.
pub const ALL: &[Exact] = &[
    ("image.sphere", "ch29", |draw| on(draw, "spherical", stage::sphere([0.0; 3], 1.0))),
    ("image.cylinder", "ch29", |draw| {
        on(draw, "cylindrical", json!({"open_cylinder": {"y0": -1.0, "y1": 1.0, "radius": 1.0}}))
    }),
    ("image.rectangle", "ch29", |draw| {
        let square =
            json!({"corner": [-1.0, 0.0, -1.0], "a": [0.0, 0.0, 2.0], "b": [2.0, 0.0, 0.0]});
        on(draw, "square", json!({"rectangle": square}))
    }),
    ("image.mesh", "ch29", |draw| {
        let uvs = CORNERS.map(|_| [between(draw, 0.0, 1.0), between(draw, 0.0, 1.0)]);
        let image =
            json!({"texels": texels(draw), "filtering": draw.pick(&["nearest", "bilinear"])});
        let mesh = json!({"vertices": CORNERS, "triangles": FACES, "uvs": uvs});
        moved(draw, json!({"image": image}), json!({"mesh": mesh}))
    }),
    ("wireframe", "ch29", |draw| {
        let wires = json!({"wireframe": {
            "line_width": between(draw, 0.1, 0.3), "line_color": color(draw), "color": color(draw),
        }});
        moved(draw, wires, json!({"mesh": {"vertices": CORNERS, "triangles": FACES}}))
    }),
    ("sky.spherical", "ch29", |draw| seen(draw, "spherical")),
    ("sky.hemispherical", "ch29", |draw| seen(draw, "hemispherical")),
    ("sky.light_probe", "ch29", |draw| seen(draw, "light_probe")),
    ("sky.panoramic", "ch29", |draw| seen(draw, "panoramic")),
    ("sky.mirrored", "ch29", |draw| {
        let mirror = json!({"reflective": {"phong": {"ka": 0.0, "kd": 0.0, "cd": 0.0}, "kr": share(draw), "cr": color(draw)}});
        let objects = vec![object("ball", "mirror", stage::sphere([0.0, 1.0, 0.0], 1.0))];
        let mut scene =
            stage::scene(whitted(3), Vec::new(), vec![material("mirror", mirror)], objects);
        scene["background"] = sky(draw, "spherical");
        let aim = within(draw, [-0.6, 0.4, 0.0], [0.6, 1.6, 0.4]);
        along(scene, ray(stage::before(draw), aim))
    }),
];

/// Ground in the light of a sky that is an image.
pub const MEANS: &[Exact] = &[
    ("sky.lit", "ch29", |draw| lit(draw, "spherical")),
    ("sky.lit_from_above", "ch29", |draw| lit(draw, "hemispherical")),
    ("sky.lit_by_probe", "ch29", |draw| lit(draw, "light_probe")),
];

/// A painted body in the middle of the stage, turned and stretched with its image.
fn on(draw: &mut Draw, mapping: &str, shape: Value) -> Value {
    let filtering = draw.pick(&["nearest", "bilinear"]);
    let image = json!({"texels": texels(draw), "mapping": mapping, "filtering": filtering});
    moved(draw, json!({"image": image}), shape)
}

fn moved(draw: &mut Draw, cd: Value, shape: Value) -> Value {
    let turns = [between(draw, -80.0, 80.0), between(draw, -80.0, 80.0)];
    let transform = json!([
        {"scale": within(draw, [0.7; 3], [1.3; 3])}, {"rotate_x": turns[0]}, {"rotate_z": turns[1]},
        {"translate": [0.0, 1.5, 0.0]},
    ]);
    let mut painted =
        material("painted", json!({"matte": {"ka": share(draw), "kd": share(draw), "cd": cd}}));
    painted["two_sided"] = json!(true);
    let materials = vec![painted, material("stone", matte(draw))];
    let objects = vec![
        object("it", "painted", json!({"instance": {"of": shape, "transform": transform}})),
        object("floor", "stone", stage::ground()),
    ];
    let at = within(draw, [-4.0, 4.0, 1.0], [4.0, 7.0, 6.0]);
    let lamp = json!({"point": {"ls": between(draw, 2.0, 4.0), "location": at}});
    let lights = vec![light("lamp", lamp), light("sky", json!({"ambient": {"ls": share(draw)}}))];
    let scene = stage::scene(direct(), lights, materials, objects);
    let aim = within(draw, [-0.7, 0.9, -0.5], [0.7, 2.1, 0.5]);
    along(scene, ray(stage::before(draw), aim))
}

/// A turned image as the sky.
fn sky(draw: &mut Draw, mapping: &str) -> Value {
    json!({"image": {
        "texels": texels(draw), "mapping": mapping, "ls": between(draw, 0.5, 2.0),
        "rotate_y": draw.pick(&[0.0, 35.0, -100.0]),
    }})
}

/// A sky in any direction.
fn seen(draw: &mut Draw, mapping: &str) -> Value {
    let mut scene = stage::scene(direct(), Vec::new(), Vec::new(), Vec::new());
    scene["background"] = sky(draw, mapping);
    let towards = draw.direction().to_array().map(|x| 2.0 * x);
    along(scene, ray([0.0; 3], towards))
}

/// A matte plane in any position, lit by the sky alone.
fn lit(draw: &mut Draw, mapping: &str) -> Value {
    let normal = within(draw, [-0.6, 0.5, -0.6], [0.6, 1.0, 0.6]);
    let plane = json!({"plane": {"point": [0.0, 0.0, 0.0], "normal": normal}});
    let materials = vec![material("stone", matte(draw))];
    let objects = vec![object("floor", "stone", plane)];
    let lights = vec![light("sky", json!({"environment": {}}))];
    let mut scene = stage::scene(direct(), lights, materials, objects);
    scene["background"] = sky(draw, mapping);
    let from = normal.map(|x| 2.0 * x);
    mean_along(draw, scene, ray(from, [0.0; 3]))
}
