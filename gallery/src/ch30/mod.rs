//! Chapter 30: procedural textures.

mod kinds;
mod solids;

use super::List;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::textures::{Lines, Paint};

pub const SCENES: List = &[
    ("ch30/cut-cube", solids::cut_cube),
    ("ch30/solid-checkers", solids::row),
    ("ch30/stretched-checker", || {
        let about = "figure 30.11: a box stretched along x with its solid checker";
        solids::stretched(about, solids::checker().into())
    }),
    ("ch30/texture-instance", || {
        let about = "figure 30.11: a texture instance scaled by 1/2 along x restores the cubes";
        solids::stretched(about, solids::halved_along_x(solids::checker()))
    }),
    ("ch30/sphere-checkers", kinds::sphere_checkers),
    ("ch30/checkers", kinds::checkers),
    ("ch30/ramp", kinds::ramp),
    ("ch30/coloured-amounts", kinds::coloured_amounts),
    ("ch30/wireframe", kinds::wireframe),
    ("ch30/sphere-textures", kinds::sphere_textures),
    ("ch30/sphere-materials", kinds::sphere_materials),
];

/// Adds ambient light and a directional light from the left and above.
fn lit(mut scene: Scene) -> Scene {
    scene.lights.push(ambient(0.6));
    scene.lights.push(directional("sun", vector(-2.0, 4.0, 3.0), 2.75));
    scene
}

/// Adds a matte object with a texture.
fn show(
    scene: &mut Scene,
    name: &str,
    shape: impl Into<groundtruth::shapes::Kind>,
    paint: impl Into<Paint>,
) {
    add(scene, name, shape, matte(0.4, 0.8, paint));
}

/// Black lines of these widths.
fn lines(horizontal: f64, vertical: f64) -> Lines {
    Lines { horizontal, vertical, ..Lines::default() }
}
