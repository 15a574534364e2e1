//! Chapter 31: noise-based textures.
//!
//! Noises, octaves and the numbers of textures are the book's; ramps, lights and the objects that
//! replace its bunnies are ours.

mod bumped;
mod cut_cube;
mod marble;
mod planes;
mod wrapped;

use super::List;
use groundtruth::math::{Point, Step, Vector};
use groundtruth::noise::{Interpolation, Noise};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::{self, Instance};
use groundtruth::textures::{ColorTable, Paint};

pub const SCENES: List = &[
    ("ch31/linear-noise", || {
        let about = "figure 31.18: one octave of linear noise: the lattice planes are visible";
        planes::noise(about, Noise { interpolation: Interpolation::Linear, ..Noise::default() })
    }),
    ("ch31/cubic-noise", || {
        planes::noise("figure 31.18: one octave of cubic noise: smooth", Noise::default())
    }),
    ("ch31/fbm", || planes::noise("figure 31.21: eight octaves", Noise::of_octaves(8))),
    ("ch31/turbulence", planes::turbulence),
    ("ch31/gain-2", || {
        let about = "figure 31.25: gain 2, six octaves: the finest octave is the strongest";
        planes::noise(about, Noise { gain: 2.0, ..Noise::of_octaves(6) })
    }),
    ("ch31/lacunarity-8", || {
        let about = "figure 31.26: lacunarity 8, six octaves: large and fine patches, none between";
        planes::noise(about, Noise { lacunarity: 8.0, ..Noise::of_octaves(6) })
    }),
    ("ch31/turbulent-sphere", planes::turbulent_sphere),
    ("ch31/wrapped-a", wrapped::a),
    ("ch31/wrapped-b", wrapped::b),
    ("ch31/wrapped-c", wrapped::c),
    ("ch31/marble-layers", || {
        marble::sphere_of("figure 31.32: a = 0: layers perpendicular to the y axis", 0.0)
    }),
    ("ch31/marble-30", || {
        marble::sphere_of("figure 31.33: a = 30: the layers are not recognisable", 30.0)
    }),
    ("ch31/marble", marble::four_marbles),
    ("ch31/sandstone", marble::four_sandstones),
    ("ch31/colors", wrapped::two_and_three_colors),
    ("ch31/nested-noises", wrapped::nested_noises),
    ("ch31/sandstone-cube", cut_cube::of_sandstone),
    ("ch31/wooden-cube", cut_cube::of_wood),
    ("ch31/wrapped-ramp", wrapped::ramp),
    ("ch31/noise-bump", bumped::by_noise),
    ("ch31/height-bump", bumped::by_height),
    ("ch31/bumped-ellipsoid", bumped::stretched),
];

/// A view along −z from far away; `distance` is that of the view plane, for a picture 600 pixels
/// wide.
fn from_the_front(about: &str, distance: f64) -> Scene {
    let view = [point(0.0, 0.0, 100.0), Point::ORIGIN];
    pinhole(about, [600, 600], view, distance)
}

/// The same with ambient light and a directional light from above on the right.
fn lit_stage(about: &str, distance: f64) -> Scene {
    let mut scene = from_the_front(about, distance);
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 1.5), 2.5));
    scene
}

/// A shape whose texture is scaled by these factors and then rotated about the z axis, while the
/// shape does not change: the outer instance transforms shape and texture, the inner one transforms
/// only the shape back.
fn texture_stretched(shape: impl Into<shapes::Kind>, by: Vector, degrees: f64) -> shapes::Kind {
    let back = Vector::from(by.to_array().map(|factor| 1.0 / factor));
    let inverse = vec![Step::RotateZ(-degrees), Step::Scale(back)];
    let inner = Instance { transform_texture: false, ..Instance::new(shape, inverse) };
    transformed(inner, vec![Step::Scale(by), Step::RotateZ(degrees)])
}

fn blue_ramp() -> ColorTable {
    ColorTable::interpolated([
        rgb(0.02, 0.04, 0.12),
        rgb(0.1, 0.2, 0.45),
        rgb(0.35, 0.45, 0.7),
        rgb(0.9, 0.9, 0.95),
    ])
}

fn sand_ramp() -> ColorTable {
    ColorTable::interpolated([
        rgb(0.75, 0.5, 0.3),
        rgb(0.55, 0.25, 0.1),
        rgb(0.8, 0.6, 0.4),
        rgb(0.35, 0.14, 0.06),
        rgb(0.85, 0.7, 0.5),
    ])
}

/// A matte material with this texture.
fn dull(paint: impl Into<Paint>) -> groundtruth::materials::Matte {
    matte(0.5, 0.75, paint)
}

/// Adds four spheres with these textures.
fn four(scene: &mut Scene, radius: f64, shape: impl Fn() -> shapes::Kind, paints: [Paint; 4]) {
    let quadrants = [(-1.0, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    for (i, (paint, (x, y))) in (1..).zip(paints.into_iter().zip(quadrants)) {
        let center = 1.05 * radius * vector(x, y, 0.0);
        add(scene, &format!("sphere {i}"), moved(shape(), center), dull(paint));
    }
}

/// The background of the chapter's objects.
const WALL: Rgb = Rgb::grey(0.1);
