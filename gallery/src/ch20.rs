//! Chapter 20: affine transformations of a sphere, without the checkers of figure 20.6 (chapter
//! 30).

use super::List;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Point, Step, Vector};
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[
    ("ch20/sphere", || scaled("figure 20.6a, plain: a unit sphere", vector(1.0, 1.0, 1.0))),
    ("ch20/wide", || scaled("figure 20.6b, plain: scaled by (1.25, 1, 2.25)", WIDE)),
    ("ch20/tall", || scaled("figure 20.6c, plain: scaled by (0.25, 2.5, 0.25)", TALL)),
    ("ch20/flat", || scaled("figure 20.6d, plain: scaled by (2.5, 0.25, 2.5)", FLAT)),
];

const WIDE: Vector = Vector::new(1.25, 1.0, 2.25);
const TALL: Vector = Vector::new(0.25, 2.5, 0.25);
const FLAT: Vector = Vector::new(2.5, 0.25, 2.5);

fn scaled(about: &str, factors: Vector) -> Scene {
    let lens = Pinhole { distance: 12_000.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(60.0, 40.0, 80.0), Point::ORIGIN, lens);
    let image = Image { samples: 25, ..Image::new(600, 600) };
    let mut scene = Scene::new(about, image, camera);
    scene.background = grey(0.5).into();
    scene.lights.push(ambient(0.25));
    scene.lights.push(point_light("lamp", point(100.0, 100.0, 60.0), 3.0));
    let shape = transformed(sphere(Point::ORIGIN, 1.0), vec![Step::Scale(factors)]);
    let (object, material) = object("sphere", shape, matte(0.25, 0.75, rgb(1.0, 0.75, 0.25)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}
