//! Sides, highlights, meshes and instances in scenes (Suffern, ch. 14, 15, 18, 21, 23, 31).

use serde_json::{Value, json};

use super::super::questions::{CORNERS, FACES};
use super::stage::{
    self, Exact, along, between, color, direct, light, material, matte, object, phong, ray, share,
    within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("sides.one", "ch14", |draw| open(draw, false)),
    ("sides.two", "ch14", |draw| open(draw, true)),
    ("emissive", "ch18", emissive),
    ("background", "ch03", background),
    ("highlight", "ch15", highlight),
    ("mesh.flat", "ch23", |draw| {
        let mesh = mesh(draw);
        shown(draw, json!({"mesh": mesh}))
    }),
    ("mesh.smooth", "ch23", |draw| {
        let mut mesh = mesh(draw);
        mesh["smooth"] = json!(true);
        shown(draw, json!({"mesh": mesh}))
    }),
    ("mesh.normals", "ch23", |draw| {
        let mut mesh = mesh(draw);
        mesh["smooth"] = json!(true);
        let normals = (0..6).map(|_| stage::within(draw, [-0.4; 3], [0.4; 3]));
        let normals: Vec<[f64; 3]> = normals
            .zip(CORNERS)
            .map(|(by, at)| std::array::from_fn(|i| 2.0 * at[i] + by[i]))
            .collect();
        mesh["normals"] = json!(normals);
        shown(draw, json!({"mesh": mesh}))
    }),
    ("mesh.tessellated", "ch23", |draw| {
        let (horizontal, vertical) = (3 + draw.below(5), 2 + draw.below(4));
        let sphere =
            json!({"horizontal": horizontal, "vertical": vertical, "radius": 1.2, "smooth": true});
        let moved = json!({"of": {"tessellated_sphere": sphere}, "transform": [{"translate": [0.0, 1.25, 0.0]}]});
        shown(draw, json!({"instance": moved}))
    }),
    ("instance.turned", "ch21", |draw| instance(draw, &[TURN])),
    ("instance.stretched", "ch21", |draw| instance(draw, &[STRETCH])),
    ("instance.composed", "ch21", |draw| instance(draw, &[STRETCH, TURN])),
    ("instance.mirrored", "ch21", |draw| instance(draw, &[STRETCH, MIRROR])),
    ("instance.sheared", "ch21", |draw| instance(draw, &[SHEAR])),
    ("instance.nested", "ch21", nested),
    ("bump.height", "ch31", |draw| bumped(draw, &[])),
    ("bump.stretched", "ch31", |draw| bumped(draw, &[STRETCH, TURN])),
];

/// A surface in the middle of the stage, over a matte ground, in the light of one lamp from anywhere.
fn on_stage(draw: &mut Draw, surface: Value, shape: Value, from: [f64; 3]) -> Value {
    // half of them from the front, so that what is seen is lit
    let at = match draw.coin() {
        true => within(draw, [-3.0, 2.0, 2.0], [3.0, 6.0, 6.0]),
        false => within(draw, [-4.0, -0.5, -4.0], [4.0, 6.0, 4.0]),
    };
    let lights = vec![
        light(
            "lamp",
            json!({"point": {"ls": between(draw, 2.0, 4.0), "color": color(draw), "location": at}}),
        ),
        light("sky", json!({"ambient": {"ls": share(draw), "color": color(draw)}})),
    ];
    let materials = vec![surface, material("stone", matte(draw))];
    let objects = vec![object("it", "surface", shape), object("floor", "stone", stage::ground())];
    let mut scene = stage::scene(direct(), lights, materials, objects);
    scene["background"] = color(draw);
    // now and then at the ground beside it, where its shadow may be
    let aim = match draw.below(5) {
        0 => stage::shadow([0.0, 1.0, 0.0], at),
        _ => within(draw, [-1.0, 0.4, -0.6], [1.0, 1.9, 0.6]),
    };
    along(scene, ray(from, aim))
}

/// A point around the stage, from which to look at either side of things.
fn around(draw: &mut Draw) -> [f64; 3] {
    let [x, y, z] = draw.direction().to_array();
    [6.0 * x, 0.5 + 5.0 * y.abs(), 6.0 * z]
}

/// A surface without an inside, from either side. The book turns the normals of open cylinders to the viewer.
fn open(draw: &mut Draw, two_sided: bool) -> Value {
    let kinds = if two_sided { 4 } else { 3 };
    let shape = match draw.below(kinds) {
        0 => {
            json!({"rectangle": {"corner": [-1.0, 0.25, -0.5], "a": [2.0, 0.0, 0.0], "b": [0.0, 1.5, 0.75]}})
        }
        1 => {
            let normal = within(draw, [-1.0, -1.0, 0.25], [1.0, 1.0, 1.0]);
            json!({"disk": {"center": [0.0, 1.25, 0.0], "normal": normal, "radius": 1.0}})
        }
        2 => {
            json!({"triangle": {"vertices": [[-1.25, 0.25, 0.5], [1.5, 0.25, -0.25], [0.0, 2.25, 0.0]]}})
        }
        _ => json!({"open_cylinder": {"y0": 0.25, "y1": 1.75, "radius": 1.0}}),
    };
    let mut surface = material("surface", json!({"phong": phong(draw)}));
    surface["two_sided"] = json!(two_sided);
    let from = around(draw);
    on_stage(draw, surface, shape, from)
}

/// What shines, seen directly from either side, though nothing samples its light.
fn emissive(draw: &mut Draw) -> Value {
    let shape = match draw.below(3) {
        0 => stage::sphere([0.0, 1.0, 0.0], 1.0),
        1 => {
            json!({"rectangle": {"corner": [-1.0, 0.25, 0.0], "a": [2.0, 0.0, 0.0], "b": [0.0, 1.75, 0.0]}})
        }
        _ => json!({"disk": {"center": [0.0, 1.0, 0.0], "normal": [0.0, 0.6, 0.8], "radius": 1.0}}),
    };
    let recipe = json!({"emissive": {"ls": between(draw, 1.0, 4.0), "ce": color(draw)}});
    let mut surface = material("surface", recipe);
    surface["two_sided"] = json!(draw.coin());
    let from = around(draw);
    on_stage(draw, surface, shape, from)
}

/// Rays that often go by.
fn background(draw: &mut Draw) -> Value {
    let surface = material("surface", matte(draw));
    let mut question =
        on_stage(draw, surface, stage::sphere([0.0, 1.0, 0.0], 1.0), [0.0, 2.0, 6.0]);
    let aim = within(draw, [-3.0, 1.0, -1.0], [3.0, 4.0, 1.0]);
    question["radiance"]["ray"] = ray([0.0, 1.0, 6.0], aim);
    question
}

/// Highlights of all exponents, at all angles: also where the mirrored direction points away from the viewer.
fn highlight(draw: &mut Draw) -> Value {
    let mut base = phong(draw);
    base["exponent"] = json!(draw.pick(&[0.25, 0.5, 1.0, 2.5, 10.0, 50.0]));
    let surface = material("surface", json!({"phong": base}));
    let from = stage::before(draw);
    on_stage(draw, surface, stage::sphere([0.0, 1.0, 0.0], 1.0), from)
}

/// A dented octahedron.
fn mesh(draw: &mut Draw) -> Value {
    let vertex = |at: [f64; 3], draw: &mut Draw| {
        let by = within(draw, [-0.2; 3], [0.2; 3]);
        let middle = [0.0, 1.25, 0.0];
        std::array::from_fn::<f64, 3, _>(|i| middle[i] + at[i] + by[i])
    };
    let vertices: Vec<[f64; 3]> = CORNERS.into_iter().map(|at| vertex(at, draw)).collect();
    json!({"vertices": vertices, "triangles": FACES})
}

/// A shiny body.
fn shown(draw: &mut Draw, shape: Value) -> Value {
    let surface = material("surface", json!({"phong": phong(draw)}));
    let from = stage::before(draw);
    on_stage(draw, surface, shape, from)
}

/// Steps of a transformation.
type Steps = fn(&mut Draw) -> Vec<Value>;

const TURN: Steps = |draw| {
    let mut angle = || between(draw, -170.0, 170.0);
    vec![json!({"rotate_x": angle()}), json!({"rotate_z": angle()}), json!({"rotate_y": angle()})]
};
const STRETCH: Steps =
    |draw| vec![json!({"scale": within(draw, [0.4, 0.4, 0.4], [1.3, 1.3, 1.3])})];
const MIRROR: Steps = |draw| {
    let angle = between(draw, 10.0, 80.0);
    vec![json!({"rotate_z": angle}), json!({"reflect": draw.pick(&["x", "y", "z"])})]
};
const SHEAR: Steps = |draw| {
    let by: Vec<f64> = (0..6).map(|_| between(draw, -0.4, 0.4)).collect();
    vec![json!({"shear": by})]
};

/// These steps, then one to the middle of the stage.
fn steps(draw: &mut Draw, kinds: &[Steps]) -> Vec<Value> {
    let mut all: Vec<Value> = kinds.iter().flat_map(|steps| steps(draw)).collect();
    all.push(json!({"translate": [0.0, 1.25, 0.0]}));
    all
}

/// A ball, box or half a ball about the origin.
fn body(draw: &mut Draw) -> Value {
    match draw.below(3) {
        0 => json!({"box": {"min": [-1.0, -0.75, -0.5], "max": [1.0, 0.75, 0.5]}}),
        1 => json!({"solid_cylinder": {"y0": -0.75, "y1": 0.75, "radius": 1.0}}),
        _ => stage::sphere([0.0; 3], 1.0),
    }
}

fn instance(draw: &mut Draw, kinds: &[Steps]) -> Value {
    let (of, transform) = (body(draw), steps(draw, kinds));
    shown(draw, json!({"instance": {"of": of, "transform": transform}}))
}

fn nested(draw: &mut Draw) -> Value {
    let inner = json!({"instance": {"of": body(draw), "transform": STRETCH(draw)}});
    let transform = steps(draw, &[TURN, STRETCH]);
    shown(draw, json!({"instance": {"of": inner, "transform": transform}}))
}

/// A ball whose height above its surface is a ramp that goes up and down: bumps without noise.
fn bumped(draw: &mut Draw, kinds: &[Steps]) -> Value {
    let to = between(draw, 0.2, 0.5);
    let ramp = json!({"ramp": {
        "axis": draw.pick(&["x", "y", "z"]), "from": 0.0, "to": to, "colors": [0.0, 1.0], "wrap": "mirror",
    }});
    let mut surface = material("surface", json!({"phong": phong(draw)}));
    surface["bump"] =
        json!({"height": {"texture": ramp, "height": between(draw, 0.05, 0.15), "step": 1e-4}});
    let (of, transform) = (stage::sphere([0.0; 3], 1.0), steps(draw, kinds));
    let shape = json!({"instance": {"of": of, "transform": transform}});
    let from = stage::before(draw);
    on_stage(draw, surface, shape, from)
}
