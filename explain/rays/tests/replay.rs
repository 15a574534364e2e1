use std::collections::BTreeSet;

use explain::SampleExplanation;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rays::RayVerdict;
use serde_json::{Value, json};

use crate::laws::traced;

/// The log of a tracer in Python that renders a scene as the book does, each line, with one value of its scene changed.
fn with_other_scene(pointer: &str, value: Value) -> Vec<String> {
    let text = include_str!("honest/scene.jsonl");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut head: Value = serde_json::from_str(&lines[0]).expect("a head");
    let place = head.pointer_mut(&format!("/scene{pointer}"));
    *place.unwrap_or_else(|| panic!("no {pointer}")) = value;
    lines[0] = head.to_string();
    lines
}

/// Law: where a program renders another scene than its log says, the ray at which it parts from ours is the first that the
/// difference reaches, and what is said there is what differs. Oracle: what was changed in the scene.
#[test]
fn the_ray_that_parts_is_the_first_that_the_difference_reaches() {
    let cases = [
        (
            "/materials/3/recipe/dielectric/inside/eta",
            json!(1.33),
            "as-ours",
            ["(transmitted)", "beside ours"],
        ),
        (
            "/materials/2/recipe/reflective/kr",
            json!(0.7),
            "as-ours",
            ["(reflected)", "counts (0.72, 0.72, 0.64)"],
        ),
        ("/materials/0/recipe/matte/kd", json!(0.4), "as-ours", ["(camera)", "brings"]),
        ("/materials/0/recipe/matte/ka", json!(0), "as-ours", ["(camera)", "brings"]),
        (
            "/lights/2/source/directional/direction",
            json!([1, 2, -1]),
            "as-ours",
            ["(shadow)", "to this lamp"],
        ),
        ("/lights/1/source/point/attenuation", json!(1), "as-ours", ["(camera)", "brings"]),
        ("/tracer/whitted/max_depth", json!(8), "as-ours", ["", "sends no "]),
        ("/background", json!([0.3, 0.4, 0.6]), "as-ours", ["", "brings (0.3, 0.4, 0.5)"]),
        (
            "/camera/lens/pinhole/distance",
            json!(100),
            "through-its-pixel",
            ["(camera)", "goes through"],
        ),
        ("/camera/eye", json!([3, 3, 9]), "through-its-pixel", ["(camera)", "the scene's eye"]),
    ];
    for (pointer, value, law, words) in cases {
        let verdict = RayVerdict::of(traced(&with_other_scene(pointer, value)));
        let broken =
            verdict.asked.iter().find(|(it, asked)| it.name == law && !asked.findings.is_empty());
        let Some((_, asked)) = broken else { panic!("{pointer}: {}", verdict.text()) };
        let told = |ray: usize, words: &str| format!("{} {words}", verdict.traced.name(ray));
        let all: Vec<String> = asked.findings.iter().map(|it| told(it.ray, &it.words)).collect();
        let is_told = |it: &String| words.iter().all(|words| it.contains(words));
        assert!(all.iter().any(is_told), "{pointer}: {all:#?}");
    }
}

/// Law: a picture whose rows are counted from below, or whose columns from the right, is said to be so. Oracle: the same log with
/// its pixels counted so.
#[test]
fn pixels_that_are_counted_otherwise_are_told() {
    let flips = [
        ([false, true], "rows are counted from below"),
        ([true, false], "columns are counted from the right"),
        ([true, true], "turned by 180°"),
    ];
    for ([across, down], cause) in flips {
        let lines = include_str!("honest/scene.jsonl").lines().map(|line| {
            let mut line: Value = serde_json::from_str(line).expect("a line");
            if let Some([x, y]) =
                line["pixel"].as_array().and_then(|it| Some([it[0].as_u64()?, it[1].as_u64()?]))
            {
                line["pixel"] =
                    json!([if across { 47 - x } else { x }, if down { 31 - y } else { y }]);
            }
            line.to_string()
        });
        let verdict = RayVerdict::of(traced(&lines.collect::<Vec<_>>()));
        let (law, asked) =
            verdict.asked.iter().find(|(law, _)| law.name == "through-its-pixel").expect("it");
        let told = law.cause(asked.roots()).expect(cause);
        assert!(told.contains(cause), "{told}");
    }
}

/// Law: a program that leaves out the square of the ratio of the indices, in weights and radiances, sends our rays. Oracle: the
/// factors of glass cancel where light leaves it: the log's own program leaves them out, the scene has them.
#[test]
fn the_square_of_the_indices_may_be_left_out() {
    for scales in [true, false] {
        let mut lines = with_other_scene("/background", json!([0.3, 0.4, 0.5]));
        let mut head: Value = serde_json::from_str(&lines[0]).expect("a head");
        head["scene"]["transparency"] = json!({ "scales_radiance": scales });
        lines[0] = head.to_string();
        let verdict = RayVerdict::of(traced(&lines));
        assert!(!verdict.is_broken(), "{}", verdict.text());
    }
}

/// Law: what random numbers decide is no difference: of a lamp that stands partly below the horizon some samples bring light, and
/// others none. Oracle: our own samples, each with its own random numbers.
#[test]
fn what_is_drawn_is_no_difference() {
    let scene = json!({
        "image": {"width": 9, "height": 9, "samples": 64},
        "camera": {"eye": [0, 3, 5], "look_at": [0, 0, 0], "lens": {"pinhole": {"distance": 20}}},
        "lights": [
            {"name": "ambient", "source": {"ambient": {}}},
            {"name": "lamp", "source": {"area": {"object": "lamp"}}},
        ],
        "materials": [
            {"name": "chalk", "recipe": {"matte": {"ka": 0.1, "kd": 0.8, "cd": 1}}},
            {"name": "glow", "recipe": {"emissive": {"ls": 5}}},
        ],
        "objects": [
            {"name": "floor", "material": "chalk", "shape": {"disk": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}}},
            {"name": "lamp", "material": "glow", "shape": {"rectangle": {"corner": [-2, -1, -2], "a": [0, 2, 0], "b": [0, 0, 4]}}},
        ],
    });
    let built: Scene = serde_json::from_value(scene.clone()).expect("a scene");
    let world = World::build(&built).expect("a world");
    let explained = explain::pixel(&built, &world, [4, 4], None).expect("few rays");
    let unlit = |sample: &SampleExplanation| sample.ray.as_ref().map(|ray| ray.unlit.len());
    let lights: BTreeSet<_> = explained.samples.iter().map(unlit).collect();
    assert!(lights.len() > 1, "the lamp is below the horizon in some samples: {lights:?}");
    let log = rays::log_of(&explained, ("", [9, 9]), None);
    let mut lines: Vec<String> = log.lines().map(str::to_owned).collect();
    lines[0] = json!({"rays": 1, "size": [9, 9], "scene": scene}).to_string();
    let verdict = RayVerdict::of(traced(&lines));
    assert!(!verdict.is_broken(), "{}", verdict.text());
}
