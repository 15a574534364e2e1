//! Chapter 16: shadows.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::lights::Point as PointLight;
use crate::math::Point;
use crate::scene::{Image, Light, Scene};

pub const SCENES: List = &[("ch16/coloured-shadows", coloured_shadows)];

fn coloured_shadows() -> Scene {
    let lens = Pinhole { distance: 1200.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(0.0, 7.0, 10.0), point(0.0, -1.5, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(600, 540) };
    let about =
        "figure 16.11b: three coloured point lights; where one is blocked, the other two mix";
    let mut scene = Scene::new(about, image, camera);
    for (name, color, location) in [
        ("red light", rgb(1.0, 0.0, 0.0), point(3.0, 10.0, 2.0)),
        ("green light", rgb(0.0, 1.0, 0.0), point(-3.0, 10.0, 2.0)),
        ("blue light", rgb(0.0, 0.0, 1.0), point(0.0, 10.0, -3.0)),
    ] {
        let source = PointLight { ls: 12.0, color, location, attenuation: 0.0 };
        scene.lights.push(Light::new(name, source));
    }
    for (object, material) in [
        object("sphere", sphere(Point::ORIGIN, 1.0), matte(0.0, 0.35, grey(0.7))),
        object("ground", ground(-3.0), matte(0.0, 0.35, grey(0.7))),
    ] {
        scene.objects.push(object);
        scene.materials.push(material);
    }
    scene
}
