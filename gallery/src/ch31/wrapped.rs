//! Wrapped noise.

use super::{WALL, dull, from_the_front, lit_stage, texture_stretched};
use groundtruth::math::{Point, Vector};
use groundtruth::noise::Noise;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::{TessellatedSphere, Torus};
use groundtruth::textures::{ColorTable, Paint, ThreeColors, TwoColors, WrappedFbm, WrappedRamp};

/// Figure 31.29 on a sphere.
fn wrapped(about: &str, texture: WrappedFbm, stretch: Vector) -> Scene {
    let mut scene = lit_stage(about, 9500.0);
    scene.background = WALL.into();
    let ball = texture_stretched(sphere(Point::ORIGIN, 3.0), stretch, 0.0);
    let texture = WrappedFbm { color: rgb(1.0, 0.8, 0.55).into(), ..texture };
    add(&mut scene, "sphere", ball, dull(texture));
    scene
}

pub fn a() -> Scene {
    let about = "figure 31.29a: wrapped noise, stretched along y and z";
    let noise = Noise { lacunarity: 4.0, ..Noise::of_octaves(2) };
    wrapped(about, WrappedFbm::new(noise, 1.0, 10.0), vector(1.0, 4.0, 4.0))
}

pub fn b() -> Scene {
    let about = "figure 31.29b: wrapped noise of four octaves, expansion number 10";
    wrapped(about, WrappedFbm::new(Noise::of_octaves(4), 1.5, 10.0), vector(1.0, 1.0, 1.0))
}

pub fn c() -> Scene {
    let about = "figure 31.29c: wrapped noise of six octaves, expansion number 3: rough edges";
    let noise = Noise { lacunarity: 6.0, ..Noise::of_octaves(6) };
    wrapped(about, WrappedFbm::new(noise, 1.0, 3.0), vector(1.0, 1.0, 1.0))
}

const GOLD: Rgb = Rgb::new(1.0, 0.65, 0.05);
const JADE: Rgb = Rgb::new(0.0, 0.55, 0.3);
const PLUM: Rgb = Rgb::new(0.45, 0.05, 0.35);

fn of_lacunarity_4(octaves: u32) -> Noise {
    Noise { lacunarity: 4.0, ..Noise::of_octaves(octaves) }
}

pub fn two_and_three_colors() -> Scene {
    let about = "as figure 31.39: wrapped noise of two and of three colours";
    let mut scene = lit_stage(about, 5800.0);
    scene.image.height = 300;
    scene.background = WALL.into();
    let [gold, plum, jade] = [GOLD, PLUM, JADE].map(Paint::from);
    let noise = of_lacunarity_4(3);
    let two = TwoColors::new(noise, 0.8, 2.0, [gold.clone(), jade.clone()]);
    let three = ThreeColors::new(noise, 0.8, 3.25, [gold, plum, jade]);
    add(&mut scene, "two", sphere(point(-2.5, 0.0, 0.0), 2.3), dull(two));
    add(&mut scene, "three", sphere(point(2.5, 0.0, 0.0), 2.3), dull(three));
    scene
}

pub fn nested_noises() -> Scene {
    let about = "figure 31.40: nested noises: fine wrapped noise in the patches of a coarse one";
    let mut scene = lit_stage(about, 9500.0);
    scene.background = WALL.into();
    let inner = WrappedFbm {
        min: 0.3,
        color: JADE.into(),
        ..WrappedFbm::new(of_lacunarity_4(2), 0.3, 4.0)
    };
    let outer = TwoColors {
        min: 0.4,
        ..TwoColors::new(of_lacunarity_4(3), 1.0, 2.0, [GOLD.into(), inner.into()])
    };
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 3.0), dull(outer));
    scene
}

/// A torus and a bumpy mesh replace the book's bunnies.
pub fn ramp() -> Scene {
    let about = "as figure 31.42: a ramp of wrapped noise, expansion number 8";
    let mut scene = from_the_front(about, 5000.0);
    scene.image.height = 300;
    scene.background = WALL.into();
    scene.lights.push(ambient(0.4));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 1.5), 2.0));
    let agate = WrappedRamp {
        ramp: ColorTable::interpolated([
            rgb(0.9, 0.85, 0.75),
            rgb(0.75, 0.35, 0.15),
            rgb(0.3, 0.08, 0.04),
            rgb(0.85, 0.6, 0.35),
        ]),
        noise: Noise::of_octaves(3),
        size: 1.5,
        expansion: 8.0,
    };
    let bumpy =
        TessellatedSphere { radius: 2.2, bumps: 0.1, ..TessellatedSphere::new(128, 64, true) };
    add(&mut scene, "pebble", moved(bumpy, vector(-2.9, 0.0, 0.0)), dull(agate.clone()));
    let ring = transformed(
        Torus { swept_radius: 1.7, tube_radius: 0.75, inward: false },
        vec![
            groundtruth::math::Step::RotateX(50.0),
            groundtruth::math::Step::Translate(vector(2.9, 0.0, 0.0)),
        ],
    );
    add(&mut scene, "ring", ring, dull(agate));
    scene
}
