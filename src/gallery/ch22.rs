//! Chapter 22: regular grids, and what they are good for.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::math::cbrt;
use crate::scene::{Image, Scene};
use crate::shapes::RandomSpheres;
use crate::textures::{Kind as TextureKind, Paint, RandomColors};

pub const SCENES: List = &[
    ("ch22/thousand-spheres", thousand_spheres),
    ("ch22/hundred-thousand-spheres", hundred_thousand_spheres),
];

/// Figure 22.11: `count` spheres that fill the same share of the cube however many they are.
fn random_spheres(about: &str, count: u32) -> Scene {
    let lens = Pinhole { distance: 3600.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(0.0, 0.0, 20.0), point(0.0, 0.0, 0.0), lens);
    let mut scene = Scene::new(about, Image::new(400, 400), camera);
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("light", vector(-10.0, 20.0, 20.0), 3.0).without_shadows());
    let volume = 0.1 / f64::from(count);
    let radius = cbrt(0.75 * volume / std::f64::consts::PI);
    let spheres = RandomSpheres { count, radius, half_side: 1.0, seed: 15, accel: None };
    let colors = Paint(TextureKind::from(RandomColors { seed: 15 }));
    let (object, material) = object("spheres", spheres, matte(0.25, 0.75, colors));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

fn thousand_spheres() -> Scene {
    random_spheres("a thousand random spheres, a tenth of a unit cube's volume in all", 1000)
}

fn hundred_thousand_spheres() -> Scene {
    random_spheres("a hundred thousand spheres of the same volume in all", 100_000)
}
