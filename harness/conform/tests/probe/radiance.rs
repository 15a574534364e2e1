//! The question `radiance`: rendered pixels and their standard errors.

use std::path::Path;

use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use serde_json::{Value, json};

use super::{ask, numbers};

/// Law: a replica is the pixel as it is rendered with that seed, bit for bit.
#[test]
fn replicas_are_pixels_of_other_seeds() {
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let mut scene = (entry.build)();
    scene.image.samples = 4;
    let pixel = [250, 300];
    let values: Vec<[f64; 3]> = (7..10)
        .map(|seed| {
            let world = World::build_seeded(&scene, Path::new(""), seed).expect("it is valid");
            render::pixel(&world, pixel).to_array()
        })
        .collect();
    let ask = |seed: u64, replicas: u32| {
        ask(&json!({"radiance": {"scene": entry.name, "pixel": pixel, "samples": 4,
            "seed": seed, "replicas": replicas}}))
    };
    for (seed, value) in (7..).zip(&values) {
        let answer = ask(seed, 1);
        assert_eq!(numbers(&answer["mean"]), value);
        assert_eq!(answer["standard_error"], Value::Null);
    }
    let answer = ask(7, 3);
    for channel in 0..3 {
        let of: Vec<f64> = values.iter().map(|value| value[channel]).collect();
        let mean = of.iter().sum::<f64>() / 3.0;
        let variance = of.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 2.0;
        let error = (variance / 3.0).sqrt();
        let found = numbers(&answer["mean"])[channel];
        assert!((found - mean).abs() < 1e-15, "the mean is {found}, not {mean}");
        let found = numbers(&answer["standard_error"])[channel];
        assert!((found - error).abs() < 1e-12 * error, "the error is {found}, not {error}");
    }
    assert_eq!(answer["samples"], 4);
    assert_eq!(answer["replicas"], 3);
}

/// Law: the radiance at a pixel is what the renderer gives it, bit for bit, with an exposure time, a filter and another size, too.
/// Oracle: the renderer.
#[test]
fn a_pixel_is_that_of_the_picture() {
    let rim = json!({
        "image": {"width": 3, "height": 3, "samples": 9, "filter": {"mitchell": {}}},
        "camera": {"eye": [0, 0, 5], "lens": {"pinhole": {"distance": 3}}, "exposure_time": 0.375},
        "materials": [{"name": "lamp", "recipe": {"emissive": {"ls": 0.75}}}],
        "objects": [{"name": "ball", "material": "lamp", "shape": {"sphere": {
            "center": [0, 0, 0], "radius": 1.1}}}],
    });
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let mut glass = (entry.build)();
    glass.image.samples = 4;
    glass.image.resize(30, 20);
    let ball: Scene = serde_json::from_value(rim.clone()).expect("a scene");
    let sized = json!({"scene": entry.name, "size": [30, 20], "samples": 4});
    for (scene, question, pixels) in [
        (ball, json!({"scene": rim}), [[0, 0], [1, 0], [2, 1]]),
        (glass, sized, [[0, 0], [14, 11], [29, 19]]),
    ] {
        let world = World::build_seeded(&scene, Path::new(""), 7).expect("it is valid");
        for pixel in pixels {
            let mut question = question.clone();
            (question["pixel"], question["seed"], question["replicas"]) =
                (json!(pixel), json!(7), json!(1));
            let answer = ask(&json!({"radiance": question}));
            let expected = render::pixel(&world, pixel).to_array();
            assert_eq!(numbers(&answer["mean"]), expected, "{pixel:?} of {}", question["scene"]);
        }
    }
}

/// Law: a scene file, and the same scene inline, give the same bits.
#[test]
fn a_file_is_the_scene_it_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    let inline = json!({
        "image": {"width": 1, "height": 1, "samples": 4, "sampler": {"random": {}}},
        "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}},
        "materials": [{"name": "lamp", "recipe": {"emissive": {"ls": 1}}}],
        "objects": [{"name": "sheet", "material": "lamp", "shape": {"rectangle": {
            "corner": [-0.5, -0.5, 0], "a": [0.3, 0, 0], "b": [0, 1, 0]}}}],
    });
    let scene: Scene = serde_json::from_value(inline.clone()).expect("a scene");
    let text = scenefile::to_toml(&scene).expect("it can be written");
    std::fs::write(&path, text).expect("it can be written");
    let of = |scene: Value| ask(&json!({"radiance": {"scene": scene, "pixel": [0, 0]}}));
    assert_eq!(of(json!(path)), of(inline));
}
