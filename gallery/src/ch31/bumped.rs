//! Bump mapping.

use super::{WALL, lit_stage};
use groundtruth::bumps::{self, Height};
use groundtruth::math::{Point, Step};
use groundtruth::noise::Noise;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::textures::Fbm;

fn bumped_sphere(about: &str, bump: impl Into<bumps::Kind>) -> Scene {
    let mut scene = lit_stage(about, 9500.0);
    scene.background = WALL.into();
    let orange = phong(0.4, 0.6, rgb(1.0, 0.5, 0.1), 0.2, 20.0);
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 3.0), orange);
    scene.materials[0].bump = Some(bump.into());
    scene
}

pub fn by_noise() -> Scene {
    let about = "a smooth sphere with normals perturbed by noise: it looks rough, like an orange";
    let noise = Noise::of_octaves(1);
    bumped_sphere(about, bumps::Noise { noise, size: 0.15, perturbation: 0.25 })
}

pub fn stretched() -> Scene {
    let about = "the same bumps on a sphere stretched to an ellipsoid: they are stretched with it, and so are slopes";
    let mut scene = by_height();
    scene.about = about.to_owned();
    let steps = vec![Step::Scale(vector(1.0, 0.4, 1.0)), Step::RotateZ(30.0)];
    scene.objects[0].shape = transformed(sphere(Point::ORIGIN, 3.0), steps);
    scene
}

pub fn by_height() -> Scene {
    let about = "a smooth sphere bump-mapped by noise of six octaves: hills and valleys";
    bumped_sphere(about, Height::new(Fbm::new(Noise::of_octaves(6), 1.0), 0.5))
}
