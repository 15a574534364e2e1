//! Chapters 20 and 21: a transformed sphere.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::math::{Point, Step, Vector};
use crate::scene::{Image, Scene};
use crate::shapes::Instance;

pub const SCENES: List = &[("ch20/ellipsoid", ellipsoid)];

fn ellipsoid() -> Scene {
    let lens = Pinhole { distance: 8000.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(100.0, 0.0, 100.0), Point::new(0.0, 1.0, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let about =
        "figure 21.5b, plain: a unit sphere scaled (2, 3, 1), turned by −45° about x, raised by 1";
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(0.25));
    scene.lights.push(point_light("lamp", point(100.0, 100.0, 60.0), 3.0));
    let shape = Instance::new(
        sphere(Point::ORIGIN, 1.0),
        vec![Step::Scale(vector(2.0, 3.0, 1.0)), Step::RotateX(-45.0), Step::Translate(Vector::Y)],
    );
    let (object, material) =
        object("ellipsoid", shape, phong(0.25, 0.75, rgb(1.0, 0.75, 0.0), 0.2, 20.0));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}
