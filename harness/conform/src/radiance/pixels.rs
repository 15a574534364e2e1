//! Pixels of pictures whose every ray has another radiance, without random numbers (Suffern, ch. 3, 4, 8, 9).

use serde_json::{Value, json};

use super::stage::{self, Exact, between, color, light, material, matte, object, share, within};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("pixel.pinhole", "ch08", |draw| pixel(draw, |_, _| {})),
    ("pixel.size", "ch03", |draw| {
        pixel(draw, |draw, scene| {
            scene["image"]["pixel_size"] = json!(between(draw, 0.4, 1.6));
        })
    }),
    ("pixel.zoom", "ch09", |draw| {
        pixel(draw, |draw, scene| {
            scene["camera"]["lens"]["pinhole"]["zoom"] = json!(between(draw, 0.5, 2.0));
        })
    }),
    ("pixel.roll", "ch09", |draw| {
        pixel(draw, |draw, scene| {
            let roll = draw.sign() * between(draw, 5.0, 120.0);
            scene["camera"]["roll"] = json!(roll);
        })
    }),
    ("pixel.exposure", "ch09", |draw| {
        pixel(draw, |draw, scene| {
            scene["camera"]["exposure_time"] = json!(between(draw, 0.25, 3.0));
        })
    }),
    ("pixel.orthographic", "ch03", |draw| {
        pixel(draw, |_, scene| {
            scene["camera"]["lens"] = json!({"orthographic": {}});
            scene["image"]["pixel_size"] = json!(0.25);
        })
    }),
    ("pixel.regular", "ch04", |draw| {
        pixel(draw, |draw, scene| {
            scene["image"]["sampler"] = json!({"regular": {}});
            scene["image"]["samples"] = json!(draw.pick(&[4, 9, 16]));
        })
    }),
];

/// A pixel of a picture that is wider than high or higher than wide: of a ground and a ball near a lamp.
fn pixel(draw: &mut Draw, change: fn(&mut Draw, &mut Value)) -> Value {
    let lamp = within(draw, [-2.0, 2.5, -1.0], [2.0, 4.0, 2.0]);
    let source = json!({"point": {
        "ls": between(draw, 10.0, 30.0), "color": color(draw), "location": lamp, "attenuation": 2.0,
    }});
    let lights = vec![light("lamp", source), light("sky", json!({"ambient": {"ls": share(draw)}}))];
    let materials = vec![material("chalk", matte(draw)), material("stone", matte(draw))];
    let objects = vec![
        object("ball", "chalk", stage::sphere([0.5, 1.0, 0.0], 1.0)),
        object("floor", "stone", stage::ground()),
    ];
    let mut scene = stage::scene(stage::direct(), lights, materials, objects);
    let (width, height) = (3 + draw.below(6), 3 + draw.below(6));
    // of odd numbers of pixels, too; never square
    let width = if width == height { width + 1 } else { width };
    scene["image"] = json!({"width": width, "height": height});
    let eye = within(draw, [-2.0, 3.0, 4.0], [2.0, 5.0, 6.0]);
    scene["camera"]["eye"] = json!(eye);
    scene["camera"]["look_at"] = json!([0.0, 0.5, 0.0]);
    change(draw, &mut scene);
    let at = [draw.below(width), draw.below(height)];
    json!({"radiance": {"scene": scene, "pixel": at, "replicas": 1}})
}
