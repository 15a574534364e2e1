//! Chapter 8: perspective viewing.

use super::List;
use super::sets::{basic_objects, wireframe_box};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Object, Scene};

pub const SCENES: List = &[
    ("ch08/perspective", || {
        from_the_front("figure 8.16: a sphere, a box and a triangle in perspective", 250.0, 200.0)
    }),
    ("ch08/close-up", || {
        from_the_front("figure 8.19: the same close up, strongly distorted", 75.0, 100.0)
    }),
    ("ch08/spheres-from-above", spheres_from_above),
    ("ch08/wireframe-box", wireframe),
];

/// The three objects from the z axis.
fn from_the_front(about: &str, eye: f64, distance: f64) -> Scene {
    let lens = Pinhole { distance, zoom: 1.0 };
    let camera = Viewpoint::new(point(0.0, 0.0, eye), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    basic_objects(&mut scene);
    scene
}

/// Figure 8.21 and the picture of page one: spheres from directly above the middle one.
fn spheres_from_above() -> Scene {
    let lens = Pinhole { distance: 73.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(0.0, 2.0, 0.0), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(500, 500) };
    let about = "figure 8.21: 25 spheres from above, the outer ones stretched by perspective";
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(0.0, 1.0, 1.0), 3.0).without_shadows());
    let squares = checker3d(0.5, rgb(0.0, 0.4, 0.8), Rgb::WHITE);
    let (first, material) =
        object("sphere", sphere(Point::ORIGIN, 0.75), matte(0.25, 0.75, squares));
    scene.materials.push(material);
    for row in -2..=2 {
        for column in -2..=2 {
            let center = 2.0 * vector(f64::from(column), 0.0, f64::from(row));
            let name = format!("sphere {column} {row}");
            // instances, so that each has the same checker
            scene.objects.push(Object::new(&name, "sphere", moved(first.shape.clone(), center)));
        }
    }
    scene
}

fn wireframe() -> Scene {
    let lens = Pinhole { distance: 280.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(0.0, 0.0, 2.5), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let about = "figure 8.22: the edges of a box, its far side much smaller than its near one";
    let mut scene = Scene::new(about, image, camera);
    scene.background = Rgb::WHITE.into();
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(1.0, 2.0, 3.0), 3.0).without_shadows());
    add(&mut scene, "box", wireframe_box(1.0, 0.02), matte(0.25, 0.5, rgb(0.0, 0.25, 0.6)));
    scene
}
