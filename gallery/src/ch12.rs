//! Chapter 12: stereoscopy. Each picture is a pair of images for parallel viewing.

use super::List;
use super::sets::{LENS, boxes_in_depth, city, rings_of_columns, wireframe_box};
use groundtruth::cameras::{
    Fisheye, Kind as Lens, Pinhole, SphericalPanorama, Stereo, ThinLens, Viewing, Viewpoint,
};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[
    ("ch12/three-spheres", three_spheres),
    ("ch12/wireframe-outside", || {
        wireframe("figure 12.13: the edges of a box from outside", point(-2.0, 0.0, 5.0))
    }),
    ("ch12/wireframe-corner", || {
        wireframe("figure 12.14: the edges of a box past a corner", point(1.5, 1.75, 3.0))
    }),
    ("ch12/thin-lens", thin_lens),
    ("ch12/fisheye", || columns("figure 12.16: rings of columns, fisheye of 200°", 200.0)),
    ("ch12/city", city_around),
    ("ch12/page-one", || columns("the picture of page one: a fisheye of 130°", 130.0)),
];

fn eyes(eye: Point, look_at: Point, separation: f64, lens: impl Into<Lens>) -> Viewpoint {
    let stereo = Stereo { viewing: Viewing::Parallel, gap: 5, separation };
    Viewpoint { stereo: Some(stereo), ..Viewpoint::new(eye, look_at, lens) }
}

/// Figure 12.12: spheres in front of, on and behind the plane of zero parallax.
fn three_spheres() -> Scene {
    let (eye, look_at) = (point(5.0, 0.0, 100.0), Point::ORIGIN);
    let lens = Pinhole { distance: 100.0, zoom: 1.0 };
    let image = Image { pixel_size: 0.05, samples: 16, ..Image::new(200, 200) };
    let about =
        "figure 12.12: three spheres; the red one in front of the picture, the blue one behind";
    let mut scene = Scene::new(about, image, eyes(eye, look_at, 0.75, lens));
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 1.0), 2.5).without_shadows());
    for (name, center, radius, color) in [
        ("near", point(0.0, 0.0, 35.0), 0.75, rgb(1.0, 0.2, 0.2)),
        ("middle", point(0.0, 0.0, 0.0), 2.0, rgb(0.9, 0.8, 0.1)),
        ("far", point(1.5, 0.0, -80.0), 2.0, rgb(0.2, 0.4, 1.0)),
    ] {
        add(&mut scene, name, sphere(center, radius), matte(0.3, 0.7, color));
    }
    scene
}

/// Figures 12.13 and 12.14.
fn wireframe(about: &str, eye: Point) -> Scene {
    let lens = Pinhole { distance: 10.0, zoom: 1.0 };
    let image = Image { pixel_size: 0.05, samples: 16, ..Image::new(200, 200) };
    let mut scene = Scene::new(about, image, eyes(eye, Point::ORIGIN, 5.0, lens));
    scene.background = Rgb::WHITE.into();
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(1.0, 2.0, 3.0), 3.0).without_shadows());
    add(&mut scene, "box", wireframe_box(1.0, 0.04), matte(0.25, 0.5, rgb(0.0, 0.25, 0.6)));
    scene
}

/// Figure 12.15.
fn thin_lens() -> Scene {
    let lens = ThinLens { distance: 98.0, focal_distance: 74.0, ..LENS };
    let (eye, look_at) = (point(0.0, 6.0, 50.0), point(0.0, 6.0, 0.0));
    let image = Image { pixel_size: 0.1225, samples: 100, ..Image::new(400, 300) };
    let about = "figure 12.15: the boxes of chapter 10 for two eyes with lenses";
    let mut scene = Scene::new(about, image, eyes(eye, look_at, 2.0, lens));
    boxes_in_depth(&mut scene);
    scene
}

/// Figure 12.16 and page one.
fn columns(about: &str, fov: f64) -> Scene {
    let (eye, look_at) = (point(0.0, 150.0, 0.0), point(0.0, 150.0, -100.0));
    let lens = Fisheye { fov, rectangular: false };
    let image = Image { samples: 16, ..Image::new(300, 300) };
    let mut scene = Scene::new(about, image, eyes(eye, look_at, 5.0, lens));
    scene.background = rgb(0.6, 0.75, 0.95).into();
    rings_of_columns(&mut scene);
    scene
}

/// Figure 12.17. The book's sky is a picture of clouds.
fn city_around() -> Scene {
    let lens = SphericalPanorama { horizontal_fov: 180.0, vertical_fov: 180.0 };
    let (eye, look_at) = (point(10.0, 15.0, 13.0), point(34.0, 15.0, 0.0));
    let image = Image { samples: 64, ..Image::new(200, 200) };
    let about = "figure 12.17 without clouds: the city in 180° by 180°, with ambient occlusion";
    let mut scene = Scene::new(about, image, eyes(eye, look_at, 5.0, lens));
    scene.background = rgb(0.6, 0.75, 0.95).into();
    city(&mut scene, occluder(0.5));
    scene
}
