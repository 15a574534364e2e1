//! Noise on a plane in front of the camera.

use super::{WALL, dull, from_the_front, lit_stage};
use groundtruth::math::{Point, Vector};
use groundtruth::noise::Noise;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::Plane;
use groundtruth::textures::{Fbm, Paint, Turbulence};

/// A plane with ten lattice cells across, in ambient light only, so that the picture is the
/// texture.
fn plane(about: &str, paint: impl Into<Paint>) -> Scene {
    let mut scene = from_the_front(about, 6000.0);
    scene.lights.push(ambient(1.0));
    // between two lattice planes: on a lattice plane, one octave would be two-dimensional noise
    let wall = Plane { point: point(0.0, 0.0, -0.3), normal: Vector::Z };
    add(&mut scene, "plane", wall, matte(1.0, 0.0, paint));
    scene
}

pub fn noise(about: &str, noise: Noise) -> Scene {
    plane(about, Fbm::new(noise, 1.0))
}

pub fn turbulence() -> Scene {
    let about = "figure 31.23: turbulence of eight octaves: dark creases where noise is 0";
    plane(about, Turbulence::new(Noise::of_octaves(8), 1.0))
}

pub fn turbulent_sphere() -> Scene {
    let about = "figure 31.28: a sphere of turbulence, eight octaves, up to 1.2";
    let mut scene = lit_stage(about, 9500.0);
    scene.background = WALL.into();
    let color = rgb(1.0, 0.7, 0.0).into();
    let fire = Turbulence { max: 1.2, color, ..Turbulence::new(Noise::of_octaves(8), 1.0) };
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 3.0), dull(fire));
    scene
}
