//! Ramps: marble and sandstone.

use super::{WALL, blue_ramp, dull, four, lit_stage, sand_ramp, texture_stretched};
use groundtruth::math::Point;
use groundtruth::noise::Noise;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::textures::{ColorTable, Paint, RampFbm};

fn marble(ramp: ColorTable, perturbation: f64) -> Paint {
    RampFbm { ramp, noise: Noise::of_octaves(4), size: 1.0, perturbation }.into()
}

pub fn sphere_of(about: &str, perturbation: f64) -> Scene {
    let mut scene = lit_stage(about, 5800.0);
    scene.background = WALL.into();
    let recipe = dull(marble(blue_ramp(), perturbation));
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 5.0), recipe);
    scene
}

pub fn four_marbles() -> Scene {
    let about = "figure 31.34: marbles with a = 8, 6, 40, 8";
    let mut scene = lit_stage(about, 2700.0);
    scene.background = WALL.into();
    let white = ColorTable::interpolated([rgb(0.25, 0.25, 0.28), grey(0.85), grey(0.9), grey(0.8)]);
    let green =
        ColorTable::interpolated([rgb(0.02, 0.1, 0.05), rgb(0.05, 0.3, 0.15), rgb(0.7, 0.85, 0.7)]);
    let red =
        ColorTable::interpolated([rgb(0.3, 0.02, 0.02), rgb(0.6, 0.15, 0.1), rgb(0.95, 0.8, 0.75)]);
    let paints = [(blue_ramp(), 8.0), (white, 6.0), (red, 40.0), (green, 8.0)];
    let paints = paints.map(|(ramp, perturbation)| marble(ramp, perturbation));
    four(&mut scene, 5.0, || sphere(Point::ORIGIN, 5.0).into(), paints);
    scene
}

/// The layers are tilted, and the texture is stretched by 2 along y.
pub fn four_sandstones() -> Scene {
    let about = "as figure 31.38: sandstones of four ramps, with slightly perturbed layers";
    let mut scene = lit_stage(about, 4600.0);
    scene.background = WALL.into();
    let ramps = [
        vec![rgb(0.9, 0.75, 0.5), rgb(0.7, 0.45, 0.25), rgb(0.85, 0.65, 0.4)],
        vec![rgb(0.6, 0.3, 0.2), rgb(0.85, 0.7, 0.6), rgb(0.45, 0.2, 0.12), rgb(0.7, 0.4, 0.3)],
        vec![rgb(0.4, 0.4, 0.35), rgb(0.7, 0.68, 0.6), rgb(0.3, 0.28, 0.25), rgb(0.8, 0.78, 0.7)],
    ];
    let [a, b, c] = ramps.map(ColorTable::interpolated);
    let paints = [a, b, c, sand_ramp()].map(|ramp| {
        let noise = Noise::of_octaves(4);
        Paint::from(RampFbm { ramp, noise, size: 0.1, perturbation: 0.05 / 0.1 })
    });
    let ball = || texture_stretched(sphere(Point::ORIGIN, 3.0), vector(1.0, 2.0, 1.0), 110.0);
    four(&mut scene, 3.0, ball, paints);
    scene
}
