//! Chapter 3: bare-bones ray tracing. There are no lights: colours are emitted radiance.

use super::List;
use groundtruth::cameras::{Orthographic, Viewpoint};
use groundtruth::materials::Emissive;
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Material, Object, Scene};
use groundtruth::shapes::{self, Plane};

pub const SCENES: List =
    &[("ch03/single-sphere", single_sphere), ("ch03/three-objects", three_objects)];

/// The chapter's view: parallel rays along −z from z = 100.
fn camera() -> Viewpoint {
    Viewpoint::new(point(0.0, 0.0, 100.0), Point::ORIGIN, Orthographic { zoom: 1.0 })
}

/// Adds an object of one constant colour, as in chapter 3, which has no materials yet.
fn flat(scene: &mut Scene, name: &str, shape: impl Into<shapes::Kind>, color: Rgb) {
    let mut material = Material::new(name, Emissive::new(1.0, color));
    material.two_sided = true;
    scene.objects.push(Object::new(name, name, shape));
    scene.materials.push(material);
}

fn single_sphere() -> Scene {
    let image = Image { pixel_size: 0.5, ..Image::new(400, 400) };
    let about = "figure 3.18: a red sphere of radius 85 fills the picture as a flat disk";
    let mut scene = Scene::new(about, image, camera());
    flat(&mut scene, "sphere", sphere(Point::ORIGIN, 85.0), rgb(1.0, 0.0, 0.0));
    scene
}

fn three_objects() -> Scene {
    let about = "figure 3.20: two spheres and a plane cut into each other";
    let mut scene = Scene::new(about, Image::new(200, 200), camera());
    flat(&mut scene, "red sphere", sphere(point(0.0, -25.0, 0.0), 80.0), rgb(1.0, 0.0, 0.0));
    flat(&mut scene, "yellow sphere", sphere(point(0.0, 30.0, 0.0), 60.0), rgb(1.0, 1.0, 0.0));
    let plane = Plane { point: Point::ORIGIN, normal: vector(0.0, 1.0, 1.0) };
    flat(&mut scene, "green plane", plane, rgb(0.0, 0.25, 0.0));
    scene
}
