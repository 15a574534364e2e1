//! Means and standard errors beside those of the probe.

use std::path::Path;

use groundtruth::{render, world::World};
use pictures::sums::Sums;

use super::expect;
use super::header::header;
use crate::kit::Folder;

/// A small picture with noise.
fn noisy() -> World {
    let mut scene = gallery::find("ch18/rectangle").map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(12, 8);
    scene.image.samples = 4;
    World::build_seeded(&scene, Path::new(""), 0).expect("gallery scenes are valid")
}

/// Law: mean and standard error of each pixel are those of `probe radiance`. Oracle: the probe, which keeps all values.
#[test]
fn mean_and_standard_error_are_those_of_the_probe() {
    let mut world = noisy();
    let mut sums = Sums::new(header([12, 8]));
    for seed in 5..15 {
        world.reseed(seed);
        sums.add(&render::render(&world), seed).expect("they fit");
    }
    let at = &Folder::new();
    let export = "export ch18/rectangle --size 12x8 --samples 4 -o scene.toml";
    expect(0, at, export);
    let mut has_noise = false;
    for pixel in [[6, 4], [2, 6], [9, 5], [0, 0]] {
        let question = serde_json::json!({"radiance": {
            "scene": "scene.toml", "replicas": 10, "seed": 5, "pixel": pixel,
        }});
        at.write("question", question.to_string());
        let answer = at.run("groundtruth probe < question").json()["answer"].clone();
        let error = sums.standard_error().expect("ten replicas");
        for (name, film) in [("mean", sums.mean()), ("standard_error", error)] {
            for (channel, found) in film.get(pixel).to_array().into_iter().enumerate() {
                let expected = answer[name][channel].as_f64().expect("a number");
                has_noise |= name == "standard_error" && expected > 1e-3;
                let bound = 1e-12 * expected.abs() + 1e-15; // of the probe's difference of near numbers
                assert!((found - expected).abs() <= bound, "{name}: {found} {expected}");
            }
        }
    }
    assert!(has_noise, "no pixel has noise: the law holds of nothing");
}
