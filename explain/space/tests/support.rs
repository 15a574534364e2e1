//! Small scenes as parts of a scene file, and their trees.

use std::path::Path;

use explain::RecordedRay;
use groundtruth::math::{cos_degrees, sin_degrees};
use groundtruth::scene::Scene;
use groundtruth::world::World;

/// From z = 10 along −z, without perspective: the pixel (x, y) of 5 × 5 looks along the line through (x − 2, 2 − y).
pub const FRONT: &str = "image = { width = 5, height = 5 }\n\
                         camera = { eye = [0, 0, 10], lens.orthographic = {} }\n";
/// From y = 9 down, without perspective: the pixel in the middle of 5 × 5 looks along the y axis.
pub const DOWN: &str = "image = { width = 5, height = 5 }\n\
                         camera = { eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], lens.orthographic = {} }\n";
/// The material of [`object`].
pub const WHITE: &str = "[[materials]]\nname = \"white\"\nrecipe.matte = { kd = 1, cd = 1 }\n";

/// A white object.
pub fn object(name: &str, rest: &str) -> String {
    format!("[[objects]]\nname = \"{name}\"\nmaterial = \"white\"\n{rest}\n")
}

pub fn light(name: &str, source: &str) -> String {
    format!("[[lights]]\nname = \"{name}\"\nsource.{source}\n")
}

pub fn built(text: &str) -> (Scene, World) {
    scenefile::from_toml(text, Path::new("here.toml")).expect("valid")
}

/// A scene, and the tree of a pixel.
pub fn traced(text: &str, pixel: [u32; 2]) -> (World, RecordedRay) {
    let (scene, world) = built(text);
    let root = explain::sample(&scene, &world, pixel, 0).ray.expect("the camera sees something");
    (world, root)
}

/// A block of glass under y = 0, seen in the middle under this angle to the y axis, and a matte floor far below; the tree.
pub fn block(degrees: f64) -> (&'static str, World, RecordedRay) {
    let (x, y) = (10.0 * sin_degrees(degrees), 10.0 * cos_degrees(degrees));
    let floor = object("floor", "shape.plane = { point = [0, -9, 0], normal = [0, 1, 0] }");
    let text = format!(
        r#"
        image = {{ width = 5, height = 5 }}
        camera = {{ eye = [{x}, {y}, 0], look_at = [0, 0, 0], up = [0, 0, -1], lens.orthographic = {{}} }}
        tracer.whitted = {{ max_depth = 4 }}
        {WHITE}{floor}[[materials]]
        name = "glass"
        recipe.dielectric = {{ inside = {{ eta = 1.5 }} }}
        [[objects]]
        name = "block"
        material = "glass"
        shape.box = {{ min = [-6, -3, -6], max = [6, 0, 6] }}
        "#
    );
    let (world, root) = traced(&text, [2, 2]);
    ("block", world, root)
}
